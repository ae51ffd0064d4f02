"""What of an effect of the rig the map of the device takes as well: no run of this kind tells how the two share it.

Iron beside the cage may answer the field alike in all directions, and so does a gain of the device. The fit gives all
of that to the map, but for sums that are zero in most bodies (`Family.sums_to_zero`), and little says that it should:
an effect that was found along some directions is as large, for all that is known, along those where it was not. The map
carries that as its uncertainty, for it flies and the rig does not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import eigh

from labcal.loop.data.credible import of_the_rig
from labcal.loop.noise.nuisance import RANK_TOLERANCE
from labcal.loop.selection.joint_fit import JointFit, new_share_needed
from labcal.loop.selection.settled import beside_settled, change_by, settled_shape
from labcal.model.effects import Term, families
from labcal.uncertainty import Contribution

Array = NDArray[np.float64]


def beside_the_map(found: JointFit, A: Array) -> list[Contribution]:
    """Of each direction of the rig's effects that the map takes, beside the derivatives A (n, q, p) of the fit.

    u is the rms of the field along it [nT], with as many degrees of freedom as there are directions that were found.
    """
    least = new_share_needed(found.problem, found.terms, found.beta, found.used)
    start, out = found.problem.T.shape[2], list[Contribution]()
    M = beside_settled(found.problem, found.terms, found.beta, found.used)
    for term, beta in zip(found.terms, found.beta, strict=True):
        if of_the_rig(term):
            out += _of_one(found, A, M, start, term, beta, least)
            out += _of_settled(found, A, term, beta)
        start += len(beta)
    return out


def _of_one(
    found: JointFit, A: Array, M: Array | None, start: int, term: Term, beta: Array, least: float
) -> Iterator[Contribution]:
    base = found.problem.T.shape[2]
    own = slice(start, start + len(beta))
    T, X = A[:, :, :base].reshape(-1, base), A[:, :, own].reshape(-1, len(beta))
    beside = np.zeros((base, len(beta))) if M is None else M[:base, own]
    X = X + T @ beside
    length = np.maximum(np.sqrt(np.sum(X**2, axis=0)), 1e-300)
    carried = np.linalg.lstsq(T, X / length, rcond=None)[0]
    taken = _taken_by_the_map(X / length, X / length - T @ carried, least)
    likely, dof = _as_large_as_found(taken, beta * length, [unit for _, unit in term.parameters])
    name = next(family.id for family in families() if family.kernel is term.kernel)
    columns = term.columns(found.problem.scene)[found.used]
    for direction in likely.T:
        shift = np.zeros(A.shape[2])
        shift[own] = direction / length
        shift[:base] = beside @ shift[own] - carried @ direction
        u = float(np.sqrt(np.mean(np.sum((columns @ shift[own]) ** 2, axis=1))))
        if u > 0:
            yield Contribution(f"{name}: what K and k take as well", "B", "normal", u, "nT", dof, shift)


def _of_settled(found: JointFit, A: Array, term: Term, beta: Array) -> Iterator[Contribution]:
    """Of a parameter of the rig's that no run tells, settled by the other ones: the map takes what it may be off."""
    settled = settled_shape(term, beta, found.problem.scene)
    if settled is None:
        return
    (at, u_of_it), base = settled, found.problem.T.shape[2]
    column = change_by(found.problem, term, at, u_of_it) @ beta
    shift = np.zeros(A.shape[2])
    shift[:base] = np.linalg.lstsq(A[:, :, :base].reshape(-1, base), column[found.used].ravel(), rcond=None)[0]
    off, scene = term.with_shape(replace(at, value=term.at(at.name) + u_of_it)), found.problem.scene
    changed_nT = (off.columns(scene) - term.columns(scene)) @ beta
    u = float(np.sqrt(np.mean(np.sum(changed_nT[found.used] ** 2, axis=1))))
    if u > 0:
        yield Contribution(f"{at.name}: what K and k take as well", "B", "normal", u, "nT", np.inf, shift)


def _taken_by_the_map(columns: Array, left: Array, least: float) -> Array:
    """Orthonormal directions (p, h) along which of the square of columns (m, p) no more than a part is `left`.

    By principal angles, for the part is that of each direction's own square. What makes no field is no direction.
    """
    values, vectors = np.linalg.eigh(columns.T @ columns)
    there = values > RANK_TOLERANCE * values[-1]
    unit = vectors[:, there] / np.sqrt(values[there])
    shares, turned = eigh(unit.T @ (left.T @ left) @ unit)
    return np.asarray(np.linalg.qr(unit @ turned[:, shares <= least])[0])


def _as_large_as_found(taken: Array, beta: Array, units: Sequence[str]) -> tuple[Array, float]:
    """What the effect is along directions (p, h) as independent standard deviations (p, h), and their dof.

    Parameters of one unit are alike before they are known, with the mean square that they have beside these directions.
    """
    beside = np.eye(len(beta)) - taken @ taken.T
    kind = np.array([units.index(unit) for unit in units])
    squares, free = (np.bincount(kind, of, len(units))[kind] for of in ((beside @ beta) ** 2, np.diag(beside)))
    known = free > 0.5
    if not taken.size or not (squares[known] > 0).any():
        return np.zeros((len(beta), 0)), np.inf
    precision = np.where(known, np.maximum(free, 0.5) / np.maximum(squares, 1e-12 * squares.max()), 0.0)
    values, vectors = np.linalg.eigh(taken.T @ (precision[:, None] * taken))
    found = values > 0
    return taken @ vectors[:, found] / np.sqrt(values[found]), float(np.trace(beside))
