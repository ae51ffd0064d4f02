"""On the card of coils that may be on, what stands below a line that is shorter now, or has gone, does not move up."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from labcal.gui.ipc.wire import Fault
from labcal.gui.theming.theme import LIGHT
from labcal.gui.widgets.common import Card
from labcal.gui.widgets.fault_card import FaultCard
from labcal.gui.widgets.headline import HIGH, RunHeadline


@pytest.fixture
def holder(qtbot):
    made = QWidget()
    qtbot.addWidget(made)
    return made


@pytest.fixture
def card(holder):
    made = FaultCard()
    column = QVBoxLayout(holder)
    column.addWidget(made)
    column.addStretch(1)  # as the page below it takes what is left
    holder.resize(300, 900)
    holder.show()
    made.show_fault(Fault("coils", "no answer", "By hand: at its panel, or at its mains switch."))
    says(made, by_hand=("supply_x", "supply_y", "supply_z"), not_read=("supply_w",), platform="platform turns, at 69°")
    return made


def says(card, *, by_hand=(), not_read=(), platform="platform stands at 69°"):
    card.say_coils("coils NOT confirmed at zero", by_hand)
    card.say_not_read(not_read)
    card.say_platform(platform)
    for _ in range(3):
        QApplication.processEvents()


def holes(card):
    """Between each line in sight and the next: as far as they are apart; and what is kept below the last one."""
    lines = [card.gravest, card.by_hand, card.not_read, card.turning, card.text, card.coils, card.platform, card.remedy]
    seen = sorted((one.y(), one.y() + one.height()) for one in lines if one.isVisible())
    return {top - end for (_, end), (top, _) in pairwise(seen)}


@pytest.mark.parametrize("platform", ["platform stands at 69°", "platform turns, at 69°"])
@pytest.mark.parametrize("by_hand", [("supply_x",), ()])
def test_what_stands_below_keeps_its_place_and_no_line_leaves_a_hole(card, by_hand, platform):
    before = card.fold.y(), card.height()
    assert card.by_hand.height() > card.by_hand.fontMetrics().height() * 1.5  # it has two lines
    says(card, by_hand=by_hand, platform=platform)
    assert (card.fold.y(), card.height()) == before
    assert holes(card) == {card.body.spacing()}
    says(card, by_hand=("supply_x", "supply_y", "supply_z"), not_read=("supply_w",), platform="platform turns, at 69°")
    assert (card.fold.y(), card.height()) == before


def test_what_another_thing_is_told_of_begins_with_the_room_of_its_own(card):
    before = card.fold.y()
    card.show_fault(Fault("coils", "another", "By hand."))
    says(card, by_hand=("supply_x",))
    assert card.fold.y() < before


def test_an_alarm_is_whole_in_the_frame_in_which_it_comes(qtbot):
    card, below = Card(), QWidget()
    qtbot.addWidget(card)
    headline = RunHeadline(LIGHT)
    card.body.addWidget(headline)
    card.body.addWidget(below, 1)
    card.resize(500, 600)
    card.show()
    headline.say("Hands off · 66 s", "off")
    QApplication.processEvents()
    headline.say("HANDS OFF – coils on: x −0.106 A, y −0.026 A, z +1.133 A · Stopping", "bad")
    room = QRect(0, 0, headline.width(), 10_000)
    words = headline.fontMetrics().boundingRect(room, int(Qt.TextFlag.TextWordWrap), headline.text())
    assert words.height() <= headline.height() >= HIGH[0]
    assert below.geometry().top() > headline.geometry().bottom()
