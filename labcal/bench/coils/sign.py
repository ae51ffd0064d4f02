"""Whether a coil's field points where its contacts say: one small step after every reversal, seen by the reference."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.bench.config import AXES
from labcal.errors import InstrumentError

Array = NDArray[np.float64]
PROBE_NT = 2000.0  # of the step: far above noise and drift, far below what could hurt
AGREES = 0.5  # of the step must be seen, with its sign; a contact that hangs shows nothing, a welded one -1


@dataclass(frozen=True, slots=True)
class SignProbe:
    """A stretch of the way to a set-point, from `before` to `after` (3,) [A], that tells the sign of `axes`."""

    before: Array
    after: Array
    axes: tuple[int, ...]


class SignCheck:
    """Remembers whose sign has been seen. `probe_A` (3,): the smallest step that tells an axis' sign.

    `see` gives the field (3,) [nT, C] that the reference sees now, None where no reference sees the coils: then the
    contacts' own read-back is all there is.
    """

    def __init__(
        self, matrix_nT_per_A: Array, contacts: Collection[str], floor_A: Mapping[str, float],
        see: Callable[[], Array | None],
    ) -> None:  # fmt: skip
        self.see, self._matrix = see, matrix_nT_per_A
        self._contacts = [k for k, axis in enumerate(AXES) if axis in contacts]
        smallest = np.array([floor_A[axis] for axis in AXES])
        self._probe_A: Array = np.maximum(PROBE_NT / np.linalg.norm(matrix_nT_per_A, axis=0), smallest)
        self._seen: dict[int, float] = {}

    def forget(self) -> None:
        """The outputs are open: what the contacts do meanwhile is not known."""
        self._seen.clear()

    def probes(self, start_A: Array, target_A: Array) -> Iterator[SignProbe]:
        """Where to stop on the straight way from `start_A` to `target_A` (3,), in order.

        Axes that cross zero at about the same point share a probe. A current too small to be measured is left alone,
        and is looked at when it grows.
        """
        change, waiting = target_A - start_A, dict[int, tuple[float, float]]()
        for axis in self._contacts:
            if self._seen.get(axis) != np.sign(target_A[axis]):
                self._seen.pop(axis, None)
                if (stretch := self._stretch(axis, start_A[axis], target_A[axis])) is not None:
                    waiting[axis] = stretch
        while waiting:
            begin = min(first for first, _ in waiting.values())
            end = max(last for first, last in waiting.values() if first == begin)
            axes = tuple(axis for axis, (first, _) in waiting.items() if first <= end)
            end = max(waiting.pop(axis)[1] for axis in axes)
            yield SignProbe(start_A + begin * change, start_A + end * change, axes)

    def judge(self, probe: SignProbe, before_nT: Array, after_nT: Array) -> None:
        """Raise InstrumentError (polarity not confirmed) where the reference saw something else than the step."""
        wanted = probe.after - probe.before
        seen = np.linalg.solve(self._matrix, after_nT - before_nT)
        for axis in probe.axes:
            if not seen[axis] / wanted[axis] >= AGREES:
                raise InstrumentError(
                    f"coil {AXES[axis]}: after its contacts were set, a step of {wanted[axis]:+.3g} A was seen by the "
                    f"reference as {seen[axis]:+.3g} A.",
                    fault="polarity not confirmed",
                    remedy="Look for a contact that hangs or is welded, then run axes-check.",
                )
            self._seen[axis] = float(np.sign(wanted[axis]))

    def _stretch(self, axis: int, start_A: float, target_A: float) -> tuple[float, float] | None:
        """The parts of the way (0 to 1) where the axis leaves zero, and where it is a probe further; None: too near."""
        change = target_A - start_A
        leaves = max(0.0, -start_A / change) if change else 1.0
        there = leaves + float(self._probe_A[axis]) / abs(change) if change else np.inf
        return (leaves, there) if there <= 1 else None
