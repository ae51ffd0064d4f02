"""Text in tables of comma-separated values that a spreadsheet would take for a formula and work out, or run."""

from __future__ import annotations

import csv
import io
import re

# What begins so is a formula, in full width too. After a sign, a number is a number and a plain name (+x-20uT) a name.
FORMULA = re.compile(
    "[\\t\\r]|[\\s\ufeff\u200b]*(?:[=@\uff1d\uff20\uff0b\uff0d]"
    "|[+-](?!(?:[0-9]+[.]?[0-9]*|[.][0-9]+)(?:[eE][+-]?[0-9]+)?\\Z)(?![\\w. -]*\\Z))"
)
MAYBE = re.compile(r"[^\w., -]")  # a line without any of these holds none


def is_formula(cell: str) -> bool:
    """Whether a spreadsheet would work `cell` out instead of showing it."""
    return not cell[:1].isalnum() and FORMULA.match(cell) is not None


def shielded(cell: str) -> str:
    """`cell`, with an apostrophe before it where it is a formula: then it is shown."""
    return f"'{cell}" if is_formula(cell) else cell


def shielded_row(line: str) -> str:
    """One row's text with each cell shielded; as it stands where none is a formula."""
    if not any(map(is_formula, cells := _cells(line))):
        return line
    out = io.StringIO()
    csv.writer(out, lineterminator="\r\n").writerow(map(shielded, cells))  # a cell that holds either is quoted
    return out.getvalue()[:-2]


def first_formula(content: str) -> tuple[int, str] | None:
    """Line (from 1) and text of the first cell of a table that is a formula; None where there is none."""
    lines = enumerate(content.split("\n"), 1)
    return next(((n, cell) for n, line in lines for cell in _cells(line) if is_formula(cell)), None)


def _cells(line: str) -> list[str]:
    """The cells of a row, none where none can be a formula; a line end is never inside one."""
    if MAYBE.search(line) is None:
        return []
    return next(csv.reader([line]), []) if '"' in line else line.split(",")
