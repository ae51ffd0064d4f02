"""Confounded explanations: pairs that no fit of this run can separate, and the measurement that does."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.findings.residual_tests import reference_field
from labcal.model.effects import Confounded, Family
from labcal.model.gaps import bridged

Array = NDArray[np.float64]
LOCKED_SHARE = 0.98  # of a current's variance that the field in the body predicts: it follows the attitude
MOVING = 0.1  # of the fastest rate: a slower platform stands
MOSTLY = 0.9  # of the moving rows
ONE_RATE = 0.1  # of the median rate: farther from it the platform turns at several


def confounded(problem: LinearProblem, named: Iterable[Family]) -> tuple[Confounded, ...]:
    """Of the effects that are `named`, accepted or equivalent, and of the run as it was recorded."""
    return (*dict.fromkeys(pair for family in named for pair in family.confounded), *_by_the_run(problem))


def _by_the_run(problem: LinearProblem) -> Iterator[Confounded]:
    run, rig = problem.run, problem.scene.rig
    for name in _attitude_locked(problem):
        yield Confounded(
            f"what {name} does, which follows the attitude", "soft iron", "switch the load at one attitude"
        )
    if rig is not None and np.isfinite(rig.angle_rad).any():
        yield Confounded("magnetism of what turns with the device", "the device's offset",
                    "remount the device turned on its fixture")  # fmt: skip
        if len(problem.observations.phase_names) and _one_rate(rig.angle_rad, problem.scene.t_s, problem.scene.segment):
            yield Confounded("a lag at a constant rate", "the mounting's phase", "turn at another rate, and backwards")
    if run.reference.u_scale_ppm is None:
        yield Confounded("the reference's scale", "the device's gain", "compare the reference with another one")


def _attitude_locked(problem: LinearProblem) -> Iterator[str]:
    """The device's currents that the field in the body predicts."""
    b = reference_field(problem)
    A = np.column_stack([np.ones(len(b)), b / max(float(np.abs(b).max()), 1e-9)])
    for channel in problem.run.channels:
        known = np.isfinite(channel.values)
        if channel.role != "dut" or channel.quantity != "current" or known.sum() < 2 * A.shape[1]:
            continue
        values = bridged(problem.run.t_s, channel.values)[0]
        spread = float(np.var(values))
        left = values - A @ np.linalg.lstsq(A, values, rcond=None)[0]
        if spread > 0 and float(np.var(left)) < (1 - LOCKED_SHARE) * spread:
            yield channel.name


def _one_rate(angle_rad: Array, t_s: Array, segment: NDArray[np.intp]) -> bool:
    """Whether the platform turns at one rate, and one way, in all segments."""
    within = (np.diff(segment) == 0) & np.isfinite(np.diff(angle_rad))
    rate = (np.diff(angle_rad) / np.diff(t_s))[within]
    moving = rate[np.abs(rate) > MOVING * np.abs(rate).max(initial=0.0)]
    usual = float(np.median(moving)) if len(moving) else 0.0
    return bool(len(moving)) and float(np.mean(np.abs(moving - usual) < ONE_RATE * abs(usual))) > MOSTLY
