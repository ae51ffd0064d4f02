"""What technicians found on their way through the window: small things, each by its cause."""

import time
from dataclasses import replace

import pytest
from lab_states import told
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QLabel, QLineEdit
from test_long_work import fitted
from test_long_work import studied as studied
from test_nothing_is_cut import large as large
from test_nothing_is_cut import measuring, settle
from test_nothing_is_cut import sized as sized
from test_one_dut import listed as listed
from test_one_dut import open_from_history

from labcal.bench.coils.state import CoilReading, Heard, LabState
from labcal.gui.ipc.answers import Ended, FitFigures, Fitted, Identified
from labcal.gui.ipc.messages import Identify, Rehearse, RunProcedure
from labcal.gui.ipc.wire import Fault
from labcal.gui.widgets.common import Card
from labcal.gui.widgets.plots import CIRCLES_PX

SMALL = (1024, 700), (1360, 760)
PLAN = (
    "preflight",
    "largest field at the DUT 50.0 µT",
    "turns between -20 and 20 °/s",
    *(f"x+{n}0uT-nominal: one turn there and back, 36 s" for n in range(12)),
)


def blue(widget):
    return widget.objectName() == "primary"


def test_begin_is_not_blue_below_a_red_card(still):
    choose = still.page("Run").choose
    assert blue(choose.start)
    still.app_state.off.warn(Fault("coils", "coils NOT confirmed at zero: supply_z gave no answer"))
    assert still.fault.isVisible()
    still.app_state.age_timer.timeout.emit()
    settle(still)
    assert not blue(choose.start)
    assert not (blue(still.next) and still.next.text().startswith("Next: Begin"))
    still.app_state.off.unconfirmed = None
    still.app_state.fault_over.emit(still.fault.fault)
    assert blue(choose.start)


def test_begin_is_not_blue_while_a_supply_is_not_at_zero(still):
    still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    told(still, (0.0, 0.0, None))
    still.app_state.bench_worker.answer(RunProcedure, Ended("r1", "finished"))
    still.page("Run").live.put_away.emit()
    assert not blue(still.page("Run").choose.start)


def planned(still):
    choose = still.page("Run").choose
    choose.rehearse()
    still.app_state.bench_worker.answer(Rehearse, PLAN)
    return choose


@pytest.mark.parametrize("size", SMALL)
def test_a_long_plan_takes_no_room_from_the_settings(still, sized, size):
    choose = still.page("Run").choose
    sized(size, False)
    settle(still)
    before = choose.area.height()
    planned(still)
    settle(still)
    assert choose.area.height() == before
    plan, seen = choose.plan, choose.area.viewport()
    assert plan.height() >= plan.heightForWidth(plan.width())
    assert seen.rect().contains(plan.mapTo(seen, QPoint(0, 0)))  # its begin is in sight


@pytest.mark.parametrize("size", SMALL)
def test_no_setting_is_cut_in_half_before_it_is_rolled(still, sized, size):
    choose = planned(still)
    sized(size, False)
    settle(still)
    choose.area.verticalScrollBar().setValue(0)
    choose.form.more.setChecked(True)
    settle(still)
    seen = choose.area.viewport()
    fields = [one for one in choose.form.findChildren(QLineEdit) if one.isVisible()]
    tops = [(one.mapTo(seen, QPoint(0, 0)).y(), one.height()) for one in fields]
    assert tops[-1][0] > seen.height()  # there is more than is in sight
    assert not [top for top, high in tops if top < seen.height() < top + high]


def right_edge(window, card):
    return card.mapTo(window, card.contentsRect().topRight()).x()


def test_the_card_of_the_run_that_is_shown_is_as_wide_as_the_column_below_it(listed, sized):
    open_from_history(listed, "r21")
    listed.page("Fit")
    sized((1024, 700), False)
    settle(listed)
    page = listed.lazy_pages["Fit"]
    assert page.area.verticalScrollBar().isVisible()
    below = {right_edge(listed, card) for card in page.page.findChildren(Card) if card.isVisible()}
    assert max(below) == right_edge(listed, listed.shown_bar)
    assert page.area.horizontalScrollBar().maximum() == 0


def standing_of(window):
    bench = window.page("Bench")
    bench.show_readings()
    return {bench.table.text(row, 5) for row in range(bench.table.rowCount())}


def test_while_everybody_is_asked_nobody_is_said_not_to_be(still):
    still.open_page("Bench")
    assert standing_of(still) == {"○ not asked"}
    still.page("Bench").check_all()
    assert standing_of(still) == {"… being asked"}
    assert still.side.read_all.isEnabled()  # who they are is another question than what they read
    still.app_state.off_worker.answer(Identify, Identified((), None))
    assert standing_of(still) == {"○ not asked"}


