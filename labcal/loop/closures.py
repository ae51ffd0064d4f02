"""What the effects that were found leave of a run's closures: so far may the zero have moved, and no farther."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.data.credible import of_the_rig
from labcal.loop.data.declared_moves import as_stated
from labcal.loop.selection.joint_fit import JointFit, sum_of_effects
from labcal.model.effects import Scene
from labcal.record import Run
from labcal.record.closure import Closure, Standstill

Array = NDArray[np.float64]
SHARE = float(1 / np.sqrt(12))  # standard uncertainty of a zero that lies anywhere within what a closure shows
SETTLED_S = 1e5  # before a standstill, after which what follows slowly has settled


def after_effects(found: JointFit) -> Run:
    """The run of `found`, with what the sensor's effects leave of its closures in the uncertainty of its zero."""
    run = found.problem.run
    stated = run.reference.u_offset_nT
    if stated is None or not run.closures:
        return run
    left = max(SHARE * left_nT(closure, found) for closure in run.closures)
    u = float(np.hypot(as_stated(run).reference.u_offset_nT or 0.0, left))
    return replace(run, reference=replace(run.reference, u_offset_nT=u))


def left_nT(closure: Closure, found: JointFit) -> float:
    """How far the field of the second standstill lies from the first's beyond the reference's own change [nT].

    As it was recorded, where an effect's channel is missing there.
    """
    before, after = closure.before, closure.after
    fields = _fields_nT(before, after, found)
    if fields is None:
        return closure.u_offset_nT / SHARE
    ends = np.array([before.reference_nT, after.reference_nT])
    if closure.body_from_cage is None or ends.shape[1] != 3:
        lengths = np.linalg.norm(fields, axis=1) - np.linalg.norm(ends, axis=1)
        return float(abs(lengths[1] - lengths[0]))
    change = fields[1] - fields[0] - np.array(closure.body_from_cage) @ (ends[1] - ends[0])
    return float(np.linalg.norm(change))


def _fields_nT(before: Standstill, after: Standstill, found: JointFit) -> Array | None:
    """The calibrated fields (2, 3), effects of the sensor taken off; None where a channel of theirs is missing."""
    p, ends = found.problem, (before, after)
    ours = [(t, b) for t, b in zip(found.terms, found.beta, strict=True) if not of_the_rig(t)]
    names = {name for term, _ in ours for name in term.channels}
    if any(name not in (end.channels or {}) for name in names for end in ends):
        return None
    reading = np.array([end.dut_nT for end in ends]) / p.run.dut.nominal_nT_per_unit
    a = p.affine.apply(reading)
    scene = Scene(
        t_s=np.ravel([(end.t_s - SETTLED_S, end.t_s) for end in ends]),
        segment=np.array([0, 0, 1, 1]),
        field_nT=np.repeat(a, 2, axis=0),
        channels={name: np.repeat([(end.channels or {})[name] for end in ends], 2) for name in names},
        mode=np.repeat([end.mode for end in ends], 2),
        axes=p.scene.axes,
    )
    effects = sum_of_effects([t for t, _ in ours], [b for _, b in ours], scene)
    return np.asarray(a - np.broadcast_to(effects, (len(scene.t_s), 3))[1::2])
