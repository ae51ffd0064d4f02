"""The parts of procedures that need no bench: words about axes, aliases, waves, orbits, tables, heading."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import ppigrf
import pytest

from labcal.bench.coverage import MOST_GAP_DEG, MOST_GROWTH, gaps, in_words, missing_sectors
from labcal.bench.rotation import stops
from labcal.bench.streams.running import Running
from labcal.bench.streams.samples import Samples, merged
from labcal.errors import InputError
from labcal.geometry import rotate, rotation
from labcal.record.stream import Block
from procedures.ambient import alias
from procedures.axes_check import describe, turned_by
from procedures.cage_calibration import Rung, Sweep, hysteresis, ladder, polarities
from procedures.cage_map import departures
from procedures.degauss import amplitudes
from procedures.play_field import EARTH_KM, orbit_field, read_history
from procedures.sync_check import chips_on, delay
from procedures.verify import errors


def test_axes_that_are_swapped_turned_or_left_handed_are_described() -> None:
    assert describe("DUT", np.eye(3), 15) == []
    assert describe("DUT", np.diag([1, -1, 1]), 15) == ["the DUT's y axis shows −y", "the DUT's axes are left-handed"]
    swapped = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])
    assert describe("reference", swapped, 15) == ["the reference's x axis shows +y", "the reference's y axis shows −x"]
    tilted = rotation([0, 0, 1], np.radians(20))
    assert describe("DUT", tilted, 15) == ["the DUT's x axis points 20° beside", "the DUT's y axis points 20° beside"]


def test_the_angle_between_two_fields_is_right_handed_about_the_axis() -> None:
    before = np.array([1000.0, 200.0, 5000.0])
    axis = np.array([0.0, 0.0, 1.0])
    assert turned_by(axis, before, rotate(axis, np.radians([-20.0]), before)[0]) == pytest.approx(-20.0)


@pytest.mark.parametrize(("rate", "seen"), [(10, 0.0), (25, 0.0), (50, 0.0), (20, 10.0), (154, 50.0), (49.9, 0.1)])
def test_the_mains_folds_to_where_it_is_seen(rate: float, seen: float) -> None:
    t = np.arange(4096) / rate
    spectrum = np.abs(np.fft.rfft(np.cos(2 * np.pi * 50.0 * t + 0.3) * np.hanning(4096)))
    assert alias(50.0, rate) == pytest.approx(seen, abs=1e-9)
    assert np.fft.rfftfreq(4096, 1 / rate)[np.argmax(spectrum)] == pytest.approx(seen, abs=1.5 * rate / 4096)


def test_trend_and_noise_are_apart() -> None:
    rng = np.random.default_rng(1)
    t = np.arange(2000) / 10
    values = 0.5 * t + rng.normal(0, 3, 2000)
    seen = Running("reference")
    seen.take(Block("reference", "r", ("ref_f",), t, values[:, None]))
    (slope,), (u,) = seen.trend()
    assert abs(slope - 0.5) < 4 * u
    assert u == pytest.approx(3 / np.sqrt(np.sum((t - t.mean()) ** 2)), rel=0.05)
    assert seen.noise == pytest.approx(3, rel=0.1)


def test_the_square_wave_is_a_maximum_length_sequence() -> None:
    wave = np.array(chips_on(127)) * 2 - 1
    correlation = [int(wave @ np.roll(wave, shift)) for shift in range(127)]
    assert correlation[0] == 127
    assert set(correlation[1:]) == {-1}


def test_the_delay_of_a_late_stream_is_found_with_its_uncertainty() -> None:
    corners, level = np.repeat(np.arange(0, 16.0), 2)[1:], np.repeat(chips_on(16), 2)[:-1].astype(float)
    t, found = np.arange(0.05, 15, 0.1), list[tuple[float, float]]()
    for seed in range(20):
        noise_nT = np.random.default_rng(seed).normal(0, 0.02, (len(t), 3))
        smooth = np.mean([np.interp(t - 0.13 - d, corners, level) for d in np.linspace(-0.05, 0.05, 21)], axis=0)
        values = np.outer(smooth, [1.0, 0.2, -0.5]) + noise_nT
        found.append(delay(Samples("dut", ("x", "y", "z"), t, values), corners, level))
    assert [d for d, _ in found] == pytest.approx([0.13] * 20, abs=0.02)
    assert max(u for _, u in found) < 0.01


def test_missing_sectors_of_a_turn_by_hand_are_named() -> None:
    angles = np.array([a for a in range(0, 360, 5) if not 90 <= a < 120], dtype=float)
    block = Block("angle", "dial", ("angle_deg",), np.arange(len(angles), dtype=float), angles[:, None])
    assert missing_sectors([block]) == [90, 105]
    assert stops(0.0, 90.0, 30.0) == [30.0, 60.0, 90.0]


@pytest.mark.parametrize(("every_s", "burst"), [(0.1, 1), (1.0, 1), (1.0, 20)])
def test_a_sector_that_the_platform_passed_while_the_dut_sent_nothing_is_missing(every_s: float, burst: int) -> None:
    t = np.arange(0.0, 180.0, 0.2)
    angle = Block("angle", "stage", ("angle_deg",), t, 2.0 * t[:, None])
    sent = np.repeat(np.arange(0.0, 180.0, every_s), burst)

    def dut(stamps: np.ndarray) -> Block:
        return Block("dut", "dut", ("x", "y", "z"), stamps, np.zeros((len(stamps), 3)))

    assert missing_sectors([angle, dut(sent)]) == []
    away = (sent > 40.0) & (sent < 100.0)  # 80 to 200 degrees; what it sees on either side is its usual pause
    blocks = [angle, dut(sent[~away])]
    assert missing_sectors(blocks) == [75, 90, 105, 120, 135, 150, 165, 180]
    ((begins, ends),) = gaps(blocks)
    assert (begins, ends) == pytest.approx((80.0, 200.0), abs=1.0)


def at_angles(angles: np.ndarray) -> list[Block]:
    return [Block("angle", "dial", ("angle_deg",), np.arange(len(angles), dtype=float), angles[:, None])]


def test_a_gap_that_matters_is_found_wherever_it_begins_and_said_by_angle() -> None:
    for begins in (0.0, 1.0, 14.0, 345.0):
        angles = np.arange(begins + 28.0, begins + 361.0, 1.0)
        found = gaps(at_angles(angles))
        assert found == [(begins, begins + 28.0)]
        assert missing_sectors(at_angles(angles))
        assert in_words(found) == f"{begins:.0f}°–{(begins + 28) % 360:.0f}°"
    assert gaps(at_angles(np.arange(20.0, 361.0, 1.0))) == []  # 20 degrees do not matter
    assert gaps(at_angles(np.arange(7.5, 360.0, 15.0))) == []  # nor do stops
    assert gaps(at_angles(np.array([10.0]))) == [(10.0, 370.0)]


def test_without_a_gap_that_is_allowed_no_harmonic_is_known_much_worse() -> None:
    theta = np.radians(np.arange(0.0, 360.0, 0.25))
    waves = [np.sqrt(2) * f(n * theta) for n in (1, 2, 3) for f in (np.cos, np.sin)]
    A = np.column_stack([np.ones_like(theta), *waves])

    def grows(gap_deg: float) -> float:
        seen = A[np.degrees(theta) >= gap_deg]
        return float(1 / np.sqrt(np.linalg.eigvalsh(seen.T @ seen / len(theta))[0]))

    assert pytest.approx(22.5) == MOST_GAP_DEG
    assert MOST_GROWTH - 0.05 < grows(MOST_GAP_DEG) <= MOST_GROWTH
    assert grows(29.0) > MOST_GROWTH


def test_blocks_of_one_source_become_one_and_nothing_is_lost() -> None:
    parts = [
        Block("angle", "dial", ("angle_deg",), np.array([float(n)]), np.array([[2.0 * n]]), b"x") for n in range(3)
    ]
    (one,) = merged(parts)
    assert (list(one.t_s), list(one.values[:, 0]), one.raw) == ([0.0, 1.0, 2.0], [0.0, 2.0, 4.0], b"xxx")


def test_degauss_amplitudes_alternate_and_fall_by_one_ratio() -> None:
    steps = amplitudes(1000.0, 10.0, 5)
    assert steps[1:] / steps[:-1] == pytest.approx([-(0.01**0.25)] * 4)


def test_a_square_helmholtz_pair_is_flat_at_its_centre() -> None:
    """Departure near the centre of a pair at 0.5445 sides is of fourth order: 16 times smaller at half the distance."""
    near, far = departures(2, 1.5, 0.5445, np.array([[0.0, 0.0, 0.05], [0.0, 0.0, 0.1]]))
    assert far / near == pytest.approx(16, rel=0.05)


@pytest.mark.parametrize("attitude", ["inertial", "nadir"])
def test_the_orbits_field_is_that_of_ppigrf_over_the_node(attitude: str) -> None:
    """Against ppigrf's geodetic form, which shares neither frame nor radius with the geocentric one used."""
    epoch, radius = datetime(2026, 1, 1, tzinfo=UTC), EARTH_KM + 500.0
    t = np.array([0.0, 1e-3])
    _, b = orbit_field(t, 500.0, 90.0, epoch, attitude)
    east, north, up = (
        float(np.ravel(v)[0]) for v in ppigrf.igrf(0.0, 0.0, radius - 6378.137, epoch.replace(tzinfo=None))
    )
    expected = [up, east, north] if attitude == "inertial" else [north, east, -up]
    assert b[0] == pytest.approx(expected, abs=2.0)


