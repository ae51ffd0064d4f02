"""The archive with ten years of five hundred sensors in it, and the pace of a push.

`pytest benchmarks/test_archive.py -s` prints the figures of docs/performance.md; it starts a PostgreSQL of its own.
"""

from __future__ import annotations

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
from test_queries import ASKED, processor_s  # noqa: E402

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
    runs = YEARS.sensors * YEARS.runs
    print(f"\n{YEARS.sensors} sensors, {runs} runs, {runs * SAMPLES:.0e} samples: processor time, server and asking")
    for question in ASKED:
        print(f"  {question}: {processor_s(running, url, question):.2f} s")


def test_push(running: Server, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LABCAL_HOME", str(tmp_path / "home"))
    url = f"{running.url(running.database())}&bundles={tmp_path / 'bundles'}"
    archiving.init_archive(url, None)
    for number in range(RUNS):
        record(f"run-{number}")
    begun, busy = time.perf_counter(), time.process_time()
    assert archiving.push(url).runs == RUNS
    wall, busy = time.perf_counter() - begun, time.process_time() - busy
    begun = time.process_time()
    assert archiving.push(url).runs == 0
    again = time.process_time() - begun
    bytes_ = sum(path.stat().st_size for path in tmp_path.rglob("*.zip"))
    n = RUNS * SAMPLES
    print(f"\npush: {n / busy:.0f} samples a second of a processor ({n / wall:.0f} by the clock)")
    print(f"bundles: {bytes_ / n:.0f} bytes a sample, raw lines in the chain with them")
    print(f"the same again: {again:.2f} s of a processor")


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
