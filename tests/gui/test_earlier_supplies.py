"""What an earlier session left at other links has no row, and a panel that fails freezes no number."""

import sys
import time
from dataclasses import replace

import pytest
from lab_states import silent
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel
from test_off_unanswered import ends

from labcal.bench.coils import state as bench
from labcal.gui.ipc.answers import CoilEnd, EarlierSupply, SwitchedOff
from labcal.gui.ipc.messages import EarlierAreGone, SwitchOff
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.bench_to_do import to_do
from labcal.gui.viewmodels.lab_now import lab_now
from labcal.gui.viewmodels.lab_off import switched_off
from labcal.gui.widgets.close_at_rest import CloseAtRest

LOST = "127.0.0.1:44637: the link was lost (Connection refused)."


def earlier(axis="x", **known):
    port = f"127.0.0.1:{44637 + ord(axis)}"
    return EarlierSupply(f"{axis} at {port}", port, LOST, **({"gone": True, "flows": False} | known))


def read(window, currents):
    """The coils as they were read just now; None: a supply that does not answer."""
    now = time.monotonic()
    coils = (
        silent(a, now) if i is None else bench.CoilReading(a, i, i, i == 0.0, None, now)
        for a, i in zip("xyz", currents, strict=True)
    )
    window.app_state.take_lab(bench.LabState(tuple(coils)))


def off(qtbot, window, *left, coils=None):
    qtbot.keyClick(window, Qt.Key.Key_F12)
    window.app_state.off_worker.answer(SwitchOff, SwitchedOff(coils or ends(), earlier=left))


def rows(window):
    return [value.text() for value in window.side.coils.values]


def test_they_have_no_row_and_hold_no_zero_of_this_bench(qtbot, still):
    off(qtbot, still, earlier("x"), earlier("y"), earlier("z"))
    assert rows(still) == ["+0.000"] * 3
    assert not still.fault.isVisible()
    assert still.app_state.lab.state.message.startswith("COILS OFF done")
    assert still.earlier.isVisible()
    assert still.earlier.words.text().startswith("▲ Supplies of an earlier session do not answer: x at 127.0.0.1:")
    assert still.side.may_go_in.text() == "● Hands may go in"
    off(qtbot, still)
    assert not still.earlier.isVisible()


def test_a_coil_is_shown_by_its_name_wherever_it_stands(still):
    before = bench.LabState(bench.unread())
    x, y, z = (CoilEnd(axis, i, "zero, open", True, 1.0) for axis, i in (("x", 1.0), ("y", 2.0), ("z", 3.0)))
    stranger = CoilEnd("x at 127.0.0.1:1", 9.0, "zero, open", True, 1.0)
    said = switched_off(before, SwitchedOff((z, stranger, y, x)), still.app_state.facts)
    roles = {name: one.role for name, one in still.app_state.facts.instruments.items()}
    assert lab_now(said, 1.0, roles, 1.0).coil_A == (1.0, 2.0, 3.0)


def test_no_number_stands_on_the_row_of_a_supply_that_does_not_answer(still):
    read(still, (1.1, 1.2, 1.3))
    supply = next(name for name, one in still.app_state.facts.instruments.items() if one.role == "coil-z")
    known = replace(still.app_state.known, instruments=(bench.Heard(supply, None, "silent"),))
    still.app_state.take_lab(known)
    assert rows(still) == ["+1.100", "+1.200", "–"]


def test_who_says_that_they_are_gone_is_named_and_only_those_whose_link_is_gone_leave(qtbot, still):
    off(qtbot, still, earlier("x"), earlier("y", gone=False))
    still.app_state.set_identity(operator="")
    assert not still.earlier.gone.isEnabled()
    still.app_state.set_identity(operator="A. Lee")
    qtbot.mouseClick(still.earlier.gone, Qt.MouseButton.LeftButton)
    asked = still.app_state.off_worker.asked[-1].command
    assert asked == EarlierAreGone(still.app_state.bench, (earlier("x").port,), "A. Lee")
    still.app_state.off_worker.answer(EarlierAreGone, True)
    assert still.app_state.off.earlier.left == (earlier("y", gone=False),)
    assert not still.earlier.gone.isVisible()
    assert "gone, says A. Lee" in still.app_state.lab.state.message


def test_one_that_answers_and_is_not_at_zero_keeps_hands_off(qtbot, still):
    off(qtbot, still, earlier("x", gone=False, flows=True))
    assert "not at zero: x at 127.0.0.1:" in still.side.hands.text()
    assert still.app_state.lab.state.hands[1] == "bad"
    assert "✕" in still.earlier.words.text()


@pytest.fixture
def excepthook(monkeypatch, still):
    told_of = []
    monkeypatch.setattr(sys, "excepthook", lambda kind, error, trace: told_of.append(error))
    return told_of


@pytest.mark.parametrize(
    ("spoilt", "told_times"),
    [
        ({"coil_A": (2.1, 2.2, 2.3, 2.4)}, 1),
        ({"keep_off": None}, 2),  # hands, at the right and in the bar above
        ({"field_measured_nT": (None, None, None)}, 1),
        ({"platform_words": None}, 1),
        ({"lights": (("reference",),)}, 1),
    ],
    ids=["coils", "hands", "field", "platform", "lights"],
)
def test_a_part_that_fails_is_blank_and_says_so_and_the_others_go_on(still, excepthook, spoilt, told_times):
    read(still, (1.1, 1.2, 1.3))
    state = replace(still.app_state.lab.state, message="it goes on")
    of_now = {name: value for name, value in spoilt.items() if hasattr(state.now, name)}
    bad = replace(state, now=replace(state.now, coil_A=(2.1, 2.2, 2.3)))
    bad = replace(bad, now=replace(bad.now, **of_now)) if of_now else replace(bad, **spoilt)
    still.show_state(bad)
    still.show_state(bad)
    assert len(excepthook) == told_times  # once, not four times a second
    assert still.message.text() == "it goes on"
    assert any("cannot be shown" in one.text() for one in still.side.findChildren(QLabel))
    assert rows(still) == (["–"] * 3 if "coil_A" in spoilt else ["+2.100", "+2.200", "+2.300"])
    still.show_state(state)
    assert not any("cannot be shown" in one.text() for one in still.side.findChildren(QLabel))


def test_what_python_says_of_a_mistake_of_labcal_stands_in_the_details_alone(still, capsys):
    still.app_state.handle_exception(IndexError, IndexError("list index out of range"), None)
    assert "list index" not in still.fault.text.text() + still.message.text()
    assert "list index out of range" in still.fault.details.toPlainText()
    assert "list index" in capsys.readouterr().err


def test_the_closing_dialog_is_headed_by_what_is_not_confirmed(qtbot, still):
    dialog = CloseAtRest(still)
    known = {
        "by_hand": (),
        "coils": "coils NOT confirmed at zero",
        "platform": "platform stands at 0°",
        "guarded": None,
    }
    dialog.say(coils_in_doubt=True, **known)
    assert dialog.heading.text() == "✕ HANDS OFF: the coils may be on"
    dialog.say(coils_in_doubt=False, **known)
    assert dialog.heading.text() == "✕ HANDS OFF: the platform may still turn"
    dialog.deleteLater()


def test_no_list_of_supplies_to_switch_off_is_empty(still, monkeypatch):
    read(still, (0.0, 0.0, None))
    monkeypatch.setattr(AppState, "by_hand", lambda self: ())
    assert "by hand" not in to_do(still.app_state)
