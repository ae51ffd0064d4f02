"""Noise that nobody has stated and that follows itself for a few rows is noise; a switch or a wander is none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.loop import close_loop
from labcal.loop.findings.own_colour import is_normal
from labcal.record import Run
from labcal.testing.made_up_runs import made_up_run

N_ROWS = 900
SIZE_nT = 30.0


def undeclared(added: np.ndarray) -> Run:
    """A run of a device without a stated noise, with `added` (n, 3) [nT] in its readings."""
    run = made_up_run(rows=N_ROWS // 6, noise_nT=1.0, declared=False).run
    return replace(run, reading=run.reading + added)


def coloured(memory: float, seed: int) -> np.ndarray:
    """An autoregressive process (n, 3) of the first order, SIZE_nT in each component."""
    draws = np.random.default_rng(seed).normal(size=(N_ROWS, 3))
    out = draws.copy()
    for i in range(1, N_ROWS):
        out[i] = memory * out[i - 1] + np.sqrt(1 - memory**2) * draws[i]
    return SIZE_nT * out


@pytest.mark.parametrize("seed", [1, *(pytest.param(n, marks=pytest.mark.slow) for n in (2, 3))])
def test_noise_with_a_short_memory_is_noise_and_its_floor_is_its_size(seed: int) -> None:
    closed = close_loop(undeclared(coloured(0.7, seed)))
    assert (closed.verdict, closed.accepted) == ("clean", ())
    assert closed.noise_floor_nT == pytest.approx(np.sqrt(3) * SIZE_nT, rel=0.15)
    assert [f.kind for f in closed.findings if f.kind == "coloured-noise"]


@pytest.mark.slow
def test_two_levels_that_nothing_recorded_switches_are_no_noise() -> None:
    switching = np.cumsum(np.random.default_rng(7).random(N_ROWS) < 0.08) % 2
    closed = close_loop(undeclared(np.outer(4 * SIZE_nT * switching, [1.0, -0.5, 0.3])))
    assert closed.verdict == "unexplained"


@pytest.mark.slow
def test_a_wander_as_long_as_the_run_is_no_noise() -> None:
    steps = np.random.default_rng(8).normal(0, SIZE_nT / 3, size=(N_ROWS, 3))
    closed = close_loop(undeclared(np.cumsum(steps, axis=0)))
    assert closed.verdict != "clean"


def test_normal_rows_pass_as_often_as_the_significance_says_and_two_levels_do_not() -> None:
    rng = np.random.default_rng(9)
    passed = [is_normal(rng.normal(size=(400, 3)), 1) for _ in range(200)]
    assert sum(passed) >= 188
    assert not is_normal(np.sign(rng.normal(size=(400, 3))) + 0.3 * rng.normal(size=(400, 3)), 1)
