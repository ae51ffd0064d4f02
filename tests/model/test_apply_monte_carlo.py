"""u_nT beside a Monte Carlo over the joint covariance of map and effects (JCGM 101), for every effect that ships."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.affine import MAP_PARAMETERS
from labcal.model.apply import apply
from labcal.model.effects import families
from labcal.model.readings import Readings
from labcal.record import Dut

ROWS, NOISE_nT = 60, 2.0
TURN = np.linspace(0.0, 7.0, ROWS)
FIELD_nT = 30e3 * np.column_stack([np.cos(TURN), np.sin(TURN), 0.4 * np.cos(2 * TURN)])
K, k_nT = np.array([[1.02, 0.01, 0.0], [0.0, 0.98, -0.01], [0.005, 0.0, 1.01]]), np.array([100.0, -200.0, 300.0])
U_MAP = np.r_[np.full(9, 2e-4), np.full(3, 5.0)]
SHARE = 0.04  # of an effect's parameter: its standard uncertainty
OFFSET = {"c_x": 300.0, "c_y": -200.0, "c_z": 150.0}
EFFECTS = {
    "offset-current": ("i", {**OFFSET, "tau_s": 3.5}),
    "offset-current-squared": ("i", OFFSET),
    "offset-temperature": ("temp", {"c_x": 60.0, "c_y": -45.0, "c_z": 30.0}),
    "offset-channel": ("volts", OFFSET),
    "gain-temperature": ("temp", {"g_x": 1.2e-3, "g_y": -9e-4, "g_z": 1.5e-3}),
    "gain-channel": ("volts", {"g_x": 1.2e-3, "g_y": -9e-4, "g_z": 1.5e-3}),
    "gain-step": ("", {"g_x": 4e-3, "g_y": -3e-3, "g_z": 2e-3, "t_step_s": 31.0}),
    "offset-step": ("", {**OFFSET, "t_step_s": 31.0}),
    "offset-drift": ("", {"c1_x": 4.0, "c1_y": 2.0, "c1_z": -3.0, "t_ref_s": 10.0}),
    "offset-mode": ("", {f"{name} quiet": value for name, value in OFFSET.items()}),
    "periodic": ("", {**{f"{part}_{axis}": 60.0 for part in ("cos", "sin") for axis in "xyz"}, "f_Hz": 0.037}),
    "nonlinearity": ("", {"c3_x": 8e-12, "c3_y": 6e-12, "c3_z": -7e-12}),
    "cross-field": ("", {"q_x:yz": 2e-7, "q_y:zx": -3e-7, "q_z:xy": 2e-7}),
    "hysteresis": ("", {"c_x": 0.02, "c_y": 0.03, "c_z": 0.01, "r_nT": 4000.0}),
    "lag": ("", {"lag_s": 0.4, "secant_s": 0.4}),
}
FIXED = ("t_ref_s", "t_step_s", "secant_s")  # a convention, a moment (a gap of its own), the lag itself
U_OF = {"f_Hz": 2e-4, "r_nT": 100.0}
SETTLED = {"offset-current": 30, "hysteresis": 15}  # rows of what went before the first: test_unknown_beginning.py
COARSE = {"lag": 2}  # last rows: undone through fewer, u holds what that misses as well, which no draw has


def uncertain(name: str) -> tuple[Calibration, np.ndarray]:
    """A calibration with that effect, and its whole joint covariance: everything is correlated with everything."""
    channel, values = EFFECTS[name]
    u = {n: 0.0 if n in FIXED else U_OF.get(n, SHARE * abs(v)) for n, v in values.items()}
    free = [n for n in values if n not in FIXED]
    scale = np.r_[U_MAP, [u[n] for n in free]]
    covariance = scale[:, None] * (0.2 * np.eye(len(scale)) + 0.8) * scale
    names = (*MAP_PARAMETERS, *(f"0:{n}" for n in free))
    return made(name, channel, values, u, covariance=covariance, covariance_of=names), covariance


def made(
    name: str, channel: str, values: dict[str, float], u: dict[str, float], map_of: np.ndarray | None = None, **more
) -> Calibration:
    theta = np.r_[K.ravel(), k_nT] if map_of is None else map_of
    channels = (channel,) if channel else ()
    parameters = tuple(Parameter(n, v, u[n], "") for n, v in values.items())
    effect = EffectRecord(name, channels, dict.fromkeys(channels, 0.1), "sensor", parameters)
    return Calibration(
        run_id="r", simulated=True, dut=Dut(serial="S"), affine=AffineMap(theta[:9].reshape(3, 3), theta[9:]),
        frame_known=True, validity=Validity((0.0, 1e5), modes=("nominal", "quiet")), span_s=(0.0, 60.0),
        run_sha256="0" * 64, effects=(effect,), metrics={"before": {}, "after": {"noise_nT": NOISE_nT}},
        **{"covariance": None, **more},
    )  # fmt: skip


def readings(noise: np.ndarray | float = 0.0) -> Readings:
    t = np.arange(float(ROWS))
    channels = {"i": 0.3 + 0.3 * np.sin(t / 5), "temp": 5 * np.sin(t / 9), "volts": np.cos(t / 4)}
    mode = np.where(np.arange(ROWS) % 20 < 10, "quiet", "nominal")
    reading = np.linalg.solve(K, (FIELD_nT + k_nT).T).T + noise
    return Readings(reading, t, np.zeros(ROWS, dtype=np.intp), mode, channels)


def scatter(name: str, draws: int) -> np.ndarray:
    """Root mean square over components of the scatter (n,) of fields by drawn maps, effects and noises."""
    _, covariance = uncertain(name)
    channel, values = EFFECTS[name]
    draw, free = np.random.default_rng(5), [n for n in values if n not in FIXED]
    found = []
    u = np.sqrt(np.diag(covariance))
    root = np.linalg.cholesky(covariance / u / u[:, None]).T
    for step in draw.normal(size=(draws, len(u))) @ root * u:
        moved = {**values, **{n: values[n] + by for n, by in zip(free, step[12:], strict=True)}}
        moved |= {"secant_s": moved["lag_s"]} if name == "lag" else {}
        there = made(name, channel, moved, dict.fromkeys(values, 0.0), np.r_[K.ravel(), k_nT] + step[:12])
        found.append(apply(there, readings(NOISE_nT * draw.normal(size=(ROWS, 3)))).field_nT)
    return np.asarray(np.sqrt(np.var(found, axis=0).mean(axis=1)))


def ratio(name: str, draws: int) -> np.ndarray:
    """Scatter over u_nT in the rows that nothing flags, and that know their past."""
    told = apply(uncertain(name)[0], readings())
    plain = np.array([flag == "" for flag in told.flags])
    assert plain.mean() > 0.8
    plain[: SETTLED.get(name, 0)] = False
    plain[ROWS - COARSE.get(name, 0) :] = False
    return np.asarray(scatter(name, draws)[plain] / told.u_nT[plain])


@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=pytest.mark.slow if n % 2 else ()) for n, one in enumerate(EFFECTS)]
)
def test_u_is_the_scatter_of_drawn_calibrations(name: str) -> None:
    assert ratio(name, 60) == pytest.approx(1.0, abs=0.4)


@pytest.mark.slow
@pytest.mark.parametrize("name", EFFECTS)
def test_u_is_the_scatter_of_drawn_calibrations_in_every_row(name: str) -> None:
    found = ratio(name, 2000)
    print(f"{name}: {found.min():.3f} to {found.max():.3f}")
    assert found == pytest.approx(1.0, abs=0.1)


def test_every_effect_that_ships_is_here() -> None:
    ours = {f.id for f in families() if f.kernel.__module__.startswith("labcal.") and f.belongs_to == "sensor"}
    assert {*EFFECTS} == ours - {"empirical"}  # a sum of columns: tests/loop/test_empirical.py
