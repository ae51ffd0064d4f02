"""Which body axis is up: the one about which the DUT's own readings turned.

In a turn through a steady field a reading changes across the axis of the turn and not along it, whatever zero and
sensitivities the DUT has: the direction in which its readings scatter least is that axis.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import Blocks, dut_nT
from labcal.bench.streams.samples import samples
from labcal.errors import LimitNotMet

FEWEST = 20  # samples of a turn that says anything
LEAST_TURN_DEG = 180.0
FLAT = 0.3  # of the scatter across: a turn whose readings leave their plane by more tells no axis
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
    up, wanted = ("XYZ"[int(np.argmax(np.abs(axis)))] for axis in (found, np.asarray(axis_body)))
    raise WrongAxis(f"{name}: body {up} is up, not {wanted}. Mount it again: this turn says nothing of {wanted}.")


def turned_about(values: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The unit vector (3,) along which readings (n, 3) of a turn scatter least; None where that is not clear."""
    if len(values) < FEWEST or values.shape[1] != 3:
        return None
    variances, directions = np.linalg.eigh(np.cov(values.T))
    return np.asarray(directions[:, 0]) if variances[0] < FLAT**2 * variances[1] else None
