"""What acts on the lab is a click or its own key held; Enter, Space and a short press are nothing.

No second click, and no key that stays down, answers the next question: each is dead for its first second.
"""

import time

import pytest
from lab_states import told
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog

from labcal.gui.ipc.messages import Answer, RunProcedure
from labcal.gui.viewmodels.may_answer import moves_by_itself
from labcal.gui.widgets import hold_button, prompt_card
from labcal.gui.widgets.hold_button import LET_GO_MS
from labcal.record.stream import Prompt

LAB_DEAD_MS = prompt_card.DEAD_MS
PRESS, RELEASE = QEvent.Type.KeyPress, QEvent.Type.KeyRelease

ACTS = Prompt(1.0, "ready", "The coils go to 50 µT. Hands off?", ("done", "redo x"), True)


@pytest.fixture
def asked(qtbot, still, patience):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((ACTS,))
    card = still.page("Run").live.prompt
    qtbot.waitUntil(lambda: card.alive, timeout=patience)
    return card


def test_enter_space_and_a_short_press_answer_nothing(qtbot, still, asked, patience):
    button = asked.choices["done"]
    button.setFocus()
    for key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
        qtbot.keyClick(button, key)
    assert not button.held.isActive()
    qtbot.keyPress(still, button.key)
    assert button.held.isActive()
    button.held.setInterval(3_600_000)  # nothing is confirmed by a clock
    qtbot.keyRelease(still, button.key)
    qtbot.waitUntil(lambda: not button.held.isActive(), timeout=patience)
    assert "too early" in asked.hint.text()
    assert (still.app_state.run.state, still.app_state.bench_worker.said) == ("asking", [])


def test_words_without_a_drawing_have_the_whole_card_and_a_tap_moves_none_of_them(qtbot, still, asked, patience):
    card = still.page("Run").live.prompt
    told(still, (0.0, 0.0, 0.0))  # the line about the coils stands from the beginning
    QApplication.processEvents()
    assert card.text.width() > 0.9 * (card.width() - 2 * card.body.spacing())
    before = card.text.geometry(), card.text.font().pointSize()
    qtbot.keyClick(still, Qt.Key.Key_F8)
    qtbot.waitUntil(lambda: card.hint.text().startswith("▲"), timeout=patience)
    QApplication.processEvents()
    assert (card.text.geometry(), card.text.font().pointSize()) == before


def test_its_own_key_held_answers_whatever_has_the_focus(qtbot, still, asked, patience):
    assert asked.choices["done"].held.interval() == 700
    still.top.operator.setFocus()
    qtbot.keyPress(still.top.operator, asked.choices["done"].key)
    qtbot.waitUntil(lambda: still.app_state.run.state == "running", timeout=patience)
    assert still.app_state.bench_worker.said == [Answer("ready", "done")]


def test_to_redo_an_axis_acts_too_and_has_a_key_of_its_own(asked):
    redo = asked.choices["redo x"]
    assert redo.text().startswith("Redo axis X")
    assert redo.key != asked.choices["done"].key


def test_a_key_that_repeats_by_letting_go_for_a_blink_is_held(qtbot, still, asked, patience):
    button = asked.choices["done"]
    button.held.setInterval(3_600_000)
    button.let_go.setInterval(3_600_000)
    qtbot.keyPress(still, button.key)
    for _ in range(5):
        qtbot.keyRelease(still, button.key)
        qtbot.keyPress(still, button.key)
    assert button.held.isActive()
    assert not button.let_go.isActive()
    qtbot.waitUntil(lambda: button.filled() > 0, timeout=patience)
    button.held.timeout.emit()
    qtbot.waitUntil(lambda: still.app_state.run.state == "running", timeout=patience)
    assert still.app_state.bench_worker.said == [Answer("ready", "done")]


# the second in which a question takes no answer, and the key that stays down

ENERGISES = Prompt(2.0, "ready", "The coils go to 50 µT and the platform turns. Hands off?", ("done",), True)
SWITCH = Prompt(1.0, "mode-nominal", "Switch the DUT to power mode nominal.", ("done",), True, {"mode": "nominal"})


@pytest.fixture
def for_a_second(monkeypatch):
    """The dead time as it is in the lab."""
    monkeypatch.setattr(prompt_card, "DEAD_MS", LAB_DEAD_MS)


