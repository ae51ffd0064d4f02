"""A plot whose size or theme has changed is drawn in an event of its own; until then its place is blank."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, Qt, QTimer
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QGraphicsView, QWidget

REPAINT_DELAY_MS = 30


class Ground(QWidget):
    """Over a plot, in its colour: else what stood at this place before would be seen there, torn."""

    def __init__(self, view: QGraphicsView) -> None:
        super().__init__(view)
        self._view = view
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.hide()

    def paintEvent(self, event: QPaintEvent) -> None:
        """One colour."""
        QPainter(self).fillRect(self.rect(), self._view.backgroundBrush())

    def cover(self) -> None:
        """All of it."""
        self.setGeometry(self._view.rect())
        self.raise_()
        self.show()


class DeferredRepaint(QObject):
    """Has a plot drawn in an event of its own where its size or its theme has changed, once it has come to rest."""

    def __init__(self, view: QGraphicsView) -> None:
        super().__init__(view)
        self._view, self._ground = view, Ground(view)
        self._over = QTimer(self, interval=REPAINT_DELAY_MS, singleShot=True)
        self._over.timeout.connect(self._draw)
        view.installEventFilter(self)

    def begin(self) -> None:
        """Draw nothing until it has come to rest."""
        self._view.viewport().setUpdatesEnabled(False)
        self._ground.cover()
        self._over.start()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Another size: everything in it is drawn anew."""
        if event.type() == QEvent.Type.Resize:
            self.begin()
        return False

    def _draw(self) -> None:
        if (holder := self._view.parentWidget()) is not None and not holder.updatesEnabled():
            return self.begin()  # the whole page is being styled
        self._view.viewport().setUpdatesEnabled(True)
        self._ground.hide()
        return self._view.viewport().repaint()
