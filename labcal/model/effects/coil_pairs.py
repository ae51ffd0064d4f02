"""What pairs of coils of a finite size give at a place off their centre, beside their field in the centre.

The field of currents that go round one axis is the gradient of a sum of zonal solid harmonics r^l P_l (Jackson,
Classical Electrodynamics, 3.3). The first is the field in the centre; the second is there where the halves of a pair
are unlike, the third where their distance is not Helmholtz's, the fifth always.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from labcal.model.effects.protocol import Array

Parts = tuple[Array, Array]  # along the axis, and for each unit of the distance across it, each (n,)


def _second(z: Array, across: Array) -> Parts:
    return 2 * z, -np.ones_like(z)


def _third(z: Array, across: Array) -> Parts:
    return 3 * z**2 - 1.5 * across, -3 * z


def _fifth(z: Array, across: Array) -> Parts:
    return 5 * z**4 - 15 * z**2 * across + 1.875 * across**2, -10 * z**3 + 7.5 * z * across


ORDERS: dict[int, Callable[[Array, Array], Parts]] = {2: _second, 3: _third, 5: _fifth}


def zonal(order: int, place: Array, axis: Array) -> Array:
    """Gradient (n, 3) of r^l P_l at `place` (n, 3), about the direction `axis` (3,)."""
    z = place @ axis
    beside = place - z[:, None] * axis
    along, across = ORDERS[order](z, np.sum(beside**2, axis=1))
    return np.asarray(along[:, None] * axis + across[:, None] * beside)
