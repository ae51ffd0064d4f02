"""The delay of the DUT behind the angle, about each axis that a run turns about and closes: which are not told."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from labcal.record.stream import Measurement

VECTOR = "zero: ref_x"  # what a preflight measures first where its reference is a vector


def delays_open(steps: Iterable[str], found: Mapping[str, Measurement]) -> tuple[str, ...]:
    """The delays that turns about the axes which these steps close did not tell: of one turn none comes.

    A scalar reference has no phase, and leaves the delay to sync-check.
    """
    axes = (name.removeprefix("closure-") for name in steps if name.startswith("closure-"))
    wanted = dict.fromkeys(f"delay {axis}" for axis in axes) if VECTOR in found else ()
    return tuple(name for name in wanted if name not in found)
