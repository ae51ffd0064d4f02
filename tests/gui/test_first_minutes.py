"""The first minutes of somebody new: what was clicked is seen to happen, and one thing is to be done at a time."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QApplication, QPushButton, QWidget

from labcal.gui.frame import Frame
from labcal.gui.ipc.answers import Ended, Identified, InstrumentAnswer, RunLine
from labcal.gui.ipc.messages import FindSimulatedBench, ReadBench, Rehearse, Rejoin, ResumeRun, RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.screen import show_whole
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.began import began_at
from labcal.gui.viewmodels.run_search import local_time
from labcal.gui.widgets import bench_chooser
from labcal.gui.widgets.plots import Traces, spread
from labcal.gui.widgets.run_chooser import run_title
from labcal.record.stream import Block, Step

ORDER = RunProcedure("preflight", "bench.toml")
RUN_ID, BEGAN_UTC = "20261128T011111-d087", "2026-11-28T01:11:11Z"


@pytest.mark.parametrize("page", ["Start", "Bench"])
def test_the_simulated_lab_is_seen_to_be_opened_from_the_click_on(same_window, qtbot, page):
    app_state = same_window.app_state
    app_state.facts = None
    same_window.open_page(page)
    there = same_window.page(page)
    [clicked] = [one for one in there.findChildren(QPushButton) if one.text() == "Simulated lab"]
    clicked.click()
    assert same_window.message.text() == "Opening the simulated lab …"
    app_state.quick_worker.answer(FindSimulatedBench, "lab/simulated.toml")
    assert same_window.message.text() == "Opening simulated.toml …"


def test_a_bench_that_cannot_be_opened_is_not_being_opened(still):
    still.app_state.open_bench("lab/none.toml")
    assert still.message.text() == "Opening none.toml …"
    [asked] = [one for one in still.app_state.quick_worker.asked if isinstance(one.command, ReadBench)]
    asked.failed(Fault("input", "there is no lab/none.toml"))
    assert still.message.text() == ""


@pytest.mark.parametrize("chosen", ["/lab/bench.toml", ""])
def test_who_is_to_open_a_bench_chooses_its_file_at_once(same_window, monkeypatch, chosen):
    """Start's button led to a second one of the same name."""
    monkeypatch.setattr(bench_chooser.QFileDialog, "getOpenFileName", lambda *_: (chosen, ""))
    same_window.app_state.facts = None
    same_window.app_state.lab.update(bench="")
    same_window.app_state.bench_changed.emit()
    same_window.open_page("Start")
    before = list(same_window.app_state.quick_worker.asked)
    same_window.page("Start").open.click()
    asked = [one.command for one in same_window.app_state.quick_worker.asked[len(before) :]]
    assert [one for one in asked if isinstance(one, ReadBench)] == ([ReadBench(chosen)] if chosen else [])


def test_no_field_moves_because_a_setting_is_another_or_the_plan_is_there(still):
    page = still.page("Run")
    still.open_page("Run")
    page.open_procedure("preflight")
    QApplication.processEvents()
    choose = page.choose
    assert choose.needs.text().splitlines()[1].startswith("About 48 min")
    lines = len(choose.needs.text().splitlines())
    choose.form.set_text("rate_deg_per_s", "20")
    assert choose.needs.text().splitlines()[1] == "The plan says how long this takes"
    choose.show_plan.setFocus()
    choose.show_plan.click()
    assert QApplication.focusWidget() is choose.give_up  # and not a field, selected
    still.app_state.bench_worker.answer(Rehearse, ("preflight", "about 4 min, without a person's steps"))
    assert "about 4 min" in choose.plan.text()
    assert len(choose.needs.text().splitlines()) == lines
    assert QApplication.focusWidget() is choose.show_plan


