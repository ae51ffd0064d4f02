"""After a run: a platform that its run could not stop, and a supply that fell silent with a current."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import STEPS, headline, lab, says, send, stands, zeros

from labcal.bench.coils.state import PlatformReading
from labcal.bench.stage_off import NOT_YET
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.lab_messages import InstrumentRead, ReadLab
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.coils_off import STOPS_S
from labcal.gui.viewmodels.hands_now import hands_words
from labcal.gui.viewmodels.lab_now import platform_said
from labcal.record.stream import Step

SILENT = Fault("instrument", "stage: silent", "Look at its plug.")
SAID = "press COILS OFF (F12) first"


@pytest.fixture
def failed(still):
    """A run on lines of its own that failed over the platform, which turned when it was read last."""
    app_state = still.app_state
    app_state.facts = replace(app_state.facts, virtual_time=False)
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(still, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    says(still, platform=stands(moving=True))
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", SILENT))
    app_state.grow_old()
    return still


def offs(window):
    return len(window.app_state.off_worker.commands(SwitchOff))


def looked(window, moving):
    """The watch has looked: the line of the platform answers."""
    now = time.monotonic()
    one = InstrumentRead("stage", "platform", "", "a stage", None, False, now, None, False, None, 104.0, moving)
    window.app_state.watch.look()
    window.app_state.watch_worker.answer(ReadLab, (one,))


def test_a_platform_left_turning_is_told_to_stop_as_soon_as_its_line_answers(failed):
    before = offs(failed)
    failed.app_state.grow_old()
    assert offs(failed) == before  # nobody answers
    looked(failed, moving=True)
    assert offs(failed) == before + 1
    failed.app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros(), platform=PlatformReading(fault=NOT_YET)))
    looked(failed, moving=True)
    assert offs(failed) == before  # it was told just now


def test_one_that_was_seen_to_stand_is_a_persons_to_turn(failed):
    before = offs(failed)
    looked(failed, moving=False)
    failed.app_state.take_lab(lab(platform=stands(moving=True)))
    assert offs(failed) == before


def test_next_stops_it_on_every_page_and_its_card_stays(failed):
    failed.app_state.off._off_s -= STOPS_S + 1
    failed.app_state.grow_old()
    card = failed.fault
    assert card.heading.text() == "✕ HANDS OFF: the platform may still turn"
    assert SAID in card.turning.text()
    assert card.close_card.isHidden()
    before = offs(failed)
    for page in ("Start", "Run", "Bench", "History"):
        failed.open_page(page)
        assert failed.next.text() == "Next: Stop the platform (COILS OFF)"
        assert card.isVisible()
    failed.next.click()
    assert offs(failed) == before + 1
    assert card.isVisible()


def test_f12_comes_first_where_the_line_answers():
    assert SAID in platform_said("platform turns, at 104°")
    assert SAID not in platform_said("platform NOT confirmed at a standstill")


def test_coils_off_says_what_became_of_the_platform(failed):
    app_state = failed.app_state
    app_state.off.order()
    app_state.off_worker.answer(SwitchOff, SwitchedOff(zeros(), platform=PlatformReading(fault=NOT_YET)))
    assert app_state.lab.state.message.endswith("; the platform was ordered to stop, and is not seen to stand yet")
    app_state.take_lab(lab(platform=stands()))
    assert app_state.lab.state.message.endswith("; platform stands at 40°")


def test_a_supply_silent_with_a_current_says_which_and_when_and_its_card_cannot_be_closed(still):
    app_state = still.app_state
    app_state.take_lab(lab((0.0, 0.0, 1.391)))
    read = time.strftime("%H:%M:%S")
    app_state.off.order()
    app_state.off_worker.answer(SwitchOff, SwitchedOff((*zeros()[:2], CoilEnd("z", None, "silent", False))))
    assert still.fault.coils.text().startswith("coils NOT confirmed at zero. z: +1.391 A when last read, " + read[:5])
    assert still.fault.close_card.isHidden()
    app_state.take_lab(lab())
    app_state.fault.emit(SILENT)
    assert not still.fault.close_card.isHidden()


def test_the_coils_keep_hands_out_before_the_platform(failed):
    words = hands_words("coils NOT confirmed at zero", "platform turns, at 104°")[0]
    assert words == "▲ Hands off: coils NOT confirmed at zero; platform turns"
    assert headline(failed) == "✕ Broken off: no answer from stage"
    failed.app_state.take_lab(lab((0.0, 0.0, None), PlatformReading(fault="silent"), faulty=("stage",)))
    assert headline(failed) == "✕ HANDS OFF – coils NOT confirmed at zero, platform may turn"
