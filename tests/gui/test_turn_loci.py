"""Loci of several turns are told apart on the Fit page: by the colour of the axis, by dashes, and by names above."""

import numpy as np
import pytest
from PySide6.QtCore import Qt

from labcal.gui.ipc.answers import FitFigures, Fitted, Look
from labcal.gui.theming.theme import DARK, LIGHT
from labcal.gui.viewmodels.turns import turns_of

NAMES = ("x+20uT-nominal", "x-20uT-nominal", "y+20uT-nominal", "z+20uT-nominal", "z+50uT-nominal", "zero")
FIELD = np.random.default_rng(1).normal(size=(12, 3)) * 1e4
INDEX = np.repeat(np.arange(6.0), 2)


def test_turns_of_one_axis_and_sense_are_one_and_what_is_no_turn_stands_last():
    turns = turns_of(NAMES, INDEX)
    assert [(one.name, one.axis, one.down, int(one.rows.sum())) for one in turns] == [
        ("x +20 µT nominal", "x", False, 2),
        ("x −20 µT nominal", "x", True, 2),
        ("y +20 µT nominal", "y", False, 2),
        ("z + (2)", "z", False, 4),
        ("offset and first position", "", False, 2),
    ]
    assert sum(one.rows for one in turns).tolist() == [1] * 12


@pytest.fixture
def views(still):
    made = still.page("Fit").views
    yield made
    made.set_theme(LIGHT)
    made.show_fit(None, "", None)


def drawn(views, index):
    views.view.setCurrentIndex(0)
    look = Look("r1", "EM-07", 12, FIELD, {}, NAMES, index)
    views.show_fit(look, "ml", Fitted(FitFigures(True), after=FIELD))
    return views.loci


def test_each_turn_has_the_colour_of_its_axis_and_its_name_above(views):
    loci = drawn(views, INDEX)
    pens = [[pair[0].opts["pen"] for pair in lines] for _, lines in loci.turns]
    inks = [{pen.color().name() for pen in of_one} for of_one in pens]
    assert inks == [{LIGHT.axis_x}, {LIGHT.axis_x}, {LIGHT.axis_y}, {LIGHT.axis_z}, {LIGHT.after}]
    dashed = [pen[0].style() == Qt.PenStyle.DashLine for pen in pens]
    assert dashed == [False, True, False, False, False]
    above = [plot.getPlotItem().titleLabel.text for plot in loci.plots]
    assert [sum(turn.name in text for text in above) for turn, _ in loci.turns] == [1] * 5
    assert all(np.isfinite(line[0].getData()[0]).any() for _, lines in loci.turns for line in lines)
    loci.set_theme(DARK)
    assert {pair[0].opts["pen"].color().name() for pair in loci.turns[0][1]} == {DARK.axis_x}
    loci.set_theme(LIGHT)


@pytest.mark.parametrize("index", [np.zeros(12), np.empty(0)], ids=["one turn", "not told apart"])
def test_one_turn_alone_is_drawn_as_before_and_nothing_of_several_stays(views, index):
    drawn(views, INDEX)
    loci = drawn(views, index)
    assert loci.turns == []
    assert [plot.getPlotItem().titleLabel.maximumHeight() for plot in loci.plots] == [0.0] * 3
    assert len(loci._views[0][0][0].getData()[0])


def test_a_plot_is_no_wider_than_its_place_however_much_is_written_above_it(views):
    above = [plot.getPlotItem().titleLabel for plot in drawn(views, INDEX).plots]
    for index in (INDEX, np.zeros(12)):
        drawn(views, index)
        for label in above:
            label.resizeEvent(None)  # as at another size of the window
        assert [label.effectiveSizeHint(Qt.SizeHint.MinimumSize).width() for label in above] == [0.0] * 3
