"""What a study says as a whole: its table, point by point of the grid, and the answer in one sentence."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from labcal.study.job import Cell, Job, Row
from labcal.study.specification import Blind, Design, FleetStudy, MonteCarlo, Simulated

OFTEN = 0.95  # of the runs at a point have to be within an accuracy
MOVED_U = 1.0  # a figure that moves by more than its own U has changed


@dataclass(frozen=True, slots=True)
class Summary:
    """A line for each point of the grid (of a fleet: one for all), and what they answer."""

    lines: tuple[Row, ...]
    answer: str
    reached: bool  # whether what was asked for was found


def summarise(study: Simulated | FleetStudy, jobs: Sequence[Job], rows: Sequence[Row]) -> Summary:
    """The summary of the rows, which stand in the order of jobs."""
    groups = dict[tuple[tuple[str, Cell], ...], list[Row]]()
    for job, row in zip(jobs, rows, strict=True):
        point = () if isinstance(study, FleetStudy) else tuple((k, v) for k, v in job.labels.items() if k != "seed")
        groups.setdefault(point, []).append(row)
    line, answer = _of(study)
    lines = tuple({**dict(point), "jobs": len(some), **line(some)} for point, some in groups.items())
    said, reached = answer(lines)
    return Summary(lines, said, reached)


Line = Callable[[list[Row]], Row]
Answer = Callable[[tuple[Row, ...]], tuple[str, bool]]


def _of(study: Simulated | FleetStudy) -> tuple[Line, Answer]:
    match study:
        case MonteCarlo():
            return monte_carlo_line, lambda lines: _quickest(lines, study.accuracy_deg)
        case Blind():
            return blind_line, _blind_answer
        case Design():
            return design_line, _design_answer
    return fleet_line, _fleet_answer


def monte_carlo_line(rows: list[Row]) -> Row:
    """How often there is a map, and of these the error of the direction beside what the fit says of it."""
    fitted = [row for row in rows if not row["why_not"]]
    error, U = _numbers(fitted, "direction_error_deg"), _numbers(fitted, "direction_U_deg")
    both = min(len(error), len(U))
    return {
        "fitted": len(fitted), "lab_min": _median(_numbers(rows, "lab_s") / 60),
        "direction_error_median_deg": _median(error), "direction_error_95_deg": _quantile(error, OFTEN),
        "direction_U_median_deg": _median(U),
        "within_U_share": float(np.mean(error[:both] <= U[:both])) if both else None,
        "magnitude_error_95_nT": _quantile(_numbers(fitted, "magnitude_error_nT"), OFTEN),
    }  # fmt: skip


def _quickest(lines: tuple[Row, ...], accuracy_deg: float | None) -> tuple[str, bool]:
    """Of the points whose runs are accurate enough that which takes the least lab time."""
    if accuracy_deg is None:
        return "No accuracy was asked for.", True
    good = [
        line for line in lines
        if line["fitted"] == line["jobs"] and (_number(line, "direction_error_95_deg") or np.inf) <= accuracy_deg
    ]  # fmt: skip
    asked = f"{accuracy_deg:g}° in {OFTEN:.0%} of the runs"
    if not good:
        return f"No point of the grid reaches {asked}.", False
    best = min(good, key=lambda line: _number(line, "lab_min") or np.inf)
    return f"{asked} in the least lab time: {_point(best)}, {best['lab_min']:.0f} min.", True


def blind_line(rows: list[Row]) -> Row:
    """How many hidden effects were named, and how."""
    words = [str(row.get("found", "failed")) for row in rows]
    return {word: words.count(word) for word in ("right", "among others", "rival", "missed", "wrong", "failed")}


def _blind_answer(lines: tuple[Row, ...]) -> tuple[str, bool]:
    total, right, wrong = (sum(int(line[key] or 0) for line in lines) for key in ("jobs", "right", "wrong"))
    return f"{right} of {total} hidden effects were named and nothing else; {wrong} wrongly.", wrong == 0


def design_line(rows: list[Row]) -> Row:
    """The choice that most seeds made, and what it costs and gives."""
    chosen = [str(row["rotations"]) for row in rows if row.get("rotations")]
    common = max(dict.fromkeys(chosen), key=chosen.count, default=None)
    same = [row for row in rows if common and row.get("rotations") == common]
    return {
        "reached": len(chosen), "rotations": common, "chosen_by": len(same),
        "lab_min": _median(_numbers(same, "lab_s") / 60), "direction_U_deg": _median(_numbers(same, "direction_U_deg")),
        "direction_error_max_deg": _quantile(_numbers(same, "direction_error_deg"), 1.0),
        "all_lab_min": _median(_numbers(rows, "all_lab_s") / 60), "all_U_deg": _median(_numbers(rows, "all_U_deg")),
    }  # fmt: skip


def _design_answer(lines: tuple[Row, ...]) -> tuple[str, bool]:
    said = []
    for line in lines:
        if line["rotations"] is None:
            U = _number(line, "all_U_deg")
            said.append(f"{_point(line)}: not by any choice" + (f"; all rotations give {U:.3f}°." if U else "."))
        else:
            said.append(
                f"{_point(line)}: {line['rotations']}, {line['lab_min']:.1f} min (all: {line['all_lab_min']:.1f} min)."
            )
    return " ".join(said), all(line["reached"] == line["jobs"] for line in lines)


def fleet_line(rows: list[Row]) -> Row:
    """How many calibrations would move, and how far."""
    worst = np.abs(_numbers(rows, "worst_change_U"))
    return {
        "worked_out": sum(not row["why_not"] for row in rows), "moved": int(np.sum(worst > MOVED_U)),
        "worst_change_median_U": _median(worst), "worst_change_max_U": _quantile(worst, 1.0),
        "other_effects": sum(row.get("effects") != row.get("effects_before") for row in rows),
    }  # fmt: skip


def _fleet_answer(lines: tuple[Row, ...]) -> tuple[str, bool]:
    [line] = lines
    most = f"; the largest by {line['worst_change_max_U']:.2f} U" if line["worst_change_max_U"] is not None else ""
    said = f"{line['moved']} of {line['worked_out']} calibrations would move by more than their U{most}."
    return said, line["worked_out"] == line["jobs"]


def _point(line: Row) -> str:
    """Where in the grid a line is: its columns before the number of jobs."""
    labels = list(line.items())[: list(line).index("jobs")]
    return ", ".join(f"{name} = {value}" for name, value in labels) or "the only point"


def _numbers(rows: Sequence[Row], name: str) -> np.ndarray[tuple[int], np.dtype[np.float64]]:
    found = [_number(row, name) for row in rows]
    return np.array([value for value in found if value is not None], dtype=np.float64)


def _number(row: Row, name: str) -> float | None:
    value = row.get(name)
    return float(value) if isinstance(value, int | float) else None


def _median(values: np.ndarray[tuple[int], np.dtype[np.float64]]) -> float | None:
    return _quantile(values, 0.5)


def _quantile(values: np.ndarray[tuple[int], np.dtype[np.float64]], share: float) -> float | None:
    return float(np.quantile(values, share)) if len(values) else None
