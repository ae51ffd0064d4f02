"""Pages of the years: control charts, a gage study, how a sensor drifts."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from labcal.certificate.report import write_report
from labcal.certificate.report.page import Facts, Mark, Page, Plot, Prose, Table, section, sections
from labcal.certificate.report.style import BAD, GOOD, INKS, MUTED, NOTHING, WIDTH_IN, number, plot_style
from labcal.files import atomic
from labcal.quality.control_chart import Chart, spread_false_alarm_rate
from labcal.quality.drift import Drift
from labcal.quality.western_electric import RULES, average_run_length
from labcal.session.check_standard import Charts, why
from labcal.store import RunSummary
from labcal.version import __version__
from labcal.years.history import DAYS_A_YEAR
from labcal.years.study_of_gage import Study
from labcal.years.trend import Trend, shortest

if TYPE_CHECKING:
    from matplotlib.figure import Figure, FigureBase

BY = (("Worked out by", f"labcal {__version__}"),)

IN_SERVICE = (
    'In-service checking (ILAC-G24, "black box") proposes no interval: check the sensor between calibrations '
    "(labcal run verify, labcal charts), and calibrate it again when a check fails."
)


def write_page(page: Page, path: Path) -> None:
    """Write `page` as .html or .pdf, or its figures alone, one below the other, as .png."""
    if path.suffix.lower() != ".png":
        write_report(page, path)
        return
    plots = [block for part in page.sections for block in part.blocks if isinstance(block, Plot)]
    with plot_style(), atomic.replacing(path) as part:
        _picture(plots).savefig(part, format="png", metadata={"Software": None})


def _picture(plots: Sequence[Plot]) -> Figure:
    from matplotlib.figure import Figure

    heights = [plot.height_in for plot in plots]
    figure = Figure(figsize=(WIDTH_IN, sum(heights)), layout="constrained", dpi=150, facecolor="white")
    parts = figure.subfigures(len(plots), 1, height_ratios=heights, squeeze=False)[:, 0]
    for plot, part in zip(plots, parts, strict=True):
        plot.draw(part)
        part.suptitle(plot.caption, fontsize=8, color=MUTED)
    return figure


def charts_page(found: Charts) -> Page:
    """The charts of a check standard, the rules with how often each alarms for nothing, and what is against it."""
    drawn = {name: c for name, c in found.of.items() if isinstance(c, Chart)}
    plots = [_plot_of(name, chart, found) for name, chart in drawn.items()]
    lacking = tuple(f"{name}: {said}." for name, said in found.of.items() if isinstance(said, str))
    out = found.out
    mark = Mark("OUT OF CONTROL", "bad") if out else Mark("IN CONTROL", "good") if drawn else Mark("NO LIMITS", "plain")
    runs = [run for point in found.points for run in point]
    return Page(
        kind="Check standard",
        title=f"Control charts of {found.serial}",
        subtitle=f"{len(runs)} runs in {len(found.points)} points",
        simulated=any(run.simulated for run in runs),
        marks=(mark,),
        summary=in_words(found),
        facts=Facts((*_sizes(found, runs), *BY)),
        sections=sections(
            section("Charts", plots),
            section("Alarms for nothing", [_alarms(found)]),
            section("Without a chart", [Prose(lacking)] if lacking else []),
            section("Runs that give no figures", [Prose(found.not_used)] if found.not_used else []),
        ),
    )


def _sizes(found: Charts, runs: Sequence[RunSummary]) -> tuple[tuple[str, str], ...]:
    stated = found.stated
    numbers = {"Runs": len(runs), "Runs a point": stated.repeats, "Points of the baseline": stated.baseline}
    return tuple((name, str(count)) for name, count in numbers.items())


def _plot_of(name: str, chart: Chart, found: Charts) -> Plot:
    return Plot(lambda figure: draw_chart(figure, name, chart, found), 2.6, f"{name}: {_judged(chart)}.")


def in_words(found: Charts) -> str:
    """One sentence: in control or not, and by what."""
    if out := found.out:
        return "Out of control: " + "; ".join(f"{name}: {why(chart)}" for name, chart in out.items()) + "."
    if any(isinstance(chart, Chart) for chart in found.of.values()):
        return "In control: no rule is broken at the last point."
    return "There are no limits yet: " + next(iter(v for v in found.of.values() if isinstance(v, str)), "no run") + "."


def _judged(chart: Chart) -> str:
    said = f"out of control, {why(chart)}" if chart.out_of_control else "in control"
    return f"{said}; means differ by more than their repeats explain" if chart.differ else said


def _alarms(found: Charts) -> Table:
    rules, n = found.stated.rules, found.stated.repeats
    rows = [(RULES[r], number(average_run_length((r,)), 1)) for r in rules]
    rows.append(("any of these rules", number(average_run_length(rules), 1)))
    if n > 1 and not found.stated.between:
        rows.append(("spread beyond its limits", number(1 / spread_false_alarm_rate(n), 1)))
    together = average_run_length(rules) / len(found.of)
    rows.append((f"any of the rules on any of {len(found.of)} quantities, about", number(together, 1)))
    caption = "Points until the first false alarm, on average, of a standard that never changes (normal, independent)."
    return Table(("Rule", "Points"), tuple(rows), frozenset({1}), caption)


def draw_chart(figure: FigureBase, name: str, chart: Chart, found: Charts) -> None:
    """The points with their limits, and below them their spread."""
    means, spreads = figure.subplots(2, 1, sharex=True, height_ratios=(2, 1))
    at = np.arange(len(chart.mean)) + 1
    unit = found.units.get(name, "")
    _limits(means, at, chart.lower, np.full(len(at), chart.centre), chart.upper)
    _limits(spreads, at, chart.spread_lower, chart.spread_centre, chart.spread_upper)
    alarmed = np.array([bool(broken) for broken in chart.broken])
    for axes, values, bad in ((means, chart.mean, alarmed), (spreads, chart.spread, chart.spread_out)):
        axes.plot(at, values, "o-", ms=3, lw=0.7, color=INKS[0])
        axes.plot(at[bad], values[bad], "s", ms=5, color=BAD)
        axes.axvline(chart.baseline + 0.5, color=MUTED, lw=0.6, ls=":")
    single = found.stated.repeats == 1 or found.stated.between
    means.set(ylabel=f"{name} ({unit})")
    spreads.set(ylabel=f"{'range' if single else 's'} ({unit})", xlabel="point", ylim=(0, None))


def _limits(axes: object, at: object, *levels: object) -> None:
    for level, style in zip(levels, ("--", "-", "--"), strict=True):
        axes.step(at, level, where="mid", color=GOOD, lw=0.8, ls=style)  # type: ignore[attr-defined]


def study_page(study: Study) -> Page:
    """A gage study: its table, its components, and what they say of the gage."""
    found = study.found
    low, high = found.percent_rr_interval
    between = f"95 %: {number(low, 1)} to {number(high, 1)} %"
    said = f"The gage takes {number(found.percent_rr, 1)} % of the total variation ({between}) and tells "
    said += f"{found.categories} categories apart."
    drawn = Plot(lambda figure: draw_components(figure, study), 2.4, "Share of the total standard deviation, 95 %.")
    tone = "good" if found.percent_rr < 10 else "warning" if found.percent_rr <= 30 else "bad"
    return Page(
        kind="Gage R&R",
        title=f"Gage R&R of {study.quantity}",
        subtitle=", ".join(f"{n} × {name}" for name, n in study.levels) + f", {study.repeats} a cell",
        simulated=study.simulated,
        marks=(Mark(f"{found.percent_rr:.0f} % R&R", tone),),  # type: ignore[arg-type]
        summary=said,
        facts=Facts(BY),
        sections=sections(
            section("Components of variation", [drawn, components_table(study)]),
            section("Analysis of variance", [anova_table(study)]),
            section("Remarks", [Prose(study.remarks)] if study.remarks else []),
        ),
    )


def draw_components(figure: FigureBase, study: Study) -> None:
    """A bar for each component but the total, with its interval; what a gage may take as lines."""
    axes = figure.subplots()
    shown = [c for c in study.found.components if c.source != "total"]
    share = np.array([c.percent for c in shown])
    low, high = np.array([c.percent_interval for c in shown]).T
    around = np.maximum([share - low, high - share], 0.0)
    at = np.arange(len(shown))
    axes.barh(at, share, xerr=around, color=INKS[0], error_kw={"lw": 0.8, "ecolor": MUTED})
    for bound, colour in ((10, GOOD), (30, BAD)):
        axes.axvline(bound, color=colour, lw=0.8, ls="--")
    axes.set(xlabel="% of the total variation", xlim=(0, 105), yticks=at, yticklabels=[c.source for c in shown])
    axes.invert_yaxis()


def components_table(study: Study) -> Table:
    """Standard deviations with their intervals, and shares of the total."""
    rows = []
    for c in study.found.components:
        between = f"{c.interval[0]:.4g} to {c.interval[1]:.4g}"
        share = f"{c.percent_interval[0]:.1f} to {c.percent_interval[1]:.1f}"
        rows.append((c.source, f"{c.sd:.4g}", between, f"{c.percent:.2f}", share))
    unit = f" ({study.unit})" if study.unit else ""
    header = ("Source", f"Standard deviation{unit}", "95 %", "% of total", "95 %")
    return Table(header, tuple(rows), frozenset({1, 2, 3, 4}))


def anova_table(study: Study) -> Table:
    """The lines of the analysis of variance."""
    rows = [
        (line.source, str(line.dof), f"{line.ss:.5g}", f"{line.ms:.5g}", NOTHING if line.F is None else f"{line.F:.3f}",
         NOTHING if line.p is None else f"{line.p:.4f}", "pooled" if line.pooled else "")
        for line in study.found.lines
    ]  # fmt: skip
    return Table(("Source", "dof", "SS", "MS", "F", "p", ""), tuple(rows), frozenset({1, 2, 3, 4, 5}))


def trend_page(serial: str, found: Sequence[Trend], dates: Sequence[datetime], simulated: bool) -> Page:
    """How a sensor's figures moved, and when it should come back."""
    kinds = list(dict.fromkeys(trend.quantity.split()[0] for trend in found))
    plots = [_plot_of_kind(kind, found, dates) for kind in kinds]
    asked = [t for t in found if t.proposals]
    return Page(
        kind="Years",
        title=f"Drift of {serial}",
        subtitle=f"{len(dates)} calibrations, {dates[0]:%Y-%m-%d} to {dates[-1]:%Y-%m-%d}",
        simulated=simulated,
        summary=intervals_in_words(found),
        facts=Facts(BY),
        sections=sections(
            section("Over time", plots),
            section("Drift a year", [drift_table(found)]),
            section("When to calibrate again", [interval_table(asked), Prose((IN_SERVICE,))] if asked else []),
        ),
    )


