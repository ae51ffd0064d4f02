"""What a stream tells while its samples pass: mean, trend and noise of a day at a thousand a second, none of it kept.

Means and co-moments are taken on block by block (Chan, Golub & LeVeque, Am. Stat. 37, 242, 1983).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.bench.streams.samples import Samples, correlated_u, samples
from labcal.record.stream import Block, Stream

Array = NDArray[np.float64]
PACED = 10_000  # samples, at least, that the sampling rate is worked out from


class Running:
    """One stream's samples so far: `n` rows of k columns. Each block comes after the one before it."""

    def __init__(self, stream: Stream) -> None:
        self.stream, self.columns, self.n = stream, tuple[str, ...](), 0
        self._mean = self._moments = self._steps = np.empty(0)  # of (t, values): (1 + k,), (1 + k, 1 + k), (k,)
        self._first = self._last = np.empty(0)
        self._paced: list[Samples] = []

    def take(self, block: Block) -> None:
        """Take a block in, where it is of this stream."""
        if block.stream == self.stream and len(block):
            self._add(samples([block], self.stream))

    def __len__(self) -> int:
        return self.n

    @property
    def mean(self) -> Array:
        """Mean (k,) of the samples."""
        return self._mean[1:]

    @property
    def u_mean(self) -> Array:
        """Standard uncertainty (k,) of the mean, as that of `Samples`."""
        square, first, last = np.diag(self._moments)[1:], self._first[1:] - self.mean, self._last[1:] - self.mean
        return correlated_u(self.n, square, square - (first**2 + last**2 + self._steps) / 2)

    @property
    def noise(self) -> Array:
        """Standard deviation (k,) of one sample from successive differences (von Neumann): drift does not enter."""
        return np.sqrt(self._steps / max(self.n - 1, 1) / 2)

    @property
    def period_s(self) -> float:
        """The time between two samples, from the first of them. Raises InstrumentError where none can be determined."""
        return samples([_block(one) for one in self._paced], self.stream).period_s

    def trend(self) -> tuple[Array, Array]:
        """Slopes (k,) [1/s] of straight lines and their standard uncertainties, least squares with white residuals."""
        slope = self._moments[0, 1:] / self._moments[0, 0]
        left = np.maximum(np.diag(self._moments)[1:] - slope * self._moments[0, 1:], 0.0)
        return slope, np.sqrt(left / (self.n - 2) / self._moments[0, 0])

    def _add(self, new: Samples) -> None:
        rows = np.column_stack([new.t_s, new.values])
        if not self.n:
            self.columns, self._first, self._last = new.columns, rows[0], rows[0]
            self._mean, self._moments = rows[0].copy(), np.zeros((rows.shape[1],) * 2)
            self._steps = np.zeros(rows.shape[1] - 1)
        if sum(map(len, self._paced)) < PACED:
            self._paced.append(new)
        self._steps = self._steps + np.sum(np.diff(rows[:, 1:], axis=0, prepend=self._last[None, 1:]) ** 2, axis=0)
        self._last, total = rows[-1], self.n + len(rows)
        mean, apart = rows.mean(axis=0), rows.mean(axis=0) - self._mean
        inside = rows - mean
        self._moments = self._moments + inside.T @ inside + np.outer(apart, apart) * (self.n * len(rows) / total)
        self._mean, self.n = self._mean + apart * (len(rows) / total), total


def _block(of: Samples) -> Block:
    return Block(of.stream, "", of.columns, of.t_s, of.values)
