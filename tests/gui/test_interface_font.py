"""The window has the system's own letters; where nobody chose any, the best that are there. Figures have one width."""

import pytest
from PySide6.QtGui import QFont
from PySide6.QtWidgets import QLabel

from labcal.gui.theming.font import PREFERRED, interface_font


@pytest.mark.parametrize(
    ("system", "there", "family"),
    [
        ("Sans Serif", ("DejaVu Sans", "Inter Variable", "Inter"), "Inter"),
        ("Sans Serif", ("DejaVu Sans", "Inter Variable"), "Inter Variable"),
        ("Sans Serif", ("DejaVu Sans",), "Sans Serif"),
        ("Segoe UI", ("Segoe UI", "Inter"), "Segoe UI"),
        ("Noto Sans", PREFERRED, "Noto Sans"),
    ],
)
def test_what_somebody_chose_stays_and_else_the_best_that_is_there_is_taken(qapp, system, there, family):
    assert interface_font(QFont(system), there).family() == family


def test_figures_of_one_width_stay_where_a_style_sheet_sets_the_size(qapp):
    before = qapp.font()
    try:
        qapp.setFont(interface_font(before, ()))
        styled = QLabel("1")
        styled.setStyleSheet("QLabel { font-size: 12pt; font-weight: 600; }")
        styled.ensurePolished()
        assert QFont.Tag("tnum") in styled.font().featureTags()
    finally:
        qapp.setFont(before)
