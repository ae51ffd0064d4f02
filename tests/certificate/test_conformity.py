"""Conformity and change where people and machines read them: report, DCC, command line."""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.certificate import Signer, changed_from, changed_since, verify
from labcal.certificate.calibration_file import calibration_bytes, read_calibration
from labcal.certificate.dcc import DCC, SI, dcc_xml, si_unit
from labcal.certificate.report import Circumstances, calibration_page
from labcal.certificate.report.derived import sensor_figures
from labcal.certificate.report.html import html
from labcal.cli import execute
from labcal.errors import InputError
from labcal.model import Calibration
from labcal.record import Administrative, Dut, Limit, Reference, Run, Segment, Specification
from labcal.record.administrative import Address, Laboratory
from labcal.store import bundle_of, save_bundle
from labcal.testing.made_up_runs import made_up_run
from labcal.uncertainty.budget import Budget, Row
from labcal.uncertainty.conformity import assess, changes
from labcal.uncertainty.conformity.decision import Judged
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map

XML = {"dcc": DCC, "si": SI}
IN_BERN = Circumstances(Administrative(Laboratory("A", "Bern", "CH"), Address("X", "Y", "DE")))
GUARDED = "guard band w = 1 U, k = 2 (ILAC G8:09/2019, 4.2.3; JCGM 106:2012, 8.3)"
LINES = (
    Judged("offset x", 1250.0, 40.0, 1500.0, "nT", GUARDED, "pass", 3.7e-36, 37.5),
    Judged("scale y", -0.49, 0.02, 0.5, "%", GUARDED, "conditional-pass", 0.1587, 25.0),
    Judged("non-orthogonality y-z", 61.0, 2.0, 60.0, "arcmin", GUARDED, "conditional-fail", 0.8413, 30.0),
    Judged("noise", 31.0, 0.5, 20.0, "nT", GUARDED, "fail", 1.0, 40.0),
)


@pytest.fixture
def judged(calibration: Calibration) -> Calibration:
    return replace(calibration, specification=tuple(asdict(line) for line in LINES))


def page_of(
    calibration: Calibration, path: Path, lab: tuple[Signer, ...] = (), before: Calibration | None = None
) -> str:
    path.write_bytes(calibration_bytes(calibration))
    checked = verify(path, lab, frozenset(), datetime(2026, 11, 21, tzinfo=UTC))
    changed = None if before is None else changes(calibration, before)
    return html(calibration_page(calibration, checked, "now", changed=changed))


def test_the_file_keeps_the_lines(judged: Calibration, tmp_path: Path):
    (tmp_path / "cal.json").write_bytes(calibration_bytes(judged))
    found = read_calibration(tmp_path / "cal.json")
    assert tuple(Judged(**line) for line in found.specification) == LINES


def test_the_report_states_each_line_its_rule_and_its_risk(judged: Calibration, tmp_path: Path):
    text = page_of(replace(judged, chain={"head": "ab" * 32, "rows": 7}), tmp_path / "cal.json")
    for said in (
        "Is it in specification?", "NOT IN SPECIFICATION", "PASS", "conditional pass", "conditional fail", "FAIL",
        "&lt; 0.01 %", "16 %", "84 %", "&gt; 99 %", ">′</td>", "37.5",
        "Decision rule, chosen before the measurement",
        "guard band w = 1 U, k = 2 (ILAC G8:09/2019, 4.2.3; JCGM 106:2012, 8.3)",
    ):  # fmt: skip
        assert said in text, said


def test_a_run_without_a_chain_does_not_show_when_its_rule_was_chosen(judged: Calibration, tmp_path: Path):
    text = page_of(replace(judged, chain=None), tmp_path / "cal.json")
    assert "Decision rule, as its run states it (when it was chosen is not shown)" in text
    assert "chosen before" not in text


