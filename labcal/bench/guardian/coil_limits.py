"""What one coil may do, as the guardian sees it: current and ramp. Refused with both numbers."""

from __future__ import annotations

from labcal.errors import LimitError

BURST_S = 0.25  # a step may be what the ramp allows in this time: ramps are made of steps, 0.1 s apart


class CoilLimit:
    """Watches one axis. The allowance for steps refills at the ramp's rate, up to `BURST_S` of it."""

    def __init__(self, axis: str, current_A: float, ramp_A_per_s: float) -> None:
        self._axis, self._current_A, self._ramp_A_per_s = axis, current_A, ramp_A_per_s
        self._level_A, self._allowance_A, self._t_s = 0.0, ramp_A_per_s * BURST_S, 0.0

    def refuse(self, current_A: float, now_s: float) -> None:
        """Raise LimitError where `current_A` may not be set now; nothing has been sent then."""
        if not abs(current_A) <= self._current_A:
            raise LimitError(
                f"coil {self._axis}: {current_A:.4g} A is beyond its limit of {self._current_A:g} A; nothing was set.",
                fault="limit reached",
            )
        step, allowed = abs(current_A - self._level_A), self._allowed(now_s)
        if step > allowed + 1e-3:
            raise LimitError(
                f"coil {self._axis}: a step of {step:.3g} A is beyond the {allowed:.3g} A that its ramp of "
                f"{self._ramp_A_per_s:g} A/s allows now; nothing was set.",
                fault="limit reached",
            )

    def was_set(self, current_A: float, now_s: float) -> None:
        """From now on `current_A` is the level."""
        self._allowance_A = max(0.0, self._allowed(now_s) - abs(current_A - self._level_A))
        self._level_A, self._t_s = current_A, now_s

    @property
    def level_A(self) -> float:
        """What was set last [A]."""
        return self._level_A

    def at_zero(self) -> None:
        """The coil has come to zero by itself."""
        self._level_A, self._allowance_A = 0.0, self._ramp_A_per_s * BURST_S

    @property
    def ramp_down_s(self) -> float:
        """How long the way to zero takes from here."""
        return abs(self._level_A) / self._ramp_A_per_s

    def _allowed(self, now_s: float) -> float:
        refilled = self._allowance_A + (now_s - self._t_s) * self._ramp_A_per_s
        return min(refilled, self._ramp_A_per_s * BURST_S)
