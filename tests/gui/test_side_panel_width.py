"""Nothing at the right of the pages is wider than its column, whoever is back after a silence and however old it is."""

from dataclasses import replace

import pytest
from geometry import faults
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QLabel, QPushButton
from test_nothing_is_cut import doubted, settle
from test_nothing_is_cut import other_language as other_language

from labcal.gui.side_panel import MARGIN
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.back_again import BACK
from labcal.gui.widgets.rolled_column import RolledColumn

SIZES = {
    "1024 x 700": ((1024, 700), False),
    "1360 x 860": ((1360, 860), False),
    "1920 x 1080": ((1920, 1080), False),
    "1920 x 1080, F11": ((1920, 1080), True),
}


def back_again(window):
    """Everybody is back after a silence, and what each read is old."""
    doubted(window)
    lab = window.app_state.lab
    back = translated(str(BACK)).format("10:49:30", "10:49:21")
    lab.update(back=tuple((name, back) for name, _, _ in lab.state.now.lights))
    window.open_page("Start")


def right_edges(side):
    """How far at the right each text and button in sight of it ends, by its words."""
    parts = [one for kind in (QLabel, QPushButton) for one in side.findChildren(kind) if one.isVisible() and one.text()]
    return {one.text(): one.mapTo(side, QPoint(one.width(), 0)).x() for one in parts}


@pytest.mark.parametrize("other_language", ["en", "de", "fr"], indirect=True)
def test_no_line_of_the_panel_is_wider_than_it(other_language, new_window, rest):
    window = rest(new_window)
    back_again(window)
    found = []
    for words, (size, wall) in SIZES.items():
        window.resize(*size)
        if window.wall != wall:
            window.toggle_wall()
        for _ in range(2):
            window.resize(*size)
            settle(window)
        side = window.side
        wide = [text for text, right in right_edges(side).items() if right > side.width() - MARGIN]
        found += [f"{words}: {text!r} is wider than the panel" for text in wide]
        found += [f"{words}: {what}" for what in faults(side)]
        rows = [row for row in side.rows if row.isVisible()]
        assert rows
        assert all(row.back.text() for row in rows), words
    assert not found, "\n".join(found)


@pytest.fixture
def rolled(new_window):
    """The column at 1024 x 700, where it has a bar."""
    new_window.resize(1024, 700)
    back_again(new_window)
    settle(new_window)
    column = new_window.side.findChild(RolledColumn)
    assert column.verticalScrollBar().isVisible()
    return new_window, column


def test_the_bar_lies_over_no_figure_and_all_figures_end_on_one_line(rolled):
    window, column = rolled
    side = window.side
    bar = column.verticalScrollBar().mapTo(side, QPoint(0, 0)).x()
    ends = {one.mapTo(side, QPoint(one.width(), 0)).x() for grid in (side.coils, side.field) for one in grid.values}
    assert len(ends) == 1
    assert max(right_edges(side).values()) < bar
    window.resize(1920, 1080)
    settle(window)
    assert not column.verticalScrollBar().isVisible()
    assert {side.width() - one.mapTo(side, QPoint(one.width(), 0)).x() for one in side.field.values} == {MARGIN}


def test_no_row_is_halved_at_the_end_of_what_is_in_sight(rolled):
    window, column = rolled
    for high in range(660, 760, 10):
        window.resize(1024, high)
        settle(window)
        end = column.viewport().height()
        texts = [one for one in column.widget().findChildren(QLabel) if one.isVisible()]
        tops = [(one.mapTo(column.viewport(), QPoint()).y(), one) for one in texts]
        assert [one.text() for top, one in tops if top < end < top + one.height()] == [], high


@pytest.mark.parametrize("name", ["reference", "dut"])
def test_who_does_not_answer_comes_into_sight_in_a_low_window(rolled, name):
    window, column = rolled
    lab = window.app_state.lab
    column.verticalScrollBar().setValue(0)

    def in_sight(shown):
        row = window.side.rows[[one for one, *_ in lab.state.now.lights].index(shown)]
        seen = row.mapTo(column.viewport(), QPoint(0, 0)).y()
        return seen >= 0 and seen + row.height() <= column.viewport().height()

    def says(lost):
        lights = tuple((n, "fault" if n in lost else "ok", "no answer" if n in lost else "") for n, *_ in before)
        lab.update(now=replace(lab.state.now, lights=lights))
        settle(window)

    before = lab.state.now.lights
    says(())
    column.verticalScrollBar().setValue(0)
    assert not in_sight(name)
    says((name,))
    assert in_sight(name)
    column.verticalScrollBar().setValue(0)  # who rolls back is left alone
    lab.update(now=replace(lab.state.now))
    settle(window)
    assert column.verticalScrollBar().value() == 0
    says(("reference", "dut"))
    assert in_sight("dut" if name == "reference" else "reference")
    says(())
    assert column.verticalScrollBar().value() == 0
