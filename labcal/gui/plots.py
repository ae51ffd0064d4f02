"""Plots in the theme's colours: traces of three axes against time, and loci on the sphere in three projections."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QHBoxLayout, QWidget

from labcal.gui.theme import Theme
from labcal.gui.words import say

Array = NDArray[np.float64]
AXES = ("x", "y", "z")
MOST = 1500  # points of a locus
JUMP = 0.35  # between two neighbours on the unit sphere that belong to different turns
VIEWS = ((0, 1), (1, 2), (2, 0))  # what each projection shows to the right and upwards


def plot(theme: Theme, bottom: str, left: str) -> pg.PlotWidget:
    """An empty plot with named axes (units in the name) in the theme's colours, without pyqtgraph's own menus."""
    widget = pg.PlotWidget(background=theme.surface, enableMenu=False)
    item = widget.getPlotItem()
    item.showGrid(x=True, y=True, alpha=0.15)
    item.hideButtons()
    for side, text in (("bottom", bottom), ("left", left)):
        axis = item.getAxis(side)
        axis.setLabel(say(text), color=theme.muted)
        axis.setPen(pg.mkPen(theme.line))
        axis.setTextPen(pg.mkPen(theme.muted))
        axis.enableAutoSIPrefix(False)
    widget.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return widget


class Traces(QWidget):
    """Three curves, x y z, against time, each named at its right end."""

    def __init__(self, theme: Theme, left: str) -> None:
        super().__init__()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.plot = plot(theme, "time  s", left)
        row.addWidget(self.plot)
        self._curves = [self.plot.plot(pen=pg.mkPen(colour)) for colour in theme.axes]
        self._names = [
            pg.TextItem(name, colour, anchor=(0, 0.5)) for name, colour in zip(AXES, theme.axes, strict=True)
        ]
        for name in self._names:
            self.plot.addItem(name, ignoreBounds=True)
        for curve in self._curves:
            curve.setDownsampling(auto=True, method="peak")
            curve.setClipToView(True)

    def show_rows(self, rows: Array) -> None:
        """Draw `rows` (n, 4): time [s], x, y, z."""
        for axis, (curve, name) in enumerate(zip(self._curves, self._names, strict=True)):
            curve.setData(rows[:, 0], rows[:, 1 + axis], connect="finite")
            name.setVisible(len(rows) > 0)
            if len(rows):
                name.setPos(float(rows[-1, 0]), float(rows[-1, 1 + axis]))


class Loci(QWidget):
    """Directions on the sphere, seen along z, x and y: where the field has been in the body's axes.

    Lines in the front half are strong, behind it they are faint.
    """

    def __init__(self, theme: Theme, *, clouds: int = 1) -> None:
        super().__init__()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        circle = np.linspace(0, 2 * np.pi, 181)
        colours = (theme.accent, theme.axis_x)[:clouds]
        self._views: list[list[tuple[pg.PlotCurveItem, pg.PlotCurveItem]]] = []
        for right, up in VIEWS:
            widget = plot(theme, f"b{AXES[right]} / |b|", f"b{AXES[up]} / |b|")
            for side in ("bottom", "left"):  # directions need no figures; the room goes to the sphere
                widget.getPlotItem().getAxis(side).setStyle(showValues=False, tickLength=0)
            widget.setAspectLocked(True)
            widget.setRange(xRange=(-1.05, 1.05), yRange=(-1.05, 1.05))
            widget.plot(np.cos(circle), np.sin(circle), pen=pg.mkPen(theme.muted))
            self._views.append([_lines(widget, colour) for colour in colours])
            row.addWidget(widget)

    def show_field(self, field_nT: Array, cloud: int = 0, most: int = MOST) -> None:
        """Draw fields (n, 3), in the order of time, by their direction; at most `most` of them, evenly taken."""
        path = _broken(_directions(field_nT, most))
        for (right, up), clouds in zip(VIEWS, self._views, strict=True):
            front, behind = clouds[cloud]
            x, y, toward = path[:, right], path[:, up], path[:, 3 - right - up] >= 0
            front.setData(x, np.where(toward, y, np.nan), connect="finite")
            behind.setData(x, np.where(toward, np.nan, y), connect="finite")


def legend_of(widget: pg.PlotWidget, ground: object = None) -> pg.LegendItem:
    """The plot's legend at its upper right, empty."""
    legend = widget.getPlotItem().legend or widget.addLegend(offset=(-8, 2), brush=ground, colCount=3)
    legend.clear()
    return legend


def words_only(legend: pg.LegendItem) -> None:
    """No samples beside the words: a word has the colour of what it names."""
    for sample, _ in legend.items:
        sample.hide()


def named_curves(widget: pg.PlotWidget, t_s: Array, curves: Sequence[tuple[str, str, Array]]) -> None:
    """Draw `curves` (name, colour, (n,)) against `t_s` (n,), each named in its own colour."""
    legend = legend_of(widget)
    for name, colour, values in curves:
        inked = f'<span style="color: {colour}; font-weight: 600">{name}</span>'
        widget.plot(t_s, values, pen=pg.mkPen(colour), name=inked, connect="finite")
    words_only(legend)
    widget.autoRange()


def _directions(field_nT: Array, most: int) -> Array:
    """Unit vectors along the finite rows of (n, 3), thinned."""
    field = field_nT[np.isfinite(field_nT).all(axis=1)]
    field = field[:: max(1, -(-len(field) // most))]
    length = np.linalg.norm(field, axis=1, keepdims=True)
    return np.asarray(field / np.where(length > 0, length, 1.0))


def _broken(path: Array) -> Array:
    """The path with a gap of NaN wherever it jumps: from one segment to the next there is no line."""
    jumps = np.flatnonzero(np.linalg.norm(np.diff(path, axis=0), axis=1) > JUMP) + 1
    return np.insert(path, jumps, np.nan, axis=0)


def _lines(widget: pg.PlotWidget, colour: str) -> tuple[pg.PlotCurveItem, pg.PlotCurveItem]:
    """What lies in front of the sphere, and behind it."""
    faint = QColor(colour)
    faint.setAlpha(90)
    front, behind = pg.PlotCurveItem(pen=pg.mkPen(colour, width=2)), pg.PlotCurveItem(pen=pg.mkPen(faint))
    widget.addItem(behind)
    widget.addItem(front)
    return front, behind
