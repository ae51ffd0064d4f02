"""Lines of a card that come, go and grow while it tells of one thing: what stands below them does not move up."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel


class KeptLines:
    """Each of `lines` keeps the room that it had in sight, until `forget`."""

    def __init__(self, *lines: QLabel) -> None:
        self._lines = lines

    def keep(self) -> None:
        """Before they say something else, or go."""
        for one in self._lines:
            if one.isVisible():
                one.setMinimumHeight(max(one.minimumHeight(), min(one.height(), one.heightForWidth(one.width()))))
                self._retain(one, kept=True)

    def forget(self) -> None:
        """Something else is told, or the card has another width."""
        for one in self._lines:
            one.setMinimumHeight(0)
            self._retain(one, kept=False)

    @staticmethod
    def _retain(line: QLabel, *, kept: bool) -> None:
        policy = line.sizePolicy()
        if policy.retainSizeWhenHidden() != kept:
            policy.setRetainSizeWhenHidden(kept)
            line.setSizePolicy(policy)
