"""The lab as the frame shows it, whatever page is open: who, what, the field now, the coils, the instruments."""

from __future__ import annotations

from dataclasses import dataclass, replace
from datetime import datetime
from typing import Any

from PySide6.QtCore import QObject, Signal

from labcal.gui.viewmodels.lab_now import NOT_TOLD, LabNow
from labcal.gui.viewmodels.number_format import FieldUnit

Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class LabState:
    """One instant of the lab; None is "not known", and is shown as such. `now` is made from the state received."""

    dut_serial: str = ""
    dut_objection: str = ""  # why it is no serial
    operator: str = ""
    operator_objection: str = ""  # why it is no name
    bench: str = ""
    opening: bool = False  # a bench
    simulated: bool = False
    platform_anew: bool = False  # a simulated bench began anew: its platform is at its zero, and nothing has turned
    reading: bool = False  # every instrument, because a person asked
    asking: bool = False  # every instrument who it is, likewise
    now: LabNow = NOT_TOLD
    keep_off: tuple[str, str] = ("", "")  # the heading over every page while hands have to be off, and its state
    hands: tuple[str, str] = ("", "")  # whether they may go in, and its state; "" where none is to reach in
    other_serials: tuple[tuple[str, str], ...] = ()  # instruments that name another serial than is stated, in words
    back: tuple[tuple[str, str], ...] = ()  # who answers again, and from when to when that was out
    field_U_nT: float | None = None  # k = 2
    unit: FieldUnit = "nT"
    message: str = ""  # what happened last
    said_at: str = ""  # and when, 07:12:04
    waiting: str = ""
    waiting_state: str = ""  # of hands, where that speaks of them


class LabViewModel(QObject):
    """Holds the `LabState`; whoever learns something says `update(...)`, the frame listens to `changed`."""

    changed = Signal(object)  # LabState

    def __init__(self) -> None:
        super().__init__()
        self.state = LabState()

    def update(self, **known: Any) -> None:
        """Take what is known by name (the fields of `LabState`) and tell the frame."""
        if "said_at" not in known and known.get("message", self.state.message) != self.state.message:
            known["said_at"] = f"{datetime.now():%H:%M:%S}" if known["message"] else ""
        new = replace(self.state, **known)
        if new != self.state:
            self.state = new
            self.changed.emit(new)
