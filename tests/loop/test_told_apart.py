"""Two causes that take each other's place: what the readings show goes first, and who is led by little is said.

Runs of the blind programs whose answers were wrong, each made again alone by its index.
"""

from __future__ import annotations

import importlib
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.loop.candidates.library import Candidate, Cause
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.refit import refit
from labcal.loop.result import ClosedLoop
from labcal.loop.selection.equivalents import done_by_readings
from labcal.record import Run
from labcal.store import read_bundle

BLIND = Path(__file__).parents[1] / "blind"


@pytest.fixture
def score(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """What counts the answers of a blind trial."""
    monkeypatch.syspath_prepend(str(BLIND))
    return importlib.import_module("score")


def made(program: str, index: int, folder: Path, seed: int = 29111) -> Run:
    """One run of a seed that was answered."""
    subprocess.run([sys.executable, BLIND / program, folder, "125", str(seed), str(index)], check=True)
    return read_bundle(folder / f"b{index:04}" / "bundle")


def answer(program: str, index: int, folder: Path) -> ClosedLoop:
    """What the loop says of it."""
    return close_loop(made(program, index, folder))


def named(closed: ClosedLoop) -> list[tuple[str, list[str]]]:
    """Each accepted effect with its rivals."""
    return [(one.effect, [rival.effect for rival in one.rivals]) for one in closed.accepted]


def test_rounded_readings_of_a_temperature_go_before_a_drift(tmp_path: Path) -> None:
    """Telemetry in steps of 0.2 K of a temperature that rises and falls once: a drift of fifteen parameters leads."""
    closed = answer("spacecraft.py", 12, tmp_path)
    assert named(closed) == [("offset-temperature", ["offset-drift"])]
    assert closed.verdict == "ambiguous"


def test_a_temperature_that_takes_all_but_a_detail_is_the_rival_of_a_drift_that_leads(tmp_path: Path) -> None:
    """It takes 99.9 % of what a drift of 15 parameters takes, by nine, and leaves an eighth more: it is rounded."""
    closed = close_loop(made("spacecraft.py", 33, tmp_path, 50551))
    assert named(closed) == [("offset-drift", ["offset-temperature"])]
    assert closed.verdict == "ambiguous"


def test_what_is_accepted_already_takes_no_second_place(tmp_path: Path) -> None:
    """A temperature that is taken to act far too late: what a drift takes beside it, it would in another form."""
    problem, _, _ = prepare(made("spacecraft.py", 12, tmp_path))
    pool = CandidateSet.of(problem, 0.85)
    forms = [c for c in pool.candidates if c.cause == ("offset-temperature", ("t_sensor",))]
    late = next(c for c in forms if [(s.name, s.value) for s in c.term.shape] == [("tau_s", 300.0)])
    drifts = [c for c in pool.candidates if c.cause == ("offset-drift", ())]

    def beside(accepted: list[Candidate]) -> list[Cause]:
        scored = pool.score_each(drifts, pool.null_model(accepted))
        drift = max(scored, key=lambda w: w.evidence).candidate
        return [c.cause for c in done_by_readings(pool, accepted, drift)]

    assert beside([]) == [late.cause]
    assert beside([late]) == []


def test_iron_on_the_table_is_found_beside_a_spindle_that_leans(tmp_path: Path) -> None:
    """Iron beside the cage could do nearly what the lean does, and is of the same name as that on the table."""
    closed = answer("magnets.py", 23, tmp_path)
    assert sorted(named(closed)) == [("axis-tilt", []), ("cage-field", [])]
    assert closed.after.holdout_rms_nT < 1.15 * closed.noise_floor_nT


@pytest.mark.slow
def test_iron_that_would_give_another_map_is_a_rival(tmp_path: Path) -> None:
    """The coils' own fields at the device fit as well, but beside them the sensor's gain is 1 % off."""
    closed = answer("magnets.py", 65, tmp_path)
    assert named(closed) == [("field-gradient", ["cage-field"])]


@pytest.mark.slow
def test_u_holds_the_map_that_goes_with_the_rival(tmp_path: Path, score: ModuleType) -> None:
    """The same run, whose true map is the rival's: without it the field is off by six times what is stated."""
    made("magnets.py", 65, tmp_path)
    said = score.put_through(tmp_path / "b0065")
    assert said["fresh"] > 5 * said["knew"]
    assert 0.5 < said["over_stated"] < 1.5


def test_u_holds_the_map_of_a_rival_of_the_device_before_and_after_it_acts(tmp_path: Path, score: ModuleType) -> None:
    """A gain that steps between two mountings is a lean of each: it leaves two maps, and a lean one between them.

    The likelier stands first, for a lean is in no later reading either.
    """
    made("sensor_laws.py", 16, tmp_path, seed=38833)
    said = score.put_through(tmp_path / "b0016")
    assert [*said["named"], *said["rivals"][0]] == ["gain-step", "axis-tilt"]
    assert said["fresh"] < 1.1 * said["knew"]
    stated = said["fresh"] / said["over_stated"]  # half of the square of what the lean's map is off by, 4.4 times
    assert 2.5 * said["knew"] < stated < 4.5 * said["knew"]  # without it 1.0 times


@pytest.mark.slow
def test_a_slow_temperature_that_moved_between_recordings_leaves_room_for_a_second_cause(tmp_path: Path) -> None:
    """A thermostat switched while nothing was recorded: the sensor's state at each beginning nobody saw."""
    run = made("spacecraft.py", 50, tmp_path)
    closed = close_loop(run)
    assert named(closed) == [("offset-temperature", []), ("reference-temperature", [])]
    assert closed.after.holdout_rms_nT < 1.15 * closed.noise_floor_nT
    again = refit(run, closed.accepted)  # begun as far off as anywhere again, not as this run was
    assert np.allclose(again.affine.K, closed.affine.K, rtol=1e-12, atol=0)


@pytest.mark.slow
def test_who_leads_by_less_than_what_is_missed_states_its_rival(tmp_path: Path) -> None:
    """A hall's temperature beside a bus whose telemetry is slow: that misses more than the lead over a drift is."""
    closed = answer("spacecraft.py", 103, tmp_path)
    assert named(closed) == [("offset-channel", []), ("reference-temperature", ["reference-drift"])]