@pytest.fixture
def switched(still, for_a_second):
    """A question whose answer is followed by the next one at once, as a run does."""
    worker, card = still.app_state.bench_worker, still.page("Run").live.prompt
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    worker.items.emit((SWITCH,))
    follows = card.answered.connect(lambda _: QTimer.singleShot(0, lambda: worker.items.emit((ENERGISES,))))
    yield card
    card.disconnect(follows)


def answers(still):
    return [word.key for word in still.app_state.bench_worker.said if isinstance(word, Answer)]


@pytest.mark.parametrize("apart_ms", [0, 120, 400])
def test_a_double_click_answers_one_question_and_the_next_is_dead_for_a_second(
    qtbot, still, switched, patience, apart_ms
):
    first = switched.choices["done"]
    qtbot.waitUntil(first.isEnabled, timeout=patience)
    place = first.mapTo(still, first.rect().center())
    qtbot.mouseClick(first, Qt.MouseButton.LeftButton)
    asked_s = time.monotonic()
    qtbot.wait(apart_ms)
    there = still.childAt(place)
    qtbot.mouseDClick(there, Qt.MouseButton.LeftButton, pos=there.mapFrom(still, place))
    qtbot.waitUntil(lambda: still.app_state.run.prompt is ENERGISES, timeout=patience)
    assert answers(still) == ["mode-nominal"]
    qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)
    assert time.monotonic() - asked_s > 0.95
    assert answers(still) == ["mode-nominal"]


def test_a_press_that_began_on_a_dead_button_answers_nothing_when_it_ends_on_a_live_one(
    qtbot, still, switched, patience
):
    button = switched.choices["done"]
    assert not button.isEnabled()
    QTest.mousePress(button, Qt.MouseButton.LeftButton)
    QTest.keyPress(still, button.key)
    qtbot.waitUntil(button.isEnabled, timeout=patience)
    QTest.mouseRelease(button, Qt.MouseButton.LeftButton)
    assert not button.held.isActive()
    qtbot.wait(50)
    assert answers(still) == []


def test_a_click_while_the_window_stood_still_is_heard_by_a_dead_button(qtbot, still, switched, patience):
    button = switched.choices["done"]
    qtbot.waitUntil(switched.dead.isActive, timeout=patience)
    switched.dead.stop()
    switched.dead.timeout.emit()  # the timer is due, and what was clicked before waits to be heard
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert answers(still) == []
    qtbot.waitUntil(button.isEnabled, timeout=patience)


def test_a_question_that_is_seen_again_is_dead_again(qtbot, still, switched, patience):
    qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)
    still.open_page("Start")
    still.open_page("Run")
    assert not switched.choices["done"].isEnabled()
    qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)


def test_what_energises_is_held_by_mouse_as_well_and_a_click_says_so(qtbot, still, asked, patience):
    button = asked.choices["done"]
    qtbot.waitUntil(button.isEnabled, timeout=patience)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    assert "too early" in asked.hint.text()
    assert answers(still) == []
    qtbot.mousePress(button, Qt.MouseButton.LeftButton)
    qtbot.mouseMove(button, button.rect().bottomRight() + QPoint(20, 20))
    QApplication.sendEvent(button, away(button))
    assert not button.held.isActive()
    began_s = time.monotonic()
    qtbot.mousePress(button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: bool(answers(still)), timeout=patience)
    assert time.monotonic() - began_s > 0.65


def away(button):
    """The mouse, pressed, beyond the button's edge."""
    at, left = QPointF(-5, -5), Qt.MouseButton.LeftButton
    return QMouseEvent(
        QEvent.Type.MouseMove, at, button.mapToGlobal(at), Qt.MouseButton.NoButton, left, Qt.KeyboardModifier.NoModifier
    )


def test_what_a_person_has_done_is_said_by_a_click(asked):
    assert asked.choices["done"].held_by_mouse
    assert not asked.choices["redo x"].held_by_mouse
    asked.show_prompt(SWITCH)
    assert not asked.choices["done"].held_by_mouse
    assert moves_by_itself(Prompt(1.0, "failed-x", "", ("retry", "stop"), True), "retry")


