"""The shape of structure that no known effect explains: for a person who has to think of one."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.autocorrelation import correlation_time_s
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.nuisance import gram_pinv
from labcal.loop.noise.periodogram import periodogram, running_median
from labcal.loop.result import ResidualShape
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
AXES = "xyz"
DOMINANT_SHARE = 0.6  # of the square above the noise: an axis with as much is named alone
MIN_EXPLAINED = 0.5  # of it that a line, a step or two levels have to take off
CONCENTRATION = 3.0  # times more above the noise in one third of fields, or quarter of a turn, than in the least
STEEP = -1.2  # slope of log power over log frequency: −2 is a random walk, 0 is white
MEMORY = 1.5  # rows: a longer correlation time is a wander
DIFFERENT_FIELDS = 0.2  # of the mean magnitude: a smaller range of fields is one
SLOPE_ROWS = 60  # of a segment whose spectrum has a slope
PART_ROWS = 20  # of a third of fields or a quarter of a turn
EDGE = 30  # part of the rows at each end in which no step is looked for
LOW_BAND = 6  # part of the frequencies whose slope is taken, and at least so many of them
QUARTERS_deg = (0.0, 90.0, 180.0, 270.0, 360.0)
LEAST_EXCESS = 0.05  # of the noise's square: what is compared has as much above it
SMOOTH = 5  # rows of a running median
SWITCHES = 3  # between two levels before they are called telegraph-like,
TWO_LEVELS = 0.88  # and the part of what is above the noise that they have to take off
ALTERNATIONS = 6
SURROGATES = 19  # of noise, none of which may look as much like two levels: one in twenty by chance
MOST_STEPS = 20  # moments that are listed


@dataclass(frozen=True, slots=True)
class _Description:
    """One description of the structure, and the share of its square that it explains."""

    kind: str
    share: float
    says: str
    period_s: float | None = None
    steps_s: tuple[float, ...] = ()


def describe(problem: LinearProblem, good: Mask) -> ResidualShape:
    """The shape of the whitened residual of `problem` on the rows that are `good`."""
    t, y, segment = problem.scene.t_s[good], problem.y[good], problem.scene.segment[good]
    excess = max(float(np.mean(y**2)) - 1.0, 1e-9)
    T = problem.T[good]
    ways = [_line(t, y, T), _step(t, y, T), _telegraph(t, y, T, segment)]
    best = max(ways, key=lambda way: way.share)
    if best.kind == "telegraph" and _is_chance(best.share, t, y, T, segment):
        best = max(ways[:-1], key=lambda way: way.share)
    if best.share * float(np.mean(y**2)) < MIN_EXPLAINED * excess:
        best = _broadband(t, _principal(y), segment)
    axis = _axis(y) if problem.kind == "vector" else "the magnitude"
    where, field, angle = _concentrated_in(problem, good)
    words = "; ".join(part for part in (f"{best.says}, on {axis}", where) if part)
    return ResidualShape(best.kind, axis, best.period_s, best.steps_s, field, angle, f"{words}.")


def _principal(y: Array) -> Array:
    """The component (n,) that varies most."""
    _, vectors = np.linalg.eigh(y.T @ y)
    return np.asarray(y @ vectors[:, -1])


def _axis(y: Array) -> str:
    above = np.maximum(np.mean(y**2, axis=0) - 1.0, 0.0)
    share = above / max(float(above.sum()), 1e-9)
    order = np.argsort(-share)
    if share[order[0]] > DOMINANT_SHARE:
        return f"axis {AXES[order[0]]}"
    if share[order[:2]].sum() > (1 + DOMINANT_SHARE) / 2:
        return f"axes {' and '.join(sorted(AXES[i] for i in order[:2]))}"
    return "all axes"


def _fitted(y: Array, T: Array, drives: Array) -> tuple[float, Array, Array]:
    """Least squares of y (n, q) on the base's T (n, q, t) and drives (n, p) on each component.

    The share of the square that they take off, the coefficients (p, q), and y less the base's part.
    """
    n, q = y.shape
    each = np.einsum("np,qr->nqpr", drives, np.eye(q)).reshape(n * q, -1)
    A = np.hstack([T.reshape(n * q, -1), each])
    x = gram_pinv(A) @ (A.T @ y.ravel())
    share = 1 - float(np.sum((y.ravel() - A @ x) ** 2) / np.sum(y**2))
    base = T.shape[2]
    return share, x[base:].reshape(-1, q), y - (A[:, :base] @ x[:base]).reshape(n, q)


def _line(t: Array, y: Array, T: Array) -> _Description:
    """The highest line of the spectrum, slower ones than a third of the record left out."""
    frequency, power = periodogram(t, y)
    contrast = np.where(frequency > 3 / np.ptp(t), power / running_median(power), 0.0)
    f = float(frequency[np.argmax(contrast)])
    if f <= 0:
        return _Description("line", 0.0, "")
    turn = 2 * np.pi * f * t
    share, _, _ = _fitted(y, T, np.column_stack([np.sin(turn), np.cos(turn)]))
    return _Description("line", share, f"a line with a period of {1 / f:.3g} s", period_s=1 / f)


def _step(t: Array, y: Array, T: Array) -> _Description:
    """One level before and another after the moment that takes most off."""
    n = len(t)
    total, sums = y.sum(axis=0), np.cumsum(y, axis=0)[:-1]
    count = np.arange(1, n)[:, None]
    gain = np.sum(sums**2 / count + (total - sums) ** 2 / (n - count), axis=1) - np.sum(total**2) / n
    edge = max(n // EDGE, 2)
    gain[:edge] = gain[-edge:] = 0.0
    row = int(np.argmax(gain))
    moment = float(t[row] + t[row + 1]) / 2
    share, _, _ = _fitted(y, T, (t > moment).astype(float)[:, None])
    return _Description("step", share, f"a step at t = {moment:.1f} s", steps_s=(moment,))


def _telegraph(t: Array, y: Array, T: Array, segment: NDArray[np.intp]) -> _Description:
    """Two levels: by turns the rows of the upper one, and the levels with the base about them."""
    x, none = _principal(y), _Description("telegraph", 0.0, "")
    middle, share = float(np.median(x)), 0.0
    for _ in range(ALTERNATIONS):
        smooth = np.concatenate([_running_median(x[rows]) for rows in stretches(segment)])
        upper = smooth > middle
        if upper.all() or not upper.any():
            return none
        share, (level,), bare = _fitted(y, T, upper.astype(float)[:, None])
        size = float(np.linalg.norm(level))
        x, middle = bare @ level / max(size, 1e-12), size / 2
    switched = np.flatnonzero(np.diff(upper.astype(int)) != 0)
    above = float(np.mean(y**2)) - 1.0
    if len(switched) < SWITCHES or share * (above + 1.0) < TWO_LEVELS * above:
        return none
    stays = float(np.median(np.diff(t[switched])))
    says = f"two levels with {len(switched)} changes between them, each kept for about {stays:.3g} s (telegraph-like)"
    return _Description("telegraph", share, says, steps_s=tuple(float(s) for s in t[switched][:MOST_STEPS]))


def _is_chance(share: float, t: Array, y: Array, T: Array, segment: NDArray[np.intp]) -> bool:
    """Whether two levels take as much off noise of the same spectrum: of its cosine coefficients with random signs."""
    from scipy.fft import idct

    spectrum, draw = cosine_transform(y), np.random.default_rng(0)
    signs = draw.choice([-1.0, 1.0], size=(SURROGATES, len(y), 1))
    surrogates = (np.asarray(idct(spectrum * each, axis=0, norm="ortho")) for each in signs)
    return any(_telegraph(t, one, T, segment).share >= share for one in surrogates)


def _running_median(x: Array) -> Array:
    if len(x) < SMOOTH:
        return x
    padded = np.pad(x, SMOOTH // 2, mode="edge")
    return np.asarray(np.median(np.lib.stride_tricks.sliding_window_view(padded, SMOOTH), axis=1))


def _broadband(t: Array, x: Array, segment: NDArray[np.intp]) -> _Description:
    """By how the spectrum falls within segments: a random walk, a correlated wander, or noise larger than stated."""
    slope, memory = _slope(x, segment), correlation_time_s(t, x[:, None])
    if slope < STEEP:
        return _Description("random-walk", 0.0, "a wander like a random walk")
    step = float(np.median(np.diff(t)))
    if memory > MEMORY * step:
        return _Description("wander", 0.0, f"a wander that remembers itself for about {memory:.2g} s")
    return _Description("noise", 0.0, "more noise than is stated, without memory from row to row")


def _slope(x: Array, segment: NDArray[np.intp]) -> float:
    """Of log power over log frequency, averaged over segments, between a twentieth and all of the lower third."""
    parts = [x[rows] for rows in stretches(segment) if np.ptp(np.flatnonzero(segment == segment[rows][0])) > SLOPE_ROWS]
    length = min((len(p) for p in parts), default=0)
    if length < SLOPE_ROWS:
        parts, length = [x], len(x)
    window = np.hanning(length)
    power = np.mean([np.abs(np.fft.rfft((p[:length] - p[:length].mean()) * window)) ** 2 for p in parts], axis=0)
    rows = np.arange(2, max(length // LOW_BAND, LOW_BAND))
    return float(np.polyfit(np.log(rows), np.log(power[rows] + 1e-300), 1)[0])


Range = tuple[float, float] | None


def _concentrated_in(problem: LinearProblem, good: Mask) -> tuple[str, Range, Range]:
    """The third of fields and the quarter of a turn that hold most of it, where they hold far more than the others."""
    square = np.mean(problem.y[good] ** 2, axis=1)
    size = problem.observations.magnitude[good]
    field = _third(square, size) if np.ptp(size) > DIFFERENT_FIELDS * size.mean() else None
    rig, angle = problem.scene.rig, None
    if rig is not None and np.isfinite(rig.angle_rad).any():
        degrees = np.mod(np.degrees(rig.angle_rad[good]), 360.0)
        angle = _quarter(square[np.isfinite(degrees)], degrees[np.isfinite(degrees)])
    words = [f"mostly in fields of {field[0] / 1000:.0f} to {field[1] / 1000:.0f} µT"] if field else []
    words += [f"mostly at angles of {angle[0]:.0f} to {angle[1]:.0f}°"] if angle else []
    return ", ".join(words), field, angle


def _third(square: Array, size: Array) -> Range:
    edges = np.quantile(size, [0, 1 / 3, 2 / 3, 1])
    inside = [(size >= low) & (size <= high) for low, high in pairwise(edges.tolist())]
    return _concentrated_part(square, inside, edges)


def _quarter(square: Array, degrees: Array) -> Range:
    edges = np.array(QUARTERS_deg)
    return _concentrated_part(square, [(degrees >= a) & (degrees < b) for a, b in pairwise(edges.tolist())], edges)


def _concentrated_part(square: Array, inside: list[Mask], edges: Array) -> Range:
    """The edges of the part that lies far above the least; None where none does, or a part has few rows."""
    if min(int(rows.sum()) for rows in inside) < PART_ROWS:
        return None
    above = [max(float(square[rows].mean()) - 1.0, LEAST_EXCESS) for rows in inside]
    place = int(np.argmax(above))
    return (float(edges[place]), float(edges[place + 1])) if above[place] > CONCENTRATION * min(above) else None
