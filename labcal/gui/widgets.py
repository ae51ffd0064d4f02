"""The few building blocks that every page uses: cards, captions, buttons, a column of aligned numbers."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtGui import QFont
from PySide6.QtWidgets import (
    QComboBox,
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from labcal.gui.theme import GRID
from labcal.gui.words import say

W = TypeVar("W", bound=QWidget)


def named(widget: W, name: str) -> W:
    """`widget` with the name that the style sheet knows it by."""
    widget.setObjectName(name)
    return widget


def label(text: str = "", name: str = "", *, wrap: bool = False) -> QLabel:
    """A text; `name` is its style: title, caption, large, simulated."""
    widget = QLabel(text)
    widget.setObjectName(name)
    widget.setWordWrap(wrap)
    widget.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    widget.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return widget


def shrinking(widget: W) -> W:
    """`widget` with its text cut off where there is no room: a long sentence widens no window."""
    widget.setMinimumWidth(1)
    return widget


def chooser(tip: str, name: str = "", *, letters: int = 12) -> QComboBox:
    """A list to choose from, as wide as it may be and no wider than `letters` where there is no room."""
    widget = QComboBox()
    widget.setToolTip(tip)
    widget.setAccessibleName(name or tip)
    widget.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    widget.setMinimumContentsLength(letters)
    widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return widget


def button(text: str, tip: str, *, primary: bool = False) -> QPushButton:
    """A push button; `primary` is the one thing to do on a page."""
    widget = QPushButton(text)
    widget.setToolTip(tip)
    widget.setObjectName("primary" if primary else "")
    widget.setAutoDefault(False)
    return widget


def set_primary(widget: QPushButton, primary: bool) -> None:
    """Make a button the one thing to do, or one of several."""
    if (name := "primary" if primary else "") != widget.objectName():
        widget.setObjectName(name)
        widget.style().unpolish(widget)
        widget.style().polish(widget)


def set_state(widget: QWidget, state: str) -> None:
    """Colour a label by state: good, warning, bad or ""."""
    if widget.property("state") != state:
        widget.setProperty("state", state)
        widget.style().unpolish(widget)
        widget.style().polish(widget)


def flat(widget: W) -> W:
    """`widget` no taller than what is in it."""
    widget.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Maximum)
    return widget


class Card(QFrame):
    """A titled surface; add to `body`."""

    def __init__(self, title: str = "", unit: str = "") -> None:
        super().__init__()
        self.setObjectName("card")
        outer = QVBoxLayout(self)
        outer.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        outer.setSpacing(GRID)
        self.heading = shrinking(label(title, "title"))
        self.unit = label(unit, "caption")
        head = QHBoxLayout()
        head.addWidget(self.heading)
        head.addStretch()
        head.addWidget(self.unit)
        if title or unit:
            outer.addLayout(head)
        self.body = QVBoxLayout()
        self.body.setSpacing(GRID)
        outer.addLayout(self.body, 1)


def tabular() -> QFont:
    """The interface's font with figures of one width, so that nothing jumps when a digit changes."""
    font = QFont()
    font.setFeature(QFont.Tag("tnum"), 1)
    return font


class Numbers(QWidget):
    """Rows of name, value and word, right-aligned in tabular figures."""

    def __init__(self, names: tuple[str, ...]) -> None:
        super().__init__()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(GRID)
        grid.setVerticalSpacing(GRID // 2)
        self._values, self._words = [label("–") for _ in names], [label("", "caption") for _ in names]
        for row, name in enumerate(names):
            grid.addWidget(label(say(name), "caption"), row, 0)
            grid.addWidget(self._values[row], row, 1)
            self._values[row].setAlignment(Qt.AlignmentFlag.AlignRight)
            grid.addWidget(self._words[row], row, 2)
            self._values[row].setFont(tabular())
        grid.setColumnStretch(1, 1)

    def show_row(self, row: int, value: str, word: str = "", state: str = "") -> None:
        """Write one row; "–" stands for what is not known."""
        self._values[row].setText(value)
        self._words[row].setText(word)
        set_state(self._words[row], state)
