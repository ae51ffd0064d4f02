"""Whatever is said above them, the buttons of a question stand where they stood, and no word is cut."""

import numpy as np
import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QLabel
from test_hands_in_the_cage import lab, stands
from test_nothing_is_cut import settle

from labcal.bench.coils.state import PlatformReading
from labcal.gui.ipc.messages import RunProcedure
from labcal.gui.translations import translate
from labcal.gui.widgets.rolled import LEAST_PX
from labcal.record.stream import Prompt, Step

MOUNT = Prompt(
    2.0, "mount-z", "Mount the DUT with body X up along the platform axis, body Y towards the cage's Y, at platform "
    "angle 0.", ("done", "redo x"), True, {"body_from_cage": np.eye(3).tolist(), "axis_cage": [0, 0, 1]},
)  # fmt: skip
WHY = "Is its plug in at both ends, and has it power? Nobody can tell from here which it is."
FAILED = Prompt(
    5.0, "failed-zero", "dut: lost", ("stop", "retry", "skip"),
    drawing={"no_answer": "dut", "what": "dut: no sample for 2.2 s.", "remedy": WHY},
)  # fmt: skip
READY = Prompt(3.0, "ready", "The coils go to 50 µT and the platform turns. Hands off?", ("done",), True)


def situations():
    silent = PlatformReading(fault="silent")
    yield lab(platform=stands())
    yield lab(platform=stands(), faulty=("reference", "dut"))
    yield lab((0.0, 0.0, 0.4), platform=stands())
    yield lab((0.0, 0.0, 0.0), platform=silent, faulty=("stage", "dut"))
    yield lab(platform=stands())


def asking(window, prompt, size):
    window.resize(*size)
    window.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    window.app_state.bench_worker.items.emit((Step(0.0, 1, 4, "zero", 60.0, ("zero", "z+20uT"), 20.0), prompt))
    window.open_page("Run")
    settle(window)
    return window.page("Run").live.prompt


SIZES, ASKED = [(984, 660), (1024, 700), (1440, 900)], [MOUNT, FAILED, READY]
EACH = [
    pytest.param(
        spoken, ASKED[i], SIZES[j], id=f"{spoken}-{ASKED[i].key}-{SIZES[j]}", marks=[] if short else pytest.mark.slow
    )
    for i in range(3)
    for j in range(3)
    for spoken, short in (
        ("en", (i + j) % 2),
        ("de", not (i + j) % 2),
    )  # fast: each question in each size, in one language
]


@pytest.fixture
def spoken(request, qapp, same_window):
    translate.install_translator(qapp, QLocale(request.param))
    yield same_window
    translate.install_translator(qapp, QLocale("en"))


@pytest.mark.parametrize(("spoken", "prompt", "size"), EACH, indirect=["spoken"])
def test_the_buttons_stay_where_they_are_in_sight_and_every_word_is_whole(spoken, prompt, size):
    card, places = asking(spoken, prompt, size), set()
    area = spoken.lazy_pages["Run"].area
    for known in situations():
        spoken.app_state.bench_worker.states.emit(known)
        settle(spoken)
        buttons = list(card.choices.values())
        places.add(tuple(str(one.mapTo(spoken, one.rect().topLeft()).toTuple()) for one in buttons))
        for one in buttons:
            seen = one.mapTo(area, one.rect().bottomRight())
            assert seen.y() <= area.height()
            assert seen.x() <= area.width()
        assert not area.horizontalScrollBar().isVisible()
        for said in card.findChildren(QLabel):
            if said.isVisibleTo(card) and said.wordWrap() and said is not card.text:
                assert said.height() >= said.heightForWidth(said.width()), said.text()
    assert len(places) == 1


def test_there_is_always_a_place_for_the_first_of_the_words(same_window):
    card = asking(same_window, MOUNT, (1024, 700))
    assert card.hands.mapTo(card, card.hands.rect().topLeft()).y() < card.height()
    assert LEAST_PX > 100


@pytest.mark.parametrize("size", [(1360, 860), (1920, 1080)], ids=str)
def test_a_note_that_comes_does_not_make_the_letters_of_the_question_smaller(fixed, size):
    card = asking(fixed, MOUNT, size)
    fixed.app_state.bench_worker.states.emit(lab(platform=stands()))
    settle(fixed)
    large, stood = card.text.font().pointSize(), card.stands.y()
    card.say_lost(["stage"])
    card.say_lost([])
    settle(fixed)
    assert card.details.text() == "stage: answers again"
    assert (card.text.font().pointSize(), card.stands.y()) == (large, stood)
    card.say_moved("17:49:10: platform 0.0°")
    settle(fixed)
    assert card.moved.isVisible()
    assert (card.text.font().pointSize(), card.stands.y()) == (large, stood)


@pytest.mark.parametrize("size", [(1360, 860), (1920, 1080)], ids=str)
def test_the_drawing_has_a_third_of_the_height_of_its_card(fixed, size):
    card = asking(fixed, MOUNT, size)
    fixed.app_state.bench_worker.states.emit(lab(platform=stands()))
    settle(fixed)
    fixed.grab()
    drawn = [place.top() for place in card.drawing.names.values()]
    words = card.drawing.fontMetrics().height()
    assert card.drawing.words_top() + words - min(drawn) > card.height() / 3