@pytest.mark.parametrize("who", ["a run that begins", "Read all"])
def test_so_as_a_run_begins_and_as_everybody_is_read(still, who):
    still.open_page("Bench")
    if who == "Read all":
        still.side.read_all.click()
    else:
        still.app_state.run.start(RunProcedure("preflight", "bench.toml", {}, "EM-07", "J. Doe"))
    still.app_state.grow_old()
    assert standing_of(still) == {"… being asked"}


def place(window, button):
    return button.mapTo(window, QPoint(0, 0))


def opened(window, qtbot, button):
    """Where a button was, and is once what it opens is there."""
    settle(window)
    before = place(window, button)
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)
    settle(window)
    return before, place(window, button)


def test_the_details_of_a_card_open_below_their_button(still, qtbot):
    still.app_state.fault.emit(Fault("crash", "Something broke.", "Try again.", "Traceback:\n" + 40 * "line\n"))
    before, after = opened(still, qtbot, still.fault.fold)
    assert still.fault.details.isVisible()
    assert after == before


def test_settings_that_are_folded_open_below_their_button(still, qtbot):
    form = still.page("Run").choose.form
    qtbot.waitUntil(form.isVisible)
    before, after = opened(still, qtbot, form.more)
    assert [field for field in form.fields.values() if field.isVisible() and place(still, field).y() > after.y()]
    assert after == before


def test_why_a_method_has_no_part_opens_below_its_button(still, studied, qtbot, sized):
    still.open_page("Fit")
    page = still.page("Fit")
    studied.fits = {"ml": fitted(10.0, 10.0), "ekf": Fitted(FitFigures(False, "the filter has diverged"))}
    studied.changed.emit()
    page.idle_queue.finish()
    sized((1360, 1000), False)
    before, after = opened(still, qtbot, page.fold)
    assert page.why.isVisible()
    assert after == before


@pytest.mark.parametrize("size", SMALL)
def test_below_a_red_card_the_circles_of_a_turn_are_still_to_be_read(still, sized, size):
    """They were 48 px high at 1024 × 700, where each is 140 px wide."""
    still.open_page(measuring(still))
    still.app_state.off.warn(Fault("coils", "coils NOT confirmed at zero: supply_z gave no answer"))
    for _ in range(2):
        sized(size, False)
        settle(still)
    for one in still.page("Run").live.loci.plots:
        assert one.height() >= min(one.width(), CIRCLES_PX)


def test_the_row_of_the_dut_says_that_it_is_not_looked_at_at_rest(still):
    """Its plug was out, and nothing said that nobody looks."""
    still.open_page("Bench")
    bench = still.page("Bench")
    heard = tuple(Heard(name, time.monotonic() - 35.0) for name in still.app_state.facts.instruments)
    coils = tuple(CoilReading(axis, None, 0.0, True, None, time.monotonic()) for axis in "xyz")
    still.app_state.take_lab(LabState(coils, instruments=heard))
    bench.show_readings()
    said = {bench.table.text(row, 1): bench.table.text(row, 5) for row in range(bench.table.rowCount())}
    assert said["dut"] == "◌ 35 s ago, not looked at at rest"
    row = next(row for row in range(bench.table.rowCount()) if bench.table.text(row, 1) == "dut")
    assert "opens its port" in bench.table.item(row, 5).toolTip()
    assert [name for name, words in said.items() if "not looked at" in words] == ["dut"]
    assert "dut" not in still.app_state.off.to_be_read()  # so it is
    still.app_state.take_lab(LabState(coils, instruments=(Heard("dut", None, "no samples"),)))
    bench.show_readings()
    assert "dut" in still.app_state.off.to_be_read()  # one that was lost is looked at until it is back
    assert not [row for row in range(bench.table.rowCount()) if "not looked at" in bench.table.text(row, 5)]


def cut_at_once(window):
    """Words of the panel on hands that have no room for all their lines, before Qt has come to lay anything out."""
    group = window.side.hands_group
    words = [one for one in group.findChildren(QLabel) if one.isVisible()]
    low = [one for one in words if one.height() < one.heightForWidth(one.width())]
    return [one.text() for one in (*low, *(one for one in words if one.geometry().bottom() > group.height()))]


def test_no_frame_shows_half_a_line_of_the_panel_on_hands(still):
    state = replace(still.app_state.lab.state, keep_off=("HANDS OFF", "off"), hands=("▲ Hands off: coils on", "off"))
    still.show_state(state)
    settle(still)
    why = "▲ Hands off: coils on: x +1.520 A, z −0.400 A; platform turns, at 41°; the field says: still on"
    still.show_state(replace(state, keep_off=("✕ HANDS OFF: not as planned", "bad"), hands=(why, "bad")))
    assert cut_at_once(still) == []
    still.show_state(still.app_state.lab.state)
