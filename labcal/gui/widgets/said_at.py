"""Says at a button why it does nothing."""

from __future__ import annotations

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QToolTip, QWidget

SHOWN_MS = 6000


def say_at(widget: QWidget, words: str) -> None:
    """Beside `widget`, for some seconds."""
    QToolTip.showText(widget.mapToGlobal(QPoint(0, 0)), words, widget, widget.rect(), SHOWN_MS)
