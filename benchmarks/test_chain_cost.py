"""What the hash chain costs while a stream of 1 kHz is written: the same minute with it and without it, in turn.

`pytest benchmarks/test_chain_cost.py -s` prints the figures of docs/performance.md.
"""

from __future__ import annotations

import time
from pathlib import Path

import numpy as np
import pytest
from unchained import begun

from labcal.record.stream import Block
from labcal.store import RunWriter, Store

RATE_HZ, READ_S, COMMIT_S = 1000, 0.05, 0.25  # a block a read, and commits as often as the writer's own
COLUMNS = ("dut_x", "dut_y", "dut_z")
LINE = b"1234.567,12345.678,-12345.678,12345.678\n"
ROUNDS = 5


def cpu_s(writer: RunWriter, seconds: int) -> float:
    """Processor time that the whole process takes to write so many seconds of the stream."""
    n = round(RATE_HZ * READ_S)
    t_s, values = np.arange(n) / RATE_HZ, np.random.default_rng(0).normal(size=(n, 3))
    busy = time.process_time()
    for number in range(round(seconds / READ_S)):
        writer.write(Block("dut", "dut", COLUMNS, t_s + number * READ_S, values, LINE * n))
        if number % round(COMMIT_S / READ_S) == 0:
            writer.commit()
    writer.commit()
    return time.process_time() - busy


@pytest.mark.parametrize("seconds", [10, 60])
def test_the_chain_takes_no_measurable_part_of_a_core_at_1_khz(seconds: int, tmp_path: Path) -> None:
    spent = {True: list[float](), False: list[float]()}
    with Store.open(tmp_path / "cost.sqlite") as store:
        for number in range(ROUNDS):
            for chained in (True, False):
                with begun(store, f"{number}-{chained}", chained=chained) as writer:
                    spent[chained].append(cpu_s(writer, seconds) / seconds)
            assert store.chain_of(f"{number}-True") is not None
    with_it, without = (1e3 * float(np.median(spent[chained])) for chained in (True, False))
    print(f"\na second of 1 kHz: {with_it:.2f} ms of a core with the chain, {without:.2f} ms without")
    assert with_it - without < 5.0  # ms a second: half a per cent of a core
