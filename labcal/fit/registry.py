"""The methods by name, and what is added to every estimate: time, residuals, held-out residuals."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from typing import Any

import numpy as np

from labcal import plugin_loading
from labcal.errors import InputError
from labcal.fit.metrics import axis_errors_deg, folds, reading_bias_nT, scalar_residual
from labcal.fit.result import Fit
from labcal.fit.wild import without_wild
from labcal.record import Run

Estimator = Callable[..., Fit]
GROUP = "labcal.estimators"  # entry points of other packages

METHODS: Mapping[str, str] = {
    "ml": "labcal.fit.vector.ml:ml",
    "centered": "labcal.fit.scalar.centered:centered",
    "centered-sequential": "labcal.fit.filters.centered_sequential:centered_sequential",
    "twostep": "labcal.fit.scalar.twostep:twostep",
    "ekf": "labcal.fit.filters.ekf:ekf",
    "ukf": "labcal.fit.filters.ukf:ukf",
    "ukf-augmented": "labcal.fit.filters.ukf:ukf_augmented",
    "foster-elkaim": "labcal.fit.scalar.foster_elkaim:foster_elkaim",
    "telemetry": "labcal.fit.scalar.telemetry:telemetry",
    "pso-scalar": "labcal.fit.swarm.pso_scalar:pso_scalar",
    "pso-axis": "labcal.fit.swarm.pso_axis:pso_axis",
}


def fit(run: Run, method: str = "ml", *, holdout: bool = True, **options: Any) -> Fit:
    """Estimate a calibration of `run` by `method`; `options` go to the estimator.

    An estimator is a pure function `(run, **options) -> Fit`; it answers `ok=False` where the run does not determine
    its parameters. Residuals, held-out residuals (skipped with `holdout=False`), axis errors and the time are added
    here. Readings that no field made (`wild_rows`) are missing to all of it. Raises InputError for a method that does
    not exist.
    """
    estimator, run = load_method(method), without_wild(run)
    start = time.perf_counter()
    found = _estimate(estimator, method, run, options)
    found = replace(found, method=method, seconds=time.perf_counter() - start)
    return _with_metrics(found, estimator, run, options, holdout=holdout)


def fit_all(run: Run, **options: Any) -> list[Fit]:
    """Every method's answer, ours in the order of `METHODS`; `options` by method name, each a mapping."""
    return [_answer(run, method, options.get(method, {})) for method in methods()]


def _answer(run: Run, method: str, options: Mapping[str, Any]) -> Fit:
    """A method's answer; where another package's fails, the sentence about it: the others stand."""
    try:
        return fit(run, method, **options)
    except InputError as error:
        if method in METHODS:
            raise
        return Fit(method=method, ok=False, why_not=str(error))


def methods() -> tuple[str, ...]:
    """The names of all installed methods: ours, then other packages' by name."""
    return (*METHODS, *_others())


def load_method(name: str) -> Estimator:
    """The estimator of this name. Raises InputError where there is none, or one of another package does not load."""
    if name in METHODS:
        module, _, function = METHODS[name].partition(":")
        return getattr(import_module(module), function)  # type: ignore[no-any-return]
    if name not in _others():
        raise InputError(f"there is no method {name!r}; the methods are {', '.join(methods())}")
    return _guarded(_others()[name])


@cache
def _others() -> dict[str, EntryPoint]:
    """What other packages bring, by name; one of a name of ours is left out. To look takes 40 ms."""
    found = sorted(entry_points(group=GROUP), key=lambda entry: entry.name)
    return {entry.name: entry for entry in found if entry.name not in METHODS}


def _guarded(entry: EntryPoint) -> Estimator:
    """Another package's estimator; its faults are said with its name, and only a `Fit` passes."""
    estimator, named = plugin_loading.load(entry), plugin_loading.named(entry)

    def answer(run: Run, **options: Any) -> Fit:
        with plugin_loading.blamed(named, f"on run {run.run_id}"):
            try:
                found = estimator(run, **options)
            except (np.linalg.LinAlgError, ArithmeticError) as error:
                return Fit(method=entry.name, ok=False, why_not=f"the numbers broke down: {error}")
            if not isinstance(found, Fit):
                raise TypeError(f"it gives a {type(found).__name__}, not a labcal.fit.Fit")
        return found

    return answer


def _estimate(estimator: Estimator, method: str, run: Run, options: Mapping[str, Any]) -> Fit:
    """The estimator's answer; numbers that break down (a singular matrix, an overflow) are an answer too."""
    try:
        with np.errstate(all="ignore"):
            return estimator(run, **options)
    except (np.linalg.LinAlgError, ArithmeticError) as error:
        return Fit(method=method, ok=False, why_not=f"the numbers broke down: {error}")


def _with_metrics(found: Fit, estimator: Estimator, run: Run, options: Mapping[str, Any], *, holdout: bool) -> Fit:
    if not found.ok or found.affine is None:
        return found
    residual = scalar_residual(run, found)
    own_bias = found.bias_nT is not None
    return replace(
        found,
        bias_nT=found.bias_nT if own_bias else reading_bias_nT(run, found.affine),
        rms_scalar_nT=_rms(residual),
        holdout_rms_scalar_nT=_holdout(found, estimator, run, options) if holdout else None,
        axis_error_deg=axis_errors_deg(run, found.affine),
    )


def _holdout(found: Fit, estimator: Estimator, run: Run, options: Mapping[str, Any]) -> float | None:
    """Rms of the magnitude residual on blocks of time that the fit did not see; None where a fold has no fit."""
    kept = []
    for train, test in folds(run):
        refit = _estimate(estimator, found.method, run.select(train), options)
        if not refit.ok or refit.affine is None:
            return None
        kept.append(scalar_residual(run.select(test), refit))
    return _rms(np.concatenate(kept)) if kept else None


def _rms(residual: Any) -> float | None:
    seen = residual[np.isfinite(residual)]
    return float(np.sqrt(np.mean(seen**2))) if len(seen) else None
