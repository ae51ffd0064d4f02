"""What the fields of run.json hold: one line of text, a date, a unit axis, a rotation, a temperature, a field."""

from __future__ import annotations

from datetime import date, datetime
from typing import Annotated

import numpy as np
from pydantic import AfterValidator, BeforeValidator, Field

from labcal.files.text_safety import checked_text
from labcal.record.physical import LARGEST_FIELD_nT
from labcal.record.vector import Matrix, Vector

ROUNDING = 1e-4  # how far a written axis or matrix may be from length one: four decimals are rounded, not wrong


def _unit_axis(v: Vector) -> Vector:
    """`v` at length one. Raises ValueError where it is farther from it than rounding explains."""
    with np.errstate(over="ignore"):
        length = float(np.linalg.norm(v))
    if abs(length - 1) > ROUNDING:
        raise ValueError(f"expected a unit vector, found one of length {length:.6g}")
    if abs(length - 1) < 1e-12:
        return v
    return (v[0] / length, v[1] / length, v[2] / length)


def _rotation(m: Matrix) -> Matrix:
    """The rotation nearest to `m`. Raises ValueError where it is farther from one than rounding explains."""
    R = np.array(m)
    with np.errstate(over="ignore"):
        off = float(np.abs(R @ R.T - np.eye(3)).max())
    if not off < ROUNDING:
        raise ValueError(f"expected a rotation matrix; R Rᵀ differs from the identity by {off:.2g}")
    if np.linalg.det(R) < 0:
        raise ValueError("expected a rotation matrix, found one that mirrors (its determinant is -1)")
    if off > 1e-12:
        u, _, vt = np.linalg.svd(R)
        R = u @ vt
    a, b, c = R.tolist()
    return (tuple(a), tuple(b), tuple(c))


def _iso_8601(text: str) -> str:
    try:
        datetime.fromisoformat(text)
    except ValueError:
        raise ValueError("expected a date and time in ISO 8601, such as 2026-03-02T08:15:00Z") from None
    return text


def _iso_day(text: str) -> str:
    try:
        date.fromisoformat(text)
    except ValueError:
        raise ValueError("expected a date in ISO 8601, such as 2026-03-02") from None
    return text


def _one_line(text: str) -> str:
    if "\n" in text or "\t" in text:
        raise ValueError("expected one line without tabs")
    return checked_text(text)


Text = Annotated[str, Field(max_length=10_000), AfterValidator(checked_text)]
Name = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(_one_line)]
Mode = Annotated[str, Field(max_length=100), AfterValidator(_one_line)]
Utc = Annotated[str, AfterValidator(_iso_8601)]
Axis = Annotated[Vector, AfterValidator(_unit_axis)]
Rotation = Annotated[Matrix, AfterValidator(_rotation)]
Spread = Annotated[float, Field(ge=0)]
Day = Annotated[str, AfterValidator(_iso_day)]
Celsius = Annotated[float, Field(ge=-273.15, le=1000)]
Nanotesla = Annotated[float, Field(ge=0, le=LARGEST_FIELD_nT)]


def null_is(default: str) -> BeforeValidator:
    """What null says where a text may be left out: the same as leaving it out."""
    return BeforeValidator(lambda value: default if value is None else value)
