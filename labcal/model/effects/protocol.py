"""What an effect is made of: the scene it acts in, its form, its family.

All that fit, loop, `apply`, reports and window have to know of an effect stands in its `Family`; nothing outside
`labcal.model.effects` knows an effect by its id, or a parameter by its name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.model.calibration import EffectRecord, Owner
from labcal.model.effects import memory
from labcal.model.effects.c_form import CForm
from labcal.model.effects.past import Past
from labcal.model.effects.shape import FoundBy, Kind, Shape
from labcal.model.smooth import Basis
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
        """The driving field along the sensor's own axes (n, 3) [nT], so that field = axes @ along_axes."""
        return self.on_axes(self.driving_field_nT)

    @property
    def driving_field_nT(self) -> Array:
        """The field (n, 3) [nT] that drives an effect: without the readings' noise as far as a fit knows it.

        A curve that nearly undoes the map would take that noise off itself, and so would a gain that hardly changes.
        """
        return self.field_nT if self.denoised_field_nT is None else self.denoised_field_nT

    def on_axes(self, field_nT: Array) -> Array:
        """A field (n, 3) along the sensor's own axes."""
        return np.asarray(np.linalg.solve(self.axes, field_nT.T).T)

    def moved(self, by_nT: Array | float) -> Scene:
        """The same in a field that is `by_nT` (n, 3) or (3,) larger."""
        denoised = None if self.denoised_field_nT is None else self.denoised_field_nT + by_nT
        return replace(self, field_nT=self.field_nT + by_nT, denoised_field_nT=denoised)

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


Kernel = Callable[["Term", Scene], Array]
SMALLEST = 1e-6  # values of secants that count as zero
DrawnAgainst = Literal["time", "angle", "field"]
Action = Literal[
    "load",  # a load is switched, or the power mode
    "heat",  # the device is warmed and cools
    "bare platform",  # the device is taken off and the reference stands in its place
    "move device",  # by 5 cm
    "turn reference",  # by 180°
    "move reference",  # to twice its distance
]


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
    inputs: tuple[str, ...] = ()  # of a smooth function (`effects.inputs`)
    basis: Basis | None = None  # of the same

    def columns(self, scene: Scene) -> Array:
        """The derivative of e by each linear parameter (n, 3, p)."""
        return self.kernel(self, scene)

    def at(self, name: str) -> float:
        """The value of a shape parameter. Raises InputError where the form lacks it."""
        for shape in self.shape:
            if shape.name == name:
                return shape.value
        raise InputError(f"the effect lacks its parameter {name}")

    def of(self, kind: Kind) -> Shape | None:
        """Its first shape parameter of this kind; None where it has none."""
        return next((shape for shape in self.shape if shape.kind is kind), None)

    def found_by(self, search: FoundBy) -> Shape | None:
        """Its first shape parameter that this search finds; None where it has none."""
        return next((shape for shape in self.shape if shape.kind.found_by == search), None)

    def with_values(self, **values: float) -> Term:
        """The same form at other shape parameters."""
        return replace(self, shape=tuple(replace(s, value=values.get(s.name, s.value)) for s in self.shape))

    def with_shape(self, at: Shape) -> Term:
        """The same form with the shape parameter of this name as it is here."""
        return replace(self, shape=tuple(at if s.name == at.name else s for s in self.shape))

    def own_secants(self) -> list[Shape]:
        """The intervals that secants are taken over: each is the value of the linear parameter in its place."""
        return [shape for shape in self.shape if shape.kind.found_by == "own secant"]

    def over_own_secants(self, values: Array) -> Term:
        """The same form with its secants taken over these values of its linear parameters; over none that vanish."""
        secants = self.own_secants()
        if not any(abs(value) > SMALLEST for value in values[: len(secants)]):
            return self
        return self.with_values(**{s.name: float(v) for s, v in zip(secants, values, strict=False)})

    def stepped(self) -> Term:
        """The same form as it is after its moment: the step came before the run began."""
        moment = self.found_by("changepoints")
        return replace(self, shape=tuple(replace(s, value=-np.inf) if s is moment else s for s in self.shape))

    def drive(self, scene: Scene) -> Array:
        """Its first channel, counted from the reference value (n,)."""
        name = self.channels[0]
        return np.asarray(scene.channels[name] - self.reference_value[name])

    def ends_of_drive(self, scene: Scene) -> tuple[float, float] | None:
        """Between which values the drive has been seen; None where nothing says so."""
        ends = None if scene.past is None else scene.past.ends.get(name := self.channels[0])
        if ends is None:
            return None
        low, high = (end - self.reference_value[name] for end in ends)
        return low, high


