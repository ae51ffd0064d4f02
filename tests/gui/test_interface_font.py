"""The window has the letters that somebody chose; where nobody did, Source Sans. Figures have one width."""

import pytest
from PySide6.QtGui import QFont, QFontInfo
from PySide6.QtWidgets import QLabel

from labcal.gui.theming.font import FAMILY, interface_font


@pytest.mark.parametrize("system", ["Segoe UI", "Noto Sans", "Cantarell"])
def test_what_somebody_chose_stays(qapp, system):
    assert interface_font(QFont(system)).family() == system


@pytest.mark.parametrize("system", ["Sans Serif", "Sans", ""])
@pytest.mark.parametrize("weight", [QFont.Weight.Normal, QFont.Weight.DemiBold, QFont.Weight.Bold])
def test_where_nobody_chose_any_the_letters_are_those_that_labcal_brings(qapp, system, weight):
    font = interface_font(QFont([system]))
    font.setWeight(weight)
    found = QFontInfo(font)
    assert (found.family(), found.weight()) == (FAMILY, weight)


def test_figures_of_one_width_stay_where_a_style_sheet_sets_the_size(qapp):
    before = qapp.font()
    try:
        qapp.setFont(interface_font(before))
        styled = QLabel("1")
        styled.setStyleSheet("QLabel { font-size: 12pt; font-weight: 600; }")
        styled.ensurePolished()
        assert QFont.Tag("tnum") in styled.font().featureTags()
    finally:
        qapp.setFont(before)
