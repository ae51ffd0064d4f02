"""What comes from outside and is too large, too deep or no file: refused at once, in one line."""

from __future__ import annotations

import json
import os
import sqlite3
import zipfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path, PureWindowsPath
from typing import Any

import pytest

from labcal.errors import InputError
from labcal.record import Dut, Reference, RunHeader
from labcal.record.run_id import as_file_name, checked_run_id
from labcal.store import Store, read_bundle
from labcal.store.limits import MOST_COLUMNS, MOST_SEGMENTS

HEAD = "t_s,segment,dut_x,dut_y,dut_z"
ROWS = f"{HEAD}\n0,a,1,2,3\n1,a,1,2,3\n"


def header(**changes: Any) -> str:
    said: dict[str, Any] = {
        "format": "labcal-run/1",
        "run_id": "r1",
        "started_utc": "2026-03-02T08:15:00Z",
        "simulated": True,
        "dut": {"serial": "S", "unit": "nT", "nominal_nT_per_unit": 1.0},
        "reference": {"kind": "none"},
        "segments": [{"id": "a", "kind": "static"}],
    }
    return json.dumps(said | changes)


def folder(path: Path, run_json: str = "", samples: str = ROWS) -> Path:
    path.mkdir()
    (path / "run.json").write_text(run_json or header())
    (path / "samples.csv").write_text(samples)
    return path


def columns(count: int) -> str:
    return f"{HEAD},{','.join(f'c{n}' for n in range(count))}\n0,a,1,2,3{',1' * count}\n"


def static(count: int) -> list[dict[str, str]]:
    return [{"id": f"s{n}", "kind": "static"} for n in range(count)]


@pytest.mark.parametrize(
    ("run_json", "samples", "says"),
    [
        ("", columns(MOST_COLUMNS), "columns are more than"),
        ("", columns(1_000_000), "a line is longer than"),
        (header(segments=static(MOST_SEGMENTS + 1)), ROWS, "segments are more than"),
        (header(channels={f"c{n}": {} for n in range(MOST_COLUMNS + 1)}), ROWS, "channels are more than"),
        (header(segments=[{"id": "a", f"k{n}": 1} for n in range(9_000)]), ROWS, "different keys"),
        ("[" * 100_000 + "]" * 100_000, ROWS, "nested too deeply"),
        ("[" * 600_000, ROWS, "objects or"),
        ("[" + "1," * 3_000_000 + "1]", ROWS, "values"),
        ('{"a": ' + "1" * 5_000 + "}", ROWS, "more than 400 digits"),
        ("", HEAD + "\n" * 50_000_000, "million cells"),
        (header(reference={"kind": "scalar", "noise_nT": 1e308}), ROWS, "less than or equal to 1000000000"),
        (header(reference={"kind": "scalar"}), f"{HEAD},ref_f\n0,a,1,2,3,1e10\n", "at most 1e\\+09 nT"),
    ],
    ids=["columns", "line", "segments", "channels", "keys", "deep", "lists", "values", "digits", "rows", "nT", "field"],
)  # fmt: skip
def test_what_is_too_much_is_refused_in_one_line(tmp_path: Path, run_json: str, samples: str, says: str) -> None:
    with pytest.raises(InputError, match=says) as caught:
        read_bundle(folder(tmp_path / "b", run_json, samples))
    assert len(str(caught.value)) < 600
    assert "\n" not in str(caught.value)


def test_as_many_segments_as_a_day_has_are_read(tmp_path: Path) -> None:
    run = read_bundle(folder(tmp_path / "b", header(segments=[{"id": "a", "kind": "static"}, *static(2_000)])))
    assert (len(run), len(run.segments)) == (2, 2_001)


def zipped(path: Path, compression: int, samples: bytes, more: int = 0) -> Path:
    with zipfile.ZipFile(path, "w", compression) as archive:
        archive.writestr("run.json", header())
        archive.writestr("samples.csv", samples)
        for number in range(more):
            archive.writestr(f"x/{number}", b"")
    return path


