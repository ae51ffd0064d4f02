"""Two runs chosen in the History stand beside each other: figures with E_n, residuals and loci over each other."""

import re
from dataclasses import replace
from datetime import datetime
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtWidgets import QApplication, QFileDialog
from test_calibration_views import FOUND, calibration
from test_path import RUN

from labcal.gui.ipc import compare_commands
from labcal.gui.ipc.answers import Compared, Comparison, Figure, FitFigures, Fitted, Look
from labcal.gui.ipc.compare_commands import compare, newest_file
from labcal.gui.ipc.messages import CompareRuns, ExportRun, ListRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import LIGHT
from labcal.gui.translations.sentences import in_words
from labcal.gui.widgets.fit_views import FitViews
from labcal.gui.widgets.trend import Trend, courses
from labcal.model.apply import apply
from labcal.model.readings import readings_of

LATER = replace(RUN, run_id="r2", started_utc="2026-01-06T07:00:00Z")


def side(run_id, calibration="", offset=0.0):
    t = np.arange(50.0)
    after = np.column_stack([np.cos(t), np.sin(t), 0 * t])
    return Compared(run_id, "EM-07", calibration, 20.0, np.full(50, offset), after, {"time  s": t, "angle  deg": t})


@pytest.fixture
def page(still):
    still.open_page("History")
    page = still.page("History")
    page.search.clear()
    still.app_state.quick_worker.answer(ListRuns, (LATER, RUN, replace(RUN, run_id="r0", status="interrupted")))
    yield page
    page.faces.setCurrentIndex(0)
    page.table.clearSelection()


def choose(page, qtbot, *runs):
    page.table.clearSelection()
    for run in runs:
        row = next(n for n in range(page.table.rowCount()) if page.table.text(n, 6) == run)
        page.table.scrollToItem(page.table.item(row, 0))
        QApplication.processEvents()  # rows have their places
        where = page.table.visualItemRect(page.table.item(row, 0)).center()
        qtbot.mouseClick(page.table.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier, where)


def test_two_chosen_runs_are_compared_the_older_one_first_and_back_again(still, page, qtbot):
    choose(page, qtbot, "r2", "r1")
    assert not page.open.isEnabled()  # which of them?
    qtbot.mouseClick(page.compare, Qt.MouseButton.LeftButton)
    assert still.app_state.fit_worker.commands(CompareRuns) == [CompareRuns("r1", "r2")]
    found = Comparison(side("r1", "r1.json", 30.0), side("r2", offset=-30.0), FOUND)
    view = page.comparison
    assert (view.isVisible(), view.picture.isVisible()) == (True, False)  # no axes of nothing
    still.app_state.fit_worker.answer(CompareRuns, found)
    assert view.picture.isVisible()
    assert view.whose.text().splitlines() == [
        "Earlier: run r1, calibration r1.json", "Later: run r2, fitted now (it has no calibration)"
    ]  # fmt: skip
    row = [view.table.text(0, column) for column in range(view.table.columnCount())]
    assert (row[0], row[5], row[6]) == ("zero reading x", "+3.00", "▲ changed")
    means = [cloud.getData()[1].mean() for cloud in view.residuals.clouds]
    assert means == [30.0, -30.0]
    view.view.setCurrentIndex(1)
    view.view.activated.emit(1)
    assert view.loci.isVisible()
    qtbot.mouseClick(view.back, Qt.MouseButton.LeftButton)
    assert page.table.isVisible()


@pytest.mark.parametrize(
    ("verdict", "dut", "said"),
    [
        ("clean", "EM-07", "the DUT has changed"),
        ("unexplained", "EM-07", "says nothing of the DUT yet"),
        ("clean", "EM-08", "They are of two DUTs"),
    ],
)
def test_what_differs_is_a_change_of_the_dut_only_where_both_are_explained_and_of_it(page, verdict, dut, said):
    found = Comparison(side("r1", "r1.json"), replace(side("r2", "r2.json"), dut=dut), FOUND)
    page.comparison.show_comparison(found, {"r1": verdict, "r2": "explained"})
    assert said in page.comparison.remark.text()
    assert ("✕ UNEXPLAINED" in page.comparison.whose.text()) == (verdict == "unexplained")


def test_two_duts_have_no_table_without_a_figure_and_are_called_by_their_serials(page):
    found = Comparison(side("r1", "r1.json"), replace(side("r2", "r2.json", -0.1), dut="EM-08"), None, "refused")
    view = page.comparison
    page.faces.setCurrentWidget(view)
    view.view.setCurrentIndex(0)
    view.show_comparison(found)
    assert not view.table.isVisible()
    assert view.remark.isVisible()
    assert view.remark.text().endswith("Residuals and loci of both are drawn below.")
    assert [line.partition(":")[0] for line in view.whose.text().splitlines()] == ["EM-07", "EM-08"]
    assert "EM-08: mean −0.1 nT, rms 0.1 nT" in view.words.text()  # one minus sign, as in tables
    assert "Later" not in view.words.text()
    view.show_comparison(Comparison(side("r1", "r1.json"), side("r2", "r2.json"), FOUND))
    assert view.table.isVisible()
    assert view.table.y() > view.remark.y()


