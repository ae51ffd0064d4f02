"""What acts on the lab is a click or its own key held; Enter, Space and a short press are nothing."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from labcal.gui.ipc.messages import Answer, RunProcedure
from labcal.record.stream import Prompt

ACTS = Prompt(1.0, "ready", "The coils go to 50 µT. Hands off?", ("done", "redo x"), True)


@pytest.fixture
def asked(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml"))
    still.app_state.bench_worker.items.emit((ACTS,))
    return still.page("Run").live.prompt


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
    assert still.app_state.bench_worker.said == [Answer("ready", "done")]
