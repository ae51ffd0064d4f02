"""Turns about known axes in a field of known magnitude: what `ml` makes of their planes, and when."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from labcal.fit.vector.ml import ml
from labcal.fit.vector.planes import forward, observe_planes, sense
from labcal.fit.vector.system import Noise, evaluate, normal
from labcal.geometry import rotate
from labcal.model import AffineMap
from labcal.record import Reference, Run

AXIS = np.array([0.0, 0.0, 1.0])


def magnitudes_of(run: Run, **stated) -> Run:
    """The run as a scalar reference would have seen it; the axes in the body stay, the cage's go."""
    return replace(
        run,
        reference=Reference("scalar"),
        reference_vector=None,
        reference_magnitude=run.magnitude_nT,
        segments=tuple(replace(segment, axis_cage=None, **stated) for segment in run.segments),
    )


def normalised(found, true: AffineMap) -> np.ndarray:
    return (found.affine.parameters - true.parameters) / np.sqrt(np.diag(found.covariance))


@pytest.mark.parametrize("reference_noise", [pytest.param(0.0, marks=pytest.mark.slow), 100.0])
def test_the_rotation_is_known_and_the_error_as_large_as_the_covariance_says(bench, reference_noise: float) -> None:
    seeds, squares = 20, []
    for seed in range(seeds):
        run, true, _ = bench(offers="axis", seed=seed, rows=60)
        run = magnitudes_of(run)
        off = reference_noise * np.random.default_rng([seed, 1]).standard_normal(len(run))
        run = replace(
            run,
            reference=Reference("scalar", noise_nT=reference_noise or None),
            reference_magnitude=run.reference_magnitude + off,
        )
        found = ml(run)
        assert found.frame_known
        error = found.affine.parameters - true.parameters
        squares.append(error @ np.linalg.solve(found.covariance, error))
    assert np.mean(squares) / 12 == pytest.approx(1, abs=3.3 * np.sqrt(2 / (12 * seeds)))  # 99.9 % of chi-squared


@pytest.mark.parametrize("reading_noise", [1.0, 25.0])
def test_the_normal_equations_are_the_derivative_of_the_cost_by_the_heights_too(bench, reading_noise: float) -> None:
    run, true, _ = bench(offers="axis", rows=20, noise_nT=reading_noise)
    seen, noise = observe_planes(magnitudes_of(run)), Noise(reading_noise)
    heights = [np.mean(run.reference_vector[run.rows(index), 2]) + 500.0 for index in range(len(seen.loci))]
    y = np.r_[true.K.ravel() * seen.scale, true.k_nT, heights]

    def half_cost(at: np.ndarray) -> float:
        return 0.5 * float(evaluate(seen, noise, at[:12], at[12:]).cost.sum())

    _, gradient = normal(seen, evaluate(seen, noise, y[:12], y[12:]), np.ones(len(seen)))
    numeric = np.array([half_cost(y + 0.01 * e) - half_cost(y - 0.01 * e) for e in np.eye(len(y))]) / 0.02
    assert gradient[12:] == pytest.approx(numeric[12:], rel=1e-3)
    assert gradient[:12] == pytest.approx(numeric[:12], abs=0.03 * np.abs(gradient[:12]).max())


def test_a_row_of_unknown_height_weighs_the_references_noise_on_its_radius_alone(bench) -> None:
    """Propagated by hand: d radius = |ref| / radius d|ref| at a given height."""
    run, true, _ = bench(offers="axis", rows=20, noise_nT=0.0)
    seen, noise = observe_planes(magnitudes_of(run)), Noise(25.0, 40.0)
    heights = [np.mean(run.reference_vector[run.rows(index), 2]) for index in range(len(seen.loci))]
    at = evaluate(seen, noise, np.r_[true.K.ravel() * seen.scale, true.k_nT], np.array(heights))
    axis, height = seen.axis[7], heights[seen.group[7]]
    across = at.field[7] - (at.field[7] @ axis) * axis
    known = np.stack([axis, across / np.linalg.norm(across)])
    by_reference = np.diag([0.0, (40.0 * seen.magnitude[7]) ** 2 / (seen.magnitude[7] ** 2 - height**2)])
    expected = known @ (25.0**2 * true.K @ true.K.T) @ known.T + by_reference
    assert np.linalg.inv(known @ at.information[7] @ known.T) == pytest.approx(expected, rel=1e-6)


def test_readings_that_are_turned_turn_the_map_back(bench) -> None:
    run, _, _ = bench(offers="axis")
    Q = np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]])
    run = magnitudes_of(run)
    found, turned = ml(run), ml(replace(run, reading=run.reading @ Q.T))
    assert np.allclose(turned.affine.K @ Q, found.affine.K, atol=1e-7)
    assert np.allclose(turned.affine.k_nT, found.affine.k_nT, atol=0.01)


