"""How large the letters of plots are: those of the window, also where these are to be read from two metres.

Nothing here imports what draws plots: the window is in sight before that.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QApplication, QGraphicsView, QWidget

from labcal.gui.theming.theme import SMALL

SIDES = ("bottom", "left")


class Letters(QObject):
    """`scale` times their size; `changed` once every plot has them."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.scale = 1.0

    def font(self) -> QFont:
        """Of figures, names of axes and names of lines."""
        font = QFont(QApplication.font())
        font.setPointSizeF(self.scale * font.pointSizeF())
        return font


LETTERS = Letters()


def title_size() -> str:
    """Of what is written above a plot."""
    return f"{LETTERS.scale * SMALL:g}pt"


def say_above(widget: Any, words: str | None) -> None:
    """Write `words` above a plot, None: nothing; however long they are or were, it is no wider than its place."""
    item = widget.getPlotItem()
    label = item.titleLabel
    label.updateMin = lambda: label.setMinimumSize(0, label.itemRect().height())  # pyqtgraph calls it at each resize
    item.setTitle(words, size=title_size())


def fit_letters(widget: Any) -> None:
    """Give a plot the letters of now: its figures, the names of its axes and lines, and what stands above it."""
    item, font = widget.getPlotItem(), LETTERS.font()
    for side in SIDES:
        axis = item.getAxis(side)
        axis.setTickFont(font)
        axis.label.setFont(font)
        axis.textWidth, axis.textHeight = 30, 18  # as pyqtgraph begins: it grows by what is written
        axis._updateLabel()
        axis.resizeEvent()  # the name in the middle
    for one in item.items:
        for named in (one, getattr(one, "label", None)):
            if (letters := getattr(named, "setFont", None)) is not None:
                letters(font)
    if item.titleLabel.isVisible():
        say_above(widget, item.titleLabel.text)


def scale_plots(window: QWidget, scale: float) -> None:
    """All of `window` have letters `scale` times their size, and so have those that come later."""
    if scale != LETTERS.scale:
        LETTERS.scale = scale
        for one in window.findChildren(QGraphicsView):
            if (repaint := getattr(one, "deferred_repaint", None)) is not None:
                repaint.begin()
                fit_letters(one)
        LETTERS.changed.emit()
