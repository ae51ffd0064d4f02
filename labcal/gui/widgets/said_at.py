"""Says near a button why it does nothing."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QToolTip, QWidget

SHOWN_MS = 6000
MARGIN_PX = 12  # of its frame, at each side


def say_below(widget: QWidget, words: str) -> None:
    """Below `widget`, no wider than it is, for some seconds: it lies over nothing beside it."""
    wrapped = f'<table width="{widget.width() - 2 * MARGIN_PX}"><tr><td>{escape(words)}</td></tr></table>'
    QToolTip.showText(widget.mapToGlobal(QPoint(0, widget.height())), wrapped, widget, widget.rect(), SHOWN_MS)
