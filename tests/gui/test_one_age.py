"""How long nobody has heard an instrument is said in one place, by one clock: the list of who answers."""

import re

import pytest
from lab_states import silent
from PySide6.QtWidgets import QLabel

from labcal.bench.coils.state import Heard, LabState
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import app_state as module
from labcal.record.stream import FAULT, Event, Prompt, Step

SEEN = "dut: no sample for 0.9 s."
ASKED = Prompt(
    2.5, "failed-zero", f"{SEEN} Try again?", ("retry", "stop"), drawing={"no_answer": "dut", "what": SEEN, FAULT: SEEN}
)


def every_word(window):
    """Of each text in sight."""
    return [one.text() for one in window.findChildren(QLabel) if one.isVisible()]


@pytest.mark.parametrize("how", ["in a step", "asked about", "ended by it"])
def test_beside_how_long_ago_it_was_heard_no_other_age_of_a_silence_stands(still, how):
    app_state = still.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    emit = app_state.bench_worker.items.emit
    emit((Step(1.0, 1, 3, "zero", 60.0),))
    emit((Event(2.0, FAULT, SEEN, {"step": "zero", "fault": "silent"}),))
    if how == "asked about":
        emit((ASKED,))
    if how == "ended by it":
        app_state.bench_worker.answer(RunProcedure, Ended("r1", f"failed: {SEEN}", Fault("instrument", SEEN)))
    now = module.time.monotonic()
    heard = (Heard("dut", now - 4.5, SEEN),)
    app_state.take_lab(LabState(tuple(silent(axis, now) for axis in "xyz"), instruments=heard))
    still.page("Run").live.draw()
    said = every_word(still)
    assert [one for one in said if "heard 4 s ago" in one]
    assert [one for one in said if re.search(r"0\.9|no sample", one)] == []


def test_what_a_silence_is_called_is_translated(still):
    from labcal.gui.translations.sentences import form_of

    assert form_of("dut: no answer")
    assert form_of("dut: no answer.")
