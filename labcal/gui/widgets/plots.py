"""Plots in the theme's colours: traces of three axes against time, and loci on the sphere in three projections."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import pyqtgraph as pg
from numpy.typing import NDArray
from PySide6.QtCore import QLocale, QRectF, Qt
from PySide6.QtGui import QColor, QResizeEvent
from PySide6.QtWidgets import QGraphicsItem, QHBoxLayout, QWidget

from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import MINUS, NARROW_SPACE
from labcal.gui.widgets.deferred_repaint import DeferredRepaint
from labcal.gui.widgets.plot_letters import LETTERS, fit_letters, say_above

Array = NDArray[np.float64]
AXES = ("x", "y", "z")
LEAST_PX = 96  # of traces: their axis bears its name
GAP_S = 2.0  # without a reading: no line
MAX_POINTS = 1500  # points of a locus
JUMP = 0.35  # between two neighbours on the unit sphere that belong to different turns
CIRCLES_PX = 18 * GRID  # so high are circles at least: a turn is seen in them, and what is below them rolls
VIEWS = ((0, 1), (1, 2), (2, 0))  # what each projection shows to the right and upwards
WIDE_GAP = "&nbsp; &nbsp; "
BEFORE_ALPHA = 130  # of 255: what was before lies behind
DASHED = "┄"  # before the name of a curve that is
THOUSANDS = re.compile(r"(?<=\d)(?=(?:\d{3})+$)")  # places for a blank, before a point
UNIT = re.compile(r"  (\S+)\s*(?=</span>)")
UNKEPT = 0.2  # of the height of an axis' name pyqtgraph keeps no room for
NAME_PX = 14  # between the names of two lines
_spare_plots: list[pg.PlotWidget] = []  # blank ones, made while nobody waited
_making: list[Iterator[None]] = [iter(())]  # the one under way


class Axis(pg.AxisItem):  # type: ignore[misc]  # pyqtgraph states no types
    """Figures with the minus sign that tables have; where there is little room its name is smaller, none overlap."""

    def resizeEvent(self, event: object = None) -> None:
        """The name in the middle, and as long as the axis at most: what is longer would be cut."""
        super().resizeEvent(event)
        if self.label is None:
            return
        upright = self.orientation in ("left", "right")
        length, needed = (self.size().height() if upright else self.size().width()), self.label.boundingRect().width()
        self.label.setScale(scale := min(1.0, length / needed) if length > 0 else 1.0)
        middle = (length + scale * needed) / 2 if upright else (length - scale * needed) / 2
        (self.label.setY if upright else self.label.setX)(middle)
        if upright:
            self.label.setX(scale * self.label.x())  # so far it stands beyond the edge, by less than its own margin

    def _updateHeight(self) -> None:
        """As high as larger letters of the name need: pyqtgraph keeps no room for a fifth of them."""
        super()._updateHeight()
        self.setMinimumHeight(high := self.minimumHeight() + self._larger())
        self.setMaximumHeight(high)

    def _larger(self) -> float:
        shown = self.fixedHeight is None and self.isVisible() and self.label is not None and self.label.isVisible()
        return UNKEPT * float(self.label.boundingRect().height()) * (1 - 1 / LETTERS.scale) if shown else 0.0

    def generateDrawSpecs(self, painter: object) -> object:
        """As pyqtgraph has them, without a figure that would lie over another."""
        if (specs := super().generateDrawSpecs(painter)) is None:
            return None
        *lines, texts = specs
        kept: list[tuple[QRectF, object, str]] = []
        for text in texts:
            if not any(text[0].intersects(other[0]) for other in kept):
                kept.append(text)
        return *lines, kept

    def tickStrings(self, values: Sequence[float], scale: float, spacing: float) -> list[str]:
        """As pyqtgraph writes them, in groups of three and with the language's decimal mark, as everywhere else."""
        mark = QLocale().decimalPoint()
        written = (text.partition(".") for text in super().tickStrings(values, scale, spacing))
        return [
            (THOUSANDS.sub(NARROW_SPACE, text) + (point and mark) + rest).replace("-", MINUS)
            for text, point, rest in written
        ]

    def labelString(self) -> str:
        """The unit, which stands behind two blanks in the name, in brackets."""
        return UNIT.sub(r" (\1)", str(super().labelString()))


def plot(theme: Theme, bottom: str, left: str) -> pg.PlotWidget:
    """An empty plot with named axes (units in the name) in the theme's colours, without pyqtgraph's own menus."""
    while not _spare_plots:
        preallocate_plots(1)
    widget = _spare_plots.pop()
    for side, text in (("bottom", bottom), ("left", left)):
        widget.getPlotItem().getAxis(side).labelText = translated(text)
    widget.setAccessibleName(translated("Plot: {0} against {1}").format(translated(left), translated(bottom)))
    apply_theme(widget, theme)
    fit_letters(widget)
    return widget


