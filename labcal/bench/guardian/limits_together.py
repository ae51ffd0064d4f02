"""What the coils may do together, as the guardian sees it: field and duty. Refused with both numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from labcal.bench.coils.windings import Windings
from labcal.bench.config import AXES, BenchConfig
from labcal.bench.guardian.duty import DutyRecord
from labcal.errors import InstrumentError, LimitError

EARTH_NT = (
    70_000.0  # what coils may have to take away before they make a field of their own; only the session measures it
)


class TogetherLimit:
    """What all coils do together: the field they make, and the mean square current that each winding has borne."""

    def __init__(self, config: BenchConfig, duty: DutyRecord) -> None:
        limits, of_dut = config.cage.limits, config.dut.limits.field_nT
        self._matrix = config.cage.matrix if _stated(config) else None
        self._field_nT = min(limits.field_nT, of_dut or math.inf)
        self._windings = Windings(limits.rms_current_A or (math.inf,) * 3, limits.rms_window_s)
        self._windings.mean_A2 = duty.recall(limits.rms_window_s)
        self._duty = duty

    def refuse(self, currents_A: Mapping[str, float]) -> None:
        """Raise LimitError where these set-points may not be held; nothing has been sent then."""
        currents = np.array([currents_A[axis] for axis in AXES])
        self._windings.refuse(currents)
        if self._matrix is None:
            if currents.any():
                raise LimitError("the cage's calibration is not there: no field is set by it; nothing was set.")
            return
        field = float(np.linalg.norm(self._matrix @ currents))
        if not field <= self._field_nT + EARTH_NT:
            raise LimitError(
                f"a field of {field:.0f} nT of the coils alone is beyond the limit of {self._field_nT:.0f} nT, Earth's "
                f"{EARTH_NT:.0f} nT taken off; nothing was set.",
                fault="limit reached",
            )

    def hot(self, currents_A: Mapping[str, float], now_s: float) -> InstrumentError | None:
        """Why the windings have had enough of what is held now, if they have."""
        try:
            self._windings.see(np.array([currents_A[axis] for axis in AXES]), now_s)
        except InstrumentError as fault:
            return fault
        finally:
            self._duty.keep(self._windings.mean_A2, now_s)
        return None


def _stated(config: BenchConfig) -> bool:
    """Whether the current-to-field matrix is known: zero needs none."""
    return config.cage.matrix_nT_per_A is not None or config.cage.constants_nT_per_A is not None
