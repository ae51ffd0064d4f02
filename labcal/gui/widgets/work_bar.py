"""A bar that moves while something is computed of which nobody knows how long it takes."""

from __future__ import annotations

from PySide6.QtWidgets import QProgressBar


class WorkBar(QProgressBar):
    """In sight while there is work."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextVisible(False)
        self.setAccessibleName(self.tr("Something is being computed"))
        self.show_work(False)

    def show_work(self, busy: bool) -> None:
        """Move, or be gone."""
        self.setRange(0, 0 if busy else 1)  # one that is out of sight moves nothing
        self.setVisible(busy)
