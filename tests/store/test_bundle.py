"""Bundles: what a good one gives, and the sentence that each fault gets."""

from __future__ import annotations

import hashlib
import os
import re
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from labcal.errors import InputError
from labcal.record import offers
from labcal.store import Bundle, bundle_of, bundle_sha256, load_bundle, read_bundle, write_bundle
from labcal.store.run_json import FIXED_COLUMNS, ChannelPart, DutPart, ReferencePart, RunJson, SegmentPart

GOLDEN = Path(__file__).parents[1] / "golden" / "bundle-1"


def change_of(path: str, value: Any):
    """A function that sets the key at the dotted `path` of a header to `value` (... takes it away)."""
    *way, last = [int(part) if part.isdigit() else part for part in path.split(".")]

    def change(header: Any) -> None:
        for part in way:
            header = header[part]
        if value is ...:
            del header[last]
        else:
            header[last] = value

    return change


def cell_of(rows: str, line: int, column: str, text: str) -> str:
    lines = rows.splitlines()
    cells = lines[line - 1].split(",")
    cells[lines[0].split(",").index(column)] = text
    lines[line - 1] = ",".join(cells)
    return "\n".join(lines) + "\n"


def test_the_bundle_that_the_page_shows_is_read_and_offers_vectors(tmp_path: Path) -> None:
    page = (Path(__file__).parents[2] / "docs" / "record.md").read_text(encoding="utf-8")
    shown = re.findall(r"```json\n(.*?)```\n\n```\n(t_s,.*?)```", page, re.DOTALL)
    for name, text in zip(("run.json", "samples.csv"), *shown, strict=True):
        (tmp_path / name).write_text(text, encoding="utf-8")
    run = read_bundle(tmp_path)
    assert (len(run), offers(run, run.segments[0]), run.channels[0].role) == (2, "vector", "dut")


def test_the_page_names_every_key_that_a_segment_a_reference_and_a_column_may_have() -> None:
    page = (Path(__file__).parents[2] / "docs" / "record.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+)`|`(\w+)…`", page.partition("### To write one yourself")[2]))
    known = {word for pair in named for word in pair}
    keys = {key for part in (SegmentPart, ReferencePart, DutPart, ChannelPart, RunJson) for key in part.model_fields}
    assert {*keys, *FIXED_COLUMNS} - known - {f"u_{name}" for name in known} == set()  # "each with `u_…`"


def test_a_good_bundle_is_read_as_written(bundle) -> None:
    run = read_bundle(bundle())
    assert (run.run_id, run.dut.serial, run.dut.noise_nT, run.reference.kind) == ("r1", "SN1", None, "vector")
    np.testing.assert_array_equal(run.t_s, [0.1, 0.2, 0.3])
    np.testing.assert_array_equal(run.reading, [[1, 2, 3.25], [-1, np.nan, 3.25], [1e-3, 2, 3.25]])
    np.testing.assert_array_equal(run.angle_deg, [0, 359.5, np.nan])
    np.testing.assert_array_equal(run.channel("i").values, [0.128, np.nan, -0.128])
    assert list(run.mode) == ["nominal", "full", ""]
    assert [run.segments[i].id for i in run.segment_index] == ["x", "x", "still"]
    assert run.segments[0].axis_body == (1.0, 0.0, 0.0)


@pytest.mark.parametrize("rows", ["crlf", "bom", "quoted"])
def test_line_ends_byte_order_marks_and_quotes_are_no_fault(bundle, rows: str, sample_rows: str) -> None:
    written = {
        "crlf": sample_rows.replace("\n", "\r\n").encode(),
        "bom": b"\xef\xbb\xbf" + sample_rows.encode(),
        "quoted": sample_rows.replace("0.3,still", '"0.3","still"').encode(),
    }
    assert bundle_of(read_bundle(bundle(rows=written[rows]))).sha256 == bundle_of(read_bundle(bundle())).sha256


@pytest.mark.parametrize(
    ("quantity", "written", "read"),
    [("temperature", "°C", "degC"), ("humidity", "percent", "%"), ("count", "counts", "count"), ("other", "C", "C")],
)
def test_a_unit_may_be_spelt_in_another_way(bundle, quantity: str, written: str, read: str) -> None:
    def change(header: Any) -> None:
        header["channels"]["i"] = {"unit": written, "quantity": quantity}

    assert read_bundle(bundle(change)).channel("i").unit == read


