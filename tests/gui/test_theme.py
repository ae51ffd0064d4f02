import itertools

import numpy as np
import pytest
from PySide6.QtWidgets import QLabel, QTableWidget

from labcal.gui.ipc.answers import FitFigures, Fitted, Look
from labcal.gui.theming.stylesheet import apply_style, styled_widgets
from labcal.gui.theming.theme import DARK, LIGHT, contrast, style_sheet
from labcal.gui.viewmodels.number_format import format_duration, format_field, format_number
from labcal.gui.widgets.cage_view import vector_colours
from labcal.gui.widgets.common import Card, label
from labcal.gui.widgets.fit_views import FitViews
from labcal.gui.widgets.plots import Loci


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
@pytest.mark.parametrize("ink", ["text", "muted", "accent", "good", "warning", "bad", "axis_x", "axis_y", "axis_z"])
def test_every_ink_can_be_read_on_every_ground(theme, ink):
    for ground in ("page", "surface", "sunken"):
        assert contrast(getattr(theme, ink), getattr(theme, ground)) >= 4.5, (ink, ground)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
def test_marks_can_be_read_on_their_own_colour(theme):
    assert contrast(theme.on_accent, theme.accent) >= 4.5
    assert contrast(theme.surface, theme.warning) >= 4.5
    assert contrast(theme.surface, theme.bad) >= 4.5


def test_contrast_of_black_on_white_is_the_standard_s_21():
    assert contrast("#000000", "#ffffff") == pytest.approx(21)


def test_numbers_have_one_format():
    assert format_number(19998.72) == "+19\u202f998.7"
    assert format_number(-3.25, 2) == "\u22123.25"
    assert format_field(-19998.7, "µT") == "\u221219.9987"
    assert format_field(100.0, "mG") == "+1.000"
    assert (format_duration(400), format_duration(4000)) == ("06:40", "1:06:40")


def test_a_label_wears_what_is_said_of_labels_and_a_table_what_is_said_of_its_parts(qapp):
    sheet, words, table = style_sheet(DARK), QLabel(), QTableWidget()
    for one in (words, table):
        apply_style(one, sheet)
    assert DARK.muted in words.styleSheet()
    assert "QTableView" not in words.styleSheet()
    assert all(part in table.styleSheet() for part in ("QTableView", "QHeaderView", "QScrollBar", "QToolTip"))
    assert "QPushButton" not in table.styleSheet()


def test_what_only_holds_others_wears_nothing(qapp):
    card, words = Card("A title"), label("words")
    card.body.addWidget(words)
    assert words in styled_widgets(card)
    assert card not in styled_widgets(card)


STATE_INKS, AXIS_INKS = ("good", "warning", "bad", "accent"), ("axis_x", "axis_y", "axis_z")
EYES = {  # what they make of linear RGB (Machado, Oliveira and Fernandes 2009, severity 1)
    "usual": np.eye(3),
    "no long cones": np.array(
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]]
    ),
    "no middle cones": np.array(
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]]
    ),
    "no short cones": np.array(
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]]
    ),
}
XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def seen(colour, eyes):
    """As these eyes see it, in CIE L*a*b*."""
    c = np.array([int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)])
    linear = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    xyz = XYZ @ np.clip(EYES[eyes] @ linear, 0, 1) / (0.95047, 1.0, 1.08883)
    f = np.where(xyz > 0.008856, np.cbrt(xyz), 7.787 * xyz + 16 / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
@pytest.mark.parametrize("eyes", EYES)
def test_the_colour_of_an_axis_is_that_of_no_state_and_no_button_for_any_eyes(theme, eyes):
    for axis in AXIS_INKS:
        for other in (*STATE_INKS, *AXIS_INKS):
            least = 30 if eyes == "usual" else 15 if other in AXIS_INKS else 10
            if other != axis:
                apart = np.linalg.norm(seen(getattr(theme, axis), eyes) - seen(getattr(theme, other), eyes))
                assert apart >= least, (axis, other, apart)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
def test_what_is_drawn_of_a_run_has_no_colour_of_a_state_an_axis_or_a_button(qapp, theme):
    taken = {getattr(theme, name) for name in (*STATE_INKS, *AXIS_INKS)}
    loci, views, pictures = Loci(theme, clouds=2), FitViews(theme), list[str]()
    loci.show_field(np.ones((3, 3)))
    pictures += [line.opts["pen"].color().name() for clouds in loci._views for pair in clouds for line in pair]
    look = Look("r1", "EM-07", 3, np.ones((3, 3)), {"time  s": np.arange(3.0), "field  nT": np.ones(3)})
    fitted = Fitted(FitFigures(True), 5.0, np.zeros(3), np.ones((3, 3)))
    for number in range(4):
        views.view.setCurrentIndex(number)
        views.show_fit(look, "ml", fitted)
    pictures += [curve.opts["pen"].color().name() for curve in views.magnitude.listDataItems()]
    pictures += [cloud.opts["brush"].color().name() for cloud in views.residual.clouds]
    pictures += [*vector_colours(theme), theme.before, theme.after]
    assert len(pictures) > 15
    assert not taken & set(pictures)


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=lambda t: t.name)
@pytest.mark.parametrize("eyes", EYES)
def test_the_three_lights_of_hands_are_told_apart_by_any_eyes(theme, eyes):
    for one, other in itertools.combinations(("good", "warning", "bad"), 2):
        apart = np.linalg.norm(seen(getattr(theme, one), eyes) - seen(getattr(theme, other), eyes))
        assert apart >= (30 if eyes == "usual" else 10), (one, other, apart)
