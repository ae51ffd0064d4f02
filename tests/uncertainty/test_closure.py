"""A closure counts by what the effects leave of it: what a current explains is no zero that moved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from wrong_lab import LOAD_A, MEAN_C, Declared, OFFSET_nT_PER_A, Recorded

from labcal.loop.close import prepare
from labcal.loop.closures import after_effects, left_nT
from labcal.loop.selection.joint_fit import JointFit, joint_fit
from labcal.loop.uncertainty import uncertainty_of
from labcal.model.effects import family
from labcal.record import Run
from labcal.record.closure import Closure, Standstill
from labcal.store import read_bundle, write_bundle

Recording = Callable[..., tuple[Run, Recorded]]
ZERO_nT, FIELD_nT = 3.0, np.array([12_000.0, 9_000.0, -13_000.0])
RECORDED_nT = float(np.linalg.norm(LOAD_A * OFFSET_nT_PER_A))


def standstill(found: Recorded, t_s: float, current_A: float) -> Standstill:
    """In one field, with the current as it is."""
    seen = found.read(FIELD_nT[None], np.array([current_A]), np.array([MEAN_C]), np.zeros((1, 3)))
    x, y, z = seen[0].tolist()
    return Standstill(t_s, (x, y, z), tuple(FIELD_nT.tolist()), "", {"i_eps": current_A})


def closed(found: Recorded, *, mounted_anew: bool = False) -> Closure:
    """The load off, then on, and nothing else."""
    ends = standstill(found, 10.0, 0.0), standstill(found, 500.0, LOAD_A)
    attitude = None if mounted_anew else ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    return Closure("closure x", RECORDED_nT / np.sqrt(12), *ends, attitude)


@pytest.fixture
def made(recorded: Recording) -> tuple[Run, Recorded]:
    """A run with a closure that its own current explains."""
    run, found = recorded(3, Declared(scale_ppm=50.0, zero_nT=ZERO_nT), effect="offset-current", rows=24)
    closure = closed(found)
    u = float(np.hypot(ZERO_nT, closure.u_offset_nT))
    return replace(run, closures=(closure,), reference=replace(run.reference, u_offset_nT=u)), found


def fitted(run: Run, *, explained: bool = True) -> JointFit:
    return joint_fit(prepare(run)[0], [family("offset-current").candidates(run)[0]] if explained else [])


def u_zero(found: JointFit) -> float:
    return next(one.u for one in uncertainty_of(found).declared if one.source == "reference zero x")


def test_what_a_current_explains_is_no_zero_that_moved(made: tuple[Run, Recorded]) -> None:
    run, _ = made
    assert run.reference.u_offset_nT == pytest.approx(40.2, abs=0.5)
    assert u_zero(fitted(run)) == pytest.approx(ZERO_nT, abs=1.0)
    assert u_zero(fitted(run, explained=False)) == pytest.approx(run.reference.u_offset_nT, rel=0.05)


def test_mounted_anew_magnitudes_are_compared(made: tuple[Run, Recorded]) -> None:
    run, found = made
    run = replace(run, closures=(closed(found, mounted_anew=True),))
    along = LOAD_A * OFFSET_nT_PER_A @ FIELD_nT / np.linalg.norm(FIELD_nT)
    assert left_nT(run.closures[0], fitted(run, explained=False)) == pytest.approx(abs(along), rel=0.1)
    assert left_nT(run.closures[0], fitted(run)) < 5.0


def test_where_the_channel_is_missing_the_closure_counts_whole(made: tuple[Run, Recorded]) -> None:
    run, _ = made
    blind = replace(run.closures[0], after=replace(run.closures[0].after, channels={}))
    assert left_nT(blind, fitted(run)) == pytest.approx(RECORDED_nT)


def test_a_closure_survives_the_bundle(made: tuple[Run, Recorded], tmp_path) -> None:
    run, _ = made
    write_bundle(run, tmp_path / "run.zip")
    again = read_bundle(tmp_path / "run.zip")
    assert again.closures == run.closures
    assert after_effects(fitted(again)).reference == after_effects(fitted(run)).reference
