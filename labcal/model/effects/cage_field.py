"""A field fixed to the cage that the reference does not see: motor, carriage, table, or the reference's own zero."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

from labcal.errors import InputError
from labcal.model.effects import iron
from labcal.model.effects.iron import Names
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import AXES, STEP, mountings, of_the_rig, some_moment
from labcal.model.effects.scene import Scene
from labcal.model.effects.term import Term
from labcal.record import Run, offers
from labcal.record.run import Channel

HARMONICS = (1, 2, 3)  # of the platform angle
NAME = re.compile(r"(?:m(\d+))?(q)?([a-z]*\d?)_([xyzuvw])")


def kernel(term: Term, scene: Scene) -> Array:
    """E = R (c + Σ_h c_h cos hθ + s_h sin hθ), R into the body, θ the platform angle; `rest_x` … where none is.

    `q_x`, `qcos1_x` … for each unit of a channel, `step_x` … from t_step on, `m2cos1_x` … in the second mounting alone.
    `bx_y` along y of C for each unit of the reference along x; `t…` of iron that turns with the table (`effects.iron`).
    """
    assert scene.rig is not None
    rig, parts = scene.rig, [_part(name) for name, _ in term.parameters]
    turned = iron.table_axes(rig) if any(part.kind.startswith("t") for part in parts) else rig.to_body
    out = np.empty((len(scene), 3, len(parts)))
    for place, part in enumerate(parts):
        if part.kind.startswith("t"):
            out[:, :, place] = iron.column(part.kind, part.along, turned, rig.prediction_nT)
        else:
            out[:, :, place] = rig.to_body[:, :, AXES.index(part.along)] * _drive(part, term, scene)[:, None]
        if part.mounting:
            out[rig.mounting + 1 != int(part.mounting), :, place] = 0.0
        if part.driven:
            out[:, :, place] *= term.drive(scene)[:, None]
    return out


def _drive(part: _Part, term: Term, scene: Scene) -> Array:
    """What a field along one axis of the cage goes by (n,), but for a channel and a mounting."""
    assert scene.rig is not None
    turning = np.isfinite(scene.rig.angle_rad)
    if part.kind == "rest":
        return (~turning).astype(float)
    if part.kind == "step":
        return (scene.t_s >= term.at(STEP.name)).astype(float)
    if part.kind.startswith("b"):
        return scene.rig.reference_nT[:, AXES.index(part.kind[1])]
    if part.kind in ("", "c"):
        return np.ones(len(scene))
    wave = np.cos if part.kind.startswith("cos") else np.sin
    return np.asarray(wave(int(part.kind[3:]) * np.nan_to_num(scene.rig.angle_rad)) * turning)


@dataclass(frozen=True, slots=True)
class _Part:
    """A parameter's name, taken apart: in one mounting alone, for each unit of a channel, of what, along which axis."""

    mounting: str
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
    standing = [_of("c"), *of_the_angle, (*_of("c"), *iron.BESIDE), *(form + rest for form in _on_table(run))]
    of_channels = [term for channel in of_the_rig(run) for term in _with(channel, run, rest)]
    return [*(Term(kernel, form) for form in standing), *of_channels, _from_a_moment(run)]


def _of(kind: str, unit: str = "nT") -> Names:
    return tuple((f"{kind}_{a}", unit) for a in AXES)


def _waves(most: int, before: str = "", unit: str = "nT", least: int = 1) -> Names:
    """The harmonics of the angle from the `least` to the `most`."""
    kinds = [f"{before}{wave}{h}" for h in range(least, most + 1) for wave in ("cos", "sin")]
    return tuple(name for kind in kinds for name in _of(kind, unit))


def _on_table(run: Run) -> list[Names]:
    """Iron on the table, where mountings tell it from the device's own soft iron, the platform's zero being one."""
    return [iron.ON_TABLE] if len(mountings(run)) > 1 else []


def _one_zero(run: Run) -> bool:
    """Whether an angle means the same in all segments: each states its attitude at zero, or all share one mounting."""
    turning = [s for s in run.segments if s.kind == "rotation"]
    return all(s.body_from_cage is not None for s in turning) or len(mountings(run)) < 2


def _with(channel: Channel, run: Run, rest: Names) -> list[Term]:
    """Zero where the channel is zero: a motor at rest, a current that does not flow.

    A motor's magnets stand or go round with its poles; the field of its windings, and their iron's, is on and off.
    """
    unit = f"nT/{channel.unit}"
    driven, forms = _of("q", unit), [_of("q", unit)]
    if mountings(run):
        on = (*driven, *_waves(HARMONICS[-1], "q", unit))
        forms += [on, (*_of("c"), *rest, *_waves(HARMONICS[-1]), *on)]
    if mountings(run) and not _one_zero(run):
        for h in HARMONICS:
            each = [(f"m{n}", f"m{n}q") for n in mountings(run)]
            turned = tuple(p for m, q in each for p in (*_waves(h, m, least=h), *_waves(h, q, unit, h)))
            forms.append((*_of("c"), *rest, *driven, *turned))
    return [Term(kernel, form, (channel.name,), {channel.name: 0.0}) for form in forms]


def _from_a_moment(run: Run) -> Term:
    """Something large was moved: a lift, a car, a cupboard."""
    return Term(kernel, _of("step"), shape=(some_moment(run),))


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
    shapes=(STEP,),
    experiment="repeat with the coils at zero, and with the reference turned by 180°",
    responds={"bare platform": 1.0},
    confounded=(CAGE_OR_ZERO, IRON_OR_LEAN),
    drawn_against="angle",
)