def test_the_bottom_line_ends_in_dots_where_it_has_no_room(still):
    def end_of(words):
        still.app_state.lab.update(message=words)
        QApplication.processEvents()
        place = QRect(still.message.mapTo(still, QPoint()), still.message.size())
        image = still.grab(place).toImage()

        right = range(image.width() - still.message.fontMetrics().horizontalAdvance("…"), image.width())
        return [image.pixelColor(x, y).name() for x in right for y in range(image.height())]

    assert set(end_of("short")) == {still.palette().color(QPalette.ColorRole.Base).name()}
    assert not still.message.is_cut()
    assert end_of("W" * 900) == end_of("i" * 900)  # the same dots, whatever is behind them
    assert still.message.is_cut()
    assert len(set(end_of("W" * 400))) > 1


def test_a_run_has_one_time_wherever_it_is_named(still):
    run = still.app_state.run
    run.start(ORDER)
    still.app_state.bench_worker.answer(RunProcedure, Ended(RUN_ID, "interrupted"))
    shown = still.page("Run").live.whose.text()
    listed = run_title(RunLine(RUN_ID, BEGAN_UTC, "interrupted", "EM-07", "J. Doe", "preflight"))
    assert run.began == f"{local_time(BEGAN_UTC):%Y-%m-%d %H:%M}"
    assert run.began in listed
    assert shown.endswith(run.began)
    run.resume(RUN_ID, ORDER)
    assert run.began == began_at(RUN_ID) != ""
    assert still.page("Run").live.whose.text().endswith(run.began)  # before anything has come of it
    still.app_state.bench_worker.answer(ResumeRun, Ended(RUN_ID, "finished"))


def test_a_simulated_run_says_so_in_every_list():
    one = RunLine("r1", BEGAN_UTC, "finished", "EM-07", "J. Doe", "preflight", simulated=True)
    assert "SIMULATED" in run_title(one)


def test_names_of_lines_that_meet_do_not_cover_each_other(qtbot):
    assert spread(np.array([5.0, 1.0, 1.2]), 2.0) == [5.0, 1.0, 3.0]
    traces = Traces(LIGHT, "nT")
    qtbot.addWidget(traces)
    traces.resize(600, 160)
    traces.show()
    rows = np.array([[t, 40_000.0 * t, 30.0 * t, -20.0 * t] for t in np.linspace(0.0, 1.0, 50)])
    traces.show_rows(rows)
    traces.plot.getPlotItem().getViewBox().updateAutoRange()
    traces.show_rows(rows)
    y, z = (traces.plot.getPlotItem().getViewBox().mapViewToDevice(name.pos()).y() for name in traces._names[1:])
    assert abs(y - z) >= 10


def test_no_line_is_drawn_over_the_time_that_a_sensor_was_away(qtbot):
    traces = Traces(LIGHT, "nT")
    qtbot.addWidget(traces)
    rows = np.array([[t, t, 2.0 * t, 3.0 * t] for t in (0.0, 0.5, 1.0, 40.0, 40.5)])
    traces.show_rows(rows)
    for axis, curve in enumerate(traces._curves):
        t_s, values = curve.getOriginalDataset()
        assert t_s.tolist() == [0.0, 0.5, 1.0, 1.0, 40.0, 40.5]
        assert np.flatnonzero(np.isnan(values)).tolist() == [3]
        assert values[~np.isnan(values)].tolist() == rows[:, 1 + axis].tolist()
    traces.show_rows(rows[:0])


class Screen:
    """One with this much room."""

    def __init__(self, width: int, height: int) -> None:
        self.room = QRect(0, 0, width, height)

    def availableGeometry(self) -> QRect:
        return self.room


@pytest.mark.parametrize(("high", "whole"), [(850, True), (899, True), (900, False), (1080, False)])
def test_no_edge_of_the_window_lies_beyond_the_screen(qtbot, monkeypatch, high, whole):
    window = QWidget()
    qtbot.addWidget(window)
    monkeypatch.setattr(window, "screen", lambda: Screen(1920, high), raising=False)
    window.resize(1360, 860)
    show_whole(window)
    assert bool(window.windowState() & Qt.WindowState.WindowMaximized) is whole