@pytest.mark.parametrize(
    ("count", "mark"),
    [
        (1, ">IN SPECIFICATION<"),
        (2, ">IN SPECIFICATION, CONDITIONALLY<"),
        (3, ">NOT IN SPECIFICATION, CONDITIONALLY<"),
        (4, ">NOT IN SPECIFICATION<"),
    ],
)
def test_the_worst_line_is_the_mark(judged: Calibration, tmp_path: Path, count: int, mark: str):
    assert mark in page_of(replace(judged, specification=judged.specification[:count]), tmp_path / "cal.json")


def test_a_report_without_a_specification_or_a_predecessor_says_nothing_of_them(calibration: Calibration, draft: Path):
    text = page_of(calibration, draft)
    assert "specification" not in text.split("<body>")[1].lower()
    assert "As found" not in text


def moved(calibration: Calibration, by_nT: float) -> Calibration:
    affine = replace(calibration.affine, k_nT=calibration.affine.k_nT + [by_nT, 0.0, 0.0])
    return replace(calibration, affine=affine, run_id="r-2025-11-02-01")


def test_the_report_says_what_changed_in_units_of_its_uncertainty(calibration: Calibration, tmp_path: Path):
    text = page_of(calibration, tmp_path / "cal.json", before=moved(calibration, 300.0))
    assert "As found, as left" in text
    assert "As found by the calibration of run r-2025-11-02-01, as left by this one." in text
    # 300 nT of k with u = 2 nT in both: E_n = -300 / (2 · √2 · 2) = -53.03 for the offset along x
    assert "\u221253.03" in text
    assert "changed by more than their uncertainty" in text
    assert "No figure changed" in page_of(calibration, tmp_path / "cal.json", before=moved(calibration, 2.0))


def test_a_dcc_says_what_changed_in_units_of_its_uncertainty(calibration: Calibration) -> None:
    etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
    laboratory = Circumstances(Administrative(Laboratory("A", "Bern", "CH"), Address("X", "Y", "DE")))
    since = changes(calibration, moved(calibration, 300.0))
    run, names = run_at("2026-11-21T23:50:00Z"), {"dcc": DCC, "si": SI}
    xml = dcc_xml(calibration, calibration_bytes(calibration), "cal.json", run, laboratory, changed=since)
    root = etree.fromstring(xml)
    told = {
        r.findtext("dcc:name/dcc:content", namespaces=names).removeprefix("since the calibration before: "): r
        for r in root.iterfind(".//dcc:result", names)
    }
    values = [v.text for v in told["offset x"].iterfind("dcc:data/dcc:quantity/si:real/si:value", names)]
    row = next(row for row in since.rows if row.quantity == "offset x")
    assert values == [repr(value) for value in (row.found, row.left, row.left - row.found, row.e_n)]
    assert float(values[3]) == pytest.approx(-53.03, abs=0.01)
    assert "run r-2025-11-02-01" in told["offset x"].findtext("dcc:description/dcc:content", namespaces=names)
    assert {row.quantity for row in since.rows} <= set(told)


def run_at(started_utc: str, serial: str = "FM-07") -> Run:
    return Run(
        "r", started_utc, True, "", Dut(serial), Reference("none"), (Segment("a", "static"),), np.array([5.0, 1205.0]),
        np.zeros(2, dtype=np.intp), np.zeros((2, 3)),
    )  # fmt: skip


