"""A chosen calibration's tabs: the specification's lines in word, shape and colour, and what changed since before."""

from __future__ import annotations

from dataclasses import replace

import pytest

from labcal.gui.ipc.answers import BudgetLine, CalibrationFile, Figure, FitFigures, Fitted, Standing
from labcal.gui.ipc.messages import ListCalibrations
from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.viewmodels.calibration_rows import PARAMETERS, cause_rows, map_rows, short_rows
from labcal.gui.viewmodels.conformity import CHANGES, SPECIFICATION, change_rows, specification_rows, verdict
from labcal.gui.viewmodels.largest_of_U import how_to_lower_U, largest_of_U
from labcal.gui.widgets.calibration_views import BUDGET, CAUSES, CHANGED, MAP, SPECIFIED, CalibrationViews
from labcal.gui.widgets.measurement_table import Table
from labcal.record import Dut
from labcal.uncertainty.conformity import Change, Changes, Judged

RULE = "guard band w = 1 U, k = 2 (ILAC G8:09/2019, 4.2.3; JCGM 106:2012, 8.3)"
LINES = (
    Judged("offset x", -1250.0, 40.0, 1500.0, "nT", RULE, "pass", 3.7e-36, 37.5),
    Judged("scale y", 0.49, 0.02, 0.5, "%", RULE, "conditional-pass", 0.1587, 25.0),
    Judged("noise", 20.3, 0.5, 20.0, "nT", RULE, "conditional-fail", 0.88, None),
    Judged("linearity z", 0.09, 0.002, 0.05, "%", RULE, "fail", 1.0, 25.0),
)
FOUND = Changes(
    "r1", "r2",
    (
        Change("offset x", 100.0, 160.0, 20.0, "nT", 3.0),
        Change("scale y", 4.0, 3.0, 9.0, "ppm", -0.11),
        Change("scale z", 4.0, 3.0, None, "ppm", None),
    ),
    ("Offsets are not of the same state.",),
)  # fmt: skip


def calibration(lines: tuple[Judged, ...] = LINES, left_open: tuple[str, ...] = (), path: str = "a") -> CalibrationFile:
    standing = Standing(path, True, False, (), (), ())
    return CalibrationFile(
        path, "r2", Dut("S1"), ((1.0,) * 3,) * 3, (0.0,) * 3, "", None, (), (), (), "", (), standing,
        specification=lines,
        left_open=left_open,
    )  # fmt: skip


SHORT = replace(calibration(()), figures=(Figure("offset", "offset x", -1250.0, 40.0, "nT"),))


@pytest.fixture
def views(qtbot):
    table = Table(PARAMETERS)
    made = CalibrationViews(table, LIGHT)
    made.table = table
    qtbot.addWidget(table)
    qtbot.addWidget(made)
    return made


def text(table: Table) -> list[list[str]]:
    return [[table.text(row, column) for column in range(table.columnCount())] for row in range(table.rowCount())]


def test_each_result_has_its_word_shape_and_colour(views):
    views.show_calibration(calibration())
    assert views.tabs.tabText(SPECIFIED) == "✕ Not in specification"
    views.tabs.setCurrentIndex(SPECIFIED)
    rows = text(views.table)
    assert rows[0] == ["zero reading x", "−1\u202f250", "40", "1500", "nT", "✓ PASS", "< 0.01 %", "37.5"]
    assert [row[5] for row in rows] == ["✓ PASS", "▲ conditional pass", "▼ conditional fail", "✕ FAIL"]
    assert rows[2][7] == "–"
    colours = [views.table.item(row, 5).foreground().color().name() for row in range(4)]
    assert colours == [LIGHT.good, LIGHT.warning, LIGHT.warning, LIGHT.bad]
    assert RULE in views.remark.text()
    views.set_theme(DARK)
    assert views.table.item(3, 5).foreground().color().name() == DARK.bad


