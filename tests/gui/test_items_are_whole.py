"""In a list that wraps its items none ends in dots, however narrow it is."""

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import QApplication

from labcal.gui.theming.stylesheet import apply_style
from labcal.gui.theming.theme import LIGHT, style_sheet
from labcal.gui.widgets.grouped_list import GroupedList
from labcal.gui.widgets.step_list import StepList

WORDS = "Étalonner un DUT"


@pytest.mark.parametrize("kind", [GroupedList, StepList])
def test_an_item_has_the_lines_that_its_words_need(qtbot, kind):
    shown = kind()
    qtbot.addWidget(shown)
    shown.addItem(WORDS)
    apply_style(shown, style_sheet(LIGHT))
    shown.show()
    metrics, heights = shown.fontMetrics(), set()
    for width in range(100, 260, 2):
        shown.resize(width, 200)
        QApplication.processEvents()
        place = shown.visualItemRect(shown.item(0))
        within = QRect(0, 0, shown.viewport().width() - 18, 1000)  # 6 px of padding and 3 of Qt's own at each side
        needed = metrics.boundingRect(within, int(Qt.TextFlag.TextWordWrap), WORDS).height()
        assert place.height() >= needed + 8, width
        heights.add(place.height())
    assert len(heights) == 2  # of one line, and of two
