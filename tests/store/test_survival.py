"""What a store survives: other files, damage, locks, full disks, kills, and several programs at once."""

from __future__ import annotations

import os
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.errors import InputError, InstrumentError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block
from labcal.store import Store, check_store

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"))


def dut_block(start: float, n: int = 10) -> Block:
    t = start + np.arange(n) / 10
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, [1.0, 2.0, -3.0]), b"frame;" * n)


def test_a_file_that_is_no_store_is_named(tmp_path: Path) -> None:
    text, other = tmp_path / "text.sqlite", tmp_path / "other.sqlite"
    text.write_text("not a database, and long enough to have no header of one" * 20)
    with pytest.raises(InputError, match="damaged, or is no store"):
        Store.open(text)
    with sqlite3.connect(other) as connection:
        connection.execute("CREATE TABLE cake (slices)")
    connection.close()
    with pytest.raises(InputError, match="another program"):
        Store.open(other)
    with pytest.raises(InputError, match="cannot be opened"):
        Store.open(tmp_path)


def test_a_damaged_store_is_an_input_error(tmp_path: Path) -> None:
    path = tmp_path / "s.sqlite"
    with Store.open(path) as store:
        for number in range(20):
            with store.begin(replace(HEADER, run_id=f"r{number}")) as writer:
                writer.write(dut_block(0.0, 200))
    good = path.read_bytes()
    path.write_bytes(good[:4096] + np.random.default_rng(0).bytes(len(good) - 4096))

    def use() -> None:
        with Store.open(path) as store:
            store.runs()
            store.run("r3")

    with pytest.raises(InputError):
        use()


def test_a_header_that_no_labcal_wrote_is_a_sentence() -> None:
    with Store.open() as store, closing(sqlite3.connect(store.path)) as stranger:
        stranger.execute("INSERT INTO run (run_id, header) VALUES ('x', '{\"dut\": 1}')")
        stranger.commit()
        with pytest.raises(InputError, match="the store is damaged: the header of run 'x'"):
            store.runs()
        with pytest.raises(InputError, match="the store is damaged: a run-header"):
            store.run("x")


def test_a_locked_store_is_a_named_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.store.database.PATIENCE_S", 0.1)
    with Store.open() as store:
        other = sqlite3.connect(store.path, isolation_level=None)
        other.execute("BEGIN EXCLUSIVE")
        with pytest.raises(InstrumentError) as caught:
            store.begin(HEADER)
        assert caught.value.fault == "store locked"
        other.close()


def test_a_full_disk_is_a_named_fault_and_loses_nothing_committed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.store.writer.PATIENCE_S", 0.1)
    with Store.open() as store:
        writer = store.begin(HEADER)
        writer.write(dut_block(0.0))
        writer.commit()
        pages = store._connection.execute("PRAGMA page_count").fetchone()[0]
        writer._connection.execute(f"PRAGMA max_page_count = {pages + 8}")

        def fill() -> None:
            for start in range(1, 1000):
                writer.write(dut_block(float(start), 1000))
                writer.commit()

        with pytest.raises(InstrumentError) as caught:
            fill()
        assert caught.value.fault == "disk full"
        assert len(list(store.items("r1"))) >= 1
        with pytest.raises(InstrumentError):
            writer.finish("failed: disk full")
        assert store.status("r1") == "interrupted"
        assert check_store(store.path).fault == ""


