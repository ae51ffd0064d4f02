"""The archive with ten years of five hundred sensors in it, and the pace of a push.

`pytest benchmarks/test_archive.py -s` prints the figures of docs/performance.md; it starts a PostgreSQL of its own.
"""

from __future__ import annotations

import resource
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

TESTS = Path(__file__).parents[1] / "tests" / "archive"
sys.path.insert(0, str(TESTS))

from made_up import Years, fill  # noqa: E402
from postgres import Server, server  # noqa: E402
from test_queries import answers  # noqa: E402

from labcal.record import Dut, Reference, RunHeader, Segment  # noqa: E402
from labcal.record.stream import Block, SegmentClosed, SegmentOpened  # noqa: E402
from labcal.session import archiving  # noqa: E402
from labcal.store import Store  # noqa: E402

YEARS = Years(500, 10)
RUNS, SAMPLES = 5, 20_000


@pytest.fixture(scope="module")
def running() -> Iterator[Server]:
    with server() as one:
        yield one


def test_questions(running: Server) -> None:
    url = running.url(name := running.database())
    archiving.init_archive(url, None)
    fill(running, name, YEARS)
    answers(url, YEARS)
    took = [answers(url, YEARS) for _ in range(5)]
    runs = YEARS.sensors * YEARS.runs
    print(f"\n{YEARS.sensors} sensors, {runs} runs, {runs * SAMPLES:.0e} samples")
    for question in took[0]:
        times = sorted(one[question] for one in took)
        print(f"  {question}: {times[0]:.3f} s, at most {times[-1]:.3f} s")


def test_push(running: Server, tmp_path: Path) -> None:
    url = f"{running.url(running.database())}&bundles={tmp_path}"
    archiving.init_archive(url, None)
    for number in range(RUNS):
        record(f"run-{number}")
    begun, busy = time.perf_counter(), resource.getrusage(resource.RUSAGE_SELF).ru_utime
    assert archiving.push(url).runs == RUNS
    wall, busy = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_SELF).ru_utime - busy
    begun = time.perf_counter()
    assert archiving.push(url).runs == 0
    again = time.perf_counter() - begun
    bytes_ = sum(path.stat().st_size for path in tmp_path.rglob("*.zip"))
    rate = RUNS * SAMPLES / wall
    print(f"\npush: {rate:.0f} samples/s, {bytes_ / RUNS / SAMPLES:.0f} bytes a sample, {busy / wall:.0%} of a core")
    print(f"the same again: {again:.3f} s")


def record(run_id: str) -> None:
    """A run of 20 000 samples with a reference, as a preflight writes it."""
    draw, t_s = np.random.default_rng(1), np.arange(SAMPLES) / 40
    with Store.open() as store:
        header = RunHeader(run_id, "2026-05-01T10:00:00Z", True, "ada", Dut("SN-9", "M3"), Reference("vector", "R7"))
        with store.begin(header) as writer:
            writer.write(SegmentOpened(0.0, Segment("all", "free")))
            for role in ("dut", "reference"):
                columns, values = tuple(f"{role[:3]}_{a}" for a in "xyz"), draw.normal(0, 3e4, (SAMPLES, 3)).round(1)
                writer.write(Block(role, role, columns, t_s, values, b"x" * 40 * SAMPLES))
            writer.write(SegmentClosed(float(t_s[-1])))
            writer.finish("finished")
