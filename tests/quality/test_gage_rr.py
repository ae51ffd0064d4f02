"""Gage R&R against the worked example of the AIAG manual, and against studies whose components are known."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.quality.gage_rr import GageRR, gage_rr

A = [
    [0.29, -0.56, 1.34, 0.47, -0.80, 0.02, 0.59, -0.31, 2.26, -1.36],
    [0.41, -0.68, 1.17, 0.50, -0.92, -0.11, 0.75, -0.20, 1.99, -1.25],
    [0.64, -0.58, 1.27, 0.64, -0.84, -0.21, 0.66, -0.17, 2.01, -1.31],
]
B = [
    [0.08, -0.47, 1.19, 0.01, -0.56, -0.20, 0.47, -0.63, 1.80, -1.68],
    [0.25, -1.22, 0.94, 1.03, -1.20, 0.22, 0.55, 0.08, 2.12, -1.62],
    [0.07, -0.68, 1.34, 0.20, -1.28, 0.06, 0.83, -0.34, 2.19, -1.50],
]
C = [
    [0.04, -1.38, 0.88, 0.14, -1.46, -0.29, 0.02, -0.46, 1.77, -1.49],
    [-0.11, -1.13, 1.09, 0.20, -1.07, -0.67, 0.01, -0.56, 1.45, -1.77],
    [-0.15, -0.96, 0.67, 0.11, -1.45, -0.49, 0.21, -0.49, 1.87, -2.16],
]
AIAG = np.transpose(np.array([A, B, C]), (2, 0, 1))  # part, appraiser, trial


def of(study: GageRR, source: str) -> float:
    return next(c.sd for c in study.components if c.source == source)


def test_the_manual_s_example_has_the_manual_s_figures() -> None:
    """AIAG, Measurement Systems Analysis, 4th edition: ten parts, three appraisers, three trials."""
    study = gage_rr(AIAG, ("part", "appraiser"))
    lines = {line.source: line for line in study.lines}
    assert (lines["part"].dof, lines["appraiser"].dof, lines["part × appraiser"].dof) == (9, 2, 18)
    assert lines["part"].ss == pytest.approx(88.3619, abs=5e-4)
    assert lines["appraiser"].ss == pytest.approx(3.1673, abs=5e-4)
    assert lines["part × appraiser"].ss == pytest.approx(0.3590, abs=5e-4)
    assert lines["repeatability"].ss == pytest.approx(2.7589, abs=5e-4)
    assert pytest.approx(0.434, abs=1e-3) == lines["part × appraiser"].F
    assert lines["part × appraiser"].pooled
    assert of(study, "repeatability") == pytest.approx(0.199933, abs=1e-5)
    assert of(study, "appraiser") == pytest.approx(0.226838, abs=1e-5)
    assert of(study, "gage R&R") == pytest.approx(0.302373, abs=1e-5)
    assert of(study, "part") == pytest.approx(1.042327, abs=1e-5)
    assert study.percent_rr == pytest.approx(27.86, abs=0.01)
    assert study.categories == 4


def drawn(draw: np.random.Generator, sd: tuple[float, ...], shape: tuple[int, int, int, int]) -> np.ndarray:
    """DUT, operator, mounting, DUT × mounting, repeatability."""
    d, o, m, r = shape
    part, who, mounting, both, noise = sd
    values = draw.normal(0, part, (d, 1, 1, 1)) + draw.normal(0, who, (1, o, 1, 1))
    values = values + draw.normal(0, mounting, (1, 1, m, 1)) + draw.normal(0, both, (d, 1, m, 1))
    return values + draw.normal(0, noise, (d, o, m, r))


def test_components_of_three_crossed_factors_are_found_without_bias() -> None:
    draw, sd = np.random.default_rng(1), (10.0, 2.0, 3.0, 1.5, 1.0)
    studies = [gage_rr(drawn(draw, sd, (8, 4, 4, 2)), ("DUT", "operator", "mounting")) for _ in range(30)]
    for source, true in zip(("DUT", "operator", "mounting", "DUT × mounting", "repeatability"), sd, strict=True):
        found = np.array([of(s, source) ** 2 if any(c.source == source for c in s.components) else 0 for s in studies])
        assert found.mean() == pytest.approx(true**2, abs=4 * found.std() / np.sqrt(len(studies)))


def test_three_crossed_factors_are_taken_apart_as_a_textbook_does_it() -> None:
    """Sums of squares from totals, components from expected mean squares (Montgomery, Design and Analysis, ch. 13)."""
    y = drawn(np.random.default_rng(8), (5.0, 2.0, 1.5, 3.0, 0.5), (6, 3, 4, 2))
    y = y + np.random.default_rng(9).normal(0, 2, (6, 3, 4, 1)) + np.random.default_rng(10).normal(0, 4, (1, 3, 4, 1))
    a, b, c, n = y.shape
    [A, B, C] = (_of_totals(y, (i,)) for i in range(3))
    AB, AC, BC = (_of_totals(y, pair) - s for pair, s in (((0, 1), A + B), ((0, 2), A + C), ((1, 2), B + C)))
    ABC = _of_totals(y, (0, 1, 2)) - A - B - C - AB - AC - BC
    error = float((y**2).sum() - (y.sum(axis=3) ** 2).sum() / n) / (a * b * c * (n - 1))
    three = ABC / ((a - 1) * (b - 1) * (c - 1))
    two = {"O": AB / ((a - 1) * (b - 1)), "M": AC / ((a - 1) * (c - 1)), "O × M": BC / ((b - 1) * (c - 1))}
    wanted = {
        "repeatability": error,
        "D × O × M": (three - error) / n,
        "D × M": (two["M"] - three) / (b * n),
        "O × M": (two["O × M"] - three) / (a * n),
        "D": (A / (a - 1) - two["O"] - two["M"] + three) / (b * c * n),
    }
    found = gage_rr(y, ("D", "O", "M"))
    assert not any(line.pooled for line in found.lines)
    for source, variance in wanted.items():
        assert of(found, source) ** 2 == pytest.approx(max(0.0, variance), rel=1e-9), source


def _of_totals(y: np.ndarray, kept: tuple[int, ...]) -> float:
    totals = y.sum(axis=tuple(i for i in range(4) if i not in kept))
    return float((totals**2).sum() * totals.size / y.size - y.sum() ** 2 / y.size)


@pytest.mark.slow
def test_intervals_hold_what_they_say() -> None:
    """95 % intervals of the gage over 150 studies: neither too narrow nor so wide that they say nothing."""
    draw, inside, true = np.random.default_rng(2), 0, np.sqrt(2.0**2 + 3.0**2 + 1.5**2 + 1.0**2)
    for _ in range(150):
        study = gage_rr(drawn(draw, (10.0, 2.0, 3.0, 1.5, 1.0), (6, 3, 3, 2)), ("DUT", "operator", "mounting"))
        low, high = next(c.interval for c in study.components if c.source == "gage R&R")
        inside += low <= true <= high
    assert 0.88 <= inside / 150 < 1.0


def test_a_tolerance_and_a_gage_that_sees_everything() -> None:
    study = gage_rr(AIAG, ("part", "appraiser"), tolerance=10.0)
    assert study.percent_tolerance == pytest.approx(100 * 6 * 0.302373 / 10, abs=1e-3)
    fine = gage_rr(AIAG + 1000 * np.arange(10)[:, None, None], ("part", "appraiser"))
    assert fine.percent_rr < 0.05
    assert fine.categories > 1000


def test_what_cannot_be_taken_apart_is_refused() -> None:
    with pytest.raises(ValueError, match="at least two"):
        gage_rr(AIAG[:1], ("part", "appraiser"))
    with pytest.raises(ValueError, match="the same"):
        gage_rr(np.ones((3, 3, 2)), ("part", "appraiser"))
    with pytest.raises(ValueError, match="missing"):
        gage_rr(np.where(AIAG > 2, np.nan, AIAG), ("part", "appraiser"))
