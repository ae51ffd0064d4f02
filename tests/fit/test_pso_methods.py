"""`pso-axis` and `pso-scalar` on runs: against `ml`, under symmetries, their uncertainty, and what they refuse."""

from dataclasses import replace

import numpy as np
import pytest
from riwanto import MODELS, TRUTH, simulate

from labcal.fit import fit
from labcal.fit.swarm.loci import loci_of
from labcal.fit.swarm.particle_swarm import SwarmSettings
from labcal.fit.swarm.polish import polish, singular_values, symmetric_basis
from labcal.fit.swarm.pso_axis import PUBLISHED, Options, pso_axis
from labcal.fit.swarm.pso_scalar import positive_definite, pso_scalar
from labcal.fit.swarm.search import u_normal
from labcal.geometry import rotate, rotation, unit
from labcal.record import Dut, Reference, Run, Segment
from labcal.store.bundle import read_bundle

K = np.array([[1.04, 0.02, -0.01], [-0.015, 0.97, 0.03], [0.02, -0.01, 1.01]])
k_NT = np.array([310.0, -250.0, 420.0])
FULL = 2 * np.pi


def platform_run(
    seed,
    *,
    axes=np.eye(3),
    fields_nT=(30_000.0, 50_000.0),
    elevation_deg=20.0,
    arc=FULL,
    noise_nT=25.0,
    samples=40,
    angle=True,
):
    """Each axis turned once at each magnitude, the field `elevation_deg` above the plane of the turn."""
    rng, rows = np.random.default_rng(seed), []
    legs = [(axis, size) for size in fields_nT for axis in np.atleast_2d(axes)]
    up = np.radians(elevation_deg)
    turn = arc * np.arange(samples) / samples
    field = np.array([np.cos(up), 0.0, np.sin(up)])
    for axis, size in legs:
        across = unit(np.cross(axis, [0.3, 0.5, 0.8]))
        at_zero = size * (np.cos(up) * across + np.sin(up) * np.asarray(axis))
        rows.append(rotate(axis, -turn, at_zero))
    b = np.vstack(rows)
    reading = (b + k_NT) @ np.linalg.inv(K).T + noise_nT * rng.normal(size=b.shape)
    return Run(
        run_id="turns",
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("SN1", noise_nT=noise_nT),
        reference=Reference("vector"),
        segments=tuple(
            Segment(f"leg{i}", "rotation", axis_body=tuple(map(float, axis)), axis_cage=(0.0, 0.0, 1.0))
            for i, (axis, _) in enumerate(legs)
        ),
        t_s=np.arange(len(b), dtype=float),
        segment_index=np.repeat(np.arange(len(legs)), samples),
        reading=reading,
        reference_vector=np.repeat([size for _, size in legs], samples)[:, None] * field,
        angle_deg=np.tile(np.degrees(turn), len(legs)) if angle else None,
    )


def scalar_reference(run):
    return replace(
        run, reference=Reference("scalar"), reference_vector=None, reference_magnitude=run.magnitude_nT, angle_deg=None
    )


def without_axes(run):
    return replace(run, segments=tuple(Segment(s.id, "free") for s in run.segments))


def in_sigma(found, K_true=K, k_true=k_NT):
    theta = np.concatenate([K_true.ravel(), k_true])
    return (found.affine.parameters - theta) / np.sqrt(np.diag(found.covariance))


@pytest.mark.parametrize("angle", [True, False])
def test_the_answer_is_the_truth_within_its_uncertainty(angle):
    found = pso_axis(platform_run(0, angle=angle))
    assert found.ok
    assert found.frame_known
    assert np.max(np.abs(in_sigma(found))) < 4
    assert np.all(np.sqrt(np.diag(found.covariance)[9:]) < 5.0)  # 25 nT, 240 rows
    assert found.noise_nT == pytest.approx(25.0, rel=0.1)


def test_the_seed_repeats_the_answer_and_another_seed_ends_at_the_same_summit():
    run = platform_run(1)
    first, again, other = (pso_axis(run, seed=seed).affine.parameters for seed in (5, 5, 6))
    assert np.array_equal(first, again)
    assert first == pytest.approx(other, rel=1e-8, abs=1e-6)


def test_polished_swarm_equals_maximum_likelihood():
    """Two derivations: white noise in the field, averaged over the turn; and errors in the readings, as Deming's."""
    run = platform_run(2, angle=False)
    swarm, ml = pso_axis(run), fit(run, "ml", holdout=False, robust=False)
    u = np.sqrt(np.diag(ml.covariance))
    assert np.max(np.abs(swarm.affine.parameters - ml.affine.parameters) / u) < 0.35
    assert np.sqrt(np.diag(swarm.covariance)) == pytest.approx(u, rel=0.25)


