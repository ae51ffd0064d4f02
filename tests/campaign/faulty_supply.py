"""What a supply can do by itself: lie about what it does, trip, come back with its panel's values."""

from __future__ import annotations

import copy
from typing import Any

from drivers.emulators.riden_rd60xx import OUTPUT, PER_A, PER_V, I, V

PANEL_V = 20.0


class Front:
    """A coil as its supply sees it. `orders`: (when, magnitude that it was told, 0 for off) [s, A]."""

    def __init__(self, coil: Any) -> None:
        self.coil, self.orders = coil, list[tuple[float, float]]()
        self._believed: Any = None  # what a lying supply says it drives
        self._measures_truly = True

    def __getattr__(self, name: str) -> Any:
        return getattr(self.coil, name)

    @property
    def current(self) -> Any:
        """What the supply measures."""
        return self.coil.current if self._measures_truly else self._believed.current

    def drive(self, t_s: float, current_A: float, voltage_V: float, on: bool) -> bool:
        """What the supply was told."""
        self.orders.append((t_s, abs(current_A) if on else 0.0))
        self._last = (current_A, voltage_V, on)
        coil = self.coil if self._believed is None else self._believed
        return bool(coil.drive(t_s, current_A, voltage_V, on))

    def lie(self, measures_truly: bool) -> None:
        """From now on it says yes and does nothing."""
        self._believed, self._measures_truly = copy.deepcopy(self.coil), measures_truly

    def repent(self, t_s: float) -> None:
        """It does what it was told."""
        if self._believed is not None:
            self._believed, self._measures_truly = None, True
            self.coil.drive(t_s, *self._last)


def panel(device: Any, front: Front, t_s: float, current_A: float, on: bool) -> None:
    """What somebody, or a trip, or mains that come back, sets at the supply of `front` without a word on its line."""
    if hasattr(device, "_outputs"):
        output = next(output for output in device._outputs.values() if output.coil is front)
        output.I, output.V, output.on = current_A, PANEL_V, on
    elif hasattr(device, "_slaves"):
        riden = next(s._write.__self__ for s in device._slaves if s._write.__self__._coil is front)
        riden._held |= {I: round(current_A * PER_A), V: round(PANEL_V * PER_V), OUTPUT: int(on)}
    elif hasattr(device, "_current_mode"):
        device._values, device._current_mode, device._on = {"CURR": current_A, "VOLT": PANEL_V}, True, on
    else:
        device._values, device._on = {"V": PANEL_V, "I": current_A}, on
    front.drive(t_s, current_A, PANEL_V, on)


def clear_watchdog(device: Any, t_s: float) -> None:
    """Somebody switches its outputs off and clears what has tripped, at its panel."""
    for output in device._outputs.values():
        output.on = False
        output.coil.drive(t_s, 0.0, output.VOLT, False)
    device._watching, device._ends_s = False, float("inf")
    device._hear(t_s)
