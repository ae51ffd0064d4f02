"""The live store: what is written comes back, nothing is edited, and what a kill leaves behind."""

from __future__ import annotations

import json
import shutil
import sqlite3
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from labcal.errors import InputError, InstrumentError, Stopped
from labcal.record import ChannelSpec, Dut, Reference, RunHeader, Segment
from labcal.record.stream import Block, Event, Measurement, ModeChanged, Prompt, SegmentClosed, SegmentOpened, Step
from labcal.store import Store, bundle_sha256, check_store, load_bundle

HEADER = RunHeader(
    run_id="r1",
    started_utc="2026-03-02T08:15:00Z",
    simulated=True,
    operator="bench",
    dut=Dut("SN1", "M3", "count", 6.67, 25.0),
    reference=Reference("vector", "R7", 3.0, "remote", (0.1, 0.0, 0.0)),
    channels=(ChannelSpec("temp", "degC", "temperature"), ChannelSpec("i_x", "A", "current", "coil")),
    procedure="preflight",
    parameters={"field_nT": 20000.0, "axes": ["x", "y"]},
    source_sha256="ab" * 32,
    bench="[dut]\n",
    instruments=({"name": "dut", "serial": "SN1"},),
    software="labcal 0.1.0",
)
SEGMENT = Segment("x", "rotation", "nominal", "", (1.0, 0.0, 0.0), (0.0, 0.0, 1.0), mounting="A")


def dut_block(start: float, n: int = 10) -> Block:
    t = start + np.arange(n) / 10
    return Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t, np.outer(t, [1.0, 2.0, -3.0]), b"frame;" * n)


ITEMS = (
    ModeChanged(0.0, "nominal"),
    Step(0.0, 1, 3, "zero", 60.0),
    Prompt(0.1, "mount-x", "x up?", ("yes", "no"), True, {"body_from_cage": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}),
    Event(0.2, "answer", "yes", {"by": "bench"}),
    SegmentOpened(1.0, SEGMENT),
    dut_block(1.0),
    Block("reference", "ref", ("ref_x", "ref_y", "ref_z"), 0.9 + np.arange(13) / 10, np.ones((13, 3)) * np.nan),
    Measurement(2.0, "zero", 3.5, 0.5, "nT", 10.0),
    Measurement(2.0, "drift", 3.5, 0.5, "nT"),
    SegmentClosed(2.05),
)


def same(a: object, b: object) -> bool:
    if not isinstance(a, Block) or not isinstance(b, Block):
        return a == b
    told = (a.stream, a.source, a.columns, a.raw) == (b.stream, b.source, b.columns, b.raw)
    return told and np.array_equal(a.t_s, b.t_s) and np.array_equal(a.values, b.values, equal_nan=True)


def test_every_item_comes_back_as_it_went_in() -> None:
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            for item in ITEMS:
                writer.write(item)
            writer.finish("finished")
        back = list(store.items("r1"))
        assert len(back) == len(ITEMS)
        assert all(map(same, back, ITEMS))
        assert all(map(same, store.items("r1", skip=4), ITEMS[4:]))
        assert store.header("r1") == replace(HEADER, instruments=({"name": "dut", "serial": "SN1"},))
        assert store.end_s("r1") == pytest.approx(2.1)
        (summary,) = store.runs()
        assert (summary.status, summary.dut_serial, summary.procedure) == ("finished", "SN1", "preflight")
        assert len(store.run("r1")) == 10


def test_blocks_of_a_stream_are_joined_but_never_past_another_item() -> None:
    temperature = Block("channel", "dut", ("temp",), np.array([0.3]), np.array([[20.5]]), b"T")
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            for item in (dut_block(0.0), temperature, dut_block(1.0), SegmentOpened(2.0, SEGMENT), dut_block(2.0)):
                writer.write(item)
        first, second, opened, last = store.items("r1")
        assert isinstance(first, Block)
        np.testing.assert_array_equal(first.t_s, np.concatenate([dut_block(0.0).t_s, dut_block(1.0).t_s]))
        np.testing.assert_array_equal(first.values[10:], dut_block(1.0).values)
        assert first.raw == b"frame;" * 20
        assert same(second, temperature)
        assert opened == SegmentOpened(2.0, SEGMENT)
        assert same(last, dut_block(2.0))


def test_a_block_whose_parts_disagree_is_refused() -> None:
    with Store.open() as store, store.begin(HEADER) as writer, pytest.raises(ValueError, match=r"\(2, 3\)"):
        writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.zeros(2), np.zeros((2, 2))))


def test_numbers_of_numpy_in_an_event_are_kept_as_numbers() -> None:
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            writer.write(Event(0.0, "read-back", "", {"amps": np.float32(0.5), "all": np.arange(3), "n": np.int64(2)}))
        (event,) = store.items("r1")
        assert isinstance(event, Event)
        assert event.data == {"amps": 0.5, "all": [0, 1, 2], "n": 2}


@pytest.mark.parametrize(
    ("error", "status"),
    [
        (None, "finished"),
        (Stopped(), "stopped"),
        (KeyboardInterrupt(), "stopped"),
        (InstrumentError("the supply is silent"), "failed: the supply is silent"),
        (ZeroDivisionError(), "failed: ZeroDivisionError"),
    ],
)
def test_the_status_says_how_the_run_was_left(error: BaseException | None, status: str) -> None:
    def record() -> None:
        with store.begin(HEADER) as writer:
            writer.write(dut_block(0.0))
            assert store.status("r1") == "running"
            if error is not None:
                raise error

    with Store.open() as store:
        if error is None:
            record()
        else:
            with pytest.raises(type(error)):
                record()
        assert store.status("r1") == status
        assert len(list(store.items("r1"))) == 1