@pytest.mark.parametrize("remembered", [False, True])
def test_the_window_is_no_larger_than_a_small_screen_where_no_desktop_fills_it(still, monkeypatch, remembered):
    frame = Frame(still.app_state.lab, {"Start": QWidget()})
    frame.says_off = False
    if remembered:
        frame.resize(1920, 1000)
    monkeypatch.setattr(frame, "screen", lambda: Screen(1366, 768), raising=False)
    monkeypatch.setattr(frame, "showMaximized", frame.show)  # as on a desktop without a window manager
    show_whole(frame)
    assert (frame.isVisible(), frame.pos()) == (True, QPoint(0, 0))
    assert QRect(0, 0, 1366, 768).contains(frame.geometry())
    frame.close()


def test_begin_again_leaves_the_focus_on_the_page(still, qtbot, patience):
    """In the DUT's serial, selected, the next key would replace it."""
    still.open_page("Run")
    page, run = still.page("Run"), still.app_state.run
    run.start(ORDER)
    still.app_state.bench_worker.answer(RunProcedure, Ended(RUN_ID, "failed: no"))
    qtbot.waitUntil(page.live.close_run.isVisible, timeout=patience)
    page.live.close_run.setFocus()
    page.live.close_run.click()
    assert page.choose.isAncestorOf(QApplication.focusWidget())
    page.choose.list.setFocus()
    run.start(ORDER)
    assert page.live.isAncestorOf(QApplication.focusWidget())
    still.app_state.bench_worker.answer(RunProcedure, Ended(RUN_ID, "finished"))


def test_a_list_of_values_is_seen_from_its_beginning_to_its_end(still):
    page = still.page("Run")
    still.open_page("Run")
    page.open_procedure("field-sphere")
    QApplication.processEvents()
    field = page.choose.form.fields["magnitudes_nT"]
    assert field.text() == "20000, 35000, 50000"
    assert field.fontMetrics().horizontalAdvance(field.text()) < field.width() - 16
    assert field.cursorPosition() == 0


def test_a_reading_on_the_bench_page_is_the_sensors_own_and_as_old_as_it_is(still):
    """Temperatures that a DUT sends with its field are no field; that it answers makes no old reading new."""
    app_state = still.app_state
    page = still.page("Bench")
    name = next(n for n, one in app_state.facts.instruments.items() if one.role == "dut")
    axes, more = np.array([[1.0, 2.0, 3.0]]), np.array([[23.2, 24.0]])
    app_state.run.start(ORDER)
    app_state.bench_worker.items.emit((Block("dut", name, ("x", "y", "z"), np.array([1.0]), axes),))
    app_state.bench_worker.items.emit((Block("channel", name, ("temp_dut", "temp_board"), np.array([1.0]), more),))
    row = next(n for n in range(page.table.rowCount()) if page.table.text(n, 1) == name)
    page.show_readings()
    assert page.table.text(row, 4) == "+1.0  +2.0  +3.0 count"
    app_state.run.last.read_s[name] -= 51.0
    app_state.take_identified(Identified((InstrumentAnswer(name, "dut", "emulated://", "CSV lines"),)))
    page.show_readings()
    assert page.table.text(row, 4) == "+1.0  +2.0  +3.0 count   51 s ago"
    app_state.bench_worker.answer(RunProcedure, Ended(RUN_ID, "finished"))


def test_a_run_begins_when_its_record_does_and_a_window_that_comes_back_does_not_change_that(still, monkeypatch):
    times = iter(["2026-11-28 01:53", "2026-11-28 01:54"])
    monkeypatch.setattr("labcal.gui.viewmodels.began.now", lambda: next(times))
    run, worker = still.app_state.run, still.app_state.bench_worker
    run.start(ORDER)
    worker.items.emit((Step(0.0, 1, 1, "zero", 60.0, ("zero",)),))
    worker.items.emit((Step(1.0, 1, 1, "zero", 60.0, ("zero",)),))
    assert run.began == "2026-11-28 01:54"
    worker.answer(RunProcedure, Ended("r1", "finished"))
    run.come_back()
    run.began = "2026-11-28 01:54"
    worker.items.emit((Step(1.0, 1, 1, "zero", 60.0, ("zero",)),))
    assert run.began == "2026-11-28 01:54"
    worker.answer(Rejoin, Ended("r1", "finished"))
