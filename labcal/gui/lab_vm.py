"""The lab as the frame shows it, whatever page is open: who, what, the field now, the coils, the instruments."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Literal

from PySide6.QtCore import QObject, Signal

from labcal.gui.numbers import FieldUnit

Light = Literal["ok", "waiting", "fault", "absent"]
Triple = tuple[float, float, float]


@dataclass(frozen=True, slots=True)
class LabState:
    """One instant of the lab; None is "not known", and is shown as such."""

    dut_serial: str = ""
    operator: str = ""
    bench: str = ""
    simulated: bool = False
    field_set_nT: Triple | None = None
    field_measured_nT: Triple | None = None
    field_U_nT: float | None = None  # k = 2
    coil_A: Triple | None = None
    coils_at_zero: bool | None = None  # when they were read
    coil_words: str = ""  # what may be said of them now
    lights: tuple[tuple[str, Light, str], ...] = ()  # instrument, light, words
    unit: FieldUnit = "nT"
    message: str = ""
    waiting: str = ""


class LabViewModel(QObject):
    """Holds the `LabState`; whoever learns something says `update(...)`, the frame listens to `changed`."""

    changed = Signal(object)  # LabState

    def __init__(self) -> None:
        super().__init__()
        self.state = LabState()

    def update(self, **known: Any) -> None:
        """Take what is known by name (the fields of `LabState`) and tell the frame."""
        new = replace(self.state, **known)
        if new != self.state:
            self.state = new
            self.changed.emit(new)
