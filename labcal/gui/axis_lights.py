"""The traffic light of each body axis: coverage, noise, sign, delay and closure, as soon as its last turn has ended."""

from __future__ import annotations

from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QWidget

from labcal.gui.run_vm import AXIS_LOOKS, RunViewModel
from labcal.gui.theme import GRID, STATES
from labcal.gui.widgets import label, named, set_state


class AxisLights(QFrame):
    """In sight also while a question is open: what is red here is redone before the DUT is dismounted."""

    def __init__(self) -> None:
        super().__init__()
        named(self, "card")
        grid = QGridLayout(self)
        grid.setContentsMargins(2 * GRID, GRID, 2 * GRID, GRID)
        grid.setHorizontalSpacing(3 * GRID)
        self.worst: dict[str, QLabel] = {}
        self.looks: dict[str, dict[str, QLabel]] = {}
        for column, axis in enumerate("xyz"):
            self._add(grid, 2 * column, axis)
            grid.setColumnStretch(2 * column + 1, 1)

    def _add(self, grid: QGridLayout, column: int, axis: str) -> None:
        self.worst[axis] = label("", "title")
        grid.addWidget(self.worst[axis], 0, column)
        row = QWidget()
        inner = QGridLayout(row)
        inner.setContentsMargins(0, 0, 0, 0)
        inner.setHorizontalSpacing(GRID)
        self.looks[axis] = {look: label("", "caption") for look in AXIS_LOOKS}
        for n, one in enumerate(self.looks[axis].values()):
            inner.addWidget(one, n // 3, n % 3)
        grid.addWidget(row, 0, column + 1)

    def show_run(self, run: RunViewModel) -> None:
        """Write what is known of each axis."""
        for axis, worst in self.worst.items():
            verdict = run.axis_light(axis)
            shape, state = STATES.get(verdict, ("○", ""))
            worst.setText(f"{axis.upper()}  {shape} {verdict}".strip())
            set_state(worst, state)
            for look, found in run.axis_looks(axis).items():
                self._show_look(self.looks[axis][look], self.tr(look), found)

    def _show_look(self, shown: QLabel, look: str, verdict: str) -> None:
        shape, state = STATES.get(verdict, ("○", ""))
        shown.setText(f"{shape} {look}")
        shown.setToolTip(f"{look}: {verdict or self.tr('not measured yet')}")
        set_state(shown, state)
