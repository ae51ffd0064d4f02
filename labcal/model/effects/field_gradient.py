"""The device is off the centre: the field there differs from the reference's in proportion to the cage's field.

A constant place off the axis gives Δv = A v with A symmetric and traceless (curl and divergence are zero); a device
off the platform axis moves on a circle, and the difference turns with the angle. Where the sensor sits off the middle
of the device, the circle is another one for each mounting, Δv = |v| G r with r a place fixed in the body.
"""

from __future__ import annotations

import numpy as np

from labcal.model.effects.axis_tilt import TILT_OR_GRADIENT
from labcal.model.effects.protocol import Array, Confounded, Family, Scene, Term
from labcal.model.effects.regressors import AXES
from labcal.record import Run, offers

MOMENT_OR_GRADIENT = Confounded("the device's moment at a near reference", "a gradient", "repeat in two coil fields")
SYMMETRIC = {"xx": (0, 0), "yy": (1, 1), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}


def kernel(term: Term, scene: Scene) -> Array:
    """`a_xy` … an element of A; `cos_x` … along x of C in proportion to |v| and the cosine of the angle.

    `gxy_z` … an element of G times z of the place in the body.
    """
    assert scene.rig is not None
    v, angle = scene.rig.reference_nT, scene.rig.angle_rad
    turning = np.isfinite(angle)
    size = np.linalg.norm(v, axis=1)
    out = np.empty((len(scene), 3, len(term.parameters)))
    for column, (name, _) in enumerate(term.parameters):
        kind, which = name.split("_")
        if kind == "a":
            cage = v @ traceless(which)
        elif kind in ("cos", "sin"):
            wave = np.cos if kind == "cos" else np.sin
            cage = (size * turning * wave(np.nan_to_num(angle)))[:, None] * np.eye(3)[AXES.index(which)]
        else:
            cage = size[:, None] * (scene.rig.to_body[:, AXES.index(which)] @ traceless(kind.removeprefix("g")))
        out[:, :, column] = np.einsum("nij,nj->ni", scene.rig.to_body, cage)
    return out


def traceless(which: str) -> Array:
    """One of the five symmetric and traceless matrices."""
    i, j = SYMMETRIC[which]
    out = np.zeros((3, 3))
    out[i, j] = out[j, i] = 1.0
    return out - np.diag([0, 0, 1.0]) if i == j else out


def candidates(run: Run) -> list[Term]:
    """A constant place off the centre; a circle about the platform axis; both; a place fixed in the body."""
    if not any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments):
        return []
    place = tuple((f"a_{w}", "1") for w in SYMMETRIC)
    circle = tuple((f"{w}_{a}", "1") for w in ("cos", "sin") for a in AXES)
    aboard = tuple((f"g{w}_{a}", "1") for w in SYMMETRIC for a in AXES)
    return [Term(kernel, p) for p in (place, circle, place + circle, aboard)]


FAMILY = Family(
    "field-gradient",
    "rig",
    kernel,
    candidates,
    experiment="move the device by 5 cm and repeat one segment",
    responds={"move device": 2.0},
    confounded=(MOMENT_OR_GRADIENT, TILT_OR_GRADIENT),
    drawn_against="field",
)
