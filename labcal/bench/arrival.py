"""A stage that rests has not arrived: where it rests decides."""

from __future__ import annotations

from labcal.errors import InstrumentError


def refuse_elsewhere(name: str, angle_deg: float, target_deg: float | None, tolerance_deg: float) -> None:
    """Raise InstrumentError (not arrived) where a stage at rest is off its target; None: it has none."""
    if target_deg is not None and not abs(angle_deg - target_deg) <= tolerance_deg:
        raise InstrumentError(
            f"{name}: it stopped {angle_deg - target_deg:+.3f}° from its target of {target_deg:.3f}°.",
            fault="not arrived",
            remedy="Look for what holds it, home it and begin this step again.",
        )
