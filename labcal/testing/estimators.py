"""An estimator held to its contract: pure, equivariant, right without noise, refusing, of the covariance it states."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import sqrtm
from scipy.spatial.transform import Rotation

from labcal.fit import Fit
from labcal.fit.registry import load_method
from labcal.model import AffineMap
from labcal.record import Run
from labcal.testing.made_up_runs import Offers, made_up_run
from labcal.testing.require import answered, require

Array = NDArray[np.float64]
Estimator = Callable[..., Fit]
FREE, SYMMETRIC = 12, 9  # parameters where the rotation is resolved, and where it is not
ROWS = 60  # a segment
NOISE_nT = 25.0
TURN = Rotation.from_rotvec([0.5, -0.8, 0.3]).as_matrix()
UNIT_nT = 13.0
SAME_u = 0.05  # of its uncertainty: how far the answer to the same question may move
SAME = 1e-3  # of the map's size, where no uncertainty is stated
EXACT = 1e-4  # of the map's size, without noise
RATIO = 0.15  # rms of error over uncertainty about 1


def check_estimator(
    estimator: str | Estimator,
    offers: Sequence[Offers],
    *,
    seeds: int = 60,
    exact: float = EXACT,
    **options: Any,
) -> None:
    """Hold an estimator (its name, or the function `(run, **options) -> Fit`) to its contract on made-up runs.

    `offers`: the kinds of run that it calibrates. On each it must be a pure function; follow readings that are turned
    or scaled; find the truth within `exact` (of the map's size) without noise; and, where it states a covariance, err
    as much as that says, over `seeds` runs. It must refuse a run that determines nothing. Raises AssertionError.
    """
    name, function = _named(estimator)
    tried = EstimatorTrial(name, partial(function, **options))
    check_refusals(tried)
    for kind in offers:
        check_pure(tried, kind)
        check_without_noise(tried, kind, exact)
        check_equivariance(tried, kind)
        check_covariance(tried, kind, seeds)


class EstimatorTrial:
    """An estimator and how it is spoken of."""

    def __init__(self, name: str, function: Callable[[Run], Fit]) -> None:
        self.name, self.function = name, function

    def __call__(self, run: Run) -> Fit:
        """Its answer; numbers that break down are none."""
        try:
            with np.errstate(all="ignore"):
                found = self.function(run)
        except (np.linalg.LinAlgError, ArithmeticError) as error:
            return Fit(method=self.name, ok=False, why_not=f"the numbers broke down: {error}")
        require(isinstance(found, Fit), f"{self.name} returned {type(found).__name__}: return a labcal.fit.Fit.")
        return found

    def map_of(self, run: Run, what: str) -> tuple[AffineMap, Fit]:
        """The map that it must find here."""
        found = self(run)
        text = f"{self.name} gives no answer on {what} ({found.why_not}): leave that kind out of `offers`, or mend it."
        require(found.ok and found.affine is not None, text)
        assert found.affine is not None
        return found.affine, found


def _named(estimator: str | Estimator) -> tuple[str, Estimator]:
    if not isinstance(estimator, str):
        return getattr(estimator, "__name__", "the estimator"), estimator
    with answered('Declare it in [project.entry-points."labcal.estimators"] and install again.'):
        return estimator, load_method(estimator)


def check_refusals(tried: EstimatorTrial) -> None:
    """A run without a reference, and one turned about one axis in one field, get `ok=False` and a reason."""
    run = made_up_run(offers="scalar", rows=ROWS).run
    nothing = replace(run, reference=replace(run.reference, kind="none"), reference_magnitude=None)
    one_axis = made_up_run(offers="scalar", axes="z", fields_nT=((20e3, 0.0, 15e3),), rows=ROWS).run
    few = run.select(np.arange(3))
    for what, poor in (("without a reference", nothing), ("about one axis", one_axis), ("of three rows", few)):
        found = tried(poor)
        text = f"{tried.name} calibrates a run {what}: answer Fit(method, ok=False, why_not='…'), affine None."
        require(not found.ok and found.affine is None, text)
        require(found.why_not, f"{tried.name} refuses a run {what} without a word: say in why_not what is missing.")


def check_pure(tried: EstimatorTrial, kind: Offers) -> None:
    """The same run gives the same answer, and is left as it was."""
    run = made_up_run(offers=kind, rows=ROWS, noise_nT=NOISE_nT).run
    before = copy.deepcopy(run.reading)
    first, _ = tried.map_of(run, f"a {kind} run")
    require(np.array_equal(run.reading, before), f"{tried.name} changes the readings that it is given: copy them.")
    again, _ = tried.map_of(run, f"a {kind} run")
    text = f"{tried.name} answers the same run twice differently: take a fixed seed."
    require(np.array_equal(first.parameters, again.parameters), text)


def check_without_noise(tried: EstimatorTrial, kind: Offers, exact: float) -> None:
    """Readings without noise give the map that they were made with."""
    made = made_up_run(offers=kind, rows=ROWS, noise_nT=0.0)
    run = replace(made.run, dut=replace(made.run.dut, noise_nT=1.0))
    found, fit = tried.map_of(run, f"a {kind} run without noise")
    error = _distance(found, truth(made.true, fit.frame_known), _sizes(made.true))
    text = (
        f"{tried.name} is off by {error:.1e} of the map without noise on a {kind} run (frame_known={fit.frame_known})"
    )
    require(error <= exact, f"{text}: K m − k is the field, K symmetric where the rotation is not resolved.")


def truth(true: AffineMap, frame_known: bool) -> AffineMap:
    """The map to be found: of those with the same magnitudes the one with a symmetric K, where these are all it saw."""
    if frame_known:
        return true
    K = np.real(sqrtm(true.K.T @ true.K))
    return AffineMap(K, K @ np.linalg.solve(true.K, true.k_nT))


def check_equivariance(tried: EstimatorTrial, kind: Offers) -> None:
    """Readings that are turned turn the answer back; readings in another unit scale K and leave k."""
    run = made_up_run(offers=kind, rows=ROWS, noise_nT=NOISE_nT).run
    found, fit = tried.map_of(run, f"a {kind} run")
    turned = replace(run, reading=run.reading @ TURN.T)
    dut = replace(run.dut, nominal_nT_per_unit=UNIT_nT, unit="count")
    scaled = replace(run, reading=run.reading / UNIT_nT, dut=dut)
    turn_back = AffineMap(found.K @ TURN.T, found.k_nT)
    if not fit.frame_known:
        turn_back = AffineMap(TURN @ found.K @ TURN.T, TURN @ found.k_nT)
    wanted = {
        "turned readings": (turned, turn_back, "K Rᵀ and k, or R K Rᵀ and R k where the rotation is not resolved"),
        f"readings in {UNIT_nT:g} nT": (scaled, AffineMap(found.K * UNIT_nT, found.k_nT), "K times the unit, and k"),
    }
    for what, (other, expected, words) in wanted.items():
        moved, _ = tried.map_of(other, what)
        unit = UNIT_nT if other is scaled else 1.0
        allowed, of = _allowed(fit, found, unit)
        error = _distance(moved, expected, allowed)
        text = f"{tried.name} gives another answer to {what} of a {kind} run, by {error:.1g} of {of}"
        require(error <= 1, f"{text}: it must be {words}.")


def _allowed(fit: Fit, found: AffineMap, unit: float) -> tuple[Array, str]:
    per = np.r_[np.full(9, unit), np.ones(3)]
    if fit.covariance is None:
        return SAME * _sizes(found) * per, "what rounding allows"
    u = np.sqrt(np.diag(fit.covariance))
    return SAME_u * np.r_[np.full(9, u[:9].max()), np.full(3, u[9:].max())] * per, f"{SAME_u:g} of its uncertainty"


def check_covariance(tried: EstimatorTrial, kind: Offers, seeds: int) -> None:
    """Over many runs the squared error is what the covariance says, from both sides."""
    squares = list[float]()
    for seed in range(seeds):
        made = made_up_run(offers=kind, rows=ROWS, noise_nT=NOISE_nT, seed=seed)
        found, fit = tried.map_of(made.run, f"a {kind} run")
        if fit.covariance is None:
            return  # it states none, and may
        free = FREE if fit.frame_known else SYMMETRIC
        error = found.parameters - truth(made.true, fit.frame_known).parameters
        squares.append(_squared(error, fit.covariance, free, tried.name) / free)
    ratio = float(np.sqrt(np.mean(squares)))
    band = RATIO + 3.3 / np.sqrt(2 * free * seeds)  # of rms chi-squared, 99.9 %
    size = "too small" if ratio > 1 else "too large"
    text = f"Over {seeds} {kind} runs the errors of {tried.name} are {ratio:.2f} times its stated uncertainty"
    require(1 - band <= ratio <= 1 + band, f"{text}: its covariance is {size}. Mend it, or state covariance=None.")


def _squared(error: Array, covariance: Array, free: int, name: str) -> float:
    """The squared error over its expectation, in the `free` directions in which the covariance is not zero."""
    require(covariance.shape == (FREE, FREE), f"{name}: covariance is (12, 12): K row by row, then k.")
    u = np.sqrt(np.diag(covariance))
    require(np.isfinite(u).all() and (u > 0).all(), f"{name}: covariance has no positive diagonal.")
    values, vectors = np.linalg.eigh(covariance / np.outer(u, u))
    along = vectors[:, -free:].T @ (error / u)
    text = f"{name}: its covariance has not the rank {free} that frame_known says (9 where K is symmetric)."
    require(values[-free] > 1e-9 * values[-1], text)
    return float(np.sum(along**2 / values[-free:]))


def _sizes(found: AffineMap) -> Array:
    return np.asarray(np.r_[np.full(9, np.linalg.norm(found.K, 2)), np.full(3, np.linalg.norm(found.k_nT))])


def _distance(one: AffineMap, other: AffineMap, sizes: Array) -> float:
    return float(np.max(np.abs(one.parameters - other.parameters) / sizes))