def test_another_program_reads_committed_rows_while_they_are_written(eventually) -> None:
    with Store.open() as store, store.begin(HEADER) as writer:
        writer.write(dut_block(0.0))
        eventually(lambda: len(list(store.items("r1"))) == 1)
        program = (
            "from labcal.store import Store\n"
            "with Store.open() as store: print(store.status('r1'), len(list(store.items('r1'))))"
        )
        seen = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout
        assert seen.split() == ["running", "1"]
        writer.write(dut_block(1.0))


def test_nothing_recorded_can_be_edited(home_of_its_own: Path) -> None:
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            writer.write(dut_block(0.0))
        connection = sqlite3.connect(store.path)
        for table in ("run", "status", "item"):
            column = connection.execute(f"SELECT name FROM pragma_table_info('{table}') LIMIT 1 OFFSET 1").fetchone()[0]
            for change in (f"UPDATE {table} SET {column} = 'x'", f"DELETE FROM {table}"):
                with pytest.raises(sqlite3.IntegrityError, match="never edited"):
                    connection.execute(change)
        connection.close()


def test_a_run_id_is_given_once_and_a_dut_has_a_serial() -> None:
    with Store.open() as store:
        with store.begin(HEADER):
            with pytest.raises(InputError, match="r1 already"):
                store.begin(HEADER)
            assert store.status("r1") == "running"
        with pytest.raises(InputError, match="serial"):
            store.begin(replace(HEADER, run_id="r2", dut=Dut("")))
        with pytest.raises(InputError, match="no run called nothing"):
            store.run("nothing")


def test_an_imported_bundle_keeps_its_bytes(bundle, tmp_path: Path) -> None:
    path = bundle()
    with Store.open() as store:
        assert store.add_bundle(path) == "r1"
        assert store.add_bundle(path) == "r1"
        assert store.bundle("r1").sha256 == load_bundle(path).sha256
        assert [summary.status for summary in store.runs()] == ["imported"]
        assert len(store.run("r1")) == 3
        with pytest.raises(InputError, match="another run called r1"):
            store.add_bundle(bundle(lambda header: header.update(operator="else")))


def test_the_timeline_is_plain_to_other_programs() -> None:
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            for item in ITEMS:
                writer.write(item)
        with sqlite3.connect(store.path) as connection:
            kinds = [kind for (kind,) in connection.execute("SELECT kind FROM item ORDER BY number")]
            query = "SELECT content, stamps, samples FROM item WHERE kind = 'block' LIMIT 1"
            content, stamps, samples = connection.execute(query).fetchone()
        connection.close()
    assert kinds[:3] == ["mode-changed", "step", "prompt"]
    assert json.loads(content)["columns"] == ["dut_x", "dut_y", "dut_z"]
    np.testing.assert_array_equal(np.frombuffer(samples, "<f8").reshape(-1, 3)[:, 0], np.frombuffer(stamps, "<f8"))


def test_the_golden_store_of_version_1_still_reads(tmp_path: Path) -> None:
    golden = Path(__file__).parents[1] / "golden"
    shutil.copy(golden / "store-1.sqlite", tmp_path)
    with Store.open(tmp_path / "store-1.sqlite") as store:
        assert [(run.run_id, run.status) for run in store.runs()] == [
            ("r1", "finished"),
            ("20260302-081500-SN1", "imported"),
        ]
        assert all(map(same, store.items("r1"), ITEMS))
        assert store.header("r1") == HEADER
        assert store.bundle("20260302-081500-SN1").sha256 == load_bundle(golden / "bundle-1").sha256
        assert check_store(store.path).fault == ""


def test_the_bundle_of_a_recorded_run_reads_back_as_the_run() -> None:
    with Store.open() as store:
        with store.begin(HEADER) as writer:
            for item in ITEMS:
                writer.write(item)
            writer.write(Block("channel", "dut", ("temp",), np.arange(0.0, 4.0), np.full((4, 1), 20.5)))
        run, bundle = store.run("r1"), store.bundle("r1")
    again = bundle.run()
    assert (again.segments, again.dut, again.reference) == (run.segments, run.dut, run.reference)
    np.testing.assert_array_equal(again.t_s, run.t_s)
    np.testing.assert_array_equal(again.reading, run.reading)
    np.testing.assert_array_equal(again.channel("temp").values, [20.5] * 10)
    assert bundle_sha256(run) == bundle.sha256 == bundle_sha256(again)


def test_a_wrong_serial_is_corrected_by_an_event_and_the_first_one_stays_in_the_record(tmp_path: Path) -> None:
    with Store.open(tmp_path / "s.sqlite") as store:
        with store.begin(HEADER) as writer:
            for item in ITEMS:
                writer.write(item)
            with pytest.raises(InputError, match="being recorded"):
                store.correct_serial("r1", "SN2", "J. Doe")
        before = store.bundle("r1").sha256
        store.correct_serial("r1", " SN2 ", "J. Doe")
        store.correct_serial("r1", "SN3", "A. Smith")
        assert store.header("r1").dut == replace(HEADER.dut, serial="SN3")
        assert (store.runs()[0].dut_serial, store.run("r1").dut.serial) == ("SN3", "SN3")
        assert store.bundle("r1").sha256 != before
        said = [item for item in store.items("r1") if isinstance(item, Event) and item.kind == "serial-corrected"]
        assert [(e.data["from"], e.data["to"], e.data["by"]) for e in said] == [
            ("SN1", "SN2", "J. Doe"),
            ("SN2", "SN3", "A. Smith"),
        ]
        with pytest.raises(InputError, match="serial number"):
            store.correct_serial("r1", "  ", "J. Doe")
