"""Three pairs of square coils: their field from magpylib, their currents through inductance and reversing contacts."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import lru_cache
from importlib import import_module
from math import inf
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import rotation_vector
from labcal.twin.step_functions import Relaxing, Steps

Array = NDArray[np.float64]
HELMHOLTZ = 0.5445  # distance of square coils over their side, for the most uniform field
AXES = ("x", "y", "z")
HOT_SWITCH_A = 0.05


@dataclass(frozen=True, slots=True)
class CoilField:
    """What 1 A in each coil makes at the centre, and how it changes with place; `wires` tells it for any place."""

    matrix_nT_per_A: Array  # (3, 3): columns are coil axes
    gradient_nT_per_A_m: Array  # (3, 3, 3): d matrix / d place, last index the direction
    wires: Wires
    exact: bool = False

    def at(self, currents_A: Array, place_m: Array) -> Array:
        """Field (n, 3) [nT, C] of `currents_A` (n, 3) at `place_m` (3,) or (n, 3), to first order in the place."""
        if self.exact and place_m.ndim == 1:
            return np.asarray(currents_A @ self.wires.at(tuple(place_m), False).T)
        centre = currents_A @ self.matrix_nT_per_A.T
        if not np.any(place_m):
            return np.asarray(centre)
        return np.asarray(centre + np.einsum("ijk,nj,...k->ni", self.gradient_nT_per_A_m, currents_A, place_m))


@dataclass(frozen=True)
class Wires:
    """Three square pairs as they are wound; `imbalance` (3,): the half towards + makes so much more, relative."""

    side_m: float
    turns: int
    tilt_deg: Array  # (3, 3): the rotation vector of each axis away from its ideal direction
    spacing: float
    imbalance: tuple[float, ...] = (0.0, 0.0, 0.0)
    _known: dict[tuple[tuple[float, ...], bool], Array] = field(default_factory=dict, compare=False)

    def at(self, place_m: tuple[float, ...], opposed: bool) -> Array:
        """Of 1 A in each coil (3, 3) [nT/A] at this place; `opposed`: with the half towards + reversed."""
        if (place_m, opposed) not in self._known:
            pairs = [self.pair(axis, np.array([place_m]), opposed)[0] for axis in range(3)]
            self._known[place_m, opposed] = np.column_stack(pairs)
        return self._known[place_m, opposed]

    def pair(self, axis: int, places: Array, opposed: bool = False) -> Array:
        """Field (n, 3) [nT/A] of one pair at `places` (n, 3)."""
        magpylib: Any = import_module("magpylib")  # slow to import, and without types

        half = self.side_m / 2
        square = half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1], [-1, -1]])
        turn = rotation_vector(np.radians(self.tilt_deg[axis]))
        total = np.zeros_like(places)
        for end in (-1, 1):
            loop = np.insert(square, 2, end * self.spacing * half, axis=1)
            loop = np.roll(loop, axis + 1, axis=1) @ turn.T  # z → the axis wanted, right-handed
            current = self.turns * (1 + end * self.imbalance[axis] / 2) * (-1 if opposed and end > 0 else 1)
            total += 1e9 * np.asarray(magpylib.current.Polyline(current=current, vertices=loop).getB(places))
        return total


def square_coils(
    side_m: float,
    turns: int,
    tilt_deg: Array,
    spacing: float = HELMHOLTZ,
    imbalance: tuple[float, ...] = (0.0, 0.0, 0.0),
    exact: bool = False,
) -> CoilField:
    """Three square pairs, each axis tilted by the rotation vector `tilt_deg[axis]` (3, 3) from its ideal direction."""
    tilts = tuple(map(tuple, np.asarray(tilt_deg, dtype=float)))
    matrix, gradient = _about_the_centre(side_m, turns, tilts, spacing, imbalance)
    return CoilField(matrix.copy(), gradient.copy(), Wires(side_m, turns, tilt_deg, spacing, imbalance), exact)


@lru_cache(maxsize=64)
def _about_the_centre(
    side_m: float, turns: int, tilts_deg: tuple[tuple[float, ...], ...], spacing: float, imbalance: tuple[float, ...]
) -> tuple[Array, Array]:
    """The field at the centre and its change with place; kept, for a simulated lab is opened again and again."""
    step = 0.02
    shifts = np.vstack([np.zeros(3), step * np.eye(3), -step * np.eye(3)])
    wires = Wires(side_m, turns, np.array(tilts_deg), spacing, imbalance)
    fields = np.stack([wires.pair(axis, shifts) for axis in range(3)], axis=-1)  # (7, 3, 3): place, component, coil
    return fields[0], np.moveaxis((fields[1:4] - fields[4:7]) / (2 * step), 0, -1)


@dataclass
class Coil:
    """One axis: the supply's output through inductance, the contacts that may reverse it, and what may open it."""

    resistance_ohm: float
    tau_s: float
    residual_A: float = 0.0  # what the supply lets through at set-point zero with the output on
    current: Relaxing = field(init=False)
    sign: Steps[int] = field(default_factory=lambda: Steps(1))
    hot_switches: list[float] = field(default_factory=list)
    closed_until_s: dict[str, float] = field(default_factory=dict)  # by whatever opens it by itself when nobody beats
    _wanted_A: float = field(default=0.0, init=False)

    def __post_init__(self) -> None:
        self.current = Relaxing(self.tau_s)

    def drive(self, t_s: float, current_A: float, voltage_V: float, on: bool) -> bool:
        """The supply now regulates to this; True where its voltage is too low for its current (constant voltage)."""
        reachable = voltage_V / self.resistance_ohm
        wanted = current_A + self.residual_A if on else 0.0
        limited = on and abs(wanted) > reachable
        self._wanted_A = float(np.clip(wanted, -reachable, reachable))
        self._flow(t_s)
        return bool(limited)

    def close(self, t_s: float, by: str, until_s: float) -> None:
        """What is called `by` lets the current through until `until_s` and opens the circuit then; opens it now where
        that is past.
        """
        self.closed_until_s[by] = until_s
        self._flow(t_s)

    def reverse(self, t_s: float, sign: int) -> None:
        """Move the contacts; under current that is a hot switch and is remembered."""
        if sign != self.sign.last:
            if abs(self.current.now(t_s)) > HOT_SWITCH_A:
                self.hot_switches.append(t_s)
            self.sign.set(t_s, sign)

    def _flow(self, t_s: float) -> None:
        end_s = min(self.closed_until_s.values(), default=inf)
        self.current.set(t_s, self._wanted_A if t_s < end_s else 0.0)
        if t_s < end_s < inf:
            self.current.set(end_s, 0.0)

    def at(self, t_s: Array) -> Array:
        """Signed current (n,) [A] in the winding."""
        return np.asarray(self.sign.values)[self.sign.index(t_s)] * self.current.at(t_s)
