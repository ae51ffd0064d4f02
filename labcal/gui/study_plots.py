"""Pictures of a study: residuals with their noise band, loci before and after, candidates as bars with intervals."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.plots import legend_of, plot, words_only
from labcal.gui.theme import Theme
from labcal.gui.words import say

LEGEND_SHARE = 0.2  # of the height is left free above the points, for the legend
Array = NDArray[np.float64]


def faint(colour: str, alpha: int) -> QColor:
    """`colour` with some transparency."""
    made = QColor(colour)
    made.setAlpha(alpha)
    return made


class Residuals(QWidget):
    """Points of a residual against anything, with the band of noise alone (k = 2) and a line at zero."""

    def __init__(self, theme: Theme, left: str = "residual  nT") -> None:
        super().__init__()
        self._theme = theme
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.plot = plot(theme, "", left)
        column.addWidget(self.plot)
        self._band = pg.LinearRegionItem(
            (0, 0), "horizontal", faint(theme.muted, 45), pen=pg.mkPen(None), movable=False
        )
        self._band.setZValue(-10)
        self.plot.addItem(self._band)
        self.plot.addItem(pg.InfiniteLine(0, 0, pen=pg.mkPen(theme.line)))
        self._clouds: list[pg.ScatterPlotItem] = []

    def show_residual(
        self, against: str, x: Array, clouds: list[tuple[str, str, Array]], noise_nT: float | None
    ) -> None:
        """Draw `clouds` (name, colour, (n,) or (n, 3)) against `x` (n,)."""
        for old in self._clouds:
            self.plot.removeItem(old)
        self._clouds = []
        ground = pg.mkBrush(faint(self._theme.surface, 225))
        legend = legend_of(self.plot, ground)
        for name, colour, values in clouds:
            self._add(name, colour, x, values.reshape(len(values), -1))
        words_only(legend)
        self._band.setRegion((-2 * (noise_nT or 0.0), 2 * (noise_nT or 0.0)))
        self._band.setVisible(noise_nT is not None)
        self.plot.getPlotItem().setLabel("bottom", against, color=self._theme.muted)
        self.plot.autoRange()
        low, high = self.plot.viewRange()[1]
        self.plot.setYRange(low, high + LEGEND_SHARE * (high - low), padding=0)

    def _add(self, name: str, colour: str, x: Array, values: Array) -> None:
        xs, ys = np.repeat(x, values.shape[1]), values.ravel()
        good = np.isfinite(xs) & np.isfinite(ys)
        cloud = pg.ScatterPlotItem(
            xs[good], ys[good], size=4, pen=None, brush=pg.mkBrush(faint(colour, 130)), name=_inked(name, colour)
        )
        self.plot.addItem(cloud)
        self._clouds.append(cloud)

    def clear(self) -> None:
        """Nothing to show."""
        self.show_residual("", np.empty(0), [], None)


def _inked(name: str, colour: str) -> str:
    """A legend's word in the colour of what it names."""
    return f'<span style="color: {colour}; font-weight: 600">{name}</span>'


class Bars(QWidget):
    """Candidates from the top: held-out rms with each, a line for noise alone; intervals where they are known."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.plot = plot(theme, "held-out rms  nT", "")
        self.plot.getPlotItem().showGrid(x=True, y=False, alpha=0.15)
        column.addWidget(self.plot)

    def show_bars(self, rows: list[tuple[str, float, tuple[float, float] | None, str]], noise_nT: float) -> None:
        """`rows`: name, rms [nT], its interval, colour."""
        self.plot.clear()
        y = -np.arange(len(rows), dtype=float)
        widths = np.array([row[1] for row in rows])
        brushes = [pg.mkBrush(faint(row[3], 200)) for row in rows]
        self.plot.addItem(
            pg.BarGraphItem(x0=np.zeros(len(rows)), y=y, width=widths, height=0.55, brushes=brushes, pen=None)
        )
        for at, (_, _, interval, _) in zip(y, rows, strict=True):
            if interval is not None:
                self.plot.plot(interval, (at, at), pen=pg.mkPen(self._theme.text, width=2))
        pen, options = (
            pg.mkPen(self._theme.text, width=1.5, dash=(4, 3)),
            {"position": 0.06, "color": self._theme.muted},
        )
        line = pg.InfiniteLine(noise_nT, 90, pen=pen, label=say("noise alone"), labelOpts=options)
        self.plot.addItem(line)
        self.plot.getAxis("left").setTicks([[(float(at), row[0]) for at, row in zip(y, rows, strict=True)]])
        top = max([noise_nT, *widths, *(i[1] for _, _, i, _ in rows if i is not None)], default=1.0)
        self.plot.setRange(xRange=(0, 1.05 * top), yRange=(-len(rows) + 0.3, 0.7), padding=0)