def _plot_of_kind(kind: str, found: Sequence[Trend], dates: Sequence[datetime]) -> Plot:
    mine = [trend for trend in found if trend.quantity.split()[0] == kind]
    caption = f"{kind.capitalize()}: U (k = 2), and the line of the drift."
    return Plot(lambda figure: draw_trends(figure, mine, dates), 2.2, caption)


def intervals_in_words(found: Sequence[Trend]) -> str:
    """The shortest proposal of each method, and what drifts."""
    moving = [t.quantity for t in found if isinstance(t.drift, Drift) and t.drift.significant]
    said = f"A drift is seen of {', '.join(moving)}. " if moving else "No figure drifts by more than its uncertainty. "
    if not any(isinstance(t.drift, Drift) for t in found):
        said = f"No drift can be estimated: {found[0].drift}. "
    by = shortest(found)
    each = "; ".join(f"{method} {days:.0f} days ({quantity})" for method, (days, quantity) in by.items())
    return f"{said}Calibrate again after: {each}." if by else said.strip()


def drift_table(found: Sequence[Trend]) -> Table:
    """The rate of each figure with its interval, and its scatter."""
    rows = []
    for trend in found:
        if isinstance(line := trend.drift, str):
            rows.append((trend.quantity, NOTHING, line, NOTHING, trend.unit, ""))
            continue
        between = f"{line.interval[0]:+.3g} to {line.interval[1]:+.3g}"
        seen = "drifts" if line.significant else ""
        rows.append((trend.quantity, f"{line.rate:+.3g}", between, f"{line.scatter:.2g}", f"{trend.unit}/year", seen))
    return Table(("Figure", "Drift", "95 %", "Scatter beyond u", "Unit", ""), tuple(rows), frozenset({1, 2, 3}))


