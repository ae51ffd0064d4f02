"""What the streams sent during one step of a procedure, put together for the procedure's own eyes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.errors import InstrumentError
from labcal.record.stream import Block, Stream

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """One stream's samples: `t_s` (n,) and `values` (n, k) in the order of `columns`."""

    stream: Stream
    columns: tuple[str, ...]
    t_s: Array
    values: Array

    def __len__(self) -> int:
        return len(self.t_s)

    @property
    def mean(self) -> Array:
        """Mean (k,) of the samples."""
        return np.asarray(self.values.mean(axis=0))

    @property
    def u_mean(self) -> Array:
        """Standard uncertainty (k,) of the mean, from successive differences and the samples' own correlation.

        sigma² / n times (1 + r) / (1 − r), with r the lag-one correlation where it is positive.
        """
        n = len(self.t_s)
        if n < 3:
            return np.full(self.values.shape[1], np.inf)
        d = self.values - self.values.mean(axis=0)
        variance = np.sum(d**2, axis=0) / (n - 1)
        covariance = np.sum(d[1:] * d[:-1], axis=0) / (n - 1)
        r = np.clip(covariance / np.where(variance > 0, variance, 1.0), 0.0, 0.99)
        return np.asarray(np.sqrt(variance / n * (1 + r) / (1 - r)))

    @property
    def period_s(self) -> float:
        """The median time between two samples."""
        return float(np.median(np.diff(self.t_s))) if len(self) > 1 else np.nan

    def between(self, start_s: float, end_s: float) -> Samples:
        """The samples stamped from `start_s` up to `end_s`."""
        rows = (self.t_s >= start_s) & (self.t_s < end_s)
        return Samples(self.stream, self.columns, self.t_s[rows], self.values[rows])

    def at(self, t_s: ArrayLike) -> Array:
        """The values (m, k), interpolated linearly at `t_s` (m,); NaN outside what was recorded."""
        t = np.asarray(t_s, dtype=float)
        columns = [np.interp(t, self.t_s, column, left=np.nan, right=np.nan) for column in self.values.T]
        return np.column_stack(columns)


def samples(blocks: Iterable[Block], stream: Stream, column: str | None = None) -> Samples:
    """All samples of one stream, in time order; of the one that has `column` where several sources share a stream.

    Raises InstrumentError (silent) where there are none.
    """
    found = [b for b in blocks if b.stream == stream and (column is None or column in b.columns) and len(b)]
    if not found:
        raise InstrumentError(
            f"no samples came from {column or stream}.",
            fault="silent",
            remedy="Look at its power and its cable.",
        )
    columns = (column,) if column else found[0].columns
    places = [[b.columns.index(c) for c in columns] for b in found]
    t = np.concatenate([b.t_s for b in found])
    values = np.concatenate([b.values[:, place] for b, place in zip(found, places, strict=True)])
    order = np.argsort(t, kind="stable")
    return Samples(stream, columns, t[order], values[order])


def merged(blocks: Iterable[Block]) -> list[Block]:
    """The same samples in one block for each stream, source and set of columns; their order in time stays."""
    groups: dict[tuple[Stream, str, tuple[str, ...]], list[Block]] = {}
    for block in blocks:
        groups.setdefault((block.stream, block.source, block.columns), []).append(block)
    return [_one_block(group) for group in groups.values()]


def _one_block(group: list[Block]) -> Block:
    if len(group) == 1:
        return group[0]
    t_s, values = np.concatenate([b.t_s for b in group]), np.concatenate([b.values for b in group])
    return replace(group[0], t_s=t_s, values=values, raw=b"".join(b.raw for b in group))
