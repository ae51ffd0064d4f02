"""The question that a scan asks where no field waited for it, and Undo once it was answered with yes."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout

from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.scan import ScanViewModel
from labcal.gui.widgets.common import Card, button, label


class ScanCard(Card):
    """Shows a `ScanViewModel`, and nothing while it holds nothing."""

    def __init__(self, scan: ScanViewModel) -> None:
        super().__init__()
        self._scan = scan
        self.words = label("", wrap=True)
        self.take = button("", self.tr("From here on this is the serial of the DUT"))
        self.leave = button("", self.tr("The scan is forgotten"), primary=True)  # it changes nothing
        self.undo = button(self.tr("Undo"), self.tr("The DUT is the one before again"))
        self.take.clicked.connect(scan.take)
        self.leave.clicked.connect(scan.put_away)
        self.undo.clicked.connect(scan.undo)
        row = QHBoxLayout()
        row.addWidget(self.words, 1)
        for widget in (self.undo, self.leave, self.take):
            row.addWidget(widget)
        self.body.addLayout(row)
        scan.changed.connect(self._show)
        self._show()

    def hear(self, app_state: AppState, text: str) -> None:
        """A scan, where no field waited for it; what has blanks is none, and is shown to nobody: it may be a secret."""
        if " " in text and not app_state.run.asks_serial:
            return app_state.said_for_now.say(self.tr("✕ Scanned, and not taken: no serial has blanks"))
        return app_state.scan(text)

    def _show(self) -> None:
        scan = self._scan
        before = scan.before or self.tr("none")
        asks = self.tr("Scanned {0}. Is it the DUT from here on? Until now: {1}.")
        done = self.tr("The DUT is {0}, in place of {1}.")
        self.words.setText((done if scan.taken else asks).format(scan.serial, before))
        self.take.setText(self.tr("Take {0}").format(scan.serial))
        self.leave.setText(self.tr("Close") if scan.taken else self.tr("Leave {0}").format(before))
        self.take.setVisible(not scan.taken)
        self.undo.setVisible(scan.taken)
        self.setVisible(bool(scan.serial))