def test_a_dcc_states_conformity_in_the_schema_s_own_words(judged: Calibration):
    etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
    laboratory = Circumstances(Administrative(Laboratory("A", "Bern", "CH"), Address("X", "Y", "DE")))
    xml = dcc_xml(judged, calibration_bytes(judged), "cal.json", run_at("2026-11-21T23:50:00Z"), laboratory)
    root, names = etree.fromstring(xml), {"dcc": DCC, "si": SI}
    verdicts = [e.text for e in root.iterfind(".//dcc:conformity", names)]
    assert verdicts == ["pass", "conditionalPass", "conditionalFail", "fail"]
    quantities = [e.getparent().getparent().getparent() for e in root.iterfind(".//dcc:conformity", names)]
    stated = [
        (q.findtext("si:real/si:value", namespaces=names), q.findtext("si:real/si:unit", namespaces=names))
        for q in quantities
    ]
    assert stated == [(repr(line.value), si_unit(line.unit)) for line in LINES]
    limits = [q.findtext(".//dcc:data/dcc:quantity/si:real/si:value", namespaces=names) for q in quantities]
    assert limits == [repr(line.limit) for line in LINES]
    expanded = [q.findtext(".//si:valueExpandedMU", namespaces=names) for q in quantities]
    assert expanded == [repr(line.U) for line in LINES]
    told = quantities[1].findtext(".//dcc:declaration/dcc:content", namespaces=names)
    assert "Absolute value at most 0.5 %." in told
    assert GUARDED in told
    assert "Specific risk of false acceptance 16 %. Test uncertainty ratio 25." in told
    assert [si_unit(u) for u in ("%", "ppm", "µT", "arcmin")] == [r"\percent", r"\ppm", r"\micro\tesla", r"\arcminute"]


def test_of_few_degrees_of_freedom_page_file_and_dcc_state_one_u(calibration: Calibration, tmp_path: Path):
    """The same zero reading stands in three tables and in the XML: k of six degrees of freedom is 2.52 in each."""
    etree = pytest.importorskip("lxml.etree", reason="needs the extra `dcc` (lxml), which is not installed")
    rows = (Row("noise of the run, through the fit", "A", "normal", 4.0, "count", 1.0, 6.0),)
    budget = tuple(Budget(f"zero reading {axis}", "", "count", rows).as_json() for axis in "xyz")
    few = replace(calibration, budget=budget)
    lines = assess(few, Specification(offset=Limit(100.0, "nT"), scale=Limit(5.0, "%")), None).lines
    U_of_zero, U_of_scale = lines[0].U, lines[3].U
    assert U_of_zero == pytest.approx(2.5165 * 2.0, rel=5e-3)  # u of k_x; K_xx is the nominal scale
    assert U_of_scale == pytest.approx(2 * 100 * figures_of_the_map(few)[3].u)  # no budget: many
    few = replace(few, specification=tuple(asdict(line) for line in lines))
    text = page_of(few, tmp_path / "cal.json")
    assert "coverage factor 2.52 (95 % at least)" in text
    assert "(k = 2.52)" in text  # of an effect's parameters
    assert f"{2.52 * few.effects[0].parameters[0].u:.2g}" in text
    assert "(k = 2)" not in text
    assert "coverage factor 2 (about 95 %)" not in text
    zero = sensor_figures(few, 2.0).rows[0]
    assert float(zero[4]) == pytest.approx(U_of_zero / 0.5, rel=0.05)
    xml = dcc_xml(few, calibration_bytes(few), "c", run_at("2026-11-21T23:50:00Z"), IN_BERN)
    stated = [
        (one.findtext("si:valueExpandedMU", namespaces=XML), one.findtext("si:coverageFactor", namespaces=XML))
        for one in etree.fromstring(xml).iterfind(".//dcc:result[@refType='labcal_specification']//si:expandedMU", XML)
    ]
    assert [float(U) for U, _ in stated] == [line.U for line in lines]
    assert [float(k) for _, k in stated] == pytest.approx([2.5165] * 3 + [2.0] * 3, rel=1e-4)


def test_an_uncertainty_has_two_figures_however_large_it_is(calibration: Calibration, tmp_path: Path):
    line = Judged("noise", 24690.3, 3386.4, 22000.0, "pT", GUARDED, "conditional-fail", 0.944, 6.497)
    text = page_of(replace(calibration, specification=(asdict(line),)), tmp_path / "cal.json")
    assert "24\u202f700" in text
    assert "3\u202f400" in text
    assert "3\u202f386" not in text


