"""What of an effect of the rig the map of the device takes as well: no run of this kind tells how the two share it.

Iron beside the cage may answer the field alike in all directions, and so does a gain of the device. The fit gives all
of that to the map, and nothing says that it should: an effect that was found along r directions is as large, for all
that is known, along those where it was not. The map carries that as its uncertainty, for it flies and the rig does not.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from labcal.loop.data.credible import min_new_share, of_the_rig
from labcal.loop.noise.nuisance import RANK_TOLERANCE
from labcal.loop.selection.joint_fit import JointFit, sum_of_effects
from labcal.model.effects import Term, families
from labcal.uncertainty import Contribution

Array = NDArray[np.float64]


def beside_the_map(found: JointFit, A: Array) -> list[Contribution]:
    """Of each direction of the rig's effects that the map takes, beside the derivatives A (n, q, p) of the fit.

    u is the rms of the field along that direction [nT], with as many degrees of freedom as directions were found.
    """
    apart = found.problem.residual_nT + sum_of_effects(found.terms, found.beta, found.problem.scene)
    least = min_new_share(found.terms, apart[found.used], found.problem.scene.field_nT[found.used])
    start, out = found.problem.T.shape[2], list[Contribution]()
    for term, beta in zip(found.terms, found.beta, strict=True):
        if of_the_rig(term):
            out += _of_one(found, A, start, term, beta, least)
        start += len(beta)
    return out


def _of_one(found: JointFit, A: Array, start: int, term: Term, beta: Array, least: float) -> Iterator[Contribution]:
    base = found.problem.T.shape[2]
    own = slice(start, start + len(beta))
    T, X = A[:, :, :base].reshape(-1, base), A[:, :, own].reshape(-1, len(beta))
    carried = np.linalg.lstsq(T, X, rcond=None)[0]
    new, directions = _principal(X, X - T @ carried)
    size = directions.T @ (X.T @ (X @ beta))
    known, columns = new > least, term.columns(found.problem.scene)[found.used]
    if not known.any():
        return
    as_large = float(np.sqrt(np.mean(size[known] ** 2)))
    for direction in directions[:, ~known].T * as_large:
        shift = np.zeros(A.shape[2])
        shift[:base], shift[own] = -carried @ direction, direction
        u = float(np.sqrt(np.mean(np.sum((columns @ direction) ** 2, axis=1))))
        if u > 0:
            name = next(family.id for family in families() if family.kernel is term.kernel)
            yield Contribution(f"{name}: what K and k take as well", "B", "normal", u, "nT", float(known.sum()), shift)


def _principal(columns: Array, left: Array) -> tuple[Array, Array]:
    """The share (r,) of its square that is `left` of each principal direction (p, r), which are of unit length."""
    length = np.maximum(np.sqrt(np.sum(columns**2, axis=0)), 1e-300)
    values, vectors = np.linalg.eigh((columns / length).T @ (columns / length))
    there = values > RANK_TOLERANCE * values[-1]
    unit = vectors[:, there] / np.sqrt(values[there]) / length[:, None]
    shares, turned = eigh(unit.T @ (left.T @ left) @ unit)
    return np.asarray(shares), np.asarray(unit @ turned)
