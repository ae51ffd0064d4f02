"""Run: choose a procedure and its settings; then the step, the question or the live picture, and what was measured."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from PySide6.QtWidgets import QVBoxLayout, QWidget

from labcal.gui.pages.run_choose import Choose
from labcal.gui.pages.run_live import Live
from labcal.gui.theming.theme import GRID, Theme
from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import FaceStack
from labcal.gui.widgets.kept_focus import focus_kept_in
from labcal.gui.widgets.plots import Loci, Traces


class RunPage(QWidget):
    """Two faces: `choose` while nothing runs, `live` from the start of a run until it is put away."""

    def __init__(self, app_state: AppState, theme: Theme) -> None:
        super().__init__()
        self._app_state = app_state
        self.choose = Choose(app_state)
        self.faces = FaceStack()
        self.choose.setContentsMargins(0, 0, 2 * GRID, 0)
        self.faces.addWidget(self.choose)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * GRID, 2 * GRID, 0, 2 * GRID)  # at the right each face has its own
        column.addWidget(self.faces)
        app_state.procedure_requested.connect(self._open_wanted)
        self._open_wanted()
        self._more = self._build(theme)

    def build_more(self) -> bool:
        """Build what is still missing, a part at a time; says whether anything was."""
        return next(self._more, False)

    def _build(self, theme: Theme) -> Iterator[bool]:
        loci = Loci(theme, clouds=2)  # of this stretch, and pale of those before it was gone on with
        loci.setParent(self)  # a theme that comes before it has its place is its own as well
        yield True
        while loci.build_more():
            yield True
        traces = Traces(theme, "DUT  nT")
        traces.setParent(self)
        yield True
        self.live = Live(self._app_state, theme, loci, traces)
        self.faces.addWidget(self.live)
        self.live.put_away.connect(self._put_away)
        self._app_state.run.changed.connect(self._show)
        self._show()
        yield True

    def open_procedure(self, names: str, settings: Mapping[str, str] | None = None) -> None:
        """Show the form of a procedure, with the settings that it is proposed with, unless a run goes on."""
        if not self._app_state.run.alive:
            self.choose.choose(names, settings)
            self.faces.setCurrentWidget(self.choose)

    @property
    def begins_at(self) -> QWidget | None:
        """The setting that is to be mended before anything else."""
        return self.choose.refused_field() if self.faces.currentWidget() is self.choose else None

    def begin(self) -> None:
        """As Close, where a run that has ended is in sight, then Begin: what is chosen, if it may begin."""
        if not self._app_state.run.alive and self.faces.currentWidget() is not self.choose:
            self._put_away()
        self.choose.start.click()

    def _open_wanted(self) -> None:
        if (wanted := self._app_state.take_wanted()) is not None:
            self.open_procedure(wanted.names, wanted.settings)
            if wanted.plan:
                self.choose.rehearse()

    def _show(self) -> None:
        if self._app_state.run.alive or self._app_state.run.state == "ended":
            with focus_kept_in(self, self.live.note, self.live.close_run):
                self.faces.setCurrentWidget(self.live)

    def _put_away(self) -> None:
        with focus_kept_in(self, self.choose.start, self.choose.list):
            self.faces.setCurrentWidget(self.choose)
