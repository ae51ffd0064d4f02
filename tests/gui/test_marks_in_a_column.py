"""Names behind marks begin at one place, whichever mark stands before them: drawn, in the letters that are in use."""

import pytest
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QApplication

from labcal.gui.side_panel import InstrumentRow
from labcal.gui.theming.stylesheet import apply_style
from labcal.gui.theming.theme import LIGHT, style_sheet
from labcal.gui.viewmodels.lab_now import LIGHT_SHAPES
from labcal.gui.viewmodels.path import SHAPES
from labcal.gui.widgets.common import named
from labcal.gui.widgets.mark_column import BEHIND, MarkedButton, mark_width
from labcal.gui.widgets.step_list import SHAPES as OF_STEPS
from labcal.gui.widgets.step_list import StepList

ROOM = 300, 40
RAIL_PX, ITEM_PX = 12, 8  # from the edge to the mark: padding, and of an item Qt's own margin and the frame


def right_of(widget, left):
    """What is drawn from `left` on."""
    return widget.grab(QRect(left, 0, ROOM[0] - left, ROOM[1])).toImage()


@pytest.mark.parametrize("scale", [1.0, 1.6])
def test_a_page_s_name_stands_where_it_is_whatever_its_mark(qtbot, scale):
    entry = named(MarkedButton("Certificate", SHAPES.values()), "rail")
    qtbot.addWidget(entry)
    apply_style(entry, style_sheet(LIGHT, scale))
    entry.resize(*ROOM)
    entry.show()
    left = RAIL_PX + mark_width(entry.fontMetrics(), SHAPES.values())
    drawn = {}
    for mark in ("", *SHAPES.values()):
        entry.set_mark(mark)
        assert entry.text() == f"{mark} Certificate".strip()
        drawn[mark] = right_of(entry, left)
    assert all(one == drawn["✓"] for one in drawn.values())
    assert drawn["✓"] != right_of(named(MarkedButton("", SHAPES.values()), "rail"), left)  # a name is drawn there


@pytest.mark.parametrize("chosen", [False, True])
def test_a_step_s_name_stands_where_it_is_whatever_its_mark(qtbot, chosen):
    shown = StepList()
    qtbot.addWidget(shown)
    apply_style(shown, style_sheet(LIGHT))
    shown.resize(*ROOM)
    shown.show()
    drawn = []
    for mark in ("done", "next", "now", "broken", "skipped"):
        shown.show_steps([("turn x", mark)], LIGHT)
        shown.item(0).setForeground(shown.palette().text())  # one colour for all
        shown.item(0).setSelected(chosen)
        QApplication.processEvents()
        drawn.append(right_of(shown, ITEM_PX + mark_width(shown.fontMetrics(), OF_STEPS.values(), " ")))
        assert shown.item(0).text().startswith(f"{OF_STEPS[mark]}{BEHIND}")
    assert all(one == drawn[0] for one in drawn)


def test_an_instrument_s_name_stands_where_it_is_whatever_its_light(qtbot):
    row = InstrumentRow()
    qtbot.addWidget(row)
    row.resize(*ROOM)
    row.show()
    lefts = set()
    for shape, colour, _ in LIGHT_SHAPES.values():
        row.show_light(shape, colour, "reference", "", aged=True, alone=False, back="")
        row.layout().activate()
        lefts.add(row.name.x())
    assert len(lefts) == 1
