"""Which body axis is up: the one about which the DUT's own readings turned.

In a turn through a steady field a reading changes across the axis of the turn and not along it, whatever zero and
sensitivities the DUT has: the direction in which its readings scatter least is that axis. An arc lies in the plane of
its circle, so that 60° of a turn tell it as well. Seen from above such an arc is 0.13 times as high as it is wide
(standard deviations: θ²/8 · 0.30 beside θ · 0.29): readings that are thinner than a twentieth see their plane from its
edge, and no spike or step that came along the axis meanwhile makes them so.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import Blocks, dut_nT
from labcal.bench.streams.samples import samples
from labcal.bench.turn_diagnostics import white_noise
from labcal.errors import LimitNotMet

Array = NDArray[np.float64]
FEWEST = 20  # samples of a turn that says anything
LEAST_TURN_DEG = 180.0
FLAT = 0.3  # of the scatter across: a turn whose readings leave their plane by more tells no axis
EARLIEST_DEG, FARTHEST_EARLY_DEG = 60.0, 60.0  # sensitivities that bend an axis so far differ sevenfold
THIN = 0.05  # of the scatter across the arc
DEAD = 0.1  # of the noise: what scatters less is a component that repeats itself
CALM = 0.3  # of that scatter may be the field's own: what comes and goes along the axis leans the plane by 17° at most
FARTHEST_DEG = 45.0  # nominal sensitivities and a mounting by hand are off by a few degrees


class WrongAxis(LimitNotMet):
    """The DUT turned about another body axis than it was to be mounted with."""


def refuse_another_axis(bench: Bench, name: str, axis_body: Sequence[float], blocks: Blocks) -> None:
    """Raise WrongAxis where `blocks`, a turn, show that another body axis than `axis_body` (3,) is up."""
    angle, dut = samples(blocks, "angle", "angle_deg"), dut_nT(bench, blocks)
    if np.ptp(np.unwrap(angle.values[:, 0], period=360.0)) < LEAST_TURN_DEG:
        return
    found = turned_about(dut.between(angle.t_s[0], angle.t_s[-1]).values)
    if found is None or abs(found @ np.asarray(axis_body)) > np.cos(np.radians(FARTHEST_DEG)):
        return
    raise _wrong(name, found, np.asarray(axis_body))


def refuse_another_axis_early(bench: Bench, name: str, axis_body: Sequence[float], blocks: Blocks) -> None:
    """The same of a turn that goes on, once that is beyond doubt; what is not is left to its end."""
    angle, reference = samples(blocks, "angle", "angle_deg"), samples(blocks, "reference").values
    turned_deg = float(np.ptp(np.unwrap(angle.values[:, 0], period=360.0))) if len(angle) else 0.0
    if turned_deg < EARLIEST_DEG or len(reference) < FEWEST:
        return
    seen = dut_nT(bench, blocks).between(angle.t_s[0], angle.t_s[-1]).values
    noise_nT = max(white_noise(seen)[0], bench.config.dut.noise_nT or 0.0)
    found = turned_about_early(seen, noise_nT, wander(reference))
    if found is not None and abs(found @ np.asarray(axis_body)) < np.cos(np.radians(FARTHEST_EARLY_DEG)):
        raise _wrong(name, found, np.asarray(axis_body))


def turned_about_early(values: Array, noise_nT: float, field_wander_nT: float) -> Array | None:
    """The unit vector (3,) across the plane in which readings (n, 3) [nT] of an arc lie; None where that is not clear.

    `field_wander_nT`: by how much the field itself wandered meanwhile (standard deviation).
    """
    if len(values) < FEWEST or values.shape[1] != 3:
        return None
    variances, directions = np.linalg.eigh(np.cov(values.T))
    thick, high = np.sqrt(np.maximum(variances[:2], 0.0))
    clear = DEAD * noise_nT < thick < THIN * high and field_wander_nT < CALM * high
    return np.asarray(directions[:, 0]) if clear else None


def wander(field_nT: Array) -> float:
    """Standard deviation [nT] of a steady field (n, 1 or 3) beyond its white noise, where it is largest."""
    largest = float(np.linalg.eigvalsh(np.atleast_2d(np.cov(field_nT.T)))[-1])
    return float(np.sqrt(max(0.0, largest - white_noise(field_nT)[0] ** 2)))


def _wrong(name: str, found: Array, wanted: Array) -> WrongAxis:
    up, not_up = ("XYZ"[int(np.argmax(np.abs(axis)))] for axis in (found, wanted))
    return WrongAxis(f"{name}: body {up} is up, not {not_up}. Mount it again: this turn says nothing of {not_up}.")


def turned_about(values: Array) -> Array | None:
    """The unit vector (3,) along which readings (n, 3) of a turn scatter least; None where that is not clear."""
    if len(values) < FEWEST or values.shape[1] != 3:
        return None
    variances, directions = np.linalg.eigh(np.cov(values.T))
    return np.asarray(directions[:, 0]) if variances[0] < FLAT**2 * variances[1] else None
