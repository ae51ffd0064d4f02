"""At a question who is silent is said, and what may be answered is one rule: for buttons, keys, scans and Next."""

import pytest
from PySide6.QtCore import Qt
from test_hands_in_the_cage import MOUNT, READY, says, send, stands
from test_hands_in_the_cage import running as running

from labcal.record.stream import Prompt

SERIAL = Prompt(4.0, "serial-mount-z", "Scan the serial.", (), True, {"serial": "EM-07"})
FAILED = Prompt(5.0, "failed-zero", "dut: lost", ("stop", "retry", "skip"), drawing={"what": "dut: lost", "remedy": ""})


@pytest.fixture
def card(running):
    running.open_page("Run")
    return running.page("Run").live.prompt


def alive(card):
    card.alive = True
    card.say_lost(card._who)
    return card


@pytest.mark.parametrize("asked", [MOUNT, Prompt(2.0, "mode-full", "Switch it.", ("done",), True, {"mode": "full"})])
def test_who_is_silent_is_named_at_a_question_with_since_when_and_what_to_do(running, card, asked):
    send(running, asked)
    says(running, platform=stands(), faulty=("reference",))
    said = card.details.text()
    assert card.details.isVisibleTo(card)
    assert said.startswith("✕ No answer from reference (since ")
    assert "plug and power" in said
    assert "nothing is measured before it answers" in said
    says(running, platform=stands(), faulty=("reference",))
    assert card.details.text() == said  # no words that tick
    says(running, platform=stands())
    assert card.details.text() == "reference: answers again"


def next_of(window):
    return window.next.text() if window.next.isVisible() else ""


@pytest.mark.parametrize("asked", [MOUNT, READY, FAILED, SERIAL])
def test_next_asks_for_an_answer_where_one_is_taken(running, card, asked):
    send(running, asked)
    says(running, platform=stands())
    assert next_of(running) == "Next: Answer the question"


@pytest.mark.parametrize(
    ("asked", "lab"),
    [
        (MOUNT, {"currents": (0.0, 0.0, 0.4), "platform": stands()}),
        (SERIAL, {"currents": (0.0, 0.0, 0.4), "platform": stands()}),
        (READY, {"platform": stands(), "faulty": ("dut",)}),
        (FAILED, {"platform": stands(), "faulty": ("dut",)}),
    ],
)
def test_next_asks_for_no_answer_that_is_barred(running, card, asked, lab):
    send(running, asked)
    says(running, **lab)
    assert next_of(running) == ""  # on this page there is nothing to do but to wait
    running.open_page("Start")
    assert next_of(running) == "Next: See the run"


def test_nothing_is_scanned_or_typed_into_a_question_whose_answer_is_barred(running, card, qtbot):
    send(running, SERIAL)
    says(running, (0.0, 0.0, 0.4), platform=stands())
    alive(card).entry.setText("EM-07")
    qtbot.keyClick(card.entry, Qt.Key.Key_Return)
    running.app_state.scan("EM-07")
    assert running.app_state.run.prompt is SERIAL
    assert "EM-07" in running.app_state.lab.state.message
    says(running, platform=stands())
    running.app_state.scan("EM-07")
    assert running.app_state.run.prompt is None
