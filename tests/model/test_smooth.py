"""Smooth functions in a finite basis, and the domain that they were seen in."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.interpolate import BSpline

from labcal.model.effects import Scene
from labcal.model.effects.inputs import value
from labcal.model.smooth import Domain, b_splines, convex_hull


def test_b_splines_are_those_of_another_implementation() -> None:
    knots = np.linspace(-1.5, 2.5, 15)
    x = np.linspace(knots[3], knots[-4] - 1e-9, 50)
    assert np.allclose(b_splines(knots, 3, x), BSpline.design_matrix(x, knots, 3).toarray())


def test_beyond_the_knots_a_spline_keeps_its_value_at_the_end() -> None:
    knots = np.linspace(-1.5, 2.5, 15)
    ends = b_splines(knots, 3, np.array([knots[3], knots[-4]]))
    assert np.allclose(b_splines(knots, 3, np.array([-50.0, 50.0])), ends)
    assert np.allclose(ends.sum(axis=1), 1.0)


def test_two_inputs_that_were_never_seen_together_are_outside_though_each_was_seen() -> None:
    x = np.linspace(0, 1, 40)
    seen = np.column_stack([x, x**2])
    domain = Domain(("channel:a", "channel:b"), tuple(map(tuple, convex_hull(seen).tolist())))
    assert not domain.outside(seen).any()
    asked = np.array([[0.9, 0.1], [0.1, 0.5], [0.5, 0.4], [np.nan, 0.5]])
    assert domain.outside(asked).tolist() == [True, True, False, False]


def test_the_rate_is_how_fast_the_field_turns_in_the_body() -> None:
    t = np.arange(0.0, 20.0, 0.25)
    turned = np.radians(7.0 * t)
    field = 4e4 * np.column_stack([np.cos(turned), np.sin(turned), np.zeros(len(t))])
    rate = value("rate", Scene(t, np.zeros(len(t), dtype=np.intp), field))
    assert rate == pytest.approx(np.full(len(t), 7.0), rel=2e-2)