def test_the_calibration_before_is_the_last_of_the_same_sensor(calibration: Calibration, tmp_path: Path):
    started = {}

    def put(name: str, started_utc: str, found: Calibration) -> None:
        (tmp_path / f"{name}.json").write_bytes(calibration_bytes(replace(found, run_id=name)))
        started[name] = started_utc

    own = replace(calibration, run_id="own")
    put("own", "2026-11-21T08:00:00Z", calibration)
    assert changed_since(own, tmp_path, started) is None
    put("first", "2024-11-21T08:00:00Z", moved(calibration, 300.0))
    put("second", "2025-11-21T08:00:00Z", moved(calibration, 2.0))
    put("later", "2027-11-21T08:00:00Z", moved(calibration, 900.0))
    put("another", "2026-11-20T08:00:00Z", replace(calibration, dut=replace(calibration.dut, serial="FM-08")))
    put("real", "2026-11-20T08:00:00Z", replace(calibration, simulated=False))
    (tmp_path / "broken.json").write_text("{")
    assert changed_since(own, tmp_path, started).found == "second"
    assert changed_since(own, tmp_path / "nowhere", started) is None
    assert changed_since(own, tmp_path, {}) is None
    with pytest.raises(InputError, match=r"another.json: is of FM-08, not of FM-07"):
        changed_from(own, tmp_path / "another.json")
    with pytest.raises(InputError, match="not JSON"):
        changed_from(own, tmp_path / "broken.json")


SHEET = 'offset = { limit = 5, unit = "uT" }\nnoise = { limit = 40, unit = "nT" }\n'


@pytest.fixture
def recorded(tmp_path: Path) -> Path:
    """A bundle whose run was recorded under a specification."""
    limits = {"offset": Limit(5.0, "uT"), "noise": Limit(40.0, "nT"), "residual": Limit(90.0, "nT")}
    save_bundle(
        bundle_of(replace(made_up_run(rows=40).run, specification=Specification(**limits))), tmp_path / "bundle"
    )
    return tmp_path / "bundle"


def test_fit_prints_the_lines_and_writes_them(
    recorded: Path, tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
):
    made = tmp_path / "cal.json"
    assert execute(["fit", str(recorded), "--out", str(made)]) == 0
    shown = capsys.readouterr().out
    for said in ("offset x", "noise", "residual", "PASS", "Decision rule: guard band w = 1 U"):
        assert said in shown, said
    stated = json.loads(made.read_bytes())["specification"]
    assert [line["quantity"] for line in stated] == ["offset x", "offset y", "offset z", "noise", "residual"]
    assert {line["result"] for line in stated} == {"pass"}
    assert stated[0]["tur"] == pytest.approx(stated[0]["limit"] / stated[0]["U"])
    assert execute(["conformity", str(made)]) == 0
    assert "offset x" in capsys.readouterr().out
    assert execute(["report", str(made), "--out", str(tmp_path / "cal.html")]) == 0
    assert "Is it in specification?" in (tmp_path / "cal.html").read_text()


def test_another_specification_is_judged_and_said_to_have_been_chosen_afterwards(
    recorded: Path, tmp_path: Path, home_of_its_own: Path, capsys: pytest.CaptureFixture[str]
):
    made, sheet = tmp_path / "cal.json", tmp_path / "sheet.toml"
    assert execute(["fit", str(recorded), "--out", str(made)]) == 0
    sheet.write_text(SHEET)
    capsys.readouterr()
    asked = ["conformity", str(made), "--specification", str(sheet)]
    assert execute(asked) == 1  # the run is not at hand: its noise is open
    shown = capsys.readouterr().out
    assert "noise, which only the run shows, and it is not at hand" in " ".join(shown.split())
    assert "not chosen before the measurement" in shown
    assert execute([*asked, "--run", str(recorded)]) == 0
    sheet.write_text(SHEET.replace("limit = 40", "limit = 4"))
    assert execute([*asked, "--run", str(recorded), "--json", str(tmp_path / "lines.json")]) == 1
    lines = json.loads((tmp_path / "lines.json").read_text())["specification"]
    assert [line["result"] for line in lines] == ["pass", "pass", "pass", "fail"]
    save_bundle(bundle_of(made_up_run(rows=40, seed=9).run), tmp_path / "other")
    assert execute([*asked, "--run", str(tmp_path / "other")]) == 2


