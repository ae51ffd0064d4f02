"""Words come and go in a run; what stands beside them stays where it is."""

from datetime import datetime

import pytest
from PySide6.QtCore import QLocale, QPoint, QRect
from test_a_question_keeps_its_places import MOUNT, READY
from test_hands_in_the_cage import lab, stands
from test_nothing_is_cut import settle

from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.translations import translate
from labcal.gui.widgets import time_left
from labcal.record import Segment
from labcal.record.stream import Event, SegmentClosed, SegmentOpened, Step

TURNS = "x+20uT-nominal", "x-50uT-full", "closure-x", "mount-y", "y+20uT-nominal"
STEPS = ("zero", "axes-check", "mount-x", *TURNS, "closing")
LONG = "reference: the link was lost (read failed: socket disconnected). Plug it in, see that nobody else has it."


@pytest.fixture(params=["de", *(pytest.param(language, marks=pytest.mark.slow) for language in ("en", "fr"))])
def spoken(request, qapp, same_window):
    translate.install_translator(qapp, QLocale(request.param))
    yield same_window
    translate.install_translator(qapp, QLocale("en"))


def step(number, left_s, needed_s=None, needed_for=""):
    return Step(0.0, number, len(STEPS), STEPS[number - 1], left_s, STEPS, 60.0, needed_s, needed_for, 4000.0)


def situations(window):
    """Yield a name for each, once the window shows it."""
    run, worker = window.app_state.run, window.app_state.bench_worker

    def told(*items, state=None):
        worker.items.emit(items)
        worker.states.emit(state or lab(platform=stands()))

    told(step(1, 4000.0))
    yield "nothing is needed"
    told(step(2, 3900.0, 70.0, "mount-x"))
    yield "needed soon"
    told(step(4, 36_000.0, 8_000.0, "mount-y"), SegmentOpened(1.0, Segment("x+20uT-nominal", "rotation")),
         state=lab((0.4, 0.4, 0.4), platform=stands(moving=True)))  # fmt: skip
    yield "in a turn"
    told(Event(2.0, "note", LONG), state=lab((0.4, 0.4, 0.4), platform=stands(moving=True), faulty=("dut",)))
    yield "who is lost"
    told(SegmentClosed(3.0), Event(3.0, "note", "x"))
    yield "between two turns"
    told(step(5, 20.0, 5.0, "closing"))
    yield "within a minute"
    told(MOUNT)
    yield "mounting"
    told(READY)
    yield "hands off"
    run.answer("done")
    told(step(9, 3.0))
    yield "the last"


def places(window):
    """Of what a person looks at or presses, by name."""
    live = window.page("Run").live

    def at(widget):
        return QRect(widget.mapTo(window, QPoint(0, 0)), widget.size())

    steps, following = at(live.steps), at(window.next)
    return {
        "the steps": (steps.topLeft().toTuple(), steps.size().toTuple()),
        "Next": (following.right(), following.top(), following.height()),
        "SIMULATED": at(window.top.simulated).getRect(),
        "COILS OFF": at(window.top.off).getRect(),
        "the page": at(window.stack).getRect(),
    }


@pytest.mark.parametrize("size", [(1024, 700), (1360, 860), (1920, 1080)], ids=str)
def test_what_is_looked_at_and_pressed_stays_where_it_is(spoken, size, monkeypatch):
    """In the evening, too, when a run is done on another day, which is said."""
    clock = type("Clock", (), {"now": staticmethod(lambda: datetime(2026, 11, 30, 20, 0))})
    monkeypatch.setattr(time_left, "datetime", clock)
    spoken.resize(*size)
    spoken.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe", "true"))
    spoken.open_page("Run")
    seen = {}
    for name in situations(spoken):
        settle(spoken)
        seen[name] = places(spoken)
    first = next(iter(seen.values()))
    moved = [(name, what, at, first[what]) for name, of in seen.items() for what, at in of.items() if at != first[what]]
    assert not moved, "\n".join(map(str, moved))
