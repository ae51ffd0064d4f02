"""Below the page of one run: what is being computed of another one, and the way to it."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP, Qt
from PySide6.QtWidgets import QHBoxLayout, QWidget

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.studied import Studied
from labcal.gui.widgets.common import button, label
from labcal.gui.widgets.run_chooser import run_name

TRACED = QT_TRANSLATE_NOOP("Words", "Being traced: {0}")
FITTED = QT_TRANSLATE_NOOP("Words", "Being fitted: {0}")


class GoesOnElsewhere(QWidget):
    """One quiet line, where anything is computed of a run that is not the one in sight."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state, self._first = app_state, Studied("")
        self.words = label("", "caption", wrap=True)
        self.show_it = button(translated("Show it"), translated("Open that run on the page that computes it"))
        self.show_it.clicked.connect(self._go)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.words, 1)
        row.addWidget(self.show_it, 0, Qt.AlignmentFlag.AlignTop)
        app_state.study_vm.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        others = self._app_state.study_vm.elsewhere()
        self.setVisible(bool(others))
        if others:
            self._first = others[0]
            runs = {one.run_id: run_name(one) for one in self._app_state.path.runs}
            self.words.setText("; ".join(_said(one, runs.get(one.run, one.run)) for one in others))

    def _go(self) -> None:
        """To the first of them."""
        page = "Loop" if self._first.traces else "Fit"
        self._app_state.one_dut.open(self._first.run)
        self._app_state.page_requested.emit(page)


def _said(studied: Studied, name: str) -> str:
    return translated(str(TRACED if studied.traces else FITTED)).format(name)
