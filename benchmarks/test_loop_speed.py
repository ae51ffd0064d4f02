"""`close_loop` against the number of rows: processor time, wall time and memory, all candidates in; `-s` prints them.

Three axes turned in two fields at any sampling rate, with a current that is at work and a temperature that is not; and
hard runs of 1 500 rows, where the search goes on: a loop beside the current in a field that steps; a nameless walk.
"""

from __future__ import annotations

import os
import resource
import time
from collections.abc import Callable

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small; waiting threads only cost

import numpy as np
import pytest
from numpy.typing import NDArray

from labcal.loop import close_loop
from labcal.record import Dut, Reference, Run, Segment
from labcal.record.run import Channel

Array = NDArray[np.float64]
ROWS = (1_500, 10_000, 30_000, 100_000, 300_000)
SECONDS = 900.0
NOISE_nT = 25.0
AXES = np.eye(3)
LEVELS_nT = np.array([50e3, 20e3, -10e3, -50e3, -20e3, 10e3])


def nothing(body: Array) -> Array:
    """No effect but the current's."""
    return np.zeros_like(body)


def run_of(rows: int, added: Callable[[Array], Array] = nothing, *, steps: bool = False) -> Run:
    """Six turns in `SECONDS`; the device's gain is 1.05, its offset 800 nT and 300 nT along x for each ampere.

    `added` gives what else it reads in a field (rows, 3) [nT], which `steps` every 40 rows or stands for three turns.
    """
    rng = np.random.default_rng(0)
    t = np.linspace(0.0, SECONDS, rows)
    index = np.minimum(np.arange(rows) * 6 // rows, 5)
    angle = 2 * np.pi * 6 * t / SECONDS
    size = LEVELS_nT[np.arange(rows) // 40 % len(LEVELS_nT)] if steps else np.where(index < 3, 20e3, 50e3)
    cage = size[:, None] * np.array([0.5, 0.6, 0.62])
    axis = AXES[index % 3]
    along = np.sum(cage * axis, axis=1, keepdims=True) * axis
    body = along + np.cos(angle)[:, None] * (cage - along) - np.sin(angle)[:, None] * np.cross(axis, cage)
    current = (np.mod(t, 47.0) < 19.0) * 0.8 + rng.normal(0, 0.01, rows)
    reading = 1.05 * body + 800 + current[:, None] * [300.0, 0, 0] + rng.normal(0, NOISE_nT, body.shape) + added(body)
    segments = tuple(
        Segment(f"turn{i}", "rotation", axis_body=a, axis_cage=a, body_from_cage=((1, 0, 0), (0, 1, 0), (0, 0, 1)))
        for i, a in enumerate([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)] * 2)
    )
    return Run(
        run_id=f"{rows}-rows",
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("s", noise_nT=NOISE_nT),
        reference=Reference("vector"),
        segments=segments,
        t_s=t,
        segment_index=index,
        reading=reading,
        reference_vector=cage,
        angle_deg=np.degrees(angle) % 360,
        channels=(
            Channel("i_load", "A", "current", current),
            Channel("temp", "degC", "temperature", 20 + 3 * np.sin(t / 90.0) + rng.normal(0, 0.05, rows)),
        ),
    )


def test_the_cost_of_a_row_does_not_grow_and_a_hundred_thousand_take_half_a_minute_and_two_gigabytes() -> None:
    seconds = {}
    for rows in ROWS:
        run = run_of(rows)
        begun, wall = time.process_time(), time.perf_counter()
        found = close_loop(run)
        seconds[rows], wall = time.process_time() - begun, time.perf_counter() - wall
        memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
        print(f"| {rows} | {seconds[rows]:.1f} s | {wall:.1f} s | {memory:.2f} GB |")
        assert [e.effect for e in found.accepted] == ["offset-current"]
        if rows == 100_000:
            assert seconds[rows] < 30
            assert memory < 2
    assert seconds[300_000] / 300_000 < seconds[30_000] / 30_000


def loop(body: Array) -> Array:
    """What a magnetic part adds that lags 3 µT behind the field (rows, 3): ± 400 nT."""
    state = np.zeros_like(body)
    for row, step in enumerate(np.diff(body, axis=0), start=1):
        state[row] = np.sign(step) + (state[row - 1] - np.sign(step)) * np.exp(-np.abs(step) / 3e3)
    return 400 * state


def walk(body: Array) -> Array:
    """A random walk along each axis, ten times the noise in the end."""
    steps = np.random.default_rng(1).normal(0, 10 * NOISE_nT / np.sqrt(len(body)), body.shape)
    return np.cumsum(steps, axis=0)


@pytest.mark.parametrize(("hard", "named"), [(loop, {"hysteresis"}), (walk, set())])
def test_a_hard_run_of_fifteen_hundred_rows(hard: Callable[[Array], Array], named: set[str]) -> None:
    run = run_of(1_500, hard, steps=hard is loop)
    begun, wall = time.process_time(), time.perf_counter()
    found = close_loop(run)
    seconds, wall = time.process_time() - begun, time.perf_counter() - wall
    causes = {e.effect for e in found.accepted}
    print(f"| {hard.__name__} | {found.verdict}: {', '.join(sorted(causes))} | {seconds:.1f} s | {wall:.1f} s |")
    assert named <= causes
    assert named or "hysteresis" not in causes
