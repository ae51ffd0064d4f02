"""What no run tells of an effect of the rig, its family says by the other parameters; the map takes what that changes.

A reference that is right at one temperature has its zero right there, and its scale: the run shows where the zero is,
and a scale that is off everywhere is the device's gain. Such a parameter is set after the fit, and columns are judged
beside what it does, else one that is large by it alone would seem to be the map's.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.nuisance import inverse_gram
from labcal.model.effects import Scene, Shape, Term, families

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]


def settled_shape(term: Term, beta: Array, scene: Scene) -> tuple[Shape, float] | None:
    """What its family says of a parameter that no run tells, and its u; None where there is none."""
    return next((f.settled(term, beta, scene) for f in families() if f.kernel is term.kernel), None)


def beside_settled(here: LinearProblem, terms: Sequence[Term], beta: Sequence[Array], used: Mask) -> Array | None:
    """M (p, p) over base, phases and betas; None where no parameter is settled so.

    A M are the derivatives A (n, p) with what such a parameter does taken off each effect's column, as far as it can
    be: columns of the map do that, so that A M spans what A does.
    """
    base, sizes = here.T.shape[2], [len(own) for own in beta]
    M, ends = np.eye(base + sum(sizes)), np.cumsum([base, *sizes])
    for term, own, start, end in zip(terms, beta, ends, ends[1:], strict=False):
        settled = settled_shape(term, own, here.scene)
        if settled is None:
            continue
        column, change = here.all_columns(term)[used], change_by(here, term, *settled)[used]
        squares = np.sum(change**2, axis=(0, 1))
        times = np.sum(column * change, axis=(0, 1)) / np.where(squares > 0, squares, 1.0)
        T = here.T[used].reshape(-1, base)
        M[:base, start:end] = np.linalg.lstsq(T, change.reshape(len(T), -1), rcond=None)[0] * times
    return None if np.array_equal(M, np.eye(len(M))) else M


def change_by(here: LinearProblem, term: Term, at: Shape, by: float) -> Array:
    """What the whitened columns (n, q, p) of an effect change by where its shape `at` is larger by so much."""
    moved = term.with_shape(replace(at, value=term.at(at.name) + by))
    return here.all_columns(moved) - here.all_columns(term)


def inverse_beside(gram: Array, M: Array | None, nuisance: int, least: float) -> Array:
    """The generalised inverse of a Gram matrix (p, p), directions judged as M says; more parameters may follow."""
    if M is None:
        return inverse_gram(gram, nuisance, least)
    whole = np.eye(len(gram))
    whole[: len(M), : len(M)] = M
    return np.asarray(whole @ inverse_gram(whole.T @ gram @ whole, nuisance, least) @ whole.T)