def test_what_a_run_noted_of_its_offsets_has_the_minus_sign_of_tables():
    noted = "offsets so far, from magnitudes alone: x 12 ± 3, y -2538 ± 12 nT (k = 2)"
    assert "y −2538 ± 12" in in_words(noted)


def test_a_traced_and_an_untraced_result_are_not_of_one_kind_and_nothing_is_said_to_have_changed(page):
    found = Comparison(side("r1", "r1.json"), side("r2", "r2.json"), FOUND)
    table = page.comparison.table

    def last_column():
        return [table.text(row, table.columnCount() - 1) for row in range(table.rowCount())]

    page.comparison.show_comparison(found, {"r1": "explained"})
    assert "One of the two is traced, the other is not" in page.comparison.remark.text()
    assert "changed" not in page.comparison.remark.text()
    assert not any(last_column())
    page.comparison.show_comparison(found, {})
    assert any("changed" in cell for cell in last_column())


def test_why_two_chosen_runs_are_not_compared_is_said(page, qtbot):
    choose(page, qtbot, "r1", "r0")
    assert page.why_not.isVisible()
    assert page.why_not.text().startswith("No comparison: run r0 is broken off")
    assert page.compare.toolTip() == page.why_not.text()
    choose(page, qtbot, "r1", "r2")
    assert not page.why_not.isVisible()


@pytest.mark.parametrize("runs", [(), ("r1",), ("r1", "r0"), ("r0", "r1", "r2")])
def test_only_two_whole_runs_are_compared(page, qtbot, runs):
    choose(page, qtbot, *runs)
    assert not page.compare.isEnabled()


def test_several_chosen_runs_are_exported_into_a_folder_each_by_serial_and_date(
    still, page, qtbot, tmp_path, monkeypatch
):
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    choose(page, qtbot, "r2", "r1")
    qtbot.mouseClick(page.export, Qt.MouseButton.LeftButton)
    asked = {one.run: one for one in still.app_state.quick_worker.commands(ExportRun)}
    assert {one.format for one in asked.values()} == {"bundle"}
    assert sorted(asked) == ["r1", "r2"]
    names = [Path(one.out).name for one in asked.values()]
    assert all(re.fullmatch(r"EM-07_2026-01-0[4-7]_\d{6}_preflight\.zip", name) for name in names)
    assert len(set(names)) == 2
    choose(page, qtbot, "r0")
    assert not page.export.isEnabled()  # an interrupted run is no bundle yet