def test_a_fault_of_the_background_commit_reaches_the_next_write(eventually, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.store.writer.PATIENCE_S", 0.1)
    with Store.open() as store:
        writer = store.begin(HEADER)
        writer._connection.execute("PRAGMA max_page_count = 1")
        writer.write(dut_block(0.0, 5000))
        eventually(lambda: writer._fault is not None)
        with pytest.raises(InstrumentError, match="disk"):
            writer.write(dut_block(1.0))
        with pytest.raises(InstrumentError):
            writer.finish("failed: disk")


RECORDER = """
import sys, itertools, numpy as np
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block
from labcal.store import Store
header = RunHeader(sys.argv[1], "2026-03-02T08:15:00Z", True, "", Dut("SN1"), Reference("none"))
writer = Store.open().begin(header)
for number in itertools.count():
    t = number + np.arange(10) / 10
    writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, [1, 2, 3])))
    if number % 50 == 49:
        writer.commit()
        print(number + 1, flush=True)
"""


@pytest.mark.skipif(os.name != "posix", reason="needs SIGKILL, which Windows lacks")
@pytest.mark.parametrize("kills", [3, pytest.param(60, marks=pytest.mark.slow)])
def test_kill_9_loses_no_committed_row_and_shows_as_interrupted(kills: int) -> None:
    rng = np.random.default_rng()
    for number in range(kills):
        run_id = f"k{number}"
        with subprocess.Popen([sys.executable, "-c", RECORDER, run_id], stdout=subprocess.PIPE, text=True) as recorder:
            assert recorder.stdout is not None
            committed = int(recorder.stdout.readline())
            with Store.open() as store:
                assert store.status(run_id) == "running"
            time.sleep(rng.uniform(0, 0.3))
            recorder.send_signal(signal.SIGKILL)
            said = [int(line) for line in recorder.stdout.read().splitlines() if line]
        with Store.open() as store:
            assert store.status(run_id) == "interrupted"
            blocks = list(store.items(run_id))
            t = np.concatenate([block.t_s for block in blocks if isinstance(block, Block)])
            values = np.concatenate([block.values for block in blocks if isinstance(block, Block)])
            assert len(t) >= 10 * max([committed, *said])
            np.testing.assert_allclose(t, np.arange(len(t)) / 10, atol=1e-9)
            np.testing.assert_array_equal(values, np.outer(t, [1, 2, 3]))
            assert check_store(store.path).fault == ""


def recorder_that(goes_on: str) -> None:
    """A process that begins run r1 as `writer`, goes on so, and is waited for."""
    program = RECORDER.split("writer =")[0] + "writer = Store.open().begin(header)\n" + goes_on
    subprocess.run([sys.executable, "-W", "ignore", "-c", program, "r1"], check=False)


def test_an_interrupted_run_can_be_resumed_a_finished_one_cannot() -> None:
    recorder_that(
        "writer.write(Block('dut', 'dut', ('dut_x', 'dut_y', 'dut_z'), np.array([1.0]), np.zeros((1, 3))))\n"
        "writer.commit()\n"
        "import os; os._exit(9)"
    )
    with Store.open() as store:
        assert store.status("r1") == "interrupted"
        with store.resume("r1") as writer:
            assert store.status("r1") == "running"
            writer.write(dut_block(store.end_s("r1") + 1))
        assert store.status("r1") == "finished"
        assert len(list(store.items("r1"))) == 2
        with pytest.raises(InputError, match="it is finished"):
            store.resume("r1")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="needs fork, which Windows lacks")
def test_a_forked_child_that_outlives_the_writer_does_not_keep_its_run_alive() -> None:
    recorder_that(
        "import os, time\n"
        "born, say = os.pipe()\n"
        "if os.fork() == 0: os.write(say, b'!'); time.sleep(5); os._exit(0)\n"
        "os.read(born, 1)\n"
        "os._exit(9)"
    )
    with Store.open() as store:
        assert store.status("r1") == "interrupted"


def test_a_thousand_samples_a_second_are_kept_up_with() -> None:
    with Store.open() as store:
        start = time.process_time()
        with store.begin(HEADER) as writer:
            for number in range(1000):  # ten seconds of 1 kHz in blocks of ten
                writer.write(dut_block(float(number), 10))
        assert time.process_time() - start < 5  # of its own, however busy the machine is
        assert sum(len(item) for item in store.items("r1") if isinstance(item, Block)) == 10_000


def test_two_programs_may_make_the_store_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.store.database.PATIENCE_S", 60.0)
    faults = []

    def make() -> None:
        try:
            Store.open(tmp_path / "new" / "s.sqlite").close()
        except Exception as error:
            faults.append(error)

    threads = [threading.Thread(target=make) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not faults
