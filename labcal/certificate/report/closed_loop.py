"""The report of a closed loop: the verdict, before and after, what was accepted, what was tried, what to do next."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.report.calibration import effect_tables, headline_of, name_of
from labcal.certificate.report.figures import segment_bounds, thin
from labcal.certificate.report.page import Block, Facts, Mark, Page, Plot, Prose, Table, Tone, section, sections
from labcal.certificate.report.style import AXES, MUTED, NOTHING, number, sentence, short
from labcal.certificate.report.unstated import not_stated
from labcal.loop.result import ClosedLoop, ResidualTest, Verdict
from labcal.model import EffectRecord
from labcal.record import Run

if TYPE_CHECKING:
    from matplotlib.figure import FigureBase

Array = NDArray[np.float64]
TONES: dict[Verdict, Tone] = {
    "clean": "good",
    "explained": "good",
    "partly-explained": "warning",
    "ambiguous": "warning",
    "unexplained": "bad",
}
ENLARGED = 5.0  # times smaller than before: what is left gets a scale of its own
KINDS = {"vector": "length of the residual vector", "scalar": "residual of the magnitude"}


def closed_loop_page(result: ClosedLoop, run: Run) -> Page:
    """The page of what the loop found in `run`."""
    floor = f"noise alone would leave {number(result.noise_floor_nT)} nT ({result.noise_floor_source})"
    return Page(
        kind="Closed loop",
        title=name_of(run.dut),
        subtitle=f"run {run.run_id}",
        simulated=run.simulated,
        marks=(Mark(result.verdict.upper().replace("-", " "), TONES[result.verdict]),),
        summary=result.summary,
        headline=headline_of(
            result.before.holdout_rms_nT,
            result.after.holdout_rms_nT,
            f"rms {KINDS[result.residual_kind]} on blocks of time that were held out; {floor}",
        ),
        facts=_facts(result, run),
        sections=sections(
            section("What to measure next", _next(result)),
            section("Residual before and after", _pictures(result, run)),
            section("Accepted", effect_tables(result.accepted)),
            section("Tests of what is left", [_tests(result)]),
            section("Tried and not accepted", [_rejected(result.rejected)]),
            section("Remarks", [Prose(result.remarks)] if result.remarks else []),
            section("What this run alone can never tell apart", _twins(result)),
            section("What is not covered", [Prose(not_stated(run))]),
        ),
        footer="Residual r = b − p: calibrated reading minus the reference carried into the sensor's axes.",
    )


def _facts(result: ClosedLoop, run: Run) -> Facts:
    set_aside = ", ".join(f"{n} {name}" for name, n in result.set_aside.items() if n) or "none"
    return Facts(
        (
            ("Started (UTC)", run.started_utc),
            ("Operator", run.operator or "–"),
            ("Base model", result.base),
            ("Residual", KINDS[result.residual_kind]),
            ("In sample", f"{number(result.before.train_rms_nT)} → {number(result.after.train_rms_nT)} nT"),
            ("Rows set aside", set_aside),
        )
    )


def _next(result: ClosedLoop) -> list[Block]:
    if (proposed := result.next_experiment) is None:
        return []
    procedure = f" (procedure {proposed.procedure})" if proposed.procedure else ""
    said = Prose((sentence(f"{proposed.do}{procedure}"), sentence(proposed.why)))
    if not proposed.ranking:
        return [said]
    rows = tuple((r.do, r.procedure or "a person's step", f"{r.sigma:.0f}") for r in proposed.ranking)
    return [
        said,
        Table(("Experiment", "Procedure", "Separation (standard deviations, foretold)"), rows, frozenset({2})),
    ]


def _tests(result: ClosedLoop) -> Table | None:
    """Each test before and after, one row each."""
    before = {(test.test, test.of): test for test in result.tests.get("before", ())}
    rows = []
    for test in result.tests.get("after", ()):
        earlier = before.get((test.test, test.of)) or next((b for k, b in before.items() if k[0] == test.test), test)
        rows.append((TESTS[test.test], test.of, _verdict_of(earlier), _verdict_of(test)))
    return Table(("Test", "Of", "Before", "After"), tuple(rows)) if rows else None


TESTS = {
    "whiteness": "White from row to row (Ljung-Box)",
    "independence": "Independence (cross-correlation)",
    "lack-of-fit": "Lack of fit against repeats (F)",
}


def _verdict_of(test: ResidualTest) -> str:
    return "passes" if test.passes else f"fails: {100 * test.share:.0f} % of the square"


def _twins(result: ClosedLoop) -> list[Block]:
    rows = tuple((pair.one, pair.other, pair.separated_by) for pair in result.twins)
    return [Table(("This", "and this", "are told apart by"), rows)] if rows else []


def _rejected(effects: tuple[EffectRecord, ...]) -> Table | None:
    if not effects:
        return None
    header = ("Effect", "Held-out rms (nT)", "Gain, 95 % (nT)", "p", "Why")
    rows = [_rejected_row(effect) for effect in effects]
    said = [i for i in range(len(header)) if any(row[i] != NOTHING for row in rows)]
    numeric = frozenset(place for place, i in enumerate(said) if i in (1, 2, 3))
    return Table(tuple(header[i] for i in said), tuple(tuple(row[i] for i in said) for row in rows), numeric)


def _rejected_row(e: EffectRecord) -> tuple[str, ...]:
    gain = NOTHING if e.improvement_ci95_nT is None else " to ".join(number(v) for v in e.improvement_ci95_nT)
    p = NOTHING if e.p_value is None else "< 0.001" if e.p_value < 0.001 else f"{e.p_value:.3f}"
    return " · ".join([e.effect, *e.channels]), number(e.holdout_rms_after_nT), gain, p, sentence(e.why)


def _pictures(result: ClosedLoop, run: Run) -> list[Block]:
    over_time = "x vermilion, y green, z blue." if result.residual_kind == "vector" else "The magnitude."
    return [
        Plot(lambda figure: draw_over_time(figure, result), 4.0, over_time),
        Plot(lambda figure: _draw_by_segment(figure, result, run), 2.0, "Rms in each segment, in sample."),
    ]


def draw_over_time(figure: FigureBase, result: ClosedLoop) -> None:
    """The residual before and after on one scale, and after on its own where it is much smaller."""
    pictures = result.pictures
    shown = [("before", pictures.before_nT, _limit(pictures.before_nT))]
    shown.append(("after, on the same scale", pictures.after_nT, shown[0][2]))
    if _limit(pictures.after_nT) * ENLARGED < shown[0][2]:
        shown.append(("after, enlarged", pictures.after_nT, _limit(pictures.after_nT)))
    panels = figure.subplots(len(shown), 1, sharex=True)
    t, rows = pictures.t_s - pictures.t_s[0], thin(len(pictures.t_s))
    colours = AXES if pictures.before_nT.shape[1] == 3 else AXES[2:]
    for panel, (name, residual, limit) in zip(panels, shown, strict=True):
        for values, colour in zip(residual.T, colours, strict=True):
            panel.plot(t[rows], values[rows], ".", ms=1.8, color=colour, rasterized=True)
        panel.set(ylabel="residual (nT)", ylim=(-limit, limit))
        panel.set_title(name)
        segment_bounds(panel, pictures.t_s, pictures.segment)
    panels[-1].set(xlabel="time (s)")


def _limit(residual: Array) -> float:
    return 1.1 * float(np.nanquantile(np.abs(residual), 0.999)) or 1.0


def _draw_by_segment(figure: FigureBase, result: ClosedLoop, run: Run) -> None:
    axes, pictures = figure.subplots(), result.pictures
    there = np.unique(pictures.segment)
    places = np.arange(len(there))
    for shift, name, residual, colour in (
        (-0.2, "before", pictures.before_nT, MUTED),
        (0.2, "after", pictures.after_nT, AXES[2]),
    ):
        squared = np.sum(residual**2, axis=1)
        rms = [np.sqrt(np.nanmean(squared[pictures.segment == segment])) for segment in there]
        axes.bar(places + shift, rms, 0.38, color=colour, label=name)
    axes.axhline(result.noise_floor_nT, color=AXES[0], lw=1, ls="--", label="noise floor")
    many = len(there) > 6
    names = [short(run.segments[i].id) for i in there]
    axes.set_xticks(places, names, rotation=30 if many else 0, ha="right" if many else "center")
    axes.set(ylabel="rms (nT)")
    axes.grid(axis="x", visible=False)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3)
