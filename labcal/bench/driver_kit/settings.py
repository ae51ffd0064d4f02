"""Numbers that a driver's Settings may hold: what cannot be is refused while bench.toml is read.

Stated without pydantic, which reads them: it takes as long to load as all else that a supply needs to be switched off.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any


@dataclass(frozen=True, slots=True)
class Bounds:
    """Of a number; None where there is none."""

    gt: float | None = None
    ge: float | None = None
    le: float | None = None

    def __get_pydantic_core_schema__(self, source: Any, handler: Callable[[Any], dict[str, Any]]) -> dict[str, Any]:
        """The number's own schema with these bounds, as pydantic's own constraints."""
        stated = {"gt": self.gt, "ge": self.ge, "le": self.le}
        return handler(source) | {key: bound for key, bound in stated.items() if bound is not None}


Positive = Annotated[float, Bounds(gt=0)]
NotNegative = Annotated[float, Bounds(ge=0)]
Count = Annotated[int, Bounds(ge=1)]
Address = Annotated[int, Bounds(ge=1, le=247)]  # of a Modbus device
Output = Annotated[int, Bounds(ge=1, le=4)]  # of a supply
