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

from labcal.fit.vector.ml import ml
from labcal.record import Dut, Reference, Run, Segment

K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])


KINDS = ("vector", "axis", "scalar")
AXES = np.eye(3)


def run_of(rows: int, kind: str) -> Run:
    """A run that offers vectors, or three turns about known axes at unknown angles in two fields, or magnitudes."""
    rng = np.random.default_rng(0)
    if kind == "axis":
        field, index, given = turns(rows)
    else:
        u = rng.normal(size=(rows, 3))
        field = rng.uniform(20e3, 50e3, (rows, 1)) * u / np.linalg.norm(u, axis=1, keepdims=True)
        index, given = np.zeros(rows, dtype=np.intp), field
    about = [{"axis_body": tuple(axis), "axis_cage": (0.0, 0.0, 1.0)} for axis in AXES.tolist() * 2]
    segments = [Segment(f"turn{i}", "rotation", **stated) for i, stated in enumerate(about)]
    return Run(
        run_id=kind,
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("s", noise_nT=25.0),
        reference=Reference("scalar" if kind == "scalar" else "vector"),
        segments=tuple(segments) if kind == "axis" else (Segment("free", "free", reference_frame="body"),),
        t_s=np.arange(float(rows)),
        segment_index=index,
        reading=(field + [2e3, -3e3, 1e3]) @ np.linalg.inv(K).T + 25 * rng.normal(size=(rows, 3)),
        reference_vector=None if kind == "scalar" else given,
        reference_magnitude=np.linalg.norm(field, axis=1) if kind == "scalar" else None,
    )


def turns(rows: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The field in the body (n, 3), the segment of each row, and the field in the cage: up along z, across along x."""
    index = np.arange(rows) * 6 // rows
    turn = 2 * np.pi * np.arange(rows) * 6 / rows
    cage = np.where(index < 3, 25e3, 50e3)[:, None] * [np.sin(0.9), 0.0, np.cos(0.9)]
    circle = np.column_stack([cage[:, 2], cage[:, 0] * np.cos(turn), cage[:, 0] * np.sin(turn)])
    field = np.take_along_axis(circle, (np.arange(3) - index[:, None]) % 3, axis=1)
    return field, index, cage


def rival(run: Run) -> Callable[[], np.ndarray]:
    """Least squares on the same residuals from the truth: K full, or symmetric where there are magnitudes alone."""
    upper, scalar = np.triu_indices(3), run.reference_vector is None
    start = np.concatenate([K[upper] if scalar else K.ravel(), [2e3, -3e3, 1e3]])
    turned = run.segments[0].kind == "rotation"
    axis = AXES[run.segment_index % 3]

    def residual(y: np.ndarray) -> np.ndarray:
        gain = np.empty((3, 3))
        if scalar:
            gain[upper] = gain.T[upper] = y[:6]
            return (np.linalg.norm(run.reading @ gain - y[6:], axis=1) - run.reference_magnitude) / 25
        b = run.reading @ y[:9].reshape(3, 3).T - y[9:]
        if not turned:
            return (b - run.reference_vector).ravel() / 25
        height = np.sum(b * axis, axis=1)
        radius = np.linalg.norm(b - height[:, None] * axis, axis=1)
        return np.concatenate([height - run.reference_vector[:, 2], radius - run.reference_vector[:, 0]]) / 25

    return lambda: (
        least_squares(residual, start, method="trf", x_scale=np.r_[np.ones(len(start) - 3), np.full(3, 3e4)]).x
    )


def seconds(work: Callable[[], object]) -> float:
    begun = time.process_time()
    work()
    return time.process_time() - begun


@pytest.mark.parametrize("kind", KINDS)
def test_a_row_of_a_million_costs_no_more_than_one_of_a_thousand_and_memory_stays_below_two_gigabytes(
    kind: str,
) -> None:
    few, many = run_of(1_000, kind), run_of(1_000_000, kind)
    a_row_of_few = min(seconds(lambda: ml(few)) for _ in range(5)) / 1_000
    taken = seconds(lambda: ml(many))
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"| {kind} | 1 000 000 | {taken:.1f} s | | | {memory:.2f} GB |")
    assert taken / 1_000_000 < a_row_of_few
    assert memory < 2


@pytest.mark.parametrize("kind", KINDS)
def test_ten_times_the_rows_take_about_ten_times_as_long(kind: str) -> None:
    some, many = run_of(100_000, kind), run_of(1_000_000, kind)
    ratio = seconds(lambda: ml(many)) / min(seconds(lambda: ml(some)) for _ in range(3))
    print(f"| {kind} | a million over a hundred thousand | {ratio:.1f} |")
    assert ratio < 20


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("rows", [1_000, 10_000, 100_000])
def test_ml(rows: int, kind: str) -> None:
    run = run_of(rows, kind)
    other = rival(run)
    assert ml(run).ok
    pairs = [(seconds(lambda: ml(run)), seconds(other)) for _ in range(5)]
    ours, theirs = (min(column) for column in zip(*pairs, strict=True))
    print(f"| {kind} | {rows} | {1e3 * ours:.0f} ms | {1e3 * theirs:.0f} ms | {theirs / ours:.1f} | |")
    assert ours < 50e-6 * rows
