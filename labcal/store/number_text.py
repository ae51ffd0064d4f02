"""Numbers as the shortest text that reads back the same: Python's own `repr`, in a fifth of the time for many."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from pydantic_core import to_json

Array = NDArray[np.float64]

AS_IN_JSON = 1e-4, 1e16  # within, JSON's text is that of `repr`; outside, each writes exponents its own way
PROBE = (-12345.600000000001, 0.1, 1 / 3, 3e-4, 2.0**53, 2.0**50 + 0.25, 2.0**50 + 0.75, 1e15, 1.0, 0.0, -0.0)


def number_texts(values: Array) -> list[str]:
    """Each of the values (n,) as `repr` has it, without a last ".0"; "" where it is not finite."""
    size = np.abs(values)
    plain = (size >= AS_IN_JSON[0]) & (size < AS_IN_JSON[1]) | (size == 0.0)
    texts = _texts(np.where(plain, values, 0.0).tolist()) if len(values) else []
    for place in np.flatnonzero(~plain).tolist():
        value = float(values[place])
        texts[place] = repr(value).removesuffix(".0") if np.isfinite(value) else ""
    return texts


def _texts(numbers: list[float]) -> list[str]:
    return (_by_json if _same() else _one_by_one)(numbers)


def _same() -> bool:
    """Whether the installed JSON writes numbers as Python does: a run's hash is that of its text."""
    return _by_json(list(PROBE)) == _one_by_one(list(PROBE))


def _by_json(numbers: list[float]) -> list[str]:
    listed = to_json(numbers).decode()
    return f"{listed[1:-1]},".replace(".0,", ",")[:-1].split(",")


def _one_by_one(numbers: list[float]) -> list[str]:
    return [repr(number).removesuffix(".0") for number in numbers]
