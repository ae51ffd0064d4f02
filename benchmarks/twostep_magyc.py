"""`twostep` against magyc's `twostep_hsi`: time and accuracy, alternating in one process, on its data and on ours.

magyc needs numpy below 2, so it has an environment of its own, which finds labcal by PYTHONPATH:

    python -m venv /tmp/magyc && /tmp/magyc/bin/pip install "numpy<2" magyc
    OPENBLAS_NUM_THREADS=1 PYTHONPATH=. /tmp/magyc/bin/python benchmarks/twostep_magyc.py
"""

from __future__ import annotations

import pickle
import tempfile
import time
import warnings
from collections.abc import Callable, Sequence
from contextlib import redirect_stdout
from functools import partial
from io import StringIO
from pathlib import Path

import numpy as np
from magyc import create_synthetic_dataset
from magyc.benchmark_methods.twostep import twostep_hsi

from labcal.fit.scalar import scalar_check, twostep

ROUNDS, SAMPLES, NT, REPEATS = 9, 1000, 1e-5, 9  # one nanotesla in gauss
THEIR_NOISE_G = 0.003
Estimate, Correct = Callable[[], object], Callable[..., np.ndarray]
Method = Callable[[np.ndarray, np.ndarray, float], tuple[Estimate, Correct]]
Data = list[tuple[np.ndarray, np.ndarray, np.ndarray]]


def theirs() -> Data:
    """Noisy readings, noiseless readings and the field (3,) [G] of magyc's synthetic data, much motion."""
    np.random.seed(0)  # noqa: NPY002, its generator draws from the global one
    with tempfile.TemporaryDirectory() as folder:
        with redirect_stdout(StringIO()):
            create_synthetic_dataset(Path(folder), niter=ROUNDS, nsamples=SAMPLES, mag_noise_G=THEIR_NOISE_G)
        data = pickle.loads(next(Path(folder).glob("*.pkl")).read_bytes())
    high = data["high"]
    return [
        (noisy, clean, field.ravel()) for noisy, clean, field in zip(high["mmt"], high["mm"], high["m0"], strict=True)
    ]


def ours(noise_G: float) -> Data:
    """The same of a sensor turned about its three axes in 0.5 G."""
    out = []
    turn = np.linspace(0, 2 * np.pi, SAMPLES // 3 + 1)[:-1]
    across = np.sin(1.2) * np.column_stack([np.cos(turn), np.sin(turn)])
    circle = np.column_stack([across, np.full_like(turn, np.cos(1.2))])
    field = 0.5 * np.vstack([np.roll(circle, axis, axis=1) for axis in range(3)])
    soft = np.array([[1.05, 0.02, -0.01], [0.02, 0.97, 0.015], [-0.01, 0.015, 1.02]])
    clean = field @ soft + [0.02, 0.05, -0.03]
    for seed in range(ROUNDS):
        noise = noise_G * np.random.default_rng(seed).standard_normal(clean.shape)
        out.append((clean + noise, clean, np.array([0.5, 0, 0])))
    return out


def by_magyc(reading: np.ndarray, field: np.ndarray, noise: float) -> tuple[Estimate, Correct]:
    """Its estimate, and the readings (n, 3) corrected by it; the field it corrects itself mixes rows and columns."""

    def correct(found: tuple[np.ndarray, np.ndarray, np.ndarray]) -> np.ndarray:
        hard, soft, _ = found
        return (reading - hard) @ np.linalg.inv(soft).T

    return partial(twostep_hsi, reading, field, measurement_noise_std=noise), correct


def by_labcal(reading: np.ndarray, field: np.ndarray, noise: float) -> tuple[Estimate, Correct]:
    """Bias and D, as many numbers as magyc gives, and the readings (n, 3) corrected by them."""

    def correct(found: scalar_check.Estimate) -> np.ndarray:
        return reading + reading @ found.D - found.bias

    magnitude = np.full(len(reading), np.linalg.norm(field))
    return partial(twostep.estimate, reading, magnitude, noise**2 * np.eye(3)), correct


def with_covariance(reading: np.ndarray, field: np.ndarray, noise: float) -> tuple[Estimate, Correct]:
    """The same, the covariance asked for."""
    estimate, correct = by_labcal(reading, field, noise)

    def both() -> scalar_check.Estimate:
        found = estimate()
        assert found.covariance.shape == (9, 9)
        return found

    return both, correct


def measured(
    methods: Sequence[Method], reading: np.ndarray, clean: np.ndarray, field: np.ndarray, noise: float
) -> list[tuple[float, float]]:
    """Of each method the processor seconds of its estimate, and the rms error of the magnitude [G] on noiseless rows.

    The seconds are the best of nine, the methods taking turns, each warmed by a call before; what disturbs the machine
    for a moment so meets no method alone. The error is infinite where there is no answer.
    """
    made = [method(reading, field, noise) for method in methods]
    seconds = [np.inf] * len(methods)
    for _ in range(REPEATS):
        for k, (estimate, _correct) in enumerate(made):
            answered(estimate)
            start = time.process_time()
            answered(estimate)
            seconds[k] = min(seconds[k], time.process_time() - start)
    errors = [error_of(answered(estimate), correct, reading, clean, field) for estimate, correct in made]
    return list(zip(seconds, errors, strict=True))


def answered(estimate: Estimate) -> object | None:
    """What it finds; None where it finds nothing."""
    try:
        return estimate()
    except (ArithmeticError, np.linalg.LinAlgError):
        return None


def error_of(
    found: object | None, correct: Correct, reading: np.ndarray, clean: np.ndarray, field: np.ndarray
) -> float:
    """The rms error of the magnitude [G] left on noiseless readings."""
    corrected = np.array([np.inf]) if found is None else correct(found)
    if not np.isfinite(corrected).all():
        return float("inf")
    design = np.column_stack([reading, np.ones(len(reading))])
    affine = np.linalg.lstsq(design, corrected, rcond=None)[0]
    left = np.linalg.norm(np.column_stack([clean, np.ones(len(clean))]) @ affine, axis=1) - np.linalg.norm(field)
    return float(np.sqrt(np.mean(left**2)))


def main() -> None:
    """Print one line for each data set."""
    warnings.simplefilter("ignore", RuntimeWarning)  # magyc's roots of negative numbers
    sets = [("magyc's synthetic data", theirs(), THEIR_NOISE_G)]
    sets += [(f"three axes in 50 000 nT, noise {noise} nT", ours(noise * NT), noise * NT) for noise in (1, 5, 25, 100)]
    for name, data, noise in sets:
        rows = [measured((by_magyc, by_labcal, with_covariance), *run, noise) for run in data]
        times, errors = np.moveaxis(np.array(rows), 2, 0)
        (slow, fast, _), (before, after, _) = np.median(times, axis=0) * 1e3, np.median(errors, axis=0) / NT
        plain, full = np.median(times[:, :1] / times[:, 1:], axis=0)
        good = " and ".join(map(str, np.sum(errors[:, :2] < 1000 * NT, axis=0)))
        print(
            f"{name}: magyc {slow:.1f} ms, labcal {fast:.3f} ms, ratio {plain:.0f}, with the covariance {full:.0f}; "
            f"magnitude error {before:.2f} nT against {after:.2f} nT; within 1000 nT {good} of {ROUNDS}"
        )


if __name__ == "__main__":
    main()