def test_what_is_in_the_folder_already_is_not_overwritten(still, page, qtbot, tmp_path, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getExistingDirectory", lambda *_: str(tmp_path))
    choose(page, qtbot, "r2", "r1")
    qtbot.mouseClick(page.export, Qt.MouseButton.LeftButton)
    first = still.app_state.quick_worker.commands(ExportRun)[0].out
    Path(first).write_bytes(b"mine")
    still.app_state.quick_worker.asked.clear()
    qtbot.mouseClick(page.export, Qt.MouseButton.LeftButton)
    assert still.app_state.quick_worker.commands(ExportRun) == []
    assert page.fault.text.text() == f"{Path(first).name} is there already; nothing was written."
    page.fault.show_fault(None)


def test_what_was_asked_before_is_not_shown_in_place_of_what_was_asked_last(still, page, qtbot):
    worker = still.app_state.fit_worker
    for runs in (("r1", "r2"), ("r2", "r1")):
        choose(page, qtbot, *runs)
        page.compare.click()
        page.comparison.back.click()
    first, second = worker.asked
    page.compare.click()
    second.then(Comparison(side("r1"), side("r2"), None, "not of one sensor"))
    first.then(Comparison(side("r1"), side("r2"), FOUND))
    assert page.comparison.table.rowCount() == 0


def test_a_run_that_cannot_be_compared_says_why_on_the_list(still, page, qtbot):
    choose(page, qtbot, "r1", "r2")
    page.compare.click()
    still.app_state.fit_worker.asked[-1].failed(Fault("input", "r1 is damaged"))
    assert page.table.isVisible()
    assert "damaged" in page.fault.text.text()
    page.fault.show_fault(None)


def test_each_run_by_its_own_calibration_and_a_run_beside_itself_has_not_changed(drafted, monkeypatch):
    from labcal import session

    monkeypatch.setenv("LABCAL_HOME", str(drafted))
    (run,) = [one.run_id for one in session.runs()]
    found = compare(SimpleNamespace(send=lambda event: None), CompareRuns(run, run))
    assert found.older.calibration == newest_file(run).name == f"{run}.json"
    assert {row.e_n for row in found.changes.rows} == {0.0}
    measured = session.load_run(run)
    field = apply(session.load_calibration(newest_file(run)), readings_of(measured)).field_nT
    step = -(-len(measured) // 1500)
    left = (np.linalg.norm(field, axis=1) - measured.magnitude_nT)[::step]
    assert np.array_equal(found.newer.residual, left, equal_nan=True)
    assert found.newer.against["time  s"][0] == 0.0
    mine = session.load_calibration(newest_file(run))
    another = replace(mine, dut=replace(mine.dut, serial="EM-08"))
    sides = iter(((found.older, another), (found.newer, mine)))
    monkeypatch.setattr(compare_commands, "side_of", lambda run: next(sides))
    refused = compare(None, CompareRuns("r0", run)).refused
    assert refused.startswith(f"The calibration of r0 is of EM-08, not of {mine.dut.serial}")


def test_the_trend_draws_the_limits_of_the_specification(qtbot):
    figures = [Figure("offset", f"offset {axis}", 100.0, 8.0, "nT", 500.0) for axis in "xyz"]
    figures += [Figure("scale", f"scale {axis}", 4.0, None, "ppm") for axis in "xyz"]
    files = [replace(calibration(), figures=tuple(figures))] * 2
    assert [one.limit for one in courses(files, "zero reading")] == [500.0] * 3
    trend = Trend(LIGHT)
    qtbot.addWidget(trend)
    trend.show_files("S1", files, [0.0, 86_400.0 * 9])
    trend.idle_queue.finish()
    lines = sorted(item.value() for item in trend.plot.getPlotItem().items if hasattr(item, "value"))
    assert lines == [-500.0, 500.0]
    assert trend.plot.getPlotItem().viewRange()[1][1] > 500.0
    trend.parameter.setCurrentIndex(1)
    trend.draw()
    trend.idle_queue.finish()
    assert [item for item in trend.plot.getPlotItem().items if hasattr(item, "value")] == []


@pytest.mark.parametrize("stated_nT", [15.0, None])
def test_the_band_is_the_noise_that_the_verdict_of_fit_goes_by_on_both_pages_and_says_which(page, stated_nT):
    stated = stated_nT is not None
    one, other = side("r1", "r1.json"), side("r2", "r2.json")
    if stated:  # of the fits' own, 20 nT each, nothing is drawn
        one, other = (replace(each, noise_nT=stated_nT, noise_stated=True) for each in (one, other))
    page.comparison.view.setCurrentIndex(0)
    page.comparison.show_comparison(Comparison(one, other, FOUND), {})
    views, figures = FitViews(LIGHT), FitFigures(True)
    views.view.setCurrentIndex(1)
    look = Look("r1", "EM-07", 50, np.ones((50, 3)), {"time  s": np.arange(50.0)})
    views.show_fit(look, "ml", Fitted(figures, 20.0, np.zeros(50), np.ones((50, 3)), stated_nT=stated_nT))
    for picture in (page.comparison.residuals, views.residual):
        assert picture._band.getRegion() == pytest.approx((-2 * (stated_nT or 20.0), 2 * (stated_nT or 20.0)))
    for words in (page.comparison.words.text(), views.words.text()):
        assert ("none is stated" in words) != stated


def test_the_noise_of_a_side_is_stated_by_its_run_where_it_states_one():
    run = SimpleNamespace(dut=SimpleNamespace(noise_nT=3.0), reference=SimpleNamespace(noise_nT=4.0))
    assert compare_commands.stated_noise(run) == 5.0


def written_below(trend):
    """What stands at the ticks of the time axis."""
    axis, image = trend.plot.getPlotItem().getAxis("bottom"), QImage(900, 60, QImage.Format.Format_RGB32)
    trend.grab()
    with QPainter(image) as painter:
        return [text for _, _, text in axis.generateDrawSpecs(painter)[2]]


def test_calibrations_of_one_day_stand_above_its_date_and_not_among_hours(qtbot):
    files = [replace(calibration(), figures=tuple(Figure("offset", f"offset {a}", 1.0, 8.0, "nT") for a in "xyz"))] * 2
    trend = Trend(LIGHT)
    qtbot.addWidget(trend)
    trend.resize(900, 400)
    noon = datetime(2026, 11, 30, 12).timestamp()
    for times, days in (([noon, noon + 600], ["2026-11-30"]), ([noon, noon + 9 * 86_400], None)):
        trend.show_files("S1", files, times)
        trend.idle_queue.finish()
        assert written_below(trend) == days if days else len(written_below(trend)) > 1
