"""The report of a fleet: what is worst, how figures are spread, who stands out, what effects which batches have."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import TYPE_CHECKING, Any

import numpy as np

from labcal.certificate.report.page import Facts, Page, Plot, Prose, Table, section, sections
from labcal.certificate.report.style import BAD, INKS, MUTED, with_uncertainty
from labcal.quality.batches import Batch
from labcal.version import __version__
from labcal.years.fleet import OUTLIER, Fleet, OfBatches, Spread

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import FigureBase

MOST_OUTLIERS, MOST_BATCHES, MOST_DRAWN = 40, 12, 8
COVERAGE = 2.0
POOLED = (
    "Each batch is drawn towards what its model has in common, the more the less it says by itself (REML within, the "
    "spread of batches integrated over its likelihood). U is 2 u (k = 2).",
    "A sensor in which the effect was not found counts as 0, with the median u of those in which it was.",
    "All such sensors of a batch may hide as much as the smallest that was found: U is wider by that.",
)


def fleet_page(found: Fleet) -> Page:
    """The page, the worst of everything first."""
    models = ", ".join(f"{model} ({sum(batches.values())})" for model, batches in found.batches.items())
    plots = [_plot_of_figures(model, found) for model in found.batches]
    effects = [_plot_of_effect(one) for one in found.effects[:MOST_DRAWN]]
    remarks = POOLED if found.effects else ("No calibration here found an effect of its sensor.",)
    few = tuple(
        f"{model}: {len(batches)} batches say nothing of how batches vary: each stands by itself."
        for model, batches in found.batches.items()
        if len(batches) < 3 and any(one.model == model for one in found.effects)
    )
    batches = sum(len(one) for one in found.batches.values())
    sizes = {"Sensors": found.sensors, "Calibrations": found.calibrations, "Batches": batches}
    facts = (*((name, str(count)) for name, count in sizes.items()), ("Worked out by", f"labcal {__version__}"))
    return Page(
        kind="Fleet",
        title=f"A fleet of {found.sensors} sensors",
        subtitle=models,
        simulated=found.simulated,
        summary=in_words(found),
        facts=Facts(facts),
        sections=sections(
            section("Effects by batch", [effect_table(found) if found.effects else None, Prose((*remarks, *few))]),
            section("Effects, drawn", effects),
            section("Sensors that stand out", [outlier_table(found)] if found.outliers else []),
            section("How figures are spread", [*plots, spread_table(found)]),
        ),
    )


def in_words(found: Fleet) -> str:
    """The worst batch of the worst effect, beside another, and the worst sensor."""
    said = []
    if found.effects:
        worst = found.effects[0]
        first, *others = worst.pooled.batches
        beside = f", {others[-1].name} {_with_u(others[-1])}" if others else ""
        said.append(f"{worst.parameter}: batch {first.name} {_with_u(first)}{beside} {worst.unit}")
    if found.outliers:
        far, _, serial, spread, _ = found.outliers[0]
        said.append(f"{serial} stands out most: its {spread.quantity} by {far:.1f} robust sigma")
    return ("; ".join(said) or "No effect was found and no sensor stands out") + "."


def _with_u(batch: Batch) -> str:
    return " ± ".join(with_uncertainty(batch.value, COVERAGE * batch.u))


def effect_table(found: Fleet) -> Table:
    """Every effect's batches, the farthest from zero first."""
    rows = []
    for one in found.effects:
        for batch in one.pooled.batches[:MOST_BATCHES]:
            share = f"{one.found_in[batch.name]} of {batch.devices}"
            pooled = with_uncertainty(batch.value, COVERAGE * batch.u)
            rows.append((one.parameter, one.model, batch.name, str(batch.devices), *pooled, one.unit, share))
    header = ("Parameter", "Model", "Batch", "Sensors", "Value", "U", "Unit", "Found in")
    return Table(header, tuple(rows), frozenset({3, 4, 5}))


