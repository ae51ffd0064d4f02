"""The traffic light of each body axis: coverage, noise, sign, delay and closure, as soon as its last turn has ended."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID, STATES, Theme
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_steps import axes_of
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
        self.columns: dict[str, QWidget] = {}
        for axis in "xyz":
            self.worst[axis], self.looks[axis] = label("", "title", wrap=True), label("", "caption")
            self.looks[axis].setTextFormat(Qt.TextFormat.RichText)
            self.columns[axis] = QWidget()
            column = QVBoxLayout(self.columns[axis])
            column.setContentsMargins(0, 0, 0, 0)
            column.setSpacing(0)
            column.addWidget(self.worst[axis])
            column.addWidget(self.looks[axis])
            row.addWidget(self.columns[axis], 1)

    def set_theme(self, theme: Theme) -> None:
        """What is shown next has the theme's colours."""
        self._theme = theme

    def show_run(self, run: RunViewModel) -> None:
        """Write what is known of each axis."""
        turned = axes_of((*run.names, *run.drawn.now, *run.drawn.earlier))
        for axis, worst in self.worst.items():
            verdict, looks = run.axis_light(axis), run.axis_checks(axis)
            self.columns[axis].setVisible(axis in turned)
            open_yet = verdict == "PASS" and not all(looks.values())  # good so far is not good
            shape, state = _of_open(run) if open_yet else STATES.get(verdict, NOT_YET)
            words = translated(verdict) if not open_yet else "" if run.alive else translated("not complete")
            worst.setText(f"{axis.upper()}  {shape} {words}".strip())
            set_state(worst, state)
            said = [self._look(translated(look), found) for look, found in looks.items()]
            if unseen := run.covered.about(axis):  # where the turn is to be mended
                said[list(looks).index("coverage")] += f"&nbsp;{translated(str(NOT_SEEN)).format(unseen)}"
            self.looks[axis].setText("<br>".join("&nbsp; ".join(said[n : n + 2]) for n in range(0, len(said), 2)))

    def _look(self, look: str, verdict: str) -> str:
        shape, state = STATES.get(verdict, NOT_YET)
        return f'<span style="color: {getattr(self._theme, state or "muted")}">{shape}&nbsp;{look}</span>'


def _of_open(run: RunViewModel) -> tuple[str, str]:
    """Shape and state of an axis of which something good is known, and something not yet, or never any more."""
    return ("…", "") if run.alive else ("▲", "warning") if run.status == "finished" else ("–", "")
