"""Each judgement where it bites: a little on either side of its value the answer is another one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.special import chdtrc

from labcal.loop.assemble import verdict_of
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Scored
from labcal.loop.candidates.spectral_lines import admissible
from labcal.loop.close import candidates_of
from labcal.loop.data.base_model import is_determined
from labcal.loop.data.checks import incoherent, is_full_rank, units
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import static_noise
from labcal.loop.data.outliers import hampel_outliers
from labcal.loop.findings.declaration import Declaration
from labcal.loop.findings.run_findings import noise_disagreement
from labcal.loop.selection import admission, equivalents, heldout_rules, stepwise
from labcal.model.effects import Family, Term


def _evidence(after: float, accepted: int = 0, distance: float = 20.0) -> Any:
    error, level = SimpleNamespace(after=after), SimpleNamespace(nT=100.0, source="declared")
    return SimpleNamespace(
        cv_error=error, level=level, equivalents=(), accepted=(None,) * accepted, outlier_distance=distance
    )


@pytest.mark.parametrize(("after", "verdict"), [(114.0, "clean"), (116.0, "unexplained")])
def test_up_to_1_15_of_the_floor_nothing_is_left(after: float, verdict: str) -> None:
    assert verdict_of(_evidence(after), {"outliers": 0, "saturation": 0}, 1000) == verdict


@pytest.mark.parametrize(("outliers", "distance", "verdict"), [(2, 20, "clean"), (3, 20, "explained"), (3, 9, "clean")])
def test_three_gross_rows_set_aside_are_a_cause(outliers: int, distance: float, verdict: str) -> None:
    aside = {"outliers": outliers, "saturation": 0}
    assert verdict_of(_evidence(100.0, distance=distance), aside, 1000) == verdict


@pytest.mark.parametrize(("distance", "verdict"), [(9.8, "clean"), (10.2, "explained")])
def test_rows_set_aside_within_ten_deviations_are_no_cause(distance: float, verdict: str) -> None:
    assert verdict_of(_evidence(100.0, distance=distance), {"outliers": 9, "saturation": 0}, 1000) == verdict


@pytest.mark.parametrize(
    ("after", "rows", "verdict"), [(100.0, 3, "explained"), (150.0, 3, "partly-explained"), (150.0, 2, "unexplained")]
)
def test_a_limit_that_readings_pile_up_at_is_named_whatever_the_rest_is(after: float, rows: int, verdict: str) -> None:
    aside = {"outliers": 0, "saturation": rows}
    assert verdict_of(_evidence(after), aside, 1000) == verdict


@pytest.mark.parametrize(("outliers", "verdict"), [(49, "explained"), (51, "partly-explained")])
def test_a_run_with_more_than_5_per_cent_outliers_is_never_explained(outliers: int, verdict: str) -> None:
    assert verdict_of(_evidence(100.0, accepted=1), {"outliers": outliers, "saturation": 0}, 1000) == verdict


@pytest.mark.parametrize(("size", "outlying"), [(5.8, False), (6.2, True)])
def test_a_row_six_deviations_from_its_neighbours_is_an_outlier(size: float, outlying: bool) -> None:
    residual = np.zeros((60, 3))
    residual[30, 1] = size
    assert hampel_outliers(residual, np.zeros(60, dtype=np.intp)).any() == outlying


@pytest.mark.parametrize(("ratio", "found"), [(1.27, False), (1.33, True), (0.78, False), (0.75, True)])
def test_noise_that_differs_by_a_factor_of_1_3_is_a_finding(ratio: float, found: bool) -> None:
    level: Any = SimpleNamespace(source="declared", nT=40.0, measured_over_declared=ratio)
    problem: Any = None
    assert (noise_disagreement(problem, level) is not None) == found


def _scored(family: str, gain: float) -> Scored:
    of = Family(family, "sensor", lambda term, scene: np.zeros((1, 3, 1)), lambda run: [])
    likelihood: Any = None
    term = Term(of.kernel, (("c", "nT"),))
    return Scored(Candidate(of, term), gain, gain - 10.0, 1.0, 1, likelihood)


@pytest.mark.parametrize(("evidence", "named"), [(11.8, False), (12.2, True)])
def test_a_cause_with_less_than_twelve_nats_is_not_named(
    monkeypatch: pytest.MonkeyPatch, evidence: float, named: bool
) -> None:
    """Why twelve is what `test_chance.py` shows: coloured noise beside twenty smooth channels stays below."""
    for asked, answer in (("min_material_drop", 0.03), ("earns_its_extension", True), ("is_of_time", True)):
        monkeypatch.setattr(stepwise, asked, lambda *_, answer=answer: answer)
    pool: Any = None
    assert (stepwise.best_admissible(pool, [], [_scored("one", evidence + 10.0)]) is not None) == named


@pytest.mark.parametrize(("behind", "count"), [(7.8, 2), (8.2, 1)])
def test_a_cause_within_eight_nats_is_as_likely(behind: float, count: int) -> None:
    best, other = _scored("one", 4000.0), _scored("other", 4000.0 - behind)
    assert len(equivalents.within_reach([best, other], best.candidate, ())) == count


@pytest.mark.parametrize(("after", "as_good"), [(102.8, True), (103.2, False)])
def test_a_held_out_error_within_3_per_cent_is_as_good(after: float, as_good: bool) -> None:
    either: Any = SimpleNamespace(before=100.0, after=after, improvement=lambda: (-4.0, -2.0))
    assert equivalents.not_worse(either) == as_good


@pytest.mark.parametrize(("rest", "accepted", "least"), [(10.0, 1, 0.8), (0.1, 1, 0.03), (10.0, 0, 0.03)])
def test_a_second_cause_takes_a_twelfth_of_what_is_left(
    monkeypatch: pytest.MonkeyPatch, rest: float, accepted: int, least: float
) -> None:
    monkeypatch.setattr(admission, "related_columns", lambda pool, accepted: [])
    null = SimpleNamespace(rss=1000 * (1 + rest), level=1.0)
    pool: Any = SimpleNamespace(n_data=1000, decimation=1.0, null_model=lambda *_: SimpleNamespace(null=null))
    candidate: Any = None
    assert admission.min_material_drop(pool, [candidate] * accepted) == pytest.approx(least)


@pytest.mark.parametrize(
    ("name", "takes", "enough"),
    [("slow", 0.73, False), ("slow", 0.77, True), ("load", 0.48, False), ("load", 0.52, True)],
)
def test_effects_together_take_most_of_the_excess(
    monkeypatch: pytest.MonkeyPatch, name: str, takes: float, enough: bool
) -> None:
    monkeypatch.setattr(heldout_rules, "follows_a_switch", lambda pool, candidate: candidate == "load")
    excess = 99.0 * 100.0**2  # of 1000 nT over a floor of 100 nT
    error: Any = SimpleNamespace(before=1000.0, after=(1000.0**2 - takes * excess) ** 0.5)
    pool: Any = None
    accepted: Any = [name]
    level: Any = SimpleNamespace(nT=100.0, source="declared")
    assert heldout_rules.explains_excess(pool, error, level, accepted) == enough


@pytest.mark.parametrize(("left_nT", "gross"), [(195.0, False), (205.0, True)])
def test_a_fifth_of_the_field_is_gross(left_nT: float, gross: bool) -> None:
    """A misfit of a fifth of the field, and a gain of a fifth of the largest: an axis that hardly sees the field."""
    assert (incoherent(left_nT, 1000.0) is not None) == gross
    assert is_full_rank(np.diag([1000.0, 1000.0, left_nT])) == gross


@pytest.mark.parametrize(("times", "another"), [(98.0, False), (102.0, True), (1 / 98, False), (1 / 102, True)])
def test_readings_a_hundred_times_off_are_in_another_unit(times: float, another: bool) -> None:
    field_nT = 1000.0
    there_and_back = times * field_nT * np.array([[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]])
    seen = SimpleNamespace(reading=there_and_back, scale=1.0)
    problem: Any = SimpleNamespace(observations=seen, run=SimpleNamespace(dut=SimpleNamespace(nominal_nT_per_unit=1.0)))
    assert (units(problem, field_nT) is not None) == another


@pytest.mark.parametrize(("u_nT", "determined"), [(980.0, True), (1020.0, False)])
def test_a_map_of_two_per_cent_of_the_field_is_not_determined(u_nT: float, determined: bool) -> None:
    identified = SimpleNamespace(worst_u_nT=u_nT, why_not=None)
    found: Any = SimpleNamespace(observations=SimpleNamespace(magnitude=np.array([2e4, 5e4])), identified=identified)
    assert is_determined(found, "affine") == determined
    assert is_determined(found, "offset")


def _segments(starts_s: list[float], seconds: float) -> Any:
    """A problem whose segments begin at these times and last as long."""
    t_s = [start + np.linspace(0.0, seconds, 101) for start in starts_s]
    segment = np.repeat(np.arange(len(starts_s)), 101)
    return SimpleNamespace(scene=SimpleNamespace(t_s=np.concatenate(t_s), segment=segment))


def _may_be_a_line(problem: Any, frequency_Hz: float) -> bool:
    return bool(admissible(problem, np.array([frequency_Hz, 10.0]))[0])


@pytest.mark.parametrize(("periods", "line"), [(2.9, False), (3.1, True)])
@pytest.mark.parametrize(
    ("starts_s", "of_s"),
    [
        ([0.0, 300.0, 600.0], 100.0),  # each segment begins with the same phase: periods of one segment count
        ([0.0, 37.0, 61.0, 90.0], 100.0),  # and with any: those of the whole run
    ],
    ids=["in step", "not in step"],
)
def test_three_periods_are_a_line(starts_s: list[float], of_s: float, periods: float, line: bool) -> None:
    in_step = starts_s[1] == 300.0
    seconds = of_s if in_step else of_s - starts_s[-1]
    frequency = periods / of_s
    if in_step:  # the starts lie whole periods apart
        starts_s = [round(start * frequency) / frequency for start in starts_s]
    assert _may_be_a_line(_segments(starts_s, seconds), frequency) == line


@pytest.mark.parametrize(("resultant", "line"), [(0.68, True), (0.72, False)])
def test_a_line_that_segments_begin_alike_with_is_their_own_motion(resultant: float, line: bool) -> None:
    """Of two segments whose phases differ by p the resultant is cos(p / 2)."""
    apart_s, phase = 90.0, 2 * np.arccos(resultant)
    frequency = (9 + phase / (2 * np.pi)) / apart_s  # one period in a segment, ten in the run
    assert _may_be_a_line(_segments([0.0, apart_s], 10.0), frequency) == line


def test_errors_as_declared_are_called_larger_in_one_run_of_a_hundred() -> None:
    """Along three directions of errors as they are declared, the squares are chi-squared of three."""
    squares = np.sum(np.random.default_rng(11).normal(size=(100_000, 3)) ** 2, axis=1)
    larger = [not Declaration(chance, 0.0, 0.0, 0.0, ()).holds for chance in chdtrc(3, squares).tolist()]
    assert np.mean(larger) == pytest.approx(0.01, abs=5 * np.sqrt(0.01 * 0.99 / 1e5))


@pytest.mark.parametrize(("spread_nT", "still"), [(98.0, True), (102.0, False)])
def test_a_field_that_spreads_by_two_per_mille_stands_still(spread_nT: float, still: bool) -> None:
    rows = 400
    field = 5e4 * np.array([0.0, 0.0, 1.0]) + spread_nT * np.where(np.arange(rows) % 2, 1, -1)[:, None] * [1, 0, 0]
    scene = SimpleNamespace(field_nT=field, segment=np.zeros(rows, dtype=np.intp), channels={}, mode=None)
    noise = np.random.default_rng(1).normal(0, 20.0, (rows, 3))
    at_rest: Any = SimpleNamespace(scene=scene, y=noise)
    found = static_noise(at_rest)
    assert found == (pytest.approx(20.0, rel=5 / np.sqrt(2 * 3 * rows)) if still else None)


@pytest.mark.parametrize(("white", "taken"), [(0.4, 0.5), (0.6, 0.6)])
def test_white_noise_is_half_of_what_was_measured_at_least(
    started: Callable[..., LinearProblem], white: float, taken: float
) -> None:
    """Of a residual that is white, in units of the measured noise; none is declared."""
    problem = started()
    run = replace(problem.run, dut=replace(problem.run.dut, noise_nT=None))
    y = np.random.default_rng(3).normal(size=problem.y.shape)
    pool = candidates_of(run, replace(problem, y=white * y / np.sqrt(np.mean(y**2))))
    assert pool.null_model().null.level == pytest.approx(taken, rel=0.02)
