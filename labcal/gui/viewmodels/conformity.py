"""A calibration's lines of specification, and what changed since the one before, as rows of a table."""

from __future__ import annotations

from collections.abc import Sequence

from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.calibration_rows import NONE, Cell
from labcal.gui.viewmodels.number_format import decimals_for, format_number, short_number
from labcal.uncertainty.conformity import Changes, Judged, ratio_in_words, risk_in_words

SPECIFICATION = ("figure", "value", "± U", "limit ±", "unit", "result", "risk", "TUR")
CHANGES = ("figure", "as found", "as left", "± U", "unit", "E_n", "")
RESULTS = {  # shape, word, colour's name; the best first
    "pass": ("✓", "PASS", "good"),
    "conditional-pass": ("▲", "conditional pass", "warning"),
    "conditional-fail": ("▼", "conditional fail", "warning"),
    "fail": ("✕", "FAIL", "bad"),
}
IN_ALL = {
    "pass": "In specification",
    "conditional-pass": "In specification, conditionally",
    "conditional-fail": "Not in specification, conditionally",
    "fail": "Not in specification",
}


def verdict(lines: Sequence[Judged]) -> str:
    """All lines in a word with its shape: that of the worst; a plain question where there are none."""
    worst = max((line.result for line in lines), key=list(RESULTS).index, default=None)
    if worst is None:
        return translated("In specification?")
    return f"{RESULTS[worst][0]} {translated(IN_ALL[worst])}"


def specification_rows(lines: Sequence[Judged]) -> list[list[Cell]]:
    """A row for each line, under `SPECIFICATION`."""
    return [_line(line) for line in lines]


def rule_of(lines: Sequence[Judged]) -> str:
    """The rule that decided, and what the risk is."""
    rules = "; ".join(dict.fromkeys(line.rule for line in lines))
    risk = translated("Risk: how probably the true value is beyond its limit.")
    return f"{rules}. {risk}" if rules else ""


def change_rows(found: Changes, *, alike: bool = True) -> list[list[Cell]]:
    """A row for each figure, under `CHANGES`; of results that are not of one kind none is said to have changed."""
    rows = []
    for row in found.rows:
        decimals = decimals_for(row.U or 0.0, row.left)
        U = "–" if row.U is None else format_number(row.U, decimals, signed=False)
        e_n = "–" if row.e_n is None else format_number(row.e_n, 2)
        numbers = [format_number(value, decimals) for value in (row.found, row.left)]
        moved = Cell(f"▲ {translated('changed')}", state="warning") if row.changed and alike else Cell("")
        right = [Cell(text, right=True) for text in (*numbers, U)]
        rows.append([Cell(in_words(row.quantity)), *right, Cell(row.unit or NONE), Cell(e_n, right=True), moved])
    return rows


def _line(line: Judged) -> list[Cell]:
    decimals = decimals_for(line.U, line.value)
    shape, word, state = RESULTS[line.result]
    return [
        Cell(in_words(line.quantity)),
        Cell(format_number(line.value, decimals), right=True),
        Cell(format_number(line.U, decimals, signed=False), right=True),
        Cell(short_number(line.limit), right=True),
        Cell(line.unit),
        Cell(f"{shape} {translated(word)}", state=state),
        Cell(risk_in_words(line.risk), right=True),
        Cell(ratio_in_words(line.tur), right=True),
    ]
