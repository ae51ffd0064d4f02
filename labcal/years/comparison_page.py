"""The page of a comparison of benches by a travelling standard."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from labcal.certificate.report.page import Facts, Mark, Page, Plot, Table, section, sections
from labcal.certificate.report.style import BAD, GOOD, INKS, NOTHING, decimals_for, number
from labcal.quality.intercomparison import Intercomparison
from labcal.version import __version__

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

E_N = "E_n = difference / U of the difference, k = 2: beyond ±1 they do not agree."


def comparison_page(serial: str, found: Mapping[str, tuple[str, Intercomparison]], simulated: bool) -> Page:
    """E_n of every bench and figure, and how well those agree that make the reference value."""
    worst = [(abs(d.e_n), name, d) for name, (_, one) in found.items() for d in one.degrees if d.e_n is not None]
    size, figure, degree = max(worst, key=lambda one: one[0])
    beyond = sum(size > 1 for size, _, _ in worst)
    most = f"the largest is {degree.e_n:+.2f} ({degree.bench}, {figure})"
    said = f"{beyond} of {len(worst)} results are beyond ±1; {most}." if beyond else f"All agree; {most}."
    consistency = tuple(
        (name, one.by, f"{one.chi2:.2f}", str(one.dof), f"{one.p:.3f}") for name, (_, one) in found.items()
    )
    heads = ("Figure", "Reference", "χ²", "dof", "p")
    return Page(
        kind="Comparison",
        title=f"Benches compared by {serial}",
        subtitle=", ".join(sorted({d.bench for _, one in found.values() for d in one.degrees})),
        simulated=simulated,
        marks=(Mark(f"|E_n| ≤ {size:.2f}", "bad" if size > 1 else "good"),),
        summary=said,
        facts=Facts((("Worked out by", f"labcal {__version__}"),)),
        sections=sections(
            section("Degrees of equivalence", [Plot(lambda drawn: draw_e_n(drawn, found), 2.6, E_N), _table(found)]),
            section("Reference values", [Table(heads, consistency, frozenset({2, 3, 4}))]),
        ),
    )


def _table(found: Mapping[str, tuple[str, Intercomparison]]) -> Table:
    rows = []
    for name, (unit, one) in found.items():
        decimals = decimals_for([d.U for d in one.degrees])
        for d in one.degrees:
            numbers = (number(x, decimals) for x in (d.value, d.reference, d.difference, d.U))
            e_n = NOTHING if d.e_n is None else f"{d.e_n:+.2f}"
            rows.append((name, d.bench, *numbers, unit, e_n, "" if d.counted else "not in the reference"))
    header = ("Figure", "Bench", "Value", "Reference", "Difference", "U", "Unit", "E_n", "")
    return Table(header, tuple(rows), frozenset({2, 3, 4, 5, 7}), E_N)


def draw_e_n(figure: FigureBase, found: Mapping[str, tuple[str, Intercomparison]]) -> None:
    """E_n of every result, a colour for each bench."""
    axes = figure.subplots()
    benches = list(dict.fromkeys(d.bench for _, one in found.values() for d in one.degrees))
    for bench, colour in zip(benches, INKS * (len(benches) // len(INKS) + 1), strict=False):
        points = [(i, d.e_n) for i, (_, one) in enumerate(found.values()) for d in one.degrees if d.bench == bench]
        x, y = zip(*((i, e) for i, e in points if e is not None), strict=True)
        shift = 0.08 * (benches.index(bench) - (len(benches) - 1) / 2)
        axes.plot(np.array(x) + shift, y, "o", ms=4, color=colour, label=bench)
    for bound in (-1, 1):
        axes.axhline(bound, color=BAD, lw=0.8, ls="--")
    axes.axhline(0, color=GOOD, lw=0.8)
    axes.set(ylabel="E_n")
    axes.set_xticks(range(len(found)), [name.replace("non-orthogonality", "angle") for name in found], rotation=30)
    figure.legend(loc="outside right upper", fontsize=7)
