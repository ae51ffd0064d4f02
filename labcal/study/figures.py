"""The figures of a study, each drawn on the figure that it is handed."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from labcal.certificate.report.page import Plot
from labcal.certificate.report.style import GOOD, INKS, MUTED, WARNING, ink
from labcal.study.job import Row
from labcal.study.specification import Blind, Design, FleetStudy, MonteCarlo, Simulated
from labcal.study.summary import MOVED_U, Summary

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

FOUND = ("right", "among others", "rival", "missed", "wrong", "failed")
MOST_NAMED = 12  # points of a grid that are named beside a figure


def figure_of(study: Simulated | FleetStudy, rows: Sequence[Row], summary: Summary) -> Plot | None:
    """The figure of the study's kind; None where no job gave what it would show."""
    match study:
        case MonteCarlo() if any(line["direction_error_95_deg"] is not None for line in summary.lines):
            caption = "Error of the field's direction that 95 % of the runs keep, and U as the fits say it (hollow)."
            return Plot(lambda figure: draw_monte_carlo(figure, summary, study.accuracy_deg), 2.9, caption)
        case Design() if any(line["lab_min"] is not None for line in summary.lines):
            caption = "The quickest choice for each accuracy (dots), and all rotations that were recorded (square)."
            return Plot(lambda figure: draw_design(figure, summary), 2.6, caption)
        case Blind():
            return Plot(lambda figure: draw_blind(figure, summary), 1.6, "What became of the hidden effects.")
        case FleetStudy() if any(row.get("worst_change_U") is not None for row in rows):
            caption = "Largest change of each calibration in units of its own U, the largest first."
            return Plot(lambda figure: draw_fleet(figure, rows), 2.4, caption)
    return None


def draw_monte_carlo(figure: FigureBase, summary: Summary, accuracy_deg: float | None) -> None:
    """Error over lab time, a mark for each point of the grid."""
    axes = figure.subplots()
    for index, line in enumerate(summary.lines):
        colour, marker = ink(index)
        _mark(axes, line, "lab_min", "direction_error_95_deg", color=colour, marker=marker, label=named(line))
        _mark(axes, line, "lab_min", "direction_U_median_deg", color=colour, marker=marker, fillstyle="none")
    if accuracy_deg is not None:
        axes.axhline(accuracy_deg, color=GOOD, lw=0.8, ls="--")
    axes.set(xlabel="lab time (min)", ylabel="direction (deg)", xlim=(0, None), ylim=(0, None))
    _legend(figure, len(summary.lines))


def draw_design(figure: FigureBase, summary: Summary) -> None:
    """Accuracy over lab time."""
    axes = figure.subplots()
    for index, line in enumerate(summary.lines):
        colour, marker = ink(index)
        _mark(axes, line, "lab_min", "direction_U_deg", color=colour, marker=marker, label=named(line))
        _mark(axes, line, "all_lab_min", "all_U_deg", color=MUTED, marker="s")
    axes.set(xlabel="lab time (min)", ylabel="U of the direction (deg)", xlim=(0, None), ylim=(0, None))
    _legend(figure, len(summary.lines))


def draw_blind(figure: FigureBase, summary: Summary) -> None:
    """One bar for each point of the grid."""
    axes = figure.subplots()
    left = np.zeros(len(summary.lines))
    for word, colour in zip(FOUND, (GOOD, INKS[5], INKS[4], MUTED, WARNING, "#000000"), strict=True):
        wide = np.array([float(line[word] or 0) for line in summary.lines])
        axes.barh(np.arange(len(left)), wide, left=left, color=colour, label=word)
        left += wide
    axes.set(xlabel="trials", yticks=np.arange(len(left)), yticklabels=[named(line) for line in summary.lines])
    axes.invert_yaxis()
    figure.legend(loc="outside right upper", fontsize=7)


def draw_fleet(figure: FigureBase, rows: Sequence[Row]) -> None:
    """One bar for each calibration."""
    axes = figure.subplots()
    moved = sorted((abs(float(v)) for row in rows if isinstance(v := row.get("worst_change_U"), float)), reverse=True)
    axes.bar(np.arange(len(moved)), moved, color=[WARNING if m > MOVED_U else INKS[0] for m in moved])
    axes.axhline(MOVED_U, color=GOOD, lw=0.8, ls="--")
    axes.set(xlabel="calibrations", ylabel="change (U)", xticks=[])


def named(line: Row) -> str:
    """Where in the grid a line is, by its values."""
    labels = list(line.items())[: list(line).index("jobs")]
    return ", ".join(f"{name.rpartition('.')[2].replace('_', ' ')} {value}" for name, value in labels) or "all"


def _mark(axes: Axes, line: Row, x: str, y: str, **how: str) -> None:
    if line[x] is not None and line[y] is not None:
        axes.plot([float(line[x] or 0)], [float(line[y] or 0)], ls="none", **how)  # type: ignore[arg-type]


def _legend(figure: FigureBase, points: int) -> None:
    if points <= MOST_NAMED:
        figure.legend(loc="outside right upper", handletextpad=0.2, fontsize=7)
