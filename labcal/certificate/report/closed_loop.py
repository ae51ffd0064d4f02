"""The report of a closed loop: the verdict, before and after, what was accepted, what was tried, what to do next."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.parameters_k import k_in_words, k_of_sources
from labcal.certificate.report.calibration import effect_tables, headline_of, name_of, named
from labcal.certificate.report.conformity import conformity_blocks
from labcal.certificate.report.empirical_term import empirical_blocks
from labcal.certificate.report.figures import segment_bounds, thin
from labcal.certificate.report.page import Block, Facts, Mark, Page, Plot, Prose, Table, Tone, section, sections
from labcal.certificate.report.style import AXES, MUTED, NOTHING, number, sentence, short
from labcal.loop.result import ClosedLoop, ResidualTest, Verdict
from labcal.model import EffectRecord
from labcal.model.effects import families
from labcal.record import Run
from labcal.uncertainty.unstated import not_covered

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
    k = k_of_sources(result.sources)
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
            section("Is it in specification?", conformity_blocks(result.conformity.lines) if result.conformity else []),
            section("Residual before and after", _pictures(result, run)),
            section("Without a name", empirical_blocks(result, run)),
            section("Accepted", effect_tables(result.accepted, k)),
            section("Tests of what is left", [_tests(result)]),
            section("Tried and not accepted", [_rejected(result.rejected), _not_tried(result)]),
            section("Remarks", [Prose(result.remarks)] if result.remarks else []),
            section("What this run alone can never tell apart", _confounded(result)),
            section("What is not covered", [Prose((*not_covered(run), *_left_open(result)))]),
        ),
        footer="Residual r = b − p: calibrated reading minus the reference carried into the sensor's axes. "
        f"U is the expanded uncertainty, k = {k_in_words(k)} (about 95 %). "
        "A positive offset parameter: the sensor reads high.",
    )


def _left_open(result: ClosedLoop) -> tuple[str, ...]:
    return result.conformity.left_open if result.conformity else ()


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
        rows.append((TESTS[test.test], test.of, _verdict_of(earlier), _verdict_of(test), _chance(test.p_value)))
    header = ("Test", "Of", "Before", "After", "p after")
    return Table(header, tuple(rows), frozenset({4}), P_OF_TESTS) if rows else None


P_OF_TESTS = (
    "p: how often a residual without structure gives as much, the looks taken counted. A test fails where p is below "
    "0.01 and what it finds is material. Whiteness is that of the segment that is worst after."
)
TESTS = {
    "whiteness": "White from row to row (Ljung-Box)",
    "independence": "Independence (cross-correlation)",
    "lack-of-fit": "Lack of fit against repeats (F)",
}


def _verdict_of(test: ResidualTest) -> str:
    return "passes" if test.passes else f"fails: {100 * test.share:.0f} % of the square"


def _confounded(result: ClosedLoop) -> list[Block]:
    rows = tuple((pair.one, pair.other, pair.separated_by) for pair in result.twins)
    return [Table(("This", "and this", "are separated by"), rows)] if rows else []


WEIGHED = (
    "Evidence: gain in log-likelihood (nats) over noise with a slow wander that has no name, less the penalty for "
    "parameters and trials. p: how often noise alone gives the best of all candidates as much evidence. "
    "Held-out rms and gain stand where the cause was tried on held-out blocks."
)


def _rejected(effects: tuple[EffectRecord, ...]) -> Table | None:
    if not effects:
        return None
    header = ("Effect", "Held-out rms (nT)", "Gain, 95 % (nT)", "p", "Why")
    rows = [_rejected_row(effect) for effect in effects]
    said = [i for i in range(len(header)) if any(row[i] != NOTHING for row in rows)]
    numeric = frozenset(place for place, i in enumerate(said) if i in (1, 2, 3))
    return Table(tuple(header[i] for i in said), tuple(tuple(row[i] for i in said) for row in rows), numeric, WEIGHED)


def _not_tried(result: ClosedLoop) -> Prose | None:
    """Effects that this run has nothing to show of."""
    tried = {effect.effect for effect in (*result.accepted, *result.rejected)}
    left = [family.id for family in families() if family.id not in tried and family.belongs_to != "data"]
    if not (left and result.rejected):
        return None
    return Prose((f"Not tried, for this run lacks the channel, reference or motion that shows it: {', '.join(left)}.",))


def _rejected_row(e: EffectRecord) -> tuple[str, ...]:
    gain = NOTHING if e.improvement_ci95_nT is None else " to ".join(number(v) for v in e.improvement_ci95_nT)
    p = NOTHING if e.p_value is None else _chance(e.p_value)
    return named(e), number(e.holdout_rms_after_nT), gain, p, sentence(e.why)


def _chance(p: float) -> str:
    return "< 0.001" if p < 0.001 else f"{p:.3f}"


def _pictures(result: ClosedLoop, run: Run) -> list[Block]:
    what = "The residual along x, y and z" if result.residual_kind == "vector" else "The residual of the magnitude"
    by_segment = "on held-out blocks, by fits that did not see them" if _held_out(result) is not None else "in sample"
    return [
        Plot(lambda figure: draw_over_time(figure, result), 4.0, f"{what}, in sample; {_beyond(result)}."),
        Plot(lambda figure: _draw_by_segment(figure, result, run), 2.0, f"Rms in each segment, {by_segment}."),
    ]


def _held_out(result: ClosedLoop) -> Array | None:
    """Lengths before and after on held-out blocks (n, 2); None where there are none."""
    lengths = result.pictures.held_out_nT
    return lengths if lengths is not None and np.isfinite(lengths).any() else None


def _beyond(result: ClosedLoop) -> str:
    """How many points the largest scale leaves out."""
    before, after = result.pictures.before_nT, result.pictures.after_nT
    limit = _limit(before)
    count = int(np.sum(np.abs(before) > limit) + np.sum(np.abs(after) > limit))
    return f"{count} point{'s lie' if count != 1 else ' lies'} beyond the scale" if count else "all points are shown"


def draw_over_time(figure: FigureBase, result: ClosedLoop) -> None:
    """The residual before and after on one scale, and after on its own where it is much smaller."""
    pictures = result.pictures
    shown = [("before", pictures.before_nT, _limit(pictures.before_nT))]
    shown.append(("after, on the same scale", pictures.after_nT, shown[0][2]))
    if _limit(pictures.after_nT) * ENLARGED < shown[0][2]:
        shown.append(("after, enlarged", pictures.after_nT, _limit(pictures.after_nT)))
    panels = figure.subplots(len(shown), 1, sharex=True)
    t, rows = pictures.t_s - pictures.t_s[0], thin(len(pictures.t_s))
    components = tuple(zip("xyz", AXES, strict=True)) if pictures.before_nT.shape[1] == 3 else (("|b|", AXES[2]),)
    for panel, (name, residual, limit) in zip(panels, shown, strict=True):
        for values, (label, colour) in zip(residual.T, components, strict=True):
            panel.plot(t[rows], values[rows], ".", ms=1.8, color=colour, rasterized=True, label=label)
        panel.set(ylabel="residual (nT)", ylim=(-limit, limit))
        panel.set_title(name)
        segment_bounds(panel, pictures.t_s, pictures.segment)
    panels[0].legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, markerscale=5, handletextpad=0.2)
    panels[-1].set(xlabel="time (s)")


def _limit(residual: Array) -> float:
    return 1.1 * float(np.nanquantile(np.abs(residual), 0.999)) or 1.0


def _draw_by_segment(figure: FigureBase, result: ClosedLoop, run: Run) -> None:
    axes, pictures = figure.subplots(), result.pictures
    lengths = _held_out(result)
    if lengths is None:
        lengths = np.stack([np.linalg.norm(r, axis=1) for r in (pictures.before_nT, pictures.after_nT)], axis=1)
    lengths, segment = lengths[seen := np.isfinite(lengths[:, 0])], pictures.segment[seen]
    there = np.unique(segment)
    places = np.arange(len(there))
    for column, (shift, name, colour) in enumerate(((-0.2, "before", MUTED), (0.2, "after", AXES[2]))):
        rms = [np.sqrt(np.mean(lengths[segment == one, column] ** 2)) for one in there]
        axes.bar(places + shift, rms, 0.38, color=colour, label=name)
    axes.axhline(result.noise_floor_nT, color=AXES[0], lw=1, ls="--", label="noise floor")
    many = len(there) > 6
    names = [short(run.segments[i].id) for i in there]
    axes.set_xticks(places, names, rotation=30 if many else 0, ha="right" if many else "center")
    axes.set(ylabel="rms (nT)")
    axes.grid(axis="x", visible=False)
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3)
