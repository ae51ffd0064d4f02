"""The line below says nothing that is past: about Next, about the window, about a run that has finished."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QSize
from PySide6.QtWidgets import QApplication
from test_path import RUN, calibration

from labcal.gui.ipc.answers import Ended, Look
from labcal.gui.ipc.messages import ListMethods, LookAt, RunProcedure
from labcal.gui.pages import certificate
from labcal.gui.translations.sentences import form_of


def test_what_next_has_become_is_past_once_it_has_become_another(still):
    still.app_state.path.take_runs((RUN,))
    still.next.too_soon.emit()
    assert still.message.text().endswith("It is now: Fit the run. Press it again.")
    still.app_state.path.changed.emit()
    assert still.message.text()  # true still
    still.app_state.path.take_calibrations((calibration(signed=False),))
    assert still.next.following == "Trace the residual"
    assert still.message.text() == ""


def test_what_next_has_become_is_past_once_it_is_pressed(still):
    still.next.too_soon.emit()
    assert still.message.text()
    changed = still.message.text()
    still.next.click()
    assert still.message.text() != changed


@pytest.mark.parametrize("how", ["another page", "another size"])
def test_that_there_is_no_room_for_larger_letters_leaves(new_window, how):
    new_window.resize(1024, 700)
    new_window.show()
    QApplication.processEvents()
    new_window.toggle_wall()
    assert new_window.message.text().startswith("The window has no room for larger letters")
    new_window.open_page("Bench") if how == "another page" else new_window.resize(new_window.size() + QSize(90, 60))
    QApplication.processEvents()
    assert new_window.message.text() == ""


@pytest.mark.parametrize(("status", "stays"), [("finished", False), ("failed: dut is silent", True)])
def test_that_a_run_has_finished_is_past_on_another_page(still, status, stays):
    still.open_page("Run")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r9", status))
    assert "preflight: " in still.message.text()
    still.open_page("Fit")
    still.app_state.run.changed.emit()
    assert bool(still.message.text()) is stays


def test_a_run_that_was_fitted_and_never_traced_is_traced_by_one_name_on_every_page(still):
    path, loop, start = still.app_state.path, still.page("Loop"), still.page("Start")
    path.take_runs((RUN,))
    path.take_calibrations((calibration(signed=False),))
    still.app_state.study_vm.open("r1")
    still.app_state.fit_worker.answer(LookAt, Look("r1", "EM-07", 1, np.zeros((1, 3)), {}))
    still.app_state.fit_worker.answer(ListMethods, ("ml",))
    assert loop.empty.text().startswith("Trace the residual of this run to its cause.\nKept of this run: offset k")
    names = {loop.close_loop.text(), start.go_on.text(), still.next.following}
    assert names == {"Trace the residual"}
    path.take_runs((replace(RUN, verdict="explained"),))
    still.app_state.study_vm.changed.emit()
    assert loop.close_loop.text() == "Work it out again"


def test_how_far_it_is_worked_out_again_is_said_in_the_windows_language(still, monkeypatch):
    page = still.page("Certificate")
    monkeypatch.setattr(certificate, "in_words", lambda sentence: f"in words: {sentence}")
    still.app_state.quick_worker.progress.emit("working the calibration out again: fitting by ml")
    assert page.said.text() == "in words: working the calibration out again: fitting by ml"
    assert form_of("working the calibration out again: fitting by ml")
    assert form_of("fitting by ml")
