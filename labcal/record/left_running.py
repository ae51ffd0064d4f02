"""A run that was left without an end: nobody has said how it left the coils."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class LeftRunning:
    """The last run on a bench. `goes_on`: its process lives, else it was cut off."""

    run_id: str
    dut_serial: str
    goes_on: bool
