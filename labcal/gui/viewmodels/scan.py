"""A serial that was scanned: held up as a question, and to be undone. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from labcal.gui.viewmodels.lab import LabState, LabViewModel


class ScanViewModel(QObject):
    """`serial` came while `before` was the DUT; `taken` says that it is the DUT now."""

    changed = Signal()

    def __init__(self, lab: LabViewModel) -> None:
        super().__init__()
        self._lab = lab
        self.serial, self.before, self.taken = "", "", False
        lab.changed.connect(self._other_dut)

    @property
    def asks(self) -> bool:
        """Whether the question is open."""
        return bool(self.serial) and not self.taken

    def ask(self, serial: str) -> None:
        """Hold `serial` up as a question: whether it is the DUT from here on."""
        self._hold(serial, self._lab.state.dut_serial, taken=False)

    def take(self) -> None:
        """It is."""
        serial, before = self.serial, self.before
        self._lab.update(dut_serial=serial, dut_objection="")
        self._hold(serial, before, taken=True)

    def undo(self) -> None:
        """The DUT is the one before again."""
        self._lab.update(dut_serial=self.before)
        self.put_away()

    def put_away(self) -> None:
        """There is no question any more."""
        self._hold("", "", taken=False)

    def _hold(self, serial: str, before: str, *, taken: bool) -> None:
        if (serial, before, taken) != (self.serial, self.before, self.taken):
            self.serial, self.before, self.taken = serial, before, taken
            self.changed.emit()

    def _other_dut(self, state: LabState) -> None:
        """Whoever says otherwise which DUT it is has answered."""
        if self.serial and state.dut_serial not in (self.serial, self.before):
            self.put_away()
