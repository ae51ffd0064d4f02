"""The uncertainty budget on paper: every quantity with its U, the largest in full, and the shares as a picture."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from labcal.certificate.indications import Indication, indications
from labcal.certificate.report.page import Block, Plot, Table
from labcal.certificate.report.style import (
    NOTHING,
    TEXT,
    decimals_for,
    ink,
    number,
    printed_unit,
    two_digits,
    with_uncertainty,
    with_unit,
)
from labcal.model import Calibration
from labcal.model.calibration import units_of_channels
from labcal.record import Run

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

One = Mapping[str, Any]
OF_THE_FIELD = "b "  # begins the quantities that are components of the field
SMALL = 0.01  # share of the variance from which a source has a name in the overview and the picture
MANY = 1e4  # degrees of freedom beyond which they are as good as infinite
BAR_IN = 0.17


def field_blocks(c: Calibration) -> list[Block]:
    """U of the field's components over the working range; nothing without a budget."""
    field = [b for b in c.budget if b["quantity"].startswith(OF_THE_FIELD)]
    return [_field_table(field, units_of_channels(c.effects))] if field else []


def indication_blocks(c: Calibration, run: Run | None) -> list[Block]:
    """The sensor as it came: what it indicates of the largest fields, before correction; nothing without the run."""
    found = indications(c, run) if run else []
    rows = [row for one in found for row in _indicated(one)]
    unit = (
        "its reading"
        if c.dut.unit == "nT"
        else f"its reading times {c.dut.nominal_nT_per_unit:g} nT, the nominal value"
    )
    at = f", {c.k_means()}" if c.k_means() else ""
    note = f"Before correction{at}: what it indicates is {unit}; components in its own axes. U is that of the error."
    header = ("Field", "Component", "Applied (nT)", "Indicated (nT)", "Error (nT)", "U (nT)", "k")
    return [Table(header, tuple(rows), frozenset({2, 3, 4, 5, 6}), note)] if rows else []


def _indicated(one: Indication) -> Iterator[tuple[str, ...]]:
    """A row for each component, all numbers to the place of U."""
    values = zip("xyz", one.field_nT, one.indicated_nT, one.error_nT, one.U_nT, strict=True)
    for axis, applied, indicated, error, U in values:
        said = [with_uncertainty(float(value), float(U))[0] for value in (applied, indicated, error)]
        yield one.at if axis == "x" else "", f"b {axis}", *said, two_digits(float(U)), f"{one.k:.2f}"


def budget_blocks(c: Calibration) -> list[Block]:
    """Overview of the sensor's figures, the largest quantity of each kind in full, the picture; none without one."""
    if not c.budget:
        return []
    field = [b for b in c.budget if b["quantity"].startswith(OF_THE_FIELD)]
    figures = [b for b in c.budget if b not in field]
    in_full = [max(same, key=lambda b: b["U"]) for same in _of_one_kind(field, figures)]
    drawn = [*field[:9], *figures]
    picture = Plot(
        lambda figure: draw_shares(figure, drawn), 0.9 + BAR_IN * len(drawn), "What makes up the variance of each."
    )
    return [_figures_table(figures), picture, *(_rows_table(one, units_of_channels(c.effects)) for one in in_full)]


def _of_one_kind(field: Sequence[One], figures: Sequence[One]) -> list[list[One]]:
    kinds = [list(field), *([b for b in figures if b["quantity"].startswith(w)] for w in ("scale", "zero", "off"))]
    return [kind for kind in kinds if kind]


def _field_table(field: Sequence[One], units: Mapping[str, str]) -> Table:
    """A row a point: U of each component."""
    rows = []
    for point in dict.fromkeys(b["at"] for b in field):
        of_point = [b for b in field if b["at"] == point]
        worst = max(of_point, key=lambda b: b["U"])
        k = _k(worst) if len({_k(b) for b in of_point}) == 1 else ", ".join(map(_k, of_point))
        rows.append((_with_units(point, units), *(two_digits(b["U"]) for b in of_point), k, largest(worst)))
    header = ("At", "U(b x) (nT)", "U(b y) (nT)", "U(b z) (nT)", "k", "Largest contributions (to the largest U)")
    note = "U of each component of the field from one reading; about 95 %. Every budget is in the file."
    return Table(header, tuple(rows), frozenset({1, 2, 3, 4}), note)


