"""What is recorded of the coils: current and polarity of each axis."""

from __future__ import annotations

from labcal.bench.config import AXES
from labcal.bench.driver_kit.roles import ChannelSpec

COIL_CHANNELS = tuple(
    spec
    for axis in AXES
    for spec in (
        ChannelSpec(f"i_coil_{axis}", "A", "current", "coil"),
        ChannelSpec(f"polarity_coil_{axis}", "1", "other", "coil"),
    )
)
