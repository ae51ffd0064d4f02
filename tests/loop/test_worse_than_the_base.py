"""Effects that are worse on rows held out than the base about its own map are none, however well they fit."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest

from labcal.loop import policy
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.selection import proof
from labcal.loop.selection.crossval import cross_validate, fixed_choice
from labcal.loop.selection.select import select


def test_what_is_better_than_the_base_about_another_map_alone_is_not_named(
    searching: Callable[..., CandidateSet], monkeypatch: pytest.MonkeyPatch
) -> None:
    base, level = searching({}, {}), NoiseFloor(36.0, "differences", None)
    about = CandidateSet.of(base.problem, base.min_noise_level)  # stands for the map that goes with the effect
    nothing = select(about, level)
    useless = max(about.candidates, key=lambda c: c.size)
    held = cross_validate(about, nothing.blocks, fixed_choice([useless]))
    seeming = replace(held, before_nT=1000 * held.before_nT, after_nT=10 * held.after_nT)
    known = proof.cross_validate
    monkeypatch.setattr(proof, "nested_selection", lambda _, __, most, *barred: fixed_choice([useless] if most else []))
    monkeypatch.setattr(proof, "cross_validate", lambda *of: seeming if of[2](of[0]) == [useless] else known(*of))
    found = proof.prove(base, about, replace(nothing, accepted=(useless,), contributions=(seeming,)), level)
    assert found.accepted == ()
    assert useless.cause in found.refused
    assert found.cv_error.after == found.cv_error.before < policy.POLICY.floor_ratio * level.nT
