"""A card whose acts are always in sight: what stands above them rolls where there is no room."""

from __future__ import annotations

from PySide6.QtCore import QMargins
from PySide6.QtWidgets import QLayout, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.bar_in_margin import BarInMargin
from labcal.gui.widgets.common import Card


class ActsCard(Card):
    """`above`, as high as there is room; below it the `acts`, whole."""

    def __init__(self, above: QLayout, *acts: QWidget | QLayout) -> None:
        super().__init__()
        outer, below = self.layout(), QVBoxLayout()
        right = 2 * GRID if outer is None else outer.contentsMargins().right()
        if outer is not None:
            outer.setContentsMargins(outer.contentsMargins() - QMargins(0, 0, right, 0))
        below.setContentsMargins(0, 0, right, 0)
        below.setSpacing(self.body.spacing())
        for act in acts:
            below.addLayout(act) if isinstance(act, QLayout) else below.addWidget(act)
        self.body.addWidget(BarInMargin(above, right), 1)
        self.body.addLayout(below)
