"""HANDS OFF: in the same place on every page while it stands, the largest words there, by one rule of ages."""

import time
from dataclasses import replace

import pytest
from PySide6.QtWidgets import QLabel
from test_hands_in_the_cage import MOUNT, READY, lab, now_s, says, send, stands
from test_hands_in_the_cage import real as real
from test_hands_in_the_cage import running as running

from labcal.bench.coils.agreement import BEFORE_HANDS, CHANGED
from labcal.bench.coils.state import FRESH_S, LabState, Witness, unread
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.known_lab import KnownLab
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.record import Segment
from labcal.record.stream import SegmentClosed, SegmentOpened


def settle(window):
    window.style_queue.finish()
    window.style_queue.finish()


def others(holder, *words):
    return [one for one in holder.findChildren(QLabel) if one not in words and one.isVisible() and one.text()]


def test_on_every_page_the_heading_stands_in_the_same_place_while_a_coil_is_on(running):
    says(running, (0.0, 0.0, 1.1))
    places = set()
    for page in running.lazy_pages:
        running.open_page(page)
        for place in (running.side.keep_off, running.top.keep_off):
            assert (place.isVisible(), place.text()) == (True, "HANDS OFF")
        places.add((str(running.side.keep_off.geometry()), str(running.top.keep_off.geometry())))
    assert len(places) == 1


def test_no_words_of_the_side_panel_are_larger(running):
    says(running, (0.0, 0.0, 1.1))
    settle(running)
    off = running.side.keep_off
    assert off.fontInfo().pointSizeF() > 1.2 * max(one.fontInfo().pointSizeF() for one in others(running.side, off))


def test_no_words_of_the_red_card_are_larger(still):
    still.app_state.take_lab(lab((0.0, 0.0, None)))
    still.app_state.off.warn(Fault("coils", "z: lost"))
    settle(still)
    card = still.fault
    assert (card.gravest.isVisible(), card.gravest.text()) == (True, "✕ HANDS OFF: the coils may be on")
    assert card.gravest.fontInfo().pointSizeF() > max(one.fontInfo().pointSizeF() for one in others(card, card.gravest))
    assert len([one for one in others(card) if one.text() == card.gravest.text()]) == 1
    card.show_fault(Fault("input", "This cannot be done."))
    assert (card.gravest.isVisible(), card.heading.isVisible()) == (False, True)


@pytest.mark.parametrize(
    ("currents", "platform", "why", "said"),
    [
        ((0.0, 0.0, 0.0), False, BEFORE_HANDS, ""),
        ((0.0, 0.0, 0.0), False, CHANGED, "▲ Hands off"),
        ((0.0, 0.0, 0.0), True, BEFORE_HANDS, "HANDS OFF"),
        ((0.0, 0.0, 0.3), False, BEFORE_HANDS, "HANDS OFF"),
        ((0.0, 0.0, None), False, BEFORE_HANDS, "✕ HANDS OFF"),
    ],
)
def test_what_is_on_or_not_confirmed_keeps_hands_off_at_a_question(running, currents, platform, why, said):
    send(running, MOUNT)
    says(running, currents, platform=stands(moving=platform), witness=Witness(why=why))
    assert running.side.keep_off.text() == running.top.keep_off.text() == said
    assert running.side.keep_off.isVisible() is bool(said)


def test_a_run_that_was_told_hands_off_keeps_them_off_with_the_coils_at_zero(running):
    says(running, platform=stands())
    send(running, READY)
    assert running.side.keep_off.text() == "▲ Hands off"
    running.app_state.run.answer("done")
    assert running.side.keep_off.text() == "HANDS OFF"
    send(running, SegmentOpened(4.0, Segment("z", "static")))
    assert running.side.keep_off.text() == "HANDS OFF"
    send(running, SegmentClosed(5.0), MOUNT)
    assert running.side.keep_off.text() == ""


def test_while_it_is_asked_whether_hands_are_off_nobody_tells_them_to_go_in(running):
    says(running, platform=stands())
    send(running, MOUNT)
    assert running.side.hands.text().startswith(("✓ Hands may go in", "● Hands may go in"))
    for text, comes in (
        ("The coils go to 50 µT. Hands off?", "Next: the coils go to 50 µT"),
        ("Next the platform looks for its zero and turns to 90°. Hands off?",
         "Next the platform looks for its zero and turns to 90°"),
        ("Is it as before? Hands off?", "Is it as before? Hands off?"),
    ):  # fmt: skip
        send(running, replace(READY, text=text))
        assert running.side.hands.text() == f"▲ Hands off: {comes}"
        assert running.side.hands.property("state") == "off"
        assert running.side.keep_off.text() == running.top.keep_off.text() == "▲ Hands off"
    says(running, platform=stands(), faulty=("dut",))  # whose plug is seen to first
    assert running.side.hands.text().startswith(("✓ Hands may go in", "● Hands may go in"))


def test_coils_that_nobody_has_read_on_a_real_bench_are_no_leave_to_reach_in(real):
    real.app_state.take_lab(LabState(unread()))
    assert real.side.keep_off.text() == "▲ Hands off"


def test_at_a_mounting_and_after_a_failure_a_reading_is_as_old_by_the_same_rule(real, running, later):
    live, app_state = running.page("Run").live, running.app_state
    send(running, MOUNT)
    says(running, platform=stands())
    later(FRESH_S + 1.0)
    app_state.grow_old()
    at_mounting = live.prompt.hands.text()
    assert at_mounting == (
        "● Hands may go in: coils read back at zero by their supplies; no reference has confirmed it · read 3 s ago"
    )
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", Fault("instrument", "dut: silent.")))
    live.fault.say_hands()
    assert live.fault.hands.text() == at_mounting
    later(WATCHED_S + 1.0)
    app_state.grow_old()
    live.fault.say_hands()
    assert live.fault.hands.text().startswith("▲ Hands off: ")
    assert live.prompt.hands.text() == live.fault.hands.text()


def test_what_lets_hands_in_and_its_reason_have_their_ages(real, running, later):
    send(running, MOUNT)
    says(running, platform=stands(), witness=Witness(why=BEFORE_HANDS, read_s=now_s()))
    later(FRESH_S + 1.0)
    assert running.page("Run").live.prompt.hands.text() == (
        f"● Hands may go in: coils read back at zero by their supplies; {BEFORE_HANDS}, 3 s ago · read 3 s ago"
    )


def test_what_proves_the_zero_is_said_to_who_reaches_in(running):
    send(running, MOUNT)
    says(running, platform=stands(), witness=Witness(why=BEFORE_HANDS))
    hands = running.page("Run").live.prompt.hands
    assert hands.text().startswith("● Hands may go in: coils read back at zero by their supplies; the reference's amb")
    read_s = time.monotonic()
    says(running, platform=stands(), witness=Witness("agrees", BEFORE_HANDS, read_s=read_s))
    assert hands.text() == "✓ Hands may go in: coils at zero, by their supplies and by the field · read 1 s ago"
    says(running, platform=stands(), witness=Witness(why=CHANGED))
    assert hands.text() == f"▲ Hands off: {CHANGED}"


def test_what_agreed_with_a_field_of_before_hands_judges_nothing_after_the_run(still):
    kept = KnownLab()
    field = (20_400.0, 1_150.0, -43_700.0)
    for why, judges in (("", True), (BEFORE_HANDS, False), (CHANGED, False)):
        kept.take(lab(witness=Witness("agrees", why, field, field, 0.0, 2e3, 10.0)), 10.0)
        assert (kept.ambient_nT(still.app_state.facts, 11.0) is not None) is judges
