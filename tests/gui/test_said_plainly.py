"""Small things that made a stranger hesitate: what a button does, what an empty page wants, which figure is which."""

from dataclasses import replace

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QDesktopServices, QKeySequence, QShortcut
from PySide6.QtWidgets import QApplication, QLabel

from labcal.gui.ipc.answers import Ended, RunLine
from labcal.gui.ipc.messages import ExportRun, FitRun, ListRuns, RunProcedure, WriteReport
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.lab_now import LabNow
from labcal.gui.viewmodels.number_format import MINUS
from labcal.gui.widgets.key_sheet import KeySheet
from labcal.record.stream import Measurement, Prompt

RUN = RunLine("r1", "2026-01-05T07:00:00Z", "finished", "EM-07", "J. Doe", "preflight")


def words_in(widget):
    return [one.text() for one in widget.findChildren(QLabel)]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        (Prompt(0.0, "ready", "The coils go on. Hands off?", acts=True), "Hands off: begin   F8"),
        (Prompt(0.0, "mode-full", "Switch it.", acts=True, drawing={"mode": "full"}), "Switched   F8"),
        (Prompt(0.0, "of another package", "Do it."), "Done"),
    ],
)
def test_the_button_of_a_question_says_what_has_been_done(still, prompt, words):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((prompt,))
    assert still.page("Run").live.prompt.choices["done"].text() == words


@pytest.mark.parametrize("name", ["Fit", "Loop"])
def test_a_page_without_runs_says_where_they_come_from(still, qtbot, name):
    page = still.page(name)
    still.open_page(name)
    still.app_state.quick_worker.answer(ListRuns, ())
    assert "record one on the Run page" in page.empty.text()
    qtbot.mouseClick(page.to_run, Qt.MouseButton.LeftButton)
    assert still.stack.currentWidget() is still.lazy_pages["Run"]
    page.chooser.refresh()
    still.app_state.quick_worker.answer(ListRuns, (RUN, replace(RUN, run_id="r2", status="failed: aborted")))
    assert page.to_run.isHidden()
    assert "Choose a run above" in page.empty.text()
    assert page.chooser.itemText(0).startswith("EM-07 · 2026-01-05")
    assert page.chooser.itemText(1).startswith("✕ broken off · ")


def test_fit_on_the_run_page_begins_at_once_and_once(still, qtbot):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    live = still.page("Run").live
    for _ in range(2):
        live.fit.click()
    assert still.stack.currentWidget() is still.lazy_pages["Fit"]
    assert len(still.app_state.fit_worker.commands(FitRun)) == 1


def test_instruments_have_words_beside_their_lights(still):
    still.show_state(LabState(now=LabNow(lights=())))
    assert "No bench is open." in [one.text() for one in still.side.findChildren(QLabel) if one.isVisible()]
    lights = (("dut", "absent", ""), ("ref", "waiting", ""), ("stage", "ok", ""))
    still.show_state(LabState(bench="bench.toml", now=LabNow(lights=lights)))
    rows = [(row.mark.text(), row.age.text()) for row in still.side.rows if row.isVisible()]
    assert rows == [("○", "not asked"), ("…", "not heard yet"), ("✓", "")], "who answers has its mark alone"
    still.show_state(LabState(bench="bench.toml", now=LabNow(lights=(("dut", "ok", ""), ("stage", "ok", "")))))
    assert "all answer" in words_in(still.side)
    assert not any(row.age.isVisible() for row in still.side.rows), "said once"


def test_of_a_long_serial_the_beginning_is_seen_and_the_whole_is_in_its_tip(still):
    serial = "FM-2026-0000-1234-5678-SPARE-UNIT-B"
    still.app_state.set_identity(dut=serial)
    assert still.top.dut.cursorPosition() == 0
    assert still.top.dut.toolTip().startswith(serial)


def test_a_long_name_of_a_measurement_is_whole_in_its_tip(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    name = "closure, DUT less reference, of the first position after the last turn about the body's z"
    still.app_state.bench_worker.items.emit((Measurement(1.0, name, 3.0, 1.0, "nT", 50.0),))
    assert still.page("Run").live.table.item(0, 0).toolTip() == name


def test_axes_have_the_minus_sign_of_the_tables(still):
    axis = still.page("Run").live.traces.plot.getPlotItem().getAxis("left")
    assert axis.tickStrings([-200.0, 0.0], 1.0, 100.0) == [f"{MINUS}200", "0"]
    assert isinstance(axis, pg.AxisItem)


def test_the_morning_check_leads_to_a_page_of_that_name(still, qtbot):
    still.open_page("Start")
    still.page("Start").morning.click()
    choose = still.page("Run").choose
    assert choose.list.currentItem().text() == "axes-check"
    assert choose.heading.text() == "Morning check · axes-check"


def test_f1_lists_every_shortcut_there_is(still, qtbot):
    still.open_page("Run")
    qtbot.keyClick(still, Qt.Key.Key_F1)
    (sheet,) = still.findChildren(KeySheet)
    said = words_in(sheet)
    own = [one for one in still.findChildren(QShortcut) if one.parent().window() is still]  # Qt's dialogs have others
    made = {one.key() for one in own if not one.key().isEmpty()}
    assert {QKeySequence("F1"), QKeySequence("F11"), QKeySequence("Ctrl+7")} <= made
    assert {one.toString(QKeySequence.SequenceFormat.NativeText) for one in made} <= set(said)
    assert {"F12", "F8, F7, F6", "Tab"} <= set(said)
    sheet.close()


def test_a_report_is_opened_and_its_folder_is_offered(still, qtbot, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    still.open_page("Certificate")
    page, out = still.page("Certificate"), str(tmp_path / "r.html")
    page.paper.write_report("c.json", out)
    assert (opened, page.paper.folder.isHidden()) == ([], True)
    still.app_state.quick_worker.answer(WriteReport, out)
    assert (opened, page.paper.folder.isHidden()) == ([out], False)
    page.paper.folder.click()
    assert opened == [out, str(tmp_path)]


def test_an_exported_run_says_where_it_lies(still, qtbot, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr(QDesktopServices, "openUrl", lambda url: opened.append(url.toLocalFile()))
    still.open_page("History")
    page, out = still.page("History"), str(tmp_path / "r.zip")
    page.export_to(RUN, "bundle", out)
    still.app_state.quick_worker.answer(ExportRun, out)
    assert page.said.text() == f"Exported: {out}"
    qtbot.mouseClick(page.folder, Qt.MouseButton.LeftButton)
    assert opened == [str(tmp_path)]


@pytest.mark.slow
def test_a_small_screen_has_room_for_every_page_and_for_a_question_with_two_answers(new_window, qtbot):
    still = new_window
    for name in still.lazy_pages:
        still.page(name)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    drawing = {"body_from_cage": np.eye(3).tolist()}
    asked = Prompt(0.0, "mount-y", "Mount the DUT with body Y up.", ("done", "redo x"), True, drawing)
    still.app_state.bench_worker.items.emit((asked,))
    size = still.size()
    still.resize(1100, 700)
    QApplication.processEvents()
    least = still.minimumSizeHint()
    still.resize(size)
    assert (least.width() <= 1024, least.height() <= 700) == (True, True), least
