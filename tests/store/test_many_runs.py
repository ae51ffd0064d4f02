"""A list of runs looks at no item of theirs, in stores of today and in those that were made before."""

from __future__ import annotations

import sqlite3
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block, Event, Measurement
from labcal.store import Store
from labcal.store.live import LAST_CORRECTION
from labcal.store.schema import INDEXES, IS_CORRECTION

HEADER = RunHeader("r1", "2026-03-02T08:15:00Z", True, "bench", Dut("SN1"), Reference("none"), procedure="ambient")


@pytest.fixture
def store_file(tmp_path: Path) -> Path:
    """Three runs, the serial of the second one corrected twice."""
    path = tmp_path / "store.sqlite"
    with Store.open(path) as store:
        for name in ("r1", "r2", "r3"):
            with store.begin(replace(HEADER, run_id=name)) as writer:
                t = np.arange(5.0)
                writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.ones((5, 3)), b"frames"))
                writer.write(Event(5.0, "note", 'not the event "serial-corrected" that corrects'))
                writer.write(Measurement(3.0, "closure", 1.0, 0.1, "nT"))
        store.correct_serial("r2", "SN2", "a.other")
        store.correct_serial("r2", "SN3", "a.other")
    return path


def plan(path: Path) -> str:
    with sqlite3.connect(path) as connection:
        found = connection.execute(f"EXPLAIN QUERY PLAN SELECT {LAST_CORRECTION} FROM run").fetchall()
    connection.close()
    return " ".join(row[-1] for row in found)


def test_a_list_of_runs_looks_at_corrections_alone(store_file: Path) -> None:
    assert "USING INDEX correction_of_run" in plan(store_file)
    with Store.open(store_file) as store:
        assert [run.dut_serial for run in store.runs()] == ["SN1", "SN3", "SN1"]
        assert [(run.operator, run.procedure, run.simulated) for run in store.runs()] == [
            ("bench", "ambient", True)
        ] * 3


def test_a_store_from_before_is_given_what_the_list_needs(store_file: Path) -> None:
    with sqlite3.connect(store_file) as connection:
        connection.execute("DROP INDEX correction_of_run")
    connection.close()
    assert "USING INDEX correction_of_run" not in plan(store_file)
    with Store.open(store_file) as store:
        assert [run.dut_serial for run in store.runs()] == ["SN1", "SN3", "SN1"]
    assert "USING INDEX correction_of_run" in plan(store_file)
    assert IS_CORRECTION in INDEXES


def test_a_header_that_is_damaged_is_named(store_file: Path) -> None:
    with sqlite3.connect(store_file) as connection:
        connection.execute("INSERT INTO run (run_id, header) VALUES ('r9', '{\"started_utc\": ')")
        connection.execute("INSERT INTO status SELECT number, 'finished', '' FROM run WHERE run_id = 'r9'")
    connection.close()
    with Store.open(store_file) as store, pytest.raises(InputError, match="damaged: the header of run 'r9'"):
        store.runs()


def test_items_without_blocks_or_their_frames(store_file: Path) -> None:
    with Store.open(store_file) as store:
        assert [type(item) for item in store.items("r1", but="block")] == [Event, Measurement]
        (block,) = (item for item in store.items("r1", raw=False) if isinstance(item, Block))
        assert (len(block), block.raw) == (5, b"")
        assert store.end_s("r1") == 5.0
