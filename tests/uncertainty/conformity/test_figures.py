"""The sensor's figures: beside a sensor built from them, and errors over their own uncertainty on many runs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.fit import draft_calibration, fit
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.record import Dut, Limit, Run, Specification
from labcal.testing.made_up_runs import MadeUp, made_up_run
from labcal.uncertainty.conformity import assess
from labcal.uncertainty.conformity.decision import Measured
from labcal.uncertainty.conformity.of_the_map import figures_of_the_map
from labcal.uncertainty.conformity.of_the_run import autocorrelations, figures_of_the_run

ALL = Specification(
    offset=Limit(5000.0, "nT"),
    scale=Limit(10.0, "%"),
    non_orthogonality=Limit(6.0, "deg"),
    noise=Limit(30.0, "nT"),
    linearity=Limit(0.2, "%"),
    residual=Limit(60.0, "nT"),
)
RUNS = 40


def calibration_of(made: MadeUp | Run, *, holdout: bool = False) -> Calibration:
    run = made.run if isinstance(made, MadeUp) else made
    return draft_calibration(run, fit(run, "ml", holdout=holdout), "0" * 64)


def rms(z: list[float]) -> float:
    return float(np.sqrt(np.mean(np.square(z))))


def test_the_figures_of_the_map_are_those_that_the_sensor_was_built_of():
    """m_i = a_i · b / s_i + zero_i, with directions a_i of known angles; counts of 4 nT."""
    off = np.radians([0.3, -0.2, 0.5])  # of x and y, y and z, z and x, from 90°
    a = np.eye(3)
    a[1, :2] = np.sin(off[0]), np.cos(off[0])
    a[2, 0] = np.sin(off[2])
    a[2, 1] = (np.sin(off[1]) - a[1, 0] * a[2, 0]) / a[1, 1]
    a[2, 2] = np.sqrt(1 - a[2, 0] ** 2 - a[2, 1] ** 2)
    scale, zero = 4.0 * np.array([1.01, 0.98, 1.002]), np.array([50.0, -20.0, 7.0])
    K = np.linalg.inv(a / scale[:, None])
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])  # of the whole sensor
    found = Calibration(
        "r", True, Dut("S", unit="count", nominal_nT_per_unit=4.0), AffineMap(turn @ K, turn @ K @ zero), None, True,
        Validity((0.0, 5e4)), (0.0, 1.0), "0" * 64,
    )  # fmt: skip
    values = [one.value for one in figures_of_the_map(found)]
    np.testing.assert_allclose(values, [200, -80, 28, 0.01, -0.02, 0.002, 0.3, -0.2, 0.5], rtol=0, atol=1e-9)
    assert all(np.isnan(one.u) for one in figures_of_the_map(found))


def test_their_uncertainty_is_the_scatter_of_draws_of_the_covariance():
    found = calibration_of(made_up_run())
    draws = np.random.default_rng(1).multivariate_normal(found.affine.parameters, found.covariance, 1500)
    scattered = [
        [one.value for one in figures_of_the_map(replace(found, affine=AffineMap.from_parameters(t), covariance=None))]
        for t in draws
    ]
    stated = [one.u for one in figures_of_the_map(found)]
    np.testing.assert_allclose(np.std(scattered, axis=0), stated, rtol=0.08)


def of_the_truth(made: MadeUp, run: Run) -> list[Measured]:
    """The run's figures beside the map that its readings were made with."""
    found = Calibration("r", True, run.dut, made.true, None, True, Validity((0.0, 5e4)), (0.0, 1.0), "0" * 64)
    return list(figures_of_the_run(found, run))


def bent(made: MadeUp, cubic_nT: tuple[float, float, float]) -> Run:
    """The run of a sensor whose axes read c (b / 50 µT)³ too high."""
    return made.with_effect(np.array(cubic_nT) * (made.field_nT / 50e3) ** 3)


@pytest.mark.slow
def test_noise_and_linearity_miss_by_as_much_as_they_state():
    """The cube of x is 3/5 P₁ + 2/5 P₃: beside its line it is 2/5 at the ends of the range, in size."""
    noise, linearity, cubic = list[float](), list[float](), dict(zip("xz", (400.0, -250.0), strict=True))
    for seed in range(RUNS):
        made = made_up_run(seed=seed, rows=40)
        found = {one.quantity: one for one in of_the_truth(made, bent(made, (400.0, 0.0, -250.0)))}
        noise.append((found["noise"].value - 25.0) / found["noise"].u)
        for axis, c in cubic.items():
            one, largest = found[f"linearity {axis}"], np.abs(made.field_nT[:, "xyz".index(axis)]).max()
            linearity.append((abs(one.value) - 0.4 * abs(c) * (largest / 50e3) ** 3) / one.u)
    assert 0.7 < rms(noise) < 1.4, rms(noise)
    assert 0.7 < rms(linearity) < 1.4, rms(linearity)


