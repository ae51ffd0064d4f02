"""Where the field has been in the DUT's axes, by segment: since a run began, or was gone on with, and before. No Qt."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np
from numpy.typing import NDArray

from labcal.gui.viewmodels.ring_buffer import RingBuffer
from labcal.record.turned import TurnBefore

MOST = 4000  # readings of a segment


class Drawn:
    """`now`, `earlier`: by segment, in rings of t, x, y, z [s, nominal nT]."""

    def __init__(self, earlier: Mapping[str, RingBuffer] | None = None) -> None:
        self.now: dict[str, RingBuffer] = {}
        self.earlier: dict[str, RingBuffer] = dict(earlier or {})

    def begin(self, segment: str) -> None:
        """Nothing of it is drawn yet, and nothing any more of what was broken off."""
        self.forget((segment,))
        self.now[segment] = RingBuffer(3, MOST)

    def forget(self, segments: Iterable[str]) -> None:
        """They are measured again, or not used."""
        for segment in segments:
            self.now.pop(segment, None)
            self.earlier.pop(segment, None)

    def take_earlier(self, turns: Iterable[TurnBefore]) -> None:
        """What the store has of before, but for what was begun again since it was asked for."""
        for one in turns:
            if one.segment not in self.now:
                self.earlier[one.segment] = RingBuffer(3, MOST)
                self.earlier[one.segment].push(np.zeros(len(one.field_nT)), one.field_nT)

    def gone_on_with(self) -> Drawn:
        """The same where all of it was before."""
        return Drawn(self.earlier | self.now)

    def rows(self, *, earlier: bool = False) -> NDArray[np.float64]:
        """The readings of all segments (n, 3) [nominal nT], thinned."""
        rows = [ring.rows()[:, 1:] for ring in (self.earlier if earlier else self.now).values()]
        return np.concatenate(rows) if rows else np.empty((0, 3))
