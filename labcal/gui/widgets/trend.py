"""A DUT's figures from calibration to calibration, with U and the limits of its specification."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from typing import Protocol

import numpy as np
import pyqtgraph as pg
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QSizePolicy

from labcal.gui.ipc.answers import Figure, Matrix
from labcal.gui.theming.theme import Theme
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.common import Card, label
from labcal.gui.widgets.idle_queue import IdleQueue
from labcal.gui.widgets.plot_letters import fit_letters
from labcal.gui.widgets.plots import apply_theme, legend_above, plot

DAY_S = 86_400.0  # a trend shows at least a day on either side
LEAST_PX = 160  # of the plot: what is said above it takes nothing of that
GAIN = "gain"  # the diagonal of K, which shows a drift where the axes' scale factors lie far apart
KINDS = {  # of figures, by the words of the chooser
    "zero reading": "offset",
    "scale": "scale",
    "non-orthogonality": "non_orthogonality",
    GAIN: "",
}


class FollowedCalibration(Protocol):
    """A calibration of this lab's folder, or of the archive."""

    @property
    def figures(self) -> tuple[Figure, ...]:
        """Of the map."""
        ...

    @property
    def K(self) -> Matrix:
        """The map's."""
        ...

    @property
    def u(self) -> tuple[float, ...] | None:
        """Of K row by row, then k."""
        ...


@dataclass(frozen=True, slots=True)
class Course:
    """One figure over the calibrations: value and U (n,), in `unit`; the limit of the newest that has one."""

    name: str
    value: tuple[float, ...]
    U: tuple[float, ...]
    unit: str
    limit: float | None = None


def courses(files: Sequence[FollowedCalibration], chosen: str) -> list[Course]:
    """The three figures of a kind over `files`, the oldest first."""
    if not files:
        return []
    if chosen == GAIN:
        return [_gain(files, axis) for axis in range(3)]
    figures = [[one for one in file.figures if one.kind == KINDS[chosen]] for file in files]
    return [
        Course(
            several[-1].quantity,
            tuple(one.value for one in several),
            tuple(one.U or 0.0 for one in several),
            several[-1].unit,
            several[-1].limit,
        )
        for several in zip(*figures, strict=True)
    ]


def _gain(files: Sequence[FollowedCalibration], axis: int) -> Course:
    value = np.array([one.K[axis][axis] for one in files])
    U = np.array([2 * one.u[4 * axis] if one.u else 0.0 for one in files])
    changed, of_it = 1e6 * (value / value[0] - 1), 1e6 * U / abs(value[0])
    return Course(f"K {'xyz'[axis] * 2}", tuple(changed), tuple(of_it), "ppm from the first")


class Trend(Card):
    """The chosen kind of figure against the time of the runs."""

    drawn = Signal()

    def __init__(self, theme: Theme) -> None:
        super().__init__(self.tr("Calibrations over time"), self.tr("bars: U, k=2"))
        self._theme = theme
        self._files: Sequence[FollowedCalibration] = ()
        self._times: Sequence[float] = ()
        self.idle_queue = IdleQueue(self)
        self.parameter = QComboBox()
        for name in KINDS:
            self.parameter.addItem(translated(name), name)
        self.parameter.setToolTip(
            self.tr(
                "Zero readings, scale factors from nominal, angles between the axes; gain: from the first calibration"
            )
        )
        self.parameter.activated.connect(self.draw)
        self.plot = plot(theme, "", "")
        self.plot.setMinimumHeight(LEAST_PX)
        self.plot.getPlotItem().setAxisItems({"bottom": pg.DateAxisItem()})
        fit_letters(self.plot)  # the new axis has pyqtgraph's own
        self.none = label(
            self.tr("No calibration of this DUT yet: its parameters and their U come up here, one dot a day."),
            wrap=True,
        )
        self.body.addWidget(self.parameter)
        self.body.addWidget(self.none)
        self.body.addWidget(self.plot, 1)
        self.body.addStretch()

    def set_theme(self, theme: Theme) -> None:
        """In the theme's colours."""
        self._theme = theme
        apply_theme(self.plot, theme)
        self.idle_queue.add(self.draw)

    def show_files(self, dut: str, files: Sequence[FollowedCalibration], times: Sequence[float]) -> None:
        """Draw these calibrations of `dut`, the oldest first, at their times [s since 1970]."""
        self.heading.setText(self.tr("Calibrations of {0}").format(dut or "–"))
        self._files, self._times = files, times
        self.draw()

    def draw(self) -> None:
        """Draw the kind of figure that is chosen, a line at a time."""
        found = courses(self._files, self.parameter.currentData())
        self.plot.clear()
        for widget, shown in ((self.none, not found), (self.plot, bool(found)), (self.parameter, bool(found))):
            widget.setVisible(shown)
        high = QSizePolicy.Policy.Preferred if found else QSizePolicy.Policy.Maximum
        self.setSizePolicy(QSizePolicy.Policy.Preferred, high)  # a sentence alone leaves the room to the runs
        if not found:
            return
        unit = f"{self.parameter.currentText()}  {translated(found[0].unit)}"
        self.plot.getPlotItem().setLabel("left", unit, color=self._theme.muted)
        for one, colour in zip(found, self._theme.axes, strict=True):
            self.idle_queue.put(("line", colour), partial(self._line, one, colour))
        self.idle_queue.put("range", partial(self._name_and_range, found))

    def _line(self, one: Course, colour: str) -> None:
        t, value, U = np.array(self._times), np.array(one.value), np.array(one.U)
        self.plot.addItem(pg.ErrorBarItem(x=t, y=value, height=2 * U, beam=0, pen=pg.mkPen(colour, width=2)))
        self.plot.plot(t, value, pen=pg.mkPen(colour), symbol="o", symbolSize=7, symbolBrush=colour, symbolPen=None)

    def _name_and_range(self, found: Sequence[Course]) -> None:
        """What is drawn last: limits, the names above, and what is seen of time and value."""
        limits = sorted({one.limit for one in found if one.limit is not None})
        for limit in limits:
            for y, shown in ((limit, translated("limit")), (-limit, "")):
                self.plot.addItem(self._limit(y, shown))
        legend_above(self.plot, zip((in_words(one.name) for one in found), self._theme.axes, strict=True))
        self.plot.autoRange(padding=0.1)
        if limits:
            self.plot.setYRange(*self._reach(found, max(limits)))
        first, last = min(self._times), max(self._times)
        of_one_day = last - first < DAY_S
        if of_one_day:
            self.plot.setXRange(first - DAY_S, last + DAY_S)
        day = ((first + last) / 2, f"{datetime.fromtimestamp(first):%Y-%m-%d}")
        self.plot.getAxis("bottom").setTicks([[day]] if of_one_day else None)  # hours of other days say nothing
        self.drawn.emit()

    def _limit(self, y: float, words: str) -> pg.InfiniteLine:
        pen = pg.mkPen(self._theme.text, width=1.5, dash=(6, 4))
        options = {"position": 0.04, "color": self._theme.text, "anchors": [(0, 0), (0, 0)]}
        return pg.InfiniteLine(y, 0, pen=pen, label=words or None, labelOpts=options)

    def _reach(self, found: Sequence[Course], limit: float) -> tuple[float, float]:
        """From below the lower limit to above the upper one, and whatever lies beyond."""
        ends = [v + s * u for one in found for v, u in zip(one.value, one.U, strict=True) for s in (-1, 1)]
        return min(-limit, *ends) - 0.1 * limit, max(limit, *ends) + 0.2 * limit