def interval_table(found: Sequence[Trend]) -> Table:
    """What each method proposes for each figure."""
    rows = [
        (t.quantity, one.method, NOTHING if one.days is None else f"{one.days:.0f}",
         NOTHING if one.hours is None else f"{one.hours:.0f}", one.why)
        for t in found for one in t.proposals
    ]  # fmt: skip
    return Table(("Figure", "Method (ILAC-G24)", "Days", "Hours of use", "Why"), tuple(rows), frozenset({2, 3}))


def draw_trends(figure: FigureBase, found: Sequence[Trend], dates: Sequence[datetime]) -> None:
    """Figures of one kind from the first calibration on, with U and the line."""
    axes = figure.subplots()
    years = np.array([when.year + (when.timetuple().tm_yday - 1) / DAYS_A_YEAR for when in dates])
    for trend, colour in zip(found, INKS, strict=False):
        U = 2 * np.nan_to_num(trend.u)
        change = trend.values - trend.values[0]
        axes.errorbar(years, change, U, fmt="o", ms=3, lw=0.8, color=colour, label=trend.quantity)
        if isinstance(trend.drift, Drift):
            ends = np.array([years[0], years[-1]])
            line = [trend.drift.at(float(y - years[-1] + trend.drift.t_last))[0] - trend.values[0] for y in ends]
            axes.plot(ends, line, color=colour, lw=0.8)
    axes.set(xlabel="year", ylabel=f"change ({found[0].unit})")
    axes.ticklabel_format(useOffset=False)
    figure.legend(loc="outside right upper", fontsize=7)
