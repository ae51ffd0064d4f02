"""The question that a scan asks where no field waited for it, and Undo once it was answered with yes."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLineEdit
from shiboken6 import isValid

from labcal.gui.viewmodels.app_state import AppState
from labcal.gui.viewmodels.scan import ScanViewModel
from labcal.gui.widgets.barcode_scanner import Scanner
from labcal.gui.widgets.common import Card, button, label


class ScanCard(Card):
    """Shows a `ScanViewModel`, and nothing while it holds nothing."""

    def __init__(self, scan: ScanViewModel) -> None:
        super().__init__()
        self._scan = scan
        self._field: QLineEdit | None = None
        self._caught = ""
        self.words = label("", wrap=True)
        self.take = button("", self.tr("From here on this is the serial of the DUT"))
        self.leave = button("", self.tr("The scan is forgotten"), primary=True)  # it changes nothing
        self.undo = button(self.tr("Undo"), self.tr("The DUT is the one before again"))
        self.typed = button(self.tr("It was typed"), self.tr("Into the field where it was typed; it is no scan"))
        self.typed.clicked.connect(self._give_back)
        self.take.clicked.connect(scan.take)
        self.leave.clicked.connect(scan.put_away)
        self.undo.clicked.connect(scan.undo)
        row = QHBoxLayout()
        row.addWidget(self.words, 1)
        for widget in (self.typed, self.undo, self.leave, self.take):
            row.addWidget(widget)
        self.body.addLayout(row)
        scan.changed.connect(self._show)
        self._show()

    def hear(self, app_state: AppState, scanner: Scanner, text: str) -> None:
        """A scan; or letters of quick fingers, which go into the field where they were typed."""
        (field, caught), run = scanner.caught, app_state.run
        if field is not None and run.alive and not run.asks_serial and not scanner.by_enter:
            return field.insert(caught)  # nobody asks for a scan, and none ends like that
        self.catch(field, caught)
        app_state.scan(text)
        if field is not None and not run.alive and app_state.serial_objection(text):
            field.insert(caught)  # it is no serial
        return None

    def catch(self, field: QLineEdit | None, text: str) -> None:
        """What came so fast while `field` had the focus: quick fingers may have typed it there."""
        more = self._scan.asks and field is not None and field is self._field
        self._field, self._caught = field, (self._caught if more else "") + text

    def _give_back(self) -> None:
        field, text = self._field, self._caught
        self._field, self._caught = None, ""
        self._scan.put_away()
        if field is not None and isValid(field):
            field.setFocus(Qt.FocusReason.OtherFocusReason)
            field.end(False)
            field.insert(text)

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
        self.typed.setVisible(scan.asks and self._field is not None)
        self.setVisible(bool(scan.serial))
