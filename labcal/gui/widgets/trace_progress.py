"""How far the Loop page's work is: what it does, what it last said of its time, and a bar."""

from __future__ import annotations

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.theming.theme import GRID
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.loop_words import headline
from labcal.gui.widgets.common import label
from labcal.gui.widgets.run_chooser import run_name
from labcal.gui.widgets.work_bar import WorkBar


class TraceProgress(QWidget):
    """In sight while something is computed; the end of a tracing is said below every page."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state, self._study = app_state, app_state.study_vm
        self.waiting, self.work = label("", "caption", wrap=True), WorkBar()
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(2 * GRID)
        column.addWidget(self.waiting)
        column.addWidget(self.work)
        self._every_second = QTimer(self, interval=1000)
        self._every_second.timeout.connect(self.show_progress)
        self._study.progressed.connect(self.show_progress)
        self._study.traced.connect(self._traced)

    def show_progress(self) -> None:
        """As it is now."""
        study = self._study
        doing = " · ".join(filter(None, (in_words(study.message), study.pace.words())))
        words = self.tr("tracing … {0}").format(doing) if study.traces else ""
        self.waiting.setText(", ".join(map(translated, study.waiting)) if study.busy and not words else words)
        self.waiting.setVisible(study.busy)
        self.work.show_work(study.busy, study.pace.share() if study.traces else None)
        self._every_second.start() if study.traces else self._every_second.stop()
        self.setVisible(study.busy)

    def _traced(self, run: str) -> None:
        """Whoever went elsewhere meanwhile reads it below."""
        studied, runs = self._study.of(run), self._app_state.path.runs
        name = next((run_name(one) for one in runs if one.run_id == run), run)
        if studied is not None and studied.loop is not None:
            said = self.tr("Traced, {0}: {1}").format(name, headline(studied.loop)[0])
            self._app_state.lab.update(message=said)
