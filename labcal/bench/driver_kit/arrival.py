"""A stage that rests has not arrived: where it rests decides. What turns the DUT turns it no faster than it may."""

from __future__ import annotations

from labcal.errors import InstrumentError, LimitError


def refuse_elsewhere(name: str, angle_deg: float, target_deg: float | None, tolerance_deg: float) -> None:
    """Raise InstrumentError (not arrived) where a stage at rest is off its target; None: it has none."""
    if target_deg is not None and not abs(angle_deg - target_deg) <= tolerance_deg:
        raise InstrumentError(
            f"{name}: it stopped {angle_deg - target_deg:+.3f}° from its target of {target_deg:.3f}°.",
            fault="not arrived",
        )


def refuse_fast_homing(name: str, homes_at_deg_per_s: float, limit_deg_per_s: float) -> None:
    """Raise LimitError where a stage homes faster than it may, at a speed that is set on the stage itself."""
    if homes_at_deg_per_s > limit_deg_per_s:
        raise LimitError(
            f"{name}: it homes at {homes_at_deg_per_s:.4g} deg/s, the DUT's limit is {limit_deg_per_s:g} deg/s; "
            "nothing was moved.",
            remedy="Lower the homing speed on the stage itself, or take the DUT off and home it with its own program.",
        )
