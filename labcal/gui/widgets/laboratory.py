"""Whose lab this is: its logo, as it is printed on certificates, and its name."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QLabel

from labcal.files.home import home
from labcal.gui.theming.theme import GRID

FILES = ("logo.svg", "logo.png")  # in labcal's folder
HIGH, WIDE = 6 * GRID, 16 * GRID


class Logo(QLabel):
    """The picture that lies in labcal's folder; nothing where none does, or it cannot be read."""

    def __init__(self) -> None:
        super().__init__()
        self.setAccessibleName(self.tr("The laboratory's logo"))
        self.look()

    def look(self) -> None:
        """Look for it anew."""
        pictures = (QPixmap(str(file)) for name in FILES if (file := home() / name).is_file())
        found = next((one for one in pictures if not one.isNull()), None)
        if found is not None:
            smooth = Qt.TransformationMode.SmoothTransformation
            self.setPixmap(found.scaled(WIDE, HIGH, Qt.AspectRatioMode.KeepAspectRatio, smooth))
        self.setVisible(found is not None)
