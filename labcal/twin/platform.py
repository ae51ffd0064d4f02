"""The rotation platform: finite rate and acceleration, a little wobble."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Piece = tuple[float, float, float, float]  # from t: angle, rate, acceleration


@dataclass
class Turntable:
    """Motion as pieces of constant acceleration; angles in degrees, right-handed about the platform axis."""

    accel_deg_per_s2: float = 5.0
    pieces: list[Piece] = field(default_factory=lambda: [(-np.inf, 0.0, 0.0, 0.0)])

    def now(self, t_s: float) -> tuple[float, float]:
        """Angle and rate at `t_s`."""
        last = self.pieces[-1]
        t0, angle, rate, accel = last if last[0] <= t_s else next(p for p in reversed(self.pieces) if p[0] <= t_s)
        since = t_s - t0 if np.isfinite(t0) else 0.0
        return angle + rate * since + accel * since**2 / 2, rate + accel * since

    def moving(self, t_s: float) -> bool:
        """Whether a motion is under way."""
        return t_s < self.pieces[-1][0]

    def stop(self, t_s: float) -> None:
        """Brake from `t_s` on."""
        angle, rate = self.now(t_s)
        self.pieces = [p for p in self.pieces if p[0] < t_s]
        if rate:
            self._append(t_s, angle, rate, -np.sign(rate) * self.accel_deg_per_s2, abs(rate) / self.accel_deg_per_s2)
        else:
            self.pieces.append((t_s, angle, 0.0, 0.0))

    def move(self, t_s: float, target_deg: float, rate_deg_per_s: float) -> None:
        """Go to `target_deg`: brake where it moves, then accelerate, cruise, brake."""
        self.stop(t_s)
        t, start, _, _ = self.pieces[-1]
        way, a = target_deg - start, self.accel_deg_per_s2
        if way == 0:
            return
        rate = min(rate_deg_per_s, np.sqrt(abs(way) * a))
        sign, rise = np.sign(way), rate / a
        self.pieces.pop()
        self._append(t, start, 0.0, sign * a, rise)
        t, angle, _, _ = self.pieces.pop()
        self._append(t, angle, sign * rate, 0.0, abs(way) / rate - rise)
        t, angle, _, _ = self.pieces.pop()
        self._append(t, angle, sign * rate, -sign * a, rise)
        self.pieces[-1] = (self.pieces[-1][0], target_deg, 0.0, 0.0)

    def place(self, t_s: float, angle_deg: float) -> None:
        """Be at `angle_deg` at once, as a hand turns a dial."""
        self.pieces = [p for p in self.pieces if p[0] < t_s] + [(t_s, angle_deg, 0.0, 0.0)]

    def at(self, t_s: Array) -> Array:
        """Angles (n,) at any times (n,)."""
        table = np.array(self.pieces)
        k = np.searchsorted(table[:, 0], t_s, side="right") - 1
        t0, angle, rate, accel = table[k].T
        since = np.where(np.isfinite(t0), t_s - t0, 0.0)
        return np.asarray(angle + rate * since + accel * since**2 / 2)

    def busy(self, t_s: Array) -> Array:
        """1 where it moves, else 0 (n,)."""
        table = np.array(self.pieces)
        k = np.searchsorted(table[:, 0], t_s, side="right") - 1
        return np.asarray(np.any(table[k, 2:] != 0, axis=1), dtype=float)

    def _append(self, t: float, angle: float, rate: float, accel: float, lasts: float) -> None:
        end = angle + rate * lasts + accel * lasts**2 / 2
        self.pieces += [(t, angle, rate, accel), (t + lasts, end, 0.0, 0.0)]
