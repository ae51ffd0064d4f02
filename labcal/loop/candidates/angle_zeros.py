"""Where the platform's angle counts from in each mounting, by least squares: an encoder that begins anew.

What turns with the table, iron or a motor's rotor, is one and the same in all mountings. In each its columns are a
trigonometric polynomial of that mounting's zero: known at a few zeros, they are known at all, and lie in few directions
of that mounting's rows. The zeros are sought by variable projection (Golub & Pereyra, Inverse Problems 19, R1, 2003) on
the products of those directions, which are small: one mounting after another, then all at once.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, beside, explained_squares, orthonormal
from labcal.model.effects import Family, Term, families
from labcal.model.effects.regressors import mountings

Array = NDArray[np.float64]
HARMONICS = 3  # of the angle, at most, in any effect that takes zeros
NODES = 2 * np.pi * np.arange(2 * HARMONICS + 1) / (2 * HARMONICS + 1)  # zeros at which columns are made
TRIED = 2 * np.pi * np.arange(24) / 24  # zeros of the next mounting, beside those that are found
SWEEPS = 2  # over all mountings, one at a time, before all at once
EVALUATIONS = 30  # of one search of all at once, beside its slopes
SAME = 1e-10  # of the largest square: directions below are rounding
FINE = 0.05  # rad: a zero is known better than that, or not at all


def angle_zeros(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Candidate]:
    """Each term that takes zeros, at those that take most off the residual that the accepted effects leave."""
    found = []
    for family in families():
        if family.found_by("angle zeros") and is_observable(pool.problem, family):
            terms = [term for term in family.candidates(pool.problem.run) if term.found_by("angle zeros")]
            found += [c for c in (_at_best(pool, accepted, family, term) for term in terms) if c is not None]
    return found


def at_best_zeros(pool: CandidateSet, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    """The candidate with its zeros moved to where they take most off beside the accepted effects."""
    term = candidate.term
    found = Search.of(pool, accepted, term).improved(np.array([s.value for s in term.shape]))
    return replace(candidate, term=_with_zeros(term, found))


def _at_best(pool: CandidateSet, accepted: Sequence[Candidate], family: Family, term: Term) -> Candidate | None:
    """None where even another amplitude in each mounting, which takes off more, would not be worth its parameters."""
    search = Search.of(pool, accepted, term)
    candidate = Candidate(family, _with_zeros(term, np.zeros(len(term.shape))), len(TRIED))
    rss = float(np.sum(pool.residual(accepted)[pool.rows] ** 2))
    gain = -0.5 * pool.n_data * np.log(max(1 - float(search.z @ search.z) / rss, 1e-12))
    if gain < pool.penalty(candidate, len(term.parameters)):
        return None
    return replace(candidate, term=_with_zeros(term, search.improved(search.one_by_one())))


def _with_zeros(term: Term, zeros: Array) -> Term:
    """The form at these zeros (k,), in (-π, π]; each is counted as searched."""
    values = np.pi - (np.pi - zeros) % (2 * np.pi)
    shapes = (
        replace(s, value=v, grid=(v - FINE, v, v + FINE)) for s, v in zip(term.shape, values.tolist(), strict=True)
    )
    return replace(term, shape=tuple(shapes))


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """Least squares in X(zeros) beta = z, X (r, p) a sum over mountings, each a polynomial of its own zero."""

    at_nodes: Array  # (mountings, nodes, r, p) what each adds to X; the first one's zero is zero, at all nodes
    z: Array  # (r,) what the residual has along all their directions
    length: Array  # (p,) of the columns, before base and accepted effects are taken out of them

    @classmethod
    def of(cls, pool: CandidateSet, accepted: Sequence[Candidate], term: Term) -> Search:
        """For a term beside base and accepted effects, on the rows of a set."""
        form = term.kernel, term.parameters, term.channels, tuple(one.name for one in term.shape)
        directions, at = pool.store.memo.get("directions", form, lambda: _all_directions(pool.problem, term))
        here = directions[pool.rows]
        kept = np.einsum("nqr,nqr->r", here, here) > SAME  # none of a mounting that has no row here
        new = beside(_spanned(pool, accepted), here[..., kept])
        Q, R = np.linalg.qr(new.reshape(-1, new.shape[2]))
        at_nodes = np.stack([np.tensordot(R, nodes[:, kept], axes=(1, 1)).swapaxes(0, 1) for nodes in at])
        length = np.linalg.norm(here @ sum(nodes[0] for nodes in at), axis=(0, 1))
        return cls(at_nodes, Q.T @ pool.residual(accepted)[pool.rows].ravel(), np.maximum(length, 1e-300))

    def each(self, place: int, zeros: Array) -> Array:
        """What a mounting adds to X at each of these zeros (m, r, p)."""
        return np.tensordot(_weights(zeros), self.at_nodes[place], axes=1)

    def left(self, zeros: Array) -> Array:
        """What least squares leaves of z (r,), in directions that are new."""
        kept, _ = self._fitted(zeros)
        return np.asarray(self.z - kept @ (kept.T @ self.z))

    def slopes(self, zeros: Array) -> Array:
        """How what is left follows each zero (r, k), but for what lies along X (Kaufman, BIT 15, 49, 1975)."""
        kept, beta = self._fitted(zeros)
        turned = np.tensordot(self.at_nodes[1:], beta / self.length, axes=1)  # (k, nodes, r)
        moved = np.einsum("kn,knr->rk", _slopes_of_weights(zeros), turned)
        return np.asarray(kept @ (kept.T @ moved) - moved)

    def _fitted(self, zeros: Array) -> tuple[Array, Array]:
        """Orthonormal directions (r, m) of X at these zeros that are new, and the amplitudes (p,) along them."""
        X = np.tensordot(_weights(np.concatenate([[0.0], zeros])), self.at_nodes, axes=2) / self.length
        directions, size, amplitudes = np.linalg.svd(X, full_matrices=False)
        new = size**2 > MIN_NEW_SHARE
        kept = directions[:, new]
        return kept, np.asarray(amplitudes[new].T @ ((kept.T @ self.z) / size[new]))

    def one_by_one(self) -> Array:
        """Zeros (k,): each mounting's beside those before it, then each beside all others."""
        adds = [self.each(place, TRIED) for place in range(len(self.at_nodes))]
        at = [0] * len(adds)
        for turn, place in itertools.product(range(1 + SWEEPS), range(1, len(adds))):
            others = [k for k in range(len(adds) if turn else place) if k != place]
            X = sum((adds[k][at[k]] for k in others), adds[place]) / self.length
            gram = np.swapaxes(X, 1, 2) @ X
            taken, _ = explained_squares(gram, (np.swapaxes(X, 1, 2) @ self.z)[:, :, None], MIN_NEW_SHARE)
            at[place] = int(np.argmax(taken[:, 0]))
        return np.asarray(TRIED[at[1:]])

    def improved(self, zeros: Array) -> Array:
        """Zeros (k,) from these on, all at once."""
        from scipy.optimize import least_squares

        return np.asarray(least_squares(self.left, zeros, self.slopes, xtol=1e-6, ftol=1e-6, max_nfev=EVALUATIONS).x)


