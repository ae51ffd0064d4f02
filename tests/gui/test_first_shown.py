"""What is shown for the first time is painted nowhere before it has its place."""

from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.record.stream import Step


def test_the_buttons_of_a_run_that_was_stopped_are_never_larger_than_buttons(new_window):
    run, worker, live = new_window.app_state.run, new_window.app_state.bench_worker, new_window.page("Run").live
    run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker.items.emit([Step(0.0, 1, 2, "x+20uT-nominal", 60.0, ("x+20uT-nominal", "closure-x"))])
    worker.answer(RunProcedure, Ended("r1", "stopped"))
    assert live.close_run.isVisible()
    assert live.close_run.size().isEmpty()  # no event has gone by, and nothing is painted over the steps
    QApplication.processEvents()
    assert live.close_run.size() == live.close_run.sizeHint()


def test_each_test_finds_the_window_in_its_first_size(still, rest):
    still.resize(1024, 700)
    assert rest(still).size() == still.size_at_first