def test_the_tab_says_what_the_lines_come_to():
    said = [verdict(LINES[:count]) for count in range(5)]
    assert said == [
        "In specification?",
        "✓ In specification",
        "▲ In specification, conditionally",
        "▼ Not in specification, conditionally",
        "✕ Not in specification",
    ]


def test_what_changed_comes_later_and_belongs_to_the_calibration_that_is_shown(views):
    views.show_calibration(calibration())
    assert not views.tabs.isTabEnabled(CHANGED)
    views.show_changes("another", FOUND)
    assert not views.tabs.isTabEnabled(CHANGED)
    views.show_changes("a", FOUND)
    assert views.tabs.isTabEnabled(CHANGED)
    assert views.tabs.tabText(CHANGED) == "▲ As found, as left: 1 changed"
    views.tabs.setCurrentIndex(SPECIFIED)
    views.tabs.setCurrentIndex(CHANGED)
    rows = text(views.table)
    assert rows[0] == ["zero reading x", "+100", "+160", "20", "nT", "+3.00", "▲ changed"]
    assert rows[1][5:] == ["−0.11", ""]
    assert rows[2][3:] == ["–", "ppm", "–", ""]
    assert "1 of 2 figures changed" in views.remark.text()
    assert "not of the same state" in views.remark.text()
    assert views.table.item(1, 5).foreground() != views.table.item(0, 6).foreground()
    views.show_calibration(calibration(path="b"))
    assert not views.tabs.isTabEnabled(CHANGED)
    assert views.tabs.currentIndex() != CHANGED
    assert views.table.columnCount() != len(rows[0])


def test_without_lines_there_is_nothing_to_open_but_what_was_left_open(views):
    views.show_calibration(calibration(()))
    assert not views.tabs.isTabEnabled(SPECIFIED)
    views.show_calibration(calibration((), ("Of the specification: noise, which this run does not determine.",)))
    assert views.tabs.isTabEnabled(SPECIFIED)
    views.tabs.setCurrentIndex(SPECIFIED)
    assert (views.table.rowCount(), "does not determine" in views.remark.text()) == (0, True)


def test_rows_are_as_wide_as_their_headings():
    assert {len(row) for row in specification_rows(LINES)} == {len(SPECIFICATION)}
    assert {len(row) for row in change_rows(FOUND)} == {len(CHANGES)}
    assert {len(row) for row in (*map_rows(calibration()), *short_rows(SHORT), *cause_rows(SHORT))} == {len(PARAMETERS)}


def test_a_few_figures_stand_first_and_the_map_behind_a_tab_of_its_own(views):
    views.show_calibration(SHORT)
    assert text(views.table) == [["zero reading x", "−1\u202f250", "40", "nT"]]
    assert [views.tabs.isTabVisible(at) for at in (MAP, CAUSES, BUDGET)] == [True, False, False]
    views.tabs.setCurrentIndex(MAP)
    assert [row[0] for row in text(views.table)][:4] == ["offset k x", "offset k y", "offset k z", "gain K x by x"]


def test_what_makes_most_of_each_uncertainty_stands_behind_a_tab_and_all_of_it_in_the_tip(views):
    shares = (("reference: zero", 0.84), ("noise", 0.16))
    budget = (
        BudgetLine("|b|", "50 µT along x", 7.42, 2.0, "nT", shares),
        BudgetLine("angle xy", "", 0.0151, 2.1, "deg", ()),
    )
    views.show_calibration(replace(calibration(), budget=budget))
    views.tabs.setCurrentIndex(BUDGET)
    assert text(views.table) == [
        ["|b| · 50 µT along x: reference: zero 84.0 %", "–", "7.4", "nT"],
        ["angle xy", "–", "0.015", "deg"],
    ]
    assert views.table.item(0, 0).toolTip().split("\n") == [
        "|b| 50 µT along x", "k = 2.00", "reference: zero 84.0 %", "noise 16.0 %"
    ]  # fmt: skip
    assert not views.remark.isVisibleTo(views)


