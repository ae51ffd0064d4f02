"""Quantities that step when somebody acts, kept as functions of time so that the past can be sampled at any moment."""

from __future__ import annotations

from typing import Generic, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
T = TypeVar("T")


class Steps(Generic[T]):
    """A value that holds until it is set again."""

    def __init__(self, first: T) -> None:
        self._t, self.values = np.array([-np.inf]), [first]

    def set(self, t_s: float, value: T) -> None:
        """From `t_s` on it is `value`."""
        self._t = np.append(self._t, t_s)
        self.values.append(value)

    @property
    def last(self) -> T:
        """The value now."""
        return self.values[-1]

    def index(self, t_s: Array) -> NDArray[np.intp]:
        """Which of `values` holds at each time (n,)."""
        return np.searchsorted(self._t, t_s, side="right") - 1


class Relaxing:
    """A current that follows its set-point through an inductance: di/dt = (target − i) / tau."""

    def __init__(self, tau_s: float) -> None:
        self._tau = tau_s
        self._t, self._from, self._to = [-np.inf], [0.0], [0.0]
        self._table: Array | None = None  # of the three, until the next step

    @property
    def target(self) -> float:
        """Where it goes."""
        return self._to[-1]

    def set(self, t_s: float, target: float) -> None:
        """From `t_s` on it goes to `target`; what was to come after that does not come."""
        while self._t[-1] > t_s:
            self._drop_last()
        if target != self._to[-1]:
            self._from.append(self.now(t_s))
            self._t.append(t_s)
            self._to.append(target)
            self._table = None

    def now(self, t_s: float) -> float:
        """The current at one moment after the last step that anybody took; steps to come are none yet."""
        k = len(self._t) - 1
        while self._t[k] > t_s:
            k -= 1
        fading = np.exp(-(t_s - self._t[k]) / self._tau) if k else 0.0
        return float(self._to[k] + (self._from[k] - self._to[k]) * fading)

    def _drop_last(self) -> None:
        for steps in (self._t, self._from, self._to):
            steps.pop()
        self._table = None

    def at(self, t_s: Array) -> Array:
        """The current (n,) at any times (n,)."""
        if self._table is None:
            self._table = np.array([self._t, self._from, self._to])
        k = np.searchsorted(self._table[0], t_s, side="right") - 1
        stepped, start, target = self._table[:, k]
        since = np.where(k > 0, t_s - stepped, np.inf)
        return np.asarray(target + (start - target) * np.exp(-since / self._tau))
