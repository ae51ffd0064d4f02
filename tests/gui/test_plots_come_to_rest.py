"""Where a plot is to be drawn anew nothing is seen of what stood at its place before, not for one frame."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QPixmap
from PySide6.QtWidgets import QApplication, QWidget

from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.widgets.plots import apply_theme, plot

BEFORE = "#ff00ff"


def frame(widget):
    """Its colours (height, width), drawn over what stood there before."""
    picture = QPixmap(widget.size())
    picture.fill(QColor(BEFORE))
    QWidget.render(widget, picture, QPoint())
    image = picture.toImage()
    return {image.pixelColor(x, y).name() for x in range(0, image.width(), 3) for y in range(0, image.height(), 3)}


@pytest.fixture
def drawn(qtbot):
    widget = plot(LIGHT, "time  s", "field  nT")
    qtbot.addWidget(widget)
    widget.resize(300, 200)
    widget.plot(np.arange(50.0), np.arange(50.0))
    widget.show()
    qtbot.waitUntil(lambda: len(frame(widget)) > 1)
    return widget


def larger(widget):
    widget.resize(400, 260)
    QApplication.processEvents()
    return LIGHT


def dark(widget):
    apply_theme(widget, DARK)
    return DARK


@pytest.mark.parametrize("change", [larger, dark])
def test_its_place_is_blank_until_it_is_drawn(drawn, qtbot, change):
    theme = change(drawn)
    assert frame(drawn) == {QColor(theme.surface).name()}
    qtbot.waitUntil(lambda: len(frame(drawn)) > 1)
    assert BEFORE not in frame(drawn)
