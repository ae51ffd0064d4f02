"""At a question who is silent is said, and what may be answered is one rule: for buttons, keys, scans and Next."""

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from test_hands_in_the_cage import MOUNT, READY, lab, says, send, stands, zeros
from test_hands_in_the_cage import running as running

from labcal.bench.coils.state import Heard, PlatformReading
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.record.stream import Event, Prompt

SERIAL = Prompt(4.0, "serial-mount-z", "Scan the serial.", (), True, {"serial": "EM-07"})
FAILED = Prompt(5.0, "failed-zero", "dut: lost", ("stop", "retry", "skip"), drawing={"what": "dut: lost", "remedy": ""})


@pytest.fixture
def card(running):
    running.open_page("Run")
    return running.page("Run").live.prompt


def alive(card):
    card.alive = True
    card.say_lost([])
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
    ("asked", "known"),
    [
        (MOUNT, lambda: {"currents": (0.0, 0.0, 0.4), "platform": stands()}),
        (SERIAL, lambda: {"currents": (0.0, 0.0, 0.4), "platform": stands()}),
        (READY, lambda: {"platform": stands(), "faulty": ("dut",)}),
        (FAILED, lambda: {"platform": stands(), "faulty": ("dut",)}),
    ],
)
def test_next_asks_for_no_answer_that_is_barred(running, card, asked, known):
    send(running, asked)
    says(running, **known())
    assert next_of(running) == ""  # on this page there is nothing to do but to wait
    running.open_page("Start")
    assert next_of(running) == "Next: See the run"


def test_how_it_is_answered_is_not_said_above_a_button_that_may_not_be_pressed(running, card):
    send(running, READY)
    says(running, platform=stands())
    alive(card)
    usual = card.hint.text()
    assert usual
    says(running, platform=stands(), faulty=("dut",))
    assert card.hint.text() == "Not yet: what it waits for stands above."
    says(running, platform=stands())
    assert card.hint.text() == usual


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


@pytest.mark.parametrize(
    ("asked", "known", "first"),
    [
        (
            READY,
            lambda: {"platform": PlatformReading(fault="silent"), "faulty": ("stage",)},
            "First stop the platform at its",
        ),
        (
            FAILED,
            lambda: {"platform": PlatformReading(fault="silent"), "faulty": ("dut",)},
            "First stop the platform at its",
        ),
        (
            READY,
            lambda: {"currents": (0.0, 0.0, None), "faulty": ("supply_z",)},
            "First press COILS OFF (F12), then switch off by hand the supply",
        ),
        (
            MOUNT,
            lambda: {"currents": (0.0, 0.0, 0.4), "platform": stands(), "faulty": ("dut",)},
            "First wait until hands may go in.",
        ),
    ],
)
def test_nobody_is_sent_to_a_plug_before_coils_and_platform_rest(running, card, asked, known, first):
    plug = Prompt(5.0, "failed-zero", "dut: lost", FAILED.choices, drawing=FAILED.drawing | {"remedy": "See to plug."})
    send(running, plug if asked is FAILED else asked)
    says(running, **known())
    assert first in card.details.text()
    assert card.details.text().index(first) < card.details.text().index("ee to plug")
    says(running, platform=stands(), faulty=("dut",))
    assert "First" not in card.details.text().replace("Put that right first", "")


def test_the_line_below_does_not_go_on_saying_who_was_silent(running, card):
    says(running, platform=stands(), faulty=("supply_z",))
    send(running, Prompt(5.0, "failed-zero", "supply_z: no reply in 1.5 s.", FAILED.choices))
    assert "supply_z: no reply" in running.message.text()
    says(running, platform=stands())
    assert running.message.text().startswith("supply_z: answers again")
    running.app_state.run.changed.emit()
    assert running.message.text().startswith("supply_z: answers again")


def test_of_coils_that_are_confirmed_again_the_line_below_says_how_they_are(running, card):
    app_state = running.app_state
    says(running, (0.0, 0.0, None), platform=stands(), faulty=("supply_z",))
    app_state.bench_worker.answer(
        RunProcedure, Ended("r1", "interrupted", Fault("instrument", "supply_z: silent.", ""))
    )
    app_state.off_worker.answer(SwitchOff, SwitchedOff((*zeros()[:2], CoilEnd("z", None, "supply_z: lost", False))))
    assert running.message.text().startswith("COILS OFF (F12), then switch off by hand: supply_z")
    app_state.take_lab(lab(platform=stands()))
    assert "by hand" not in running.message.text()
    assert running.message.text().startswith("supply_z: answers again")
    assert "; coils read back at zero by their supplies" in running.message.text()
    assert "reference:" not in running.message.text()  # which the warning did not name


def test_while_the_coils_have_the_card_nobody_is_sent_to_a_plug_beside_it(running, card):
    app_state, live = running.app_state, running.page("Run").live
    says(running, (0.0, 0.0, None), faulty=("supply_z",))
    plug = Fault("instrument", "supply_z: no reply in 1.5 s.", "Is its plug in at both ends?")
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", plug))
    app_state.off_worker.answer(SwitchOff, SwitchedOff((*zeros()[:2], CoilEnd("z", None, "lost", False))))
    assert running.fault.by_hand.text() == "COILS OFF (F12), then switch off by hand: supply_z"
    assert live.verdict.reason.text() == "supply_z: no reply in 1.5 s."


def test_nothing_counts_down_between_a_failure_and_trying_again(running, card):
    run, live = running.app_state.run, running.page("Run").live
    says(running, platform=stands())
    send(running, Event(15.0, "note", "15 s of 20 s are over"))
    assert (run.step_left_s(), run.left_s()) == (5.0, 45.0)
    send(running, Event(16.0, "fault", "dut: silent", {"step": "zero", "fault": "silent"}))
    send(running, Event(19.0, "read-back", "coils at zero"))
    assert (run.step_left_s(), run.left_s()) == (20.0, 60.0), "the whole of it, if it is tried again"
    live.draw()
    assert " s" not in live.headline.text().partition("·")[2]
    assert live.time_left.until.text() == ""
    send(running, FAILED, Event(40.0, "answer", "retry", {"key": FAILED.key}), Event(41.0, "note", "goes on"))
    assert (run.step_left_s(), run.left_s()) == (19.0, 59.0)


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ("silent", "no answer (plug? power?)"),
        ("tcp://127.0.0.1:35339: no reply in 1.5 s, nothing came.", "no answer (plug? power?)"),
        ("dut: no sample for 3.1 s.", "no answer (plug? power?)"),
        ("link lost", "no answer (link lost)"),
        ("the link was lost", "no answer (link lost)"),
        ("stuck", "stuck"),
    ],
)
def test_one_word_for_who_does_not_answer_however_it_was_found(running, card, fault, said):
    running.app_state.take_lab(replace(lab(platform=stands()), instruments=(Heard("dut", None, fault),)))
    row = next(one.text() for one in running.side.instrument_rows if "dut" in one.text())
    assert row == f"✕ dut  {said}"
