"""A field fixed to the cage that the reference does not see: motor, carriage, table, or the reference's own zero."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from labcal.errors import InputError
from labcal.model.effects import iron
from labcal.model.effects.iron import Names
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import AXES, STEP, mountings, of_the_rig, some_moment
from labcal.model.effects.scene import Rig, Scene
from labcal.model.effects.shape import ZERO, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers
from labcal.record.run import Channel

HARMONICS = (1, 2, 3)  # of the platform angle
MOST_MOUNTINGS = 30  # in which the angle may count from a zero of its own
NAME = re.compile(r"(q)?([a-z]*\d?)_([xyzuvw])")


def kernel(term: Term, scene: Scene) -> Array:
    """E = R (c + Σ_h c_h cos hθ + s_h sin hθ), R into the body, θ the platform angle; `rest_x` … where none is.

    `q_x`, `qcos1_x` … for each unit of a channel, `step_x` … from t_step on. θ counts from `zero_2_rad` in the second
    mounting. `bx_y` along y of C for each unit of the reference along x, `bsx_y` also along x for each along y,
    `bturn_z` the reference turned about z; `t…` of iron that turns with the table (`effects.iron`).
    """
    assert scene.rig is not None
    rig, parts = _from_zero(scene.rig, term), [_part(name) for name, _ in term.parameters]
    turned = iron.table_axes(rig) if any(part.kind.startswith("t") for part in parts) else rig.to_body
    out = np.empty((len(scene), 3, len(parts)))
    for place, part in enumerate(parts):
        if part.kind.startswith("t"):
            out[:, :, place] = iron.column(part.kind, part.along, turned, rig.prediction_nT)
        elif part.kind.startswith("bs"):
            out[:, :, place] = _both_ways(rig, AXES.index(part.kind[-1]), AXES.index(part.along))
        elif part.kind == "bturn":
            turned_nT = np.cross(np.eye(3)[AXES.index(part.along)], rig.reference_nT)
            out[:, :, place] = np.einsum("nij,nj->ni", rig.to_body, turned_nT)
        else:
            out[:, :, place] = rig.to_body[:, :, AXES.index(part.along)] * _drive(part, term, scene.t_s, rig)[:, None]
        if part.driven:
            out[:, :, place] *= term.drive(scene)[:, None]
    return out


def _both_ways(rig: Rig, one: int, other: int) -> Array:
    """Along each of two axes of the cage what the reference along the other drives (n, 3); along one axis once."""
    driven = rig.to_body[:, :, one] * rig.reference_nT[:, [other]]
    return driven if one == other else driven + rig.to_body[:, :, other] * rig.reference_nT[:, [one]]


def _from_zero(rig: Rig, term: Term) -> Rig:
    """The rig with the angle of each mounting counted from its zero."""
    zeros = np.zeros(int(rig.mounting.max(initial=0)) + 1)
    for shape in term.shape:
        if shape.kind is ZERO and (number := int(shape.name.split("_")[1])) <= len(zeros):
            zeros[number - 1] = shape.value
    return replace(rig, angle_rad=rig.angle_rad - zeros[rig.mounting]) if zeros.any() else rig


def _drive(part: _Part, term: Term, t_s: Array, rig: Rig) -> Array:
    """What a field along one axis of the cage goes by (n,), but for a channel."""
    turning = np.isfinite(rig.angle_rad)
    if part.kind == "rest":
        return (~turning).astype(float)
    if part.kind == "step":
        return (t_s >= term.at(STEP.name)).astype(float)
    if part.kind.startswith("b"):
        return rig.reference_nT[:, AXES.index(part.kind[1])]
    if part.kind in ("", "c"):
        return np.ones(len(t_s))
    wave = np.cos if part.kind.startswith("cos") else np.sin
    return np.asarray(wave(int(part.kind[3:]) * np.nan_to_num(rig.angle_rad)) * turning)


@dataclass(frozen=True, slots=True)
class _Part:
    """A parameter's name, taken apart: for each unit of a channel, of what, along which axis."""

    driven: str
    kind: str
    along: str


def _part(name: str) -> _Part:
    found = NAME.fullmatch(name)
    if found is None:
        raise InputError(f"cage-field has no parameter {name}")
    return _Part(*(group or "" for group in found.groups()))


