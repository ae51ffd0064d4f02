"""What an effect is made of: the scene it acts in, its form, its family."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.model.calibration import EffectRecord, Owner
from labcal.model.effects.past import Past
from labcal.record import Run

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Rig:
    """What only a run with a vector reference knows (n rows): needed by effects of the rig, absent in `apply`."""

    prediction_nT: Array  # (n, 3) p, the reference carried into B
    reference_nT: Array  # (n, 3) the reference in C
    to_body: Array  # (n, 3, 3) p = to_body @ reference; NaN where the reference is given in B
    axis_body: Array  # (n, 3) NaN where there is no platform axis
    axis_cage: Array  # (n, 3)
    angle_rad: Array  # (n,) platform angle, unwrapped within a segment; NaN where there is none
    mounting: NDArray[np.intp]  # (n,) rows of one mounting share an unknown phase and tilt


@dataclass(frozen=True, slots=True, eq=False)
class Scene:
    """All that an effect may look at, row by row (n rows, in time order)."""

    t_s: Array  # (n,) the run's clock
    segment: NDArray[np.intp]  # (n,) a change is a boundary for delays, derivatives and hysteresis
    field_nT: Array  # (n, 3) a = K m − k, in B
    channels: Mapping[str, Array] = field(default_factory=dict)  # each (n,), in its unit
    mode: NDArray[np.str_] | None = None  # (n,)
    axes: Array = field(default_factory=lambda: np.eye(3))  # (3, 3) K per nominal unit: column i moves with reading i
    rig: Rig | None = None
    denoised_field_nT: Array | None = None  # (n, 3) a at the estimated true reading, where a fit knows it
    past: Past | None = None  # where the rows are a piece of a recording (`Family.in_pieces`)

    def __len__(self) -> int:
        return len(self.t_s)

    @property
    def along_axes_nT(self) -> Array:
        """The field along the sensor's own axes (n, 3) [nT], so that field = axes @ along_axes."""
        return self.on_axes(self.field_nT)

    @property
    def driving_field_nT(self) -> Array:
        """The field (n, 3) [nT] that drives a curve: without the readings' noise as far as a fit knows it.

        A curve that nearly undoes the map would take that noise off itself.
        """
        return self.field_nT if self.denoised_field_nT is None else self.denoised_field_nT

    def on_axes(self, field_nT: Array) -> Array:
        """A field (n, 3) along the sensor's own axes."""
        return np.asarray(np.linalg.solve(self.axes, field_nT.T).T)

    def moved(self, by_nT: Array | float) -> Scene:
        """The same in a field that is `by_nT` (n, 3) or (3,) larger."""
        quiet = None if self.denoised_field_nT is None else self.denoised_field_nT + by_nT
        return replace(self, field_nT=self.field_nT + by_nT, denoised_field_nT=quiet)

    def select(self, rows: NDArray[Any]) -> Scene:
        """The same scene with only these rows (mask or numbers, in time order)."""
        rig = self.rig and Rig(*(getattr(self.rig, name)[rows] for name in Rig.__slots__))
        return replace(
            self,
            t_s=self.t_s[rows],
            segment=self.segment[rows],
            field_nT=self.field_nT[rows],
            channels={name: values[rows] for name, values in self.channels.items()},
            mode=None if self.mode is None else self.mode[rows],
            rig=rig,
            denoised_field_nT=None if self.denoised_field_nT is None else self.denoised_field_nT[rows],
        )


@dataclass(frozen=True, slots=True)
class Shape:
    """A parameter that does not enter linearly: its value, unit, and the grid that a search starts from."""

    name: str
    value: float
    unit: str
    grid: tuple[float, ...] = ()


Kernel = Callable[["Term", Scene], Array]
SearchStrategy = Literal[
    "grid", "lines", "moments"
]  # at its grid's points, or at the residual's own frequencies or jumps


@dataclass(frozen=True, slots=True)
class Term:
    """One form that an effect can take: `kernel` is all its physics, the linear parameters are left open.

    `kernel(form, scene)` gives the derivative of e by each linear parameter, (n, 3, p) [nT of B per unit].
    """

    kernel: Kernel
    parameters: tuple[tuple[str, str], ...]  # name and unit of each linear parameter, in the order of the columns
    channels: tuple[str, ...] = ()
    reference_value: Mapping[str, float] = field(default_factory=dict)  # where each channel counts as zero
    shape: tuple[Shape, ...] = ()

    def columns(self, scene: Scene) -> Array:
        """The derivative of e by each linear parameter (n, 3, p)."""
        return self.kernel(self, scene)

    def at(self, name: str) -> float:
        """The value of a shape parameter. Raises InputError where the form lacks it."""
        for shape in self.shape:
            if shape.name == name:
                return shape.value
        raise InputError(f"the effect lacks its parameter {name}")

    def with_values(self, **values: float) -> Term:
        """The same form at other shape parameters."""
        return replace(self, shape=tuple(replace(s, value=values.get(s.name, s.value)) for s in self.shape))

    def drive(self, scene: Scene) -> Array:
        """Its first channel, counted from the reference value (n,)."""
        name = self.channels[0]
        return np.asarray(scene.channels[name] - self.reference_value[name])


@dataclass(frozen=True, slots=True)
class Family:
    """All that is known about one effect id: whose it is, the terms it can take, and what would show it."""

    id: str
    belongs_to: Owner
    kernel: Kernel
    candidates: Callable[[Run], Sequence[Term]]  # the forms that this run could show; empty where its needs are not met
    shapes: tuple[str, ...] = ()  # names of the parameters that do not enter linearly
    experiment: str = ""  # what would show it, one sentence
    bound_to_run: bool = False  # holds on the run's own clock only (drift, step, periodic)
    of_field: bool = False  # grows with the field itself: cannot be told from a gain that the run does not determine
    from_vectors: bool = False  # only vectors show it: on magnitudes the noise alone would
    search_strategy: SearchStrategy = (
        "grid"  # where to look; what is read off the residual may come again at another place
    )
    harmonics: bool = False  # what is left of it may be its own overtones
    generic: bool = False  # follows whatever a channel measures: an equivalent cause with a mechanism goes first
    second_order: bool = False  # of higher order than a cause that may be equivalent: that one goes first
    extends: tuple[str, ...] = ()  # families that it reduces to at zero: its own part needs evidence
    related: tuple[str, ...] = ()  # families whose shapes a more general form of it would have
    in_pieces: bool = False  # goes on from `scene.past`, or sees as far as `reach_s` says: a recording may be cut

    def restore(self, record: EffectRecord) -> Term:
        """The form that a calibration file describes."""
        linear = tuple((p.name, p.unit) for p in record.parameters if p.name not in self.shapes)
        shape = tuple(Shape(p.name, p.value, p.unit) for p in record.parameters if p.name in self.shapes)
        return Term(self.kernel, linear, record.channels, dict(record.reference_value), shape)


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """A form with its linear parameters: what `apply` subtracts."""

    family: Family
    term: Term
    beta: Array  # (p,)

    def predict(self, scene: Scene) -> Array:
        """The effect e (n, 3) [nT of B]."""
        return np.asarray(self.term.columns(scene) @ self.beta)
