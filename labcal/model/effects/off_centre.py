"""The field of finite coil pairs away from their centre, as harmonics in the place: linear up to the fourth degree.

About the centre a field without sources is the gradient of solid harmonics r^l Y_l (Jackson, 3.33). A pair that is
what it should be has none but those of its own axis, of fourth degree first (Helmholtz); a wrong spacing adds its
second degree, coils that are unlike the third, whatever is askew the linear one; four corners add cos 4φ. Each coil's
goes with its own field, the surroundings' with nothing. The device turns, and the place with it: it is fixed in the
body, but for its height along the platform axis, and known in direction only; the coefficients hold its distance.
"""

from __future__ import annotations

import re
from functools import lru_cache

import numpy as np

from labcal.model.effects.iron import Names
from labcal.model.effects.protocol import Array, Rig
from labcal.model.effects.regressors import AXES
from labcal.model.effects.shape import PLACE, Shape

SYMMETRIC = {"xx": (0, 0), "yy": (1, 1), "xy": (0, 1), "xz": (0, 2), "yz": (1, 2)}
SURROUNDINGS = "o"  # whatever the coils do
DRIVES = (*AXES, SURROUNDINGS)
NAME = re.compile(r"([xyzo])([1-4]s?)_([xyz]+)")
LON = Shape("place_lon_deg", 0.0, "deg", tuple(range(0, 360, 45)), PLACE)
LAT = Shape("place_lat_deg", 0.0, "deg", (12.0, 40.0, 70.0), PLACE)  # half the sphere: the other half has other signs
UP = Shape("place_up_deg", 0.0, "deg", (-30.0, 0.0, 30.0), PLACE)
PLACES = (LON, LAT, UP)


def traceless(which: str) -> Array:
    """One of the five symmetric and traceless matrices."""
    i, j = SYMMETRIC[which]
    out = np.zeros((3, 3))
    out[i, j] = out[j, i] = 1.0
    return out - np.diag([0, 0, 1.0]) if i == j else out


def _harmonics(degrees: tuple[str, ...]) -> Names:
    """Parameters: the linear ones of each coil and the surroundings, and those about a coil's axis of `degrees`."""
    linear = [(d, "1", which) for d in DRIVES for which in SYMMETRIC]
    about = [(d, n, a) for n in degrees for d in DRIVES for a in (AXES if d == SURROUNDINGS else d)]
    return tuple((f"{d}{n}_{w}", "nT" if d == SURROUNDINGS else "1") for d, n, w in (*linear, *about))


PAIRS = _harmonics(("2", "4"))
PAIRS_ASKEW = _harmonics(("2", "3", "4", "4s"))  # unlike coils, and square ones


def columns(names: Names, lon_deg: float, lat_deg: float, up_deg: float, rig: Rig) -> Array:
    """The field in C for each unit of each parameter (n, 3, p), at the place of unit length that the angles give.

    `x2_x`: of second degree about x, in proportion to the reference along x; `o1_xy` in proportion to nothing.
    """
    place = _place(rig, *np.radians([lon_deg, lat_deg, up_deg]))
    harmonics, drive, which = _arranged(names)
    fields = np.stack([harmonic(degree, axis, place) for degree, axis in harmonics], axis=2)
    drives = np.column_stack([rig.reference_nT, np.ones(len(place))])
    return np.asarray(fields[:, :, which] * drives[:, None, drive])


@lru_cache(maxsize=8)
def _arranged(names: Names) -> tuple[list[tuple[str, str]], list[int], list[int]]:
    """The harmonics (degree and axis) that parameters have, and the places of each one's drive and harmonic."""
    parts = [_parts(name) for name, _ in names]
    harmonics = list(dict.fromkeys((degree, which) for _, degree, which in parts))
    places = {harmonic: place for place, harmonic in enumerate(harmonics)}
    return harmonics, [DRIVES.index(d) for d, _, _ in parts], [places[degree, which] for _, degree, which in parts]


def _parts(name: str) -> tuple[str, str, str]:
    found = NAME.fullmatch(name)
    assert found is not None
    drive, degree, which = found.groups()
    return drive, degree, which


def _place(rig: Rig, lon: float, lat: float, up: float) -> Array:
    """The place in C (n, 3): `up` from the plane in which the lever (`lon`, `lat` in the body) turns."""
    lever = np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])
    return np.asarray(np.cos(up) * (lever @ rig.to_body) + np.sin(up) * np.nan_to_num(rig.axis_cage))


def harmonic(degree: str, which: str, place: Array) -> Array:
    """The field (n, 3) at places (n, 3) of one harmonic of this degree: a matrix's, or about an axis."""
    return place @ traceless(which) if degree == "1" else _about_axis(degree, which, place)


def _about_axis(degree: str, axis: str, place: Array) -> Array:
    """The gradient (n, 3) of r^l P_l about an axis, l one more than the degree; `4s` that of c Re (a + ib)^4."""
    k = AXES.index(axis)
    order = [(k + 1) % 3, (k + 2) % 3, k]
    a, b, c = place[:, order].T
    square = a**2 + b**2
    if degree == "4s":
        across, along = (4 * c * (a**3 - 3 * a * b**2), 4 * c * (b**3 - 3 * b * a**2)), square**2 - 8 * (a * b) ** 2
    else:
        out, along = {
            "2": (-3 * c, 3 * c**2 - 1.5 * square),
            "3": (1.5 * square - 6 * c**2, 4 * c**3 - 6 * c * square),
            "4": (7.5 * c * square - 10 * c**3, 5 * c**4 - 15 * c**2 * square + 1.875 * square**2),
        }[degree]
        across = (out * a, out * b)
    found = np.empty_like(place)
    found[:, order] = np.column_stack([*across, along])
    return found
