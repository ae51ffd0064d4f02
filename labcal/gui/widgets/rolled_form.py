"""A form with the plan of it below: together they roll where there is no room, and no field is cut in two."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.widgets.rolled import Rolled

AREA_PX = 18 * GRID  # of the settings: so much is in sight in the lowest window


class RolledForm(Rolled):
    """Holds one form at a time, and `plan`, which comes into sight when it is said."""

    def __init__(self, plan: QLabel) -> None:
        self.form: QWidget | None = None
        self._column = QVBoxLayout()
        self._column.setSpacing(2 * GRID)
        super().__init__(self._column, least=AREA_PX)
        self._plan = plan
        self._column.addWidget(plan)
        self._column.addStretch(1)

    def hold(self, form: QWidget) -> None:
        """In place of the form before it."""
        if self.form is not None and self.form is not form:
            self.form.hide()
            self.form.deleteLater()
        self.form = form
        self._column.insertWidget(0, form)
        form.setAutoFillBackground(False)
        form.show()
        self.verticalScrollBar().setValue(0)

    def show_plan(self, words: str) -> None:
        """Say it, with as much of it in sight as there is room for, from its begin; none where it is ""."""
        self._plan.setText(words)
        self._plan.setVisible(bool(words))
        if words:
            QTimer.singleShot(0, self, self._bring_plan)  # once it has its lines

    def _bring_plan(self) -> None:
        self._be_whole()
        end, begin = self._plan.geometry().bottom(), self._plan.y()
        bar, high = self.verticalScrollBar(), self.viewport().height()
        bar.setValue(min(begin, max(bar.value(), end - high)))

    def _rows(self) -> Sequence[QWidget]:
        return () if self.form is None else self.form.findChildren(QWidget)
