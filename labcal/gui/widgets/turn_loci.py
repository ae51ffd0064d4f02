"""Loci of several turns: each in the colour of its axis, dashed where the field was against it, and named above."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt

from labcal.gui.theming.theme import Theme
from labcal.gui.viewmodels.turns import Turn
from labcal.gui.widgets.plot_letters import say_above
from labcal.gui.widgets.plots import (
    AXES,
    DASHED,
    MAX_POINTS,
    Array,
    Loci,
    legend_above,
    lines,
    set_locus,
    with_alpha,
)

BEHIND_ALPHA = 85  # of 255, behind the sphere


class TurnLoci(Loci):
    """As `Loci`; in place of its first cloud it may show that cloud turn by turn."""

    def __init__(self, theme: Theme, *, clouds: int = 1) -> None:
        self.turns: list[tuple[Turn, list[tuple[pg.PlotCurveItem, pg.PlotCurveItem]]]] = []
        super().__init__(theme, clouds=clouds)

    def show_turns(self, field_nT: Array, turns: Sequence[Turn]) -> None:
        """Draw fields (n, 3) by the turn that they are of; of one turn alone as a cloud without a name."""
        several = len(turns) > 1 and len(field_nT) > 0
        self.show_field(np.empty((0, 3)) if several else field_nT)
        for _, views in self.turns:
            for widget, pair in zip(self.plots, views, strict=True):
                for one in pair:
                    widget.removeItem(one)
        self.turns = [(turn, [lines(widget) for widget in self.plots]) for turn in turns] if several else []
        for turn, views in self.turns:
            set_locus(views, field_nT[turn.rows], MAX_POINTS // len(turns))
        self._colour(self._theme)

    def _colour(self, theme: Theme) -> None:
        super()._colour(theme)
        for turn, views in self.turns:
            ink = ink_of(turn, theme)
            style = Qt.PenStyle.DashLine if turn.down else Qt.PenStyle.SolidLine
            for front, behind in views:
                front.setPen(pg.mkPen(ink, width=2, style=style))
                behind.setPen(pg.mkPen(with_alpha(ink, BEHIND_ALPHA), style=style))
        for widget, axis in zip(self.plots, AXES, strict=False):  # what is no turn beside those about x
            of_it = [turn for turn, _ in self.turns if (turn.axis or AXES[0]) == axis]
            named = [(f"{DASHED} {one.name}" if one.down else one.name, ink_of(one, theme)) for one in of_it]
            legend_above(widget, named) if self.turns else say_above(widget, None)  # all circles of one size


def ink_of(turn: Turn, theme: Theme) -> str:
    """The colour of its axis, which has no other meaning; of what is no turn that of what is calibrated."""
    return dict(zip(AXES, theme.axes, strict=True)).get(turn.axis, theme.after)
