"""What the windings bear: the mean square current of each, and the moment when one has had enough."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from labcal.bench.config import AXES
from labcal.errors import InstrumentError, LimitError

Array = NDArray[np.float64]


class Windings:
    """The mean square current of each axis, fading over `window_s`: di²/dt = (i² − mean) / window."""

    def __init__(self, rms_limit_A: tuple[float, float, float], window_s: float) -> None:
        self._limit, self._window_s = np.array(rms_limit_A), window_s
        self.mean_A2: Array = np.zeros(3)
        self._current, self._t_s = np.zeros(3), 0.0

    def see(self, currents_A: Array, now_s: float) -> None:
        """Take in the measured currents (3,). Raises InstrumentError (limit reached) where a winding has had enough."""
        fading = math.exp(-(now_s - self._t_s) / self._window_s)
        self.mean_A2 = self._current**2 + (self.mean_A2 - self._current**2) * fading
        self._current, self._t_s = currents_A, now_s
        for axis, rms, limit in zip(AXES, np.sqrt(self.mean_A2), self._limit, strict=True):
            if rms > limit:
                raise InstrumentError(
                    f"coil {axis}: {rms:.3g} A root mean square over {self._window_s:.0f} s, its limit is {limit:g} A.",
                    fault="limit reached",
                    remedy="Let the winding cool, then use less current or shorter times.",
                )

    def refuse(self, target_A: Array) -> None:
        """Raise LimitError where a current would have to be taken back within a tenth of the window."""
        ahead = math.exp(-0.1)
        soon = np.sqrt(target_A**2 + (self.mean_A2 - target_A**2) * ahead)
        for axis, rms, limit in zip(AXES, soon, self._limit, strict=True):
            if rms > limit:
                raise LimitError(
                    f"coil {axis}: {rms:.3g} A root mean square would soon be reached, its limit is {limit:g} A; "
                    "nothing was set."
                )