def _spare_plot_in_parts() -> Iterator[None]:
    """Make one more spare plot, in three parts."""
    axes = {side: Axis(side) for side in ("left", "bottom", "right", "top")}
    yield
    item = pg.PlotItem(axisItems=axes, enableMenu=False)
    for side in ("right", "top"):  # axes that are given are shown
        item.hideAxis(side)
    yield
    widget = pg.PlotWidget(plotItem=item)
    widget.deferred_repaint = DeferredRepaint(widget)
    item.showGrid(x=True, y=True, alpha=0.15)
    item.hideButtons()
    for side in ("bottom", "left"):
        axes[side].enableAutoSIPrefix(False)
        axes[side].setStyle(maxTickLevel=1)
        axes[side].setCacheMode(QGraphicsItem.CacheMode.DeviceCoordinateCache)  # a grid is expensive to draw
    widget.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    _spare_plots.append(widget)


def preallocate_plots(format_number: int) -> bool:
    """Make a part of a plot for the page that is built next, unless there are `number`; says whether there are.

    A plot takes 20 ms to make, and a page has up to four.
    """
    if len(_spare_plots) >= format_number:
        return True
    if next(_making[0], True):
        _making[0] = _spare_plot_in_parts()
    return False


def apply_theme(widget: pg.PlotWidget, theme: Theme) -> None:
    """Put ground, axes and their names into the theme's colours."""
    widget.deferred_repaint.begin()
    widget.setBackground(theme.surface)
    for side in ("bottom", "left"):
        axis = widget.getPlotItem().getAxis(side)
        axis.setLabel(axis.labelText, color=theme.muted)
        axis.setPen(pg.mkPen(theme.line))
        axis.setTextPen(pg.mkPen(theme.muted))


class Traces(QWidget):
    """Three curves, x y z, against time, each named at its right end."""

    def __init__(self, theme: Theme, left: str) -> None:
        super().__init__()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.plot = plot(theme, "time  s", left)
        self.plot.setMinimumHeight(LEAST_PX)
        row.addWidget(self.plot)
        kept = self.plot.sizePolicy()
        kept.setRetainSizeWhenHidden(True)  # nothing moves as the first row comes
        self.plot.setSizePolicy(kept)
        self.plot.hide()  # axes from 0 to 1 would say something of nothing
        self._curves = [self.plot.plot() for _ in AXES]
        self._names = [pg.TextItem(name, anchor=(0, 0.5)) for name in AXES]
        for name in self._names:
            name.setFont(LETTERS.font())
            self.plot.addItem(name, ignoreBounds=True)
        for curve in self._curves:
            curve.setDownsampling(auto=True, method="peak")
            curve.setClipToView(True)
        self._colour(theme)

    def set_theme(self, theme: Theme) -> None:
        """Each curve and its name in the axis' colour."""
        apply_theme(self.plot, theme)
        self._colour(theme)

    def _colour(self, theme: Theme) -> None:
        for curve, name, colour in zip(self._curves, self._names, theme.axes, strict=True):
            curve.setPen(pg.mkPen(colour))
            name.setColor(colour)

    def show_rows(self, rows: Array) -> None:
        """Draw `rows` (n, 4): time [s], x, y, z; no line where nothing was heard for a while."""
        self.plot.setVisible(bool(len(rows)))
        gaps = np.flatnonzero(np.diff(rows[:, 0]) > GAP_S) + 1
        nothing = np.column_stack([rows[gaps - 1, 0], np.full((len(gaps), len(AXES)), np.nan)])
        drawn = np.insert(rows, gaps, nothing, axis=0)
        for axis, curve in enumerate(self._curves):
            curve.setData(drawn[:, 0], drawn[:, 1 + axis], connect="finite")
        view = self.plot.getViewBox()
        view.updateAutoRange()  # else it is that of what was drawn before, and a name may lie outside
        low, high = view.viewRange()[1]
        least = (high - low) * LETTERS.scale * NAME_PX / max(1.0, view.height())
        at = spread(rows[-1, 1:], least) if len(rows) else []
        if at and max(at) > high - least / 2:  # no room above: from the top one downwards
            at = [-place for place in spread(-np.minimum(rows[-1, 1:], high - least / 2), least)]
        for name in self._names:
            name.setVisible(len(rows) > 0)
        for name, value in zip(self._names, at, strict=False):
            name.setPos(float(rows[-1, 0]), value)


