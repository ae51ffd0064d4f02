"""Every state of run, coils, instruments and guardian is drawn: no two places of the window contradict each other."""

import itertools
import re
import time
from dataclasses import replace

import pytest
from lab_states import silent
from PySide6.QtWidgets import QLabel

from labcal.bench.coils.state import CoilReading, FieldReading, Heard, LabState, PlatformReading, Witness, unread
from labcal.gui.ipc.answers import CoilEnd, Ended, SwitchedOff
from labcal.gui.ipc.messages import RunProcedure, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels import app_state as module
from labcal.gui.viewmodels.hands_now import MAY
from labcal.record import Segment
from labcal.record.stream import Event, Measurement, Prompt, SegmentOpened, Step

STEPS = ("zero", "x+20uT-nominal", "closing")
FIRST = Step(0.0, 1, 3, "zero", 60.0, STEPS, 20.0)
ASKED = Prompt(1.0, "mount-x", "Mount it.", ("done",), True)
MODE = Prompt(1.0, "mode-full", "Switch the DUT to power mode full.", ("done",), True, {"mode": "full"})
ENERGISED = Event(0.5, "set-point", "field 30000 0 40000 nT", {"field_nT": [3e4, 0, 4e4]})
GOOD = Measurement(1.5, "x+20uT-nominal: noise", 20.0, 1.0, "nT", 30.0)
PAUSED = Event(2.0, "pause", "paused, coils at zero", {})
SILENT = Fault("instrument", "reference: no sample for 3.1 s.", "Look at its cable.")
RUNS = {  # what is told, and how the run ends (None: it goes on)
    "idle": (None, None),
    "starting": ((), None),
    "running": ((FIRST, ENERGISED), None),
    "measuring": ((FIRST, ENERGISED, SegmentOpened(2.0, Segment("x+20uT-nominal", "rotation")), GOOD), None),
    "asking": ((FIRST, ENERGISED, ASKED), None),
    "asking for a mode": ((FIRST, ENERGISED, MODE), None),
    "paused": ((FIRST, ENERGISED, PAUSED), None),
    "goes on": ((FIRST, PAUSED, Event(3.0, "pause", "goes on")), None),
    "stopping": ((FIRST, ENERGISED, GOOD), "stop"),
    "stopping, and asked once more": ((FIRST, ENERGISED, GOOD), "stop, asked"),
    "aborting": ((FIRST, ENERGISED), "abort"),
    "finished": ((FIRST, GOOD), Ended("r1", "finished")),
    "stopped": ((FIRST, GOOD), Ended("r1", "stopped", Fault("stopped", "stopped by the operator"))),
    "failed": ((FIRST, GOOD), Ended("r1", "failed: reference is silent", SILENT)),
    "interrupted by its store": ((FIRST, GOOD), Ended("r1", "interrupted", Fault("input", "runs.sqlite: disk full"))),
    "COILS OFF at rest, the platform read 3 s before": (None, "off"),
    "its worker died": ((FIRST, ENERGISED), Fault("ended", "The work was killed (signal 9, SIGKILL).")),
}
ON, OFF, LOST = (1.52, 0.0, -0.4), (0.0, 0.001, 0.0), (None, 0.0, 0.0)
COILS = {  # currents, what the reference says, how long ago
    "not told": None,
    "at zero": (OFF, "agrees", 0.0),
    "zero by word": (OFF, "not known", 0.0),
    "zero, then nothing": (OFF, "agrees", 12.0),
    "on": (ON, "agrees", 0.0),
    "on, then nothing": (ON, "agrees", 12.0),
    "one lost": (LOST, "agrees", 0.0),
    "no zero by the reference": (OFF, "disagrees", 0.0),
}
INSTRUMENTS = {
    "all answer": (0.0, ""),
    "all silent for 12 s": (12.0, ""),
    "one failed": (0.0, "silent"),
    "unheard": None,
}
GUARDIANS = {"none": None, "lives": True, "lost": False}
REACHED = [
    which
    for which in itertools.product(RUNS, COILS, INSTRUMENTS, GUARDIANS)
    if which[1] != "not told" or which[2:] == ("unheard", "none")  # who has told nothing has told nothing
]


