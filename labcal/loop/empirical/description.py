"""What a smooth function looks like, which physics has that shape, and the experiment that would tell."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.result import NextExperiment
from labcal.model import EffectRecord
from labcal.model.effects import Scene
from labcal.model.effects.inputs import ATTITUDE, CHANNEL, FIELD, RATE, values
from labcal.model.effects.regressors import stretches
from labcal.model.smooth import Basis, curve
from labcal.record import Run

Array = NDArray[np.float64]
POINTS = 200  # of a curve,
GRID = 24  # and along each input of a map
NEARLY_ALL = 0.97  # of a curve's square, that a simpler curve may stand for it
SHORT = 0.15  # of the range, within which a step is over
LEVEL = 0.1  # of the height: nearer to an end's value than this is at it
FLAT = 0.25  # of the steepest slope: an end that is flatter has saturated
RETURNS = 0.4  # of a hill's height, that its feet may differ by
OTHER_WAY = 0.03  # of what is left, that the direction of the input may explain beyond chance
PHYSICS = {
    "straight": "a sensitivity to it that the library has no file for, or that follows another quantity",
    "quadratic": "heating by a current, a magnet's force, or a straight effect on both sides of a null",
    "saturating": "a core or an amplifier at its limit, or a magnetic part that saturates",
    "resonant": "a mechanical or electrical resonance, or a filter's edge, at that value",
    "a step": "a thermostat, a comparator or a changeover of range at that value",
    "wavy": "interference, a converter's missing codes, or a beat with a clock",
    "a bent curve": "a response of higher order; more range would show which",
    "a product": "a sensitivity to one that the other changes, as a gain that follows a temperature",
    "a map": "two causes that act together",
}
EXPERIMENTS = {  # of what varies: what to do, and the procedure
    FIELD: ("step the field up and down along each axis, through more than its range", "linearity"),
    ATTITUDE: ("turn through many attitudes in one field, then in half of it", "field-sphere"),
    RATE: ("turn at several rates, forwards and backwards", "rate-sweep"),
    "temperature": ("hold the attitude, warm the device and let it cool, over a wider range", "temperature-drift"),
    "current": ("hold the attitude and step the current up and down through its range", "current-coupling"),
}  # fmt: skip


@dataclass(frozen=True, slots=True)
class FunctionShape:
    """What a function looks like: one of PHYSICS, where, and whether it differs on the way back."""

    kind: str
    at: float | None = None
    both_ways: bool = True

    def says(self, inputs: tuple[str, ...]) -> str:
        """One sentence or two."""
        where = "" if self.at is None else f" about {self.at:.4g}"
        back = "" if self.both_ways else " It differs on the way back: something remembers, as iron and warm masses do."
        of = " and ".join(name.removeprefix(CHANNEL).replace("_", " ") for name in inputs)
        return f"Over {of} it is {self.kind}{where}: {PHYSICS[self.kind]}.{back}"


def describe_function(
    basis: Basis, hull: Array, left_nT: Array, scene: Scene, inputs: tuple[str, ...]
) -> FunctionShape:
    """The shape of a function over its domain; `left_nT` (n, 3) is what remains of the rows of `scene`."""
    described = shape_of(basis, hull, inputs)
    if len(inputs) == 2:
        return described
    return replace(described, both_ways=not _differs_on_the_way_back(values(inputs, scene)[:, 0], left_nT, scene))


def shape_of(basis: Basis, hull: Array, inputs: tuple[str, ...]) -> FunctionShape:
    """The same of the function alone."""
    if len(inputs) == 2:
        return FunctionShape(_of_two(basis, hull))
    x = np.linspace(hull.min(), hull.max(), POINTS)
    kind, place = of_one(_main(curve(basis, x[:, None])[0]))
    return FunctionShape(kind, None if place is None else float(x[place]))


def _main(f: Array) -> Array:
    """The one curve (n,) that stands for most of the three, its mean taken off."""
    f = f - f.mean(axis=0)
    return np.asarray(f @ np.linalg.svd(f, full_matrices=False)[2][0])


def of_one(y: Array) -> tuple[str, int | None]:
    """The kind, and the point that it is about."""
    x, power = np.linspace(-1, 1, len(y)), float(y @ y)
    for degree, kind in ((1, "straight"), (2, "quadratic")):
        off = y - np.polynomial.Polynomial.fit(x, y, degree)(x)
        if off @ off < (1 - NEARLY_ALL) * power:
            return kind, None
    slope, height = np.gradient(y), float(np.ptp(y))
    steep = np.abs(slope) > FLAT * np.abs(slope).max()
    turns = np.flatnonzero(np.diff(np.sign(slope[steep])) != 0)
    if not len(turns):
        inside = int(np.argmax(np.abs(slope)))
        if np.sum(np.abs(y - np.sort(y[[0, -1]])[:, None]).min(axis=0) > LEVEL * height) < SHORT * len(y):
            return "a step", inside
        return ("saturating", inside) if not (steep[0] and steep[-1]) else ("a bent curve", None)
    if len(turns) == 1 and abs(y[0] - y[-1]) < RETURNS * height:
        return "resonant", int(np.argmax(np.abs(y - (y[0] + y[-1]) / 2)))
    return ("wavy", None) if len(turns) > 1 else ("a bent curve", None)


def _of_two(basis: Basis, hull: Array) -> str:
    """A product where, sums of functions of one input taken off, one pair of functions is left."""
    grid = [np.linspace(low, high, GRID) for low, high in zip(hull.min(axis=0), hull.max(axis=0), strict=True)]
    x = np.array([(a, b) for a in grid[0] for b in grid[1]])
    f = _main(curve(basis, x)[0]).reshape(GRID, GRID)
    both = f - f.mean(axis=0) - f.mean(axis=1)[:, None] + f.mean()
    size = np.linalg.svd(both, compute_uv=False) ** 2
    return "a product" if size[0] > NEARLY_ALL * size.sum() else "a map"


def _differs_on_the_way_back(x: Array, left: Array, scene: Scene) -> bool:
    """Whether what remains follows the way that the input moves, more than chance and a detail would."""
    way = np.zeros(len(x))
    for rows in stretches(scene.segment):
        if rows.stop - rows.start > 1:
            way[rows] = np.sign(np.gradient(x[rows]))
    scaled = (x - x.mean()) / max(float(x.std()), 1e-300)
    A = np.column_stack([way, way * scaled, way * scaled**2])
    took = left - (left - A @ np.linalg.lstsq(A, left, rcond=None)[0])
    chance = A.shape[1] / len(x)
    return bool(np.sum(took**2) > (OTHER_WAY + 2 * chance) * np.sum(left**2))


def experiment(run: Run, record: EffectRecord, described: FunctionShape) -> NextExperiment:
    """The one that would show what a term without a name is."""
    name = record.inputs[0]
    channel = name.removeprefix(CHANNEL)
    other = (f"hold the attitude and move {channel} up and down through more than its range, twice", None)
    kind = run.channel(channel).quantity if name.startswith(CHANNEL) else name.partition("_")[0]
    do, procedure = EXPERIMENTS.get(kind, other)
    if len(record.inputs) == 2:
        do = f"hold {record.inputs[1].removeprefix(CHANNEL)} and {do}; then the other way round"
    return NextExperiment(f"the cause has no name yet. {described.says(record.inputs)}".rstrip("."), do, procedure)
