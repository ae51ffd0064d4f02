"""What a calibration comes by, page after page: for who has measured nothing here yet."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import QGridLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.translate import translated
from labcal.gui.widgets.common import label

PAGES = {
    "Bench": QT_TRANSLATE_NOOP("Words", "The instruments of your lab: open its bench file, and see that each answers."),
    "Run": QT_TRANSLATE_NOOP("Words", "You mount the DUT about each axis; coils and platform do the rest."),
    "Fit": QT_TRANSLATE_NOOP("Words", "Offset, scale and angles from that run, each with its uncertainty."),
    "Loop": QT_TRANSLATE_NOOP("Words", "What is left over is traced to its cause, and tried on held-out data."),
    "Certificate": QT_TRANSLATE_NOOP("Words", "Another person approves, you sign, and it is handed out."),
}


class WayAhead(QWidget):
    """A line for each page from bench to certificate: its name, and what is done there."""

    def __init__(self) -> None:
        super().__init__()
        grid = QGridLayout(self)
        grid.setContentsMargins(0, GRID, 0, 0)
        grid.setHorizontalSpacing(3 * GRID)
        grid.setVerticalSpacing(2 * GRID)
        for row, (page, words) in enumerate(PAGES.items()):
            grid.addWidget(label(translated(page), "title"), row, 0, Qt.AlignmentFlag.AlignTop)
            grid.addWidget(label(translated(str(words)), wrap=True), row, 1)
        grid.setColumnStretch(1, 1)
