"""Who is there, and how many are out: one list and one count, in the panel, on the cards and at a question."""

import time
from dataclasses import replace

import pytest
from test_hands_in_the_cage import STEPS, says, send, stands
from test_hands_in_the_cage import real as real

from labcal.bench.coils.state import CoilReading, Heard, LabState, PlatformReading, unread
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.viewmodels.beside_coils import beside_coils
from labcal.gui.viewmodels.failed_step import NAMED
from labcal.record.stream import Prompt, Step

LOST = {"no_answer": "stage", "what": "stage: no reply.", "remedy": "Is its plug in?", "fault": "stage: no reply."}
FAILED = Prompt(3.0, "failed-zero", "zero: stage: no reply.", ("stop", "retry"), drawing=LOST)


@pytest.fixture
def wired(real):
    """Supplies and contacts at one host, everybody else at a device of its own."""
    facts = real.app_state.facts

    def link(number, role):
        return f"tcp://lab:{number}" if role.startswith(("coil-", "polarity")) else f"serial:///dev/ttyUSB{number}"

    there = enumerate(facts.instruments.items())
    instruments = {name: replace(one, link=link(number, one.role)) for number, (name, one) in there}
    real.app_state.facts = replace(facts, instruments=instruments)
    return real


def rows(window):
    return [row.name.text() for row in window.side.rows if not row.isHidden()]


def zero(guardian=None):
    now = time.monotonic()
    return LabState(tuple(CoilReading(axis, 0.0, 0.0, True, True, now) for axis in "xyz"), guardian=guardian)


def test_the_list_has_the_same_lines_in_a_run_and_at_rest(wired):
    app_state = wired.app_state
    names = [*app_state.facts.instruments, "guardian"]
    for known in (LabState(unread()), zero(), zero(guardian=True), zero(guardian=False), zero()):
        app_state.take_lab(known)
        assert [name for name, _, _ in app_state.lab.state.now.lights] == names
    assert rows(wired)[-1] == "○ guardian  only in a run"


def test_of_a_simulated_bench_no_guardian_is_listed(still):
    still.app_state.take_lab(zero())
    assert not [one for one in rows(still) if "guardian" in one]


def test_that_all_answer_and_how_the_bench_is_marked_is_said_of_the_instruments(wired):
    app_state, now = wired.app_state, time.monotonic()
    heard = tuple(Heard(name, now) for name in app_state.facts.instruments)
    app_state.take_lab(replace(zero(), instruments=heard))
    assert wired.side.legend.text() == "all answer"
    assert app_state.path.marks()["Bench"] == "done"


def test_a_line_that_several_share_is_named_with_how_many_are_out_in_all(wired):
    app_state = wired.app_state
    out = [name for name in app_state.facts.instruments if name != "dut"]
    app_state.take_lab(LabState(unread(), instruments=tuple(Heard(name, None, "silent") for name in out)))
    said = f"No answer from {len(out)} instruments, all 4 at lab among them: look at that common line first."
    assert wired.side.legend.text() == said
    assert said in beside_coils(app_state.lab.state.now)
    assert len([one for one in rows(wired) if one.startswith("✕")]) == len(out)


def test_a_question_about_the_first_that_was_missed_names_everybody_who_is_out_by_now(wired):
    """With all plugs out it said "No answer from stage" in the largest letters: the platform is asked most often."""
    app_state = wired.app_state
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    send(wired, Step(0.0, 1, 4, "zero", 60.0, STEPS, 20.0))
    wired.open_page("Run")
    card, names = wired.page("Run").live.prompt, list(app_state.facts.instruments)
    says(wired, platform=PlatformReading(fault="silent"), faulty=("stage",))
    send(wired, FAILED)
    assert card.text.text() == "✕ No answer from stage"
    says(wired, platform=PlatformReading(fault="silent"), faulty=("stage", "dut"))
    assert card.text.text() == "✕ No answer from stage, dut"
    says(wired, (None, None, None), PlatformReading(fault="silent"), tuple(names))
    assert len(names) > NAMED
    assert card.text.text() == f"✕ No answer from {len(names)} instruments"
    says(wired, platform=stands(), faulty=("dut",))
    assert card.text.text() == "✕ No answer from dut"
    says(wired, platform=stands())
    assert card.text.text() == "Every instrument answers again."