def told(names, coils, instruments, guardian, now):
    """The state as a worker tells it."""
    if coils is None:
        return None
    currents, verdict, age_s = coils
    axes = tuple(
        CoilReading(a, i, i, abs(i) < 0.005, None, now - age_s) if i is not None else silent(a, now - age_s)
        for a, i in zip("xyz", currents, strict=True)
    )
    heard = () if instruments is None else tuple(Heard(n, now - instruments[0], "") for n in names)
    if instruments is not None and instruments[1]:
        heard = (*heard[:-1], Heard(names[-1], now - 5.0, instruments[1]))
    field_s = now - (age_s if instruments is None else max(age_s, instruments[0]))
    witness = Witness(verdict, "no reference has confirmed it", difference_nT=9e4, limit_nT=2e3, read_s=now - age_s)
    field = FieldReading((3e4, 0.0, 4e4) if max(map(abs, filter(None, currents)), default=0) > 0.1 else None,
                         (3e4, 10.0, 4e4), field_s)  # fmt: skip
    stands = None if instruments is None else PlatformReading(69.0, False, now - instruments[0])
    return LabState(axes, witness, guardian, heard, field, stands)


def brought(window, which):
    """The window in this state; the clock of what is read stands still meanwhile."""
    run_state, coils, instruments, guardian = which
    app_state, (items, end) = window.app_state, RUNS[run_state]
    now = module.time.monotonic()
    state = told(list(app_state.facts.instruments), COILS[coils], INSTRUMENTS[instruments], GUARDIANS[guardian], now)
    if end == "off":
        switched_off(app_state, state)
        return
    if items is None:
        if state is not None:
            app_state.take_lab(state)
        return
    app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    app_state.bench_worker.items.emit(items)
    if state is not None:
        app_state.bench_worker.states.emit(state)
    finish(app_state, end)


def switched_off(app_state, state):
    """COILS OFF at rest is answered: each supply is read back at zero, the platform was not looked at."""
    now, known = module.time.monotonic(), state or LabState(unread())
    long_ago = known.platform and replace(known.platform, read_s=now - 3.0)
    app_state.take_lab(replace(known, platform=long_ago))
    app_state.off.order()
    ends = tuple(CoilEnd(axis, flows_A, "zero, open", True, now) for axis, flows_A in zip("xyz", OFF, strict=True))
    app_state.off_worker.answer(SwitchOff, SwitchedOff(ends))


def finish(app_state, end):
    if isinstance(end, Ended):
        app_state.bench_worker.answer(RunProcedure, end)
    elif isinstance(end, Fault):
        app_state.bench_worker.asked[-1].failed(end)
    elif end is not None:
        app_state.run.abort() if end == "abort" else app_state.run.stop()
        if end == "stop, asked":
            app_state.bench_worker.items.emit((ASKED, PAUSED))


class Seen:
    """What each place of the window says."""

    def __init__(self, window):
        self.window, self.live, self.side = window, window.page("Run").live, window.side
        self.live.draw()
        self.bench = window.page("Bench")
        self.bench.show_readings()
        self.zero = self.side.zero_words.text()
        self.currents = [cell.text() for cell in self.side.coils.values]
        self.fields = [cell.text() for cell in self.side.field.values]
        self.lights = [row.text() for row in self.side.instrument_rows if not row.isHidden()]
        self.rows = [[self.bench.table.text(r, c) for c in range(6)] for r in range(self.bench.table.rowCount())]
        self.message = window.message.text()
        shown = [self.live, self.window.fault]
        self.texts = [one.text() for part in shown for one in part.findChildren(QLabel) if not one.isHidden()]
        self.texts += [self.zero, self.message, window.waiting.text(), self.window.page("Start").question.text()]


def says_zero(text):
    return bool(re.search(r"(?<!NOT )(at zero|zero by the supply)", text)) and "NOT" not in text and "ago" not in text


def contradictions(window):
    """Every pair of places that cannot both be true, in words."""
    seen, run = Seen(window), window.app_state.run
    yield from of_the_coils(seen)
    yield from of_ages(seen, window.app_state)
    yield from of_hands(seen, window.app_state.lab.state)
    yield from of_the_run(seen, run)
    yield from of_the_instruments(seen)
    if any("no bench is open" in text.lower() for text in [*seen.texts, seen.side.legend.text()]):
        yield "no bench is open, with a bench open"
    if not window.top.simulated.isVisible():
        yield "the emulated bench is not said to be simulated"


