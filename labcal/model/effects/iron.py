"""Iron that the cage's field magnetises: its field at the device, linear in the reference, beside its remanence.

What stands beside the cage answers with one tensor of the cage, for the coils' field at its place is linear in the one
at the centre. What turns with the table answers with one tensor of the table: in the cage that has the harmonics 0, 1
and 2 of the platform angle, within one mounting it is the device's own soft iron.
"""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product

import numpy as np

from labcal.geometry import rotation
from labcal.model.effects.protocol import Array, Rig
from labcal.model.effects.regressors import AXES

Names = tuple[tuple[str, str], ...]
TABLE = ("u", "v", "w")  # axes that turn with the table, w along the platform's
ACROSS = ("u", "v")
REMANENT = tuple((f"t_{a}", "nT") for a in TABLE)
BESIDE: Names = tuple((f"b{driven}_{a}", "1") for driven, a in product(AXES, AXES))
ON_TABLE: Names = (*REMANENT, *((f"t{driven}_{a}", "1") for driven, a in product(TABLE, TABLE)))
LEVEL: Names = (REMANENT[2], *((f"t0_{a}", "1") for a in TABLE))  # the same wherever the table's zero is
INDUCED_ACROSS = (("tw", ACROSS), ("tu", ("w",)), ("tv", ("w",)), ("t2", ACROSS))
TURNED: Names = (*REMANENT[:2], *((f"{kind}_{a}", "1") for kind, axes in INDUCED_ACROSS for a in axes))


def of_each_mounting(numbers: Iterable[int]) -> Names:
    """Iron on a table whose angle starts at another zero in each of these mountings."""
    return (*LEVEL, *((f"m{number}{name}", unit) for number in numbers for name, unit in TURNED))


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

    `t_u`: its remanence along u. `tw_u`: along u, what the field along w induces. `t0_w`, `t0_u`, `t0_v`: along w what
    does there, across w what does there, and that turned by 90°. `t2_u`, `t2_v`: what goes round twice a turn.
    """
    u, v, w = np.moveaxis(axes, 2, 0)
    if kind == "t":
        return np.asarray(axes[:, :, TABLE.index(along)])
    of_u, of_v, of_w = np.einsum("nij,ni->jn", axes, prediction_nT)[:, :, None]
    if kind == "t0":
        return np.asarray({"u": of_u * u + of_v * v, "v": of_u * v - of_v * u, "w": of_w * w}[along])
    if kind == "t2":
        return np.asarray(of_u * u - of_v * v if along == "u" else of_u * v + of_v * u)
    return np.asarray((of_u, of_v, of_w)[TABLE.index(kind[1])] * axes[:, :, TABLE.index(along)])
