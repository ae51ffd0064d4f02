"""A row of widgets that goes on in a second one where there is no room: no page is wider than its place."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtWidgets import QLayout, QLayoutItem, QWidget

from labcal.gui.theming.theme import GRID


class Flow(QLayout):
    """From the left; what can grow in a row gets what is left of it.

    Where nothing can the row stands at the right, but `left`.
    """

    def __init__(self, *widgets: QWidget, left: bool = False) -> None:
        super().__init__()
        self._at_left = left
        self._items: list[QLayoutItem] = []
        self._heights: dict[int, int] = {}  # by width: Qt asks dozens of times for each layout, and nothing has changed
        self.setSpacing(GRID)
        self.setContentsMargins(0, 0, 0, 0)
        for widget in widgets:
            self.addWidget(widget)

    def addItem(self, item: QLayoutItem) -> None:
        """One more, at the end."""
        self._items.append(item)

    def count(self) -> int:
        """How many there are."""
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        """One of them."""
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        """One of them, taken away."""
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def expandingDirections(self) -> Qt.Orientation:
        """As wide as may be."""
        return Qt.Orientation.Horizontal

    def hasHeightForWidth(self) -> bool:
        """The narrower, the more rows."""
        return True

    def heightForWidth(self, width: int) -> int:
        """Of all rows at this width."""
        if width not in self._heights:
            rows = self._rows(width)
            self._heights[width] = sum(self._high(row, width) for row in rows) + self.spacing() * max(0, len(rows) - 1)
        return self._heights[width]

    def invalidate(self) -> None:
        """What is in it has changed: forget how high it was."""
        self._heights.clear()
        super().invalidate()

    def sizeHint(self) -> QSize:
        """All in one row."""
        seen = self._seen()
        return QSize(self._width(seen), _height(seen))

    def minimumSize(self) -> QSize:
        """The widest of them alone."""
        seen = self._seen()
        return QSize(max((one.minimumSize().width() for one in seen), default=0), _height(seen))

    def setGeometry(self, rect: QRect) -> None:
        """Put them in their places."""
        super().setGeometry(rect)
        y = rect.y()
        for row in self._rows(rect.width()):
            self._place(row, QPoint(rect.x(), y), rect.width())
            y += self._high(row, rect.width()) + self.spacing()

    def _seen(self) -> list[QLayoutItem]:
        return [one for one in self._items if not one.isEmpty()]

    def _width(self, row: list[QLayoutItem]) -> int:
        return sum(one.sizeHint().width() for one in row) + self.spacing() * max(0, len(row) - 1)

    def _rows(self, width: int) -> list[list[QLayoutItem]]:
        """As few as there is room for; where nothing grows, of about one width: no one stands in a row alone."""
        rows = self._filled(width)
        if any(one.expandingDirections() & Qt.Orientation.Horizontal for one in self._seen()):
            return rows
        for _ in self._items if len(rows) > 1 else ():  # each time the longest row gives one away, or none can
            narrower = self._filled(max(map(self._width, rows)) - 1)
            if len(narrower) > len(rows):
                break
            rows = narrower
        return rows

    def _filled(self, width: int) -> list[list[QLayoutItem]]:
        rows: list[list[QLayoutItem]] = []
        for one in self._seen():
            if rows and self._width([*rows[-1], one]) <= width:
                rows[-1].append(one)
            else:
                rows.append([one])
        return rows

    def _place(self, row: list[QLayoutItem], at: QPoint, width: int) -> None:
        growing, left = _growing(row), max(0, width - self._width(row))
        x, high = at.x() + (0 if growing or self._at_left else left), self._high(row, width)
        for one, size in self._sizes(row, width):
            one.setGeometry(QRect(QPoint(x, at.y() + (high - size.height()) // 2), size))
            x += size.width() + self.spacing()

    def _high(self, row: list[QLayoutItem], width: int) -> int:
        return max((size.height() for _, size in self._sizes(row, width)), default=0)

    def _sizes(self, row: list[QLayoutItem], width: int) -> list[tuple[QLayoutItem, QSize]]:
        """Each as wide as it is there, and as high as its words are at that width."""
        growing, left = _growing(row), max(0, width - self._width(row))
        out = list[tuple[QLayoutItem, QSize]]()
        for one in row:
            hint = one.sizeHint()
            wide = min(width, hint.width() + (left // len(growing) if one in growing else 0))
            out.append((one, QSize(wide, one.heightForWidth(wide) if one.hasHeightForWidth() else hint.height())))
        return out


def _growing(row: list[QLayoutItem]) -> list[QLayoutItem]:
    return [one for one in row if one.expandingDirections() & Qt.Orientation.Horizontal]


def _height(row: list[QLayoutItem]) -> int:
    return max((one.sizeHint().height() for one in row), default=0)
