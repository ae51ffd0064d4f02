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
from labcal.model.effects import BEGINNING, BEGINNING_ON, Term
from labcal.model.effects.past import Past
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
SPREADS = np.linspace(0.0, 1.0, 201)  # in deviations of anywhere
SEEN = 100.0  # reciprocal variance of a direction, from which on it is looked at
MOST_SEGMENTS = 40  # that are looked at: they tell enough
ANYWHERE_TOO = 0.5  # the chance, before the run is seen, that segments begin anywhere; else each spread is as likely


def with_beginnings(found: JointFit) -> JointFit:
    """The same, each loop with where the run's segments began on the whole, and how far from there."""
    for place in range(len(found.terms)):
        found = _spread(_on_the_whole(found, place), place)
    return found


def _spread(found: JointFit, place: int) -> JointFit:
    term = found.terms[place]
    if (shape := term.of(BEGINNING)) is None:
        return found
    return _changed(found, place, term.with_values(**{shape.name: spread_of(*_shown(found, term, found.beta[place]))}))


def _on_the_whole(found: JointFit, place: int) -> JointFit:
    """The part of its curve that a core began with, by least squares; each beginning is told from there."""
    term, beta = found.terms[place], found.beta[place]
    if (shape := term.of(BEGINNING_ON)) is None or not term.begins:
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
    X = np.zeros((*problem.y.shape, 3 * len(segments)))
    for place, rows in enumerate(segments):
        X[rows, :, 3 * place : 3 * place + 3] = columns[rows]
    fitted = [problem.all_columns(t)[:, :, : t.lasting] for t in found.terms]
    A = np.concatenate([problem.T, *fitted], axis=2)[used].reshape(-1, problem.T.shape[2] + sum(map(_width, fitted)))
    base = orthonormal_span(A / np.maximum(np.linalg.norm(A, axis=0), 1e-300))
    both = np.concatenate([X, y[:, :, None]], axis=2)[used].reshape(len(A), -1) / np.sqrt(np.mean(problem.y[used] ** 2))
    both -= base @ (base.T @ both)
    gram = both.T @ both
    values, along = np.linalg.eigh(gram[:-1, :-1])
    return np.maximum(values, 0.0), along.T @ gram[:-1, -1]


def _width(columns: Array) -> int:
    return int(columns.shape[2])


def orthonormal_span(columns: Array) -> Array:
    """An orthonormal basis of what columns (n, p) span."""
    u, size, _ = np.linalg.svd(columns, full_matrices=False)
    return np.asarray(u[:, size > RANK_TOLERANCE * size[0]])


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
