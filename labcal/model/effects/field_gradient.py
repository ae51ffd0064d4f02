"""The device is off the centre: the field there differs from the reference's in proportion to the cage's field.

A constant place off the axis gives Δv = A v with A symmetric and traceless (curl and divergence are zero); a device
off the platform axis moves on a circle, and the difference turns with the angle. Where the sensor sits off the middle
of the device, the circle is another one for each mounting, Δv = |v| G r with r a place fixed in the body.

Coils of a finite size that are not alike give each their own difference (`effects.coil_pairs`), in proportion to their
current where it is recorded, else to the field along their axis: at a place that turns with the body, and lies
`over_centre` along the platform's axis, or at one that is fixed in the cage. The unit of length is left open. Of pairs
that are no rotation bodies, or askew, the difference at a place fixed in the cage is any vector for each: iron in the
cage, which the ambient field magnetises too, adds a constant field to that.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from labcal.model.effects.axis_tilt import TILT_OR_GRADIENT
from labcal.model.effects.coil_pairs import zonal
from labcal.model.effects.protocol import Array, Confounded, Family
from labcal.model.effects.regressors import AXES, coils, per_axis
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import ANGLE, LEVEL, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers

MOMENT_OR_GRADIENT = Confounded("the device's moment at a near reference", "a gradient", "repeat in two coil fields")
LON_deg, LAT_deg = (0.0, 60.0, 120.0, 180.0, 240.0, 300.0), (20.0, 65.0)  # the opposite place differs in signs alone
ABOVE = (-0.6, 0.0, 0.6)  # times the distance in the body
LON, LAT = Shape("lon_deg", 0.0, "deg", LON_deg, ANGLE), Shape("lat_deg", 0.0, "deg", LAT_deg, ANGLE)
HIGH = Shape("over_centre", 0.0, "1", ABOVE, LEVEL)
FINE_LON = replace(LON, grid=tuple(30.0 * k for k in range(12)))  # the fifth harmonic changes fast with the place
FINE_LAT = replace(LAT, grid=(10.0, 40.0, 70.0))
SYMMETRIC = {"xx": (0, 0), "yy": (1, 1), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}


def kernel(term: Term, scene: Scene) -> Array:
    """`a_xy` … an element of A; `cos_x` … along x of C in proportion to |v| and the cosine of the angle.

    `gxy_z` … an element of G times z of the place in the body.
    """
    assert scene.rig is not None
    if term.shape:
        return _unlike_coils(term, scene)
    if term.channels:
        return _each_coil(term, scene)
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


def _unlike_coils(term: Term, scene: Scene) -> Array:
    """`turning2_1` … the first pair's second zonal harmonic, at a place in the body; `standing2_1` … in the cage."""
    assert scene.rig is not None
    rig, pairs = scene.rig, _pairs(term, scene)
    lon, lat = np.radians([term.at("lon_deg"), term.at("lat_deg")])
    place = np.tile([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)], (len(scene), 1))
    if term.parameters[0][0].startswith("turning"):
        place = np.einsum("nji,nj->ni", rig.to_body, place) + term.at("over_centre") * np.nan_to_num(rig.axis_cage)
    cage = np.empty((len(scene), 3, len(term.parameters)))
    for column, (name, _) in enumerate(term.parameters):
        kind, number = name.split("_")
        drive, axis = pairs[int(number) - 1]
        cage[:, :, column] = drive[:, None] * zonal(int(kind[-1]), place, axis)
    return np.asarray(rig.to_body @ cage)


def _each_coil(term: Term, scene: Scene) -> Array:
    """`coil1_x` … along x of C for each unit of the first pair's field."""
    assert scene.rig is not None
    pairs, axes = _pairs(term, scene), scene.rig.to_body
    each = ((pairs[int(name[4:-2]) - 1][0], AXES.index(name[-1])) for name, _ in term.parameters)
    return np.stack([drive[:, None] * axes[:, :, along] for drive, along in each], axis=2)


def _pairs(term: Term, scene: Scene) -> list[tuple[Array, Array]]:
    """The field in the centre of each pair of coils (n,) [nT] and its direction (3,), from their currents if known."""
    assert scene.rig is not None
    v = scene.rig.reference_nT
    if not term.channels:
        return [(v[:, k], np.eye(3)[k]) for k in range(3)]
    currents = np.column_stack([scene.channels[name] for name in term.channels])
    known = np.isfinite(currents).all(axis=1) & np.isfinite(v).all(axis=1)
    beside = np.column_stack([currents, np.ones(len(scene)), scene.t_s])  # the ambient field wanders
    per_ampere = np.linalg.lstsq(beside[known], v[known], rcond=None)[0][: len(term.channels)]
    sizes = np.linalg.norm(per_ampere, axis=1)
    return [(i * size, b / size) for i, size, b in zip(currents.T, sizes, per_ampere, strict=True)]


def traceless(which: str) -> Array:
    """One of the five symmetric and traceless matrices."""
    i, j = SYMMETRIC[which]
    out = np.zeros((3, 3))
    out[i, j] = out[j, i] = 1.0
    return out - np.diag([0, 0, 1.0]) if i == j else out


def candidates(run: Run) -> list[Term]:
    """A constant place off the centre; a circle about the platform axis; both; a place in the body; coils unlike."""
    if not any(offers(run, s) == "vector" and s.reference_frame == "cage" for s in run.segments):
        return []
    place = tuple((f"a_{w}", "1") for w in SYMMETRIC)
    circle = tuple((f"{w}_{a}", "1") for w in ("cos", "sin") for a in AXES)
    aboard = tuple((f"g{w}_{a}", "1") for w in SYMMETRIC for a in AXES)
    alike = [Term(kernel, p) for p in (place, circle, place + circle, aboard)]
    return alike + _of_pairs(tuple(c.name for c in coils(run)))


def _of_pairs(names: tuple[str, ...]) -> list[Term]:
    """Rotation bodies, at a place that turns with the body or stands in the cage; any vector for each known current."""
    count, zero = len(names) or len(AXES), dict.fromkeys(names, 0.0)
    forms = (
        ("turning", (2,), (LON, LAT, HIGH)),
        ("turning", (2, 3, 5), (FINE_LON, FINE_LAT, HIGH)),
        ("standing", (2,), (LON, LAT)),
        ("standing", (2, 3), (LON, LAT)),
    )
    found = []
    for kind, orders, shape in forms:
        parameters = tuple((f"{kind}{order}_{k + 1}", "1") for order in orders for k in range(count))
        found.append(Term(kernel, parameters, names, zero, shape))
    askew = tuple(p for k in range(len(names)) for p in per_axis(f"coil{k + 1}", "1"))
    return [*found, Term(kernel, askew, names, zero)] if names else found


FAMILY = Family(
    "field-gradient",
    "rig",
    kernel,
    candidates,
    phrase="the DUT is off the cage's centre",
    shapes=(LON, LAT, HIGH),
    experiment="move the device by 5 cm and repeat one segment",
    responds={"move device": 2.0},
    confounded=(MOMENT_OR_GRADIENT, TILT_OR_GRADIENT),
    drawn_against="field",
)
