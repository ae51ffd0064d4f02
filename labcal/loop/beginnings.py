"""How far from rest the loops of other recordings begin: as far as the segments of the run did.

A state that nobody saw before the first row may lie anywhere. Where it lay in the run's own segments, the residual shows:
each is one more draw of how the device is treated before it is recorded.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.selection.joint_fit import JointFit
from labcal.model.effects import BEGINNING, Term
from labcal.model.effects.past import Past
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
SPREADS = np.linspace(0.0, 1.0, 201)  # in deviations of anywhere
ANYWHERE_TOO = 0.5  # the chance, before the run is seen, that segments begin anywhere; else each spread is as likely


def with_beginnings(found: JointFit) -> JointFit:
    """The same, each loop with the spread of its beginnings over the run's segments."""
    terms = tuple(_begun(found, term, beta) for term, beta in zip(found.terms, found.beta, strict=True))
    return replace(found, terms=terms)


def _begun(found: JointFit, term: Term, beta: Array) -> Term:
    if (shape := term.of(BEGINNING)) is None:
        return term
    return term.with_values(**{shape.name: spread_of(*_shown(found, term, beta))})


def _shown(found: JointFit, term: Term, beta: Array) -> tuple[Array, Array]:
    """How well each direction (k,) of a segment's beginning is seen, and what is seen of it.

    For y = X u + noise of variance one, u in deviations of anywhere on the three axes: the eigenvalues of XᵀX, and Xᵀy
    along its eigenvectors.
    """
    problem, used = found.problem, found.used
    begun = np.r_[np.zeros(term.lasting), beta[term.lasting :]]
    y = problem.y + problem.all_columns(term) @ begun
    rms = float(np.sqrt(np.mean(problem.y[used] ** 2)))
    anywhere = term.with_values(**{s.name: 1.0 for s in term.shape if s.kind is BEGINNING})
    off, rest = (_effect(found, anywhere, beta - begun, astray) for astray in (1.0, 0.0))
    X = problem.whiten @ ((off - rest)[:, :, None] * np.eye(3)) / rms
    values, seen = list[Array](), list[Array]()
    for rows in stretches(problem.scene.segment):
        A = X[rows][used[rows]].reshape(-1, 3)
        weight, along = np.linalg.eigh(A.T @ A)
        values.append(weight)
        seen.append(along.T @ (A.T @ (y[rows][used[rows]].ravel() / rms)))
    return np.concatenate(values), np.concatenate(seen)


def _effect(found: JointFit, term: Term, beta: Array, astray: float) -> Array:
    scene = replace(found.problem.scene, past=Past(len(found.problem), astray=astray))
    return np.asarray(term.columns(scene) @ beta)


def spread_of(values: Array, seen: Array) -> float:
    """The root of the mean square spread after the run, in deviations of anywhere."""
    s2 = SPREADS[:, None] ** 2
    left = 1 + s2 * values
    log = 0.5 * np.sum(s2 * seen**2 / left - np.log(left), axis=1)
    before = np.full(len(SPREADS), (1 - ANYWHERE_TOO) / len(SPREADS))
    before[-1] += ANYWHERE_TOO
    chance = before * np.exp(log - log.max())
    return float(np.sqrt(np.sum(chance * SPREADS**2) / np.sum(chance)))