def of_the_coils(seen):
    flowing = [c for c in seen.currents if c != "–" and abs(float(c.replace("\u2212", "-"))) > 0.005]
    claims = {text for text in seen.texts if says_zero(text)}
    if claims and flowing:
        yield f"{claims} beside {flowing}"
    if claims and not says_zero(seen.zero):
        yield f"{claims} beside {seen.zero}"
    if seen.zero.startswith("✓") and seen.currents != ["+0.000", "+0.001", "+0.000"]:
        yield f"{seen.zero} beside {seen.currents}"
    if "coils on" in seen.zero and not flowing:
        yield f"{seen.zero} beside {seen.currents}"
    if "not read back" in seen.zero and set(seen.currents) != {"–"}:
        yield f"{seen.zero} beside {seen.currents}"
    if not flowing and seen.fields[0] != "–":
        yield f"field {seen.fields[0]} set beside {seen.currents}"
    on_bench = [row[4].partition(" ")[0] for row in seen.rows if row[0].startswith("coil")]
    if on_bench != seen.currents:
        yield f"{on_bench} on the bench page, {seen.currents} beside it"
    asked = seen.live.prompt
    beside, said = (seen.zero, seen.side.platform.text()), (asked.lab.text(), asked.stands.text())
    if not asked.isHidden() and seen.window.app_state.run.prompt and said != beside:
        yield f"the question says {said!r}, the panel {beside!r}"
    colours = (seen.side.zero_words.property("state"), seen.side.platform.property("state"))
    if not asked.isHidden() and colours != (asked.lab.property("state"), asked.stands.property("state")):
        yield f"the question is in other colours than {colours}"
    stands = seen.side.platform.text()
    rests = seen.zero.startswith(("✓", "■ coils read back at zero")) and (
        not stands or (stands[0] == "✓" and "read" not in stands)
    )
    rests = rests and seen.window.app_state.run.state not in ("starting", "running")  # a run that begins, or goes on
    if not (asked.isHidden() or asked.hands.isHidden()) and ("may go in" in asked.hands.text()) != rests:
        yield f"{asked.hands.text()!r} beside {seen.zero!r} and {stands!r}"


def of_hands(seen, state):
    """The heading over every page, the panel and the line below let hands in together, or not at all."""
    words, mark = state.hands
    if "not seen to stand yet" in seen.message and mark in MAY:
        yield f"{words!r} beside {seen.message!r}"
    if (mark in MAY) == bool(state.keep_off[0]) and words:
        yield f"{words!r} beside {state.keep_off[0]!r} over every page"
    signs = {one.partition("H")[0] for one in (words, state.keep_off[0]) if one and mark not in MAY}
    if len(signs) > 1:
        yield f"{words!r} beside {state.keep_off[0]!r}: two signs of one state"


def of_ages(seen, app_state):
    """What is older than 2 s is grey and says how old it is; what is not does not."""
    side, now = seen.side, time.monotonic()
    known = app_state.known
    coils_s = min((c.read_s for c in known.coils if c.read_s), default=None) if known else None
    asked_off = set(seen.currents) == {"–"}
    for cells, age, read_s in (
        (side.coils.values, side.coils_age, None if asked_off else coils_s),
        (side.field.values[1:], side.field_age, known.field.read_s if known else None),
    ):
        old = read_s is not None and module.time.monotonic() - read_s > 2.0
        for cell in cells:
            if cell.text() != "–" and (cell.property("state") == "old") != old:
                yield f"{cell.text()} read {now - read_s:.0f} s ago is {'' if not old else 'not '}grey"
        if any(cell.text() != "–" for cell in cells) and ("ago" in age.text()) != old:
            yield f"the age {age.text()!r} of what was read {now - read_s:.0f} s ago"
    for text in seen.lights:
        heard = {one.name: one for one in known.instruments}.get(text.split()[1]) if known else None
        if heard and heard.heard_s and module.time.monotonic() - heard.heard_s > 2.0 and "ago" not in text:
            yield f"{text}: heard {now - heard.heard_s:.0f} s ago"