def test_scalar_swarm_equals_maximum_likelihood_on_magnitudes():
    run = without_axes(scalar_reference(platform_run(3)))
    swarm, ml = pso_scalar(run), fit(run, "ml", holdout=False, robust=False)
    assert swarm.ok
    assert ml.ok
    assert not swarm.frame_known
    assert np.max(np.abs(swarm.affine.parameters - ml.affine.parameters) / np.sqrt(np.diag(ml.covariance))) < 0.35
    np.testing.assert_allclose(swarm.affine.K, swarm.affine.K.T, atol=1e-12)
    assert np.linalg.matrix_rank(swarm.covariance * np.outer(*2 * [np.r_[np.full(9, 4e4), np.ones(3)]])) == 9


def test_a_scalar_reference_and_the_axes_alone_resolve_the_rotation():
    """The paper's own case: |b| and the rotation axes; the heights of the loci are estimated too."""
    found = pso_axis(scalar_reference(platform_run(4)))
    assert found.frame_known
    assert np.max(np.abs(in_sigma(found))) < 4


def test_turning_the_body_turns_the_answer():
    Q = rotation(unit([1.0, 2.0, -1.0]), 0.4)
    run = platform_run(5)
    turned_segments = tuple(replace(s, axis_body=tuple(Q @ s.axis_body)) for s in run.segments)
    found, turned = pso_axis(run), pso_axis(replace(run, segments=turned_segments))
    np.testing.assert_allclose(turned.affine.K, Q @ found.affine.K, atol=1e-9)
    assert turned.affine.k_nT == pytest.approx(Q @ found.affine.k_nT, abs=1e-4)


def test_units_scale_the_answer():
    run = platform_run(6)
    counts = replace(
        run, reading=run.reading / 7.5, dut=Dut("SN1", unit="count", nominal_nT_per_unit=7.5, noise_nT=25.0)
    )
    nT, by_count = pso_axis(run), pso_axis(counts)
    np.testing.assert_allclose(by_count.affine.K, 7.5 * nT.affine.K, rtol=1e-9, atol=1e-9)
    assert by_count.affine.k_nT == pytest.approx(nT.affine.k_nT, rel=1e-9)
    assert np.sqrt(np.diag(by_count.covariance))[:9] == pytest.approx(
        7.5 * np.sqrt(np.diag(nT.covariance))[:9], rel=1e-6
    )


def test_angles_tell_a_turn_back_from_a_turn_forth():
    run = platform_run(7)
    rows = np.concatenate([run.rows(i)[::-1] if i in (1, 3) else run.rows(i) for i in range(6)])
    back = replace(
        run, reading=run.reading[rows], reference_vector=run.reference_vector[rows], angle_deg=run.angle_deg[rows]
    )
    assert pso_axis(back).affine.parameters == pytest.approx(pso_axis(run).affine.parameters, rel=1e-7, abs=1e-5)
    blind = pso_axis(replace(back, angle_deg=None))
    assert not blind.ok
    assert "axis_body" in blind.why_not


def test_a_locus_whose_field_lies_along_its_axis_contradicts_nothing():
    """Its points are noise: they have no plane, and go round nothing."""
    run, along = platform_run(13), platform_run(14, axes=[0.0, 0.0, 1.0], fields_nT=(40_000.0,), elevation_deg=90.0)
    both = replace(
        run,
        segments=(*run.segments, replace(along.segments[0], id="along")),
        t_s=np.arange(len(run) + len(along), dtype=float),
        segment_index=np.concatenate([run.segment_index, np.full(len(along), len(run.segments))]),
        reading=np.vstack([run.reading, along.reading]),
        reference_vector=np.vstack([run.reference_vector, along.reference_vector]),
        angle_deg=np.concatenate([run.angle_deg, along.angle_deg]),
    )
    found = pso_axis(both)
    assert found.ok, found.why_not
    assert np.max(np.abs(in_sigma(found))) < 4


