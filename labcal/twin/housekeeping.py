"""What a spacecraft tells about itself: supply currents, temperatures, bus voltage; functions of time alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from labcal.twin.step_functions import Steps

Array = NDArray[np.float64]
HOURS = 12


def telegraph(rng: np.random.Generator, mean_s: float, until_s: float = HOURS * 3600.0) -> tuple[Array, Array]:
    """Switching times and states (0 or 1) of a random telegraph whose states last `mean_s` on average."""
    n = int(2 * until_s / mean_s) + 8
    return np.cumsum(rng.exponential(mean_s, n)), (np.arange(n) % 2).astype(float)


def walk(rng: np.random.Generator, per_root_s: float, until_s: float = HOURS * 3600.0) -> Array:
    """A random walk on whole seconds, one column an axis: (until, 3)."""
    return np.cumsum(rng.normal(scale=per_root_s, size=(int(until_s), 3)), axis=0)


@dataclass
class Housekeeping:
    """Channels by name; each load's current follows its own on/off pattern, temperatures follow the loads slowly."""

    rng: np.random.Generator
    loads_A: Mapping[str, float]  # channel -> current when on
    idle_A: float = 0.05
    period_s: float = 60.0
    noise_A: float = 0.002
    noise_C: float = 0.02
    patterns: dict[str, tuple[Array, Array]] = field(init=False)
    forced: dict[str, Steps[float]] = field(init=False)  # nan: as the pattern says

    def __post_init__(self) -> None:
        self.patterns = {
            name: telegraph(self.rng, self.period_s * (1 + 0.5 * k)) for k, name in enumerate(self.loads_A)
        }
        self.forced = {name: Steps(np.nan) for name in self.loads_A}
        self._ripple = self.rng.uniform(0, 2 * np.pi, 4)

    def force(self, t_s: float, load: str, on: bool) -> None:
        """Somebody switches a load; from then on it stays so."""
        self.forced[load].set(t_s, float(on))

    def true(self, t_s: Array) -> dict[str, Array]:
        """Every channel (n,) as it is."""
        channels = {name: self._current(name, t_s) for name in self.loads_A}
        total = np.sum([*channels.values()], axis=0)
        channels["v_bus"] = 8.1 - 0.15 * total
        warm = 6 * (1 - np.exp(-np.maximum(t_s, 0) / 1500))
        wave = np.sin(2 * np.pi * t_s / 900 + self._ripple[0]) + 0.6 * np.sin(2 * np.pi * t_s / 377 + self._ripple[1])
        channels["temp_dut"] = 21.5 + warm + 0.8 * wave
        channels["temp_board"] = 23.0 + 0.5 * warm + 0.4 * np.sin(2 * np.pi * t_s / 1310 + self._ripple[2])
        return channels

    def with_noise(self, true: Mapping[str, Array]) -> dict[str, Array]:
        """The channels as they are sent: with the noise of their own converters."""
        sigma = np.array([{"i": self.noise_A, "t": self.noise_C, "v": 0.01}[name[0]] for name in true])
        noise = sigma * self.rng.standard_normal((len(next(iter(true.values()))), len(true)))
        return {name: value + noise[:, k] for k, (name, value) in enumerate(true.items())}

    def _current(self, name: str, t_s: Array) -> Array:
        times, states = self.patterns[name]
        on = states[np.searchsorted(times, t_s, side="right") % len(states)]
        forced = np.asarray(self.forced[name].values)[self.forced[name].index(t_s)]
        on = np.where(np.isnan(forced), on, forced)
        return np.asarray(self.idle_A + (self.loads_A[name] - self.idle_A) * on)
