"""What is told of samples that are not kept is what the kept ones tell."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from labcal.bench.running import Running
from labcal.bench.samples import Samples, thinned
from labcal.errors import InstrumentError
from labcal.record.stream import Block


def recording(n: int, seed: int) -> Samples:
    """A drift, a noise with a memory, and a level that dwarfs both; several lines at each moment."""
    rng = np.random.default_rng(seed)
    t = 1e4 + np.floor(np.arange(n) / 7) * 7e-3
    noise = np.cumsum(rng.normal(0, 1, (n, 3)) * 0.3, axis=0) + rng.normal(0, 3, (n, 3))
    return Samples("reference", ("ref_x", "ref_y", "ref_z"), t, 5e4 + noise + 0.2 * t[:, None])


def told(seen: Samples, cuts: list[int]) -> Running:
    running = Running("reference")
    for start, stop in pairwise([0, *sorted(cuts), len(seen)]):
        running.take(Block("reference", "r", seen.columns, seen.t_s[start:stop], seen.values[start:stop], b"raw"))
        running.take(Block("dut", "d", ("dut_x", "dut_y", "dut_z"), seen.t_s[:2], np.ones((2, 3))))
    return running


@given(st.lists(st.integers(0, 500), max_size=8), st.integers(0, 3))
def test_it_tells_what_all_samples_together_tell(cuts: list[int], seed: int) -> None:
    seen = recording(500, seed)
    running = told(seen, cuts)
    assert len(running) == 500
    assert running.columns == seen.columns
    assert running.mean == pytest.approx(seen.mean, rel=1e-12)
    assert running.u_mean == pytest.approx(seen.u_mean, rel=1e-6)
    assert running.noise == pytest.approx(np.sqrt(np.mean(np.diff(seen.values, axis=0) ** 2, axis=0) / 2), rel=1e-9)
    assert running.period_s == pytest.approx(1e-3)
    for axis, (slope, u) in enumerate(zip(*running.trend(), strict=True)):
        line, covariance = np.polyfit(seen.t_s - seen.t_s.mean(), seen.values[:, axis], 1, cov=True)
        assert slope == pytest.approx(line[0], rel=1e-6)
        assert u == pytest.approx(np.sqrt(covariance[0, 0]), rel=1e-6)


def test_a_period_that_cannot_be_told_is_said() -> None:
    same = Samples("dut", ("dut_x",), np.full(5, 2.0), np.zeros((5, 1)))
    with pytest.raises(InstrumentError, match="5 samples came, all at one moment"):
        _ = same.period_s


def test_thinned_to_means_at_their_own_mean_moments() -> None:
    t = np.array([0.1, 0.5, 0.9, 1.1, 5.0])
    blocks = [Block("dut", "d", ("dut_x",), part, 10 * part[:, None], b"raw") for part in (t[:2], t[2:])]
    (one,) = thinned(blocks, 1.0)
    assert one.t_s == pytest.approx([0.5, 1.1, 5.0])
    assert one.values[:, 0] == pytest.approx(10 * one.t_s)
    assert one.raw == b""
