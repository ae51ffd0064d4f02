"""What a card says beside coils that are not confirmed at zero: the field first, then what was read before."""

from __future__ import annotations

from labcal.gui.viewmodels.field_witness import field_says
from labcal.gui.viewmodels.lab_now import LabNow


def beside_coils(now: LabNow) -> str:
    """In sentences; "" where nothing more is known. What silent instruments have in common is looked at first."""
    field = field_says(now)
    return ". ".join(filter(None, (field[:1].upper() + field[1:], now.silent_with_current, now.in_common)))
