"""A LEMI-025 with a GPS fix: a record a second of the ten samples before it."""

from __future__ import annotations

from collections.abc import Mapping
from datetime import UTC, datetime
from typing import Any

import numpy as np

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker
from drivers.framing import lemi

BEGAN = datetime(2026, 1, 1, tzinfo=UTC).timestamp()


class Lemi025Emulator(Talker):
    """The record that leaves at t names the second t - `sent_after_s`."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        def record(t_s: float, _: list[float]) -> bytes:
            second = t_s - settings.sent_after_s
            times = second - settings.gps_delay_s + np.arange(lemi.SAMPLES) / lemi.SAMPLES
            field = lab.reference_nT(times) * lab.reference_nT_per_unit / 1000
            return lemi.build(settings.tag.encode(), round(BEGAN + second), True, field)

        super().__init__(lambda times: times[:, None], record, rate_hz=1.0)
