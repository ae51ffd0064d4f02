"""One sentence for one thing, and none that the next moment, or what stands beside it, takes back."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import lab, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import NOT_READ_ON, PlatformReading, Witness
from labcal.bench.stage_off import NOT_YET
from labcal.gui.ipc.answers import CoilEnd, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.viewmodels.known_lab import KnownLab
from labcal.gui.viewmodels.lab_now import WATCHED_S
from labcal.record import Segment
from labcal.record.stream import FAULT, Event, SegmentOpened, Step


def test_coils_off_is_said_to_be_done_once_and_its_sentence_gets_its_end(real, monkeypatch):
    app_state, clock = real.app_state, iter(f"13:59:{second}" for second in range(13, 60))
    monkeypatch.setattr(app_state, "facts", replace(app_state.facts, virtual_time=False))
    app_state.take_lab(lab(platform=stands(age_s=2.0)))
    app_state.off.order()
    monkeypatch.setattr(time, "strftime", lambda *_: next(clock))
    ends = tuple(CoilEnd(axis, 0.0, "zero, open", True, time.monotonic()) for axis in "xyz")
    unseen = PlatformReading(fault=NOT_YET)
    app_state.off_worker.answer(SwitchOff, SwitchedOff(ends, platform=unseen))
    first, said_at = app_state.lab.state.message, app_state.lab.state.said_at
    app_state.take_lab(lab(platform=stands()))
    last = app_state.lab.state.message
    assert last != first
    assert last.partition(": ")[0] == first.partition(": ")[0]
    assert app_state.lab.state.said_at == said_at


def test_while_a_step_breaks_off_no_field_and_no_turn_is_said_to_come(real):
    app_state = real.app_state
    app_state.run.start(RunProcedure("rotate-axis", "bench.toml", {}, "EM-07", "J. Doe"))
    items = app_state.bench_worker.items
    items.emit((Step(1.0, 2, 2, "z+50uT", 60.0), SegmentOpened(1.0, Segment("z+50uT", "rotation"))))
    app_state.bench_worker.states.emit(lab(platform=stands()))
    assert "the platform turns next" in app_state.hands()[0]
    items.emit((Event(2.0, FAULT, "reference: no sample for 0.9 s", {"step": "z+50uT"}),))
    words, mark = app_state.hands()
    assert (words.endswith("Hands off: the step is broken off"), mark) == (True, "bad")


@pytest.mark.parametrize("virtual_time", [True, False], ids=["simulated", "real"])
def test_of_a_simulated_lab_it_is_not_said_ever_longer_ago_that_its_reference_agreed(real, virtual_time):
    now, kept = time.monotonic(), KnownLab()
    facts = replace(real.app_state.facts, virtual_time=virtual_time)
    agreed = Witness("agrees", "", (0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 2000.0, now - WATCHED_S - 60.0)
    kept.take(replace(lab(platform=stands()), reference=agreed), now)
    said = kept.now(facts, now, driven=False).coil_words
    assert (NOT_READ_ON in said, "last looked at" in said) == (virtual_time, not virtual_time)


def test_no_run_is_said_to_be_none_before_the_store_was_looked_into(still, monkeypatch):
    page, path = still.page("Start"), still.app_state.path
    monkeypatch.setattr(path, "runs", ())
    for listed, said in ((False, "…"), (True, "none yet")):
        monkeypatch.setattr(path, "listed", listed)
        page.grid.laid_out.emit()
        assert page.counted.text() == said
        assert (page.no_runs.text() == "Looking into the store.") is not listed
