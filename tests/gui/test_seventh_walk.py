"""What a stranger found: a doubt that nobody was told of, buttons that did nothing to see, cards that stayed."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QApplication
from test_path import calibration

from labcal.gui.ipc.messages import Approve, ListCalibrations, ListKeys
from labcal.gui.viewmodels.signing import ambiguity
from labcal.model.records import EffectRecord, Rival

RIVAL = Rival("offset-temperature", ("T_box",), 2.0)
DOUBTED = EffectRecord("offset-current", ("i_radio",), {}, "sensor", (), provisional=True, rivals=(RIVAL,))
SAID = "AMBIGUOUS: offset-current (i_radio) is provisional; offset-temperature (T_box) may be the cause as well."


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


@pytest.fixture
def page(new_window):
    new_window.resize(1360, 860)
    new_window.app_state.set_identity(dut="EM-07", operator="J. Doe")
    new_window.open_page("Certificate")
    return new_window.page("Certificate")


def settle():
    for _ in range(5):
        QApplication.processEvents()


def told(page, one):
    worker = page._app_state.quick_worker
    worker.answer(ListCalibrations, (one,))
    worker.answer(ListKeys, ("a.smith",))
    settle()


@pytest.mark.parametrize("stage", FILES)
def test_that_its_cause_is_not_certain_is_said_in_amber_from_draft_to_release(page, stage):
    one, word = FILES[stage]
    told(page, one)
    assert page.word.text() == f"{word}  ·  EM-07"
    assert page.word.property("state") == "warning"
    assert (page.doubt.text(), page.doubt.isVisible()) == (SAID, True)


def test_what_is_certain_is_released_in_green(page):
    told(page, standing(calibration(), "released"))
    assert page.word.text() == "✓ RELEASED  ·  EM-07"
    assert (page.word.property("state"), page.doubt.isHidden()) == ("good", True)
    assert not ambiguity(calibration())


def test_who_approves_what_is_ambiguous_is_asked_once(page):
    told(page, DRAFT)
    steps, asked = page.steps, page._app_state.quick_worker
    steps.approver.setCurrentText("a.smith")
    steps.approve.click()
    assert not asked.commands(Approve)
    assert steps.approval.asked.text() == f"{SAID} Approve it all the same?"
    assert steps.approve.text() == "Approve it all the same"
    steps.approve.click()
    assert [one.name for one in asked.commands(Approve)] == ["a.smith"]
    assert steps.approval.asked.isHidden()
