"""How heavy the heaviest of all candidates would come out by chance: a maximum over surrogates of the residual.

What the accepted effects leave is whitened by the noise that was fitted to it; its cosine coefficients then get random
signs. That keeps the spectrum and takes away any tie to time, field and channels (phase randomisation, Theiler et al.,
Physica D 58, 77, 1992, in the cosine transform). Every look of every cause is scored on each surrogate, so that the
search that was made is corrected for as it was made: delays, time constants and likenesses among candidates included.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.search import Candidate, Columns, Search, Weighed

Array = NDArray[np.float64]
SURROGATES = 100
LEAST = 1e-4  # of a column's square must be new to what stands there
TAIL = 0.2  # of the surrogates: their excess over the rest is taken as exponential


def by_chance(search: Search, accepted: Sequence[Candidate], seed: int = 0) -> Array:
    """The largest weight of any candidate (surrogates,) [nats] on residuals with nothing in them but their noise."""
    stage = search.stage(accepted)
    weight = np.repeat(stage.bands.spectra[stage.null.tried], np.diff(stage.bands.edges)) ** -0.5 / stage.null.level
    known = _basis(_flat(stage.columns, weight))
    left = _flat(stage.y, weight)[:, 0]
    left = left - known @ (known.T @ left)
    signs = np.random.default_rng(seed).choice([-1.0, 1.0], size=(len(left), SURROGATES))
    drawn = left[:, None] * signs
    drawn = drawn - known @ (known.T @ drawn)
    heaviest = np.full(SURROGATES, -np.inf)
    for group in search.standing:
        for candidate, gain, new in zip(group.candidates, *_gains(search, group, weight, known, drawn), strict=True):
            if new:
                heaviest = np.maximum(heaviest, gain - search.price(candidate, int(new)))
    return np.sort(heaviest)


def _gains(search: Search, group: Columns, weight: Array, known: Array, drawn: Array) -> tuple[Array, NDArray[np.intp]]:
    """What each candidate of a group takes off the surrogates, halved (candidates, surrogates), and its new columns.

    Orthonormal columns `known` (n q, b) stand beside it, and nothing of them is in `drawn` (n q, surrogates).
    """
    moved = search.moved_each(group) * weight[:, None, None, None]
    c, p = moved.shape[2:]
    X = np.ascontiguousarray(moved.reshape(-1, c * p).T)
    each, carried, pull = X.reshape(c, p, -1), (X @ known).reshape(c, p, -1), (X @ drawn).reshape(c, p, -1)
    own = each @ np.swapaxes(each, 1, 2)
    size = np.maximum(np.sqrt(np.einsum("cpp->cp", own)), 1e-300)
    values, vectors = np.linalg.eigh((own - carried @ np.swapaxes(carried, 1, 2)) / size[:, :, None] / size[:, None])
    new = values > LEAST
    along = np.swapaxes(vectors, 1, 2) @ (pull / size[:, :, None])
    part = np.where(new, 1 / np.where(new, values, 1.0), 0.0)
    return 0.5 * np.sum(along**2 * part[:, :, None], axis=1), new.sum(axis=1)


def p_value(weighed: Weighed, heaviest: Array) -> float:
    """How often chance alone would give a candidate of this weight: by counting, beyond that by an exponential tail."""
    edge = heaviest[int((1 - TAIL) * len(heaviest))]
    if weighed.rank == 0:
        return 1.0
    if weighed.weight <= edge:
        return float((1 + np.sum(heaviest >= weighed.weight)) / (1 + len(heaviest)))
    excess = max(float(np.mean(heaviest[heaviest >= edge] - edge)), 1.0)
    return float(TAIL * np.exp((edge - weighed.weight) / excess))


def _flat(columns: Array, weight: Array) -> Array:
    return (columns * weight[:, None, None]).reshape(-1, columns.shape[2])


def _basis(columns: Array) -> Array:
    """Orthonormal columns that span the given ones."""
    size = np.sqrt(np.sum(columns**2, axis=0))
    scaled = columns / np.maximum(size, 1e-300)
    values, vectors = np.linalg.eigh(scaled.T @ scaled)
    kept = values > 1e-6 * LEAST
    return np.asarray(scaled @ (vectors[:, kept] / np.sqrt(values[kept])))
