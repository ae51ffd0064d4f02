"""The reference follows the temperature of the room: its zero, and its scale, one for all axes or one for each."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.following import BEHIND
from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import AXES, low_passed, middle, per_axis, weather_of_the_room
from labcal.record import Run, offers
from labcal.record.run import Channel

TAU_S = (30.0, 100.0, 300.0, 1000.0)  # of a reference in its housing, behind the room
REFERENCE_OR_DEVICE = Confounded(
    "a reference that follows the room", "a sensor that follows the same temperature", "warm the device alone"
)


def kernel(term: Term, scene: Scene) -> Array:
    """E = R (c + g v) (T − T_ref), v the reference in the cage and R into the body; T behind by tau_s where that is.

    `c_x` … in nT, `g` common to the axes or `g_x` … of each: by how much the field is larger than the reference tells.
    """
    assert scene.rig is not None
    tau_s = term.at(BEHIND.name) if term.shape else 0.0
    warm = low_passed(scene.t_s, scene.segment, term.drive(scene), tau_s, scene.past)[:, None]
    to_body, v = scene.rig.to_body, scene.rig.reference_nT
    parts = [to_body * warm[:, :, None]]
    if any(name == "g" for name, _ in term.parameters):
        parts.append((scene.rig.prediction_nT * warm)[:, :, None])
    elif len(term.parameters) > len(AXES):
        parts.append(to_body * (v * warm)[:, None, :])
    return np.concatenate(parts, axis=2)


def candidates(run: Run) -> list[Term]:
    """Each temperature of the room that moves: zero alone, with one scale, with one for each axis, and behind."""
    if not any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments):
        return []
    return [term for channel in weather_of_the_room(run) for term in _of(channel)]


def _of(channel: Channel) -> list[Term]:
    zero, unit = per_axis("c", f"nT/{channel.unit}"), f"1/{channel.unit}"
    common, each = (*zero, ("g", unit)), (*zero, *per_axis("g", unit))
    tau = (replace(BEHIND, grid=TAU_S),)
    forms = ((zero, ()), (common, ()), (common, tau), (each, ()))
    return [Term(kernel, p, (channel.name,), {channel.name: middle(channel)}, shape) for p, shape in forms]


FAMILY = Family(
    "reference-temperature",
    "rig",
    kernel,
    candidates,
    shapes=(BEHIND,),
    of_field=True,
    experiment="warm the room with the device kept as it is, and compare the reference with a second one",
    responds={"bare platform": 1.0},
    confounded=(REFERENCE_OR_DEVICE,),
)
