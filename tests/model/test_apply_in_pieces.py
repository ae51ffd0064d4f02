"""A recording applied some rows at a time gives what it gives in one: to the last sign that is written."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.apply import apply, apply_in_pieces
from labcal.model.readings import Readings
from labcal.record import Dut

ROWS = 400
CURRENT = ("offset-current", ("i",), {"i": 0.2}, {"c_x": 50.0, "c_y": -3.0, "c_z": 10.0})
WARMTH = ("gain-temperature", ("temp",), {"temp": 20.0}, {"g_x": 1e-4, "g_y": 2e-4, "g_z": -1e-4})
DRIFT = ("offset-drift", (), {}, {"c1_x": 0.4, "c1_y": 0.2, "c1_z": -0.1, "t_ref_s": 10.0})
MODES = ("offset-mode", (), {}, {"c_x quiet": 20.0, "c_y quiet": 2.0, "c_z quiet": -5.0})
LAG = ("lag", (), {}, {"lag_s": 0.05, "secant_s": 0.05})
LOOP = ("hysteresis", (), {}, {"c_x": 0.02, "c_y": 0.03, "c_z": 0.01, "r_nT": 4000.0})
LATE = ("offset-current", ("i",), {"i": 0.2}, {"c_x": 50.0, "c_y": -3.0, "c_z": 10.0, "tau_s": 3.0})
DELAYED = (*CURRENT[:3], {**CURRENT[3], "delay_s": 1.7})
AHEAD = (*CURRENT[:3], {**CURRENT[3], "delay_s": -0.9})
SEVERAL = (*CURRENT[:3], {f"c{tau}s_{a}": 20.0 + tau for tau in (0, 3, 12) for a in "xyz"})
HEAT = ("offset-current-squared", ("i",), {"i": 0.0}, {**CURRENT[3], "tau_s": 1.0})
CURVED = (
    "offset-temperature",
    ("temp",),
    {"temp": 20.0},
    {**CURRENT[3], "d_x": 1.0, "d_y": 0.5, "d_z": 2.0, "tau_s": 5.0},
)
LEADING = ("offset-temperature", ("temp",), {"temp": 20.0}, {**CURRENT[3], "tau_s": -8.0})  # windows end on rows
SLOW_GAIN = (*WARMTH[:3], {**WARMTH[3], "tau_s": 6.0})
FAR_LAG = ("lag", (), {}, {"lag_s": 0.35, "secant_s": 0.35})
DAHL = ("hysteresis", (), {}, {"c_x": 20.0, "c_y": 30.0, "c_z": 10.0, "w_nT": 4000.0})
STOPS = ("hysteresis", (), {}, {f"c{r}_{a}": 0.02 for r in (500, 4000) for a in "xyz"})
KEPT = ("hysteresis", (), {}, {**STOPS[3], "kept": 1.0})
CORE = (
    "hysteresis",
    (),
    {},
    {f"{name}_{a}": 30.0 for name in ("c", "t1") for a in "xyz"} | {"a_nT": 1e4, "pinning_nT": 4e3},
)
RELAYS = (
    *CORE[:3],
    {**{k: v for k, v in CORE[3].items() if k[-2:] != "nT"}, "r_nT": 3e3, "middles_nT": 9e3, "sd_ln": 0.5},
)
ALONE = ("hysteresis", (), {}, {"c_x": 0.2, "c_y": 0.3, "c_z": 0.1, "r_nT": 4000.0, "less_itself": 1.0})
ANEW = ("hysteresis", (), {}, {**STOPS[3], "kept": 0.0})
PLAY = (
    "hysteresis",
    (),
    {},
    {
        f"{c}_{a}": v
        for c, v in (("c", 9.0), ("t1", 5.0), ("a2", 1e-9), ("a3", 1e-13), ("a4", 1e-18), ("a5", 1e-22))
        for a in "xyz"
    }
    | {"r_nT": 1000.0, "s_nT": 20000.0},
)
BAR = (
    "hysteresis",
    (),
    {},
    {f"body_c{r}_{a}": 0.01 for r in (2000, 6000) for a in "xyz"} | {"lon_deg": 30.0, "lat_deg": 20.0, "kept": 1.0},
)


def calibration(*effects: tuple) -> Calibration:
    return Calibration(
        run_id="r",
        simulated=True,
        dut=Dut(serial="S"),
        affine=AffineMap(np.diag([1.1, 0.9, 1.0]), np.array([100.0, -200.0, 300.0])),
        covariance=np.diag([1e-8] * 9 + [4.0] * 3),
        frame_known=True,
        validity=Validity((25e3, 33e3), temperature_C=(15.0, 25.0), modes=("nominal", "quiet")),
        span_s=(0.0, 30.0),
        run_sha256="0" * 64,
        effects=tuple(
            EffectRecord(
                name, channels, reference, "sensor", tuple(Parameter(k, v, abs(v) / 10, "") for k, v in values.items()),
                holdout_rms_before_nT=30.0, holdout_rms_after_nT=12.0,
            )
            for name, channels, reference, values in effects
        ),
        metrics={"before": {}, "after": {"noise_nT": 10.0, "holdout_rms_nT": 25.0}},
    )  # fmt: skip


def recording(seed: int) -> Readings:
    """Turns in three segments, with outliers, a rail, gaps of readings and channels, and rows of an unknown mode."""
    rng = np.random.default_rng(seed)
    turn = np.linspace(0, 9, ROWS)
    reading = 30e3 * np.column_stack([np.cos(turn), np.sin(turn), 0.3 * np.cos(2 * turn)]) + rng.normal(
        0, 10, (ROWS, 3)
    )
    reading[rng.random(ROWS) < 0.02] += [4e3, 0, 0]
    reading[:, 0] = np.minimum(reading[:, 0], 29.8e3)
    reading[rng.random(ROWS) < 0.02, 1] = np.nan
    load = np.where(np.sin(7 * turn) > 0, 0.4, 0.1)
    load[rng.random(ROWS) < 0.05] = np.nan
    load[120:170] = np.nan
    temperature = 20 + 7 * np.sin(turn / 3) + rng.normal(0, 0.01, ROWS)
    modes = np.array(["nominal", "quiet", "loud", ""])[rng.integers(0, 4, ROWS)]
    starts = np.sort(rng.integers(0, ROWS, 3)) if seed else np.array([ROWS])  # the first is all one segment
    segment = np.searchsorted(starts, np.arange(ROWS), side="right")
    t_s = 0.1 * np.arange(ROWS) + 20.0 * np.minimum(segment, 2)  # two segments begin after a while, the third at once
    return Readings(reading, t_s, segment, modes, {"i": load, "temp": temperature})


def written(field_nT: np.ndarray, u_nT: np.ndarray) -> list[str]:
    return [f"{x:.3f} {y:.3f} {z:.3f} {u:.3f}" for (x, y, z), u in zip(field_nT, u_nT, strict=True)]


@pytest.mark.parametrize(
    "effects",
    [
        *((), (CURRENT, WARMTH), (DRIFT, MODES, CURRENT), (LAG,), (LOOP, CURRENT), (LATE, LAG)),
        *((DELAYED,), (AHEAD, FAR_LAG), (SEVERAL,), (HEAT, CURVED), (LEADING,), (SLOW_GAIN,)),
        *(
            (DAHL,),
            (STOPS,),
            (KEPT,),
            (ANEW,),
            pytest.param((ALONE,), marks=pytest.mark.slow),
            (PLAY,),
            (CORE,),
            (RELAYS,),
            (BAR,),
        ),
    ],
    ids=[
        *("map", "channels", "time-and-mode", "lag", "loop", "late"),
        *("delayed", "ahead", "several", "curved", "leading", "slow-gain"),
        *("dahl", "stops", "kept", "anew", "alone", "play", "core", "relays", "bar"),
    ],
)
@settings(max_examples=6)
@given(most=st.integers(5, ROWS + 10), seed=st.integers(0, 3))
def test_pieces_of_any_size_give_what_the_whole_gives(effects: tuple, most: int, seed: int) -> None:
    cal, readings = calibration(*effects), recording(seed)
    whole, pieces = apply(cal, readings), list(apply_in_pieces(cal, readings, most))
    field, u = (np.concatenate([getattr(p, name) for p in pieces]) for name in ("field_nT", "u_nT"))
    assert written(field, u) == written(whole.field_nT, whole.u_nT)
    assert tuple(flag for piece in pieces for flag in piece.flags) == whole.flags


def test_the_recordings_have_what_rows_take_from_the_whole() -> None:
    flags = [flag for seed in range(4) for flag in apply(calibration(CURRENT), recording(seed)).flags]
    found = set(" ".join(flags).split())
    assert {"outlier", "saturated", "field", "mode"} <= found


@pytest.mark.parametrize(
    "effect", [CURRENT, LAG, LATE, DELAYED, LEADING, KEPT, DAHL], ids=lambda effect: "-".join([effect[0], *effect[3]])
)
def test_one_long_segment_is_done_in_pieces_also_where_effects_remember(effect: tuple) -> None:
    found = [len(p.u_nT) for p in apply_in_pieces(calibration(effect), recording(0), 150)]
    assert found == [150, 150, 100]


def test_pieces_are_as_long_as_an_effect_reaches() -> None:
    far = (*CURRENT[:3], {**CURRENT[3], "delay_s": 25.0})
    assert len(next(apply_in_pieces(calibration(far), recording(0), 10)).u_nT) == 250  # of 400 in 40 s


def test_all_rows_are_one_piece_where_an_effect_remembers_and_time_goes_back() -> None:
    readings = recording(0)
    readings.t_s[200:] -= 30.0
    assert [len(p.u_nT) for p in apply_in_pieces(calibration(LAG), readings, 150)] == [ROWS]
    assert len(list(apply_in_pieces(calibration(CURRENT), readings, 150))) == 3
