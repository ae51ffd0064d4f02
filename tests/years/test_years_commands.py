"""`labcal rr`, `intervals` and `intercompare`: what they say, their exit codes, and what they refuse."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
import pytest
from calibrations_of_years import calibrated, kept

from labcal.cli import execute as labcal
from labcal.store import save_bundle
from labcal.store.bundle import bundle_of
from labcal.testing.made_up_runs import made_up_run


@pytest.fixture
def table(tmp_path: Path) -> Path:
    """Six DUTs, three operators, three mountings, twice."""
    draw, lines = np.random.default_rng(1), ["dut,operator,mounting,value"]
    part, who, how = draw.normal(0, 10, 6), draw.normal(0, 0.2, 3), draw.normal(0, 0.3, 3)
    for i, j, k, _ in np.ndindex(6, 3, 3, 2):
        lines.append(f"S{i},op{j},m{k},{part[i] + who[j] + how[k] + draw.normal(0, 0.2):.6f}")
    path = tmp_path / "study.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def asked(words: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> dict[str, object]:
    assert labcal([*words, "--json", "-"]) == code
    found: dict[str, object] = json.loads(capsys.readouterr().out)
    return found


def test_a_gage_that_is_fine_and_one_that_is_not(table: Path, capsys: pytest.CaptureFixture[str]) -> None:
    found = asked(["rr", "--table", str(table), "--tolerance", "100"], capsys)
    assert found["levels"] == {"DUT": 6, "operator": 3, "mounting": 3}
    assert found["percent_rr"] < 10  # type: ignore[operator]
    assert found["percent_tolerance"] < 5  # type: ignore[operator]
    picture = table.with_name("rr.png")
    assert labcal(["rr", "--table", str(table), "--out", str(picture)]) == 0
    assert picture.read_bytes().startswith(b"\x89PNG")
    capsys.readouterr()
    near = table.with_name("near.csv")
    rows = [line.split(",") for line in table.read_text().splitlines()]
    near.write_text("\n".join(",".join([*row[:3], row[3] if i == 0 else str(float(row[3]) / 1e9 + (i * 7 % 13))])
                              for i, row in enumerate(rows)))  # fmt: skip
    assert labcal(["rr", "--table", str(near)]) == 1
    assert "of the total variation" in capsys.readouterr().out


def test_a_cell_that_is_empty_is_named(table: Path, capsys: pytest.CaptureFixture[str]) -> None:
    table.write_text("".join(f"{x}\n" for x in table.read_text().splitlines() if not x.startswith("S2,op1,m0")))
    assert labcal(["rr", "--table", str(table)]) == 2
    assert "nothing is there of DUT S2; operator op1; mounting m0" in capsys.readouterr().err


def test_a_study_of_runs_takes_their_operators_and_serials(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from dataclasses import replace

    runs = []
    for i, (serial, who) in enumerate([(s, w) for s in ("A", "B") for w in ("ada", "bob") for _ in range(2)]):
        k = np.array([100.0 if serial == "A" else 400.0, 0.0, 0.0])
        run = made_up_run(rows=12, noise_nT=1.0, seed=i, k=k).run
        named = replace(run, run_id=f"r{i}", operator=who, dut=replace(run.dut, serial=serial))
        save_bundle(bundle_of(named), tmp_path / f"r{i}.zip")
        runs.append(str(tmp_path / f"r{i}.zip"))
    found = asked(["rr", *runs, "--quantity", "offset x"], capsys)
    assert found["levels"] == {"DUT": 2, "operator": 2}
    assert found["unit"] == "nT"
    assert found["simulated"] is run.simulated
    assert found["percent_rr"] < 5  # type: ignore[operator]
    assert labcal(["rr", *runs, "--quantity", "offset q"]) == 2
    assert labcal(["rr", runs[0], runs[0]]) == 2


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ("dut,operator\nA,b\n", "no column 'value'"),
        ("dut,operator,value\nA,b,x\n", "line 2, column value: 'x' is no number"),
        ("dut,operator,value\nA,b,nan\n", "is no number"),
        ("dut,operator,value\n", "no rows"),
        ("", "no column"),
        (f"dut,value\nA,{'1' * 140_000}\n", "is no CSV"),
        ("dut,operator,value\nA,b,1\nA,c,2\n", "two DUTs"),
        ("dut,operator,value\nA,b,1\nB,b,2\n", "nothing was repeated"),
        ("dut,operator,value\nA,b,1\nB,b,1\nA,b,1\nB,b,1\n", "all values are the same"),
        ("dut,value\nA,1e308\nA,-1e308\nB,1\nB,2\n", "a value is beyond 1e+100"),
        ("dut,value,Value\nA,1,2\nB,1,2\n", "two columns 'value'"),
        ("dut,value\nA,1.5\nA,1,6\n", "line 3: has more cells than the heads"),
    ],
)
def test_a_table_that_is_none_is_refused(
    content: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "t.csv"
    path.write_text(content)
    assert labcal(["rr", "--table", str(path)]) == 2
    assert said in capsys.readouterr().err


def test_a_drift_is_seen_and_each_method_says_when_to_come_back(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """3 nT a year on x, nothing on y; 12 nT are permitted."""
    draw = np.random.default_rng(2)
    made = [calibrated(day=365.25 * i, offset_nT=(3.0 * i + draw.normal(0, 1), draw.normal(0, 1), 0.0))
            for i in range(8)]  # fmt: skip
    kept(tmp_path, *made)
    found = asked(["intervals", "EM-1", str(tmp_path), "--permitted", "offset=12 nT"], capsys)
    figures = {one["quantity"]: one for one in found["figures"]}  # type: ignore[attr-defined]
    low, high = figures["offset x"]["drift"]["interval"]
    assert low < 3.0 < high
    assert low > 0
    between = figures["offset y"]["drift"]["interval"]
    assert between[0] < 0 < between[1]
    methods = {one["method"]: one["days"] for one in figures["offset x"]["proposals"]}
    assert set(methods) == {"staircase", "control chart", "in-use time", "drift"}
    assert 0 < methods["drift"] < methods["control chart"] <= 1826
    page = tmp_path / "page.html"
    assert labcal(["intervals", "EM-1", str(tmp_path), "--permitted", "offset x=1 nT", "--out", str(page)]) == 1
    assert "A drift is seen of offset x" in page.read_text()
    assert "In-service checking (ILAC-G24" in page.read_text()


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["EM-2"], "no calibration of EM-2"),
        (["EM-1", "--permitted", "offset=20"], "'offset=20 nT'"),
        (["EM-1", "--permitted", "offset=1..2 nT"], "'offset=20 nT'"),
        (["EM-1", "--permitted", "ofset=20 nT"], "none of the figures"),
        (["EM-1", "--permitted", "offset=20 ppm"], "is in nT, not in ppm"),
        (["EM-1", "nowhere.json"], "nowhere.json"),
        (["EM-1", "--out", "x.doc"], "a page ends in"),
    ],
)
def test_what_gives_no_interval_is_refused(
    words: list[str], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    kept(tmp_path, calibrated(), calibrated(day=300))
    given = words if "nowhere.json" in words else [words[0], str(tmp_path), *words[1:]]
    assert labcal(["intervals", *given]) == 2
    told = capsys.readouterr().err
    assert said in told
    assert len(told.strip().splitlines()) == 1


def test_two_calibrations_give_a_staircase_and_say_why_the_rest_does_not(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    kept(tmp_path, calibrated(), calibrated(day=400, offset_nT=(10.5, 20, 30)))
    found = asked(["intervals", "EM-1", str(tmp_path), "--permitted", "offset=20 nT"], capsys)
    first = found["figures"][0]  # type: ignore[index]
    assert first["proposals"][0]["days"] == pytest.approx(500)
    assert "needs 3" in first["proposals"][1]["why"]


def test_benches_that_agree_and_one_that_does_not(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    a, b, c = kept(tmp_path, calibrated(), calibrated(day=30, offset_nT=(11.0, 20, 30)),
                   calibrated(day=60, offset_nT=(40.0, 20, 30)))  # fmt: skip
    found = asked(["intercompare", f"aalto={a}", f"espoo={b}"], capsys)
    assert found["figures"][0]["degrees"][0]["e_n"] == pytest.approx(-0.5 / (2 * np.sqrt(0.5)), rel=0.01)  # type: ignore[index]
    words = ["intercompare", f"aalto={a}", f"espoo={b}", f"oulu={c}", "--pilot", "aalto"]
    assert asked(words, capsys, code=1)["figures"][0]["degrees"][2]["e_n"] > 5  # type: ignore[index]
    page = tmp_path / "benches.pdf"
    assert labcal([*words, "--out", str(page)]) == 1
    assert page.read_bytes().startswith(b"%PDF")


def test_what_cannot_be_compared_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    a, b = kept(tmp_path, calibrated(), calibrated("EM-2"))
    for words, said in (
        ([f"x={a}", f"y={b}"], "several sensors"),
        ([f"x={a}"], "two benches"),
        ([str(a), str(b)], "expected BENCH=CAL"),
        ([f"x={a}", f"y={a}", "--pilot", "z"], "pilot"),
        ([f"x={a}", f"y={tmp_path}/none.json"], "none.json"),
    ):
        assert labcal(["intercompare", *words]) == 2
        assert said in capsys.readouterr().err


@pytest.mark.skipif(sys.platform == "win32", reason="devices as POSIX has them")
def test_a_table_without_an_end_or_of_bytes_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "t.csv").write_bytes(b"dut,value\na,\xff\n")
    for file, why in (("/dev/zero", "is not a regular file"), (str(tmp_path / "t.csv"), "is not UTF-8 (byte 12)")):
        assert labcal(["rr", "--table", file]) == 2
        assert why in capsys.readouterr().err