@pytest.mark.parametrize(
    ("make", "says"),
    [
        (lambda path: zipped(path, zipfile.ZIP_DEFLATED, HEAD.encode() + b"\n" * (64 << 20)), "would grow from"),
        (lambda path: zipped(path, zipfile.ZIP_STORED, ROWS.encode(), 1_500), "1502 files"),
        (lambda path: zipped(path, zipfile.ZIP_STORED, ROWS.encode(), 30_000), "lists more files"),
        (lambda path: zipped(path, zipfile.ZIP_BZIP2, ROWS.encode()), "unusual way"),
    ],
    ids=["newlines", "files", "directory", "method"],
)
def test_zips_that_swell_are_refused(tmp_path: Path, make: Callable[[Path], Path], says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_bundle(make(tmp_path / "b.zip"))


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="has no pipes of this kind")
def test_pipes_and_links_that_lead_away_are_refused(tmp_path: Path) -> None:
    bundle, elsewhere = folder(tmp_path / "b"), tmp_path / "elsewhere.csv"
    (bundle / "samples.csv").rename(elsewhere)
    os.mkfifo(bundle / "samples.csv")
    with pytest.raises(InputError, match="no plain file"):
        read_bundle(bundle)
    (bundle / "samples.csv").unlink()
    (bundle / "samples.csv").symlink_to(elsewhere)
    with pytest.raises(InputError, match="leads out of the bundle"):
        read_bundle(bundle)


@pytest.mark.parametrize(
    "name", ["", "..", ".hidden", "--help", "a b", "a/b", "r\u200b1", "r\u0430", "r\x1b[2J", "r\n", "r" * 129, "=cmd|x"]
)
def test_run_ids_that_a_shell_or_an_eye_misreads_are_refused(tmp_path: Path, name: str) -> None:
    with pytest.raises(ValueError, match="a run id is of letters"):
        checked_run_id(name)
    with pytest.raises(InputError, match="column run_id"):
        read_bundle(folder(tmp_path / "b", header(run_id=name)))
    with Store.open() as store, pytest.raises(InputError, match="a run id is of letters"):
        store.begin(RunHeader(name, "2026-03-02T08:15:00Z", True, "", Dut("S"), Reference("none")))
    assert all(letter.isascii() and letter.isprintable() and letter not in "/\\ " for letter in as_file_name(name))
    assert as_file_name(name) not in (".", "..")


@pytest.mark.parametrize("name", ["CON", "con.", "nul.txt", "aux.tar.gz", "Com1", "lpt9.x.", "a.", "prn.."])
def test_a_run_id_is_a_file_on_windows_too(name: str) -> None:
    with pytest.raises(ValueError, match="on Windows"):
        checked_run_id(name)
    assert not PureWindowsPath(as_file_name(name)).is_reserved()
    assert not as_file_name(name).endswith(".")


@pytest.mark.parametrize(
    "name", ["r1", "20261121T070000-3f9c", "20260302-081500-SN1", "a+b", "console", "com10", "a.con", "r" * 128]
)
def test_run_ids_that_are_words_stand_as_they_are(name: str) -> None:
    assert checked_run_id(name) == as_file_name(name) == name


def test_a_store_with_an_odd_run_id_still_lists_and_reads_it(tmp_path: Path) -> None:
    with Store.open() as store, closing(sqlite3.connect(store.path)) as older:
        run_json = header(run_id="old run \u00fc")
        insert = older.execute("INSERT INTO run (run_id, header) VALUES (?, ?)", ("old run \u00fc", run_json))
        older.execute("INSERT INTO status VALUES (?, 'imported', '')", (insert.lastrowid,))
        kept = (insert.lastrowid, run_json.encode(), ROWS.encode())
        older.execute("INSERT INTO bundle (run, run_json, samples_csv) VALUES (?, ?, ?)", kept)
        older.commit()
        assert [run.run_id for run in store.runs()] == ["old run \u00fc"]
        assert len(store.run("old run \u00fc")) == 2


def test_a_time_that_does_not_grow_ends_the_reading_where_it_stands(tmp_path: Path) -> None:
    """Three million rows of nothing were all read, in 8 s, before the first was refused."""
    (tmp_path / "run.json").write_text(header())
    (tmp_path / "samples.csv").write_bytes(f"{ROWS}1,a,1,2,3\n".encode() + b"2,a,1,2,3\n" * 600_000 + b"\xff\n")
    with pytest.raises(InputError, match=r"line 4, column t_s: found the same time as the row before"):
        read_bundle(tmp_path)
