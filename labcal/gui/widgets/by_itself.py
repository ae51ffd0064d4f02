"""Each part of the frame is shown by itself: one that fails loses what it showed and says so, and the others go on.

A number that stands while its part has failed would be taken for one of now.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab import LabState

CANNOT = QT_TRANSLATE_NOOP("Words", "cannot be shown")


def cannot_be_shown() -> str:
    """In place of what stood there."""
    return translated(str(CANNOT))


@dataclass(frozen=True, slots=True)
class ShownPart:
    """`show` writes a state; `blank` takes away whatever stands there, and says that it cannot be shown."""

    show: Callable[[LabState], object]
    blank: Callable[[], object]


class ByItself:
    """Shows `parts` in their order; what one fails over is told once, until that part can be shown again."""

    def __init__(self, *parts: ShownPart) -> None:
        self._parts, self._failed = parts, set[int]()

    def show(self, state: LabState) -> None:
        """Each part, whatever becomes of the others."""
        for number, part in enumerate(self._parts):
            try:
                part.show(state)
                self._failed.discard(number)
            except Exception:
                part.blank()
                if number not in self._failed:
                    self._failed.add(number)
                    sys.excepthook(*sys.exc_info())  # the window's own: a card
