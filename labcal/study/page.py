"""The report of a study for people: the answer, the figure, a line for each point, and what could not be done."""

from __future__ import annotations

import math
from collections.abc import Sequence

from labcal.certificate.report.page import Facts, Page, Prose, Table, section, sections
from labcal.certificate.report.style import NOTHING, number
from labcal.study.figures import figure_of
from labcal.study.job import Cell, Job, Row
from labcal.study.specification import FleetStudy, Simulated
from labcal.study.summary import Summary
from labcal.study.table import columns
from labcal.version import __version__

MOST_FAULTS = 20
WORDS = {
    "monte-carlo": "Monte Carlo of a calibration",
    "blind": "Blind trials of the loop",
    "design": "Rotations for the least lab time",
    "fleet": "A fleet worked out again",
}


def study_page(
    study: Simulated | FleetStudy,
    name: str,
    jobs: Sequence[Job],
    rows: Sequence[Row],
    summary: Summary,
    remarks: list[str],
) -> Page:
    """The page of a study that is done; nothing on it tells how long the computer took."""
    faults = [f"{job.name}: {row['why_not']}" for job, row in zip(jobs, rows, strict=True) if row.get("why_not")]
    more = [f"and {len(faults) - MOST_FAULTS} more"] if len(faults) > MOST_FAULTS else []
    simulated = not isinstance(study, FleetStudy)
    return Page(
        kind="Study",
        title=WORDS[study.kind],
        subtitle=name,
        simulated=simulated,
        summary=summary.answer,
        facts=Facts((("Kind", study.kind), ("Jobs", str(len(jobs))), ("Worked out by", f"labcal {__version__}"))),
        sections=sections(
            section("What it shows", [figure_of(study, rows, summary)]),
            section("Point by point", [table_of(summary.lines)]),
            section("What was left out", [Prose(tuple(remarks))] if remarks else []),
            section("What gave no result", [Prose((*faults[:MOST_FAULTS], *more))] if faults else []),
        ),
        footer="Every job is a row of table.csv beside this page.",
    )


def table_of(lines: Sequence[Row]) -> Table:
    """The summary's lines; a unit stands in the name of its column."""
    names = columns(lines)
    cells = tuple(tuple(cell_text(line.get(name)) for name in names) for line in lines)
    numeric = (i for i, name in enumerate(names) if not any(isinstance(line.get(name), str) for line in lines))
    return Table(tuple(map(heading, names)), cells, frozenset(numeric))


def heading(name: str) -> str:
    """The name of a column as words: "direction error 95 (deg)"."""
    words, _, unit = name.rpartition("_")
    if "." in name or unit not in ("deg", "nT", "min", "s", "U"):
        return name.replace("_", " ") if "." not in name else name
    return f"{words.replace('_', ' ')} ({unit})"


def cell_text(value: Cell) -> str:
    """A cell for people: three digits that count."""
    if value is None:
        return NOTHING
    if not isinstance(value, float):
        return str(value)
    if value == 0 or not math.isfinite(value):
        return number(value, 0)
    return number(value, max(0, 2 - math.floor(math.log10(abs(value)))))
