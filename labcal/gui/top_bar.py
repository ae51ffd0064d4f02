"""The bar above every page: which DUT, who works here, the bench, and Coils off."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLineEdit, QPushButton, QVBoxLayout

from labcal.gui.theming.theme import GRID
from labcal.gui.viewmodels.lab import LabState
from labcal.gui.viewmodels.what_happens import keep_off_words
from labcal.gui.widgets.barcode_scanner import takes_names, takes_scans
from labcal.gui.widgets.by_itself import cannot_be_shown
from labcal.gui.widgets.common import OneLine, Surface, label, plain, set_state
from labcal.gui.widgets.roomy import Roomy


class TopBar(Surface):
    """DUT, operator, bench, SIMULATED where it is, HANDS OFF where it holds, and Coils off: in sight on every page.

    `reason`: why one is not accepted; it lies over the top of the page, which moves for nobody who types.
    """

    def __init__(self) -> None:
        super().__init__(Qt.Edge.BottomEdge)
        column, row = QVBoxLayout(self), QHBoxLayout()
        column.setContentsMargins(2 * GRID, GRID, 2 * GRID, GRID)
        column.setSpacing(GRID // 2)
        column.addLayout(row)
        row.setSpacing(GRID)
        self.dut, self.operator, self.bench = QLineEdit(), QLineEdit(), OneLine()
        self.dut.setToolTip(self.tr("Serial number of the device under test: type it, or scan it at any moment"))
        self.operator.setToolTip(self.tr("Who works here now; stands in the record and in the calibration"))
        for caption, value in ((self.tr("DUT"), self.dut), (self.tr("Operator"), self.operator)):
            value.setAccessibleName(caption)
            value.setPlaceholderText(self.tr("needed"))
            value.setMinimumWidth(4 * GRID)
            value.editingFinished.connect(partial(_show_beginning, value))
            row.addWidget(label(caption, "caption"))
            row.addWidget(value)
            row.addSpacing(GRID)
        self._tips = {entry: entry.toolTip() for entry in (self.dut, self.operator)}
        self.dut.returnPressed.connect(self.operator.setFocus)
        takes_scans(self.dut)
        takes_names(self.operator)
        row.addWidget(label(self.tr("Bench"), "caption"))
        row.addWidget(self.bench)
        row.addStretch()
        self.simulated = label(self.tr("SIMULATED"), "simulated")
        row.addWidget(self.simulated)
        row.addStretch()
        self.keep_off = Roomy("keep_off")
        self.keep_off.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self.keep_off.setAccessibleName(self.tr("Whether hands have to be off"))
        row.addWidget(self.keep_off)
        self.off = QPushButton(self.tr("COILS OFF   F12"))
        self.off.setObjectName("off")
        self.off.setToolTip(self.tr("Take every coil to zero now (F12). Works in every state and asks nothing."))
        self.off.setFocusPolicy(Qt.FocusPolicy.NoFocus)  # a name, Tab, Space must not press it; its key is F12
        row.addWidget(self.off)
        self.reason = OneLine()
        set_state(self.reason, "bad")
        self.reason.setAutoFillBackground(True)

    def show_state(self, state: LabState) -> None:
        """Write the state."""
        for entry, text in ((self.dut, state.dut_serial), (self.operator, state.operator)):
            if entry.text() != text and not (_is_in(entry) and entry.isModified()):
                entry.setText(text)
                entry.setCursorPosition(0)  # of a long one its beginning is seen
            entry.setToolTip(plain(f"{text}\n{self._tips[entry]}") if text else self._tips[entry])
        self._show_objections(state)
        self.bench.setText(state.bench or "–")
        words, mark = state.keep_off
        self.keep_off.room_for(*keep_off_words())  # SIMULATED does not move as it comes
        self.keep_off.setText(words)
        set_state(self.keep_off, mark)
        self.keep_off.setVisible(bool(words))
        self.simulated.setVisible(state.simulated)

    def wanted(self, state: LabState) -> QLineEdit | None:
        """The field that has to be filled in first; None where none has, or nobody types there now."""
        open_still = (
            (self.dut, not state.dut_serial or bool(state.dut_objection)),
            (self.operator, not state.operator or bool(state.operator_objection)),
        )
        return next((one for one, wanted in open_still if wanted and state.bench and not one.isReadOnly()), None)

    def blank(self) -> None:
        """It cannot be shown: no old word on hands stays."""
        self.keep_off.setText(f"▲ {cannot_be_shown()}")
        set_state(self.keep_off, "bad")
        self.keep_off.show()

    def _show_objections(self, state: LabState) -> None:
        """A red frame around what is not accepted, and the reason below, whichever page is open."""
        objections = {self.dut: state.dut_objection, self.operator: state.operator_objection}
        for entry, objection in objections.items():
            set_state(entry, "bad" if objection else "")
        self.reason.setText("   ".join(f"✕ {one}" for one in objections.values() if one))
        self.reason.setToolTip(plain(self.reason.text()))  # the whole, where there is no room for it
        self.reason.setVisible(bool(self.reason.text()))


def _is_in(entry: QLineEdit) -> bool:
    """Whether what is typed in its window goes there, also while another program is in front."""
    return entry.window().focusWidget() is entry


def _show_beginning(entry: QLineEdit) -> None:
    """Of a long serial or name that was left; who comes back from another program goes on where the cursor was."""
    if not _is_in(entry):
        entry.setCursorPosition(0)