@pytest.mark.parametrize(("arc_deg", "noise"), [(360.0, 5500.0), (360.0, 12_000.0), (120.0, 1000.0)])
def test_a_normal_tilts_over_draws_as_it_says(arc_deg, noise):
    random, samples = np.random.default_rng(1), 100
    b = rotate(np.array([0.0, 0.0, 1.0]), np.radians(arc_deg) * np.arange(samples) / samples, [35_000.0, 0.0, 0.0])
    tilts, said = [], []
    for _ in range(300):
        variances, directions = np.linalg.eigh(np.cov((b + noise * random.normal(size=b.shape)).T))
        tilts.append(directions[:, 0] @ directions_across(b)[1])  # about the long way
        said.append(u_normal(variances[1], variances[0], samples))
    assert np.sqrt(np.mean(np.square(tilts))) == pytest.approx(np.median(said), rel=0.2)


def directions_across(b):
    """The long way (3,) and the short way (3,) of the points of a plane across z."""
    x, y = np.linalg.eigh(np.cov(b[:, :2].T))[1].T[::-1]
    return np.append(x, 0.0), np.append(y, 0.0)


def test_rows_without_a_reading_are_left_out():
    run = platform_run(8)
    holed = np.array(run.reading)
    holed[::17] = np.nan
    found = pso_axis(replace(run, reading=holed))
    assert np.max(np.abs(in_sigma(found))) < 4


def test_the_published_method_has_no_covariance_and_comes_near():
    found = pso_axis(simulate(MODELS[0], 0), options=PUBLISHED)
    assert found.covariance is None
    assert found.affine.parameters[:9] == pytest.approx(TRUTH[:9], abs=0.06)


def test_one_axis_is_refused_with_its_rank():
    found = pso_axis(platform_run(9, axes=[0.0, 0.0, 1.0]))
    assert not found.ok
    assert found.affine is None
    assert "11 of 12" in found.why_not  # two magnitudes leave the turn about that axis open
    assert "another body axis" in found.why_not


def test_arcs_that_are_too_short_for_their_noise_are_refused():
    run = platform_run(10, arc=np.radians(3.0), noise_nT=400.0, fields_nT=(40_000.0,), elevation_deg=0.0)
    found = pso_axis(run)
    assert not found.ok
    assert "determine" in found.why_not


def test_a_run_without_axes_or_without_reference_is_refused():
    run = platform_run(11)
    assert "axis_body" in pso_axis(without_axes(run)).why_not
    none = replace(run, reference=Reference("none"), reference_vector=None)
    assert not pso_axis(none).ok
    assert not pso_scalar(none).ok


def ranks(run, *, scalar):
    loci = loci_of(run, with_axes=not scalar)
    theta = np.concatenate([K.ravel(), k_NT])
    theta = positive_definite(theta) if scalar else theta
    return int(np.sum(singular_values(loci, theta, symmetric_basis() if scalar else None) > 1e-6))


@pytest.mark.parametrize(
    ("axes", "fields_nT", "elevation_deg", "rank"),
    [
        (np.eye(3)[:1], (40_000.0,), 20.0, 5),
        (np.eye(3)[:1], (30_000.0, 50_000.0), 20.0, 8),
        (np.eye(3)[:2], (40_000.0,), 20.0, 8),
        (np.eye(3)[:2], (30_000.0, 50_000.0), 0.0, 8),
        (np.eye(3)[:2], (30_000.0, 50_000.0), 30.0, 9),
        (np.eye(3), (40_000.0,), 20.0, 9),
        (np.eye(3), (40_000.0,), 90.0, 3),
    ],
)
def test_rank_of_what_magnitudes_determine(axes, fields_nT, elevation_deg, rank):
    run = platform_run(0, axes=axes, fields_nT=fields_nT, elevation_deg=elevation_deg, noise_nT=0.0)
    assert ranks(run, scalar=True) == rank
    found = pso_scalar(replace(run, dut=Dut("SN1", noise_nT=1.0)))
    assert found.ok == (rank == 9)
    if rank < 9:
        assert f"{rank} of 9" in found.why_not


@pytest.mark.parametrize(("axes", "elevation_deg", "rank"), [(1, 20.0, 8), (2, 0.0, 12), (2, 20.0, 12), (3, 0.0, 12)])
def test_rank_of_what_axes_determine_at_one_magnitude(axes, elevation_deg, rank):
    run = platform_run(0, axes=np.eye(3)[:axes], fields_nT=(40_000.0,), elevation_deg=elevation_deg, noise_nT=0.0)
    assert ranks(run, scalar=False) == rank


@pytest.mark.parametrize(
    "model", [MODELS[0], pytest.param(MODELS[2], marks=pytest.mark.slow)], ids=["model-1", "model-3"]
)
def test_intervals_hold_the_truth_in_the_papers_models(model):
    """Pooled over 12 parameters and 60 seeds; the slow tests take 500."""
    share = share_inside(lambda seed: polish(loci_of(simulate(model, seed)), TRUTH, white_in="field"), TRUTH, 60)
    assert 0.925 < share.mean() < 0.975
    assert share.min() > 0.8