@pytest.mark.parametrize("marked", [True, False])  # X11 marks what it repeats, where press and release come together
def test_one_long_hold_answers_one_question_and_fills_nothing_before_the_key_was_let_go(
    qtbot, still, switched, patience, marked
):
    qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)
    strike(still, QEvent.Type.KeyPress)
    qtbot.wait(660)  # then a keyboard repeats
    ends_s = time.monotonic() + 3.0
    while time.monotonic() < ends_s:
        strike(still, QEvent.Type.KeyRelease, marked)
        strike(still, QEvent.Type.KeyPress, marked)
        qtbot.wait(40)
        if answers(still):
            assert not switched.choices["done"].held.isActive()
    assert answers(still) == ["mode-nominal"]
    assert switched.choices["done"].isEnabled()
    strike(still, QEvent.Type.KeyRelease)
    qtbot.wait(LET_GO_MS + 50)
    assert answers(still) == ["mode-nominal"]
    strike(still, QEvent.Type.KeyPress)
    assert switched.choices["done"].held.isActive()
    qtbot.waitUntil(lambda: answers(still) == ["mode-nominal", "ready"], timeout=patience)


def strike(still, kind, repeated=False):
    QApplication.sendEvent(still, QKeyEvent(kind, Qt.Key.Key_F8, Qt.KeyboardModifier.NoModifier, "", repeated))


def test_a_key_that_is_held_searches_nothing_of_the_window(still, asked, monkeypatch):
    """It comes thirty times a second, to the focus and to all that this stands in: readings wait behind it."""
    searched = []
    monkeypatch.setattr(type(still), "findChildren", lambda *asked: searched.append(asked) or [])
    for kind, repeated in ((QEvent.Type.KeyPress, False), *[(one, True) for one in (RELEASE, PRESS) * 3]):
        strike(still, kind, repeated)
    strike(still, QEvent.Type.KeyRelease)
    assert asked.choices["done"].isVisible()
    assert searched == []


@pytest.mark.parametrize("inside", [True, False])  # of a dialog that stands on a part of the window, or on itself
def test_a_question_that_is_covered_is_not_answered_by_its_key(qtbot, still, asked, patience, inside):
    qtbot.waitUntil(asked.choices["done"].isEnabled, timeout=patience)
    dialog = QDialog(still.top if inside else still)
    dialog.show()
    strike(still, QEvent.Type.KeyPress)
    assert not asked.choices["done"].held.isActive()
    dialog.close()
    hold_button.heard_ms.clear()
    strike(still, QEvent.Type.KeyPress)
    assert asked.choices["done"].held.isActive()


def test_a_key_that_is_down_from_before_is_told_to_be_let_go(qtbot, still, switched, patience):
    strike(still, PRESS, repeated=True)  # its press went to what was there before
    assert switched.hint.text().startswith("▲ Let go of F8")
    strike(still, RELEASE)
    hold_button.heard_ms.clear()
    qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)
    strike(still, PRESS)
    assert switched.choices["done"].held.isActive()


@pytest.mark.parametrize("seen", ["its release", "a press anew", "another window"])
def test_that_a_key_is_down_is_not_said_longer_than_it_is_known(qtbot, still, switched, patience, seen):
    """It stood there for half a minute after F8 was let go; and where its release went elsewhere, for good."""
    usual = switched.hint.text()
    for kind in (PRESS, RELEASE, PRESS):  # as X11 repeats a key that stays down
        strike(still, kind, repeated=True)
    assert switched.hint.text().startswith("▲ Let go of F8")
    if seen == "its release":
        strike(still, RELEASE)
        strike(still, PRESS)  # a blink: it is down
        qtbot.wait(2 * LET_GO_MS)
        assert switched.hint.text().startswith("▲ Let go of F8")
        strike(still, RELEASE)
    elif seen == "a press anew":
        qtbot.waitUntil(switched.choices["done"].isEnabled, timeout=patience)
        hold_button.heard_ms.clear()
        strike(still, PRESS)
        assert switched.choices["done"].held.isActive()
    else:
        QApplication.sendEvent(switched.choices["done"], QEvent(QEvent.Type.ActivationChange))
    qtbot.waitUntil(lambda: switched.hint.text() == usual, timeout=patience)


def test_presses_that_came_too_soon_keep_no_question_from_its_answer(qtbot, still, switched, patience):
    asked_s = time.monotonic()
    while not switched.choices["done"].isEnabled() and time.monotonic() - asked_s < patience / 1000:
        strike(still, PRESS)
        qtbot.wait(LET_GO_MS + 20)
        strike(still, RELEASE)
        qtbot.wait(LET_GO_MS + 20)
    assert switched.choices["done"].isEnabled()
    assert time.monotonic() - asked_s < 3 * LAB_DEAD_MS / 1000
