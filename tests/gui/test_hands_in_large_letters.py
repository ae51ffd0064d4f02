"""With larger letters on a small screen what is said of hands is whole, in every language."""

from dataclasses import replace

import pytest
from geometry import faults
from PySide6.QtCore import QLocale
from test_hands_in_the_cage import lab, stands
from test_nothing_is_cut import TURNED, begun, by_word, measuring, send, settle
from test_sixth_walk import STANDS

from labcal.bench.coils.agreement import BEFORE_HANDS
from labcal.bench.coils.state import PlatformReading
from labcal.gui.translations import translate
from labcal.record.stream import Event

SMALL = (1024, 700)
PAUSED = Event(3.0, "pause", "paused, coils at zero")
STILL_MOUNTED = replace(
    STANDS, text="Is the DUT still mounted with body X up, exactly as it was before the interruption?"
)


def known(window, *args):
    window.app_state.bench_worker.states.emit(lab(*args))


def silent(window):
    known(window, (0.0, 0.0, None), PlatformReading(fault="silent"), ("supply_z", "stage"))


def gone_on_with(window):
    by_word(window, STILL_MOUNTED)
    run = window.app_state.run
    run.anew = run.goes_on = True
    why = replace(run.lab.reference, why=BEFORE_HANDS)
    window.app_state.bench_worker.states.emit(replace(run.lab, reference=why))


SITUATIONS = {
    "to mount": lambda window: (begun(window, TURNED), known(window, (0.0, 0.0, 0.0), stands())),
    "to mount, and nobody answers": lambda window: (begun(window, TURNED), silent(window)),
    "does it stand still": gone_on_with,
    "measuring, and nobody answers": lambda window: (measuring(window), silent(window)),
    "paused": lambda window: (measuring(window), send(window, PAUSED), known(window, (0.0, 0.0, 0.0), stands())),
    "paused, and nobody answers": lambda window: (measuring(window), send(window, PAUSED), silent(window)),
}


@pytest.fixture(params=["de", *(pytest.param(language, marks=pytest.mark.slow) for language in ("en", "fr"))])
def spoken(request, qapp, new_window):
    translate.install_translator(qapp, QLocale(request.param))
    yield new_window
    translate.install_translator(qapp, QLocale("en"))


def places_of_hands(window):
    live, side = window.page("Run").live, window.side
    places = (live.prompt.hands, live.prompt.text, live.headline, live.hands, side.keep_off, side.may_go_in, side.hands)
    return [one for one in places if one.isVisible() and one.text()]


def test_whether_hands_may_go_in_is_whole(spoken, rest):
    spoken.toggle_wall()
    found = []
    for name, begin in SITUATIONS.items():
        begin(rest(spoken))
        for _ in range(2):
            spoken.resize(*SMALL)
            settle(spoken)
        cut = [one for one in places_of_hands(spoken) if one.visibleRegion().boundingRect() != one.rect()]
        found += [f"{name}: {fault}" for fault in faults(spoken)]
        found += [f"{name}: {one.visibleRegion().boundingRect()} of {one.rect()}: {one.text()}" for one in cut]
        assert spoken.wall
    assert not found, "\n".join(found)