def _figures_table(figures: Sequence[One]) -> Table:
    rows = tuple(
        (b["quantity"], b["at"] or NOTHING, two_digits(b["U"]), _k(b), printed_unit(b["unit"]), largest(b))
        for b in figures
    )
    return Table(("Figure", "At", "U", "k", "Unit", "Largest contributions"), rows, frozenset({2, 3}))


def _rows_table(b: One, units: Mapping[str, str]) -> Table:
    """One budget in full, the largest contribution first (GUM, 7.2.7)."""
    rows = tuple(
        (
            row["source"],
            row["type"],
            row["distribution"],
            with_unit(number(row["u"], decimals_for([row["u"]])), row["unit"]),
            f"{row['sensitivity']:.3g}".replace("-", "−"),
            number(abs(row["u"] * row["sensitivity"]), decimals_for([b["U"]]) + 1),
            f"{100 * row['share']:.1f} %",
            dof_text(row["dof"]),
        )
        for row in sorted(b["rows"], key=lambda row: -row["share"])
    )
    at = f" at {_with_units(b['at'], units)}" if b["at"] else ""
    unit = printed_unit(b["unit"])
    U, dof = with_unit(two_digits(b["U"]), b["unit"]), dof_text(b["dof"])
    said = f"{b['quantity']}{at}: U = {U}, k = {_k(b)}, effective degrees of freedom {dof}."
    if pairs := ", ".join(f"{c['one']} and {c['other']} {c['r']:+.2f}".replace("-", "−") for c in b["correlations"]):
        said += f" The sources are independent; of the fitted parameters these are correlated: {pairs}."
    header = ("Source", "Type", "Distribution", "u", "Sensitivity", f"|c·u| ({unit})", "Share", "DoF")
    return Table(header, rows, frozenset({3, 4, 5, 6, 7}), said)


def _with_units(at: str, units: Mapping[str, str]) -> str:
    """A point in words with the units of its channels, where a file states their numbers alone; no line ends in one."""
    for name, unit in units.items():
        at = re.sub(rf"(?<= {re.escape(name)} = )[^ ,]+(?=,|$)", f"\\g<0>\u00a0{unit}", at)
    return at.replace(" = ", "\u00a0=\u00a0")


def largest(b: One, most: int = 2) -> str:
    """The largest contributions in words, as "reference zero z 88 %"."""
    rows = sorted(b["rows"], key=lambda row: -row["share"])[:most]
    return ", ".join(f"{row['source']} {100 * row['share']:.0f}\u00a0%" for row in rows if row["share"] > SMALL)


def dof_text(dof: float | None) -> str:
    """Degrees of freedom as they are printed: rounded down (GUM, G.4.1), ∞ for very many."""
    return "∞" if dof is None or dof > MANY else f"{int(dof)}"


def _k(b: One) -> str:
    return f"{b['k']:.2f}"


def draw_shares(figure: FigureBase, drawn: Sequence[One]) -> None:
    """A bar each quantity, in its sources' shares of the variance; sources that differ in the axis alone are one."""
    axes = figure.subplots()
    sources = dict.fromkeys(_kind(row["source"]) for b in drawn for row in b["rows"] if row["share"] > SMALL)
    left = [0.0] * len(drawn)
    for place, source in enumerate(sources):
        parts = [sum(row["share"] for row in b["rows"] if _kind(row["source"]) == source) for b in drawn]
        axes.barh(range(len(drawn)), parts, left=left, height=0.72, color=ink(place)[0], label=source)
        left = [at + part for at, part in zip(left, parts, strict=True)]
    names = [f"{b['quantity']}, {b['at']}" if b["quantity"].startswith(OF_THE_FIELD) else b["quantity"] for b in drawn]
    axes.set_yticks(range(len(drawn)), names, color=TEXT)
    axes.invert_yaxis()
    axes.set(xlim=(0, 1), xlabel="share of the variance")
    axes.grid(axis="y", visible=False)
    axes.legend(loc="lower center", bbox_to_anchor=(0.4, 1.0), ncols=2, handlelength=1.2)


def _kind(source: str) -> str:
    """The source without its axis: "reference zero x" is a reference zero."""
    for end in (*(f" about {a}" for a in "xyz"), *(f" {a}" for a in "xyz")):
        source = source.removesuffix(end)
    return source
