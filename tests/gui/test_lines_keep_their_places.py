"""On the card of coils that may be on, what stands below a line that is shorter now, or has gone, does not move up."""

import pytest
from PySide6.QtWidgets import QApplication, QVBoxLayout, QWidget

from labcal.gui.ipc.wire import Fault
from labcal.gui.widgets.fault_card import FaultCard


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


def tops(card):
    return card.not_read.y(), card.coils.y()


@pytest.mark.parametrize("platform", ["platform stands at 69°", "platform turns, at 69°"])
@pytest.mark.parametrize("by_hand", [("supply_x",), ()])
def test_what_stands_below_keeps_its_place(card, by_hand, platform):
    before = tops(card)
    assert card.by_hand.height() > card.by_hand.fontMetrics().height() * 1.5  # it has two lines
    says(card, by_hand=by_hand, platform=platform)
    moved = tops(card)  # where nobody is to be switched off any more, what failed is said below that
    assert moved == before if by_hand else moved[0] == before[0]
    says(card, by_hand=("supply_x", "supply_y", "supply_z"), not_read=("supply_w",), platform="platform turns, at 69°")
    assert tops(card) == before


def test_what_another_thing_is_told_of_begins_with_the_room_of_its_own(card):
    before = card.coils.y()
    card.show_fault(Fault("coils", "another", "By hand."))
    says(card, by_hand=("supply_x",))
    assert card.coils.y() < before
