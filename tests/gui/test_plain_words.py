"""What a person reads while they work: news that is news, names in words, nothing cut where it can be helped."""

import numpy as np
import pytest
from lab_states import told
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLineEdit
from shiboken6 import delete

from labcal.bench.parameters import Limits, ParameterSpec
from labcal.errors import InputError
from labcal.gui.ipc.answers import Ended, FitFigures, Fitted
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault, fault_of
from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.number_format import needed_title, step_title
from labcal.gui.widgets.parameter_form import range_of
from labcal.gui.widgets.plots import Traces
from labcal.gui.widgets.study_plots import Residuals
from labcal.record import Segment
from labcal.record.stream import Event, Prompt, SegmentOpened, Step


def send(window, *items):
    window.app_state.bench_worker.items.emit(items)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("x-50uT-full", "x −50 µT full"),
        ("z+20uT-nominal: wrong signs", "z +20 µT nominal: wrong signs"),
        ("closure-x", "closure x"),
        ("mount-y", "body Y up"),
        ("mount-y: DUT less reference, first position", "body Y up: DUT less reference, first position"),
        ("zero", "offset and first position"),  # the coils are energised before that step ends
    ],
)
def test_a_step_is_said_in_words(name, words):
    assert step_title(name) == words


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("i_eps  A", "current i_eps  A"),
        ("temp_dut  degC", "temperature temp_dut  degC"),
        ("wheel  rpm", "channel wheel  rpm"),
        ("time  s", "time  s"),
    ],
)
def test_a_channel_is_drawn_against_in_words(qtbot, name, words):
    picture = Residuals(LIGHT)
    qtbot.addWidget(picture)
    picture.show_residual(name, np.ones(2), [], None)
    assert picture.plot.getPlotItem().getAxis("bottom").labelText == words


def test_no_curve_loses_its_name_at_the_top_of_a_picture(qtbot):
    traces = Traces(LIGHT, "DUT  nT")
    qtbot.addWidget(traces)
    traces.plot.setYRange(0.0, 100.0, padding=0)
    for _ in range(2):
        traces.show_rows(np.array([[0.0, 0.0, 50.0, 99.0], [1.0, 20.0, 98.0, 99.0]]))
    places = sorted(name.pos().y() for name in traces._names)
    low, high = traces.plot.viewRange()[1]
    assert low < places[0]
    assert places[-1] < high
    assert places[2] - places[1] > 0.1 * (high - low) * 14 / traces.plot.height()


def test_each_curve_has_its_name_beside_it_as_soon_as_it_is_drawn(qtbot):
    traces = Traces(LIGHT, "DUT  nT")
    qtbot.addWidget(traces)
    traces.resize(600, 160)
    traces.show()
    for ends in ([16e3, 1550.0, 13.9e3], [2.0, 3.0, -1.0]):  # a range of before says nothing
        traces.show_rows(np.array([[0.0, -ends[0], 0.0, 0.0], [1.0, *ends]]))
        low, high = traces.plot.viewRange()[1]
        assert [name.pos().y() for name in traces._names] == pytest.approx(ends, abs=0.15 * (high - low))


def test_a_mounting_is_needed_for_in_words():
    assert needed_title("mount-y") == "mount it with body Y up"
    assert needed_title("closing") == "mount it as at first"
    assert (step_title("position-7"), step_title("position 7")) == ("position 7", "position 7")


def test_a_small_limit_is_written_out():
    spec = ParameterSpec("u_time_s", "float", 0.005, limits=Limits(1e-6, 1e5, unit="s"))
    assert range_of(spec) == "0.000001 … 100000 s"


def test_an_answer_is_no_news_and_what_goes_on_is_said_without_a_loose_end(still):
    still.app_state.run.start(RunProcedure("axes-check", "bench.toml"))
    send(still, Prompt(1.0, "ready", "Hands off?", ("done",), True))
    still.app_state.run.answer("done")
    send(still, Event(1.1, "answer", "done", {"key": "ready"}))
    assert "done" not in still.app_state.lab.state.message
    live = still.page("Run").live
    live.draw()
    assert live.headline.text() == "Hands off"


def test_a_procedure_without_turns_shows_none_and_offers_no_fit(still):
    still.app_state.run.start(RunProcedure("axes-check", "bench.toml"))
    live = still.page("Run").live
    assert not any(part.isVisible() for part in (live.steps, live.lights, live.loci, live.turn.bar))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    assert (live.fit.isVisible(), live.close_run.isVisible()) == (False, True)
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    send(still, Step(0.0, 1, 2, "zero", 60.0, ("zero", "x+20uT-nominal", "closing"), 20.0))
    assert all(part.isVisible() for part in (live.steps, live.lights))
    assert not live.loci.isVisible()  # three empty circles: nothing turns yet
    assert not live.turn.bar.isVisible()  # of which axis?
    send(still, Step(20.0, 2, 3, "x+20uT-nominal", 40.0, (), 20.0))
    assert live.turn.bar.isVisible()
    assert live.loci.isVisible()


