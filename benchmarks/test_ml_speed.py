"""`ml` against `scipy.optimize.least_squares` on the same rows, and in time and memory against their number.

The rival gets the true map as its start, weights all rows alike, and gives neither covariance nor robustness nor a word
on what the run determines. Seconds are of the processor, the ratio of two taken in turn; `-s` prints the table.
"""

from __future__ import annotations

import resource
import time
from collections.abc import Callable

import numpy as np
import pytest
from scipy.optimize import least_squares

from labcal.fit.ml import ml
from labcal.record import Dut, Reference, Run, Segment

K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])


def run_of(rows: int, kind: str) -> Run:
    rng = np.random.default_rng(0)
    u = rng.normal(size=(rows, 3))
    field = rng.uniform(20e3, 50e3, (rows, 1)) * u / np.linalg.norm(u, axis=1, keepdims=True)
    reading = (field + [2e3, -3e3, 1e3]) @ np.linalg.inv(K).T + 25 * rng.normal(size=(rows, 3))
    vector = kind == "vector"
    return Run(
        run_id=kind,
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("s", noise_nT=25.0),
        reference=Reference("vector" if vector else "scalar"),
        segments=(Segment("free", "free", reference_frame="body"),),
        t_s=np.arange(float(rows)),
        segment_index=np.zeros(rows, dtype=np.intp),
        reading=reading,
        reference_vector=field if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(field, axis=1),
    )


def rival(run: Run) -> Callable[[], np.ndarray]:
    """Least squares on the same residuals from the truth: vectors with K full, magnitudes with K symmetric."""
    upper = np.triu_indices(3)
    start = np.concatenate([K[upper] if run.reference_vector is None else K.ravel(), [2e3, -3e3, 1e3]])

    def residual(y: np.ndarray) -> np.ndarray:
        gain = np.empty((3, 3))
        if run.reference_vector is not None:
            return ((run.reading @ y[:9].reshape(3, 3).T - y[9:]) - run.reference_vector).ravel() / 25
        gain[upper] = gain.T[upper] = y[:6]
        return (np.linalg.norm(run.reading @ gain - y[6:], axis=1) - run.reference_magnitude) / 25

    return lambda: (
        least_squares(residual, start, method="trf", x_scale=np.r_[np.ones(len(start) - 3), np.full(3, 3e4)]).x
    )


def seconds(work: Callable[[], object]) -> float:
    begun = time.process_time()
    work()
    return time.process_time() - begun


@pytest.mark.parametrize("kind", ["vector", "scalar"])
def test_a_million_rows_take_no_more_each_than_a_thousand(kind: str) -> None:
    run = run_of(1_000_000, kind)
    taken = seconds(lambda: ml(run))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"| {kind} | 1 000 000 | {taken:.1f} s | | | {memory:.2f} GB |")
    assert taken < 50
    assert memory < 2


@pytest.mark.parametrize("kind", ["vector", "scalar"])
@pytest.mark.parametrize("rows", [1_000, 10_000, 100_000])
def test_ml(rows: int, kind: str) -> None:
    run = run_of(rows, kind)
    other = rival(run)
    assert ml(run).ok
    pairs = [(seconds(lambda: ml(run)), seconds(other)) for _ in range(5)]
    ours, theirs = (min(column) for column in zip(*pairs, strict=True))
    print(f"| {kind} | {rows} | {1e3 * ours:.0f} ms | {1e3 * theirs:.0f} ms | {theirs / ours:.1f} | |")
    assert ours < 50e-6 * rows
