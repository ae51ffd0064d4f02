"""Columns of a fine grid as combinations of few, and products of sets that are made so."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from labcal.loop import policy
from labcal.loop.candidates.interpolated import interpolated
from labcal.loop.candidates.library import Candidate, expand_library
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.bands import bands_of
from labcal.loop.noise.coloured import grams_by_band
from labcal.loop.noise.column_sets import ColumnSets
from labcal.loop.noise.nuisance import principal_span, span_of_combinations

Started = Callable[..., LinearProblem]


def grid_of(problem: LinearProblem, effect: str, parameters: int) -> list[Candidate]:
    """The points of the form of this effect with so many linear parameters and the most points."""
    forms: dict[object, list[Candidate]] = {}
    for c in expand_library(problem):
        if c.family.id == effect and len(c.term.parameters) == parameters:
            forms.setdefault(c.term.parameters, []).append(c)
    return max(forms.values(), key=len)


@pytest.mark.parametrize("parameters", [3, 9])
def test_what_coils_give_at_every_place_is_made_of_a_few_places(started: Started, parameters: int) -> None:
    problem = started()
    grid = grid_of(problem, "field-gradient", parameters)
    found = interpolated(problem, grid)
    assert found is not None
    assert found.made_of.shape[2] < len(grid) * parameters / 8
    for place, candidate in enumerate(grid):
        direct = problem.columns(candidate.term)
        assert np.linalg.norm(found.columns(place) - direct) < 1e-9 * np.linalg.norm(direct)


def test_directions_that_are_not_credible_are_left_out_of_the_combinations(
    started: Started, monkeypatch: pytest.MonkeyPatch
) -> None:
    problem = started()
    grid = grid_of(problem, "field-gradient", 9)
    monkeypatch.setattr(
        policy, "POLICY", policy.Policy(max_share_of_field=1e-3)
    )  # so much has to be new that some directions are not
    found = interpolated(problem, grid)
    assert found is not None
    less = 0
    for place, candidate in enumerate(grid):
        direct = problem.columns(candidate.term)
        less += np.linalg.norm(direct - problem.all_columns(candidate.term)) > 1e-3 * np.linalg.norm(direct)
        assert np.linalg.norm(found.columns(place) - direct) < 1e-6 * np.linalg.norm(direct)
    assert less > 0


def test_a_grid_whose_columns_are_all_their_own_stays_as_it_is(started: Started) -> None:
    problem = started()
    assert interpolated(problem, grid_of(problem, "cage-field", 3)[:1]) is None
    assert interpolated(problem, grid_of(problem, "hysteresis", 9)) is None


def test_combinations_multiply_as_their_columns_do() -> None:
    draw = np.random.default_rng(4)
    made_of, mix, others = draw.normal(size=(60, 3, 5)), draw.normal(size=(5, 7, 2)), draw.normal(size=(180, 4))
    sets = ColumnSets(made_of, 7, mix)
    each = np.stack([sets.columns(place) for place in range(7)], axis=2)
    assert np.allclose(each, np.einsum("nqm,mcp->nqcp", made_of, mix))
    side_by_side = ColumnSets(each.reshape(60, 3, -1), 7)
    for one, other in zip(*(grams_by_band(some, others, bands_of(60)) for some in (sets, side_by_side)), strict=True):
        assert np.allclose(one, other, atol=1e-9)


def test_combinations_span_what_their_columns_do() -> None:
    draw = np.random.default_rng(7)
    made_of, times = draw.normal(size=(40, 3, 6)), draw.integers(1, 9, 30).astype(float)
    mix = draw.normal(size=(6, 4)) @ draw.normal(size=(4, 30))
    one, other = span_of_combinations(made_of, mix, times), principal_span(made_of @ mix, times)
    assert one.shape == other.shape == (40, 3, 4)
    one, other = one.reshape(120, 4), other.reshape(120, 4)
    assert np.allclose(one @ one.T, other @ other.T, atol=1e-9)
