"""Buttons that take each other's place: as wide as the widest, so that nothing beside them moves."""

from __future__ import annotations

from PySide6.QtWidgets import QSizePolicy, QStackedWidget, QWidget


class OnePlace(QStackedWidget):
    """One of `widgets` is in sight, at first the first."""

    def __init__(self, *widgets: QWidget) -> None:
        super().__init__()
        for one in widgets:
            self.addWidget(one)
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
