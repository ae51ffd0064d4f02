"""`pso-axis`: the swarm against a plain loop with an SVD for each particle, and against pyswarms with that loop.

All three evaluate the same objective (model 1 of Riwanto et al. 2017, published weights and sign rule) equally often;
the ratio is of the best times of this very run. `pip install pyswarms` for the second comparison.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest
from riwanto import MODELS, simulate
from swarm_by_loop import rotation_axis_fitness

from labcal.fit.swarm.loci import Loci, loci_of
from labcal.fit.swarm.objectives import RotationAxisObjective
from labcal.fit.swarm.particle_swarm import SwarmSettings, minimise
from labcal.fit.swarm.search import PUBLISHED, objective_of

HIGH = np.r_[np.ones(9), np.full(3, 5000.0)]
ROUNDS = 5


def problem(samples: int) -> tuple[RotationAxisObjective, Callable[[np.ndarray], np.ndarray]]:
    """The objective of a whole swarm, and the same by a loop over the particles."""
    loci = loci_of(simulate(MODELS[0], seed=0, samples=samples))
    return objective_of(loci, 2000.0, PUBLISHED), by_loop(loci)


def by_loop(loci: Loci) -> Callable[[np.ndarray], np.ndarray]:
    parts = [loci.reading[loci.rows(i)] for i in range(len(loci.axes))]
    return lambda swarm: np.array([rotation_axis_fitness(p, parts, loci.axes, loci.magnitude) for p in swarm])


def seconds(work: Callable[[], object], rounds: int) -> float:
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


@pytest.mark.parametrize(("samples", "iterations"), [(300, 100), (10_000, 20)])
def test_swarm_against_a_loop(benchmark, samples, iterations):
    fast, slow = problem(samples)
    settings = SwarmSettings(iterations=iterations)

    def search(objective):
        return minimise(objective, -HIGH, HIGH, np.random.default_rng(0), settings)

    benchmark.pedantic(search, args=(fast,), rounds=ROUNDS, warmup_rounds=1)
    ratio = seconds(lambda: search(slow), 2) / benchmark.stats.stats.min
    benchmark.extra_info["ratio"] = ratio
    assert search(fast).value == pytest.approx(search(slow).value, rel=1e-9)  # the same course, place by place
    assert ratio > 20


def test_swarm_against_pyswarms(benchmark, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # pyswarms writes report.log where it stands
    pyswarms = pytest.importorskip("pyswarms", reason="`pip install pyswarms` for this comparison")
    fast, slow = problem(300)
    settings = SwarmSettings(iterations=100)

    def theirs() -> float:
        options = {"w": settings.w[2], "c1": settings.c1[2], "c2": settings.c2[2]}
        swarm = pyswarms.single.GlobalBestPSO(
            settings.particles, 12, options, bounds=None, velocity_clamp=None, init_pos=None
        )
        return float(swarm.optimize(slow, settings.iterations, verbose=False)[0])

    benchmark.pedantic(
        minimise, args=(fast, -HIGH, HIGH, np.random.default_rng(0), settings), rounds=ROUNDS, warmup_rounds=1
    )
    ratio = seconds(theirs, 2) / benchmark.stats.stats.min
    benchmark.extra_info["ratio"] = ratio
    assert ratio > 30
