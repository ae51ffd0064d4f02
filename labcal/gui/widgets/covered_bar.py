"""How much of the circle this turn has seen, or between two what the turns about its axis have: a bar and its words."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QProgressBar, QWidget

from labcal.gui.viewmodels.number_format import FIGURE_SPACE
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import in_turn
from labcal.gui.widgets.common import label


class CoveredBar(QWidget):
    """Shown where a body axis is turned about."""

    def __init__(self) -> None:
        super().__init__()
        self.bar, self.words = QProgressBar(), label("", "caption")
        self.bar.setTextVisible(False)
        self.bar.setToolTip(self.tr("How much of the circle the turn about this axis has seen, in sectors of 15°"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.words)
        row.addWidget(self.bar, 1)

    def show_run(self, run: RunViewModel) -> None:
        """As it is now; written before it comes into sight."""
        percent = round(100 * run.coverage())
        self.bar.setValue(percent)
        this = in_turn(run.segment, run.step)
        words = self.tr("{0}, this turn: {1} % of the circle") if this else self.tr("{0}: {1} % of the circle")
        self.words.setText(words.format(run.axis.upper(), f"{percent:3d}".replace(" ", FIGURE_SPACE)))
        self.setVisible(bool(run.axis) and run.turns() and run.state != "ended")