def test_a_table_with_a_fault_is_refused_at_its_place(tmp_path: Path) -> None:
    path = tmp_path / "history.csv"
    path.write_text("t_s,b_x,b_y,b_z\n0,1,2,3\n1,1,nan,3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"line 3, column b_y: 'nan' is no finite number"):
        read_history(path)
    path.write_text("t_s,b_x,b_y,b_z\n0,1,2,3\n0,1,2,3\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"line 3, column t_s: time does not go on"):
        read_history(path)
    path.write_text("t_s,b_x,b_y\n0,1,2\n", encoding="utf-8")
    with pytest.raises(InputError, match="b_z: this column is missing"):
        read_history(path)


def test_heading_and_magnitude_errors_do_not_see_the_mountings_phase() -> None:
    rng, axis = np.random.default_rng(2), np.array([0.0, 0.0, 1.0])
    true = rng.normal(size=(50, 3)) * 3e4
    heading, magnitude = errors(rotate(axis, np.full(50, 0.7), true), true, axis)
    assert heading == pytest.approx(np.zeros(50), abs=1e-9)
    assert magnitude == pytest.approx(np.zeros(50), abs=1e-6)
    bent = rotate(axis, np.radians(np.where(np.arange(50) % 2, 1.0, -1.0)), true)
    assert np.abs(errors(bent, true, axis)[0]) == pytest.approx(np.ones(50), abs=1e-6)


def swept(fields_nT: np.ndarray, rungs: list[Rung]) -> Sweep:
    """A sweep of coils of 50 µT/A whose fields are `fields_nT` (n, 3), one step in 3 s."""
    fractions, count = [r.fraction for r in rungs], len(rungs)
    currents = np.vstack([np.outer(fractions, axis) for axis in np.eye(3)])
    coil, sign, rising = np.repeat([0, 1, 2], count), [r.sign for r in rungs] * 3, [r.rising for r in rungs] * 3
    return Sweep(
        3.0 * np.arange(3 * count),
        currents,
        5e4 * currents + fields_nT,
        coil,
        np.array(sign),
        np.array(rising),
        1.0,
        0.0,
        0.2,
    )


def test_the_ladder_goes_up_down_and_up_in_either_polarity_and_switches_once_at_zero() -> None:
    rungs = ladder(3)
    assert [r.rising for r in rungs[:9]] == [True] * 3 + [False] * 3 + [True] * 3
    assert [r.sign for r in rungs] == [1] * 9 + [-1] * 9
    assert np.abs([r.fraction for r in rungs[:9]]) == pytest.approx(
        [1 / 3, 2 / 3, 1, 2 / 3, 1 / 3, 0.1, 1 / 3, 2 / 3, 1], rel=0.04
    )
    assert len({abs(r.fraction) for r in rungs}) == 18


def test_hysteresis_and_a_polarity_of_its_own_are_told_apart() -> None:
    rungs = ladder(3)
    noise = np.random.default_rng(1).normal(0, 1.0, (3 * len(rungs), 3))
    late = np.array([r.sign * (20.0 if r.rising else -20.0) for r in rungs])
    weaker = np.array([-1e-3 * 5e4 * r.fraction * (r.sign < 0) for r in rungs])
    for along, up_down, relay in ((0 * late, 0.0, 0.0), (late, 40.0, 0.0), (weaker, 0.0, 1000.0)):
        fields = noise.copy()
        fields[len(rungs) : 2 * len(rungs), 1] += along
        sweep = swept(fields, rungs)
        for (values, u), expected in ((hysteresis(sweep), up_down), (polarities(sweep), relay)):
            assert np.all(np.abs(values - [0.0, expected, 0.0]) < 5 * u)
        assert hysteresis(sweep)[1][[0, 2]].max() < 1
        assert polarities(sweep)[1][[0, 2]].max() < 70
