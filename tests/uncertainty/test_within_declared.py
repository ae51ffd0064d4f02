"""What a run declares of its reference and mounting explains what they leave: that is no structure, and no more is."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest
from trials import KINDS, recorded

from labcal.loop import close_loop, policy
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.declared_directions import DeclaredDirections
from labcal.loop.result import ClosedLoop
from labcal.record import Run

FEW, MANY = 1, pytest.param(4, marks=pytest.mark.slow)  # runs of each kind of reference

each_kind = pytest.mark.parametrize(
    "kind", ["axis", *(pytest.param(kind, marks=pytest.mark.slow) for kind in KINDS if kind != "axis")]
)


def runs(number: int, *, effect: str = "none", kinds: tuple[str, ...] = KINDS) -> Iterator[Run]:
    """Recorded by the independent lab, wrong by draws of what they declare."""
    yield from (recorded(seed, kind, effect=effect, twin=False)[1] for kind in kinds for seed in range(number))


def stated(run: Run, times: float) -> Run:
    """The run whose declared errors are so many times as large."""
    reference = run.reference
    return replace(
        run,
        reference=replace(
            reference,
            u_scale_ppm=times * (reference.u_scale_ppm or 0.0),
            u_offset_nT=times * (reference.u_offset_nT or 0.0),
        ),
        segments=tuple(replace(s, u_axis_body_deg=times * (s.u_axis_body_deg or 0.0)) for s in run.segments),
    )


def shifted(run: Run, nT: float) -> Run:
    """The run as a reference has it whose zero along x is off."""
    assert run.reference_vector is not None
    return replace(run, reference_vector=run.reference_vector + nT * np.eye(3)[0])


def more_than_noise(closed: ClosedLoop) -> bool:
    return closed.after.holdout_rms_nT > policy.POLICY.floor_ratio * closed.noise_floor_nT


def kinds_of(closed: ClosedLoop) -> set[str]:
    return {finding.kind for finding in closed.findings}


@pytest.mark.parametrize("number", [FEW, MANY])
def test_a_reference_that_is_wrong_as_it_declares_leaves_a_clean_run(number: int) -> None:
    found = [close_loop(run) for run in runs(number)]
    left = [closed for closed in found if more_than_noise(closed)]
    assert len(left) > len(found) / 2  # there is something to explain
    assert [closed.verdict for closed in found] == ["clean"] * len(found)
    assert all("within-declared" in kinds_of(closed) for closed in left)
    assert all("beside what the run declares" in closed.summary for closed in left)
    assert not any("within-declared" in kinds_of(closed) for closed in found if not more_than_noise(closed))


@pytest.mark.slow
def test_without_what_is_declared_the_same_runs_have_structure(monkeypatch: pytest.MonkeyPatch) -> None:
    none = property(lambda self: np.zeros((*self.y.shape, 0)))
    monkeypatch.setattr(LinearProblem, "declared", none)
    assert any(close_loop(run).verdict != "clean" for run in runs(4))  # ends with the first


@pytest.mark.parametrize("number", [FEW, MANY])
def test_what_is_larger_than_declared_is_not_clean(number: int) -> None:
    """A mounted axis: what another kind of reference has wrong is taken by the map, or a field of the cage."""
    found = [close_loop(stated(run, 0.1)) for run in runs(number, kinds=("axis",))]
    left = [closed for closed in found if more_than_noise(closed)]
    assert left
    assert not any(closed.verdict == "clean" for closed in left)
    assert not any("within-declared" in kinds_of(closed) for closed in found)


def test_a_field_that_hides_in_the_declared_zero_is_not_claimed_and_a_larger_one_is_seen() -> None:
    run = recorded(2, "vector", effect="none", twin=False)[1]
    hidden, between, seen = (close_loop(shifted(run, nT)) for nT in (30.0, 150.0, 600.0))
    assert not hidden.accepted
    assert hidden.verdict == "clean"
    assert not between.accepted  # five standard deviations of the zero: no proof of a field, and more than declared
    assert between.verdict == "unexplained"
    assert "beyond-declared" in kinds_of(between)
    assert between.next_experiment is not None
    assert [e.effect for e in seen.accepted] == ["cage-field"]


@pytest.mark.parametrize("number", [FEW, MANY])
@each_kind
def test_an_effect_at_work_keeps_its_name_and_closes_the_run(number: int, kind: str) -> None:
    for run in runs(number, effect="offset-current", kinds=(kind,)):
        closed = close_loop(run)
        assert [e.effect for e in closed.accepted] == ["offset-current"]
        assert closed.verdict == "explained"


def test_directions_are_those_of_the_dense_covariance() -> None:
    rng = np.random.default_rng(0)
    D, y = rng.normal(size=(7, 3, 4)) * [10.0, 3.0, 1.0, 0.1], rng.normal(size=(7, 3))
    found, flat = DeclaredDirections.of(D), D.reshape(21, 4)
    values, vectors = np.linalg.eigh(np.eye(21) + flat @ flat.T)
    dense = (vectors / np.sqrt(values)) @ vectors.T @ y.ravel()
    np.testing.assert_allclose(found.whitened(y[:, :, None]).ravel(), dense, atol=1e-12)
    likeliest = flat.T @ np.linalg.solve(np.eye(21) + flat @ flat.T, y.ravel())
    np.testing.assert_allclose(found.likeliest(y), likeliest, atol=1e-12)
    far = found.likeliest(y + 1e4 * D[:, :, 0])
    assert np.linalg.norm(far) < 4 * np.sqrt(4)  # standard deviations: no error is as large as that


def test_the_surprise_of_errors_as_declared_is_chi_squared() -> None:
    rng = np.random.default_rng(1)
    D = rng.normal(size=(30, 3, 3)) * 5.0
    found = DeclaredDirections.of(D)
    draws = [found.surprise(D @ rng.normal(size=3) + rng.normal(size=(30, 3))) for _ in range(2000)]
    assert {count for _, count in draws} == {3}
    squares = np.array([square for square, _ in draws])
    assert squares.mean() == pytest.approx(3, abs=5 * np.sqrt(6 / 2000))
    assert squares.var() == pytest.approx(6, rel=0.2)
