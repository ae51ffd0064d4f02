"""A zero that the reference did not see is measured again by a button, and that it was lifted is said."""

import time

from PySide6.QtCore import Qt
from test_off_unanswered import ADVICE, DOUBT, ends

from labcal.errors import InstrumentError
from labcal.gui.ipc.answers import Doubt, Ended, SwitchedOff
from labcal.gui.ipc.messages import CheckZero, Identify, RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault, fault_of

NOW = f"NOT at zero by the reference: {DOUBT}. {ADVICE}"


def test_the_card_has_the_button_and_says_what_is_seen_now(qtbot, still):
    off = still.app_state.off_worker
    qtbot.keyClick(still, Qt.Key.Key_F12)
    off.answer(SwitchOff, SwitchedOff(ends(), "2026-11-30 00:12 UTC, it sees 99", ADVICE))
    off.asked[-1].failed(Fault("instrument", "nobody answers"))  # who looks again by itself did not come so far
    assert not off.commands(CheckZero)
    still.app_state.fault.emit(still.app_state.off.unconfirmed)
    qtbot.mouseClick(still.fault.check_zero, Qt.MouseButton.LeftButton)
    assert len(off.commands(CheckZero)) == 1
    off.answer(CheckZero, Doubt(NOW, False, ends(), "2026-11-30 00:12 UTC, it sees 99"))
    assert "98.90 µT apart" in still.app_state.known.reference.words
    assert "00:12" not in still.app_state.coil_words()
    assert "00:12" in still.app_state.off.unconfirmed.details
    qtbot.mouseClick(still.fault.check_zero, Qt.MouseButton.LeftButton)
    off.answer(CheckZero, Doubt("they agree again", True, ends()))
    assert "A run may begin again" in still.app_state.lab.state.message
    assert not still.fault.isVisible()
    assert len(off.commands(Identify)) == 1


def test_a_run_that_was_refused_over_it_says_so_and_that_it_is_lifted(qtbot, still):
    app_state = still.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    refused = fault_of(
        InstrumentError(f"NOT at zero by the reference: {DOUBT}.", fault="not zero", remedy=f"{ADVICE}.")
    )
    assert refused.kind == "zero"
    app_state.bench_worker.answer(RunProcedure, Ended("r1", "interrupted", refused))
    card = still.page("Run").live.fault
    assert card.heading.text() == "✕ The zero of the coils is in doubt"
    assert card.check_zero.isVisibleTo(card)
    off = app_state.off_worker
    card.check_zero.click()
    off.answer(CheckZero, Doubt("they agree again", True, ends(), time.strftime("%H:%M")))
    app_state.lab.update(message=app_state.lab.state.message)
    assert "A run may begin again" in app_state.lab.state.message
    assert "A run may begin again" in still.page("Run").live.verdict.reason.text()
