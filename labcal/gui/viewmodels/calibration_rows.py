"""A calibration's figures, its parameters and its budget, as rows of a table."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import BudgetLine, CalibrationFile, Figure
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import in_words, name_in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.cause_words import in_plain_words
from labcal.gui.viewmodels.gain_words import GAINS, gain_name
from labcal.gui.viewmodels.largest_of_U import how_to_lower_U, largest_of_U
from labcal.gui.viewmodels.number_format import decimals_for, format_number

SHORT = QT_TRANSLATE_NOOP(
    "Words",
    "By the method {0}. Zero reading: what the sensor indicates in no field; the offset k of b = K m − k is under Map.",
)
CLOSED = "closed-loop"  # as a calibration file has it
NONE = "1"  # the unit of what has none
PARAMETERS = ("parameter", "value", "± U", "unit")


@dataclass(frozen=True, slots=True)
class Cell:
    """A cell: its text, whether it stands right, its colour by the name of a state ("": none), and its tip."""

    text: str
    right: bool = False
    state: str = ""
    tip: str = ""


def short_rows(one: CalibrationFile) -> list[list[Cell]]:
    """Offsets, scale factors and angles as people follow them; of a file that states none, its map."""
    return [_figure(figure) for figure in one.figures] or map_rows(one)


def method_words(one: CalibrationFile) -> str:
    """The method that made it, as people say it; "" where the file does not say."""
    return translated("closed loop") if one.method == CLOSED else one.method


def short_remark(one: CalibrationFile) -> str:
    """What makes most of U, by which method the figures in short are, and what they are not."""
    said = translated(str(SHORT)).format(method_words(one)) if one.method and one.figures else ""
    return "\n".join(filter(None, (f"{largest_of_U(one)} {how_to_lower_U(one)}".strip(), said)))


def map_rows(one: CalibrationFile) -> list[list[Cell]]:
    """A row for each parameter of the map, k then K row by row."""
    u: tuple[float | None, ...] = one.u or (None,) * 12
    gain = NONE if one.dut.unit == "nT" else f"nT/{one.dut.unit}"
    rows = [
        _parameter(f"{translated('offset k')} {axis} {in_words(one.k_means)}".rstrip(), value, u[9 + n], "nT")
        for n, (axis, value) in enumerate(zip("xyz", one.k_nT, strict=True))
    ]
    K = zip((gain_name(*gain) for gain in GAINS), (v for row in one.K for v in row), u, strict=False)
    return rows + [_parameter(name, value, s, gain) for name, value, s in K]


def cause_rows(one: CalibrationFile) -> list[list[Cell]]:
    """A row for each parameter of what is corrected, or found, beside the map."""
    named = ((in_plain_words(effect, one.phrases), effect) for effect in (*one.effects, *one.findings))
    return [_parameter(f"{name} {p.name}", p.value, p.u, p.unit) for name, effect in named for p in effect.parameters]


def budget_rows(budget: Sequence[BudgetLine]) -> list[list[Cell]]:
    """A row for each quantity: what makes most of its U, and U; all that makes it where one points at it."""
    return [_budgeted(line) for line in budget]


def _figure(figure: Figure) -> list[Cell]:
    u = None if figure.U is None else figure.U / 2
    return _parameter(name_in_words(figure.quantity), figure.value, u, figure.unit)


def _parameter(name: str, value: float, u: float | None, unit: str) -> list[Cell]:
    decimals = decimals_for(2 * (u or 0.0), value)
    U = "–" if u is None else format_number(2 * u, decimals, signed=False)
    return [Cell(name), Cell(format_number(value, decimals), right=True), Cell(U, right=True), Cell(unit or NONE)]


def _budgeted(line: BudgetLine) -> list[Cell]:
    shares = [f"{name_in_words(source)} {format_number(100 * share, signed=False)} %" for source, share in line.sources]
    quantity, at = name_in_words(line.quantity), name_in_words(line.at)
    tip = "\n".join([f"{quantity} {at}".rstrip(), f"k = {format_number(line.k, 2, signed=False)}", *shares])
    U = format_number(line.U, decimals_for(line.U, line.U), signed=False)
    name = f"{quantity} · {at}" if at else quantity
    return [
        Cell(with_head(name, shares[0]) if shares else name, tip=tip),  # where the column takes what room there is
        Cell("–", right=True, tip=tip),
        Cell(U, right=True, tip=tip),
        Cell(line.unit),
    ]
