"""A prediction taken at another time: as exact as a cubic, and with the noise of one row whatever the time is."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.model.effects.displaced import displaced

ROWS, RATE, SIZE_nT = 4000, 0.45, 2e4  # 26 degrees a second


def stamps(period_s: float, jitter: float) -> np.ndarray:
    chance = np.random.default_rng(5)
    return np.cumsum(period_s * (1 + jitter * chance.uniform(-1, 1, ROWS)))


def turning(t_s: np.ndarray) -> np.ndarray:
    return SIZE_nT * np.column_stack([np.cos(RATE * t_s), np.sin(RATE * t_s), np.ones(len(t_s))])


@pytest.mark.parametrize(
    "by_s",
    [
        pytest.param(-0.003, marks=pytest.mark.slow),
        -0.04,
        pytest.param(-0.05, marks=pytest.mark.slow),
        pytest.param(0.06, marks=pytest.mark.slow),
        pytest.param(-0.13, marks=pytest.mark.slow),
        0.77,
    ],
)
@pytest.mark.parametrize(("period_s", "jitter"), [(0.1, 0.0), (0.1, 0.2), (0.01, 0.0), (0.001, 0.0)])
def test_what_turns_is_known_at_any_time_inside(period_s: float, jitter: float, by_s: float) -> None:
    t_s = stamps(period_s, jitter)
    found = displaced(t_s, np.zeros(ROWS, dtype=np.intp), turning(t_s), np.full(ROWS, by_s))
    inside = (t_s + by_s > t_s[0]) & (t_s + by_s < t_s[-1])
    assert found[inside] == pytest.approx(turning(t_s + by_s)[inside], abs=0.2)  # 1e-5 of it


@pytest.mark.parametrize("by_s", [-0.04, -0.05, -0.06, -0.1, -0.15, -0.25])
@pytest.mark.parametrize("jitter", [0.0, 0.2])
def test_no_time_has_less_noise_than_a_row(jitter: float, by_s: float) -> None:
    t_s, noise = stamps(0.1, jitter), np.random.default_rng(7).standard_normal((ROWS, 3))
    there = displaced(t_s, np.zeros(ROWS, dtype=np.intp), noise, np.full(ROWS, by_s))
    assert np.mean(there**2) >= np.mean(noise**2) * 0.97  # interpolation between two rows: half of it
    near = displaced(t_s, np.zeros(ROWS, dtype=np.intp), noise, np.full(ROWS, -0.04)) - noise
    assert abs(np.mean(near * noise)) < 0.05 * np.mean(noise**2)


def test_beyond_its_ends_a_segment_goes_on_straight_and_segments_do_not_meet() -> None:
    t_s = 0.1 * np.arange(20.0)
    segment = np.repeat(np.array([0, 1], dtype=np.intp), 10)
    values = np.where(segment == 0, 3.0 * t_s, 100.0 - 2.0 * t_s)[:, None]
    found = displaced(t_s, segment, values, np.full(20, 0.35))
    assert found == pytest.approx(np.where(segment == 0, 3.0, -2.0)[:, None] * 0.35 + values)


def test_a_segment_too_short_for_a_cubic_is_interpolated() -> None:
    t_s = 0.1 * np.arange(4.0)
    found = displaced(t_s, np.zeros(4, dtype=np.intp), t_s[:, None], np.full(4, -0.05))
    assert found[1:, 0] == pytest.approx(t_s[1:] - 0.05)
