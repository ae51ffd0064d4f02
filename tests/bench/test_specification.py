"""A DUT's specification: a table of bench.toml or a file, checked before anything moves."""

from __future__ import annotations

from pathlib import Path

import pytest

from labcal.bench.config import read_config
from labcal.bench.identify import identify_all
from labcal.bench.specification import read_specification, specification_of
from labcal.errors import InputError
from labcal.record import Limit, Specification

EXAMPLE = (Path(__file__).resolve().parents[2] / "examples" / "simulated.toml").read_text(encoding="utf-8")
TABLE = """
[dut.specification]
offset = { limit = 2.0, unit = "uT" }
scale = { limit = 0.5, unit = "%" }
rule = "guard-band"
r = 0.83
"""
SHEET = 'model = "simulated fluxgate"\nrule = "simple-acceptance"\nnoise = { limit = 20, unit = "nT" }\n'


def bench(tmp_path: Path, table: str = "", named: str = "") -> Path:
    text = EXAMPLE.replace("noise_nT = 15.1\n", f"noise_nT = 15.1\n{named}\n") if named else EXAMPLE
    path = tmp_path / "bench.toml"
    path.write_text(text + table, encoding="utf-8")
    return path


def specified(path: Path) -> Specification | None:
    return specification_of(read_config(path), path)


def test_a_table_of_the_bench_file_is_read(tmp_path: Path):
    found = specified(bench(tmp_path, TABLE))
    assert found == Specification(offset=Limit(2.0, "uT"), scale=Limit(0.5, "%"), r=0.83)
    assert found.guard == 0.83
    assert list(found.limits) == ["offset", "scale"]


def test_a_bench_without_one_has_none(tmp_path: Path):
    assert specified(bench(tmp_path)) is None


def test_a_file_for_a_model_lies_beside_the_bench_file(tmp_path: Path):
    (tmp_path / "fluxgate.toml").write_text(SHEET)
    found = specified(bench(tmp_path, named='specification = "fluxgate.toml"'))
    assert found == Specification(noise=Limit(20, "nT"), rule="simple-acceptance", title="simulated fluxgate")
    assert found.guard == 0


def test_a_file_for_another_model_is_refused(tmp_path: Path):
    (tmp_path / "fluxgate.toml").write_text(SHEET.replace("simulated", "another"))
    with pytest.raises(InputError, match=r"fluxgate.toml, line 1.*'another fluxgate'.*'simulated fluxgate'"):
        specified(bench(tmp_path, named='specification = "fluxgate.toml"'))


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("offset = {", "ofset = {", "ofset"),
        ('unit = "uT"', 'unit = "deg"', "offset has no unit 'deg': expected one of nT, pT, uT, µT"),
        ("limit = 2.0", "limit = 0.0", "limit must be a number greater than 0"),
        ("limit = 2.0", "limit = nan", "offset.limit"),
        ("limit = 2.0", 'limit = "2.0"', "offset.limit"),
        ("limit = 2.0", "limt = 2.0", "offset.limt"),
        ("r = 0.83", "r = 11", "r must lie between 0 and 10"),
        ("limit = 2.0", "limit = 1e308", "at most 1e+12"),
        ("r = 0.83", "r = true", "dut.specification.r: must be"),
        ('"guard-band"', '"simple-acceptance"', "no guard band: state no r, or rule = 'guard-band' for w = 0.83 U"),
        ('"guard-band"', '"shared"', "rule"),
        ("r = 0.83", 'title = "two\\nlines"', "one printable line"),
    ],
)
def test_what_is_wrong_is_named_with_its_line_before_a_run(tmp_path: Path, old: str, new: str, says: str):
    path = bench(tmp_path, TABLE.replace(old, new))
    lines = path.read_text().splitlines()
    for asked in (specified, identify_all):  # the run's own way, and `bench check`
        with pytest.raises(InputError) as caught:
            asked(path)
        assert says in str(caught.value)
        assert caught.value.line in (1 + lines.index("[dut.specification]"), *_lines_of(lines, new))


def test_either_letter_that_looks_like_micro_is_one(tmp_path: Path):
    (tmp_path / "class-b.toml").write_text('noise = { limit = 1, unit = "\u03bcT" }\n', encoding="utf-8")
    assert read_specification(tmp_path / "class-b.toml").noise == Limit(1.0, "\u00b5T")


def _lines_of(lines: list[str], new: str) -> list[int]:
    return [number for number, line in enumerate(lines, 1) if new.split("\n")[0] in line]


def test_a_table_that_limits_nothing_is_refused(tmp_path: Path):
    with pytest.raises(InputError, match="limits nothing: state one of offset"):
        specified(bench(tmp_path, "\n[dut.specification]\nr = 1.0\n"))


def test_a_file_that_is_not_there_stops_the_run_and_not_the_way_to_zero(tmp_path: Path):
    path = bench(tmp_path, named='specification = "gone.toml"')
    assert read_config(path).guarded  # what `bench off` reads
    with pytest.raises(InputError, match=r"there is no file .*gone.toml"):
        specified(path)


def test_a_file_by_itself_is_called_by_its_name(tmp_path: Path):
    (tmp_path / "class-b.toml").write_text('residual = { limit = 1, unit = "nT" }\n')
    assert read_specification(tmp_path / "class-b.toml").title == "class-b"
