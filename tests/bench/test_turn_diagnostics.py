"""What one turn shows: noise free of the turn itself, a sense that is the wrong way round, a delay from to and fro."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from labcal.bench.turn_diagnostics import delay_of, look_at_turn, white_noise
from labcal.geometry import rotate, shortest_rotation
from labcal.record.stream import Block

AXIS, RATE_HZ = (0.0, 1.0, 0.0), 10.0
FIELD = np.array([9_000.0, 3_000.0, 12_000.0])  # cage


def bench(kind: str = "vector") -> Any:
    config = SimpleNamespace(
        dut=SimpleNamespace(nominal_nT_per_unit=1.0),
        reference=SimpleNamespace(kind=kind),
        platform=SimpleNamespace(axis_cage=(0.0, 0.0, 1.0)),
    )
    return SimpleNamespace(config=config, platform=SimpleNamespace(motorised=True))


def turned(
    rate_deg_per_s: float, *, late_s: float = 0.0, noise_nT: float = 0.0, mirrored: float = 1.0, along: float = 1.0
) -> list[Block]:
    """One whole turn of a DUT with a bias; `mirrored` −1 turns the wrong way, `along` −1 has its axis upside down."""
    t = np.arange(0.0, 360 / abs(rate_deg_per_s), 1 / RATE_HZ)
    angle = rate_deg_per_s * t
    field = shortest_rotation((0.0, 0.0, 1.0), AXIS) @ FIELD
    seen = rotate(np.asarray(AXIS), -mirrored * np.radians(angle - rate_deg_per_s * late_s), field)
    seen = seen + (along - 1) * (field @ AXIS) * np.asarray(AXIS) + np.array([800.0, -300.0, 150.0])
    seen = seen + noise_nT * np.random.default_rng(1).standard_normal(seen.shape)
    return [
        Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, seen),
        Block("reference", "ref", ("ref_x", "ref_y", "ref_z"), t, np.tile(FIELD, (len(t), 1))),
        Block("angle", "stage", ("angle_deg",), t, np.mod(angle, 360.0)[:, None]),
    ]


def test_the_noise_is_that_of_the_sensor_and_not_the_turn() -> None:
    seen = look_at_turn(bench(), AXIS, turned(20.0, noise_nT=25.0))
    assert seen.noise_nT == pytest.approx(25.0, abs=4 * seen.u_noise_nT)
    assert look_at_turn(bench(), AXIS, turned(20.0)).noise_nT < 1.0
    spiked = np.random.default_rng(2).normal(0.0, 25.0, (400, 3))
    spiked[::40] += 5_000.0
    assert white_noise(spiked)[0] < 45.0


def test_the_stated_uncertainty_of_the_noise_is_the_spread_of_what_is_found() -> None:
    found = [white_noise(np.random.default_rng(n).standard_normal((300, 3))) for n in range(200)]
    values, u = (np.array(part) for part in zip(*found, strict=True))
    assert values.mean() == pytest.approx(1.0, abs=0.02)
    assert 0.7 < values.std() / u.mean() < 1.4


@pytest.mark.parametrize(("how", "wrong"), [({}, 0), ({"mirrored": -1.0}, 1), ({"along": -1.0}, 1)])
def test_a_sense_or_an_axis_the_wrong_way_round_is_counted(how: dict[str, float], wrong: int) -> None:
    assert look_at_turn(bench(), AXIS, turned(20.0, noise_nT=25.0, **how)).wrong_signs == wrong


def test_turns_to_and_fro_tell_the_delay_within_its_uncertainty() -> None:
    turns = [look_at_turn(bench(), AXIS, turned(rate, late_s=0.08, noise_nT=25.0)) for rate in (20.0, -20.0, 20.0)]
    late, u = delay_of(turns) or (np.nan, np.nan)
    assert late == pytest.approx(0.08, abs=4 * u)
    assert u < 0.01
    assert delay_of(turns[:1]) is None
    assert delay_of(turns[::2]) is None  # never back


def test_without_a_vector_reference_there_is_a_sense_but_no_delay() -> None:
    seen = look_at_turn(bench("scalar"), AXIS, turned(20.0))
    assert (seen.wrong_signs, seen.phase_rad) == (0, None)
