"""A cause beside what the related forms of an accepted effect are likely to do, not beside all that they span."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.policy import POLICY
from labcal.loop.selection import admission, stepwise
from labcal.loop.selection.admission import evidence_beside_likely_forms, evidence_of_its_own, plain_evidence
from labcal.loop.selection.related import related_columns
from labcal.loop.selection.stepwise import backward_check, best_beside_likely_forms

Rows = dict[str, np.ndarray]
STANDING_nT = np.array([90.0, -120.0, 60.0])
IRON = 1e-3 * np.array([[4.0, 2.0, -3.0], [-1.0, -5.0, 2.5], [1.5, -2.0, 1.0]])  # of the field that magnetises it
HALF_WIDTH_nT, SLOPE, PERIOD_s, LINE_nT = 6000.0, 0.05, 44.0, np.array([60.0, -42.0, 30.0])


def _play(field_nT: np.ndarray) -> np.ndarray:
    """What follows a field (n,) once it is farther away than the half-width (Visintin's play operator)."""
    out, last = np.empty_like(field_nT), float(field_nT[0])
    for i, h in enumerate(field_nT):
        last = out[i] = min(max(last, h - HALF_WIDTH_nT), h + HALF_WIDTH_nT)
    return out


def _loop_beside_a_line(rows: Rows) -> np.ndarray:
    held = np.stack([_play(along) for along in rows["ref"].T], axis=1)
    line = np.sin(2 * np.pi * (rows["t_s"] - rows["t_s"][0]) / PERIOD_s)
    return np.asarray(SLOPE * (held - rows["ref"]) + np.outer(line, LINE_nT))


def test_a_line_beside_a_loop_is_found_though_the_forms_of_a_loop_span_it(
    started: Callable[..., LinearProblem],
) -> None:
    """There are hundreds of forms of a loop: free to mix, they take whatever is slow."""
    pool = CandidateSet.of(started(_loop_beside_a_line), 0.85)
    loops = [c for c in pool.candidates if c.family.id == "hysteresis"]
    loop = refined(pool, pool.rank(loops)[0].candidate, [])
    lines = [c for c in all_candidates(pool, [loop]) if c.family.id == "periodic"]
    line = pool.rank(lines, [loop])[0]
    spanned = pool.score(line.candidate, pool.null_model([loop], related_columns(pool, [loop])))
    assert spanned.evidence < 0 < POLICY.min_evidence < evidence_of_its_own(pool, [loop], line.candidate)
    found = best_beside_likely_forms(pool, [loop], lines)
    assert found is not None
    assert backward_check(pool, [loop, found.candidate]) == [loop, found.candidate]


def test_it_leads_by_the_evidence_of_a_name_over_what_the_forms_may_still_do(
    started: Callable[..., LinearProblem], monkeypatch: pytest.MonkeyPatch
) -> None:
    pool = CandidateSet.of(started(_loop_beside_a_line), 0.85)
    loop = pool.rank([c for c in pool.candidates if c.family.id == "hysteresis"])[0].candidate
    lines = [c for c in all_candidates(pool, [loop]) if c.family.id == "periodic"]
    found = best_beside_likely_forms(pool, [loop], lines)
    assert found is not None
    for lead, stands in ((0.5, False), (-0.5, True)):
        still = found.evidence - POLICY.min_evidence + lead
        monkeypatch.setattr(stepwise, "gain_of", lambda model, forms, nats=still: nats)
        assert (best_beside_likely_forms(pool, [loop], lines) is not None) is stands


def test_what_lies_wholly_within_the_forms_of_another_is_one_of_them(
    started: Callable[..., LinearProblem], monkeypatch: pytest.MonkeyPatch
) -> None:
    """However well it does alone: what iron beside the cage does in a turn is a lean of the axis as well."""

    def stands_beside_iron(rows: Rows) -> np.ndarray:
        axis = np.eye(3)[["xyz".index(name[0]) for name in rows["segment"]]]
        in_cage, turn = STANDING_nT + rows["ref"] @ IRON.T, rows["angle"][:, None]
        along = np.sum(in_cage * axis, axis=1, keepdims=True) * axis
        return np.asarray(along + np.cos(turn) * (in_cage - along) - np.sin(turn) * np.cross(axis, in_cage))

    pool = CandidateSet.of(started(stands_beside_iron), 0.85)
    standing = next(c for c in pool.candidates if c.family.id == "cage-field" and len(c.term.parameters) == 3)
    lean = pool.rank([c for c in pool.candidates if c.family.id == "axis-tilt"], [standing])[0].candidate
    monkeypatch.setattr(admission, "LIKELIEST", 0)
    assert evidence_beside_likely_forms(pool, [standing], lean) > POLICY.min_evidence
    assert plain_evidence(pool, [standing], lean) < 1.0
