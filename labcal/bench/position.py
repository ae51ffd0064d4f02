"""A standstill in two numbers: what DUT and reference saw, for everything that compares one position with another."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.steps import dut_nT
from labcal.bench.streams.samples import samples
from labcal.record.closure import Standstill
from labcal.record.stream import Block

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Position:
    """Means at a standstill: `dut` (3,) [nominal nT, B], `reference` (3,) [nT, C] or (1,) where it is scalar.

    `u` [nT] is the standard uncertainty of the difference of the two along any one direction. `t_s` is the middle, and
    `channels` are the means of what came beside them.
    """

    dut: Array
    reference: Array
    u: float
    t_s: float
    channels: Mapping[str, float]

    @property
    def excess(self) -> float:
        """|DUT| − |reference| [nT]."""
        return float(np.linalg.norm(self.dut) - np.linalg.norm(self.reference))

    def standstill(self, mode: str) -> Standstill:
        """As the record keeps it."""
        x, y, z = self.dut.tolist()
        return Standstill(self.t_s, (x, y, z), tuple(self.reference.tolist()), mode, dict(self.channels))

    def moved_from(self, before: Position, body_from_cage: Array) -> Array:
        """What the DUT (3,) changed beyond the field's own change, or in all where the reference is scalar [nT, B]."""
        if len(self.reference) != 3:
            return self.dut - before.dut
        return np.asarray((self.dut - before.dut) - body_from_cage @ (self.reference - before.reference))


def position(bench: Bench, blocks: Sequence[Block]) -> Position:
    """The position that `blocks` recorded. Raises InstrumentError (silent) where a stream is missing."""
    dut, reference = dut_nT(bench, blocks), samples(blocks, "reference")
    u = float(np.hypot(dut.u_mean.max(), reference.u_mean.max()))
    return Position(dut.mean, reference.mean, u, float(dut.t_s.mean()), _channels(blocks))


def _channels(blocks: Sequence[Block]) -> dict[str, float]:
    """The mean of every channel that came, with finite values alone: a slow one may have sent nothing meanwhile."""
    names = dict.fromkeys(
        name for block in blocks if block.stream == "channel" and len(block) for name in block.columns
    )
    means = {name: float(samples(blocks, "channel", name).mean[0]) for name in names}
    return {name: value for name, value in means.items() if np.isfinite(value)}
