"""A field fixed to the cage that the reference does not see: motor, carriage, table, or the reference's own zero."""

from __future__ import annotations

import numpy as np

from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import AXES, STEP, of_the_rig, some_moment
from labcal.record import Run, offers
from labcal.record.run import Channel


def kernel(term: Term, scene: Scene) -> Array:
    """E = R (c + Σ_h c_h cos hθ + s_h sin hθ), R into the body, θ the platform angle; `rest_x` … where none is.

    `q_x` … for each unit of a channel, `step_x` … from t_step on.
    """
    assert scene.rig is not None
    angle = np.nan_to_num(scene.rig.angle_rad)
    turning = np.isfinite(scene.rig.angle_rad)
    out = np.empty((len(scene), 3, len(term.parameters)))
    for column, (name, _) in enumerate(term.parameters):
        kind, axis = name.split("_")
        drive = np.ones(len(scene))
        if kind == "rest":
            drive = (~turning).astype(float)
        elif kind == "q":
            drive = term.drive(scene)
        elif kind == "step":
            drive = (scene.t_s >= term.at(STEP.name)).astype(float)
        elif kind != "c":
            wave = np.cos if kind.startswith("cos") else np.sin
            drive = wave(int(kind[3:]) * angle) * turning
        out[:, :, column] = scene.rig.to_body[:, :, AXES.index(axis)] * drive[:, None]
    return out


def candidates(run: Run) -> list[Term]:
    """A constant; one that changes with the angle, up to the second harmonic; with the platform or the room; a step.

    Segments at rest do not say at which angle the platform stands: what changes with it is another constant there.
    """
    seen = [s for s in run.segments if offers(run, s) == "vector" and s.reference_frame == "cage"]
    if not seen:
        return []
    rest = ("rest",) if any(s.kind != "rotation" for s in seen) else ()
    sets = (("c",), ("c", *rest, "cos1", "sin1"), ("c", *rest, "cos1", "sin1", "cos2", "sin2"))
    standing = [Term(kernel, tuple((f"{k}_{a}", "nT") for k in kinds for a in AXES)) for kinds in sets]
    return [*standing, *map(_with, of_the_rig(run)), _from_a_moment(run)]


def _with(channel: Channel) -> Term:
    """Zero where the channel is zero: a motor at rest, a current that does not flow."""
    parameters = tuple((f"q_{a}", f"nT/{channel.unit}") for a in AXES)
    return Term(kernel, parameters, (channel.name,), {channel.name: 0.0})


def _from_a_moment(run: Run) -> Term:
    """Something large was moved: a lift, a car, a cupboard."""
    return Term(kernel, tuple((f"step_{a}", "nT") for a in AXES), shape=(some_moment(run),))


CAGE_OR_ZERO = Confounded("a constant field of the cage", "a zero error of the reference", "turn the reference by 180°")
FAMILY = Family(
    "cage-field",
    "rig",
    kernel,
    candidates,
    shapes=(STEP,),
    experiment="repeat with the coils at zero, and with the reference turned by 180°",
    responds={"bare platform": 1.0},
    confounded=(CAGE_OR_ZERO,),
    drawn_against="angle",
)
