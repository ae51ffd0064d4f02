"""What a run declares moves the fitted parameters as the same fit of the run that it would have been."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from wrong_lab import Declared

from labcal.fit.declared import contributions
from labcal.fit.vector.declared import declared_contributions
from labcal.fit.vector.ml import estimate, ml
from labcal.loop.close import prepare
from labcal.loop.selection.joint_fit import JointFit, joint_fit
from labcal.loop.uncertainty import of_the_file, uncertainty_of
from labcal.model import AffineMap
from labcal.model.effects import family
from labcal.model.sensor_figures import figures_jacobian
from labcal.record import Run
from labcal.testing.made_up_runs import made_up_run
from labcal.uncertainty import covariance_of, declared_errors
from labcal.uncertainty.beside_declared import LARGEST, beside_declared

DECLARED = Declared(scale_ppm=400.0, zero_nT=30.0, align_deg=0.2, body_deg=0.25)


def _parameters(found: JointFit) -> np.ndarray:
    return np.concatenate(
        [found.problem.parameterisation.nearest(found.problem.theta), found.problem.phase, *found.beta]
    )


def _fitted(run: Run) -> JointFit:
    term = family("offset-current").candidates(run)[0]
    return joint_fit(prepare(run)[0], [term])


def test_every_declared_error_moves_the_loop_s_map_and_effect_as_a_fit_of_the_run_it_would_have_been(recorded) -> None:
    run, _ = recorded(1, DECLARED, effect="offset-current", rows=24)
    run = replace(run, reference=replace(run.reference, u_time_s=0.02))
    found = _fitted(run)
    contributions = uncertainty_of(found).declared
    errors = declared_errors(run)
    assert [c.source for c in contributions] == [e.source for e in errors]
    assert len(errors) == 1 + 3 + 3 + 3 + 1
    u = np.sqrt(np.diag(found.covariance))
    for error, contribution in zip(errors, contributions, strict=True):
        moved = _parameters(_fitted(error.change(run))) - _parameters(found)
        away = moved - contribution.shift
        assert np.abs(away / u).max() < 0.02 * np.abs(moved / u).max() + 0.05, error.source


@pytest.mark.parametrize("kind", ["vector", "scalar"])
def test_every_declared_error_moves_the_fit_as_a_fit_of_the_run_it_would_have_been(recorded, kind: str) -> None:
    run, _ = recorded(2, replace(DECLARED, kind=kind), rows=24)
    found = estimate(run, robust=False)
    parts = found.observations, found.noise, found.parameterisation, found.solution
    u = np.sqrt(np.diag(found.covariance))
    contributions = declared_contributions(run, *parts)
    assert len(contributions) == (10 if kind == "vector" else 5)
    for error, contribution in zip(declared_errors(run), contributions, strict=True):
        moved = estimate(error.change(run), robust=False).affine.parameters - found.affine.parameters
        assert np.abs((moved - contribution.shift) / u).max() < 0.02 * np.abs(moved / u).max() + 0.05, error.source


def test_a_turn_in_the_body_and_a_scale_are_what_they_are_in_closed_form(recorded) -> None:
    run, _ = recorded(3, Declared(scale_ppm=400.0, body_deg=0.25), rows=24)
    found = estimate(run, robust=False)
    parts = found.observations, found.noise, found.parameterisation, found.solution
    new = sum(np.outer(c.shift, c.shift) for c in declared_contributions(run, *parts))
    old = covariance_of(contributions(run, found.affine, frame_known=True), 12)
    size = np.sqrt(np.diag(old))
    assert np.allclose(new / np.outer(size, size), old / np.outer(size, size), atol=0.05)


def test_a_turn_of_the_axes_is_no_change_of_scale_and_no_angle_between_axes(recorded) -> None:
    """Of a turn by 2° the square is 600 ppm: it is no sensitivity (GUM, 5.1.3), and no scale of the sensor."""
    run, _ = recorded(3, Declared(body_deg=2.0), effect="offset-current", rows=24)
    found, of_loop = estimate(run, robust=False), _fitted(run)
    parts = found.observations, found.noise, found.parameterisation, found.solution
    shipped = of_the_file(of_loop, uncertainty_of(of_loop), [True]).sources.declared
    for turns, theta in (
        (declared_contributions(run, *parts), found.affine.parameters),
        (shipped, of_loop.problem.affine.parameters),
    ):
        J = figures_jacobian(theta)
        moved = np.array([J @ turn.shift[:12] for turn in turns])
        assert len(moved) == 3
        assert np.abs(np.hstack([moved[:, :3], np.radians(moved[:, 6:])])).max() < 1.5e-4


def test_a_magnitude_s_zero_is_a_larger_field(recorded) -> None:
    run, _ = recorded(4, Declared(zero_nT=300.0, kind="scalar"), rows=24)
    found = estimate(run, robust=False)
    (contribution,) = declared_contributions(
        run, found.observations, found.noise, found.parameterisation, found.solution
    )
    by_scalars = covariance_of(contributions(run, found.affine, frame_known=False), 12)
    assert np.allclose(by_scalars, np.outer(contribution.shift, contribution.shift), atol=0.1 * by_scalars.max())
    F, b = run.magnitude_nT, found.affine.apply(run.reading)
    more = AffineMap.from_parameters(found.affine.parameters + contribution.shift).apply(run.reading)
    larger = np.linalg.norm(more, axis=1) / np.linalg.norm(b, axis=1) - 1
    assert larger == pytest.approx(300.0 * F.sum() / (F @ F), rel=0.05)  # what a gain can take up of it


@pytest.mark.parametrize("stated", [{"u_scale_ppm": 5000.0}, {"u_offset_nT": 300.0}])
def test_a_reference_declared_a_hundred_times_worse_is_in_map_and_effect(
    recorded: Callable[..., tuple[Run, object]], stated: dict[str, float]
) -> None:
    run, _ = recorded(5, Declared(scale_ppm=50.0, zero_nT=3.0), effect="offset-current", rows=24)
    worse = replace(run, reference=replace(run.reference, **stated))
    before, after = (_fitted(r) for r in (run, worse))
    wide = {r: uncertainty_of(fit) for r, fit in (("before", before), ("after", after))}
    u = {when: np.sqrt(np.diag(of.covariance)) for when, of in wide.items()}
    map_or_k = [0, 4, 8] if "u_scale_ppm" in stated else [9, 10, 11]
    assert np.all(u["after"][map_or_k] > 10 * u["before"][map_or_k])
    assert np.allclose(before.covariance, after.covariance, rtol=1e-6)


def test_a_declared_scale_that_does_not_show_takes_nothing_off_the_noise() -> None:
    """Beside the map a scale leaves only itself times the residual: no less noise is known with it than without."""
    run = made_up_run(noise_nT=15.0, rows=60, seed=1).run
    noisy = run.reference_vector + np.random.default_rng(3).normal(0, 3.0, (len(run), 3))
    run = replace(run, reference_vector=noisy, reference=replace(run.reference, noise_nT=3.0))
    stated = replace(run, reference=replace(run.reference, u_scale_ppm=50.0))
    plain, beside = (uncertainty_of(joint_fit(prepare(r)[0], [])).noise.covariance for r in (run, stated))
    assert np.sqrt(np.diag(beside)) == pytest.approx(np.sqrt(np.diag(plain)), rel=0.02)
    fits = [ml(replace(r, dut=replace(r.dut, noise_nT=None))).covariance for r in (run, stated)]
    assert np.sqrt(np.diag(fits[1])[9:]) == pytest.approx(np.sqrt(np.diag(fits[0])[9:]), rel=0.05)


@pytest.mark.parametrize("declared_noise", [True, pytest.param(False, marks=pytest.mark.slow)])
def test_what_declared_errors_leave_in_the_residual_is_no_noise_of_the_device(recorded, declared_noise: bool) -> None:
    """A reference that stands askew leaves its own error beside the map: no reading of the device has it."""
    wrong = Declared(zero_nT=60.0, align_deg=0.4)
    run, found = recorded(6, wrong, rows=60)
    if not declared_noise:
        run = replace(run, dut=replace(run.dut, noise_nT=None))
    stated = ml(run)
    nothing = ml(replace(run, reference=replace(run.reference, u_offset_nT=None, u_align_deg=None)))
    less = ml(replace(run, reference=replace(run.reference, u_offset_nT=1.0, u_align_deg=0.01)))
    assert stated.noise_nT == pytest.approx(found.noise_nT, rel=0.15)
    assert nothing.noise_nT > 2 * found.noise_nT  # where nobody says that it may be askew, it stays in what is found
    assert less.noise_nT > 2 * found.noise_nT  # and where it is more askew than they say


def test_what_declared_errors_leave_is_no_structure_that_the_loop_leaves(recorded) -> None:
    run, found = recorded(6, Declared(zero_nT=60.0, align_deg=0.4), rows=24)
    less = replace(run, reference=replace(run.reference, u_offset_nT=1.0, u_align_deg=0.01))
    parts, left = [], []
    for one in (run, less):
        fitted = joint_fit(prepare(one)[0], [])
        parts.append(uncertainty_of(fitted).beside_declared)
        left.append(float(np.sqrt(np.mean(fitted.problem.residual_nT**2))))
    assert np.sqrt(parts[0]) * left[0] == pytest.approx(found.noise_nT, rel=0.15)
    assert np.sqrt(parts[1]) * left[1] > 3 * found.noise_nT


def test_no_more_is_taken_off_than_a_declared_error_can_be() -> None:
    draw = np.random.default_rng(1)
    noise, shape = draw.normal(size=(300, 3)), draw.normal(size=(300, 3, 1))
    for size, stays in ((2.0, 0.0), (20.0, 20.0 - LARGEST)):
        rest = beside_declared(noise + size * 4.0 * shape[:, :, 0], 4.0 * shape)
        along = float(np.sum(rest * shape[:, :, 0]) / np.sum(shape**2)) / 4.0
        assert along == pytest.approx(stays, abs=0.03)
    small = 1e-3 * shape
    assert beside_declared(noise, small) == pytest.approx(noise)  # it cannot show in so much noise
