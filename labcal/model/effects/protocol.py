"""All that is known about an effect: its `Family`, and a form of it with its parameters fitted.

All that fit, loop, `apply`, reports and window have to know of an effect stands in its `Family`; nothing outside
`labcal.model.effects` knows an effect by its id, or a parameter by its name.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects import memory
from labcal.model.effects.c_form import CForm
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import FoundBy, Shape
from labcal.model.effects.term import Kernel, Term
from labcal.model.records import EffectRecord, Owner
from labcal.record import Run

Array = NDArray[np.float64]
DrawnAgainst = Literal["time", "angle", "field"]
Action = Literal[
    "load",  # a load is switched, or the power mode
    "heat",  # the device is warmed and cools
    "bare platform",  # the device is taken off and the reference stands in its place
    "move device",  # by 5 cm
    "turn reference",  # by 180°
    "move reference",  # to twice its distance
]


def no_form(term: Term) -> bool:
    """No form of a family."""
    return False


def of_one_family(chosen: Term, other: Term) -> bool:
    """Any two forms of a family."""
    return True


def no_simpler(term: Term, fitted: Array) -> Term | None:
    """Every form stands for itself."""
    return None


def itself_alone(term: Term, beta: Array, covariance: Array) -> tuple[Sequence[Term], str]:
    """No other cause."""
    return (), ""


def nothing_settled(term: Term, beta: Array, scene: Scene) -> None:
    """A run tells all of its parameters."""


def no_parameters(term: Term) -> Sequence[str]:
    """None of a term's parameters."""
    return ()


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
    the order of time within each segment; without `scene.rig` unless the effect is the rig's; each row from itself
    alone unless `reach_s` says otherwise. `candidates` gives the terms that a run could show, none where the run lacks
    what they need.
    A parameter that does not enter linearly stands in `shapes` with the name and kind that it has in the terms, and has
    a grid there if it is searched.
    """

    id: str
    belongs_to: Owner
    kernel: Kernel
    candidates: Callable[[Run], Sequence[Term]]
    shapes: tuple[Shape, ...] = ()  # the parameters that do not enter linearly; values and grids are the candidates'

    phrase: str = ""  # what happens, for a technician: "the gain changes with temperature"; empty: its id stands for it

    # What the decision has to know
    of_field: bool = False  # grows with the field itself: a gain that the run does not determine looks alike
    follows_reference: bool = False  # a sensor's, driven by the reference where that is a vector, as all of the rig's
    from_vectors: bool = False  # only vectors show it: on magnitudes the noise alone would
    repeats: bool = False  # may act more than once, each time at another moment or frequency
    harmonics: bool = False  # what is left of it may be its own overtones
    adds_up: bool = False  # several channels may act at once: they are scored as a set too
    generic: bool = False  # follows whatever a channel measures: an equivalent cause with a mechanism goes first
    rig_form: Callable[[Term], bool] = no_form  # forms of a sensor's family that are the rig's
    second_order: bool = False  # of higher order than a cause that may be equivalent: that one goes first
    extends: tuple[str, ...] = ()  # families that it reduces to at zero: its own part needs evidence
    related: tuple[str, ...] = ()  # families whose shapes a more general form of it would have
    may_be_missed: Callable[[Term, Term], bool] = of_one_family  # whether the second is what the first may lack of it
    simpler: Callable[[Term, Array], Term | None] = no_simpler  # the smaller form that fitted parameters come to
    holds_another: Callable[[Term, Array, Array], tuple[Sequence[Term], str]] = itself_alone  # by fitted parameters and
    # their covariance: forms that may be left of it, and the family that did the rest, where it cannot have done it all
    sums_to_zero: Callable[[Term], Sequence[str]] = no_parameters  # linear parameters whose sum is, where no run tells
    settled: Callable[[Term, Array, Scene], tuple[Shape, float] | None] = (
        nothing_settled  # by fitted parameters: one of
    )
    # the rig's that changes only what the map takes, with its u
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
    unsure: Callable[[Term, Scene], Array] | None = None  # how far its columns (n, 3, p) may be off by themselves
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

    def plainly(self) -> str:
        """What happens, in plain words; its id where its author has given none."""
        return self.phrase or self.id

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
