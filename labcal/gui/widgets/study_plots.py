"""Pictures of a study: residuals with their noise band, loci before and after, candidates as bars with intervals."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.theming.theme import Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.drawn_against import against_words
from labcal.gui.widgets.plot_letters import LETTERS
from labcal.gui.widgets.plots import apply_theme, legend_above, plot
from labcal.gui.widgets.plots import with_alpha as with_alpha

ROOM_ABOVE = 1.1  # bars: for the words of the line
BAR_PX, AXIS_PX = 26, 52  # how high a bar and the axis below are
Array = NDArray[np.float64]


class Residuals(QWidget):
    """Points of a residual against anything, with the band of noise alone (k = 2) and a line at zero."""

    def __init__(self, theme: Theme, left: str = "residual  nT") -> None:
        super().__init__()
        self._theme = theme
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.plot = plot(theme, "", left)
        column.addWidget(self.plot)
        self._band = pg.LinearRegionItem((0, 0), "horizontal", pen=pg.mkPen(None), movable=False)
        self._band.setZValue(-10)
        self._zero = pg.InfiniteLine(0, 0)
        self.plot.addItem(self._band)
        self.plot.addItem(self._zero)
        self.clouds: list[pg.ScatterPlotItem] = []
        self._colour(theme)

    def set_theme(self, theme: Theme) -> None:
        """Ground, band and zero in the theme's colours; the points come in theirs."""
        self._theme = theme
        apply_theme(self.plot, theme)
        self._colour(theme)

    def _colour(self, theme: Theme) -> None:
        self._band.setBrush(with_alpha(theme.muted, 45))
        self._zero.setPen(pg.mkPen(theme.line))

    def show_residual(
        self, against: str, x: Array, clouds: list[tuple[str, str, Array]], noise_nT: float | None
    ) -> None:
        """Draw `clouds` (name, colour, (n,) or (n, 3)) against `x` (n,)."""
        self.show_clouds(against, [(name, colour, x, values) for name, colour, values in clouds], noise_nT)

    def show_clouds(self, against: str, clouds: list[tuple[str, str, Array, Array]], noise_nT: float | None) -> None:
        """Draw `clouds` (name, colour, x (n,), (n,) or (n, 3)), each against an x of its own."""
        for old in self.clouds:
            self.plot.removeItem(old)
        self.clouds = []
        for _, colour, x, values in clouds:
            self._add(colour, x, values.reshape(len(values), -1))
        legend_above(self.plot, [(name, colour) for name, colour, _, _ in clouds])
        self._band.setRegion((-2 * (noise_nT or 0.0), 2 * (noise_nT or 0.0)))
        self._band.setVisible(noise_nT is not None)
        self.plot.getPlotItem().setLabel("bottom", against_words(against), color=self._theme.muted)
        self.plot.autoRange()

    def _add(self, colour: str, x: Array, values: Array) -> None:
        xs, ys = np.repeat(x, values.shape[1]), values.ravel()
        good = np.isfinite(xs) & np.isfinite(ys)
        alpha = 70 if colour == self._theme.before else 130  # what was before lies behind
        cloud = pg.ScatterPlotItem(xs[good], ys[good], size=4, pen=None, brush=pg.mkBrush(with_alpha(colour, alpha)))
        self.plot.addItem(cloud)
        self.clouds.append(cloud)

    def clear(self) -> None:
        """Nothing to show."""
        self.show_residual("", np.empty(0), [], None)


class Bars(QWidget):
    """Candidates from the top: held-out rms with each, a line for noise alone; intervals where they are known."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.plot, self._rows = plot(theme, "held-out rms  nT", ""), 0
        LETTERS.changed.connect(self._fit_height)
        self.plot.getPlotItem().showGrid(x=True, y=False, alpha=0.15)
        self.plot.getPlotItem().getAxis("left").setStyle(tickLength=0)
        column.addWidget(self.plot)

    def set_theme(self, theme: Theme) -> None:
        """What is shown next has the theme's colours."""
        self._theme = theme
        apply_theme(self.plot, theme)

    def show_bars(self, rows: list[tuple[str, float, tuple[float, float] | None, str]], noise_nT: float) -> None:
        """`rows`: name, rms [nT], its interval, colour."""
        self.plot.clear()
        y = -np.arange(len(rows), dtype=float)
        widths = np.array([row[1] for row in rows])
        brushes = [pg.mkBrush(with_alpha(row[3], 200)) for row in rows]
        self.plot.addItem(
            pg.BarGraphItem(x0=np.zeros(len(rows)), y=y, width=widths, height=0.55, brushes=brushes, pen=None)
        )
        for at, (_, _, interval, _) in zip(y, rows, strict=True):
            if interval is not None:
                self.plot.plot(interval, (at, at), pen=pg.mkPen(self._theme.text, width=2))
        pen = pg.mkPen(self._theme.text, width=1.5, dash=(4, 3))
        top = max([noise_nT, *widths, *(i[1] for _, _, i, _ in rows if i is not None)], default=1.0)
        side = float(noise_nT > top / 2)  # of the line that has room for its name
        options = {"position": 0.97, "color": self._theme.muted, "anchors": [(side, 0), (side, 0)]}
        line = pg.InfiniteLine(noise_nT, 90, pen=pen, label=translated("noise"), labelOpts=options)
        self.plot.addItem(line)
        self.plot.getAxis("left").setTicks([[(float(at), row[0]) for at, row in zip(y, rows, strict=True)]])
        self.plot.setRange(xRange=(0, 1.05 * top), yRange=(-len(rows) + 0.4, ROOM_ABOVE), padding=0)
        line.label.setFont(LETTERS.font())
        self._rows = len(rows)
        self._fit_height()

    def _fit_height(self) -> None:
        """Bars as high as their names."""
        if self._rows:
            self.setFixedHeight(round(LETTERS.scale * (BAR_PX * (self._rows + ROOM_ABOVE) + AXIS_PX)))
