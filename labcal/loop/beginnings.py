"""How far from rest the loops of other recordings begin: as far as the segments of the run did.

A state that nobody saw before the first row may lie anywhere. Where it lay in the run's own segments is seen in the
residual, and each is one more draw of how the device is treated before it is recorded.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.noise.nuisance import RANK_TOLERANCE
from labcal.loop.selection.joint_fit import JointFit
from labcal.model.effects import BEGINNING, BEGINNING_ON, CARRIED_OFF, Term
from labcal.model.effects.past import Past
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
SPREADS = np.linspace(0.0, 1.0, 201)  # in deviations of anywhere
SEEN = 100.0  # reciprocal variance of a direction, from which on it is looked at
SMALLEST = 1e-6  # of the channel's half range: a response that began nowhere else
MOST_SEGMENTS = 40  # that are looked at: they tell enough
ANYWHERE_TOO = 0.5  # the chance, before the run is seen, that segments begin anywhere; else each spread is as likely


def with_beginnings(found: JointFit) -> JointFit:
    """The same, each loop and slow response with where the segments of the run began, and how far from there."""
    for place in range(len(found.terms)):
        found = _carried(_spread(_on_the_whole(found, place), place), place)
    return found


def _carried(found: JointFit, place: int) -> JointFit:
    """How far a slow response was off where a segment began: the root of the mean square, along its own direction."""
    term, beta = found.terms[place], found.beta[place]
    if (within := term.of(CARRIED_OFF)) is None or not term.of_beginnings:
        return found
    own, begun = beta[: term.lasting], beta[term.lasting :].reshape(-1, term.lasting)
    part = float(np.sqrt(np.mean((begun @ own) ** 2))) / max(float(own @ own), 1e-300)
    moved = np.r_[own, begun.ravel() / max(part, SMALLEST)]
    return _changed(found, place, term.with_values(**{within.name: within.value * max(part, SMALLEST)}), moved)


def _spread(found: JointFit, place: int) -> JointFit:
    term = found.terms[place]
    if (shape := term.of(BEGINNING)) is None:
        return found
    return _changed(found, place, term.with_values(**{shape.name: spread_of(*_shown(found, term, found.beta[place]))}))


def _on_the_whole(found: JointFit, place: int) -> JointFit:
    """The part of its curve that a core began with, by least squares; each beginning is counted from there."""
    term, beta = found.terms[place], found.beta[place]
    if (shape := term.of(BEGINNING_ON)) is None or not term.of_beginnings:
        return found
    used, none = found.used, term.with_values(**{shape.name: 0.0})
    per_part = (found.problem.all_columns(term) - found.problem.all_columns(none))[:, :, : term.lasting]
    slope = (per_part @ beta[: term.lasting])[used].ravel()
    begun = found.problem.all_columns(term)[:, :, term.lasting :][used].reshape(len(slope), -1)
    y = found.problem.y[used].ravel() + begun @ beta[term.lasting :]
    lacking = float(slope @ y) / max(float(slope @ slope), 1e-300)
    part = min(max(shape.value + lacking, 0.0), 1.0)
    more = np.linalg.lstsq(begun, (shape.value - part) * slope, rcond=None)[0]
    moved = np.r_[beta[: term.lasting], beta[term.lasting :] + more]
    return _changed(found, place, term.with_values(**{shape.name: part}), moved)


def _changed(found: JointFit, place: int, term: Term, beta: Array | None = None) -> JointFit:
    terms = (*found.terms[:place], term, *found.terms[place + 1 :])
    own = found.beta[place] if beta is None else beta
    return replace(found, terms=terms, beta=(*found.beta[:place], own, *found.beta[place + 1 :]))


def _shown(found: JointFit, term: Term, beta: Array) -> tuple[Array, Array]:
    """How well each direction (k,) of the segments' beginnings is seen, and what is seen of it.

    For y = X u + A b + noise of variance one, u in deviations of anywhere for each axis of each segment, b all that
    is fitted beside: with A taken off both, the eigenvalues of XᵀX, and Xᵀy along its eigenvectors.
    """
    problem, used = found.problem, found.used
    begun = np.where(np.arange(len(beta)) < term.lasting, 0.0, beta)
    y = problem.y + problem.all_columns(term) @ begun
    anywhere = term.with_values(**{s.name: 1.0 for s in term.shape if s.kind is BEGINNING})
    far = _far(found, anywhere, beta - begun)
    columns = problem.whiten @ (far[:, :, None] * np.eye(3))
    segments = [rows for rows in stretches(problem.scene.segment) if far[rows].any()][:MOST_SEGMENTS]
    A = np.concatenate([problem.T, *(problem.all_columns(t)[:, :, : t.lasting] for t in found.terms)], axis=2)
    A = A * used[:, None, None]
    A /= np.maximum(np.sqrt(np.einsum("nqp,nqp->p", A, A)), 1e-300)
    gram, cross = np.zeros((3 * len(segments), 3 * len(segments))), np.zeros((A.shape[2], 3 * len(segments)))
    seen, y = np.zeros(len(gram)), y * used[:, None]
    for place, rows in enumerate(segments):
        own, X = slice(3 * place, 3 * place + 3), columns[rows] * used[rows, None, None]
        gram[own, own] = np.einsum("nqi,nqj->ij", X, X)
        cross[:, own] = np.einsum("nqp,nqi->pi", A[rows], X)
        seen[own] = np.einsum("nqi,nq->i", X, y[rows])
    taken_off = cross.T @ np.linalg.pinv(np.einsum("nqp,nqr->pr", A, A), rcond=RANK_TOLERANCE, hermitian=True)
    level = float(np.mean(problem.y[used] ** 2))
    values, along = np.linalg.eigh((gram - taken_off @ cross) / level)
    return np.maximum(values, 0.0), along.T @ (seen - taken_off @ np.einsum("nqp,nq->p", A, y)) / level


def astray_nT(found: JointFit, place: int) -> float:
    """How far off a loop is in the first row of another recording: the rms length of one standard deviation [nT]."""
    term, beta = found.terms[place], found.beta[place]
    if term.of(BEGINNING) is None:
        return 0.0
    far = _far(found, term, np.where(np.arange(len(beta)) < term.lasting, beta, 0.0))
    first = [rows.start for rows in stretches(found.problem.scene.segment)]
    return float(np.sqrt(np.mean(np.sum(far[first] ** 2, axis=1))))


def _far(found: JointFit, term: Term, beta: Array) -> Array:
    """How far from its own a term is (n, 3) [nT] where it begins a standard deviation astray."""
    rest, *either = (_effect(found, term, beta, astray) for astray in (0.0, 1.0, -1.0))
    return np.asarray(np.sqrt(np.mean([np.square(off - rest) for off in either], axis=0)))


def _effect(found: JointFit, term: Term, beta: Array, astray: float) -> Array:
    scene = replace(found.problem.scene, past=Past(len(found.problem), astray=astray))
    return np.asarray(term.columns(scene) @ beta)


def spread_of(values: Array, seen: Array) -> float:
    """The root of the mean square spread after the run, in deviations of anywhere.

    By directions that noise leaves uncertain by a tenth at most: what a form misses resembles the others.
    """
    values, seen = values[values > SEEN], seen[values > SEEN]
    s2 = SPREADS[:, None] ** 2
    left = 1 + s2 * values
    log = 0.5 * np.sum(s2 * seen**2 / left - np.log(left), axis=1)
    before = np.full(len(SPREADS), (1 - ANYWHERE_TOO) / len(SPREADS))
    before[-1] += ANYWHERE_TOO
    chance = before * np.exp(log - log.max())
    return float(np.sqrt(np.sum(chance * SPREADS**2) / np.sum(chance)))
