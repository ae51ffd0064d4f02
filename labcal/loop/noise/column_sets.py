"""Sets of columns whose products are asked for together: side by side, or combinations of fewer columns."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class ColumnSets:
    """So many sets of p columns each, made of m columns."""

    made_of: Array  # (n, q, m)
    count: int  # sets
    mix: Array | None = None  # (m, sets, p); None where the m columns are those of the sets, one set after the other

    @classmethod
    def alone(cls, columns: Array) -> ColumnSets:
        """One set (n, q, p)."""
        return cls(columns, 1)

    def like(self, made_of: Array) -> ColumnSets:
        """The same sets of other columns (n', q, m)."""
        return replace(self, made_of=made_of)

    def columns(self, place: int) -> Array:
        """The columns (n, q, p) of one set."""
        if self.mix is not None:
            return self.made_of @ self.mix[:, place]
        p = self.made_of.shape[2] // self.count
        return self.made_of[:, :, place * p : (place + 1) * p]

    def squares(self, rows: Array) -> Array:
        """The Gram matrix (sets, p, p) of each set, where its m columns are `rows` (r, m)."""
        if self.mix is None:
            each = rows.reshape(len(rows), self.count, -1)
            return np.asarray(each.transpose(1, 2, 0) @ each.transpose(1, 0, 2))
        onto = np.tensordot(rows.T @ rows, self.mix, axes=1)
        return np.asarray(self.mix.transpose(1, 2, 0) @ onto.transpose(1, 0, 2))

    def products(self, of_parts: Array) -> Array:
        """Of products (..., m) of the m columns with others, those of all sets' columns (..., sets p)."""
        return of_parts if self.mix is None else np.asarray(of_parts @ self.mix.reshape(len(self.mix), -1))
