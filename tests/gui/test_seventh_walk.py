"""What a stranger found: a doubt that nobody was told of, buttons that did nothing to see, cards that stayed."""

import time
from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from test_certificate_steps import page as page
from test_certificate_steps import settle, told
from test_choose import looked_at, told_by_the_loop
from test_hands_in_the_cage import lab, says, stands
from test_path import RUN, calibration

from labcal.bench.coils.state import Heard
from labcal.bench.links.heard_before import PLUG
from labcal.gui.ipc.answers import Ended, FitFigures, Fitted
from labcal.gui.ipc.messages import Approve, CloseLoop, LookAt, RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.signing import doubts
from labcal.gui.widgets import next_button
from labcal.model.records import EffectRecord, Rival

RIVAL = Rival("offset-temperature", ("T_box",), 2.0)
DOUBTED = EffectRecord("offset-current", ("i_radio",), {}, "sensor", (), provisional=True, rivals=(RIVAL,))
SAID = "AMBIGUOUS, the cause is not certain: offset-current (i_radio). It may be another: offset-temperature (T_box)."


def in_doubt(one):
    return replace(one, effects=(DOUBTED,), approvers=("a.smith",) if one.standing.signatures else ())


def standing(one, status):
    return replace(one, standing=replace(one.standing, status=status))


DRAFT = in_doubt(standing(calibration(signed=False), "unsigned"))
FILES = {
    "draft": (DRAFT, "○ DRAFT · AMBIGUOUS"),
    "approved": (replace(DRAFT, approvers=("a.smith",)), "○ DRAFT · AMBIGUOUS"),
    "released": (in_doubt(standing(calibration(), "released")), "▲ RELEASED · AMBIGUOUS"),
}


@pytest.mark.parametrize("stage", FILES)
def test_that_its_cause_is_not_certain_is_said_in_amber_from_draft_to_release(page, stage):
    one, word = FILES[stage]
    told(page, one, "a.smith")
    assert page.word.text() == f"{word}  ·  EM-07"
    assert page.word.property("state") == "warning"
    assert (page.doubt.text(), page.doubt.isVisible()) == (SAID, True)


def test_what_is_certain_is_released_in_green(page):
    told(page, standing(calibration(), "released"), "a.smith")
    assert page.word.text() == "✓ RELEASED  ·  EM-07"
    assert (page.word.property("state"), page.doubt.isHidden()) == ("good", True)
    assert not doubts(calibration())


def test_who_approves_what_is_ambiguous_is_asked_once(page):
    told(page, DRAFT, "a.smith")
    steps, asked = page.steps, page._app_state.quick_worker
    steps.approver.setCurrentText("a.smith")
    steps.approve.click()
    assert not asked.commands(Approve)
    assert steps.approval.asked.text() == f"{SAID} Approve it all the same?"
    assert steps.approve.text() == "Approve it all the same"
    steps.approve.click()
    assert [one.name for one in asked.commands(Approve)] == ["a.smith"]
    assert steps.approval.asked.isHidden()


@pytest.mark.parametrize("procedure", ["reverse", None])  # with a button for the measurement, and without one
def test_next_scrolls_to_what_is_not_known(new_window, qtbot, procedure):
    new_window.resize(1280, 480)
    app_state = new_window.app_state
    app_state.set_identity(dut="EM-07", operator="J. Doe")
    new_window.open_page("Loop")
    page, study, worker = new_window.page("Loop"), app_state.study_vm, app_state.fit_worker
    app_state.path.take_runs((replace(RUN, verdict="ambiguous"),))
    study.open("r1")
    worker.answer(LookAt, looked_at("r1"))
    study.close_loop()
    worker.answer(CloseLoop, told_by_the_loop(procedure))
    study.fits["ml"] = Fitted(FitFigures(True))
    study.changed.emit()
    settle()
    area = new_window.lazy_pages["Loop"].area
    wanted = page.next if procedure else page.unknown

    def in_sight():
        top = wanted.mapTo(area.viewport(), QPoint(0, 0)).y()
        return top >= 0 and top + wanted.height() <= area.viewport().height()

    wanted.setFocus()  # it may have it already
    area.verticalScrollBar().setValue(0)
    assert not in_sight()
    assert new_window.next.text() == "Next: See what is not known"
    qtbot.mouseClick(new_window.next, Qt.MouseButton.LeftButton)
    assert in_sight()
    assert wanted.hasFocus()


def test_next_takes_no_press_that_was_meant_for_what_it_said_before(still, qtbot, monkeypatch):
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 60_000)
    still.open_page("History")
    done = []
    still.next.clicked.connect(lambda: done.append(still.next.text()))
    still.app_state.path.take_runs((RUN,))  # Calibrate … was said before
    said = "Next has just changed, and did nothing. It is now: Fit the run. Press it again."
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert (done, still.app_state.lab.state.message) == ([], said)
    still.app_state.lab.update(message="")
    still.next.press()  # by Ctrl+N
    assert (done, still.app_state.lab.state.message) == ([], said)
    monkeypatch.setattr(next_button, "TOO_SOON_MS", 0)
    qtbot.mouseClick(still.next, Qt.MouseButton.LeftButton)
    assert done
    still.app_state.path.take_runs(())


@pytest.fixture
def lost(still):
    """The Run page after a run that an instrument ended, which may be gone on with."""
    app_state = still.app_state
    app_state.path.resumable = frozenset({"preflight"})
    app_state.facts = replace(app_state.facts, virtual_time=False)
    still.open_page("Run")
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    fault = Fault("instrument", "supply_z (tcp://lab:1): no reply in 1.5 s.", PLUG)
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", fault))
    return still


def test_go_on_is_not_the_blue_button_while_an_instrument_is_silent(lost):
    live = lost.page("Run").live
    says(lost, (0.0, 0.0, None), stands(), ("supply_z",))
    assert live.go_on.isVisible()
    assert live.go_on.objectName() == ""
    says(lost, (0.0, 0.0, 0.0), stands())
    assert live.go_on.objectName() == "primary"


def test_a_card_of_an_instrument_goes_once_it_answers_again_and_sends_nobody_to_mend_it(lost):
    live = lost.page("Run").live
    assert live.fault.isVisible()
    says(lost, (0.0, 0.0, None), stands(), ("supply_z",))
    assert lost.app_state.warning_shown  # the red card of its coil stands in its place
    assert live.verdict.next.text().startswith("Mend what is said above")
    answering = replace(lab(platform=stands()), instruments=(Heard("supply_z", time.monotonic()),))
    lost.app_state.bench_worker.states.emit(answering)
    assert not live.fault.isVisible()
    assert (live.verdict.reason.text(), live.verdict.reason.property("state")) == ("supply_z: answers again", "")
    assert live.verdict.next.text() == "Nothing was measured: Go on begins with the first step."
    says(lost, (0.0, 0.0, None), stands(), ("supply_z",))
    assert lost.app_state.warning_shown  # the red card of its coil stands in its place
