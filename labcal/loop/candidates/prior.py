"""Parameters that are known before the run is seen, as data of their own (Theil & Goldberger, Int. Econ. Rev. 2, 65).

Those of a smooth function have mean zero and one standard deviation. How a core was magnetised where a segment began
is anywhere between its two saturations, which its own loop says how large they are. All others are open.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.model.effects import Term
from labcal.model.effects.past import ANYWHERE
from labcal.model.effects.regressors import AXES

Array = NDArray[np.float64]


def as_data(
    terms: Sequence[Term], beta: Sequence[Array] | None, start: int, q: int, loops: Sequence[Array] | None = None
) -> tuple[Array, Array]:
    """One row (known, q, p) for each known parameter, and how far off it is (known, q) in its own deviations.

    Of p parameters the first `start` are the base's. With `beta` None they are taken to be zero. `loops` say how large
    the loops are, where `beta` itself does not.
    """
    weight = _weights(
        terms, beta if loops is None else loops, start, start + sum(len(term.parameters) for term in terms)
    )
    known = np.flatnonzero(weight)
    rows = np.zeros((len(known), q, len(weight)))
    rows[np.arange(len(known)), 0, known] = weight[known]
    off = np.zeros((len(known), q))
    if beta is not None and len(known):
        off[:, 0] = weight[known] * np.concatenate([np.zeros(start), *beta])[known]
    return rows, off


def precision(terms: Sequence[Term], beta: Sequence[Array], start: int, p: int) -> Array:
    """What is known of p parameters before the data (p, p): reciprocal variances."""
    return np.diag(_weights(terms, beta, start, p) ** 2)


def _weights(terms: Sequence[Term], beta: Sequence[Array] | None, start: int, p: int) -> Array:
    """Reciprocal standard deviations (p,), zero where a parameter is open."""
    out = np.zeros(p)
    for number, term in enumerate(terms):
        end = start + len(term.parameters)
        if term.basis is not None:
            out[start:end] = 1 / term.basis.prior_nT
        if term.of_beginnings and beta is not None:
            of_each_axis = ANYWHERE * np.abs(beta[number][: len(AXES)])
            spread = np.tile(of_each_axis, term.of_beginnings // len(AXES))
            out[end - term.of_beginnings : end] = np.where(spread > 0, 1 / np.where(spread > 0, spread, 1.0), 0.0)
        start = end
    return out
