"""A small line that takes no room while it says nothing."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel


class Remark(QLabel):
    """As a wrapped caption of `label`; away where there is no word."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setObjectName("caption")
        self.setWordWrap(True)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.hide()

    def setText(self, text: str) -> None:
        """Write `text`, and be there for it."""
        super().setText(text)
        self.setVisible(bool(text))