def _spanned(pool: CandidateSet, accepted: Sequence[Candidate]) -> Array:
    """Orthonormal columns (rows, q, b) that span the base and the accepted effects on these rows."""

    def made() -> Array:
        return orthonormal(np.concatenate([pool.problem.T, *(pool.columns(c) for c in accepted)], axis=2)[pool.rows])

    return pool.cached("spanned", accepted, made)


def _all_directions(problem: LinearProblem, term: Term) -> tuple[Array, list[Array]]:
    """Directions (N, q, r) of all mountings, on every row, and each mounting's columns in them (nodes, r, p)."""
    assert problem.scene.rig is not None
    mounting = problem.scene.rig.mounting + 1
    made = np.stack([problem.all_columns(term.with_values(**{s.name: v for s in term.shape})) for v in NODES])
    numbers = mountings(problem.run)
    few = [_few_directions(made[:, mounting == number]) for number in numbers]
    ends = np.cumsum([0, *(directions.shape[2] for directions, _ in few)])
    whole, at = np.zeros((*problem.y.shape[:2], ends[-1])), []
    for number, (directions, nodes), a, b in zip(numbers, few, ends, ends[1:], strict=False):
        whole[mounting == number, :, a:b] = directions
        at.append(np.zeros((len(NODES), ends[-1], nodes.shape[2])))
        at[-1][:, a:b] = nodes
    return whole, at


def _few_directions(made: Array) -> tuple[Array, Array]:
    """Orthonormal directions (m, q, r) of columns (nodes, m, q, p), and the columns in them (nodes, r, p)."""
    nodes, m, q, p = made.shape
    flat = np.moveaxis(made, 0, 2).reshape(m * q, nodes * p)
    length = np.maximum(np.linalg.norm(flat, axis=0), 1e-300)
    left, size, right = np.linalg.svd(flat / length, full_matrices=False)
    kept = size**2 > SAME * size.max(initial=0.0) ** 2  # none, where no row of a mounting is left
    columns, r = (size[kept, None] * right[: len(size)][kept]) * length, int(kept.sum())
    return left[:, kept].reshape(m, q, r), np.moveaxis(columns.reshape(r, nodes, p), 1, 0)


def _slopes_of_weights(zeros: Array) -> Array:
    """How each node's weight follows its zero (m, nodes)."""
    h = np.arange(1, HARMONICS + 1)
    return np.asarray(-2 * (h * np.sin(np.multiply.outer(zeros[:, None] - NODES, h))).sum(axis=2) / len(NODES))


def _weights(zeros: Array) -> Array:
    """What each node counts for (m, nodes) in a trigonometric polynomial's value at each of these zeros."""
    h = np.arange(1, HARMONICS + 1)
    return np.asarray((1 + 2 * np.cos(np.multiply.outer(zeros[:, None] - NODES, h)).sum(axis=2)) / len(NODES))