def test_what_stands_still_at_many_angles_has_no_lights_of_turns(still):
    still.app_state.run.start(RunProcedure("verify", "bench.toml"))
    names = ("mounting and zero", "position 1")
    send(still, Step(0.0, 1, 2, names[0], 60.0, names, 20.0), Step(20.0, 2, 2, names[1], 40.0, (), 40.0))
    send(still, SegmentOpened(21.0, Segment("position-1", "rotation")))
    live = still.page("Run").live
    live.draw()
    assert (live.loci.isVisible(), live.lights.isVisible(), live.turn.bar.isVisible()) == (True, False, False)
    assert live.headline.text() == "Hands off · 39 s simulated · position 1"


def test_a_dut_at_rest_has_no_circle_and_no_lights_of_turns(still):
    still.app_state.run.start(RunProcedure("field-sphere", "bench.toml"))
    live = still.page("Run").live
    send(still, Step(0.0, 1, 2, "zero", 60.0, ("zero", "shell-50"), 20.0), SegmentOpened(1.0, Segment("p1", "static")))
    assert (live.loci.isVisible(), live.steps.isVisible()) == (True, True)
    assert not any(part.isVisible() for part in (live.lights, live.turn.bar, live.turn.words))
    send(still, SegmentOpened(2.0, Segment("x-2dps-there", "rotation")))  # one that no step names
    assert all(part.isVisible() for part in (live.lights, live.turn.bar, live.turn.words))
    still.app_state.run.forget()
    assert not still.app_state.run.turns()


def test_who_stops_a_run_reads_how_it_stands_and_no_alarm(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    told(still)
    stopped = Fault("stopped", "stopped by the operator", "", "Traceback: …")
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped", stopped))
    card = still.page("Run").live.fault
    assert card.coils.text() == "✓ coils at zero"
    assert card.text.text().startswith("What was measured is kept")
    assert not card.save.isVisible()
    card.show_fault(Fault("instrument", "The reference is silent."))
    assert card.save.isVisible()


def test_a_serial_that_is_typed_takes_what_was_said_of_the_one_before_from_the_line_below(still):
    still.app_state.scan("WRONG!1")
    assert still.app_state.lab.state.message.startswith("✕ Scanned, and not taken: 'WRONG!1'")
    still.app_state.set_identity(dut="EM-08")
    assert still.app_state.lab.state.message == ""


def test_enter_after_the_serial_leads_to_the_operator(still, qtbot):
    still.top.dut.setFocus()
    qtbot.keyClick(still.top.dut, Qt.Key.Key_Return)
    assert still.top.operator.hasFocus()


def test_a_fault_names_the_file_and_keeps_its_path_for_the_details():
    fault = fault_of(InputError("does not open", file="/home/j/keys/j.doe.pem"))
    assert (fault.text, fault.details) == ("j.doe.pem: does not open", "/home/j/keys/j.doe.pem: does not open")


def test_the_names_of_parameters_stand_whole_beside_eleven_methods(still, qtbot):
    from labcal.gui.pages.fit import OFFSETS, QUALITY
    from labcal.gui.viewmodels.gain_words import GAINS, gain_name

    page = still.page("Fit")
    still.open_page("Fit")
    failed = Fitted(FitFigures(False, "diverged"))
    still.app_state.study_vm.fits = {f"method-number-{n}": failed for n in range(11)}
    still.app_state.study_vm.changed.emit()
    page.idle_queue.finish()
    names = (*QUALITY, *OFFSETS, *(gain_name(*gain) for gain in GAINS))
    widest = max(page.table.fontMetrics().horizontalAdvance(name) for name in names)
    assert page.table.columnWidth(0) >= widest


def test_what_is_typed_as_a_passphrase_is_never_taken_for_a_scan(still, qtbot, patience):
    still.open_page("Certificate")
    page = still.page("Certificate")
    secret = QLineEdit(page)
    secret.setEchoMode(page.steps.passphrase.echoMode())
    secret.show()
    secret.setFocus()
    qtbot.waitUntil(secret.hasFocus, timeout=patience)
    still.scanner.wait.setInterval(3_600_000)
    qtbot.keyClicks(secret, "correct horse")
    assert secret.text() == "correct horse"
    assert still.app_state.lab.state.dut_serial == "EM-07"
    delete(secret)


def test_a_plot_has_its_two_axes_and_no_more(qapp):
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.widgets.plots import plot

    item = plot(LIGHT, "time  s", "residual  nT").getPlotItem()
    shown = {side for side in ("left", "bottom", "right", "top") if item.getAxis(side).isVisible()}
    assert shown == {"left", "bottom"}


def test_how_a_run_ended_and_how_the_coils_are_is_said_once(still):
    """The verdict, the bar and the line below said "stopped", each in its place."""
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 2, "zero", 60.0, ("zero", "x+20uT-nominal"), 20.0))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "stopped"))
    live = still.page("Run").live
    live.draw()
    assert live.time_left.left.text() == ""
