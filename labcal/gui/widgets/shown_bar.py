"""Says on a page whose run it shows, where that is not the one of the marks, and leads back to that one."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout

from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.widgets.common import Card, button, label, set_state
from labcal.gui.widgets.run_chooser import run_name


class ShownBar(Card):
    """Above every page; in sight on those that show a run, or a calibration, of another DUT, or another run."""

    def __init__(self, app_state: AppState) -> None:
        super().__init__()
        self._app_state, self._page = app_state, ""
        self.words = label("", wrap=True)
        set_state(self.words, "warning")
        self.back = button("", self.tr("This page shows the DUT to be measured again"))
        self.back.clicked.connect(app_state.one_dut.back)
        self.take = button("", self.tr("From here on this is the DUT to be measured: the one that is mounted"))
        self.take.clicked.connect(self._take)
        row = QHBoxLayout()
        row.addWidget(self.words, 1)
        row.addWidget(self.take)
        row.addWidget(self.back)
        self.body.addLayout(row)
        app_state.one_dut.changed.connect(self.show_shown)
        app_state.run.changed.connect(self._enable)
        self.show_shown()

    def show_page(self, page: str) -> None:
        """This page is the one in sight."""
        self._page = page
        self.show_shown()

    def show_shown(self) -> None:
        """Whose it is, and of which DUT, or which run, the marks and Next speak."""
        if self._app_state.one_dut.beside_the_marks(self._page):
            return self._show_another_run()
        serial, run = self._app_state.one_dut.shown(self._page)
        here = self._app_state.lab.state.dut_serial
        listed = (run_name(one) for one in self._app_state.path.runs if one.run_id == run)
        measured = self.tr("To be measured: {0}; the marks at the left and Next are of it.").format(here)
        if not here:
            measured = self.tr("Which DUT is to be measured is not said yet.")
        self.words.setText(self.tr("Shown: {0}. {1}").format(next(listed, serial), measured))
        self.back.setText(self.tr("Back to {0}").format(here))
        self.back.setVisible(bool(here))
        self.take.show()
        self.take.setText(self.tr("Measure {0}").format(serial))
        self.setVisible(bool(serial))
        return self._enable()

    def _show_another_run(self) -> None:
        """Of the same DUT."""
        path = self._app_state.path
        last, shown = path.last(), next(one for one in path.runs if one.run_id == self._app_state.study_vm.run)
        marked = self.tr("The marks at the left and Next are of no run yet.")
        if last is not None:
            marked = self.tr("The marks at the left and Next are of another run: {0}.").format(run_name(last))
        self.words.setText(self.tr("Shown: {0}. {1}").format(run_name(shown), marked))
        self.back.setText(self.tr("Back to that run") if last is not None else self.tr("Put it away"))
        self.back.show()
        self.take.hide()
        self.show()

    def _take(self) -> None:
        self._app_state.set_identity(dut=self._app_state.one_dut.shown(self._page)[0])

    def _enable(self) -> None:
        self.take.setEnabled(not self._app_state.run.alive)
