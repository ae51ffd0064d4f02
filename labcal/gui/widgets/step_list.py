"""The steps of a run as a list: what is done, what goes on, what comes, what was left out or broke."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QListWidget, QListWidgetItem

from labcal.gui.theming.theme import Theme
from labcal.gui.viewmodels.number_format import step_title
from labcal.gui.widgets.mark_column import BEHIND, MarkedItems

SHAPES = {"done": "✓", "now": "●", "next": "○", "skipped": "–", "broken": "✕"}


class StepList(QListWidget):
    """Keeps the step that goes on, or that broke, in sight."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("Steps"))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setWordWrap(True)
        self.setResizeMode(QListWidget.ResizeMode.Adjust)
        self.setItemDelegate(MarkedItems(self, SHAPES.values()))

    def show_steps(self, steps: Sequence[tuple[str, str]], theme: Theme) -> None:
        """Each step by its name, and how it stands: a key of `SHAPES`."""
        if self.count() != len(steps):
            self.clear()
            self.addItems([step_title(name) for name, _ in steps])
        for row, (name, mark) in enumerate(steps):
            _show(self.item(row), f"{SHAPES[mark]}{BEHIND}{step_title(name)}", mark, theme)
            if mark in ("now", "broken"):
                self.setCurrentRow(row)
                self.scrollToItem(self.item(row))


def _show(item: QListWidgetItem, text: str, mark: str, theme: Theme) -> None:
    if item.text() != text:
        item.setText(text)
        item.setToolTip(text)  # a long one is cut in a narrow window
    colour = {"next": theme.muted, "broken": theme.bad}.get(mark, theme.text)
    if item.foreground().color().name() != colour:
        item.setForeground(QColor(colour))
