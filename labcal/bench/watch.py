"""What must not go unnoticed while the coils are on: a stream that falls silent or stuck, a winding that gets hot."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from labcal.bench.config import AXES
from labcal.errors import InstrumentError, LimitError
from labcal.record.stream import Block

Array = NDArray[np.float64]
STUCK_SAMPLES = 100


class StreamWatch:
    """Raises InstrumentError where nothing has come for `silent_s`, or the same values for `stuck_s`."""

    def __init__(self, name: str, silent_s: float, stuck_s: float, now_s: float) -> None:
        self._name, self._silent_s, self._stuck_s = name, silent_s, stuck_s
        self._last_s = self._changed_s = now_s
        self._value: Array | None = None
        self._same = 0

    def see(self, blocks: list[Block], now_s: float) -> None:
        """Look at what has come up to `now_s`."""
        for block in blocks:
            if block.stream in ("dut", "reference") and len(block):
                self._note(block)
        if now_s - self._last_s > self._silent_s:
            raise InstrumentError(
                f"{self._name}: no sample for {now_s - self._last_s:.1f} s.",
                fault="silent",
                remedy="Coils go to zero; look at its power and its cable.",
            )
        if self._same > STUCK_SAMPLES and self._last_s - self._changed_s > self._stuck_s:
            raise InstrumentError(
                f"{self._name}: the same reading for {self._last_s - self._changed_s:.0f} s.",
                fault="stuck",
                remedy="Coils go to zero; switch the sensor off and on, and look at its range.",
            )

    def _note(self, block: Block) -> None:
        self._last_s = float(block.t_s[-1])
        before = block.values[:1] if self._value is None else self._value[None, :]
        moved = np.flatnonzero(np.any(np.diff(np.vstack([before, block.values]), axis=0) != 0, axis=1))
        self._value = block.values[-1]
        if len(moved):
            self._changed_s, self._same = float(block.t_s[moved[-1]]), len(block) - int(moved[-1])
        else:
            self._same += len(block)


class TemperatureLimit:
    """Raises InstrumentError where one of the DUT's temperatures [degC] leaves its allowed range."""

    def __init__(self, allowed_C: tuple[float, float], channels: tuple[str, ...]) -> None:
        self._allowed, self._channels = allowed_C, channels

    def see(self, blocks: list[Block]) -> None:
        """Look at the housekeeping that has come."""
        for block in blocks:
            for name in set(self._channels) & set(block.columns):
                values = block.values[:, block.columns.index(name)]
                for value, beyond, limit in (
                    (float(np.nanmin(values)), np.less, self._allowed[0]),
                    (float(np.nanmax(values)), np.greater, self._allowed[1]),
                ):
                    if beyond(value, limit):
                        raise InstrumentError(
                            f"{block.source}: {name} is {value:g} degC, its limit is {limit:g} degC.",
                            fault="limit reached",
                            remedy="Coils go to zero; let the DUT come back into its range.",
                        )


class Windings:
    """The mean square current of each axis, fading over `window_s`: di²/dt = (i² − mean) / window."""

    def __init__(self, rms_limit_A: tuple[float, float, float], window_s: float) -> None:
        self._limit, self._window_s = np.array(rms_limit_A), window_s
        self._mean, self._current, self._t_s = np.zeros(3), np.zeros(3), 0.0

    def see(self, currents_A: Array, now_s: float) -> None:
        """Take in the measured currents (3,). Raises InstrumentError (limit reached) where a winding has had enough."""
        fading = math.exp(-(now_s - self._t_s) / self._window_s)
        self._mean = self._current**2 + (self._mean - self._current**2) * fading
        self._current, self._t_s = currents_A, now_s
        for axis, rms, limit in zip(AXES, np.sqrt(self._mean), self._limit, strict=True):
            if rms > limit:
                raise InstrumentError(
                    f"coil {axis}: {rms:.3g} A root mean square over {self._window_s:.0f} s, its limit is {limit:g} A.",
                    fault="limit reached",
                    remedy="Coils go to zero; let the winding cool, then use less current or shorter times.",
                )

    def refuse(self, target_A: Array) -> None:
        """Raise LimitError where a current would have to be taken back within a tenth of the window."""
        ahead = math.exp(-0.1)
        soon = np.sqrt(target_A**2 + (self._mean - target_A**2) * ahead)
        for axis, rms, limit in zip(AXES, soon, self._limit, strict=True):
            if rms > limit:
                raise LimitError(
                    f"coil {axis}: {rms:.3g} A root mean square would soon be reached, its limit is {limit:g} A; "
                    "nothing was set."
                )
