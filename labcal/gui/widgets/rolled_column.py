"""A column of figures that rolls where there is no room: no row is cut in two."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtWidgets import QLabel, QWidget

from labcal.gui.widgets.bar_in_margin import BarInMargin


class RolledColumn(BarInMargin):
    """Ends, before it is rolled, above the row that would be halved."""

    def _rows(self) -> Sequence[QWidget]:
        return self._holder.findChildren(QLabel)
