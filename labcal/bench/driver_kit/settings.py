"""Numbers that a driver's Settings may hold: what cannot be is refused while bench.toml is read."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
Count = Annotated[int, Field(ge=1)]
Address = Annotated[int, Field(ge=1, le=247)]  # of a Modbus device
Output = Annotated[int, Field(ge=1, le=4)]  # of a supply
