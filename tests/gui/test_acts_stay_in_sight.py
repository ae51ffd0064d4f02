"""Note, Pause and Stop of a run are in sight whatever is said above them; and what is measured is no coin."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication
from test_field_as_witness import real_lines
from test_hands_in_the_cage import running as running
from test_hands_in_the_cage import says, stands
from test_nothing_is_cut import WORST, begun, measuring, settle

from labcal.gui.ipc.wire import Fault

LOST = Fault(
    "coils",
    "coils NOT confirmed at zero: z: the link was lost, no reply in 1.5 s",
    "See to its plug and its power. What was measured is kept.",
    "trace",
)


@pytest.fixture
def alarmed(new_window):
    """A supply is lost in a measurement, and the gravest card stands above every page."""
    measuring(new_window)
    new_window.open_page("Run")
    new_window.app_state.off.unconfirmed = LOST
    new_window.app_state.fault.emit(LOST)
    new_window.fault.say_coils("coils NOT confirmed at zero", ("supply_z",), "z: +1.520 A when last read, 10:52:28")
    new_window.app_state.lab.update(message="z is lost")
    return new_window


@pytest.mark.parametrize("size", [(1920, 1080), (1360, 860), (1024, 700)])
def test_the_acts_of_a_run_are_in_sight_below_the_card_of_a_lost_supply(alarmed, size):
    for _ in range(2):
        alarmed.resize(*size)
        settle(alarmed)
    QApplication.processEvents()
    assert alarmed.fault.isVisible()
    live = alarmed.page("Run").live
    for act in (live.note, live.photo, live.pause, live.stop):
        assert act.visibleRegion().boundingRect() == act.rect(), f"{act.objectName()} at {size}"
    end = live.stop.mapTo(alarmed, QPoint(0, live.stop.height())).y()
    assert end <= alarmed.bottom.mapTo(alarmed, QPoint()).y()


def test_what_is_measured_gives_way_to_the_pictures_below_such_a_card(alarmed):
    """The circles were coins, above a table of which one row was seen."""
    alarmed.resize(1360, 860)
    settle(alarmed)
    live = alarmed.page("Run").live
    assert not live.below.isVisible()
    assert live.loci.height() > live.loci.minimumSizeHint().height()
    alarmed.fault.close_card.click()
    alarmed.app_state.lab.update(message="")
    assert live.below.isVisible()


@pytest.mark.parametrize("high", range(700, 900, 40))
def test_the_last_row_in_sight_of_what_was_measured_is_a_whole_one(new_window, high):
    many = [replace(WORST, name=f"closure {n}") for n in range(12)]
    begun(new_window, *many)
    new_window.open_page("Run")
    new_window.resize(1360, high)
    settle(new_window)
    table = new_window.page("Run").live.table
    end = table.viewport().height()
    rows = [(table.rowViewportPosition(row), table.rowHeight(row)) for row in range(table.rowCount())]
    assert sum(top < end for top, _ in rows) >= 2
    assert [top for top, height in rows if top < end < top + height - 1] == []


def test_below_such_a_card_the_steps_have_the_room_of_what_is_not_promised(running):
    live = running.page("Run").live
    real_lines(running)
    running.resize(1360, 860)
    running.open_page("Run")
    says(running, (0.0, 0.0, 1.1), stands())
    live.draw()
    settle(running)
    promised, high = live.time_left.until.height(), live.time_left.height()
    says(running, (0.0, 0.0, None), stands(moving=True), ("supply_z",))
    live.draw()
    settle(running)
    assert running.app_state.lab.state.now.coil_words.startswith("coils NOT confirmed")
    assert 0 < promised <= high - live.time_left.height()
    says(running, (0.0, 0.0, 1.1), stands())
    live.draw()
    settle(running)
    assert live.time_left.height() == high