@pytest.mark.parametrize(
    ("path", "default"),
    [
        ("operator", ""),
        ("dut.model", ""),
        ("reference.serial", ""),
        ("segments.0.note", ""),
        ("segments.0.reference_frame", "cage"),
        ("channels.i.role", "dut"),
    ],
)
def test_null_is_no_statement(bundle, path: str, default: str) -> None:
    said, null = (bundle_of(read_bundle(bundle(change_of(path, value)))) for value in (default, None))
    assert null.run_json == said.run_json


@pytest.mark.parametrize("absent", ["axis_cage", "axis_body"])
def test_the_attitude_carries_one_axis_from_the_other(bundle, absent: str) -> None:
    axes = {"axis_body": [1.0, 0.0, 0.0], "axis_cage": [0.0, 0.0, 1.0]}
    stated = {name: axis for name, axis in axes.items() if name != absent}

    def change(header: Any) -> None:
        attitude = [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
        header["segments"][0] = {"id": "x", "kind": "rotation", "body_from_cage": attitude, **stated}

    assert list(getattr(read_bundle(bundle(change)).segments[0], absent)) == axes[absent]


@pytest.mark.parametrize("line_end", ["\n", "\r\n"])
def test_the_last_line_needs_no_line_end(bundle, line_end: str, sample_rows: str) -> None:
    whole = read_bundle(bundle(rows=sample_rows))
    bare = read_bundle(bundle(rows=sample_rows.rstrip().replace("\n", line_end).encode()))
    assert np.array_equal(bare.t_s, whole.t_s)
    assert np.array_equal(bare.reading, whole.reading, equal_nan=True)
    assert np.array_equal(bare.channels[-1].values, whole.channels[-1].values, equal_nan=True)


@pytest.mark.parametrize(
    ("encoded", "words"),
    [
        (lambda text: text.encode("utf-16"), "line 1: expected UTF-8 text, found byte 0xff"),
        (lambda text: text.replace("\n", "\r").encode(), "line 1: lines end in CR alone; expected LF or CRLF"),
        (lambda text: text.rpartition(",")[0].encode(), "line 4, column 12: expected 12 cells"),
    ],
)
def test_a_file_of_other_lines_or_letters_says_why(bundle, encoded: Any, words: str, sample_rows: str) -> None:
    with pytest.raises(InputError, match=words):
        read_bundle(bundle(rows=encoded(sample_rows)))


@pytest.mark.parametrize(
    ("line", "column", "text"),
    [
        (3, "dut_x", "nan"),
        (3, "dut_x", "NaN"),
        (3, "ref_y", "inf"),
        (3, "temp", "-Infinity"),
        (3, "temp", "1e999"),
        (3, "dut_z", "1_000"),
        (3, "dut_z", " 1"),
        (3, "dut_z", "1,5"),
        (4, "dut_z", "12.3.4"),
        (4, "dut_z", "--1"),
        (4, "dut_z", "none"),
        (4, "i", "١"),
        (4, "angle_deg", "0x10"),
        (4, "segment", "y"),
        (4, "segment", ""),
        (2, "segment", "x "),
        (4, "t_s", "0.2"),
        (4, "t_s", "0.15"),
        (3, "t_s", ""),
        (4, "mode", "m" * 101),
    ],
)
def test_a_wrong_cell_is_named_by_file_line_and_column(
    bundle, sample_rows: str, line: int, column: str, text: str
) -> None:
    with pytest.raises(InputError) as caught:
        read_bundle(bundle(rows=cell_of(sample_rows, line, column, text)))
    assert Path(caught.value.file).name == "samples.csv"
    assert caught.value.line == line
    if "," not in text:
        assert caught.value.column == column


def test_a_truncation_of_the_rows_is_refused_unless_it_leaves_every_cell(bundle, sample_rows: str) -> None:
    data, cells = sample_rows.encode(), sample_rows.partition("\n")[0].count(",")
    for length in range(len(data)):
        left = data[:length].decode()
        rows = left.splitlines()[1:]
        if left.endswith("\n") and rows:
            assert len(read_bundle(bundle(rows=left))) == len(rows)
        elif not rows or rows[-1].count(",") < cells:
            with pytest.raises(InputError):
                read_bundle(bundle(rows=left))


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        ("", "empty"),
        ("t_s,segment\n", "dut_x"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z\n", "found none"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z,t_s\n", "twice"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z,\n", "column name"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z,hk\n0,x,1,2,3,4,5,6,7\n", "no channel"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_f\n0,x,1,2,3,4\n", "ref_x"),
        ("t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z\n0,x,1,2,3,4,5,6\n\n1,x,1,2,3,4,5,6\n", "expected 8 cells"),
        ('t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z\n0,"x\n",1,2,3,4,5,6\n', "line end"),
        ('t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z\n0,"x"y,1,2,3,4,5,6\n', "comma-separated"),
        ('"t_s\nsegment\n', "comma-separated"),
        (b"t_s,segment\n\xff\xfe\n", "UTF-8"),
    ],
)
def test_a_wrong_table_is_refused_in_words(bundle, rows: str | bytes, says: str) -> None:
    with pytest.raises(InputError, match=says):
        read_bundle(bundle(rows=rows))


