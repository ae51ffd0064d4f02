"""A core that bends strongly: what `apply` works from contains the effect, and the form in the file holds it whole."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.loop import policy
from labcal.loop.close import candidates_of, prepare
from labcal.loop.selection.joint_fit import in_sample_rms, joint_fit
from labcal.loop.selection.proof import select_and_prove
from labcal.loop.selection.second_order import in_full

KNEE_nT = 110e3


def test_a_form_that_reaches_the_noise_to_first_order_only_gives_way_to_a_larger_one_of_its_cause(
    making: ModuleType, tmp_path: Path
) -> None:
    rows, segments = making.recorded()
    rows["dut"] = KNEE_nT * np.tanh(rows["dut"] / KNEE_nT)
    run = session.load_run(str(making.written(tmp_path, rows, segments)))
    problem, level, _ = prepare(run)
    found = select_and_prove(candidates_of(run, problem), level)
    cubic = next(
        c for c in found.pool.candidates if [name for name, _ in c.term.parameters] == ["c3_x", "c3_y", "c3_z"]
    )
    found = replace(found, accepted=(cubic,), contributions=found.contributions[:1])
    alone = joint_fit(problem, [cubic.term], found.pool.valid)
    full, fitted = in_full(problem, found, alone)
    assert full.accepted[0].cause == cubic.cause
    assert full.accepted[0].size > cubic.size
    assert in_sample_rms(fitted) < policy.POLICY.floor_ratio * level.nT < in_sample_rms(alone)
    assert in_full(problem, full, fitted) == (full, fitted)


def test_no_form_is_larger_by_a_shape_that_the_search_did_not_find(
    monkeypatch: pytest.MonkeyPatch, making: ModuleType, tmp_path: Path
) -> None:
    """A temperature at which the reference was right, far outside the run, would be found where a gain is not whole."""
    rows, segments = making.recorded()
    t = rows["t_s"]
    rows["temp_room"] = 21.3 + 1.4 * np.sin(t / 61.0) + 0.004 * t
    rows["ref"] = rows["ref"] / (1 + 0.002 * (rows["temp_room"] - 21.3)[:, None])
    channels = making.CHANNELS | {"temp_room": {"unit": "degC", "quantity": "temperature", "role": "room"}}
    run = session.load_run(str(making.written(tmp_path, rows, segments, channels)))
    problem, level, _ = prepare(run)
    found = select_and_prove(candidates_of(run, problem), level)
    smallest = next(c for c in found.pool.candidates if c.family.id == "reference-temperature" and not c.term.shape)
    found = replace(found, accepted=(smallest,), contributions=found.contributions[:1])
    tried = list[set[str]]()
    monkeypatch.setattr(
        "labcal.loop.selection.second_order.refined",
        lambda pool, form, others: tried.append({shape.name for shape in form.term.shape}) or form,
    )
    in_full(problem, found, joint_fit(problem, [smallest.term], found.pool.valid))
    assert tried
    assert not set().union(*tried)
