"""A bar that moves while something is computed; filled as far as that is known to be done."""

from __future__ import annotations

from PySide6.QtWidgets import QProgressBar


class WorkBar(QProgressBar):
    """In sight while there is work."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextVisible(False)
        self.setAccessibleName(self.tr("Something is being computed"))
        self.show_work(False)

    def show_work(self, busy: bool, share: float | None = None) -> None:
        """Be filled to `share`, where it is known, else move; or be gone."""
        self.setRange(0, 1 if not busy else 0 if share is None else 100)  # one that is out of sight moves nothing
        if busy and share is not None:
            self.setValue(round(100 * share))
        self.setVisible(busy)
