"""Smooth functions of one or two inputs in a finite basis: B-splines, weighted so that their prior is one number.

A function is f(x) = Σ_j s_j φ_j(x) with φ = B(x) · `functions`; B are B-splines (de Boor, A Practical Guide to Splines,
chapter 9), for two inputs their products. Where it has been seen is a `Domain`: an interval, or a joint convex hull.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Table = tuple[tuple[float, ...], ...]
ROUNDING = 1e-9  # of a hull's size: what was seen at its edge lies within


@dataclass(frozen=True, slots=True)
class Domain:
    """Where an effect has been seen: one input between two ends, two in the convex hull of what was seen together."""

    inputs: tuple[str, ...]
    hull: Table  # corners, against the clock; of one input its ends

    def outside(self, x: Array) -> NDArray[np.bool_]:
        """Rows (n,) of inputs (n, k) that lie outside; a missing one lies nowhere, and so not outside."""
        corners = np.array(self.hull)
        if len(self.inputs) == 1:
            low, high = corners.min(), corners.max()
            margin = ROUNDING * (high - low)
            return np.asarray((x[:, 0] < low - margin) | (x[:, 0] > high + margin))
        size = np.maximum(np.ptp(corners, axis=0), 1e-300)
        here, ends = x / size, corners / size
        edge = np.roll(ends, -1, axis=0) - ends
        beside = here[:, None, :] - ends
        left = edge[:, 0] * beside[:, :, 1] - edge[:, 1] * beside[:, :, 0]
        return np.asarray((left < -ROUNDING).any(axis=1))


@dataclass(frozen=True, slots=True)
class Basis:
    """The functions of an empirical term, one set for each body axis, and what was taken off their columns.

    Columns are φ_j(x) e_i less their projection on the base, [1, a / SCALE] on each axis: so what the map could do as
    well stays the map's (Plumlee, JASA 112, 1274, 2017).
    """

    kind: str
    knots: Table  # of each input
    degree: int
    functions: Table  # (splines, r)
    projection: Table  # (12, 3 r) on 1, a_x, a_y, a_z of each axis: what is taken off each column
    prior_nT: float  # standard deviation of each coefficient before the run was seen, and of f anywhere
    coefficients: Table = ()  # (r, 3) nT
    covariance: Table = ()  # (3 r, 3 r) nT², in the order of the effect's parameters

    def at(self, inputs: Sequence[Array]) -> Array:
        """The functions φ (n, r) at these inputs, each (n,); beyond the knots as at their ends."""
        splines = b_splines(np.array(self.knots[0]), self.degree, inputs[0])
        for knots, x in zip(self.knots[1:], inputs[1:], strict=True):
            other = b_splines(np.array(knots), self.degree, x)
            splines = (splines[:, :, None] * other[:, None, :]).reshape(len(x), -1)
        return np.asarray(splines @ np.array(self.functions))


def b_splines(knots: Array, degree: int, x: Array) -> Array:
    """All B-splines of this degree on the knots at x (n,), as (n, knots − degree − 1); x is held inside the knots."""
    x = np.clip(x, knots[degree], knots[-degree - 1])
    place = np.clip(np.searchsorted(knots, x, side="right") - 1, degree, len(knots) - degree - 2)
    B = (np.arange(len(knots) - 1) == place[:, None]).astype(float)
    for d in range(1, degree + 1):
        width = knots[d:] - knots[:-d]
        slope = 1 / np.where(width > 0, width, np.inf)
        rise = (x[:, None] - knots[: -d - 1]) * slope[:-1] * B[:, :-1]
        fall = (knots[d + 1 :] - x[:, None]) * slope[1:] * B[:, 1:]
        B = rise + fall
    return np.asarray(B)


def convex_hull(points: Array) -> Array:
    """The corners (m, 2) of the convex hull of points (n, 2), against the clock (Andrew, Inf. Proc. Lett. 9, 216)."""
    ordered = np.unique(points, axis=0).tolist()
    if len(ordered) < 3:
        return np.array(ordered)
    half = [_lower(ordered), _lower(ordered[::-1])]
    return np.array([*half[0][:-1], *half[1][:-1]])


def _lower(ordered: list[list[float]]) -> list[list[float]]:
    out: list[list[float]] = []
    for p in ordered:
        while len(out) > 1 and _turn(out[-2], out[-1], p) <= 0:
            out.pop()
        out.append(p)
    return out


def _turn(a: list[float], b: list[float], c: list[float]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def curve(basis: Basis, x: Array) -> tuple[Array, Array]:
    """The function on each body axis at inputs x (n, k), and its standard uncertainty, both (n, 3) [nT].

    For pictures and words: without its mean over the run, which is the map's, and with what is the map's in the field.
    """
    phi = basis.at(list(x.T))
    columns = phi[:, None, :, None] * np.eye(3)[None, :, None, :]
    columns = columns.reshape(len(x), 3, -1) - np.array(basis.projection)[:3]
    f = columns @ np.array(basis.coefficients).ravel()
    variance = np.einsum("nip,pq,niq->ni", columns, np.array(basis.covariance), columns)
    return np.asarray(f), np.asarray(np.sqrt(np.maximum(variance, 0.0)))
