"""The figures of a run: loci on the sphere, magnitude, residuals. Each draws on the figure it is handed."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.report.style import AXES, LINE, MUTED, TEXT, ink, short
from labcal.geometry import unit
from labcal.record import Run

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

Array = NDArray[np.float64]
MOST_POINTS = 6000
MOST_NAMES = 40  # of segments, beyond which none is named in a figure
NEAR_DEG = 20.0  # a direction counts as covered when the field pointed this near to it


def coverage(field: Array) -> float:
    """Share of the sphere's directions within NEAR_DEG of a measured one; `field` (n, 3), NaN and zero left out."""
    seen = _directions(field)
    directions = _even_directions(600)
    nearest = np.max(directions @ seen[:: max(1, len(seen) // 3000)].T, axis=1) if len(seen) else np.zeros(1)
    return float(np.mean(nearest >= np.cos(np.radians(NEAR_DEG))))


def draw_sphere(figure: FigureBase, run: Run, field: Array) -> None:
    """Directions of `field` (n, 3) in B on an equal-area map of the sphere, one colour and mark a segment."""
    axes = figure.add_subplot(projection="hammer")
    for index, segment in enumerate(run.segments):
        b = _directions(field[run.rows(index)])
        b = b[thin(len(b))]
        colour, marker = ink(index)
        longitude, latitude = np.arctan2(b[:, 1], b[:, 0]), np.arcsin(np.clip(b[:, 2], -1, 1))
        axes.scatter(longitude, latitude, s=5, c=colour, marker=marker, lw=0, label=short(segment.id), rasterized=True)
    for name, place in {
        "+x": (0, 0),
        "+y": (np.pi / 2, 0),
        "−y": (-np.pi / 2, 0),
        "+z": (0, np.pi / 2),
        "−z": (0, -np.pi / 2),
    }.items():
        axes.annotate(
            name,
            place,
            color=TEXT,
            ha="center",
            va="center",
            weight="bold",
            fontsize=8,
            bbox={"fc": "white", "ec": "none", "alpha": 0.75, "pad": 1},
        )
    axes.set_xticklabels([])
    axes.set_yticklabels([])
    if len(run.segments) <= MOST_NAMES:
        figure.legend(loc="outside right upper", markerscale=2, handletextpad=0.2, fontsize=7)


def draw_magnitude(figure: FigureBase, run: Run, field: Array | None) -> None:
    """|field| over time: the raw reading, the calibrated one, and the reference."""
    axes = figure.subplots()
    t, rows = run.t_s - run.t_s[0], thin(len(run))
    series = [("reading × nominal", np.linalg.norm(run.reading_nT, axis=1), LINE if field is not None else AXES[2])]
    if field is not None:
        series.append(("calibrated", np.linalg.norm(field, axis=1), AXES[2]))
    if run.reference.kind != "none":
        series.append(("reference", run.magnitude_nT, AXES[0]))
    for name, values, colour in series:
        axes.plot(t[rows], values[rows] / 1000, ".", ms=1.6, color=colour, label=name, rasterized=True)
    axes.set(xlabel="time (s)", ylabel="|b| (µT)")
    segment_bounds(axes, run.t_s, run.segment_index)
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, markerscale=5, handletextpad=0.2)


def draw_residual(figure: FigureBase, run: Run, residual: Array, labels: tuple[str, ...]) -> None:
    """Residual (n, 3) or (n, 1) [nT] over time, and how it is distributed."""
    over_time, spread = figure.subplots(1, 2, width_ratios=(3, 1), sharey=True)
    t, rows = run.t_s - run.t_s[0], thin(len(run))
    for values, label, colour in zip(residual.T, labels, AXES if len(labels) == 3 else AXES[2:], strict=True):
        over_time.plot(t[rows], values[rows], ".", ms=1.8, color=colour, label=label, rasterized=True)
        spread.hist(values[np.isfinite(values)], bins=50, orientation="horizontal", histtype="step", color=colour, lw=1)
    limit = 1.1 * float(np.nanquantile(np.abs(residual), 0.999)) or 1.0
    over_time.set(xlabel="time (s)", ylabel="residual (nT)", ylim=(-limit, limit))
    spread.set(xlabel="samples")
    segment_bounds(over_time, run.t_s, run.segment_index)
    if len(labels) > 1:
        over_time.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=3, markerscale=5, handletextpad=0.2)


def draw_by_segment(figure: FigureBase, run: Run, residual: Array, noise_nT: float | None) -> None:
    """Rms of the residual's length in each segment, with the declared noise as a line."""
    axes = figure.subplots()
    length = np.linalg.norm(residual, axis=1)
    rms = [_rms(length[run.rows(i)]) for i in range(len(run.segments))]
    places = np.arange(len(rms))
    axes.bar(places, rms, color=AXES[2], width=0.62)
    if len(rms) <= MOST_NAMES:
        many = len(rms) > 6
        axes.set_xticks(
            places, [short(s.id) for s in run.segments], rotation=30 * many, ha="right" if many else "center"
        )
    else:
        axes.set(xlabel="segments, in order of time")
    axes.set(ylabel="rms (nT)")
    axes.grid(axis="x", visible=False)
    if noise_nT:
        floor = noise_nT * np.sqrt(residual.shape[1])
        axes.axhline(floor, color=AXES[0], lw=1, ls="--", label="the sensor's declared noise")
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0))


def segment_bounds(axes: Axes, t_s: Array, segment: NDArray[np.intp]) -> None:
    """A faint line wherever the segment (n,) changes along the time (n,)."""
    for row in np.flatnonzero(np.diff(segment)):
        axes.axvline((t_s[row] + t_s[row + 1]) / 2 - t_s[0], color=MUTED, lw=0.4, alpha=0.4)
    axes.margins(x=0.01)


def thin(count: int) -> NDArray[np.intp]:
    """Evenly chosen rows of `count`, at most MOST_POINTS."""
    return np.arange(0, count, max(1, -(-count // MOST_POINTS)))


def _even_directions(count: int) -> Array:
    """Unit vectors (count, 3) spread evenly: the Fibonacci lattice."""
    i = np.arange(count) + 0.5
    z, turn = 1 - 2 * i / count, np.pi * (1 + np.sqrt(5)) * i
    r = np.sqrt(1 - z**2)
    return np.column_stack([r * np.cos(turn), r * np.sin(turn), z])


def _directions(field: Array) -> Array:
    """Unit vectors (m, 3) of those rows (n, 3) that have a direction."""
    length = np.linalg.norm(field, axis=1)
    return unit(field[np.isfinite(length) & (length > 0)])


def _rms(values: Array) -> float:
    seen = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(seen**2))) if len(seen) else 0.0