@pytest.mark.parametrize(
    ("path", "value", "says"),
    [
        ("format", "labcal-run/2", "labcal-run/1"),
        ("run_id", ..., "missing"),
        ("run_id", "../up", "a run id is of letters"),
        ("run_id", " a", "begins with a letter or digit"),
        ("operator", "\x1b[2Jdemo", r"control character U\+001B"),
        ("dut.serial", "SN\u202e1", r"control character U\+202E"),
        ("segments.0.id", "a\tb", "one line"),
        ("started_utc", "yesterday", "ISO 8601"),
        ("simulated", "yes", "boolean"),
        ("dut.unit", "gauss", "'nT' or 'count'"),
        ("dut.nominal_nT_per_unit", 0, "greater than 0"),
        ("dut.nominal_nT_per_unit", "1", "valid number"),
        ("dut.noise_nT", -1, "greater than or equal to 0"),
        ("reference.kind", "tensor", "'vector', 'scalar' or 'none'"),
        ("segments", [], "at least 1"),
        ("segments.0.kind", "spin", "'rotation', 'static' or 'free'"),
        ("segments.0.id", "still", "two segments"),
        ("segments.0.axis_body", [1, 1, 0], "unit vector"),
        ("segments.0.axis_body", [1e308, 1e308, 0], "unit vector"),
        ("segments.0.axis_cage", [0, 0], "missing|at least|3 items"),
        ("segments.0.axis_bdy", [1, 0, 0], ""),
        ("segments.1.body_from_cage", [[1, 0, 0], [0, 1, 0], [0, 0, 1.01]], "rotation matrix"),
        ("segments.1.body_from_cage", [[1, 0, 0], [0, 1, 0], [0, 0, -1]], "mirrors"),
        ("segments.1.body_from_cage", [[1e200, 0, 0], [0, 1e200, 0], [0, 0, 1]], "rotation matrix"),
        ("segments.0.body_from_cage", [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "must be axis_body"),
        ("channels.i.unit", "furlong", "no unit 'furlong' of current"),
        ("channels.i.unit", "degC", "no unit 'degC' of current"),
        ("channels.i.quantity", "curent", "'temperature', 'current'"),
        ("channels.dut_x", {"unit": "A", "quantity": "current"}, "dut_x"),
        ("channels.i.roles", "coil", "is 'role' meant"),
    ],
)
def test_a_wrong_header_is_refused_with_its_line_and_key(bundle, path: str, value: Any, says: str) -> None:
    if path.endswith("axis_bdy"):  # a misspelt optional key must not turn a rotation into a scalar segment

        def change(header: Any) -> None:
            header["segments"][0]["axis_bdy"] = header["segments"][0].pop("axis_body")

        says = "is 'axis_body' meant"
    else:
        change = change_of(path, value)
    with pytest.raises(InputError, match=says) as caught:
        read_bundle(bundle(change))
    assert Path(caught.value.file).name == "run.json"
    assert caught.value.line is not None


def test_the_line_named_is_the_line_of_the_fault(bundle) -> None:
    folder = bundle(change_of("channels.i.unit", "furlong"))
    with pytest.raises(InputError) as caught:
        read_bundle(folder)
    lines = (folder / "run.json").read_text().splitlines()
    assert lines[caught.value.line - 1] == '  "i": {'
    assert caught.value.column == "channels.i"


@pytest.mark.parametrize(
    "header",
    [
        "",
        "{",
        "[]",
        "null",
        '{"format": NaN}',
        '{"format": "labcal-run/1", "format": "labcal-run/1"}',
        "[" * 100_000,
        '{"a":' * 3000 + "1" + "}" * 3000,
        "9" * 5000,
        '"\\ud800"',
        "\x00",
    ],
)
def test_what_is_not_a_header_is_refused(header: str) -> None:
    with pytest.raises(InputError):
        Bundle(header.encode(), b"").run()


def test_a_quoted_cell_over_a_line_end_is_found_on_its_own_line(bundle, sample_rows: str) -> None:
    with pytest.raises(InputError) as caught:
        read_bundle(bundle(rows=sample_rows.replace("0.2,x", '0.2,"x\n"')))
    assert caught.value.line == 3


def test_what_no_file_can_say_is_written_as_missing(bundle) -> None:
    run = read_bundle(bundle())
    reading = run.reading.copy()
    reading[0, 0] = np.inf
    assert np.isnan(bundle_of(replace(run, reading=reading)).run().reading[0, 0])


def test_unknown_keys_that_resemble_nothing_are_let_be(bundle) -> None:
    assert read_bundle(bundle(change_of("recorded_with", "another lab's tool"))).run_id == "r1"


def test_rounded_axes_are_made_exact(bundle) -> None:
    run = read_bundle(bundle(change_of("segments.0.axis_body", [0.7071, 0.7071, 0])))
    assert run.segments[0].axis_body == pytest.approx((0.5**0.5, 0.5**0.5, 0), abs=1e-12)


@pytest.mark.parametrize("name", ["out", "out.zip"])
def test_export_reads_back_the_same_and_repeats_byte_for_byte(bundle, tmp_path: Path, name: str) -> None:
    run = read_bundle(bundle())
    write_bundle(run, tmp_path / name)
    first = load_bundle(tmp_path / name)
    again = bundle_of(first.run())
    assert (again.run_json, again.samples_csv) == (first.run_json, first.samples_csv)
    if name.endswith("zip"):
        written = (tmp_path / name).read_bytes()
        os.utime(tmp_path / name, (0, 0))
        write_bundle(run, tmp_path / name)
        assert (tmp_path / name).read_bytes() == written
    assert not list(tmp_path.glob(".*"))


def test_the_golden_bundle_still_reads_and_writes_its_own_bytes() -> None:
    golden = load_bundle(GOLDEN)
    again = bundle_of(golden.run())
    assert (again.run_json, again.samples_csv) == (golden.run_json, golden.samples_csv)
    assert golden.run().reading[1, 0] == 1234.5678901234567


def test_run_sha256_is_the_digest_of_the_two_digests(bundle) -> None:
    folder = bundle()
    digests = "".join(
        hashlib.sha256((folder / name).read_bytes()).hexdigest() + "\n" for name in ("run.json", "samples.csv")
    )
    assert bundle_sha256(load_bundle(folder)) == hashlib.sha256(digests.encode()).hexdigest()


def test_what_is_no_bundle_at_all_is_refused(tmp_path: Path) -> None:
    for path in (tmp_path / "absent", tmp_path):
        with pytest.raises(InputError):
            read_bundle(path)
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(InputError):
        read_bundle(tmp_path / "pipe")


def test_a_hundred_thousand_rows_read_in_seconds(bundle, sample_rows: str) -> None:
    line = sample_rows.splitlines()[1].split(",", 1)[1]
    rows = sample_rows.splitlines()[0] + "\n" + "".join(f"{i / 100},{line}\n" for i in range(100_000))
    path = bundle(rows=rows)
    start = time.process_time()
    assert len(read_bundle(path)) == 100_000
    assert time.process_time() - start < 10  # about one, and its own, however busy the machine is


def test_all_shared_bundles_read_and_repeat(shared: Path) -> None:
    folders = [path.parent for path in shared.glob("data/**/run.json")]
    assert len(folders) >= 11
    for folder in folders:
        run = read_bundle(folder)
        again = bundle_of(run).run()
        np.testing.assert_array_equal(again.reading, run.reading)
        assert again.segments == run.segments


def test_what_an_instrument_put_into_a_header_does_not_lose_the_run(bundle) -> None:
    run = replace(read_bundle(bundle()), operator="Ada\x1b[2J")
    assert bundle_of(run).run().operator == "Ada\ufffd[2J"


def test_a_power_mode_that_acts_on_a_terminal_is_refused_with_its_line(bundle, sample_rows: str) -> None:
    header, first, second, *rest = sample_rows.splitlines()
    place = header.split(",").index("mode")
    cells = second.split(",")
    cells[place] = "\x1b[2J"
    with pytest.raises(InputError, match="control character") as caught:
        read_bundle(bundle(rows="\n".join([header, first, ",".join(cells), *rest, ""])))
    assert (caught.value.line, caught.value.column) == (3, "mode")