class Loci(QWidget):
    """Directions on the sphere, seen along z, x and y: where the field has been in the body's axes.

    Lines in the front half are strong, behind it they are faint.
    """

    def __init__(self, theme: Theme, *, clouds: int = 1) -> None:
        super().__init__()
        self._row = QHBoxLayout(self)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._theme, self._clouds = theme, clouds
        self.plots: list[pg.PlotWidget] = []
        self._circles: list[pg.PlotDataItem] = []
        self._views: list[list[tuple[pg.PlotCurveItem, pg.PlotCurveItem]]] = []
        self.build_more()

    def build_more(self) -> bool:
        """Build the next of its projections; says whether one was missing."""
        if len(self.plots) == len(VIEWS):
            return False
        circle = np.linspace(0, 2 * np.pi, 181)
        right, up = VIEWS[len(self.plots)]
        widget = plot(self._theme, f"b{AXES[right]} / |b|", f"b{AXES[up]} / |b|")
        for side in ("bottom", "left"):  # directions need no figures and no grid
            widget.getPlotItem().getAxis(side).setStyle(showValues=False, tickLength=0)
        widget.showGrid(x=False, y=False)
        widget.setAspectLocked(True)
        widget.setRange(xRange=(-1.05, 1.05), yRange=(-1.05, 1.05))
        self.plots.append(widget)
        self._circles.append(widget.plot(np.cos(circle), np.sin(circle)))
        self._views.append([lines(widget) for _ in range(self._clouds)])
        self._row.addWidget(widget)
        self._colour(self._theme)
        return True

    def showEvent(self, event: object) -> None:
        """All of it, where it comes into sight before it was whole."""
        self._whole()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """No lower than each of them is wide, up to what a turn is seen in: then it is rolled, and not squeezed."""
        super().resizeEvent(event)
        self.setMinimumHeight(min(CIRCLES_PX, event.size().width() // len(VIEWS)))

    def _whole(self) -> None:
        while self.build_more():
            pass

    def set_theme(self, theme: Theme) -> None:
        """Circles and lines in the theme's colours."""
        self._theme = theme
        for widget in self.plots:
            apply_theme(widget, theme)
        self._colour(theme)

    def _colour(self, theme: Theme) -> None:
        for circle, clouds in zip(self._circles, self._views, strict=True):
            circle.setPen(pg.mkPen(theme.line, width=2))
            for (colour, front_alpha), (front, behind) in zip(
                ((theme.after, 255), (theme.before, BEFORE_ALPHA)), clouds, strict=False
            ):
                front.setPen(pg.mkPen(with_alpha(colour, front_alpha), width=2))
                behind.setPen(pg.mkPen(with_alpha(colour, front_alpha // 3), width=2))
        for widget in self.plots:  # directions need no axes
            for side in ("bottom", "left"):
                axis = widget.getPlotItem().getAxis(side)
                axis.setPen(pg.mkPen(theme.surface))
                axis.setLabel(axis.labelText, color=theme.muted)

    def show_field(self, field_nT: Array, cloud: int = 0, most: int = MAX_POINTS) -> None:
        """Draw fields (n, 3), in the order of time, by their direction; at most `most` of them, evenly taken."""
        self._whole()
        set_locus([clouds[cloud] for clouds in self._views], field_nT, most)


def set_locus(views: Sequence[tuple[pg.PlotCurveItem, pg.PlotCurveItem]], field_nT: Array, most: int) -> None:
    """The directions of fields (n, 3) into the lines of each of `VIEWS`: before the sphere, and behind it."""
    path = _broken(_directions(field_nT, most))
    for (right, up), (front, behind) in zip(VIEWS, views, strict=True):
        x, y, toward = path[:, right], path[:, up], path[:, 3 - right - up] >= 0
        front.setData(x, np.where(toward, y, np.nan), connect="finite")
        behind.setData(x, np.where(toward, np.nan, y), connect="finite")


def with_alpha(colour: str, alpha: int) -> QColor:
    """`colour` with some transparency."""
    made = QColor(colour)
    made.setAlpha(alpha)
    return made


def spread(values: Array, least: float) -> list[float]:
    """`values` (n,), each at least `least` above the next lower one: no name of a line covers another."""
    places, floor = [0.0] * len(values), -math.inf
    for place in np.argsort(values, kind="stable"):
        floor = max(float(values[place]), floor + least)
        places[place] = floor
    return places


def legend_above(widget: pg.PlotWidget, named: Iterable[tuple[str, str]]) -> None:
    """Write what is drawn above it, (name, colour) each: a word has the colour of what it names, and covers nothing."""
    words = [f'<span style="color: {colour}; font-weight: 600">{name}</span>' for name, colour in named]
    say_above(widget, WIDE_GAP.join(words))


def named_curves(widget: pg.PlotWidget, t_s: Array, curves: Sequence[tuple[str, str, Array]]) -> None:
    """Draw `curves` (name, colour, (n,)) against `t_s` (n,), each named in its own colour; those named ┄ are dashed."""
    for name, colour, values in curves:
        style = Qt.PenStyle.DashLine if name.startswith(DASHED) else Qt.PenStyle.SolidLine
        widget.plot(t_s, values, pen=pg.mkPen(colour, style=style), connect="finite")
    legend_above(widget, [(name, colour) for name, colour, _ in curves])
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


def lines(widget: pg.PlotWidget) -> tuple[pg.PlotCurveItem, pg.PlotCurveItem]:
    """What lies in front of the sphere, and behind it."""
    front, behind = pg.PlotCurveItem(), pg.PlotCurveItem()
    widget.addItem(behind)
    widget.addItem(front)
    return front, behind
