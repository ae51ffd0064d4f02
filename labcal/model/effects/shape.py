"""Parameters of an effect that do not enter linearly: what each is, where it is looked for, how finely it is known.

A `Shape` carries its own value, unit and grid; its `Kind` says which search finds it, between which values it is
refined, and over which step the effect is straight in it. Most effects take one of the kinds below.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
BEYOND = 3.0  # times the last point of a grid, beyond which it is not searched
RESOLUTION = 0.6  # of 1 / (the run's length), either way of a line's frequency
FINE = 1e-3  # of a value: over so much an effect is straight in it
FINE_ROW = 0.05  # of a row, the same for a delay
FoundBy = Literal["grid", "delay scan", "changepoints", "spectral lines", "angle zeros", "own secant"]


@dataclass(frozen=True, slots=True)
class Kind:
    """What a nonlinear parameter is. Its functions are given the parameter and the times of the rows t_s (n,).

    `found_by` says where candidates come from. "grid": every point of the parameter's grid. "delay scan": the delay of
    its first channel, which it follows with one parameter for each axis, that takes most off the residual.
    "changepoints": the moments of which that is true, its columns being zero before. "spectral lines": the residual's
    own frequencies. "angle zeros": where each mounting's angle counts from, all at once. "own secant": the value of the
    linear parameter in its place.
    """

    name: str  # for people
    bracket: Callable[[Shape, Array], tuple[float, float]]  # around its value: it is refined between these
    step: Callable[[Shape, Array], float]  # over which the effect is straight in it
    found_by: FoundBy = "grid"
    u: Callable[[Shape, Array, float], float] = lambda shape, t_s, by_slope: by_slope  # from what the fit says


def _scale(shape: Shape, t_s: Array) -> tuple[float, float]:
    return _between_neighbours(shape, 1 / BEYOND)


def _not_narrower(shape: Shape, t_s: Array) -> tuple[float, float]:
    return _between_neighbours(shape, 1.0)


def _between_neighbours(shape: Shape, narrowest: float) -> tuple[float, float]:
    below = [g for g in shape.grid if g < shape.value]
    above = [g for g in shape.grid if g > shape.value]
    lower, upper = (BEYOND, 1 / BEYOND) if shape.value < 0 else (narrowest, BEYOND)
    return (max(below) if below else shape.value * lower), (min(above) if above else shape.value * upper)


def _one_grid_step(shape: Shape, t_s: Array) -> tuple[float, float]:
    width = _grid_step(shape)
    return shape.value - width, shape.value + width


def _one_delay(shape: Shape, t_s: Array) -> tuple[float, float]:
    width = min(abs(g) for g in shape.grid)
    return shape.value - width, shape.value + width


def _one_line(shape: Shape, t_s: Array) -> tuple[float, float]:
    width = RESOLUTION / float(np.ptp(t_s))
    return shape.value - width, shape.value + width


def _grid_step(shape: Shape) -> float:
    return float(np.min(np.diff(shape.grid))) if len(shape.grid) > 1 else abs(shape.value) or 1.0


def _of_its_value(shape: Shape, t_s: Array) -> float:
    return FINE * abs(shape.value)


def _of_the_grid(shape: Shape, t_s: Array) -> float:
    return FINE * _grid_step(shape)


def _of_a_row(shape: Shape, t_s: Array) -> float:
    return FINE_ROW * float(np.median(np.diff(t_s)))


def _of_a_line(shape: Shape, t_s: Array) -> float:
    return FINE / float(np.ptp(t_s))


def _between_two_rows(shape: Shape, t_s: Array, by_slope: float) -> float:
    """A step may lie anywhere between two rows (uniform)."""
    after = min(max(int(np.searchsorted(t_s, shape.value)), 1), len(t_s) - 1)
    return float((t_s[after] - t_s[after - 1]) / np.sqrt(12))


SCALE = Kind("scale", _scale, _of_its_value)  # not zero, its size unknown: searched by factors
TIME_CONSTANT = Kind("time constant", _scale, _of_its_value)  # of a response (negative: undone), or of a settling
THRESHOLD = Kind("threshold", _not_narrower, _of_its_value)  # none below the grid: ripple and noise would drive it
LEVEL = Kind("level", _one_grid_step, _of_the_grid)  # may be zero or of either sign: searched by grid steps
ANGLE = Kind("angle", _one_grid_step, _of_the_grid)  # may be zero
DELAY = Kind("delay", _one_delay, _of_a_row, "delay scan")
ZERO = Kind("zero of an angle", _one_grid_step, _of_the_grid, "angle zeros")  # in a mounting, the first one's being 0
FREQUENCY = Kind("frequency", _one_line, _of_a_line, "spectral lines")
MOMENT = Kind("moment", _scale, _of_its_value, "changepoints", _between_two_rows)
SECANT = Kind("secant", _scale, _of_its_value, "own secant")  # the interval that a derivative in time is taken over
BEGINNING = Kind("beginning", _scale, _of_its_value)  # how far off its rest a state begins, in its deviations
BEGINNING_ON = Kind("beginning on", _scale, _of_its_value)  # where a state begins on the whole, by the run's segments
CARRIED_OFF = Kind("carried off", _scale, _of_its_value)  # how far off a state may be that is carried over a gap
LESS_ITSELF = Kind("less itself", _scale, _of_its_value)  # 1: the field without the effect drives it
GIVEN = Kind("given", _scale, _of_its_value)  # by the run, the device or the author: it has no grid


@dataclass(frozen=True, slots=True)
class Shape:
    """A parameter that does not enter linearly: its value, its unit, the grid that a search starts from, its kind.

    One without a grid is not searched; those found by a scan are given one there.
    """

    name: str
    value: float
    unit: str
    grid: tuple[float, ...] = ()
    kind: Kind = SCALE

    def bracket(self, t_s: Array) -> tuple[float, float]:
        """Between which values it is refined, for rows at t_s (n,)."""
        return self.kind.bracket(self, t_s)

    def step(self, t_s: Array) -> float:
        """A change over which the effect is straight, for rows at t_s (n,)."""
        return self.kind.step(self, t_s)

    def u(self, t_s: Array, by_slope: float) -> float:
        """Its standard uncertainty, for rows at t_s (n,), where the fit gives `by_slope`."""
        return self.kind.u(self, t_s, by_slope)
