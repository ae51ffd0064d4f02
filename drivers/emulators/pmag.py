"""A DUT that sends a sentence a sample, ten times a second."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker, dut_rows
from drivers.framing import nmea


class PmagEmulator(Talker):
    """Time and temperature with three decimals, readings with one."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        forms = ["%.1f" if name in "xyz" else "%.3f" for name in settings.columns]
        super().__init__(
            dut_rows(lab, settings.columns, settings),
            lambda t, row: nmea.build(settings.sentence, [f % v for f, v in zip(forms, row, strict=True)]),
        )
