"""In a window of 984 × 660 nothing lies beside the page: no page is wider than its place."""

from dataclasses import replace

import pytest
from PySide6.QtWidgets import QApplication, QStyle, QStyleOptionComboBox, QToolTip
from test_a_question_keeps_its_places import asking
from test_calibration_views import FOUND
from test_compare import side
from test_nothing_is_cut import WORST, begun, by_word, settle, traced
from test_nothing_is_cut import large as large
from test_nothing_is_cut import other_language as other_language
from test_nothing_is_cut import sized as sized
from test_path import RUN
from test_sixth_walk import STANDS

from labcal.bench.coils.agreement import BEFORE_HANDS
from labcal.gui.ipc.answers import Comparison
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.theming.theme import LIGHT
from labcal.gui.widgets.measurement_table import MeasuredCard
from labcal.gui.widgets.rolled import Rolled

SMALL = (984, 660)


@pytest.mark.parametrize("page", ["Start", "Bench", "Run", "Fit", "Loop", "Certificate", "History"])
def test_no_page_is_wider_than_a_small_window(same_window, qtbot, page):
    same_window.resize(*SMALL)
    same_window.app_state.set_identity(dut="MAG-0043", operator="J. Doe")
    same_window.open_page(page)
    same_window.page(page)
    broken = replace(RUN, dut_serial="MAG-0043", status="interrupted", simulated=True)
    same_window.app_state.quick_worker.answer(ListRuns, (broken,))
    qtbot.wait(50)
    QApplication.processEvents()
    assert (same_window.width(), same_window.height()) == SMALL
    bar = same_window.lazy_pages[page].area.horizontalScrollBar()
    assert bar.maximum() == 0


def test_whether_hands_may_go_in_is_seen_whole_at_a_question_after_an_interruption(same_window):
    """An inner bar cut "✓ Hands may go in: … the reference has no"."""
    card = asking(same_window, STANDS, SMALL)
    said = "✓ Hands may go in: coils at zero, each was read back, platform stands; the reference has no say in that"
    card.hands.setText(said)
    card.hands.show()
    settle(same_window)
    rolled = card.findChild(Rolled)
    assert card.hands.mapTo(rolled, card.hands.rect().bottomLeft()).y() < rolled.viewport().height()


def test_the_longest_reservation_is_whole_below_the_longest_such_question(still, sized, later):
    """As a preflight asks it, gone on with at 1024 × 700, on a bench that began anew."""
    whole = "Is the DUT still mounted with body X up, exactly as it was before the interruption?"
    still.open_page(by_word(still, replace(STANDS, text=whole)))
    run, worker = still.app_state.run, still.app_state.bench_worker
    run.anew = run.goes_on = True
    worker.states.emit(replace(run.lab, reference=replace(run.lab.reference, why=BEFORE_HANDS)))
    for _ in range(2):
        sized((1024, 700), False)
        settle(still)
    card = still.page("Run").live.prompt
    assert card.hands.text().endswith(f"{BEFORE_HANDS} · read 1 s ago")
    rolled = card.findChild(Rolled)
    assert card.hands.height() >= card.hands.heightForWidth(card.hands.width())
    assert card.hands.mapTo(rolled, card.hands.rect().bottomLeft()).y() < rolled.viewport().height()
    assert still.lazy_pages["Run"].area.horizontalScrollBar().maximum() == 0


def test_the_verdict_of_a_measurement_is_seen(same_window):
    same_window.resize(*SMALL)
    begun(same_window, WORST)
    same_window.open_page("Run")
    settle(same_window)
    table = same_window.page("Run").live.table
    assert table.columnViewportPosition(5) + table.columnWidth(5) <= table.viewport().width()
    assert same_window.lazy_pages["Run"].area.horizontalScrollBar().maximum() == 0


def test_large_letters_on_a_large_screen_keep_no_window_large(same_window):
    """Two runs compared, in the largest letters: made small at once, it is as small as it was made, and whole."""
    same_window.open_page("History")
    page = same_window.page("History")
    page.comparison.show_comparison(Comparison(side("r1", "r1.json"), side("r2", "r2.json"), FOUND))
    page.faces.setCurrentWidget(page.comparison)
    same_window.toggle_wall()
    same_window.resize(3840, 2160)
    settle(same_window)
    same_window.resize(*SMALL)
    settle(same_window)
    assert (same_window.width(), same_window.height()) == SMALL
    assert same_window.lazy_pages["History"].area.horizontalScrollBar().maximum() == 0
    same_window.resize(200, 200)
    settle(same_window)
    assert same_window.width() >= same_window.minimumSizeHint().width() > 200
    same_window.resize(*SMALL)
    same_window.toggle_wall()


def test_where_there_is_no_room_for_larger_letters_that_is_said(same_window):
    same_window.resize(*SMALL)
    same_window.toggle_wall()
    assert same_window.message.text() == "The window has no room for larger letters: make it larger."
    assert same_window.message.text() in QToolTip.text()  # also there: a run writes the line below anew
    (tip,) = (one for one in QApplication.topLevelWidgets() if one.inherits("QTipLabel"))
    last = same_window.sidebar_buttons.buttons()[-1]
    below, side = last.mapTo(same_window, last.rect().bottomLeft()).y(), same_window.sidebar.width()
    top, left = same_window.mapFromGlobal(tip.pos()).y(), same_window.mapFromGlobal(tip.pos()).x()
    assert below <= top
    assert left + tip.width() <= side + tip.contentsMargins().left() + 4  # over no table, no button, no note
    switch = same_window.size_switch
    assert top + tip.height() <= switch.mapTo(same_window, switch.rect().topLeft()).y()
    same_window.toggle_wall()


@pytest.mark.parametrize(("page", "face"), [("History", "comparison"), ("History", "recording"), ("Bench", "editor")])
def test_what_a_face_out_of_sight_would_need_makes_no_page_wider(new_window, page, face):
    """Two runs once compared in large letters, or a bench file edited: the list was cut, with a bar below it."""
    new_window.open_page(page)
    hidden = getattr(new_window.page(page), face)
    new_window.resize(1024, 700)
    hidden.setMinimumWidth(2 * new_window.width())
    settle(new_window)
    assert new_window.lazy_pages[page].area.horizontalScrollBar().maximum() == 0


@pytest.mark.parametrize("other_language", ["en", "fr"], indirect=True)
def test_what_a_residual_is_drawn_against_is_whole(other_language, same_window, rest):
    window = rest(same_window)
    window.open_page(traced(window))
    window.resize(1024, 700)
    settle(window)
    chooser = window.page("Loop").against
    place = chooser.style().subControlRect(
        QStyle.ComplexControl.CC_ComboBox, styled(chooser), QStyle.SubControl.SC_ComboBoxEditField, chooser
    )
    assert chooser.currentText() != ""
    assert place.width() >= chooser.fontMetrics().horizontalAdvance(chooser.currentText())


def styled(chooser):
    option = QStyleOptionComboBox()
    chooser.initStyleOption(option)
    return option


@pytest.mark.parametrize("width", [300, 420, 700])
def test_the_newest_of_what_was_measured_is_in_sight_below_its_headings(qtbot, width):
    card = MeasuredCard(LIGHT)
    qtbot.addWidget(card)
    card.show()
    name = "mount-z: DUT less reference, first position, before the field went on and after it"
    card.table.show_measurements([replace(WORST, name=name)])
    for _ in range(3):
        QApplication.processEvents()
        card.resize(width, card.minimumHeight())
    seen = card.table.viewport().height()
    assert card.table.rowViewportPosition(0) == 0
    assert card.table.rowHeight(0) <= seen
