"""Plots write as the window does: in its size, also where that is to be read from two metres, and in its language."""

import re

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication, QGraphicsView
from test_nothing_is_cut import other_language as other_language
from test_nothing_is_cut import settle as rest_of_it
from test_nothing_is_cut import shown

from labcal.gui.theming.theme import LIGHT
from labcal.gui.viewmodels.number_format import format_number
from labcal.gui.widgets.plot_letters import LETTERS
from labcal.gui.widgets.plots import Axis, Loci, legend_above, plot
from labcal.gui.widgets.study_plots import Bars
from labcal.gui.widgets.trend import Trend

PAGES = ("Run", "Fit", "Loop", "History")


def figures_pt(window):
    """The size of each axis' figures and name, and of each line's name."""
    found = []
    for one in window.findChildren(QGraphicsView):
        if isinstance(one, pg.PlotWidget):
            for side in ("bottom", "left"):
                axis = one.getPlotItem().getAxis(side)
                found += [axis.style["tickFont"].pointSizeF(), axis.label.font().pointSizeF()]
    return found


def names_of_axes(window):
    """As they are drawn."""
    plots = [one for one in window.findChildren(QGraphicsView) if isinstance(one, pg.PlotWidget)]
    return [one.getPlotItem().getAxis(side).label.toPlainText() for one in plots for side in ("bottom", "left")]


def settle():
    for _ in range(3):
        QApplication.processEvents()


def test_letters_of_every_plot_grow_with_the_windows(new_window):
    for name in PAGES:
        new_window.open_page(name)
    _ = new_window.page("Fit").views.residual
    settle()
    before, names = figures_pt(new_window), names_of_axes(new_window)
    assert len(before) > 10
    new_window.resize(1920, 1080)
    settle()
    assert new_window._scale == 1.0
    new_window.toggle_wall()
    settle()
    grown = figures_pt(new_window)
    assert names_of_axes(new_window) == names != [""] * len(names)
    assert grown == pytest.approx([new_window._scale * pt for pt in before])
    _ = new_window.page("Fit").views.magnitude  # built only now
    assert set(map(round, figures_pt(new_window))) == set(map(round, grown))
    new_window.toggle_wall()
    settle()
    assert set(figures_pt(new_window)) == set(before)


def test_what_stands_above_a_plot_and_bars_grow_too(new_window, qtbot):
    bars = Bars(LIGHT)
    qtbot.addWidget(bars)
    bars.show_bars([("a", 3.0, None, LIGHT.after), ("b", 2.0, None, LIGHT.after)], 1.0)
    above = plot(LIGHT, "a", "b")
    above.setParent(new_window)
    legend_above(above, [("named", LIGHT.after)])
    high = bars.height()
    new_window.resize(1920, 1080)
    new_window.toggle_wall()
    settle()
    assert bars.height() == round(new_window._scale * high)
    size = float(re.search(r"[\d.]+", above.getPlotItem().titleLabel.opts["size"])[0])
    assert size == pytest.approx(9.0 * new_window._scale)
    new_window.toggle_wall()
    settle()


@pytest.mark.parametrize("other_language", ["en", "de", "fr"], indirect=True)
def test_figures_of_an_axis_are_written_as_those_of_a_table(other_language):
    mark = QLocale().decimalPoint()
    assert mark == ("." if other_language == "en" else ",")
    axis = Axis("left")
    said = axis.tickStrings([-1000.5, 0.5, 1200.0], 1.0, 0.5)
    assert said == [format_number(v, signed=False) for v in (-1000.5, 0.5, 1200.0)]
    assert axis.tickStrings([1000.0], 1.0, 1000.0) == [format_number(1000.0, 0, signed=False)]


def test_the_days_below_a_trend_are_as_large_as_all_figures(qtbot):
    trend = Trend(LIGHT)
    qtbot.addWidget(trend)
    font = trend.plot.getPlotItem().getAxis("bottom").style["tickFont"]
    assert font is not None
    assert font.pointSizeF() == LETTERS.font().pointSizeF()


@pytest.mark.parametrize("other_language", ["en", "fr"], indirect=True)
def test_the_names_beside_what_is_left_are_as_large_as_the_letters_of_the_window(other_language, new_window, rest):
    window = rest(new_window)
    page = shown(window, "Loop")
    window.resize(1920, 1080)
    window.toggle_wall()
    window.open_page(page)
    rest_of_it(window)
    parts = window.page("Loop").left, window.page("Loop").change
    for part in parts:
        part.setMaximumHeight(part.minimumHeight())  # where a card above takes the room of the page
    rest_of_it(window)
    plots = [part.plot for part in parts]
    assert [one.getPlotItem().getAxis("left").label.scale() for one in plots] == [1.0, 1.0]


def test_what_lies_behind_a_circle_is_as_wide_a_line_as_what_lies_before_it(qtbot):
    loci = Loci(LIGHT)
    qtbot.addWidget(loci)
    loci.show_field(np.eye(3))
    drawn = [one for view in loci.plots for one in view.getPlotItem().items if isinstance(one, pg.PlotCurveItem)]
    assert {one.opts["pen"].widthF() for one in drawn} == {2.0}
