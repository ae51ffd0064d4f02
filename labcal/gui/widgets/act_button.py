"""A button of a run: it keeps its place whatever its neighbours say, and takes no click meant for what was there."""

from __future__ import annotations

import time

from PySide6.QtCore import QT_TRANSLATE_NOOP, QEvent, QPoint, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QMoveEvent
from PySide6.QtWidgets import QPushButton

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.said_for_now import SaidForNow
from labcal.gui.widgets import next_button
from labcal.gui.widgets.flow import Flow

JUST_CHANGED = QT_TRANSLATE_NOOP("Words", "The buttons of the run have just changed: nothing was done. Press again.")


class ActButton(QPushButton):
    """With several words it says one of them at a time, the first as it begins, and is as large as for the longest.

    `too_soon`: it was pressed before its new words, or its new place, could be seen, and does nothing.
    """

    too_soon = Signal()

    def __init__(self, words: str | tuple[str, ...], tip: str, *, primary: bool = False) -> None:
        self._words = (words,) if isinstance(words, str) else words
        super().__init__(self._words[0])
        self.setToolTip(tip)
        self.setObjectName("primary" if primary else "")
        self.setAutoDefault(False)
        self._place: QPoint | None = None  # in the window, when it was in sight last
        self._changed_s: float | None = None

    def say(self, nth: int) -> None:
        """What it does from now on: in which of its words."""
        if (words := self._words[nth]) != self.text():
            self.setText(words)
            self._changed_s = time.monotonic()

    def sizeHint(self) -> QSize:
        """For the longest of its words."""
        metrics, hint = self.fontMetrics(), super().sizeHint()
        sizes = [metrics.size(Qt.TextFlag.TextShowMnemonic, words) for words in self._words]
        now = metrics.size(Qt.TextFlag.TextShowMnemonic, self.text())
        more = QSize(max(one.width() for one in sizes), max(one.height() for one in sizes)) - now
        return hint + more.expandedTo(QSize(0, 0))

    def minimumSizeHint(self) -> QSize:
        """No smaller."""
        return self.sizeHint()

    def event(self, event: QEvent) -> bool:
        """It comes into sight in a place where another button may have been; a page that is opened is none."""
        if event.type() == QEvent.Type.ShowToParent:
            self._changed_s = time.monotonic()
        return super().event(event)

    def moveEvent(self, event: QMoveEvent) -> None:
        """Another place in the window: a card that grows upward moves nothing in it."""
        place = self.mapTo(self.window(), QPoint())
        if place != self._place:
            self._place, self._changed_s = place, time.monotonic()
        super().moveEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Not taken where it has just changed."""
        self.too_soon.emit() if self._just_changed() else super().mousePressEvent(event)

    def _just_changed(self) -> bool:
        return self._changed_s is not None and time.monotonic() - self._changed_s < next_button.TOO_SOON_MS / 1000


def in_a_row(said: SaidForNow, *acts: ActButton) -> Flow:
    """All of them; a press that is not taken is said in the line below."""
    for act in acts:
        act.too_soon.connect(lambda: said.say(translated(str(JUST_CHANGED))))
    return Flow(*acts)
