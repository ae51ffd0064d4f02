"""What stands in a calibration file, piece by piece: numbers, names, spans and matrices, each checked as it is read."""

from __future__ import annotations

from datetime import datetime
from typing import Annotated

import numpy as np
from pydantic import AfterValidator, Field

from labcal.files.text_safety import checked_text

WORST_CONDITION = 1e8  # of K; beyond it readings cannot be distinguished
ROUNDING = 1e-6  # of a covariance scaled to unit variances


def _range(pair: tuple[float, float]) -> tuple[float, float]:
    if pair[0] > pair[1]:
        raise ValueError(f"from {pair[0]:g} to {pair[1]:g} runs backward")
    return pair


def checked_map(rows: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    """K, which has to map different readings to different fields."""
    K = np.array(rows)
    if not np.any(K) or np.linalg.cond(K) > WORST_CONDITION:
        raise ValueError("is not invertible: it would map different readings to one field")
    return rows


def positive(rows: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    """A symmetric positive semi-definite matrix."""
    C = np.array(rows)
    u = np.sqrt(np.maximum(np.diag(C), 0.0))
    scaled = C / np.outer(unit := np.where(u > 0, u, 1.0), unit)
    if np.any(np.diag(C) < 0):
        raise ValueError("has a negative variance on its diagonal")
    if np.max(np.abs(scaled - scaled.T)) > ROUNDING:
        raise ValueError("is not symmetric")
    if np.linalg.eigvalsh((scaled + scaled.T) / 2).min() < -ROUNDING:
        raise ValueError("is not positive semi-definite")
    return rows


def checked_square(rows: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    """As many columns as rows."""
    if {len(row) for row in rows} != {len(rows)}:
        raise ValueError("is not square")
    return rows


def _even(rows: tuple[tuple[float, ...], ...]) -> tuple[tuple[float, ...], ...]:
    if len({len(row) for row in rows}) > 1:
        raise ValueError("has rows of unlike length")
    return rows


def _distinct(names: tuple[str, ...]) -> tuple[str, ...]:
    if len(set(names)) < len(names):
        raise ValueError("names one thing twice")
    return names


def _time(text: str) -> str:
    try:
        zone = datetime.fromisoformat(text).tzinfo
    except ValueError:
        zone = None
    if zone is None:
        raise ValueError(f"{text[:40]!r} is no time of a known zone")
    return text


Text = Annotated[str, Field(max_length=10_000), AfterValidator(checked_text)]
Name = Annotated[Text, Field(min_length=1)]
Utc = Annotated[Name, AfterValidator(_time)]
Names = Annotated[tuple[Name, ...], AfterValidator(_distinct)]
Span = Annotated[tuple[float, float], AfterValidator(_range)]
Row = tuple[float, float, float]
CovarianceRow = Annotated[tuple[float, ...], Field(min_length=12, max_length=12)]
Covariance = Annotated[tuple[CovarianceRow, ...], Field(min_length=12, max_length=12), AfterValidator(positive)]
JointCovariance = Annotated[
    tuple[tuple[float, ...], ...],
    Field(min_length=12),
    AfterValidator(checked_square),
    AfterValidator(positive),
]
Table = Annotated[
    tuple[Annotated[tuple[float, ...], Field(min_length=1)], ...], Field(min_length=1), AfterValidator(_even)
]
Plain = dict[Name, float | Text | bool | None]
Sha256 = Annotated[str, Field(pattern=r"\A[0-9a-f]{64}\z")]
Uncertainty = Annotated[float, Field(ge=0, le=1e100)]  # its square is a number too
