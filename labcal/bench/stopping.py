"""Zero and stop: the coils are ordered to zero first, and a platform that turns waits for no supply that is dead."""

from __future__ import annotations

from labcal.bench.coils.cage import Cage
from labcal.bench.driver_kit.roles import RotationPlatform
from labcal.bench.guardian.client import GuardianClient
from labcal.bench.guardian.modbus import GuardedModbus
from labcal.bench.platform import BenchPlatform


def zero_and_stop(
    cage: Cage, platform: RotationPlatform, guardian: GuardianClient | None, platform_link: object
) -> None:
    """Every coil to zero, as `Cage.zero`; a platform that may turn is told to stop as soon as that is ordered.

    On a line of the supplies' own it is told afterwards, for that is their guardian's.
    """
    stop = platform.told_to_stop if isinstance(platform, BenchPlatform) else _nothing
    if guardian is not None and not isinstance(platform_link, GuardedModbus):
        guardian.once_ordered = stop
    try:
        cage.zero()
    finally:
        if guardian is not None:
            guardian.once_ordered = _nothing
        stop()


def _nothing() -> None:
    """Of a platform that a person turns."""
