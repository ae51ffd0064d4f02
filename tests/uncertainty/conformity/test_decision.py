"""Decisions and their risks, beside numerical integration and the published figures of JCGM 106 and ILAC G8."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.stats import norm

from labcal.record import Limit, Specification
from labcal.uncertainty.conformity import judge, ratio_in_words, risk_of_accepting
from labcal.uncertainty.conformity.decision import Measured, decide


def integrated(value: float, u: float, low: float, high: float) -> float:
    """1 less the integral of the normal density over [low, high], term by term in plain numpy."""

    def density(x: float) -> float:
        return float(np.exp(-(((x - value) / u) ** 2) / 2) / (u * np.sqrt(2 * np.pi)))

    below = quad(density, min(low, value - 12 * u) - 12 * u, low, epsabs=1e-15)[0] if np.isfinite(low) else 0.0
    above = quad(density, high, max(high, value + 12 * u) + 12 * u, epsabs=1e-15)[0]
    return below + above


@pytest.mark.parametrize("value", [-1.4, -1.0, -0.3, 0.0, 0.7, 0.99, 1.0, 1.01, 1.6])
@pytest.mark.parametrize("u", [0.05, 0.2, 0.9, 4.0])
def test_the_risk_is_the_integral_of_the_density_beyond_the_limit(value: float, u: float):
    assert risk_of_accepting(value, u, 1.0) == pytest.approx(integrated(value, u, -1.0, 1.0), abs=1e-9)
    assert risk_of_accepting(value, u, 1.0, signed=False) == pytest.approx(integrated(value, u, -np.inf, 1.0), abs=1e-9)


def test_the_examples_of_jcgm_106():
    """7.3: a Zener diode (upper limit) and a container (lower limit); 7.4: a motor oil between two limits."""
    diode = risk_of_accepting(-5.47, 0.05, -5.40, signed=False)
    container = risk_of_accepting(-509.7, 8.6, -490.0, signed=False)
    oil = risk_of_accepting(13.6 - 14.4, 1.8, 1.9)  # between 12.5 and 16.3
    assert [round(1 - risk, 2) for risk in (diode, container, oil)] == [0.92, 0.99, 0.66]


@pytest.mark.parametrize(("p", "z"), [(0.80, 0.84), (0.90, 1.28), (0.95, 1.64), (0.99, 2.33), (0.999, 3.09)])
def test_table_1_of_jcgm_106(p: float, z: float):
    """Conformance probabilities of one-sided limits by z = (T - y) / u, there to two decimals of z."""
    assert 1 - risk_of_accepting(0.0, 1.0, z - 0.005, signed=False) < p
    assert 1 - risk_of_accepting(0.0, 1.0, z + 0.005, signed=False) > p


@pytest.mark.parametrize(("r", "stated"), [(3.0, 1e-6), (1.5, 0.0016), (1.0, 0.025), (0.83, 0.05), (0.0, 0.50)])
def test_table_1_of_ilac_g8(r: float, stated: float):
    """The risk of false acceptance at the acceptance limit stays below what the guide states, and is near it."""
    rule = Specification(offset=Limit(10.0, "nT"), r=r)
    at_limit = judge(Measured("offset", "offset x", 10.0 - r * 2 * 0.5, 0.5), Limit(10.0, "nT"), rule)
    assert at_limit.result == "pass"
    assert at_limit.risk == pytest.approx(norm.sf(2 * r), abs=1e-12)
    assert at_limit.risk <= stated
    assert at_limit.risk > 0.8 * stated or r == 3.0


def test_a_small_risk_keeps_its_digits():
    assert risk_of_accepting(0.0, 1.0, 9.0) == pytest.approx(2 * 1.1285884e-19, rel=1e-6)


@pytest.mark.parametrize(
    ("size", "result"),
    [
        (79.9, "pass"),
        (80.0, "pass"),
        (80.1, "conditional-pass"),
        (100.0, "conditional-pass"),
        (100.1, "conditional-fail"),
        (120.0, "conditional-fail"),
        (120.1, "fail"),
    ],
)
def test_the_four_results_with_a_guard_band(size: float, result: str):
    rule = Specification(offset=Limit(100.0, "nT"), r=0.5)
    for value in (size, -size):
        line = judge(Measured("offset", "offset x", value, 20.0), Limit(100.0, "nT"), rule)
        assert (line.result, line.U, line.tur) == (result, 40.0, 2.5)
        assert line.rule.startswith("guard band w = 0.5 U (ILAC G8:09/2019, 4.2.3")


def test_simple_acceptance_knows_two_results():
    rule = Specification(offset=Limit(100.0, "nT"), rule="simple-acceptance", r=1.0)
    results = {
        judge(Measured("offset", "o", v, 20.0), Limit(100.0, "nT"), rule).result for v in np.linspace(0, 200, 41)
    }
    assert results == {"pass", "fail"}
    assert decide(100.0, 100.0, 0.0) == "pass"
    line = judge(Measured("offset", "o", 100.0, 20.0), Limit(100.0, "nT"), rule)
    assert line.rule.startswith("simple acceptance, w = 0 (ILAC G8:09/2019, 4.2.1")
    assert line.risk == pytest.approx(0.5, abs=1e-6)


def test_a_band_wider_than_the_limit_passes_nothing():
    rule = Specification(offset=Limit(10.0, "nT"))
    line = judge(Measured("offset", "o", 0.0, 8.0), Limit(10.0, "nT"), rule)
    assert (line.result, line.tur) == ("conditional-pass", 0.625)


@pytest.mark.parametrize(
    ("measured", "limit", "value", "U"),
    [
        (Measured("offset", "q", 1500.0, 50.0), Limit(2.0, "uT"), 1.5, 0.1),
        (Measured("offset", "q", 1500.0, 50.0), Limit(2e6, "pT"), 1.5e6, 1e5),
        (Measured("scale", "q", -0.004, 1e-4), Limit(0.5, "%"), -0.4, 0.02),
        (Measured("scale", "q", -0.004, 1e-4), Limit(5000, "ppm"), -4000.0, 200.0),
        (Measured("non_orthogonality", "q", 0.5, 0.01), Limit(60, "arcmin"), 30.0, 1.2),
        (Measured("non_orthogonality", "q", 0.5, 0.01), Limit(10, "mrad"), 8.726646, 0.349066),
        (Measured("linearity", "q", 25.0, 2.5, full_scale_nT=50_000.0), Limit(0.1, "%"), 0.05, 0.01),
        (Measured("linearity", "q", 25.0, 2.5, full_scale_nT=50_000.0), Limit(100, "nT"), 25.0, 5.0),
    ],
)
def test_a_line_is_in_the_unit_of_its_limit(measured: Measured, limit: Limit, value: float, U: float):
    line = judge(measured, limit, Specification(offset=Limit(1.0, "nT")))
    assert (line.value, line.U) == (pytest.approx(value, rel=1e-6), pytest.approx(U, rel=1e-6))
    assert (line.unit, line.limit, line.tur) == (limit.unit, limit.limit, pytest.approx(limit.limit / U, rel=1e-6))
    assert line.risk == pytest.approx(risk_of_accepting(value, U / 2, limit.limit), abs=1e-12)


def test_a_figure_known_exactly_has_no_ratio():
    line = judge(Measured("offset", "o", 3.0, 0.0), Limit(10.0, "nT"), Specification(offset=Limit(10.0, "nT")))
    assert (line.result, line.risk, line.tur) == ("pass", 0.0, None)


@pytest.mark.parametrize("dof", [3.0, 6.4, 30.0])
@pytest.mark.parametrize("value", [-0.9, 0.0, 0.4, 1.0, 1.3])
def test_few_degrees_of_freedom_widen_u_and_the_risk(value: float, dof: float):
    """Beside draws of t: a chi squared behind every normal one (JCGM 101, 6.4.9.7)."""
    draw, u, n = np.random.default_rng(8), 0.2, 400_000
    drawn = value + u * draw.standard_normal(n) * np.sqrt(dof / draw.chisquare(dof, n))
    line = judge(
        Measured("offset", "offset x", value, u, dof=dof), Limit(1.0, "nT"), Specification(offset=Limit(1.0, "nT"))
    )
    assert line.risk == pytest.approx(np.mean(np.abs(drawn) > 1.0), abs=4 * 0.5 / np.sqrt(n))
    assert np.mean(np.abs(drawn - value) < line.U) == pytest.approx(0.9545, abs=4 * 0.21 / np.sqrt(n))
    assert line.tur == pytest.approx(1.0 / line.U)


def test_a_pass_at_the_edge_of_the_guard_band_has_the_same_risk_for_few_degrees_of_freedom():
    """2.3 % (docs/certificate.md); with k = 2 six degrees of freedom would leave 4.6 %."""
    limit = Limit(10.0, "nT")
    at_edge = 10.0 - 2.516528 * 0.5  # t of 97.725 %
    line = judge(Measured("offset", "offset x", at_edge, 0.5, dof=6.0), limit, Specification(offset=limit))
    assert line.risk == pytest.approx(0.02275, rel=1e-3)


@pytest.mark.parametrize(
    ("ratio", "words"), [(None, "–"), (0.0412, "0.041"), (0.98, "0.98"), (3.96, "4.0"), (37.5, "37.5"), (4e4, "> 1000")]
)
def test_a_ratio_below_one_keeps_its_figures(ratio: float | None, words: str):
    assert ratio_in_words(ratio) == words
