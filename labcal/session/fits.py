"""Estimates of a run that nobody keeps: one method, or all beside each other, and how a live filter's grew."""

from __future__ import annotations

from typing import TYPE_CHECKING

from labcal.fit import Fit, fit, fit_all
from labcal.record import Run
from labcal.session.sources import load_run

if TYPE_CHECKING:
    from labcal.fit.filters.convergence import History


def fit_run(run: str, method: str = "ml", channels: tuple[str, ...] | None = None) -> tuple[Run, list[Fit]]:
    """Estimate a calibration by one method, or by "all"; `channels` limits what `telemetry` may use."""
    measured = load_run(run, channels)
    return measured, fit_all(measured) if method == "all" else [fit(measured, method)]


def filter_history(run: str, method: str) -> History:
    """How the estimate of a live filter grew with the readings of `run`."""
    from labcal.fit.filters import convergence

    return convergence.filter_history(load_run(run), method)