def of_the_run(seen, run):
    live, waiting, headline = seen.live, seen.window.waiting.text(), seen.live.headline.text()
    words = {"asking": "your turn", "paused": "paused"}
    if waiting != (words.get(run.state) or ("hands off, measuring" if run.state == "running" and run.segment else "")):
        yield f"{waiting!r} while the run is {run.state}"
    if live.middle.currentWidget() is live.prompt and run.state != "asking":
        yield f"a question stands while the run is {run.state}"
    if (
        seen.zero.startswith("✕")
        and run.state == "running"
        and (not headline.startswith("✕ HANDS OFF") or live.time_left.until.text())
    ):
        yield f"{headline!r} and {live.time_left.until.text()!r} beside {seen.zero!r}"
    if seen.zero.startswith("✕") and not run.alive and seen.window.next.text() != "Next: See to the coils":
        yield f"{seen.window.next.text()!r} beside {seen.zero!r}"
    if run.state in ("paused", "stopping", "starting", "ended") and "Hands off" in headline:
        yield f"{headline!r} while the run is {run.state}"
    if (live.pause.text() == "Go on") != (run.state == "paused"):
        yield f"the button says {live.pause.text()!r} while the run is {run.state}"
    if (live.close_run.isHidden() or not live.stop.isHidden()) and run.state == "ended":
        yield "an ended run may be stopped"
    if run.status != "finished" and "PASS" in "".join(one.text() for one in live.lights.worst.values()):
        yield "PASS of an axis whose checks were not all made"
    if run.state == "ended" and ("PASS" in live.verdict.word.text()) != (run.status == "finished"):
        yield f"the verdict is {live.verdict.word.text()!r} of a run that is {run.status!r}"
    if (live.middle.currentWidget() is live.verdict) != (run.state == "ended"):
        yield f"a verdict stands while the run is {run.state}, or none when it has ended"
    if run.alive != (seen.window.next.text() in ("Next: See the run", "Next: Answer the question")):
        yield f"{seen.window.next.text()!r} while the run is {run.state}"
    if run.alive and "Ready." in seen.window.page("Start").question.text():
        yield "Ready, while a run goes on"
    if not run.alive and seen.message.startswith(("Paused", "Hands off", "Stopping")):
        yield f"{seen.message!r} after the run"


def of_the_instruments(seen):
    beside = {text.split()[1]: text[0] for text in seen.lights}
    for _, name, _, _, _, state in seen.rows:
        if beside[name] != state[0]:
            yield f"{name}: {state!r} on the bench page, {beside[name]} beside it"
    yield from of_the_platform(seen, beside)


def of_the_platform(seen, beside):
    """Where it stands is said alike, and who stands was heard."""
    role, name, _, _, reading, _ = next(row for row in seen.rows if row[0] == "platform")
    said = seen.side.platform.text()
    if ("69°" in said) != ("69.0°" in reading):
        yield f"{role} at {reading!r} on the bench page, {said!r} beside it"
    if said.startswith("✓") and beside[name] in "…○":
        yield f"{said!r} beside {beside[name]} {name}"


@pytest.fixture
def drawn(still):
    still.page("Start"), still.page("Bench")
    return still


def is_in_the_short_form(which):
    """Each pair of run and coils once, with instruments and guardians in turn, so that all pairs of two parts are."""
    run, coils, instruments, guardian = which
    i, j = list(RUNS).index(run), list(COILS).index(coils)
    own, guarded = list(INSTRUMENTS), list(GUARDIANS)
    turn = own[(i + j) % len(own)], guarded[(i // len(own) + j) % len(guarded)]
    return coils == "not told" or (instruments, guardian) == turn


@pytest.mark.parametrize("run_state", RUNS)
def test_no_two_places_of_the_window_disagree(drawn, run_state, monkeypatch):
    none_disagrees(drawn, [one for one in REACHED if one[0] == run_state and is_in_the_short_form(one)], monkeypatch)


@pytest.mark.slow
@pytest.mark.parametrize("run_state", RUNS)
def test_in_all_other_states_no_two_places_disagree(drawn, run_state, monkeypatch):
    others = [one for one in REACHED if one[0] == run_state and not is_in_the_short_form(one)]
    none_disagrees(drawn, others, monkeypatch)


def none_disagrees(drawn, states, monkeypatch):
    stands = time.monotonic()
    monkeypatch.setattr(module, "time", type("Still", (), {"monotonic": staticmethod(lambda: stands)}))
    app_state, found = drawn.app_state, []
    for which in states:
        app_state.forget()
        app_state.run.forget()
        app_state.off_worker.asked.clear()
        app_state.lab.update(message="", waiting="")
        app_state.grow_old()
        drawn.fault.show_fault(None)
        brought(drawn, which)
        found += [f"{', '.join(which)}: {what}" for what in contradictions(drawn)]
    assert not found, f"{len(found)} contradictions:\n" + "\n".join(found[:20])


def test_every_state_is_drawn():
    assert len(REACHED) == len(RUNS) * (7 * 4 * 3 + 1) == 1445
    short = [one for one in REACHED if is_in_the_short_form(one)]
    for pair in itertools.combinations(range(4), 2):  # every pair of two parts' states
        assert {tuple(one[at] for at in pair) for one in short} == {tuple(one[at] for at in pair) for one in REACHED}
    assert len(short) == len(RUNS) * (7 + 1) == 136
