"""The residual on shells of one magnitude by degree of spherical harmonics: bars, lines where scatter would end."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Qt

from labcal.gui.ipc.answers import ShellLeft
from labcal.gui.theming.theme import Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import short_number
from labcal.gui.widgets.plots import legend_above
from labcal.gui.widgets.study_plots import with_alpha

WIDTH = 0.8  # of all bars of a degree together


def draw_degrees(widget: pg.PlotWidget, theme: Theme, shells: Sequence[ShellLeft]) -> None:
    """A bar for each degree and shell; where no shell goes all round, what would show one."""
    widget.clear()
    colours = (theme.after, theme.before)
    names = list[tuple[str, str]]()
    for number, shell in enumerate(shells):
        colour, wide = colours[number % len(colours)], WIDTH / len(shells)
        x = np.arange(len(shell.rms_nT)) + (number - (len(shells) - 1) / 2) * wide
        brush = with_alpha(colour, 180)
        widget.addItem(pg.BarGraphItem(x=x, height=np.array(shell.rms_nT), width=0.9 * wide, pen=None, brush=brush))
        ends = np.column_stack([x - 0.45 * wide, x + 0.45 * wide]).ravel()
        pen = pg.mkPen(theme.text, width=2, style=Qt.PenStyle.DotLine)
        widget.plot(ends, np.repeat(shell.noise_nT, 2), connect="pairs", pen=pen)
        names.append((f"{short_number(float(f'{shell.magnitude_nT / 1000:.3g}'))} µT", colour))
    legend_above(widget, names or [(translated("no fields all round at one magnitude: see field-sphere"), theme.muted)])
    widget.getAxis("bottom").setTicks([[(degree, str(degree)) for degree in range(4)]])
    widget.autoRange()