def test_a_draft_of_a_simulated_run_says_so_and_its_list_leaves_the_focus_alone(still, qtbot):
    draft = replace(calibration(path="home/r2.json"), simulated=True, operator="J. Doe")
    page = still.page("Certificate")
    still.app_state.lab.update(dut_serial=draft.dut.serial)
    still.open_page("Certificate")
    still.app_state.quick_worker.answer(ListCalibrations, (draft,))
    assert page.list.itemText(0).endswith("r2  ·  SIMULATED")
    assert "SIMULATED: it describes no real sensor." in page.standing.text()
    page.steps.take_keys(("jdoe",))
    page.steps.signer.setFocus()
    page.refresh()
    still.app_state.quick_worker.answer(ListCalibrations, (draft,))
    assert page.steps.signer.hasFocus()


MOUNTED = BudgetLine("b y", "50 µT along +x", 873.6, 2.0, "nT", (("rotation axes in the body about z", 0.97),))
NOISY = BudgetLine("b x", "50 µT along +x", 31.9, 2.0, "nT", (("noise of one reading", 0.88),))


def test_one_line_says_what_makes_most_of_U():
    """27 nT on the Loop page, and U = 870 nT on the certificate, said nothing of each other."""
    words = largest_of_U(replace(SHORT, budget=(NOISY, MOUNTED)))
    assert words == (
        "U of one component of the field: 874 nT (k = 2), mostly from the mounting, declared good to 0.5°."
    )
    assert how_to_lower_U(replace(SHORT, budget=(NOISY, MOUNTED))) == (
        "To lower it, mount more exactly and declare that (u_mounting_deg): docs/certificate.md"
    )
    shared = replace(MOUNTED, sources=(("rotation axes in the body about z", 0.4), ("noise of one reading", 0.3)))
    assert largest_of_U(replace(SHORT, budget=(shared,))) == (
        "U of one component of the field: up to 874 nT (k = 2), 40 % of it from the declared mounting "
        "(rotation axes in the body about z)."
    )
    assert "declare" not in how_to_lower_U(replace(SHORT, budget=(shared,)))
    assert how_to_lower_U(None) == ""
    assert largest_of_U(replace(SHORT, budget=())) == largest_of_U(None) == ""


def test_the_figures_in_short_say_by_which_method_they_are_and_what_they_are_not(views):
    views.show_calibration(replace(SHORT, budget=(MOUNTED,), method="closed-loop"))
    most, said = views.remark.text().split("\n")
    assert "mounting" in most
    assert said.startswith(
        "By the method closed loop. Zero reading: what the sensor indicates in no field; the offset k"
    )


def test_the_loop_page_says_it_too(still):
    page, app_state = still.page("Loop"), still.app_state
    app_state.study_vm.forget("r1")
    app_state.path.take_calibrations((replace(SHORT, run_id="r1", budget=(MOUNTED,)),))
    assert page.most_of_U.text() == largest_of_U(replace(SHORT, budget=(MOUNTED,)))
    assert "u_mounting_deg" in page.most_of_U.toolTip()
    app_state.path.take_calibrations(())
    assert page.most_of_U.isHidden()


@pytest.mark.parametrize(("unit", "said"), [("nT", "1"), ("LSB", "nT/LSB")])
def test_every_row_of_a_map_says_its_unit_and_that_of_k_is_1_where_readings_are_fields(unit, said):
    one = calibration()
    one = replace(one, dut=replace(one.dut, unit=unit))
    assert [row[3].text for row in map_rows(one)] == ["nT"] * 3 + [said] * 9


def test_rows_of_the_fit_table_name_each_gain_and_the_unit_of_offsets(still):
    page, study = still.page("Fit"), still.app_state.study_vm
    study.fits = {"ml": Fitted(FitFigures(False, "diverged"))}
    study.changed.emit()
    page.idle_queue.finish()
    names = [page.table.text(row, 0) for row in range(page.table.rowCount())]
    assert names[-9:] == [f"gain K {a} by {b}" for a in "xyz" for b in "xyz"]
    assert all("  nT" in name for name in names if name.startswith("offset"))  # gains have no unit
