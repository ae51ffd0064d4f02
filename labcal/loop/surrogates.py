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

from labcal.loop.search import Candidate, Search, Weighed

Array = NDArray[np.float64]
SURROGATES = 100
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
    heaviest = np.full(SURROGATES, -np.inf)
    for group in search.standing:
        moved = search.moved_each(group)
        for place, candidate in enumerate(group.candidates):
            X = _flat(moved[:, :, place], weight)
            new = _basis(X - known @ (known.T @ X), X)
            if new.shape[1]:
                gain = 0.5 * np.sum((new.T @ drawn) ** 2, axis=0)
                heaviest = np.maximum(heaviest, gain - search.price(candidate, new.shape[1]))
    return np.sort(heaviest)


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


def _basis(columns: Array, whole: Array | None = None, least: float = 1e-4) -> Array:
    """Orthonormal columns that span the given ones, but for directions with less than `least` of `whole`'s square."""
    size = np.sqrt(np.sum((columns if whole is None else whole) ** 2, axis=0))
    scaled = columns / np.maximum(size, 1e-300)
    values, vectors = np.linalg.eigh(scaled.T @ scaled)
    kept = values > least * (1e-6 if whole is None else 1.0)
    return np.asarray(scaled @ (vectors[:, kept] / np.sqrt(values[kept])))
