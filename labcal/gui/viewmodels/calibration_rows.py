"""A calibration's parameters and its budget, as rows of a table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from labcal.gui.ipc.answers import BudgetLine, CalibrationFile
from labcal.gui.translations.sentences import in_words, name_in_words
from labcal.gui.viewmodels.number_format import decimals_for, format_number
from labcal.gui.viewmodels.study import cause_name

PARAMETERS = ("parameter", "value", "± U", "unit")


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell: its text, whether it stands right, its colour by the name of a state ("": none), and its tip."""

    text: str
    right: bool = False
    state: str = ""
    tip: str = ""


def parameter_rows(one: CalibrationFile) -> list[list[Cell]]:
    """A row for each parameter of map and effects, then for each quantity of the budget, under `PARAMETERS`."""
    u: tuple[float | None, ...] = one.u or (None,) * 12
    gain = f"nT/{one.dut.unit}"
    rows = [
        _parameter(f"k {axis} {in_words(one.k_means)}".rstrip(), value, u[9 + n], "nT")
        for n, (axis, value) in enumerate(zip("xyz", one.k_nT, strict=True))
    ]
    K = zip((f"K {a}{b}" for a in "xyz" for b in "xyz"), (v for row in one.K for v in row), u, strict=False)
    rows += [_parameter(name, value, s, gain) for name, value, s in K]
    for effect in (*one.effects, *one.findings):
        name = cause_name(effect.effect, effect.channels)
        rows += [_parameter(f"{name} {p.name}", p.value, p.u, p.unit) for p in effect.parameters]
    return rows + budget_rows(one.budget)


def budget_rows(budget: Sequence[BudgetLine]) -> list[list[Cell]]:
    """A row for each quantity: what makes most of its U, and U; all that makes it where one points at it."""
    return [_budgeted(line) for line in budget]


def _parameter(name: str, value: float, u: float | None, unit: str) -> list[Cell]:
    decimals = decimals_for(2 * (u or 0.0), value)
    U = "–" if u is None else format_number(2 * u, decimals, signed=False)
    return [Cell(name), Cell(format_number(value, decimals), right=True), Cell(U, right=True), Cell(unit)]


def _budgeted(line: BudgetLine) -> list[Cell]:
    shares = [f"{name_in_words(source)} {format_number(100 * share, signed=False)} %" for source, share in line.sources]
    quantity, at = name_in_words(line.quantity), name_in_words(line.at)
    tip = "\n".join([f"{quantity} {at}".rstrip(), f"k = {format_number(line.k, 2, signed=False)}", *shares])
    U = format_number(line.U, decimals_for(line.U, line.U), signed=False)
    name = f"{quantity} · {at}" if at else quantity
    return [
        Cell(f"{name}: {shares[0]}" if shares else name, tip=tip),  # here, where the column is as wide as there is room
        Cell("–", right=True, tip=tip),
        Cell(U, right=True, tip=tip),
        Cell(line.unit),
    ]
