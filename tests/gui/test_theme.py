import pytest
from PySide6.QtWidgets import QLabel, QTableWidget

from labcal.gui.theming.stylesheet import apply_style, styled_widgets
from labcal.gui.theming.theme import DARK, LIGHT, contrast, style_sheet
from labcal.gui.viewmodels.number_format import format_duration, format_field, format_number
from labcal.gui.widgets.common import Card, label


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
