"""The uncertainty budget of one quantity (GUM, 8): what contributes how much, combined, expanded."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

PROBABILITY = 0.9545  # of a normal distribution within k = 2 (GUM, table G.1)
SHOWN = 1e-5  # share of the variance below which a row says nothing


@dataclass(frozen=True, slots=True)
class Row:
    """One contribution, independent of the others: its effect on the quantity is `sensitivity` times `u`."""

    source: str
    type: Literal["A", "B"]
    distribution: str
    u: float  # standard uncertainty of the source, in `unit`
    unit: str
    sensitivity: float  # of the quantity, per `unit`
    dof: float  # of u; infinite where it is taken as known

    @property
    def effect(self) -> float:
        """|c u|, the standard uncertainty of the quantity by this source alone (GUM, 5.1.3)."""
        return abs(self.sensitivity * self.u)


@dataclass(frozen=True, slots=True)
class Correlation:
    """How two fitted parameters that the quantity rests on are correlated."""

    one: str
    other: str
    r: float


@dataclass(frozen=True, slots=True)
class Budget:
    """The contributions to one quantity, and what they come to."""

    quantity: str
    at: str
    unit: str
    rows: tuple[Row, ...]
    correlations: tuple[Correlation, ...] = ()

    @property
    def u(self) -> float:
        """Combined standard uncertainty (GUM, 5.1.2, (10)): the rows are independent."""
        return float(np.sqrt(np.sum([row.effect**2 for row in self.rows])))

    @property
    def dof(self) -> float:
        """Effective degrees of freedom by Welch and Satterthwaite (GUM, G.4.1, (G.2b)); may be infinite."""
        inverse = sum(row.effect**4 / row.dof for row in self.rows)
        return self.u**4 / inverse if inverse > 0 else np.inf

    @property
    def k(self) -> float:
        """The coverage factor: Student's t for PROBABILITY (GUM, G.3.2, G.6.4); 2.00 where dof is infinite."""
        return coverage_factor(self.dof)

    @property
    def U(self) -> float:
        """The expanded uncertainty k u (GUM, 6.2.1)."""
        return self.k * self.u

    def as_json(self) -> dict[str, Any]:
        """As the calibration file has it (contract), six digits of each number; infinite degrees of freedom are null.

        Rows that do not show, by their share, are left out.
        """
        u2 = self.u**2
        shares = [(row, row.effect**2 / u2 if u2 > 0 else 0.0) for row in self.rows]
        return {
            "quantity": self.quantity,
            "at": self.at,
            "unit": self.unit,
            "U": _digits(self.U),
            "k": _digits(self.k),
            "dof": _finite(self.dof),
            "rows": [_row(row, share) for row, share in shares if share > SHOWN],
            "correlations": [{"one": c.one, "other": c.other, "r": _digits(c.r)} for c in self.correlations],
        }


def coverage_factor(dof: float, probability: float = PROBABILITY) -> float:
    """Student's t (1 + p)/2 for that many degrees of freedom; they are not rounded down (GUM, G.4.1, note 1)."""
    from scipy.special import ndtri, stdtrit

    upper = (1 + probability) / 2
    return float(stdtrit(dof, upper) if np.isfinite(dof) else ndtri(upper))


def _row(row: Row, share: float) -> dict[str, Any]:
    return {
        "source": row.source,
        "type": row.type,
        "distribution": row.distribution,
        "u": _digits(row.u),
        "unit": row.unit,
        "sensitivity": _digits(row.sensitivity),
        "share": min(_digits(share), 1.0),
        "dof": _finite(row.dof),
    }


def _digits(value: float) -> float:
    return float(f"{value:.6g}")


def _finite(value: float) -> float | None:
    return _digits(value) if np.isfinite(value) else None
