"""A closure: the device in one field twice during a run, with what stood beside it, so that a fit can say what is left.

What an effect explains of a change is no drift of the zero: how far a zero may have moved is known after the effects.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from labcal.record.vector import Matrix, Vector


@dataclass(frozen=True, slots=True)
class Standstill:
    """Means over some seconds at rest."""

    t_s: float
    dut_nT: Vector  # readings times the nominal nT per unit, in B
    reference_nT: tuple[float, ...]  # vector in C, or (magnitude,)
    mode: str = ""
    channels: Mapping[str, float] | None = None  # those that were there


@dataclass(frozen=True, slots=True)
class Closure:
    """Two standstills that would be alike, had nothing changed."""

    name: str
    u_offset_nT: float  # what it adds to the zero's standard uncertainty where no effect is taken off
    before: Standstill
    after: Standstill
    body_from_cage: Matrix | None = None  # of both; None where it was mounted anew: then magnitudes are compared
