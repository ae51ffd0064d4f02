"""The line below every page shows whole lines: a second one where there is room for it, else dots."""

import pytest
from PySide6.QtGui import QFontMetrics, QImage
from PySide6.QtWidgets import QWidget

from labcal.gui.widgets.two_lines import TwoLines

LONG = "Mount the DUT with body Z up along the platform axis, body X towards the cage's X, at platform angle 0."


def inked(image: QImage) -> list[int]:
    """The rows of pixels in which something is written, left of the dots."""
    paper = image.pixel(0, 0)
    return [y for y in range(image.height()) if any(image.pixel(x, y) != paper for x in range(image.width() // 2))]


@pytest.mark.parametrize("lines", [1.0, 1.6, 2.0])
def test_no_line_is_cut_through_however_high_its_place_is(qtbot, lines):
    holder = QWidget()
    qtbot.addWidget(holder)
    said = TwoLines()
    said.setParent(holder)
    said.setText(LONG)
    font = said.font()
    font.setPointSize(14)
    said.setFont(font)
    metrics = QFontMetrics(font)
    said.resize(int(metrics.horizontalAdvance(LONG) * 0.7), round(lines * metrics.lineSpacing()))
    holder.resize(said.size())
    holder.show()
    rows = inked(holder.grab().toImage())
    assert said.is_cut() is (lines < 2)  # dots say so
    assert (rows[-1] - rows[0] > metrics.lineSpacing()) is (lines == 2)  # two lines where both are whole, else one
