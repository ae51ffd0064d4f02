"""A text that has the room of whatever may come to stand there: what stands beside it does not move when it does."""

from __future__ import annotations

from PySide6.QtCore import QRect, QSize, Qt
from PySide6.QtWidgets import QLabel

NO_END_PX = 10_000


class Roomy(QLabel):
    """As `label`; also while it is hidden it keeps its place."""

    def __init__(self, name: str = "", *, wrap: bool = False) -> None:
        super().__init__()
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setObjectName(name)
        self.setWordWrap(wrap)
        self.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._may_say: tuple[str, ...] = ()
        self._asked: object = None  # of a layout, which asks for the same again and again
        self._found = QSize()
        keeps = self.sizePolicy()
        keeps.setRetainSizeWhenHidden(True)
        self.setSizePolicy(keeps)

    def room_for(self, *texts: str) -> None:
        """There is to be room for each of these."""
        if texts != self._may_say:
            self._may_say = texts
            self.updateGeometry()

    def sizeHint(self) -> QSize:
        """That of the largest of them."""
        hint = super().sizeHint()
        return hint if self.wordWrap() else hint.expandedTo(self._room(NO_END_PX))

    def minimumSizeHint(self) -> QSize:
        """The same: in a wrapped text only lines are added."""
        hint = super().minimumSizeHint()
        return hint if self.wordWrap() else hint.expandedTo(self._room(NO_END_PX))

    def heightForWidth(self, width: int) -> int:
        """So many lines as the longest has."""
        return max(super().heightForWidth(width), self._room(width).height()) if self.wordWrap() else -1

    def _room(self, width: int) -> QSize:
        asked = (width, self.font().key(), self._may_say)
        if asked == self._asked:
            return self._found
        room, flags = QSize(), Qt.TextFlag.TextWordWrap if self.wordWrap() else Qt.TextFlag.TextSingleLine
        for text in self._may_say:
            seen = self.fontMetrics().boundingRect(QRect(0, 0, width, NO_END_PX), flags, text)
            room = room.expandedTo(seen.size())
        self._asked, self._found = asked, room
        return room
