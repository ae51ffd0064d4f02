"""Of the circle: what the turn that goes on has seen, and which stretches of those that are over nobody saw."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from labcal.bench.coverage import SECTOR_DEG, in_words
from labcal.record.stream import Event, Measurement

SECTORS = round(360 / SECTOR_DEG)
UNSEEN_S = 2.0  # without a reading so long, a DUT has not seen where the platform turned


def seen_about(axis: str, measured: Mapping[str, Measurement]) -> float:
    """The part of the circle, 0 to 1, that the best of the turns about a body axis has seen, by its missing sectors."""
    turns = re.compile(f"{axis}[+-].*: missing sectors")
    missing = [one.value for name, one in measured.items() if axis and turns.fullmatch(name)]
    return 1.0 - min(missing) / SECTORS if missing else 0.0


class Covered:
    """`unseen`: by segment, in words: 30°–58°."""

    def __init__(self) -> None:
        self._sectors, self.unseen = set[int](), dict[str, str]()

    def begin(self) -> None:
        """Another step or segment: nothing of it is seen yet."""
        self._sectors = set()

    def turned(self, t_s: NDArray[np.float64], angle_deg: NDArray[np.float64], dut_s: float | None) -> None:
        """The platform was there, as far as the DUT, last heard at `dut_s`, can have seen it."""
        seen = t_s < (dut_s or np.inf) + UNSEEN_S
        self._sectors |= {int(a % 360 // SECTOR_DEG) for a in angle_deg[seen]}

    def part(self) -> float:
        """Of the circle, 0 to 1."""
        return len(self._sectors) / SECTORS

    def missed(self, event: Event) -> None:
        """A turn is over and has not seen these stretches."""
        self.unseen[str(event.data["segment"])] = in_words([(a, b) for a, b in event.data["gaps_deg"]])

    def forget(self, segments: Iterable[str]) -> None:
        """They are measured again, or not used."""
        for segment in segments:
            self.unseen.pop(segment, None)

    def about(self, axis: str) -> str:
        """What no turn about this body axis may leave out, and did: each stretch once."""
        turns = (words for name, words in self.unseen.items() if name[:1] == axis)
        return ", ".join(dict.fromkeys(turns))