def test_a_turn_back_is_known_by_its_angles_alone(bench) -> None:
    """Half of the loci go round the other way: mirror images of b fit as well, and only the angle tells."""
    run, true, _ = bench(offers="vector")
    rows = np.concatenate([run.rows(i)[::-1] if i % 2 else run.rows(i) for i in range(len(run.segments))])
    back = replace(
        run, reading=run.reading[rows], angle_deg=run.angle_deg[rows], reference_vector=run.reference_vector[rows]
    )
    told, blind = ml(magnitudes_of(back)), ml(replace(magnitudes_of(back), angle_deg=None))
    assert told.frame_known
    assert np.abs(normalised(told, true)).max() < 4.5
    assert blind.ok
    assert not blind.frame_known


@pytest.mark.parametrize("axes", ["xy", "xyz"])
def test_turns_the_other_way_without_angles_are_no_frame(bench, axes: str) -> None:
    """About two axes the wrong sense is half a turn about the third: all fits, and the field would be the opposite."""
    run, true, _ = bench(offers="vector", axes=axes)
    left = [i for i, segment in enumerate(run.segments) if segment.axis_body[2] == 0]
    rows = np.concatenate([run.rows(i)[::-1] if i in left else run.rows(i) for i in range(len(run.segments))])
    back = magnitudes_of(replace(
        run, reading=run.reading[rows], angle_deg=run.angle_deg[rows], reference_vector=run.reference_vector[rows]
    ))  # fmt: skip
    stated, blind = ml(back), ml(replace(back, angle_deg=None))
    assert stated.frame_known
    assert np.abs(normalised(stated, true)).max() < 4.5
    assert blind.ok
    assert not blind.frame_known


def test_a_field_that_turns_meanwhile_leaves_the_rotation_open(bench) -> None:
    """Its magnitude says nothing of its direction, but the heights on one locus then differ: no plane, no frame."""
    run, true, b = bench(offers="axis")
    sway = 300.0 * np.sin(np.arange(len(run)) / 9.0)[:, None]  # nT, along the axes
    moved = b + sway * np.array([run.segments[index].axis_body for index in run.segment_index])
    run = replace(run, reading=run.reading + (moved - b) @ np.linalg.inv(true.K).T)
    found = ml(replace(magnitudes_of(run), reference_magnitude=np.linalg.norm(moved, axis=1)))
    assert found.ok
    assert not found.frame_known
    assert np.allclose(found.affine.K, found.affine.K.T)


def test_the_declared_mounting_of_the_axes_is_in_the_frame_and_not_in_the_magnitudes(bench) -> None:
    run, true, _ = bench(offers="axis")
    plain, loose = ml(magnitudes_of(run)), ml(magnitudes_of(run, u_axis_body_deg=1.0))
    more = loose.covariance - plain.covariance
    turned = np.radians(1.0) * true.K[0, 0]  # of K_yx by a turn about z
    assert np.sqrt(more[3, 3]) == pytest.approx(turned, rel=0.1)
    assert loose.frame_known


def test_one_axis_leaves_the_turn_about_it_open(bench) -> None:
    found = ml(magnitudes_of(bench(offers="axis", axes="z")[0]))
    assert not found.ok
    assert "another body axis" in found.why_not


def test_without_axes_magnitudes_stay_magnitudes(bench) -> None:
    run, _, _ = bench(offers="axis")
    free = magnitudes_of(run, kind="free", axis_body=None)
    assert not observe_planes(free).loci
    assert not ml(free).frame_known
    assert not observe_planes(run).loci  # a vector reference says the height


@pytest.mark.parametrize(("samples", "arc_deg", "noise"), [(33, 360, 5500.0), (33, 90, 2000.0), (300, 360, 3000.0)])
def test_the_sense_of_a_turn_scatters_as_it_says(samples: int, arc_deg: float, noise: float) -> None:
    random = np.random.default_rng(0)
    angle = np.radians(arc_deg) * np.arange(samples) / samples
    b = rotate(AXIS, -angle, np.array([35_000.0, 0.0, 9_000.0]))
    uneven = noise * np.array([[1.0, 0.2, 0.0], [0.1, 0.8, 0.1], [0.0, 0.3, 1.2]])
    draws = [
        sense(b + random.standard_normal(b.shape) @ uneven.T, AXIS, np.ones(samples), uneven @ uneven.T)
        for _ in range(400)
    ]
    values, u = np.array(draws).T
    right_handed = 35_000.0**2 * np.sin(angle[1]) * (samples - 1)
    assert values.mean() == pytest.approx(right_handed, rel=4 * values.std() / right_handed / 20)
    assert np.median(u) == pytest.approx(values.std(), rel=4 / np.sqrt(2 * 400))


def test_a_row_without_an_angle_counts_neither_way(bench) -> None:
    run, _, _ = bench(offers="vector", rows=10)
    holed = np.array(run.angle_deg)
    holed[3] = np.nan
    assert forward(replace(run, angle_deg=holed), run.rows(0)).tolist() == [1, 1, 0, 0, 1, 1, 1, 1, 1, 0]
    assert (forward(replace(run, angle_deg=None), run.rows(0)) == 1).all()