RUNS = {
    "vector reference": (lambda run: run, None),
    "scalar reference": (scalar_reference, None),
    "magnitudes alone": (scalar_reference, symmetric_basis()),
}


@pytest.mark.parametrize(
    "kind", [kind if kind == "vector reference" else pytest.param(kind, marks=pytest.mark.slow) for kind in RUNS]
)
def test_intervals_hold_the_truth_on_runs(kind):
    share = share_of_runs(kind, 60)
    assert 0.92 < share.mean() < 0.98
    assert share.min() > 0.8


@pytest.mark.slow
@pytest.mark.parametrize("model", [MODELS[0], MODELS[2], MODELS[3]], ids=lambda m: f"model-{m.number}")
def test_intervals_hold_the_truth_in_the_papers_models_over_500_seeds(model):
    share = share_inside(lambda seed: polish(loci_of(simulate(model, seed)), TRUTH, white_in="field"), TRUTH, 500)
    assert 0.93 < share.mean() < 0.97
    assert share.min() > 0.916
    assert share.max() < 0.978


@pytest.mark.slow
@pytest.mark.parametrize("kind", RUNS)
def test_intervals_hold_the_truth_on_runs_over_500_seeds(kind):
    share = share_of_runs(kind, 500)
    assert 0.93 < share.mean() < 0.97
    assert share.min() > 0.916
    assert share.max() < 0.978


def share_of_runs(kind, seeds):
    change, basis = RUNS[kind]
    truth = np.concatenate([K.ravel(), k_NT])
    truth = truth if basis is None else positive_definite(truth)

    def found(seed):
        return polish(loci_of(change(platform_run(seed)), with_axes=basis is None), truth, basis=basis)

    return share_inside(found, truth, seeds)


def share_inside(found, truth, seeds):
    """The share (12,) of seeds whose 95 % interval holds the truth."""
    answers = [found(seed) for seed in range(seeds)]
    return np.mean([np.abs(a.theta - truth) < 1.96 * np.sqrt(np.diag(a.covariance)) for a in answers], axis=0)


def test_residuals_that_correlate_widen_the_covariance():
    run, theta = platform_run(12, samples=200), np.concatenate([K.ravel(), k_NT])
    slow = 200.0 * np.sin(np.arange(len(run)) / 40.0)[:, None] * np.ones(3)
    bare, wide = (polish(loci_of(r), theta) for r in (run, replace(run, reading=run.reading + slow)))
    louder = (wide.noise_nT / bare.noise_nT) ** 2
    assert np.all(np.diag(wide.covariance) > 5 * louder * np.diag(bare.covariance))


def test_what_is_declared_of_the_mounting_is_in_the_covariance():
    run = platform_run(0)
    loose = replace(run, segments=tuple(replace(s, u_axis_body_deg=1.0) for s in run.segments))
    u = np.sqrt(np.diag(pso_axis(loose).covariance))
    assert u[1] == pytest.approx(np.radians(1.0) * K[1, 1], rel=0.05)


def test_no_covariance_where_uneven_gains_and_noise_would_bias_it():
    found = pso_axis(simulate(MODELS[0], 0, white_in="reading"))
    assert found.ok
    assert found.covariance is None
    assert pso_axis(platform_run(0)).covariance is not None


def test_measured_runs_are_answered_or_refused_without_a_traceback(shared):
    folders = [*sorted((shared / "data" / "practice").glob("*/bundle")), *sorted((shared / "data").glob("*/run.json"))]
    assert len(folders) > 9
    for folder in folders:
        run = read_bundle(folder.parent if folder.name == "run.json" else folder)
        for method in ("pso-axis", "pso-scalar"):
            found = fit(run, method, holdout=False, options=Options(SwarmSettings(iterations=40)))
            assert found.ok == (found.affine is not None)
            assert found.ok or found.why_not


def test_practice_run_without_an_effect_agrees_with_maximum_likelihood(shared):
    run = read_bundle(shared / "data" / "practice" / "p01" / "bundle")
    swarm, ml = fit(run, "pso-axis", options=Options(SwarmSettings(iterations=60))), fit(run, "ml")
    u = np.sqrt(np.diag(swarm.covariance))
    assert np.max(np.abs(swarm.affine.parameters - ml.affine.parameters) / u) < 3
    assert swarm.holdout_rms_scalar_nT == pytest.approx(ml.holdout_rms_scalar_nT, rel=0.02)