def candidates(run: Run) -> list[Term]:
    """A constant, with harmonics of the angle up to the third; iron that the field magnetises; a channel's; a step.

    Segments at rest do not say at which angle the platform stands: what changes with it is another constant there.
    """
    seen = [s for s in run.segments if offers(run, s) == "vector" and s.reference_frame == "cage"]
    if not seen:
        return []
    rest = _of("rest") if any(s.kind != "rotation" for s in seen) else ()
    of_the_angle = [(*_of("c"), *rest, *_waves(most)) for most in HARMONICS]
    on_table = [(*iron.ON_TABLE, *rest)] if len(mountings(run)) > 1 else []  # else it is the device's own soft iron
    standing = [_of("c"), *of_the_angle, (*_of("c"), *iron.BESIDE), *on_table]
    from_zeros = [Term(kernel, form, shape=zeros) for form in (of_the_angle[-1], *on_table) if (zeros := _zeros(run))]
    of_channels = [term for channel in of_the_rig(run) for term in _with(channel, run, rest)]
    return [*(Term(kernel, form) for form in standing), *from_zeros, *of_channels, _from_a_moment(run)]


def _of(kind: str, unit: str = "nT") -> Names:
    return tuple((f"{kind}_{a}", unit) for a in AXES)


def _waves(most: int, before: str = "", unit: str = "nT", least: int = 1) -> Names:
    """The harmonics of the angle from the `least` to the `most`."""
    kinds = [f"{before}{wave}{h}" for h in range(least, most + 1) for wave in ("cos", "sin")]
    return tuple(name for kind in kinds for name in _of(kind, unit))


def _zeros(run: Run) -> tuple[Shape, ...]:
    """Where the angle counts from in each mounting but the first; none where it means the same in all of them.

    It does where each segment states its attitude at zero.
    """
    turning, numbers = [s for s in run.segments if s.kind == "rotation"], list(mountings(run))
    if all(s.body_from_cage is not None for s in turning) or max(numbers, default=0) > MOST_MOUNTINGS:
        return ()
    return tuple(_zero(number) for number in numbers[1:])


def _zero(number: int) -> Shape:
    return Shape(f"zero_{number}_rad", 0.0, "rad", kind=ZERO)


def _with(channel: Channel, run: Run, rest: Names) -> list[Term]:
    """Zero where the channel is zero: a motor at rest, a current that does not flow.

    A motor's magnets stand or go round with its poles; the field of its windings, and their iron's, is on and off.
    """
    unit = f"nT/{channel.unit}"
    driven, forms = _of("q", unit), [_of("q", unit)]
    found, at = [], ((channel.name,), {channel.name: 0.0})
    if mountings(run):
        on, standing = (*driven, *_waves(HARMONICS[-1], "q", unit)), (*_of("c"), *rest)
        forms += [on, (*standing, *_waves(HARMONICS[-1]), *on)]
        of_poles = [(*standing, *driven, *_waves(h, least=h), *_waves(h, "q", unit, h)) for h in HARMONICS]
        found = [Term(kernel, form, *at, zeros) for form in of_poles if (zeros := _zeros(run))]
    return [*(Term(kernel, form, *at) for form in forms), *found]


def _from_a_moment(run: Run) -> Term:
    """Something large was moved: a lift, a car, a cupboard."""
    return Term(kernel, _of("step"), shape=(some_moment(run),))


def _may_be_missed(chosen: Term, other: Term) -> bool:
    """Iron that turns with the table does not lack iron that stands beside the cage: those are two causes."""
    irons = iron.kinds([name for name, _ in chosen.parameters])
    return not irons or iron.kinds([name for name, _ in other.parameters]) <= irons


def _holds_a_lean(term: Term, beta: Array, covariance: Array) -> tuple[Sequence[Term], str]:
    forms = iron.without_lean(term.parameters, beta, covariance)
    return [replace(term, parameters=form) for form in forms], "axis-tilt"


CAGE_OR_ZERO = Confounded("a constant field of the cage", "a zero error of the reference", "turn the reference by 180°")
IRON_OR_LEAN = Confounded(
    "iron beside the cage",
    "a platform that leans in the cage",
    "take the iron away, or measure how the platform stands",
)
FAMILY = Family(
    "cage-field",
    "rig",
    kernel,
    candidates,
    phrase="something at the cage or the table adds a field",
    shapes=(STEP, *(_zero(number) for number in range(2, MOST_MOUNTINGS + 1))),
    experiment="repeat with the coils at zero, and with the reference turned by 180°",
    responds={"bare platform": 1.0},
    holds_another=_holds_a_lean,
    sums_to_zero=lambda term: iron.diagonal([name for name, _ in term.parameters]),
    confounded=(CAGE_OR_ZERO, IRON_OR_LEAN),
    drawn_against="angle",
    may_be_missed=_may_be_missed,
)
