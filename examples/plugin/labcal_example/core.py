"""Sensor offset from a core near the harness that a current magnetises, and that saturates."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from labcal.model.effects import Family, Scene, Shape, Term
from labcal.model.effects.protocol import Array
from labcal.model.effects.regressors import moving, on_each_axis, per_axis
from labcal.record import Run

BENDS_AT = Shape("bend_A", 0.5, "A", (0.1, 0.15, 0.22, 0.33, 0.5, 0.75, 1.1))  # its unit, and where a search starts


def kernel(term: Term, scene: Scene) -> Array:
    """E = c tanh(I / I_b), per axis: the columns are d E / d c."""
    return on_each_axis(np.tanh(term.drive(scene) / term.at(BENDS_AT.name)))


def candidates(run: Run) -> Sequence[Term]:
    """Each current that moves, counted from no current."""
    return [Term(kernel, per_axis("c", "nT"), (c.name,), {c.name: 0.0}, (BENDS_AT,)) for c in moving(run, ("current",))]


FAMILY = Family(
    "example-core",
    "sensor",
    kernel,
    candidates,
    shapes=(BENDS_AT,),
    phrase="a core at the harness is magnetised by a current",
    experiment="switch the load at several currents: what saturates hardly grows beyond its bend",
)
