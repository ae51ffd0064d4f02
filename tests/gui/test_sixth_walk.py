"""What a stranger saw who walked through the window once more."""

from __future__ import annotations

import time
from dataclasses import replace

import numpy as np

from labcal.bench.coils.agreement import NO_AMBIENT
from labcal.bench.coils.state import CoilReading, LabState, PlatformReading, Witness, unread
from labcal.gui.ipc import bench_commands
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.ipc.messages import ResumeRun, RunProcedure
from labcal.gui.ipc.run_began import began_at
from labcal.gui.ipc.wire import Fault
from labcal.gui.widgets.hold_button import HoldButton
from labcal.record.stream import Prompt

UP = {"body_from_cage": np.eye(3).tolist(), "axis_cage": [0.0, 0.0, 1.0]}
STANDS = Prompt(1.0, "mounting-stands", "Is the DUT still mounted?", ("yes", "no"), True, UP)


def asked(window, prompt=STANDS):
    """The card of `prompt` in a run that goes on."""
    window.open_page("Run")
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    window.app_state.bench_worker.items.emit((prompt,))
    return window.page("Run").live.prompt


def test_beside_still_mounted_it_is_said_what_no_means_and_each_answer_has_a_key(still):
    card = asked(still)
    assert "No: mount it again first." in card.hint.text()
    assert "turns that were finished stay" in card.hint.text()
    assert [made.text() for made in card.choices.values()] == ["Yes   F8", "No   F7"]
    assert all(isinstance(made, HoldButton) for made in card.choices.values())


def test_a_simulated_bench_that_begins_anew_says_so_beside_the_first_question_alone(still):
    still.app_state.run.virtual_time = True
    still.open_page("Run")
    still.app_state.run.resume("r1", RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    worker, card = still.app_state.bench_worker, still.page("Run").live.prompt
    worker.items.emit((STANDS,))
    worker.states.emit(LabState(unread(), platform=PlatformReading(0.0, False, time.monotonic())))
    assert card.anew.isVisible()
    still.app_state.run.answer("yes")
    worker.items.emit((Prompt(2.0, "ready", "Hands off?", acts=True),))
    assert not card.anew.isVisible()


def test_a_window_that_comes_back_to_a_run_that_was_gone_on_with_says_when_the_run_began(monkeypatch):
    monkeypatch.setattr(bench_commands, "read_bench", lambda channel, asked: None)
    order = ResumeRun("20261128T060000-3f9c", "bench.toml", "EM-07", "20 times", None, "preflight", "J. Doe")
    assert bench_commands.going(None, order).began == began_at(order.run) != ""


def lab_with(current_A, angle_deg):
    """A state read just now, with this current in each coil."""
    now = time.monotonic()
    zero = abs(current_A) < 0.001
    coils = tuple(CoilReading(axis, None, current_A, zero, None, now) for axis in "xyz")
    return LabState(coils, platform=PlatformReading(angle_deg, not zero, now))


def test_the_table_of_bench_is_never_of_another_moment_than_the_panel(still):
    still.open_page("Bench")
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    page, worker = still.page("Bench"), still.app_state.bench_worker
    for current_A, angle_deg, words in ((0.161, 15.0, "+0.161 A"), (0.0, 0.0, "+0.000 A")):
        worker.states.emit(lab_with(current_A, angle_deg))
        table = {page.table.text(row, 0): page.table.text(row, 4) for row in range(page.table.rowCount())}
        assert table["coil x"] == words
        assert table["platform"].startswith(f"+{angle_deg:.1f}°")
        assert f"{angle_deg:.0f}°" in still.side.platform.text()


def test_that_hands_may_go_in_is_one_sentence_with_its_reason_and_nothing_is_amber_beside_it(still):
    card = asked(still, Prompt(1.0, "mount-x", "Mount it.", ("done",), True, UP))
    lab = lab_with(0.0, 0.0)
    still.app_state.bench_worker.states.emit(replace(lab, reference=Witness(why=NO_AMBIENT)))
    said = "● Hands may go in: coils read back at zero by their supplies; "
    assert card.hands.text() == f"{said}the reference has no ambient field to compare with yet · read 1 s ago"
    assert not card.lab.isVisible()
    assert still.side.zero_words.text().startswith("■ coils read back at zero by their supplies")
    assert still.side.zero_words.property("state") == ""
    asked_again = Prompt(2.0, "ready", "Hands off?", acts=True)
    still.app_state.bench_worker.items.emit((asked_again,))
    assert card.lab.isVisible(), "who stands back is told the whole of it"


def test_after_coils_off_what_it_has_reached_is_read_first_and_watched(still):
    asked(still, Prompt(1.0, "mount-x", "Mount it.", ("done",), True, UP))
    worker, live, state = still.app_state.bench_worker, still.page("Run").live, still.app_state
    state.off.order()
    at_zero = lab_with(0.0, 258.0)
    worker.states.emit(replace(at_zero, reference=Witness("agrees", "", read_s=time.monotonic())))
    fault = Fault("stopped", "aborted by the operator")
    worker.answer(RunProcedure, Ended("r1", "failed: aborted by the operator", fault))
    word = live.verdict.word.text().replace("\N{NO-BREAK SPACE}", " ")
    assert word == "✓ COILS OFF: coils at zero, platform stands"
    assert not live.verdict.serial.isVisible(), "it stands at the top"
    assert live.verdict.rule.text().startswith("■ STOPPED.")
    assert state.lab.state.message.startswith("EM-07 · ")
    assert state.lab.state.message.endswith(": stopped by COILS OFF")
    supplies = {name for name, one in state.facts.instruments.items() if one.role.startswith("coil-")}
    state.watch.look()
    (looked,) = state.watch_worker.commands(ReadLab)
    assert supplies <= set(looked.names)
    state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    state.watch.look()
    assert len(state.watch_worker.commands(ReadLab)) == 1, "the next run has the lab"