def test_the_reference_s_own_noise_is_not_the_sensor_s():
    """Both draws are independent from row to row here: all of the reference's variance is in the differences."""
    made = made_up_run(seed=5, offers="scalar", noise_nT=20.0, rows=400)
    draw = np.random.default_rng(6).normal(0.0, 8.0, len(made.run))
    noisy = replace(
        made.run,
        reference=replace(made.run.reference, noise_nT=8.0),
        reference_magnitude=made.run.reference_magnitude + draw,
    )
    [told] = [one for one in of_the_truth(made, noisy) if one.figure == "noise"]
    assert abs(told.value - 20.0) < 2 * told.u
    [unstated] = [
        one for one in of_the_truth(made, replace(noisy, reference=made.run.reference)) if one.figure == "noise"
    ]
    assert unstated.value - 20.0 > 3 * unstated.u
    louder = replace(noisy, reference=replace(noisy.reference, noise_nT=60.0))
    assert not [one for one in of_the_truth(made, louder) if one.figure == "noise"]


def test_a_straight_sensor_is_straight_within_its_uncertainty():
    over = []
    for seed in range(RUNS):
        made = made_up_run(seed=seed, rows=40)
        found = [one for one in of_the_truth(made, made.run) if one.figure == "linearity"]
        over += [abs(one.value) > 2 * one.u for one in found]
        assert [one.full_scale_nT for one in found] == pytest.approx(np.abs(made.field_nT).max(axis=0), rel=0.01)
    assert np.mean(over) < 0.15  # the largest over the range is larger than a value at one place


def test_an_effect_that_straightens_the_sensor_leaves_its_linearity_as_it_is():
    made = made_up_run(seed=1, noise_nT=1.0, rows=40, K=np.eye(3))  # an effect of the sensor follows its own axes
    run = bent(made, (400.0, 400.0, 400.0))
    cubic = [Parameter(f"c3_{axis}", 400.0 / 50e3**3, 0.0, "1/nT2") for axis in "xyz"]
    square = [Parameter(f"c2_{axis}", 0.0, 0.0, "1/nT") for axis in "xyz"]
    straightened = EffectRecord("nonlinearity", (), {}, "sensor", (*square, *cubic))
    found = Calibration(
        "r", True, run.dut, made.true, None, True, Validity((0.0, 5e4)), (0.0, 1.0), "0" * 64, (straightened,)
    )
    assert float(np.std(np.linalg.norm(found.apply(run).field_nT, axis=1) - run.magnitude_nT)) < 3.0
    lines = [one for one in figures_of_the_run(found, run) if one.figure == "linearity"]
    assert all(abs(one.value) > 30.0 for one in lines), lines


def test_a_residual_is_the_held_out_rms_of_the_calibration():
    made = made_up_run(rows=40)
    found = replace(calibration_of(made), metrics={"before": {}, "after": {"holdout_rms_nT": 41.0}})
    one = next(one for one in figures_of_the_run(found, made.run) if one.figure == "residual")
    assert one.value == 41.0
    assert one.u == pytest.approx(41.0 / np.sqrt(2 * len(made.run)), rel=0.2)


def test_autocorrelations_are_those_of_the_series_itself():
    draw = np.random.default_rng(3).normal(size=2000)
    y = np.convolve(draw, np.ones(4), "valid")  # rho is 3/4, 1/2, 1/4, 0 …
    direct = [float(y[lag:] @ y[:-lag] / (y @ y)) for lag in (1, 2, 3)]
    np.testing.assert_allclose(autocorrelations(y)[:3], direct, rtol=1e-9)
    assert len(autocorrelations(y)) < 8
    assert len(autocorrelations(np.zeros(100))) == 0


def test_every_figure_of_the_specification_has_its_lines():
    run = replace(made_up_run(rows=40).run, specification=ALL)
    found = calibration_of(run, holdout=True)
    names = [line["quantity"] for line in found.specification]
    axes, pairs = ("x", "y", "z"), ("x-y", "y-z", "z-x")
    assert names == [
        *(f"offset {a}" for a in axes), *(f"scale {a}" for a in axes), *(f"non-orthogonality {p}" for p in pairs),
        "noise", *(f"linearity {a}" for a in axes), "residual",
    ]  # fmt: skip
    assert not [said for said in found.not_covered if "specification" in said]
    assert {line["quantity"]: line["result"] for line in found.specification}["offset x"] == "pass"
    assert {line["quantity"]: line["result"] for line in found.specification}["non-orthogonality x-y"] == "pass"


def test_what_nothing_determines_is_named_and_not_passed():
    run = made_up_run(fields_nT=((30e3, 0.0, 0.0),), rows=60).run
    found = calibration_of(made_up_run())
    told = assess(found, ALL, None)
    assert [line.quantity for line in told.lines if line.quantity in ("noise", "residual")] == []
    assert told.left_open == (
        "Of the specification: noise, which only the run shows, and it is not at hand.",
        "Of the specification: linearity, which only the run shows, and it is not at hand.",
        "Of the specification: residual, which only the run shows, and it is not at hand.",
    )
    bare = assess(replace(found, covariance=None), replace(ALL, noise=None, linearity=None, residual=None), run)
    assert bare.lines == ()
    assert bare.worst is None
    assert bare.left_open[0] == "Of the specification: offset, which has no uncertainty here."
    dark = replace(run, reference=replace(run.reference, kind="none"), reference_vector=None)
    assert len(assess(found, ALL, dark).left_open) == 3
    assert "this run does not determine" in assess(found, ALL, dark).left_open[0]


def test_a_run_without_a_specification_gets_no_lines():
    assert calibration_of(made_up_run()).specification == ()
