"""What a recording offers a calibration, and what the calibration makes of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.errors import InputError
from labcal.record import Run

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


def readings_of(
    reading: ArrayLike | Run,
    t_s: ArrayLike | None = None,
    segment: ArrayLike | None = None,
    mode: ArrayLike | None = None,
    channels: Mapping[str, ArrayLike] | None = None,
) -> Readings:
    """The columns (n rows, or one reading of three numbers), or those of a run. Raises InputError naming a column."""
    if isinstance(reading, Run):
        segments = np.array([s.id for s in reading.segments], dtype=np.str_)[reading.segment_index]
        housekeeping = {channel.name: channel.values for channel in reading.channels}
        return Readings(reading.reading, reading.t_s, segments, reading.mode, housekeeping)
    rows = np.atleast_2d(_numbers("reading", reading))
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError(f"expected n rows of three numbers; this has the shape {rows.shape}", column="reading")
    names, modes = (None if c is None else np.atleast_1d(np.asarray(c, dtype=np.str_)) for c in (segment, mode))
    times = None if t_s is None else np.atleast_1d(_numbers("t_s", t_s))
    named = {name: np.atleast_1d(_numbers(name, values)) for name, values in (channels or {}).items()}
    found = Readings(rows, times, names, modes, named)
    for name, column in {"t_s": found.t_s, "segment": found.segment, "mode": found.mode, **named}.items():
        if column is not None and column.shape != (len(rows),):
            raise InputError(f"has the shape {column.shape}; there are {len(rows)} readings", column=name)
    return found


def _numbers(name: str, values: ArrayLike) -> Array:
    try:
        return np.asarray(values, dtype=float)
    except (TypeError, ValueError):
        raise InputError("expected numbers", column=name) from None


@dataclass(frozen=True, slots=True, eq=False)
class Applied:
    """The field of each row, NaN where the reading is missing."""

    field_nT: Array  # (n, 3) in B
    u_nT: Array  # (n,) standard uncertainty of one component, noise included
    flags: tuple[str, ...]  # (n,) empty, or words of `FLAGS` apart by spaces
