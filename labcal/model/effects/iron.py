"""Iron that the cage's field magnetises: its field at the device, linear in the reference, beside its remanence.

What stands beside the cage answers with one tensor of the cage, for the coils' field at its place is linear in the one
at the centre. What turns with the table answers with one tensor of the table: in the cage that has the harmonics 0, 1
and 2 of the platform angle, within one mounting it is the device's own soft iron.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations_with_replacement, product

import numpy as np

from labcal.geometry import rotation
from labcal.model.effects.regressors import AXES
from labcal.model.effects.scene import Array, Rig

Names = tuple[tuple[str, str], ...]
TABLE = ("u", "v", "w")  # axes that turn with the table, w along the platform's
REMANENT = tuple((f"t_{a}", "nT") for a in TABLE)
BESIDE: Names = tuple((f"b{driven}_{a}", "1") for driven, a in product(AXES, AXES))
SYMMETRIC: Names = tuple((f"bs{one}_{other}", "1") for one, other in combinations_with_replacement(AXES, 2))
SURE = 2.0  # standard uncertainties
ON_TABLE: Names = (*REMANENT, *((f"t{driven}_{a}", "1") for driven, a in product(TABLE, TABLE)))


def kinds(names: Sequence[str]) -> set[str]:
    """Which iron these parameters tell of: b of what stands beside the cage, t of what turns with the table."""
    return {name[0] for name in names} & {"b", "t"}


def diagonal(names: Sequence[str]) -> tuple[str, ...]:
    """The diagonal of the tensor that these parameters are; none where they are no whole one.

    A dipole's field tensor has no trace, nor has its product with the answer of a body that is alike in all directions.
    """
    wholes = ([f"b{a}_{a}" for a in AXES], [f"bs{a}_{a}" for a in AXES], [f"t{a}_{a}" for a in TABLE])
    return next((tuple(whole) for whole in wholes if set(whole) <= set(names)), ())


def without_lean(names: Names, beta: Array, covariance: Array) -> tuple[Names, ...]:
    """Forms of iron beside the cage without a lean, where its fitted tensor is more of a turn than iron can be.

    The symmetric one, and those with a turn about one axis, which the platform's may be.

    A body at r answers the field by T = D P: D, the field of a dipole there, is symmetric, and so is its
    polarisability P, which has no negative value. Then tr T² = tr (√P D √P)² is not negative, and T = S + A has no
    larger part A that turns than S that does not. A lean of the platform is all A. The trace, which the device's map
    takes as well, counts as zero, as it is of a body that is alike in all directions.
    """
    places = [names.index(one) for one in BESIDE if one in names]
    if len(places) < len(BESIDE):
        return ()
    T = beta[places].reshape(3, 3)  # by what drives it, then along what
    S, A = (T + T.T) / 2 - np.eye(3) * np.trace(T) / 3, (T - T.T) / 2
    slope = 2 * (A - S).ravel()
    u = float(np.sqrt(slope @ covariance[np.ix_(places, places)] @ slope))
    if np.sum(A**2) - np.sum(S**2) <= SURE * u:
        return ()
    symmetric = (*(one for one in names if one not in BESIDE), *SYMMETRIC)
    return (symmetric, *((*symmetric, (f"bturn_{axis}", "1")) for axis in AXES))


def table_axes(rig: Rig) -> Array:
    """The table's axes u, v and w in the body (n, 3, 3), as columns; zero where it does not turn."""
    out = np.zeros_like(rig.to_body)
    turning = np.isfinite(rig.angle_rad) & np.isfinite(rig.axis_cage).all(axis=1)
    for axis in np.unique(rig.axis_cage[turning], axis=0):
        rows = turning & (rig.axis_cage == axis).all(axis=1)
        upright = np.column_stack([*_across(axis), axis])
        out[rows] = rig.to_body[rows] @ rotation(axis, rig.angle_rad[rows]) @ upright
    return out


def _across(axis: Array) -> tuple[Array, Array]:
    """Two directions across an axis: u, v and it are right-handed."""
    u = np.cross(np.eye(3)[int(np.argmin(np.abs(axis)))], axis)
    u = u / np.linalg.norm(u)
    return u, np.cross(axis, u)


def column(kind: str, along: str, axes: Array, prediction_nT: Array) -> Array:
    """What iron on the table adds in the body (n, 3), `axes` being the table's and `prediction_nT` the reference there.

    `t_u`: its remanence along u. `tw_u`: along u, what the field along w induces.
    """
    if kind == "t":
        return np.asarray(axes[:, :, TABLE.index(along)])
    induced_by = np.einsum("ni,ni->n", axes[:, :, TABLE.index(kind[1])], prediction_nT)
    return np.asarray(induced_by[:, None] * axes[:, :, TABLE.index(along)])
