"""A table in the order of a column, by a click on its heading or by keys."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeySequence, QShortcut

from labcal.gui.widgets.key_sheet import described
from labcal.gui.widgets.measurement_table import Table


class SortedTable(Table):
    """Says by which column it is to be sorted; whoever fills it does that, and says so with `show_order`."""

    sort_wanted = Signal(int)

    def __init__(self, headings: tuple[str, ...], *stretch: int) -> None:
        super().__init__(headings, *stretch)
        header = self.horizontalHeader()
        header.setSortIndicatorShown(True)
        header.sectionClicked.connect(self.sort_wanted)
        header.setToolTip(self.tr("Click to sort by this column, again to turn the order round"))
        self._key("Ctrl+Right", 1, self.tr("in a table: in the order of the column at the right"))
        self._key("Ctrl+Left", -1, self.tr("in a table: in the order of the column at the left"))
        self._key("Ctrl+Down", 0, self.tr("in a table: its order turned round"))

    def _key(self, key: str, steps: int, words: str) -> None:
        shortcut = QShortcut(QKeySequence(key), self, context=Qt.ShortcutContext.WidgetShortcut)
        shortcut.activated.connect(lambda: self.sort_wanted.emit(self._column_beside(steps)))
        described(shortcut, words)

    def _column_beside(self, steps: int) -> int:
        """The one in sight `steps` right of the one that it is sorted by; behind the last comes the first."""
        header = self.horizontalHeader()
        seen = [one for one in map(header.logicalIndex, range(header.count())) if not header.isSectionHidden(one)]
        return seen[(seen.index(header.sortIndicatorSection()) + steps) % len(seen)]

    def show_order(self, column: int, *, falling: bool) -> None:
        """Mark the column that it is sorted by."""
        order = Qt.SortOrder.DescendingOrder if falling else Qt.SortOrder.AscendingOrder
        self.horizontalHeader().setSortIndicator(column, order)
