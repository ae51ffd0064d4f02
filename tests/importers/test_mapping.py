"""The mapping file: strict, and every fault told with its line and key."""

from __future__ import annotations

from pathlib import Path

import pytest
from foreign_files import MAPPING, mapping

from labcal.errors import InputError
from labcal.importers import read_mapping

WRONG = {  # change, more at the end, line, words
    "a key nobody knows": (('unit = "nT"\n\n[ref', 'units = "nT"\n\n[ref'), "", 13, "reading.unit"),
    "a unit nobody knows": (
        ('columns = ["mx", "my", "mz"]\nunit = "nT"', 'columns = ["mx", "my", "mz"]\nunit = "Oe"'),
        "",
        13,
        "reading.unit",
    ),
    "two columns of three": (('["mx", "my", "mz"]', '["mx", "my"]'), "", 12, "reading.columns"),
    "an axis twice": (('unit = "nT"\n\n[ref', 'unit = "nT"\naxes = ["x", "x", "z"]\n\n[ref'), "", 14, "once"),
    "no frame": (('frame = "body"\n', ""), "", 15, "frame"),
    "a channel without its unit": (("", ""), '[channels.i]\ncolumn = "i"\n', 20, "channels.i.unit"),
    "a segment's kind": (
        ("", ""),
        '[[segments]]\nid = "a"\n[[segments]]\nid = "b"\nkind = "spin"\n',
        24,
        "segments.1.kind",
    ),
    "a segment that ends before it begins": (
        ("", ""),
        '[[segments]]\nid = "a"\nstart_s = 9.0\nend_s = 3.0\n',
        20,
        "ends at 3 s",
    ),
    "two segments of a name": (("", ""), '[[segments]]\nid = "a"\n[[segments]]\nid = "a"\n', None, "same id"),
    "counts without their size": (('unit = "nT"\n\n[ref', 'unit = "count"\n\n[ref'), "", None, "nominal_nT_per_count"),
    "an attitude of a body's reference": (
        ("", ""),
        '[attitude]\ncolumns = ["a", "b", "c", "d"]\norder = "wxyz"\nmaps = "cage-to-body"\n',
        None,
        "already",
    ),
    "a rate beside a column": (('unit = "s"', 'unit = "s"\nrate_Hz = 10.0'), "", 7, "not both"),
    "no clock": (('column = "t"\nunit = "s"\n', ""), "", 7, "needs a column, or rate_Hz"),
    "a column without its unit": (('column = "t"\nunit = "s"\n', 'column = "t"\n'), "", 7, "needs a unit"),
    "a unit without its column": (('column = "t"\nunit = "s"\n', 'rate_Hz = 5.0\nunit = "s"\n'), "", 7, "needs a unit"),
    "a rate of nothing": (('column = "t"\nunit = "s"\n', "rate_Hz = 0.0\n"), "", 8, "time.rate_Hz"),
    "no number": (("", ""), '[[segments]]\nid = "a"\nstart_s = nan\n', 22, "start_s"),
    "another format": (("labcal-mapping/1", "labcal-mapping/9"), "", 1, "format"),
}


def test_a_mapping_that_is_right_is_read(tmp_path: Path) -> None:
    assert read_mapping(mapping(tmp_path)).reading.columns == ("mx", "my", "mz")


@pytest.mark.parametrize("case", WRONG)
def test_what_is_wrong_is_told_with_line_and_key(case: str, tmp_path: Path) -> None:
    change, more, line, word = WRONG[case]
    with pytest.raises(InputError) as caught:
        read_mapping(mapping(tmp_path, *([change] if change[0] else []), more=more))
    assert caught.value.line == line
    assert word in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1


@pytest.mark.parametrize("text", ["", "x = ", "a" * 300_000, "[time]\n" + "a." * 200 + "b = 1\n", "\0", MAPPING * 2])
def test_what_is_no_mapping_is_refused(text: str, tmp_path: Path) -> None:
    (tmp_path / "map.toml").write_text(text)
    with pytest.raises(InputError, match=r"map\.toml"):
        read_mapping(tmp_path / "map.toml")
