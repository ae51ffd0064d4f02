"""The reference follows the temperature of the room: its zero, and its scale, one for all axes or one for each."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.following import BEHIND
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import low_passed, middle, per_axis, room_temperatures
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import GIVEN, LEVEL, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers
from labcal.record.run import Channel

RIGHT = Shape("right_at", 0.0, "degC", kind=LEVEL)
SCALE_RIGHT = Shape("scale_right_at", 0.0, "degC", kind=GIVEN)  # where the zero has a level of its own
REACH = np.linspace(-1.0, 2.0, 7)  # of the channel's range, counted from its least: where the reference may be right
TAU_S = (30.0, 100.0, 300.0, 1000.0)  # of a reference in its housing, behind the room
REFERENCE_OR_DEVICE = Confounded(
    "a reference that follows the room", "a sensor that follows the same temperature", "warm the device alone"
)


def kernel(term: Term, scene: Scene) -> Array:
    """E = R (c + g v) (T − T_ref) + R o, v the reference in the cage and R into the body; T behind by tau_s if at all.

    `c_x` … in nT, `g` common to the axes or `g_x` … of each: by how much the field is larger than the reference tells.
    Where it is right, zero and scale alike, at the temperature `right_at`, that stands for T_ref: what the scale is at
    T_ref no fit could tell from the device's own. `o_x` … where the zero is not right at T_ref, whatever the axis; the
    scale is then right at `scale_right_at`.
    """
    assert scene.rig is not None
    tau_s = term.at(BEHIND.name) if _has(term, BEHIND) else 0.0
    warm = low_passed(scene.t_s, scene.segment, term.drive(scene), tau_s, scene.past)[:, None]
    zero, scale = (warm - _right_at(term, shapes) for shapes in ((RIGHT,), (RIGHT, SCALE_RIGHT)))
    to_body, v = scene.rig.to_body, scene.rig.reference_nT
    names, parts = {name for name, _ in term.parameters}, [to_body * zero[:, :, None]]
    if "o_x" in names:
        parts.append(to_body)
    if "g" in names:
        parts.append((scene.rig.prediction_nT * scale)[:, :, None])
    elif "g_x" in names:
        parts.append(to_body * (v * scale)[:, None, :])
    return np.concatenate(parts, axis=2)


def _has(term: Term, shape: Shape) -> bool:
    return any(own.name == shape.name for own in term.shape)


def _right_at(term: Term, shapes: tuple[Shape, ...]) -> float:
    """How far above T_ref the first of these is that the term has; 0.0 where it has none."""
    own = (term.at(shape.name) for shape in shapes if _has(term, shape))
    return next((at - term.reference_value[term.channels[0]] for at in own), 0.0)


def candidates(run: Run) -> list[Term]:
    """Each temperature of the room that moves: zero alone, with one scale, with one for each axis, and behind.

    Each also right at another temperature than T_ref: what that leaves of the zero stands still in the cage.
    """
    if not any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments):
        return []
    return [term for channel in room_temperatures(run) for term in _of(channel)]


def simpler(term: Term, fitted: Array) -> Term | None:
    """The form that is right at one temperature: where (c, o) come nearest to c (T − right_at)."""
    names = [name for name, _ in term.parameters]
    if "o_x" not in names or "g" not in names or _has(term, BEHIND):
        return None
    c, o = _zero(term, fitted)
    [channel] = term.channels
    right_at = term.reference_value[channel] - float(c @ o) / max(float(c @ c), 1e-300)
    unit = dict(term.parameters)["g"]
    return replace(
        term,
        parameters=tuple(one for one in term.parameters if not one[0].startswith("o_")),
        shape=(replace(RIGHT, unit=unit.removeprefix("1/"), value=right_at, grid=(right_at,)),),
    )


def settled(term: Term, fitted: Array, scene: Scene) -> tuple[Shape, float] | None:
    """Where the scale is right is where the zeros of the axes are, as nearly as those agree.

    Before the zeros are known it may be anywhere within `REACH` of the run's temperatures, each as likely.
    """
    if not _has(term, SCALE_RIGHT):
        return None
    c, o = _zero(term, fitted)
    squares, T = max(float(c @ c), 1e-300), term.drive(scene)
    above = -float(c @ o) / squares
    apart = o + c * above
    by_zeros = 2 * squares / max(float(apart @ apart), 1e-300)
    before = 12 / max(float(np.ptp(REACH)) * float(np.ptp(T)), 1e-300) ** 2
    known = by_zeros + before
    at = term.reference_value[term.channels[0]] + (by_zeros * above + before * float(np.mean(T))) / known
    own = next(shape for shape in term.shape if shape.name == SCALE_RIGHT.name)
    return replace(own, value=at), float(known**-0.5)


def _zero(term: Term, fitted: Array) -> tuple[Array, Array]:
    """How the zero follows (3,), and what it is at T_ref (3,)."""
    names = [name for name, _ in term.parameters]
    c, o = (np.array([fitted[names.index(f"{name}_{axis}")] for axis in "xyz"]) for name in "co")
    return c, o


def _of(channel: Channel) -> list[Term]:
    zero, unit = per_axis("c", f"nT/{channel.unit}"), f"1/{channel.unit}"
    elsewhere, common, each = per_axis("o", "nT"), (("g", unit),), per_axis("g", unit)
    tau, least, most = replace(BEHIND, grid=TAU_S), float(np.nanmin(channel.values)), float(np.nanmax(channel.values))
    right = replace(RIGHT, unit=channel.unit, grid=tuple((least + REACH * (most - least)).tolist()))
    forms: list[tuple[tuple[tuple[str, str], ...], tuple[Shape, ...]]]
    forms = [(zero, ()), ((*zero, *elsewhere), ())]
    forms += [((*zero, *scale), shape) for scale in (common, each) for shape in ((), (right,))]
    level = replace(SCALE_RIGHT, unit=channel.unit, value=middle(channel))
    forms += [((*zero, *elsewhere, *common), (level,)), ((*zero, *common), (tau,))]
    forms += [((*zero, *elsewhere, *common), (tau, level))]
    return [Term(kernel, p, (channel.name,), {channel.name: middle(channel)}, shape) for p, shape in forms]


FAMILY = Family(
    "reference-temperature",
    "rig",
    kernel,
    candidates,
    phrase="the reference changes with temperature",
    shapes=(BEHIND, RIGHT, SCALE_RIGHT),
    extends=("cage-field",),
    of_field=True,
    simpler=simpler,
    settled=settled,
    experiment="warm the room with the device kept as it is, and compare the reference with a second one",
    responds={"bare platform": 1.0},
    confounded=(REFERENCE_OR_DEVICE,),
)
