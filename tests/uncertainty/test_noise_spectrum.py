"""Least squares under noise of four colours: intervals hold the truth, and white noise costs nothing."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.loop.noise.bands import Bands, cosine_transform
from labcal.loop.noise.bounded import weighted_spectra
from labcal.loop.noise.coloured import noise_spectrum, weighted_gram

ROWS, DRAWS = 400, 60
Draw = np.random.Generator


def _columns() -> np.ndarray:
    """A constant, a turn, a fast and a slow wave, a drift and a switched load, on each of three components."""
    t = np.arange(ROWS)
    wave = 2 * np.pi * t
    of_one = np.column_stack([np.ones(ROWS), np.cos(wave / 60), np.sin(wave / 7.3), np.sin(wave / 350), t / ROWS - 0.5,
                              np.mod(t, 75) < 31])  # fmt: skip
    return np.einsum("np,ab->napb", of_one, np.eye(3)).reshape(ROWS, 3, -1)


def _white(draw: Draw) -> np.ndarray:
    return draw.normal(size=(ROWS, 3))


def _correlated(draw: Draw, decay: float) -> np.ndarray:
    """Exponentially correlated, of variance one."""
    out, state = np.empty((ROWS, 3)), draw.normal(size=3)
    for row in range(ROWS):
        state = decay * state + np.sqrt(1 - decay**2) * draw.normal(size=3)
        out[row] = state
    return out


def _autoregressive(draw: Draw) -> np.ndarray:
    return 2 * _correlated(draw, 0.9) + 0.5 * _white(draw)


def _random_walk(draw: Draw) -> np.ndarray:
    walk = 0.15 * np.cumsum(_white(draw), axis=0)
    return walk - walk.mean(axis=0) + _white(draw)  # the constant is that of the run's span


def _flicker(draw: Draw) -> np.ndarray:
    """1/f noise of waves down to an eighth of the run's lowest, counted from its mean over the run."""
    f = np.fft.rfftfreq(8 * ROWS)[1:]
    parts = draw.normal(size=(2, len(f), 3)) / np.sqrt(f)[:, None]
    spectrum = np.concatenate([np.zeros((1, 3)), parts[0] + 1j * parts[1]])
    made = np.fft.irfft(spectrum, axis=0)[:ROWS] * np.sqrt(ROWS)
    return made - made.mean(axis=0) + 0.3 * _white(draw)


NOISE = {"white": _white, "autoregressive": _autoregressive, "random walk": _random_walk, "flicker": _flicker}


def bounded_noise(transformed: np.ndarray, y: np.ndarray) -> tuple[Bands, np.ndarray]:
    """The bands, and the noise's variance in each over all spectra that were tried."""
    weighted = weighted_spectra(transformed, y)
    return weighted.bands, weighted.mean


def _over_u(make: object, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Errors over their stated u, and u over that of white least squares."""
    A, y = _columns(), make(np.random.default_rng(seed))
    flat = A.reshape(-1, A.shape[2])
    inverse = np.linalg.inv(flat.T @ flat)
    moved = cosine_transform(A)
    bands, spectrum = bounded_noise(moved, cosine_transform(y))
    u = np.sqrt(np.diag(inverse @ weighted_gram(moved, bands, spectrum) @ inverse))
    return inverse @ (flat.T @ y.ravel()) / u, u / np.sqrt(np.diag(inverse))


@pytest.fixture(scope="module")
def found() -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Of each kind of noise, both for every draw and parameter."""
    each = {name: [_over_u(make, seed) for seed in range(DRAWS)] for name, make in NOISE.items()}
    return {name: (np.array([z for z, _ in of]), np.array([u for _, u in of])) for name, of in each.items()}


@pytest.mark.slow
def test_intervals_hold_the_truth_in_95_of_100_over_all_kinds_of_noise(found) -> None:
    covered = {name: np.mean(np.abs(z) < 1.96) for name, (z, _) in found.items()}
    assert 0.93 <= np.mean(list(covered.values())) <= 0.97, covered
    assert all(0.90 <= share <= 0.99 for share in covered.values()), covered


def test_white_noise_costs_nothing(found) -> None:
    over_white = found["white"][1]
    assert np.all(np.median(over_white, axis=0) < 1.05)
    assert np.mean(over_white < 1.3) > 0.97
    assert over_white.min() > 0.9


def test_a_short_correlation_is_not_carried_to_zero_frequency() -> None:
    """A random walk that follows a short correlation best says many times too much of a constant."""
    A, moved = _columns(), cosine_transform(_columns())
    flat = A.reshape(-1, A.shape[2])
    inverse = np.linalg.inv(flat.T @ flat)
    y = _correlated(np.random.default_rng(3), 0.9)
    true = np.sqrt((1 + 0.9) / (1 - 0.9))  # the root of the spectrum at zero over that of white noise
    carried, bounded = (
        np.sqrt((inverse @ weighted_gram(moved, *of) @ inverse)[0, 0] / inverse[0, 0])
        for of in (noise_spectrum(moved.copy(), y), bounded_noise(moved, cosine_transform(y)))
    )
    assert carried > 1.8 * true
    assert 0.8 * true < bounded < 1.25 * true


@pytest.mark.slow
@pytest.mark.parametrize("name", NOISE)
def test_each_kind_of_noise_is_covered_over_many_draws(name: str) -> None:
    z = np.array([_over_u(NOISE[name], seed)[0] for seed in range(1000, 1600)])
    assert 0.91 <= np.mean(np.abs(z) < 1.96) <= 0.985
