"""The budget of a calibration: every number of it beside a Monte Carlo, another's propagator, and what `apply` says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import monte_carlo
import numpy as np
import pytest
import wrong_lab
from scipy.signal import lfilter
from trials import as_run, calibrated
from wrong_lab import Declared

from labcal.certificate.parameters_k import k_of_sources
from labcal.loop.close import prepare
from labcal.loop.noise.bands import cosine_transform
from labcal.loop.noise.bounded import weighted_spectra
from labcal.loop.noise.coloured import grams_of_bands
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import Calibration
from labcal.model.affine import AffineMap
from labcal.model.effects import family
from labcal.uncertainty import Contribution, FitNoise, Sources
from labcal.uncertainty.budget import PROBABILITY, Budget, Row, coverage_factor
from labcal.uncertainty.of_calibration import NOISE, ONE_READING, field_budgets, figure_budgets

GTC = pytest.importorskip("GTC", reason="the extra dev has it")
DECLARED = Declared(scale_ppm=400.0, zero_nT=30.0, align_deg=0.05, body_deg=0.05)
CLUMSY = replace(DECLARED, body_deg=0.25)
Made = tuple[Calibration, Sources]
FIGURES = [f"{what} {axis}" for what in ("scale", "zero reading") for axis in "xyz"] + [
    f"off 90° {pair}" for pair in ("x–y", "y–z", "z–x")
]


def calibration_of(declared: Declared) -> Made:
    """A calibration with a current at work, and what it is made of."""
    run = as_run(wrong_lab.record(1, declared, effect="offset-current", rows=24))
    found = joint_fit(prepare(run)[0], [family("offset-current").candidates(run)[0]])
    return calibrated(run, effect="offset-current"), of_the_file(found, uncertainty_of(found), [True]).sources


@pytest.fixture(scope="module")
def made() -> Made:
    """Of a run that declares everything."""
    return calibration_of(DECLARED)


def point(budget: Mapping[str, Any]) -> tuple[int, np.ndarray, float | None]:
    """The component, the field in nT and the current that a budget of the field names."""
    size, _, direction = budget["at"].partition(" µT along ")
    sign, axis = direction[0], "xyz".index(direction[1])
    current = float(budget["at"].partition("i_eps = ")[2]) if "i_eps" in budget["at"] else None
    field = float(size) * 1000 * (-1 if sign == "−" else 1) * np.eye(3)[axis]
    return "xyz".index(budget["quantity"][-1]), field, current


def theta_of(c: Calibration) -> np.ndarray:
    return np.concatenate([c.affine.parameters, [p.value for p in c.effects[0].parameters]])


def reading_and_load(c: Calibration, field: np.ndarray, current: float | None) -> tuple[np.ndarray, float]:
    """The reading that gives that field, and the current less its reference value."""
    zero = c.k_at["i_eps"]
    load = (zero if current is None else current) - zero
    coupling = np.array([p.value for p in c.effects[0].parameters])
    return np.linalg.solve(c.affine.K, field + c.affine.k_nT + load * coupling), load


def test_the_end_gauge_of_the_gum_comes_out() -> None:
    """GUM, H.1: u_c = 32 nm, ν_eff = 16.7, of contributions in nm with 18, 25.6, 50 and 2 degrees of freedom."""
    rows = [(25.0, 18.0), (9.7, 25.6), (2.9, 50.0), (16.6, 2.0)]
    budget = Budget(
        "l", "", "nm", tuple(Row(str(n), "A", "normal", u, "nm", 1.0, dof) for n, (u, dof) in enumerate(rows))
    )
    assert budget.u == pytest.approx(31.7, abs=0.05)
    assert budget.dof == pytest.approx(16.7, abs=0.1)
    assert coverage_factor(16, 0.99) == pytest.approx(2.92, abs=0.005)
    assert coverage_factor(np.inf) == pytest.approx(2.0, abs=0.0005)


def test_shares_are_of_the_whole_and_u_is_their_root_sum(made: Made) -> None:
    for budget in made[0].budget:
        effects = [row["u"] * row["sensitivity"] for row in budget["rows"]]
        assert sum(row["share"] for row in budget["rows"]) == pytest.approx(1.0, abs=1e-3)
        assert np.sqrt(np.sum(np.square(effects))) == pytest.approx(budget["U"] / budget["k"], rel=1e-3)
        assert all(row["type"] == ("B" if row["dof"] is None else "A") for row in budget["rows"])


def test_the_points_are_the_ends_of_the_working_range(made: Made) -> None:
    c, _ = made
    low, high = (f"{v / 1000:.4g} µT along" for v in c.validity.field_nT)
    at = [b["at"] for b in c.budget if b["quantity"] == "b z"]
    assert sum(a.startswith(high) for a in at) == 6 + 2 * 3
    assert sum(a.startswith(low) for a in at) == 3
    assert {a.partition("i_eps = ")[2] for a in at} == {"", "0", "0.4"}
    assert [b["quantity"] for b in c.budget[-9:]] == FIGURES


def test_a_budget_of_the_field_says_what_apply_says(made: Made) -> None:
    c, _ = made
    of_field = c.budget[:-9]
    for three in zip(of_field[::3], of_field[1::3], of_field[2::3], strict=True):
        _, field, current = point(three[0])
        reading, _ = reading_and_load(c, field, current)
        current = c.k_at["i_eps"] if current is None else current
        said = c.apply([reading] * 3, channels={"i_eps": [current] * 3})
        assert said.flags[1] == ""
        u = np.sqrt(np.mean([(b["U"] / b["k"]) ** 2 for b in three]))
        assert u == pytest.approx(said.u_nT[1], rel=2e-3), three[0]["at"]


def test_a_monte_carlo_disagrees_nowhere_by_more_than_its_own_tolerance(made: Made) -> None:
    """To the second digit of u (JCGM 101, 8); a budget a tenth too large is seen."""
    far = disagreements(*made, digits=2)
    assert max(far.values()) < 1.0, max(far, key=far.__getitem__)
    c, sources = made
    wider = tuple({**b, "U": 1.1 * b["U"]} for b in c.budget)
    assert min(disagreements(replace(c, budget=wider), sources, digits=2).values()) > 1.0


@pytest.mark.slow
def test_nor_with_so_many_draws_that_their_own_scatter_is_nothing(made: Made) -> None:
    far = disagreements(*made, digits=2, blocks=150)
    assert max(far.values()) < 1.0, max(far, key=far.__getitem__)


@pytest.mark.slow
def test_of_a_large_turn_s_second_order_only_the_second_digit_knows() -> None:
    """Of 50 µT a turn of 0.25° takes 1 nT off, which no sensitivity shows (GUM, F.2.4.4): 0.02 of u."""
    far = disagreements(*calibration_of(CLUMSY), digits=1)
    assert max(far.values()) < 1.0, max(far, key=far.__getitem__)


def disagreements(c: Calibration, sources: Sources, digits: int, blocks: int = 1) -> dict[tuple[str, str], float]:
    """y ± U from the interval of the draws, in units of δ and four times the draws' own scatter; of every budget.

    The interval's ends are means over blocks of draws (JCGM 101, 7.9.4).
    """
    found = [_ends(c, sources, seed) for seed in range(1, blocks + 1)]
    drawn = np.mean(found, axis=0)
    scatter = 4 * monte_carlo.spread_of_ends(blocks * monte_carlo.DRAWS, PROBABILITY)
    values = [*(point(b)[1][point(b)[0]] for b in c.budget[:-9]), *figures_of_map(c)]
    far = {}
    for budget, y, (low, high) in zip(c.budget, values, drawn, strict=True):
        U = budget["U"]
        u = U / budget["k"]
        allowed = monte_carlo.tolerance(u, digits) + scatter * u
        far[budget["quantity"], budget["at"]] = max(abs(y - U - low), abs(y + U - high)) / allowed
    return far


def _ends(c: Calibration, sources: Sources, seed: int) -> list[np.ndarray]:
    """Of every budget, by one block of draws."""
    drawn = monte_carlo.draws(theta_of(c), sources, c.metrics["after"]["noise_nT"], seed)
    found = []
    for budget in c.budget[:-9]:
        axis, field, current = point(budget)
        found.append(monte_carlo.field(drawn, *reading_and_load(c, field, current))[:, axis])
    return [monte_carlo.ends(values, PROBABILITY) for values in (*found, *monte_carlo.figures(drawn).T)]


def figures_of_map(c: Calibration) -> np.ndarray:
    one = monte_carlo.Drawn(c.affine.K[None], c.affine.k_nT[None], np.zeros((1, 3)), np.zeros((1, 3)))
    return monte_carlo.figures(one)[0]


class Tree:
    """The same inputs in the GUM Tree Calculator (MSL, New Zealand): uncertain numbers with a chain rule."""

    def __init__(self, c: Calibration, sources: Sources) -> None:
        theta, noise = theta_of(c), sources.noise
        u = np.sqrt(np.diag(noise.covariance))
        fitted = GTC.multiple_ureal([0.0] * len(theta), u.tolist(), noise.dof, [f"p{i}" for i in range(len(theta))])
        for i in range(len(theta)):
            for j in range(i):
                GTC.set_correlation(float(noise.covariance[i, j] / u[i] / u[j]), fitted[i], fitted[j])
        self.declared = {one.source: GTC.ureal(0.0, one.u) for one in sources.declared}
        per_unit = [(self.declared[one.source], one.shift / one.u) for one in sources.declared]
        self.theta = [
            float(value) + fitted[i] + sum(float(slope[i]) * error for error, slope in per_unit)
            for i, value in enumerate(theta)
        ]
        self.reading = [GTC.ureal(0.0, c.metrics["after"]["noise_nT"]) for _ in "xyz"]

    def field(self, axis: int, reading: np.ndarray, load: float) -> Any:
        K, k, coupling = self.theta[3 * axis : 3 * axis + 3], self.theta[9 + axis], self.theta[12 + axis]
        return (
            sum(a * (float(m) + noise) for a, m, noise in zip(K, reading, self.reading, strict=True))
            - k
            - load * coupling
        )

    def figures(self) -> list[Any]:
        """By Cramer's rule: the rows of K⁻¹ are cross products of K's columns over its determinant."""
        K = [[self.theta[3 * i + j] for j in range(3)] for i in range(3)]
        columns = [[K[i][j] for i in range(3)] for j in range(3)]
        crossed = [_cross(columns[(j + 1) % 3], columns[(j + 2) % 3]) for j in range(3)]
        det = _dot(columns[0], crossed[0])
        inverse = [[value / det for value in row] for row in crossed]
        length = [GTC.sqrt(_dot(row, row)) for row in inverse]
        zero = [_dot(row, self.theta[9:12]) for row in inverse]
        angles = [_dot(inverse[a], inverse[b]) / length[a] / length[b] for a, b in ((0, 1), (1, 2), (2, 0))]
        return [*(1 / one for one in length), *zero, *(GTC.asin(one) * (180 / np.pi) for one in angles)]


def _dot(a: list[Any], b: list[Any]) -> Any:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a: list[Any], b: list[Any]) -> list[Any]:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def test_another_propagator_finds_the_same_budget(made: Made) -> None:
    """The same inputs in GTC: combined uncertainty, degrees of freedom, coverage factor, and every declared part."""
    c, sources = made
    noise = sources.noise
    one_model = Sources(FitNoise.single(noise.covariance, noise.dof), sources.declared)  # GTC knows no odds of models
    tree = Tree(c, one_model)
    for budget, there in zip(figure_budgets(c, one_model), tree.figures(), strict=True):
        _same(budget.as_json(), there, tree)
    for budget in c.budget[:-9:7]:
        axis, field, current = point(budget)
        _same(budget, tree.field(axis, *reading_and_load(c, field, current)), tree, dof=None)


def _same(budget: Mapping[str, Any], there: Any, tree: Tree, dof: float | None = 0.02) -> None:
    named = f"{budget['quantity']} {budget['at']}"
    assert there.u == pytest.approx(budget["U"] / budget["k"], rel=2e-3), named
    if dof is not None:
        assert there.df == pytest.approx(budget["dof"], rel=dof), named
        assert GTC.reporting.k_factor(there.df, p=100 * PROBABILITY) == pytest.approx(budget["k"], rel=1e-4), named
    for row in budget["rows"]:
        if row["source"] in tree.declared:
            part = GTC.reporting.u_component(there, tree.declared[row["source"]])
            assert part == pytest.approx(row["u"] * row["sensitivity"], rel=1e-2, abs=2e-3 * there.u), named


def test_a_variance_is_known_as_well_as_its_models_agree() -> None:
    """2 v²/Var(v) by hand: of models 1 and 3, equally likely, with ten degrees of freedom each."""
    each = np.array([np.eye(2), 3 * np.eye(2)])
    noise = FitNoise.of(np.array([0.5, 0.5]), each, 10.0)
    between, within = 1.0, (2 * 1 / 10 + 2 * 9 / 10) / 2
    assert noise.dof_of(np.array([0.0, 2.0])) == pytest.approx(2 * 2**2 / (between + within))
    assert FitNoise.single(np.eye(2), 10.0).dof_of(np.array([1.0, 5.0])) == pytest.approx(10.0)


def test_degrees_of_freedom_are_how_much_u_scatters_over_runs() -> None:
    """Var(u²) = 2 u⁴ / ν over 100 made runs of white noise: a mean and a slope, 60 rows of one component."""
    draw, n = np.random.default_rng(4), 60
    A = np.stack([np.ones(n), np.linspace(-1, 1, n)], axis=1)
    moved, slope = cosine_transform(A[:, None, :]), np.array([0.0, 1.0])
    inverse = np.linalg.inv(A.T @ A)
    variances, stated = [], []
    for _ in range(100):
        y = draw.standard_normal((n, 1))
        found = weighted_spectra(moved, cosine_transform(y))
        white = FitNoise.single(inverse * found.spectra[0, 0], found.dof)
        variances.append(slope @ white.covariance @ slope)
        stated.append(white.dof_of(slope))
    scatter = np.var(variances) / np.mean(variances) ** 2
    assert np.mean(stated) == pytest.approx(2 / scatter, rel=0.5)


def test_degrees_of_freedom_under_correlated_noise_are_how_much_u_scatters_over_runs() -> None:
    """The same for a mean beside noise of a short memory, 600 rows: its variance is known from a few of them only."""
    n, decay = 600, 0.8
    A = np.ones((n, 1, 1))
    moved, inverse = cosine_transform(A), np.eye(1) / n
    variances, stated = [], []
    for seed in range(60):
        draw = np.random.default_rng([seed, 5])
        steps = draw.normal(size=n) * np.where(np.arange(n) == 0, 1.0, np.sqrt(1 - decay**2))
        y = lfilter([1.0], [1.0, -decay], steps)[:, None] + 0.2 * draw.normal(size=(n, 1))
        found = weighted_spectra(moved, cosine_transform(y))
        grams = inverse @ grams_of_bands(moved, found.bands) @ inverse
        noise = FitNoise.of(found.weight, np.tensordot(found.spectra, grams, axes=1), found.dof)
        variances.append(float(noise.covariance[0, 0]))
        stated.append(noise.dof_of(np.ones(1)))
    of_runs = 2 * np.mean(variances) ** 2 / np.var(variances, ddof=1)
    assert np.median(stated) == pytest.approx(of_runs, rel=0.5)
    assert np.quantile(stated, 0.9) < 4 * of_runs  # nor is one run taken for all rows


def test_without_declarations_noise_alone_is_there(made: Made) -> None:
    c, sources = made
    rows = figure_budgets(c, replace(sources, declared=()))[0].rows
    assert [row.source for row in rows] == [NOISE]


def test_counts_are_said_in_counts(made: Made) -> None:
    c, sources = made
    counted = replace(c, dut=replace(c.dut, unit="count"), affine=AffineMap(c.affine.K, c.affine.k_nT))
    assert [b.unit for b in figure_budgets(counted, sources)] == ["nT/count"] * 3 + ["count"] * 3 + ["deg"] * 3


def test_one_reading_s_noise_goes_through_its_own_row_of_the_map(made: Made) -> None:
    c, _ = made
    row = next(r for r in c.budget[0]["rows"] if r["source"] == ONE_READING)
    assert row["sensitivity"] == pytest.approx(np.sqrt(np.sum(c.affine.K[0] ** 2)), rel=1e-5)
    assert row["u"] == pytest.approx(c.metrics["after"]["noise_nT"], rel=1e-5)


def test_declared_noise_of_a_reading_is_taken_as_known_and_found_noise_is_counted(made: Made) -> None:
    c, sources = made
    run = as_run(wrong_lab.record(1, DECLARED, effect="offset-current", rows=24))
    louder = {**c.metrics, "after": {**c.metrics["after"], "noise_nT": 1.2 * wrong_lab.NOISE_nT}}
    silent = replace(run, dut=replace(run.dut, noise_nT=None))
    of_reading = []
    for cal, there in ((c, run), (replace(c, metrics=louder), run), (c, silent)):
        rows = field_budgets(cal, sources, there)[0].rows
        of_reading.append(next((row.type, row.dof) for row in rows if row.source == ONE_READING))
    assert of_reading == [("B", np.inf), ("A", sources.noise.dof), ("A", sources.noise.dof)]


@pytest.mark.parametrize(("zero", "dof", "k"), [(0.0, 6.0, 2.517), (3.0, 600.0, 2.0)])
def test_the_parameter_with_the_fewest_degrees_of_freedom_sets_the_k_of_all(zero: float, dof: float, k: float) -> None:
    """What is declared counts as known: with nine times the noise's variance of it, ν = 6 (10 / 1)²."""
    declared = Contribution("zero", "B", "normal", 1.0, "nT", np.inf, np.array([6.0, zero]))
    sources = Sources(FitNoise.single(np.diag([4.0, 1.0]), 6.0), (declared,))
    assert sources.fewest_dof() == pytest.approx(dof)
    assert k_of_sources(sources) == pytest.approx(k, abs=5e-3)
    assert k_of_sources(None) == 2.0
