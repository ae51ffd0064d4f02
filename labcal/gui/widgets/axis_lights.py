"""The traffic light of each body axis: coverage, noise, sign, delay and closure, as soon as its last turn has ended."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout

from labcal.gui.theming.theme import GRID, STATES, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.widgets.common import Surface, label, set_state

NOT_YET = ("○", "")
NOT_SEEN = QT_TRANSLATE_NOOP("Words", "(not seen: {0})")


class AxisLights(Surface):
    """In sight also while a question is open: what is red here is redone before the DUT is dismounted."""

    def __init__(self, theme: Theme) -> None:
        super().__init__()
        self._theme = theme
        row = QHBoxLayout(self)
        row.setContentsMargins(2 * GRID, GRID, 2 * GRID, GRID)
        row.setSpacing(3 * GRID)
        self.worst: dict[str, QLabel] = {}
        self.looks: dict[str, QLabel] = {}
        for axis in "xyz":
            self.worst[axis], self.looks[axis] = label("", "title", wrap=True), label("", "caption")
            self.looks[axis].setTextFormat(Qt.TextFormat.RichText)
            column = QVBoxLayout()
            column.setSpacing(0)
            column.addWidget(self.worst[axis])
            column.addWidget(self.looks[axis])
            row.addLayout(column, 1)

    def set_theme(self, theme: Theme) -> None:
        """What is shown next has the theme's colours."""
        self._theme = theme

    def show_run(self, run: RunViewModel) -> None:
        """Write what is known of each axis."""
        for axis, worst in self.worst.items():
            verdict, looks = run.axis_light(axis), run.axis_checks(axis)
            so_far = verdict == "PASS" and not looks["closure"] and run.status != "finished"  # good so far is not good
            shape, state = (("…" if run.alive else "–"), "") if so_far else STATES.get(verdict, NOT_YET)
            words = translated(verdict) if not so_far else "" if run.alive else translated("not complete")
            worst.setText(f"{axis.upper()}  {shape} {words}".strip())
            set_state(worst, state)
            said = [self._look(translated(look), found) for look, found in looks.items()]
            if unseen := run.covered.about(axis):  # where the turn is to be mended
                said[list(looks).index("coverage")] += f"&nbsp;{translated(str(NOT_SEEN)).format(unseen)}"
            self.looks[axis].setText("<br>".join("&nbsp; ".join(said[n : n + 2]) for n in range(0, len(said), 2)))

    def _look(self, look: str, verdict: str) -> str:
        shape, state = STATES.get(verdict, NOT_YET)
        return f'<span style="color: {getattr(self._theme, state or "muted")}">{shape}&nbsp;{look}</span>'
