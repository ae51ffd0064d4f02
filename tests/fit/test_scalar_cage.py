"""A cage by magnitudes alone, against coils and a drifting place that are made up here."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.fit.scalar_cage import Magnitudes, ScalarCage, by_components, fit_scalar_cage, largest_En, with_matrix
from procedures.scalar_cage import components, joined, rotating

COILS = np.array([[50_100.0, -250.0, 180.0], [-310.0, 49_800.0, 90.0], [-170.0, 160.0, 50_300.0]])
EARTH = np.array([20_400.0, 1_150.0, -43_700.0])
LEAK_A = np.array([4e-4, 3e-4, -2e-4])


def in_the_coils_frame() -> tuple[np.ndarray, np.ndarray]:
    """What no rotation changes: the upper triangle of the coils, and the place's field along with it (QR by hand)."""
    x = COILS[:, 0] / np.linalg.norm(COILS[:, 0])
    y = COILS[:, 1] - (COILS[:, 1] @ x) * x
    y /= np.linalg.norm(y)
    frame = np.array([x, y, np.cross(x, y)])
    return frame @ COILS, frame @ EARTH


def seen(steps: list[np.ndarray | None], seed: int, noise_nT: float = 0.1, from_s: float = 0.0) -> Magnitudes:
    """The magnitudes at `steps` of currents, 3.5 s apart, beside a place that waves by some nT."""
    rng, t = np.random.default_rng(seed), from_s + 3.5 * np.arange(len(steps))
    I = np.array([np.zeros(3) if step is None else step for step in steps])  # noqa: E741  # I is the current, as in the papers
    signs = np.array([np.zeros(3) if step is None else np.where(step >= 0, 1.0, -1.0) for step in steps])
    wave = np.outer(np.sin(2 * np.pi * t / 400), [8.0, -6.0, 5.0])
    b = (I + LEAK_A * signs) @ COILS.T + EARTH + wave
    return Magnitudes(t, I, signs, np.linalg.norm(b, axis=1) + rng.normal(0, noise_nT, len(t)))


def both(seed: int, noise_nT: float = 0.1) -> tuple[Magnitudes, Magnitudes]:
    first = seen(components(np.full(3, 0.8)), seed, noise_nT)
    fields = rotating(50e3, 32, 4)[0]
    second = seen([np.linalg.solve(COILS, b - EARTH) for b in fields], seed + 1000, noise_nT, first.t_s[-1] + 4.0)
    return first, second


def errors(found: ScalarCage, at: Magnitudes) -> np.ndarray:
    A, b0 = in_the_coils_frame()
    wave = np.outer(np.sin(2 * np.pi * at.t_s / 400), [8.0, -6.0, 5.0]).mean(axis=0)
    frame = A @ np.linalg.inv(COILS)
    true = np.r_[A[np.triu_indices(3)], b0 + frame @ wave, LEAK_A]
    return np.asarray(found.parameters - true)


def test_both_methods_find_the_coils_in_their_own_frame() -> None:
    first, second = both(1)
    for rows in (first, second, joined(first, second)):
        start = fit_scalar_cage(first) if rows is second else None
        found = fit_scalar_cage(rows, start=start)
        z = errors(found, rows) / np.sqrt(np.diag(found.covariance))
        assert np.abs(z).max() < 4.5
        assert np.std(found.residual_nT) < 0.15
    assert largest_En(fit_scalar_cage(first), fit_scalar_cage(second, start=fit_scalar_cage(first))) < 1.5


def test_constants_and_angles_are_the_coils_with_uncertainties_that_hold() -> None:
    found = [fit_scalar_cage(joined(*both(seed))) for seed in range(25)]
    length = np.linalg.norm(COILS, axis=0)
    u = COILS / length
    square = np.degrees(np.arcsin([u[:, 0] @ u[:, 1], u[:, 0] @ u[:, 2], u[:, 1] @ u[:, 2]]))
    for true, told in ((length, [f.constants() for f in found]), (square, [f.angles_deg() for f in found])):
        z = np.array([(value - true) / u_value for value, u_value in told])
        assert 0.75 < np.sqrt(np.mean(z**2)) < 1.25


def test_errors_over_sixty_runs_are_as_large_as_their_uncertainty() -> None:
    runs = [joined(*both(seed)) for seed in range(60)]
    found = [fit_scalar_cage(rows) for rows in runs]
    z = np.array([errors(f, rows) / np.sqrt(np.diag(f.covariance)) for f, rows in zip(found, runs, strict=True)])
    assert 0.88 < np.sqrt(np.mean(z**2)) < 1.15
    whole = [errors(f, r) @ np.linalg.solve(f.covariance, errors(f, r)) for f, r in zip(found, runs, strict=True)]
    assert np.mean(whole) == pytest.approx(12, abs=3)


def test_what_is_declared_of_the_sensor_moves_the_answer_as_its_errors_would() -> None:
    rows = joined(*both(2))
    plain = fit_scalar_cage(rows)
    wide = fit_scalar_cage(rows, u_zero_nT=5.0, u_scale_ppm=20.0)
    others = rows.magnitude_nT + 5.0, rows.magnitude_nT * (1 + 2e-5)
    for part, F in zip(wide.contributions, others, strict=True):
        moved = fit_scalar_cage(replace(rows, magnitude_nT=F)).parameters - plain.parameters
        u = np.sqrt(np.diag(plain.covariance))
        assert np.abs((moved - part.shift) / (np.abs(part.shift) + u)).max() < 0.05


def test_the_closed_form_is_exact_where_nothing_drifts_or_leaks() -> None:
    steps = components(np.full(3, 0.8))
    I = np.array([np.zeros(3) if step is None else step for step in steps])  # noqa: E741  # I is the current, as in the papers
    F = np.linalg.norm(I @ COILS.T + EARTH, axis=1)
    A, b0 = by_components(Magnitudes(np.arange(len(F), dtype=float), I, 0 * I, F))
    true_A, true_b0 = in_the_coils_frame()
    assert pytest.approx(true_A, abs=1e-4) == A
    assert pytest.approx(true_b0, abs=1e-4) == b0
    assert with_matrix(COILS, Magnitudes(np.zeros(len(F)), I, 0 * I, F)) == pytest.approx(EARTH, abs=1e-4)


def test_currents_that_tell_too_little_are_refused() -> None:
    alone = seen([0.8 * s * np.eye(3)[j] for j in range(3) for s in (1, -1)] * 8, 0)
    with pytest.raises(ValueError, match="each alone in both signs, and every two together"):
        by_components(alone)
    dead = seen(components(np.full(3, 0.8)), 0)
    flat = replace(dead, magnitude_nT=np.random.default_rng(1).normal(5e4, 1.0, len(dead)))
    with pytest.raises(ValueError, match="does the sensor follow the currents"):
        by_components(flat)
    few = dead.select(np.arange(len(dead)) < 20)
    with pytest.raises(ValueError, match=r"too few|do not determine"):
        fit_scalar_cage(few, start=fit_scalar_cage(dead))
