"""The preflight on the twin: what it records, what a fit makes of it, and what fails it."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.linalg import sqrtm

from labcal import session
from labcal.bench.clock import RealClock
from labcal.errors import InputError, LimitNotMet
from labcal.fit.vector.ml import ml
from labcal.record.stream import Event, Measurement, Prompt, Step
from labcal.store import Store
from labcal.twin.config import TwinTruth
from labcal.twin.sensor import response
from procedures.preflight_plan import MORE_S, PreflightPlan

BenchFile = Callable[..., Path]
SHORT = {"rate_deg_per_s": "20", "zero_s": "4", "dwell_s": "2"}


def test_it_records_every_axis_magnitude_sign_and_mode_as_a_whole_turn(bench_file: BenchFile) -> None:
    outcome = session.run("preflight", bench_file(), SHORT, operator="J. Doe", seed=3)
    assert outcome.status == "finished", outcome.fault
    assert not outcome.failed
    run = session.load_run(outcome.run_id)
    recorded = {(s.mounting, s.mode, s.id.split("uT")[0][1:]) for s in run.segments}
    assert recorded == {(a, m, b) for a in "xyz" for m in ("nominal", "full") for b in ("+20", "+50", "-50")}
    assert {s.axis_body for s in run.segments} == {(1, 0, 0), (0, 1, 0), (0, 0, 1)}
    for index, segment in enumerate(run.segments):
        rows = run.rows(index)
        assert np.ptp(run.angle_deg[rows]) > 355
        sign = -1 if "-50" in segment.id else 1
        field = np.median(run.reference_vector[rows], axis=0)
        inclination = np.degrees(np.arccos(sign * field[2] / np.linalg.norm(field)))
        assert inclination == pytest.approx(50, abs=1.0)
        assert np.linalg.norm(field) == pytest.approx(2e4 if "+20" in segment.id else 5e4, rel=0.01)


@pytest.mark.slow
def test_a_fit_of_the_record_finds_the_truth_of_the_twin(bench_file: BenchFile) -> None:
    """The DUT reads (R b + bias) / 4 nT, so K = 4 R⁻¹ and k = R⁻¹ bias: signs, frames and units all hold."""
    outcome = session.run("preflight", bench_file(), SHORT | {"rate_deg_per_s": "8", "modes": "nominal"}, seed=5)
    fit, truth = ml(session.load_run(outcome.run_id)), TwinTruth().dut
    assert fit.affine is not None, fit.why_not
    R = response(*(np.array(v) for v in (truth.scale, truth.nonorthogonality_deg, truth.misalignment_deg)))
    for field in 5e4 * np.vstack([np.eye(3), -np.eye(3)]):
        reading = (R @ field + truth.bias_nT) / truth.nT_per_unit
        assert fit.affine.apply(reading) == pytest.approx(field, abs=25.0)
    with Store.open() as store:
        notes = [i.text for i in store.items(outcome.run_id) if isinstance(i, Event) and "offsets so far" in i.text]
    assert notes[0] == "offsets so far: not yet determined by the turns made"
    root = sqrtm(np.linalg.inv(R @ R.T)).real  # K of the magnitudes, from readings in nT
    said = re.findall(r"[xyz] (-?\d+) ± (\d+)", notes[-1])
    for true, (value, expanded) in zip(root @ truth.bias_nT, said, strict=True):
        assert float(value) == pytest.approx(true, abs=2 * float(expanded) + 1)


def test_the_zero_the_checks_the_rate_and_the_closure_stand_in_the_record(bench_file: BenchFile) -> None:
    outcome = session.run("preflight", bench_file(), SHORT | {"axes": "z", "modes": "nominal"}, seed=3)
    with Store.open() as store:
        items = list(store.items(outcome.run_id))
        assert store.header(outcome.run_id).parameters["axes"] == ["z"]
    measured = {item.name: item for item in items if isinstance(item, Measurement)}
    assert measured["zero: ref_z"].value == pytest.approx(-43_700, abs=100)
    assert measured["closure z"].verdict == "PASS"
    closures = [item.value for name, item in measured.items() if name.startswith("closure")]
    assert len(closures) == 3
    u_zero_nT = session.load_run(outcome.run_id).reference.u_offset_nT
    assert u_zero_nT == pytest.approx(np.hypot(3.0, max(closures) / np.sqrt(12)))
    kept = session.load_run(outcome.run_id).closures
    assert [closure.name for closure in kept] == [name for name in measured if name.startswith("closure")]
    assert [closure.body_from_cage is None for closure in kept] == [False, True, True]
    assert {"i_eps", "temp_dut"} <= set(kept[0].before.channels or {})
    assert measured["z+50uT-nominal: missing sectors"].value == 0
    assert {"rotation rate", "DUT behind the angle", "closure, DUT less reference, coils off"} <= set(measured)
    asked = [item.key for item in items if isinstance(item, Prompt) and item.acts]
    assert asked[:4] == ["ready", "mount-z", "mode-nominal", "ready"]
    last = [item for item in items if isinstance(item, Event)][-1]
    assert (last.kind, last.text) == ("read-back", "coils at zero")


def test_the_fastest_allowed_rate_follows_from_the_timing_uncertainty(bench_file: BenchFile) -> None:
    outcome = session.run("preflight", bench_file(), {"axes": "z", "modes": "nominal", "reverse": "no"}, seed=3)
    with Store.open() as store:
        rate = next(i for i in store.items(outcome.run_id) if isinstance(i, Measurement) and i.name == "rotation rate")
    b_across, u_time_s, allowed_nT = 50e3 * np.sin(np.radians(50)), 0.005, 8.0
    assert np.radians(rate.value) * u_time_s * b_across == pytest.approx(allowed_nT, rel=1e-6)


def test_a_closure_beyond_its_limit_fails_the_run(bench_file: BenchFile) -> None:
    drift = 'effects = { "offset-step" = { at_s = 160.0 } }'
    outcome = session.run("preflight", bench_file(drift), SHORT | {"closure_nT": "40"}, seed=4)
    assert outcome.status.startswith("failed: closure")
    assert "something moved or drifted" in outcome.status
    assert (session.load_run(outcome.run_id).reference.u_offset_nT or 0) > 40 / np.sqrt(12)
    with pytest.raises(LimitNotMet):
        outcome.raise_fault()


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ({"axes": "x,q"}, "axes = q is refused: expected one of x, y, z"),
        ({"axes": "x,y,x"}, "axes states one twice"),
        ({"modes": "nominal,turbo"}, "power mode 'turbo' is none of the DUT's"),
        ({"rate_deg_per_s": "36"}, "36 deg/s is too fast: DUT and platform allow 20 deg/s"),
    ],
)
def test_what_cannot_be_done_is_refused_before_anybody_mounts_anything(
    bench_file: BenchFile, given: dict[str, str], says: str
) -> None:
    asked: list[str] = []
    with pytest.raises(InputError, match=says):
        session.run(
            "preflight", bench_file(), given, answer=lambda prompt: asked.append(prompt.key) or "done"
        ).raise_fault()
    assert not asked


def test_a_field_that_the_coils_cannot_make_is_refused_after_the_zero_and_not_in_its_turn(
    bench_file: BenchFile,
) -> None:
    tender = bench_file("", ("field_nT = 100000.0", "field_nT = 40000.0"))
    outcome = session.run("preflight", tender, SHORT, seed=3)
    assert "a field of 50000 nT is beyond the limit of the DUT, 40000 nT; nothing was set" in outcome.status
    with Store.open() as store:
        items = list(store.items(outcome.run_id))
    assert not [i for i in items if isinstance(i, Event) and i.kind == "set-point"]


@pytest.mark.parametrize(
    ("wrong", "says"),
    [
        (("angle_sign = 1", "angle_sign = -1"), "the angle runs the wrong way round"),
        (("[reference]\n", "[reference]\ncage_from_sensor = [[0,1,0],[1,0,0],[0,0,1]]\n"), "reference's x axis shows"),
    ],
)
def test_what_points_the_wrong_way_is_said_in_words_and_stops_it(
    bench_file: BenchFile, wrong: tuple[str, str], says: str
) -> None:
    outcome = session.run("preflight", bench_file("", wrong), SHORT, seed=3)
    assert outcome.status.startswith("failed: axes-check")
    assert says in outcome.status


def test_an_axis_is_redone_before_it_is_dismounted_and_the_first_try_is_kept_but_not_used(
    bench_file: BenchFile,
) -> None:
    asked = list[str]()

    def answer(prompt: Prompt) -> str:
        asked.append(prompt.key)
        if prompt.key == "mount-y" and asked.count("mount-y") == 1:
            return "redo x"
        return prompt.choices[0] if prompt.choices else "lift moved"

    given = SHORT | {"axes": "x,y", "modes": "nominal", "magnitudes_nT": "20000"}
    outcome = session.run("preflight", bench_file(), given, answer=answer, seed=3)
    assert outcome.status == "finished", outcome.fault
    run = session.load_run(outcome.run_id)
    assert [s.id for s in run.segments] == ["x+20uT-nominal-2", "x-20uT-nominal-2", "y+20uT-nominal", "y-20uT-nominal"]
    assert {s.mounting for s in run.segments} == {"x", "y"}
    with Store.open() as store:
        items = list(store.items(outcome.run_id))
    refused = next(i for i in items if isinstance(i, Event) and i.kind == "not-used")
    assert (refused.data["reason"], refused.data["segments"]) == ("lift moved", ["x+20uT-nominal", "x-20uT-nominal"])
    steps = [item.name for item in items if isinstance(item, Step)]
    turned = ["x+20uT-nominal", "x-20uT-nominal", "closure-x", "mount-y"]
    assert steps[3:13] == ["mount-x", *turned, *turned, "y+20uT-nominal"]  # the mounting is asked for once more
    measured = {item.name: item for item in items if isinstance(item, Measurement)}
    assert [measured[f"x+20uT-nominal: {what}"].verdict for what in ("noise", "wrong signs")] == ["PASS"] * 2
    assert measured["delay x"].verdict == "PASS"


def test_what_is_redone_after_an_interruption_is_in_the_time_that_is_left() -> None:
    kept = frozenset({"x+20uT-nominal"})
    estimate: Any = None  # nothing is taken into it: the plan is all that is asked
    plan = PreflightPlan(
        ("x", "y"), (20e3,), ("nominal",), 50.0, True, 20.0, 8.0, 0.005, 0.0, 5.0, 10.0, 500.0, 0.5, estimate,
        kept,
    )  # fmt: skip
    assert dict(plan.plan().steps)["x+20uT-nominal"] == 0.0
    assert dict(plan.without("x").plan().steps)["x+20uT-nominal"] == 18.0 + MORE_S


@pytest.mark.slow
def test_at_true_speed_it_records_the_same_as_on_the_virtual_clock(bench_file: BenchFile) -> None:
    given = SHORT | {"axes": "z", "modes": "nominal", "magnitudes_nT": "20000", "reverse": "no", "zero_s": "2"}
    begun = time.monotonic()
    outcome = session.run("preflight", bench_file(), given, clock=RealClock(), seed=3)
    lasted_s = time.monotonic() - begun
    assert outcome.status == "finished", outcome.fault
    true = session.load_run(outcome.run_id)
    virtual = session.load_run(session.run("preflight", bench_file(), given, seed=3).run_id)
    assert lasted_s > np.ptp(true.t_s) > 17
    assert [s.id for s in true.segments] == [s.id for s in virtual.segments]
    assert len(true) == pytest.approx(len(virtual), rel=0.05)
    assert np.median(np.diff(true.t_s)) == pytest.approx(0.1, abs=1e-6)
