"""A calibration beside the specification that was chosen before it was measured: one line for each figure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace

from labcal.model import Calibration
from labcal.record import Run, Specification
from labcal.uncertainty.conformity.decision import Judged, Measured, finite, judge
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map
from labcal.uncertainty.conformity.of_the_run import figures_of_the_run

LEFT_OPEN = "Of the specification: "
ORDER = ("pass", "conditional-pass", "conditional-fail", "fail")  # the best first


@dataclass(frozen=True, slots=True)
class Assessment:
    """The lines that were judged, and in a sentence each what the specification limits and nothing determined.

    `k_means` says what the offsets belong to, as "at i_eps = 0.0532 A"; empty where they belong to any state.
    """

    lines: tuple[Judged, ...]
    left_open: tuple[str, ...]
    k_means: str = ""

    @property
    def worst(self) -> str | None:
        """The worst result of all lines; None where none was judged."""
        return max((line.result for line in self.lines), key=ORDER.index, default=None)


def assess(calibration: Calibration, specification: Specification, run: Run | None) -> Assessment:
    """Judge every figure that `specification` limits; noise, linearity and residual need the `run`."""
    measured = [*figures_of_the_map(calibration), *(figures_of_the_run(calibration, run) if run is not None else ())]
    lines, left_open = list[Judged](), list[str]()
    for name, limit in specification.limits.items():
        known = [one for one in measured if one.figure == name and finite(one)]
        lines += [judge(one, limit, specification) for one in known]
        if not known:
            left_open.append(f"{LEFT_OPEN}{name.replace('_', '-')}, which {_why_open(measured, name, run)}.")
    return Assessment(tuple(lines), tuple(left_open), calibration.k_means())


def _why_open(measured: Sequence[Measured], name: str, run: Run | None) -> str:
    if any(one.figure == name for one in measured):
        return "has no uncertainty here"
    return "only the run shows, and it is not at hand" if run is None else "this run does not determine"


def with_conformity(calibration: Calibration, run: Run) -> Calibration:
    """The calibration with the lines of the specification that `run` was recorded under, if it was under one."""
    if run.specification is None:
        return calibration
    found = assess(calibration, run.specification, run)
    return replace(
        calibration,
        specification=tuple(asdict(line) for line in found.lines),
        not_covered=(*calibration.not_covered, *found.left_open),
    )


def stated_lines(calibration: Calibration) -> tuple[Judged, ...]:
    """The lines that the calibration states."""
    return tuple(Judged(**line) for line in calibration.specification)
