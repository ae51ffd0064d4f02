"""Streams at rate over real lines, recorded to disk while a window repaints in another process.

`pytest benchmarks/test_streams.py -s -k 60` prints the figures of docs/performance.md; `-k 5` is the short form.
"""

from __future__ import annotations

import os
import socket
import sqlite3
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack, closing, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from unchained import begun

from drivers.ccsds import Ccsds
from drivers.ccsds import Settings as CcsdsSettings
from drivers.csv_line import CsvLine
from drivers.csv_line import Settings as CsvSettings
from drivers.hmr2300 import NT_PER_COUNT, Hmr2300
from drivers.hmr2300 import Settings as HmrSettings
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
from labcal.store import Store

HERE = Path(__file__).parent
STEP_S = 0.2


@contextmanager
def child(*arguments: str) -> Iterator[subprocess.Popen[str]]:
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    command = [sys.executable, *arguments]
    with subprocess.Popen(command, stdin=-1, stdout=-1, text=True, env=environment) as process:
        try:
            yield process
        finally:
            process.kill()


def free_udp_port() -> int:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


@contextmanager
def lines() -> Iterator[tuple[RealClock, list[Any]]]:
    """Clock and drivers; the instruments are in a process of their own."""
    port, clock = free_udp_port(), RealClock()
    udp = open_link(f"udp://127.0.0.1:{port}", clock)
    with child(str(HERE / "stream_sources.py"), str(port)) as sources:
        assert sources.stdout is not None
        pty, tcp = sources.stdout.readline().split()
        settings = HmrSettings(format="binary", baud=19200, rate=154)
        drivers: list[Any] = [
            Hmr2300("hmr2300", open_link(pty, clock), clock, settings),
            CsvLine("csv-line", open_link(f"tcp://127.0.0.1:{tcp}", clock), clock, CsvSettings()),
            Ccsds("ccsds", udp, clock, CcsdsSettings(framing="datagram")),
        ]
        with ExitStack() as afterwards:
            for driver in drivers:
                afterwards.callback(driver.close)
                driver.start()
            yield clock, drivers


def numbers(name: str, values: np.ndarray) -> np.ndarray:
    """The number that each sample carries."""
    if name != "hmr2300":
        return values[:, 0].astype(int)
    counts = np.round(values / NT_PER_COUNT).astype(int)
    return counts[:, 0] * 20_000 + counts[:, 1]


@pytest.mark.parametrize("chained", [True, False])
@pytest.mark.parametrize("seconds", [5, 60])
def test_no_sample_is_lost_or_comes_twice_while_a_window_repaints(seconds: int, chained: bool, tmp_path: Path) -> None:
    """With the record's hash chain, and without it beside that: what the chain costs is no sample."""
    got: dict[str, list[np.ndarray]] = {}
    with child(str(HERE / "repaint.py")) as window:
        assert window.stdout is not None
        assert window.stdout.readline() == "painting\n"
        with (
            Store.open(tmp_path / "streams.sqlite") as store,
            begun(store, "streams", chained=chained) as record,
            lines() as (clock, drivers),
        ):
            from_s, busy = clock.now(), time.process_time()
            while clock.now() < from_s + seconds:
                clock.wait_until(clock.now() + STEP_S)
                for driver in drivers:
                    for block in driver.read_until(clock.now()):
                        record.write(block)
                        got.setdefault(driver.name, []).append(block.values)
            busy, elapsed = time.process_time() - busy, clock.now() - from_s
            events = [event for driver in drivers for event in driver.events()]
        with closing(sqlite3.connect(tmp_path / "streams.sqlite")) as connection:
            assert connection.execute("SELECT count(*) > 0 FROM chain").fetchone() == (chained,)
        painted = window.poll() is None
    print(f"\n{seconds} s {'with' if chained else 'without'} the chain: busy {100 * busy / elapsed:.0f} % of the time")
    for name, blocks in got.items():
        found = numbers(name, np.vstack(blocks))
        steps = np.diff(found)
        lost, twice = int(np.sum(steps[steps > 1] - 1)), int(np.sum(steps < 1))
        print(f"{name}: {len(found)} samples, {len(found) / elapsed:.1f} a second, {lost} lost, {twice} twice")
        assert (lost, twice) == (0, 0), name
        assert len(found) > 0.97 * {"hmr2300": 154}.get(name, 1000) * seconds
    assert len(got) == 3
    assert events == []
    assert painted


def busy_share(clock: RealClock, read: Any, seconds: float) -> float:
    """CPU seconds of this process per second while `read(t)` is called in the bench's rhythm."""
    begun, busy = clock.now(), time.process_time()
    while clock.now() < begun + seconds:
        clock.wait_until(clock.now() + STEP_S)
        read(clock.now())
    return (time.process_time() - busy) / (clock.now() - begun)


def test_drivers_cost_little_above_the_bare_lines() -> None:
    with lines() as (clock, drivers):
        bare, driven = [], []
        for _round in range(4):
            bare.append(busy_share(clock, lambda t: [d._link.receive(t) for d in drivers], 2.0))
            driven.append(busy_share(clock, lambda t: [d.read_until(t) for d in drivers], 2.0))
    overhead = float(np.median(driven) - np.median(bare))
    print(f"\nbare lines {100 * np.median(bare):.1f} % of a core, with drivers {100 * np.median(driven):.1f} %")
    assert overhead < 0.10
