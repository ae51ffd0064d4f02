"""What a channel, or the field, did before a recording's first row: u_nT beside a Monte Carlo over such pasts."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply
from labcal.model.readings import Readings
from labcal.model.smooth import Domain
from labcal.record import Dut

TAU_S, STEP_S, NOISE_nT, DRAWS = 20.0, 0.5, 1.0, 60
OFFSET = np.array([300.0, -200.0, 150.0])
LOOP = np.array([0.03, 0.02, 0.04])
SEEN_A = (0.0, 0.4)


def calibration(name: str, channels: tuple[str, ...], values: dict[str, float]) -> Calibration:
    """One effect whose parameters are certain, of a sensor whose map is."""
    effect = EffectRecord(
        name, channels, dict.fromkeys(channels, 0.0), "sensor",
        tuple(Parameter(n, v, 0.0, "") for n, v in values.items()),
        domain=tuple(Domain((f"channel:{c}",), ((SEEN_A[0],), (SEEN_A[1],))) for c in channels),
    )  # fmt: skip
    return Calibration(
        run_id="r", simulated=True, dut=Dut(serial="S"), affine=AffineMap(np.eye(3), np.zeros(3)), covariance=None,
        frame_known=True, validity=Validity((0.0, 1e5)), span_s=(0.0, 60.0), run_sha256="0" * 64, effects=(effect,),
        metrics={"before": {}, "after": {"noise_nT": NOISE_nT}},
    )  # fmt: skip


OF_OFFSET, OF_LOOP = (dict(zip(("c_x", "c_y", "c_z"), one, strict=True)) for one in (OFFSET, LOOP))
BEHIND = calibration("offset-current", ("i",), {**OF_OFFSET, "tau_s": TAU_S})


def switched(draw: np.random.Generator, t_s: np.ndarray, dwell_s: float) -> np.ndarray:
    """A load that goes on and off at random, as long in either state on the mean."""
    edges = t_s[0] + np.cumsum(draw.exponential(dwell_s, 50 + int(3 * np.ptp(t_s) / dwell_s)))
    return SEEN_A[1] * ((np.searchsorted(edges, t_s) + draw.integers(2)) % 2)


def behind(drive: np.ndarray) -> np.ndarray:
    """The response of first order to a drive that stands from row to row, straight in between."""
    keep, state = np.exp(-STEP_S / TAU_S), drive[0]
    found = [state]
    for before, here in pairwise(drive):
        state = keep * state + (1 - keep) * (before + here) / 2
        found.append(state)
    return np.array(found)


def errors_over_u(recorded_s: float, dwell_s: float) -> np.ndarray:
    """Rms error over rms u in each of the first three time constants that are recorded, of loads with random pasts."""
    found, u = [], []
    for seed in range(DRAWS):
        draw = np.random.default_rng(seed)
        t_s = np.arange(-10 * TAU_S, recorded_s, STEP_S)
        load = switched(draw, t_s, dwell_s)
        now, n = t_s >= 0, int((t_s >= 0).sum())
        field = np.tile([30e3, 1e3, -2e3], (n, 1))
        reading = field + behind(load)[now, None] * OFFSET + NOISE_nT * draw.normal(size=(n, 3))
        rows = Readings(reading, t_s[now], np.zeros(n, dtype=np.intp), None, {"i": load[now]})
        told = apply(BEHIND, rows)
        found.append(np.mean((told.field_nT - field) ** 2, axis=1))
        u.append(told.u_nT**2)
    part = np.floor(np.arange(len(u[0])) * STEP_S / TAU_S)
    parts = [part == k for k in sorted(set(part[part < 3]))]
    return np.array([np.sqrt(np.mean(np.array(found)[:, rows]) / np.mean(np.array(u)[:, rows])) for rows in parts])


@pytest.mark.parametrize("dwell_s", [10.0, 40.0])
def test_in_the_first_time_constants_u_holds_what_the_channel_did_before(dwell_s: float) -> None:
    ratio = errors_over_u(300.0, dwell_s)
    assert (ratio > 0.7).all()
    assert (ratio < 1.2).all()


def test_of_a_recording_in_which_nothing_happens_u_is_what_the_channel_may_have_done() -> None:
    (ratio,) = errors_over_u(10.0, 40.0)  # half a time constant: mostly the load stood
    assert 0.5 < ratio < 1.2


def test_a_channel_that_moves_slowly_leaves_less_open_than_one_that_switches() -> None:
    t_s = np.arange(0.0, 300.0, STEP_S)
    field = np.tile([30e3, 1e3, -2e3], (len(t_s), 1))
    slow = 0.2 + 0.2 * np.sin(t_s / 1000.0)
    fast = SEEN_A[1] * (np.mod(t_s, 45.0) < 20.0)
    first = [
        apply(BEHIND, Readings(field, t_s, np.zeros(len(t_s), dtype=np.intp), None, {"i": load})).u_nT[0]
        for load in (slow, fast)
    ]
    assert first[0] < 0.5 * first[1]


def with_loop(field: np.ndarray, begins: np.ndarray, r_nT: float) -> np.ndarray:
    """What a sensor reads whose part follows the reading as a stop: row after row, until both agree."""
    seen, state, found = field[0] + LOOP * begins, begins, []
    for here in field:
        reading = seen
        for _ in range(8):
            reading = here + LOOP * np.clip(state + reading - seen, -r_nT, r_nT)
        state, seen = np.clip(state + reading - seen, -r_nT, r_nT), reading
        found.append(reading)
    return np.array(found)


@pytest.mark.parametrize("shape", [{"r_nT": 3000.0}, {"r_nT": 3000.0, "kept": 0.0}], ids=["at-rest", "demagnetised"])
def test_a_loop_begins_anywhere(shape: dict[str, float]) -> None:
    """The stop of a random past in the field: where it was, the recording does not say until it has turned twice."""
    cal = calibration("hysteresis", (), {**OF_LOOP, **shape})
    found, u = [], []
    for seed in range(DRAWS):
        draw = np.random.default_rng(seed)
        t_s = np.arange(0.0, 60.0, STEP_S)
        field = 15e3 * np.sin(0.05 * t_s[:, None] + draw.uniform(0, 2 * np.pi, 3))
        begins = draw.uniform(-1, 1, 3) * shape["r_nT"]
        reading = with_loop(field, begins, shape["r_nT"]) + NOISE_nT * draw.normal(size=field.shape)
        told = apply(cal, Readings(reading, t_s, np.zeros(len(t_s), dtype=np.intp)))
        found.append(np.mean((told.field_nT - field) ** 2, axis=1))
        u.append(told.u_nT**2)
    first, last = slice(1, 5), slice(-20, None)
    ratio = [np.sqrt(np.mean(np.array(found)[:, rows]) / np.mean(np.array(u)[:, rows])) for rows in (first, last)]
    assert 0.6 < ratio[0] < 1.2
    assert 0.8 < ratio[1] < 1.2
