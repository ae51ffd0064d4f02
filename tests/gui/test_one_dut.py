"""The top, the sidebar and Next are of the DUT to be measured; a page that shows another one's run says so."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from test_path import calibration, marks

from labcal.gui.ipc.answers import Ended, FitFigures, Fitted, Look, RunLine
from labcal.gui.ipc.messages import CloseLoop, ListCalibrations, ListMethods, ListRuns, LookAt, RunProcedure
from labcal.gui.standing import come_back
from labcal.gui.viewmodels.one_dut import KEPT
from labcal.gui.viewmodels.path import Next
from labcal.gui.widgets.run_chooser import run_name

OF_21 = RunLine("r21", "2026-11-22T01:00:00Z", "finished", "EM-21", "J. Doe", "preflight", verdict="explained")
OF_22 = RunLine("r22", "2026-11-22T02:00:00Z", "finished", "EM-22", "J. Doe", "preflight")


@pytest.fixture
def listed(still):
    """Two runs of two DUTs; EM-22 stands at the top."""
    still.open_page("History")
    still.page("History").search.clear()
    still.app_state.quick_worker.answer(ListRuns, (OF_22, OF_21))
    still.app_state.set_identity(dut="EM-22")
    return still


def open_from_history(window, run_id):
    history = window.page("History")
    row = next(row for row in range(history.table.rowCount()) if history.table.text(row, 6) == run_id)
    history.table.selectRow(row)
    history.open.click()


def test_looking_at_a_run_changes_nothing_of_the_dut_to_be_measured(listed, qtbot):
    """Begin measured the DUT that was mounted under the serial of a run that was looked at."""
    app_state, before = listed.app_state, marks(listed)
    open_from_history(listed, "r21")
    assert (listed.page_shown(), app_state.study_vm.run) == ("Fit", "r21")
    assert (listed.top.dut.text(), marks(listed)) == ("EM-22", before)
    assert app_state.path.next() == Next("Fit", "Fit the run", "r22")
    app_state.start("preflight", {})
    assert app_state.run.order.dut == "EM-22"
    app_state.run.forget()
    for page in ("Fit", "Loop"):
        listed.open_page(page)
        assert listed.shown_bar.isVisible()
        assert app_state.study_vm.run == "r21"
    words = listed.shown_bar.words.text()
    assert words == f"Shown: {run_name(OF_21)}. To be measured: EM-22; the marks at the left and Next are of it."
    listed.open_page("History")
    assert not listed.shown_bar.isVisible()
    listed.open_page("Fit")
    qtbot.mouseClick(listed.shown_bar.back, Qt.MouseButton.LeftButton)
    assert (listed.top.dut.text(), app_state.study_vm.run) == ("EM-22", "r22")
    assert not listed.shown_bar.isVisible()


def test_the_dut_that_is_shown_is_measured_only_where_that_is_said(listed, qtbot):
    open_from_history(listed, "r21")
    assert listed.shown_bar.take.text() == "Measure EM-21"
    qtbot.mouseClick(listed.shown_bar.take, Qt.MouseButton.LeftButton)
    assert (listed.top.dut.text(), listed.app_state.study_vm.run) == ("EM-21", "r21")
    assert listed.app_state.path.last() == OF_21
    assert not listed.shown_bar.isVisible()


def test_whose_run_it_is_may_be_known_later(listed):
    listed.app_state.path.take_runs(())
    listed.app_state.open_study("r21")
    assert not listed.shown_bar.isVisible()
    listed.app_state.fit_worker.answer(LookAt, Look("r21", "EM-21", 1, np.zeros((1, 3)), {}))
    assert (listed.shown_bar.isVisible(), listed.top.dut.text()) == (True, "EM-22")


def test_what_is_learned_of_the_store_later_switches_no_dut(same_window):
    """After a start the DUT of an interrupted run is proposed; one that another window leaves later is not."""
    app_state = same_window.app_state
    app_state.one_dut.stated = app_state.one_dut.proposed = False
    app_state.path.take_runs(())
    app_state.propose_dut()
    proposed = same_window.top.dut.text()
    app_state.path.take_runs((replace(OF_21, status="interrupted", simulated=True),))
    app_state.propose_dut()
    assert same_window.top.dut.text() == proposed


def test_a_dut_that_was_scanned_is_said(same_window):
    app_state = same_window.app_state
    app_state.one_dut.stated = app_state.one_dut.proposed = False
    app_state.scan("EM-55")
    app_state.scan_vm.take()
    assert app_state.settings.value(KEPT) == "EM-55"
    app_state.propose_dut()
    assert same_window.top.dut.text() == "EM-55"


def test_another_serial_at_the_top_lets_go_of_the_run_of_the_one_before(listed):
    open_from_history(listed, "r21")
    listed.app_state.set_identity(dut="EM-23")
    assert listed.app_state.study_vm.run == "r21"  # it is still being typed
    listed.top.dut.editingFinished.emit()
    assert listed.app_state.study_vm.run == ""
    assert listed.page("Fit").chooser.currentData() is None


def test_a_trace_goes_on_behind_another_dut_and_is_there_when_its_serial_is_typed_again(listed):
    app_state = listed.app_state
    study, worker = app_state.study_vm, app_state.fit_worker
    app_state.set_identity(dut="EM-21")
    listed.top.dut.editingFinished.emit()
    app_state.open_study("r21")
    study.fits["ml"] = Fitted(FitFigures(True))
    study.close_loop()
    app_state.set_identity(dut="EM-23")
    listed.top.dut.editingFinished.emit()
    assert (study.run, worker.killed, len(worker.commands(CloseLoop))) == ("", 0, 1)
    assert listed.app_state.lab.state.message == "EM-21: what is being computed goes on."
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-23", "J. Doe"))
    app_state.bench_worker.answer(RunProcedure, Ended("r23", "finished", None, ()))
    assert (worker.killed, len(worker.commands(CloseLoop))) == (0, 1)
    app_state.set_identity(dut="EM-21")
    listed.top.dut.editingFinished.emit()
    assert (study.run, study.traces, list(study.fits), marks(listed)[1:3]) == ("r21", True, ["ml"], "✓●")


def test_while_a_run_goes_on_its_dut_stays_and_any_run_may_be_looked_at(listed):
    listed.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-22", "J. Doe"))
    listed.app_state.open_study("r21")
    listed.open_page("Loop")
    assert (listed.top.dut.text(), listed.app_state.study_vm.run) == ("EM-22", "r21")


def test_a_window_that_is_started_again_after_a_crash_has_the_serial_that_was_said_last(same_window):
    same_window.app_state.set_identity(dut="EM-99")
    assert same_window.app_state.settings.value(KEPT) == "EM-99"
    same_window.app_state.one_dut.stated = False
    same_window.app_state.lab.update(dut_serial="")
    come_back(same_window, "Fit", "window-1.zip", ran=False)
    same_window.app_state.propose_dut()
    assert same_window.top.dut.text() == "EM-99"


def test_what_is_kept_of_a_run_is_said_where_it_is_opened_and_in_the_lists(listed):
    released = replace(calibration(), run_id="r21")
    released = replace(released, standing=replace(released.standing, status="released"))
    listed.page("History").refresh()
    listed.app_state.quick_worker.answer(ListRuns, (OF_22, replace(OF_21, left_nT=(41.2, 15.4, 15.1))))
    listed.app_state.quick_worker.answer(ListCalibrations, (released,))
    history = listed.page("History")
    assert [history.table.text(row, 5) for row in range(2)] == ["–", "✓ EXPLAINED · ✓ released"]
    history.search.setText("released")
    assert history.table.rowCount() == 1
    open_from_history(listed, "r21")
    listed.app_state.fit_worker.answer(LookAt, Look("r21", "EM-21", 1, np.zeros((1, 3)), {}))
    listed.app_state.fit_worker.answer(ListMethods, ("ml",))
    fit, loop = listed.page("Fit"), listed.page("Loop")
    for page in (fit, loop):
        figures = "✓ EXPLAINED · 41.2 → 15.4 nT rms of the vector, noise alone 15.1 nT rms"
        assert f"Kept of this run: {figures}" in page.empty.text()
        assert "✓ released" in page.empty.text()
    assert loop.close_loop.text() == "Work it out again"
    listed.app_state.path.take_handed_out(released)
    assert listed.app_state.path.stands("r21") == "✓ handed out"
    listed.open_page("Start")
    listed.app_state.quick_worker.answer(ListRuns, (OF_21,))
    assert listed.page("Start").runs.text(0, 3).endswith("✓ handed out")


def test_the_certificate_is_of_the_dut_at_the_top(listed):
    mine, other = (
        calibration(),
        replace(calibration(), path="other.json", dut=replace(calibration().dut, serial="EM-22")),
    )
    listed.open_page("Certificate")
    page, worker = listed.page("Certificate"), listed.app_state.quick_worker
    worker.answer(ListCalibrations, (mine, other))
    assert page.chosen() == other
    page.list.setCurrentIndex(0)  # looked at: it stays, and the bar says whose it is
    assert (listed.shown_bar.isVisible(), listed.top.dut.text()) == (True, "EM-22")
    page.refresh()
    worker.answer(ListCalibrations, (mine, other))
    assert page.chosen() == mine
    listed.shown_bar.back.click()
    worker.answer(ListCalibrations, (mine, other))
    assert (page.chosen(), listed.shown_bar.isVisible()) == (other, False)
    listed.app_state.set_identity(dut="EM-23")
    page.refresh()
    worker.answer(ListCalibrations, (mine, other))
    assert (page.chosen(), page.list.isVisible(), "EM-23" in page.empty.text()) == (None, True, True)


def test_the_certificate_is_that_of_the_run_that_is_shown(listed):
    mine = replace(
        calibration(signed=False), path="mine.json", run_id="r22", dut=replace(calibration().dut, serial="EM-22")
    )
    other = replace(calibration(), run_id="r21", dut=replace(calibration().dut, serial="EM-21"))
    open_from_history(listed, "r21")
    listed.open_page("Certificate")
    page, worker = listed.page("Certificate"), listed.app_state.quick_worker
    worker.answer(ListCalibrations, (mine, other))
    assert (page.chosen(), listed.shown_bar.isVisible(), marks(listed)[3]) == (other, True, "○")
    listed.shown_bar.back.click()
    worker.answer(ListCalibrations, (mine, other))
    assert (page.chosen(), listed.shown_bar.isVisible()) == (mine, False)


def test_the_count_and_the_run_are_said_alike_on_every_page(listed):
    """Start, Fit, Loop, Certificate and History: one number, and one name of a run, its DUT first."""
    worker, name = listed.app_state.quick_worker, run_name(OF_21)
    released = replace(calibration(), run_id="r21")
    released = replace(released, dut=replace(released.dut, serial="EM-21"))
    history = listed.page("History")
    assert history.card.unit.text() == "2 in the store"
    history.search.setText("EM-21")
    assert history.card.unit.text() == "1 of 2 in the store"
    history.search.clear()
    assert name.startswith("EM-21 · ")
    listed.open_page("Start")
    worker.answer(ListRuns, (OF_22, OF_21))
    start = listed.page("Start")
    assert start.counted.text() == "2 in the store"
    assert [start.runs.text(row, 1) for row in range(2)] == ["EM-22", "EM-21"]
    assert start.runs.item(1, 1).toolTip().startswith(name)
    listed.open_page("Certificate")
    worker.answer(ListCalibrations, (released,))
    assert listed.page("Certificate").list.itemText(0).endswith(name)
    for page in ("Fit", "Loop"):
        listed.open_page(page)
        worker.answer(ListRuns, (OF_22, OF_21))
        assert listed.page(page).chooser.itemText(1).endswith(name)


@pytest.mark.parametrize(("status", "simulated", "dut"), [
    ("interrupted", True, "EM-21"),
    pytest.param("finished", True, "SIM-0001", marks=pytest.mark.slow),
    pytest.param("interrupted", False, "SIM-0001", marks=pytest.mark.slow),
])  # fmt: skip
def test_until_somebody_says_which_the_dut_is_that_of_the_run_to_be_gone_on_with(same_window, status, simulated, dut):
    app_state = same_window.app_state
    app_state.one_dut.stated = app_state.one_dut.proposed = False
    app_state.path.take_runs((replace(OF_21, status=status, simulated=simulated),))
    app_state.propose_dut()
    assert same_window.top.dut.text() == dut
    app_state.set_identity(dut="EM-44")
    app_state.propose_dut()
    assert same_window.top.dut.text() == "EM-44"
