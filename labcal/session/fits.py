"""Estimates of a run that nobody keeps: one method, or all beside each other, and how a live filter's grew."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from labcal.fit import Fit, fit, fit_all
from labcal.fit.scalar.scalar_check import MISSING
from labcal.record import Run
from labcal.session.sources import load_run

if TYPE_CHECKING:
    from labcal.fit.filters.convergence import History


def fit_run(run: str, method: str = "ml", channels: tuple[str, ...] | None = None) -> tuple[Run, list[Fit]]:
    """Estimate a calibration by one method, or by "all"; `channels` limits what `telemetry` may use."""
    measured = load_run(run, channels)
    return measured, fit_all(measured) if method == "all" else [fit(measured, method)]


def left_open(run: Run, found: Fit) -> str:
    """What the run leaves open of the map that `found` gives, a sentence; "" where it determines the whole.

    By the judgement that the loop goes by: the noise alone must not leave the field at any direction too uncertain.
    """
    if found.left_open or found.affine is None or found.sources is None:
        return found.left_open or ""
    from labcal.fit.vector.identifiability import worst_uncertainty
    from labcal.loop.policy import POLICY

    theta = np.concatenate([found.affine.K.ravel(), found.affine.k_nT])
    field_nT = float(np.nanmax(run.magnitude_nT)) if run.reference.kind != "none" else 0.0
    worst_nT = worst_uncertainty(theta, found.sources.noise.covariance[:12, :12], field_nT)
    if worst_nT < POLICY.max_field_uncertainty * field_nT or not field_nT:
        return ""
    return f"the field would be uncertain by {worst_nT:.0f} nT: {MISSING}"


def filter_history(run: str, method: str) -> History:
    """How the estimate of a live filter grew with the readings of `run`."""
    from labcal.fit.filters import convergence

    return convergence.filter_history(load_run(run), method)