def no_form(term: Term) -> bool:
    """No form of a family."""
    return False


@dataclass(frozen=True, slots=True)
class Confounded:
    """Two explanations of one run that no fit can separate, and what does."""

    one: str
    other: str
    separated_by: str


@dataclass(frozen=True, slots=True)
class Family:
    """All that is known about one effect id: what its author has to give. The first four, and `experiment`, suffice.

    `kernel` must give finite columns (n, 3, p) wherever the field and the term's channels are finite, for any rows in
    the order of time; without `scene.rig` unless the effect is the rig's; each row from itself alone unless `reach_s`
    says otherwise. `candidates` gives the terms that a run could show, none where the run lacks what they need.
    A parameter that does not enter linearly stands in `shapes` with the name and kind that it has in the terms, and has
    a grid there if it is searched.
    """

    id: str
    belongs_to: Owner
    kernel: Kernel
    candidates: Callable[[Run], Sequence[Term]]
    shapes: tuple[Shape, ...] = ()  # the parameters that do not enter linearly; values and grids are the candidates'

    # What the decision has to know
    of_field: bool = False  # grows with the field itself: cannot be told from a gain that the run does not determine
    follows_reference: bool = False  # a sensor's, driven by the reference where that is a vector, as all of the rig's
    from_vectors: bool = False  # only vectors show it: on magnitudes the noise alone would
    repeats: bool = False  # may act more than once, each time at another moment or frequency
    harmonics: bool = False  # what is left of it may be its own overtones
    adds_up: bool = False  # several channels may act at once: they are weighed as a set too
    generic: bool = False  # follows whatever a channel measures: an equivalent cause with a mechanism goes first
    rig_form: Callable[[Term], bool] = no_form  # forms of a sensor's family that are the rig's
    second_order: bool = False  # of higher order than a cause that may be equivalent: that one goes first
    extends: tuple[str, ...] = ()  # families that it reduces to at zero: its own part needs evidence
    related: tuple[str, ...] = ()  # families whose shapes a more general form of it would have
    time_constants: Callable[[Term], Sequence[float]] = memory.time_constants  # of its responses [s]: each settles

    # What separates it from others
    experiment: str = ""  # what would show it, one sentence
    responds: Mapping[Action, float] = field(default_factory=dict)  # the factor it changes by; 1: driven, still there
    confounded: tuple[Confounded, ...] = ()  # what one run never tells it from

    # What `apply` has to know of a sensor's effect; moments, delays and secants flag the rows beside them by themselves
    bound_to_run: bool = False  # holds on the run's own clock only (drift, step, periodic)
    bound_form: Callable[[Term], bool] = no_form  # forms bound to the run where others are not
    of_temperature: bool = False  # its channel is the temperature that a calibration's range speaks of
    modes: Callable[[Term], Sequence[str]] | None = None  # the power modes that it has parameters of
    reach_s: Callable[[Term], float | None] = memory.reach_s  # how far it looks; None: at the row itself alone
    secant_s: Callable[[Term, Array], Array] = memory.secant_s  # how far ahead each row looks, of rows at t_s (n,)
    in_pieces: bool = False  # goes on from `scene.past`, or sees as far as `reach_s` says: a recording may be cut

    # How it flies
    in_c: Callable[[Term], CForm] | None = None  # in C99; without it a calibration that ships it has no C

    # How it is drawn
    drawn_against: DrawnAgainst = "time"  # where it has no channel

    def is_bound_to_run(self, term: Term) -> bool:
        """Whether this form of it holds on the run's own clock only."""
        return self.bound_to_run or self.bound_form(term)

    def owner(self, term: Term) -> Owner:
        """Whose this form of it is."""
        return "rig" if self.rig_form(term) else self.belongs_to

    def found_by(self, search: FoundBy) -> bool:
        """Whether this search finds one of its parameters."""
        return any(shape.kind.found_by == search for shape in self.shapes)

    def restore(self, record: EffectRecord) -> Term:
        """The form that a calibration file describes."""
        kinds = {shape.name: shape.kind for shape in self.shapes}
        linear = tuple((p.name, p.unit) for p in record.parameters if p.name not in kinds)
        shape = tuple(Shape(p.name, p.value, p.unit, kind=kinds[p.name]) for p in record.parameters if p.name in kinds)
        at = dict(record.reference_value)
        return Term(self.kernel, linear, record.channels, at, shape, record.inputs, record.basis)


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """A form with its linear parameters: what `apply` subtracts."""

    family: Family
    term: Term
    beta: Array  # (p,)

    def predict(self, scene: Scene) -> Array:
        """The effect e (n, 3) [nT of B]."""
        return np.asarray(self.term.columns(scene) @ self.beta)
