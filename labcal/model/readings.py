"""What a recording offers a calibration, and what the calibration makes of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Readings:
    """What a recording offers (n rows); NaN and "" are missing, None a column that is not there."""

    reading: Array  # (n, 3) in the DUT's unit
    t_s: Array | None = None  # (n,)
    segment: NDArray[Any] | None = None  # (n,) names or numbers
    mode: NDArray[Any] | None = None  # (n,) names, or numbers of `modes`
    channels: Mapping[str, Array] = field(default_factory=dict)  # each (n,)
    modes: tuple[str, ...] | None = None

    def __len__(self) -> int:
        return len(self.reading)

    def rows(self, start: int, stop: int) -> Readings:
        """Some of the rows, their modes by name."""
        t_s, segment, mode = (None if c is None else c[start:stop] for c in (self.t_s, self.segment, self.mode))
        mode = mode if mode is None or self.modes is None else np.array(self.modes, dtype=np.str_)[mode]
        channels = {name: values[start:stop] for name, values in self.channels.items()}
        return Readings(self.reading[start:stop], t_s, segment, mode, channels)


@dataclass(frozen=True, slots=True, eq=False)
class Applied:
    """The field of each row, NaN where the reading is missing."""

    field_nT: Array  # (n, 3) in B
    u_nT: Array  # (n,) standard uncertainty of one component, noise included
    flags: tuple[str, ...]  # (n,) empty, or words of `FLAGS` apart by spaces
