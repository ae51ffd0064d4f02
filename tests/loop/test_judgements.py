"""Each judgement where it bites: a little on either side of its value the answer is another one."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from labcal.loop.assemble import verdict_of
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Scored
from labcal.loop.data.outliers import hampel_outliers
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