def test_offsets_say_at_what_channels_they_are(
    calibration: Calibration, tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    (tmp_path / "cal.json").write_bytes(calibration_bytes(replace(calibration, k_at={"i_eps": 0.0532})))
    (tmp_path / "sheet.toml").write_text('[offset]\nlimit = 1e5\nunit = "nT"\n')
    asked = ["conformity", str(tmp_path / "cal.json"), "--specification", str(tmp_path / "sheet.toml")]
    assert execute([*asked, "--json", str(tmp_path / "lines.json")]) == 0
    assert "Offsets are those at i_eps = 0.0532" in capsys.readouterr().out
    assert json.loads((tmp_path / "lines.json").read_text())["offsets"].startswith("at i_eps = 0.0532")


def test_a_calibration_measured_under_none_says_so(draft: Path, capsys: pytest.CaptureFixture[str]):
    assert execute(["conformity", str(draft)]) == 2
    assert "was measured under no specification: name one with --specification FILE" in capsys.readouterr().err


def test_compare_tells_a_change_by_its_exit_code(
    calibration: Calibration, tmp_path: Path, capsys: pytest.CaptureFixture[str]
):
    for name, by in (("now", 0.0), ("same", 2.0), ("then", 300.0)):
        (tmp_path / f"{name}.json").write_bytes(calibration_bytes(moved(calibration, by)))
    now, same, then = (str(tmp_path / f"{name}.json") for name in ("now", "same", "then"))
    assert execute(["compare", now, same]) == 0
    assert execute(["compare", now, then, "--json", str(tmp_path / "changes.json")]) == 1
    assert "-53.03" in capsys.readouterr().out
    rows = json.loads((tmp_path / "changes.json").read_text())["rows"]
    assert rows[0]["e_n"] == pytest.approx(-300 / (4 * np.sqrt(2)), rel=1e-3)


def test_a_report_compares_with_the_file_that_it_is_told(
    calibration: Calibration, tmp_path: Path, home_of_its_own: Path
):
    for name, by in (("now", 0.0), ("then", 300.0)):
        (tmp_path / f"{name}.json").write_bytes(calibration_bytes(moved(calibration, by)))
    session.report(str(tmp_path / "now.json"), tmp_path / "now.html", before=tmp_path / "then.json")
    assert "As found, as left" in (tmp_path / "now.html").read_text()


def test_a_report_is_written_where_the_store_cannot_be_read(
    calibration: Calibration, tmp_path: Path, home_of_its_own: Path
):
    (home_of_its_own / "store.sqlite").write_bytes(b"no store at all, but longer than nothing" * 40)
    (tmp_path / "now.json").write_bytes(calibration_bytes(calibration))
    session.report(str(tmp_path / "now.json"), tmp_path / "now.html")
    assert "As found" not in (tmp_path / "now.html").read_text()


def test_the_lab_s_own_folder_is_looked_through(calibration: Calibration, tmp_path: Path, home_of_its_own: Path):
    folder = home_of_its_own / "calibrations"
    folder.mkdir(parents=True)
    for name, day, by in (("then", "2025-11-21", 300.0), ("now", "2026-11-21", 0.0)):
        save_bundle(bundle_of(replace(run_at(f"{day}T08:00:00Z"), run_id=name)), tmp_path / name)
        session.import_bundle(tmp_path / name)
        (folder / f"{name}.json").write_bytes(calibration_bytes(replace(moved(calibration, by), run_id=name)))
    session.report(str(folder / "now.json"), tmp_path / "now.html")
    assert "As found by the calibration of run then" in (tmp_path / "now.html").read_text()
    assert session.changed_since(read_calibration(folder / "then.json")) is None