def outlier_table(found: Fleet) -> Table:
    """Who stands out by which figure."""
    rows = [
        (serial, model, s.quantity, f"{value:.5g}", f"{s.centre:.5g}", s.unit, f"{far:.1f}")
        for far, model, serial, s, value in found.outliers[:MOST_OUTLIERS]
    ]
    more = len(found.outliers) - len(rows)
    caption = f"Beyond {OUTLIER} robust sigma of its model's median.{f' And {more} more.' if more > 0 else ''}"
    header = ("Sensor", "Model", "Figure", "Value", "Median", "Unit", "Sigma")
    return Table(header, tuple(rows), frozenset({3, 4, 6}), caption)


def spread_table(found: Fleet) -> Table:
    """Median, robust sigma and range of every figure."""
    rows = []
    for s in found.spreads:
        numbers = (s.centre, s.sigma, float(s.values.min()), float(s.values.max()))
        rows.append((s.model, s.quantity, *(f"{x:.4g}" for x in numbers), s.unit))
    header = ("Model", "Figure", "Median", "Robust sigma", "Least", "Most", "Unit")
    return Table(header, tuple(rows), frozenset({2, 3, 4, 5}))


def _plot_of_figures(model: str, found: Fleet) -> Plot:
    mine = [s for s in found.spreads if s.model == model]
    return Plot(lambda figure: draw_spreads(figure, mine), 4.2, f"{model}: sensors by figure; red: who stands out.")


def draw_spreads(figure: FigureBase, spreads: Sequence[Spread]) -> None:
    """A histogram for each figure."""
    across = 3
    down = -(-len(spreads) // across)
    every: Any = figure.subplots(down, across, squeeze=False)
    for axes, spread in zip(every.flat, spreads, strict=False):
        axes.hist(spread.values, bins=min(30, max(5, len(spread.values) // 3)), color=INKS[0])
        for _, value, _ in spread.outliers:
            axes.axvline(value, color=BAD, lw=0.8)
        axes.set(xlabel=f"{spread.quantity} ({spread.unit})")
    for axes in every.flat[len(spreads) :]:
        axes.set_visible(False)


def _plot_of_effect(one: OfBatches) -> Plot:
    height = 0.8 + 0.16 * min(len(one.pooled.batches), MOST_BATCHES)
    caption = f"{one.parameter}, {one.model}: pooled with U (dots), the batch's own mean (open)."
    return Plot(lambda figure: draw_batches(figure, one), height, caption)


def draw_batches(figure: FigureBase, one: OfBatches) -> None:
    """A line for each batch, the farthest from zero at the top."""
    axes: Axes = figure.subplots()
    shown = one.pooled.batches[:MOST_BATCHES]
    at = np.arange(len(shown))
    value, U = np.array([b.value for b in shown]), COVERAGE * np.array([b.u for b in shown])
    axes.errorbar(value, at, xerr=U, fmt="o", ms=4, lw=1, color=INKS[0])
    axes.plot([b.own_mean for b in shown], at, "o", ms=5, fillstyle="none", color=MUTED)
    axes.axvline(0, color=MUTED, lw=0.6)
    axes.set(xlabel=one.unit, yticks=at, yticklabels=[f"{b.name} ({b.devices})" for b in shown])
    axes.set_ylim(len(shown) - 0.5, -0.5)


def fleet_document(found: Fleet) -> dict[str, Any]:
    """`labcal-fleet/1`."""
    spreads = [
        {"model": s.model, "quantity": s.quantity, "unit": s.unit, "median": s.centre, "robust_sigma": s.sigma,
         "least": float(s.values.min()), "most": float(s.values.max()), "sensors": len(s.values)}
        for s in found.spreads
    ]  # fmt: skip
    stand_out = [
        {"serial": serial, "model": model, "quantity": s.quantity, "value": value, "unit": s.unit, "sigma": far}
        for far, model, serial, s, value in found.outliers
    ]
    return {
        "format": "labcal-fleet/1",
        "sensors": found.sensors,
        "calibrations": found.calibrations,
        "batches": {model: dict(batches) for model, batches in found.batches.items()},
        "effects": [asdict(one) for one in found.effects],
        "stand_out": stand_out,
        "figures": spreads,
    }
