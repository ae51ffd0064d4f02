"""What the streams sent during one step of a procedure, put together for the procedure's own eyes."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.errors import InstrumentError
from labcal.record.sampling import period_s
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
        """Standard uncertainty (k,) of the mean, with the samples' own correlation (see `correlated_u`)."""
        d = self.values - self.values.mean(axis=0)
        return correlated_u(len(self), np.sum(d**2, axis=0), np.sum(d[1:] * d[:-1], axis=0))

    @property
    def period_s(self) -> float:
        """The time between two samples, as `labcal.record.period_s`. Raises InstrumentError where there is none."""
        period = period_s(self.t_s)
        if np.isnan(period):
            raise InstrumentError(
                f"{self.stream}: {len(self)} samples came, all at one moment: its sampling rate is unknown.",
                fault="silent",
                remedy="Look at its power and its cable, or record for longer.",
            )
        return period

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
            remedy="Look at its power and its cable, or listen for longer.",
        )
    columns = (column,) if column else found[0].columns
    places = [[b.columns.index(c) for c in columns] for b in found]
    t = np.concatenate([b.t_s for b in found])
    values = np.concatenate([b.values[:, place] for b, place in zip(found, places, strict=True)])
    order = np.argsort(t, kind="stable")
    return Samples(stream, columns, t[order], values[order])


def correlated_u(n: int, squares: Array, products: Array) -> Array:
    """Standard uncertainty (k,) of a mean of n: sigma² / n times (1 + r) / (1 − r), r the lag-one correlation, if > 0.

    `squares` (k,): the sum of squared deviations from the mean; `products` (k,): that of each with the one before it.
    """
    if n < 3:
        return np.full(len(squares), np.inf)
    variance, covariance = squares / (n - 1), products / (n - 1)
    r = np.clip(covariance / np.where(variance > 0, variance, 1.0), 0.0, 0.99)
    return np.asarray(np.sqrt(variance / n * (1 + r) / (1 - r)))


def merged(blocks: Iterable[Block]) -> list[Block]:
    """The same samples in one block for each stream, source and set of columns; their order in time stays."""
    groups: dict[tuple[Stream, str, tuple[str, ...]], list[Block]] = {}
    for block in blocks:
        groups.setdefault((block.stream, block.source, block.columns), []).append(block)
    return [_one_block(group) for group in groups.values()]


def thinned(blocks: Iterable[Block], every_s: float) -> list[Block]:
    """The means over intervals of `every_s`, at their mean stamps: what moves slowly, of a recording of hours."""
    return [_means(block, every_s) for block in merged(blocks) if len(block)]


def _means(block: Block, every_s: float) -> Block:
    _, where, count = np.unique(np.floor(block.t_s / every_s), return_inverse=True, return_counts=True)
    sums = np.zeros((len(count), 1 + block.values.shape[1]))
    np.add.at(sums, where, np.column_stack([block.t_s, block.values]))
    means = sums / count[:, None]
    return replace(block, t_s=means[:, 0], values=means[:, 1:], raw=b"")


def _one_block(group: list[Block]) -> Block:
    if len(group) == 1:
        return group[0]
    t_s, values = np.concatenate([b.t_s for b in group]), np.concatenate([b.values for b in group])
    return replace(group[0], t_s=t_s, values=values, raw=b"".join(b.raw for b in group))


def block_of(stream: Stream, source: str, columns: tuple[str, ...], rows: list[tuple[float, ...]]) -> Block:
    """Rows of t_s and values, as they were polled, in one block."""
    table = np.array(rows, dtype=float)
    return Block(stream, source, columns, table[:, 0], table[:, 1:])
