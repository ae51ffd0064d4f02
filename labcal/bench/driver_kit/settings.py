"""Numbers that a driver's Settings may hold: what cannot be is refused while bench.toml is read.

Stated without pydantic, which reads them: it takes as long to load as all else that a supply needs to be switched off.
"""

from __future__ import annotations

from typing import Annotated

from annotated_types import Ge, Gt, Le

Positive = Annotated[float, Gt(0)]
NotNegative = Annotated[float, Ge(0)]
Count = Annotated[int, Ge(1)]
Address = Annotated[int, Ge(1), Le(247)]  # of a Modbus device
Output = Annotated[int, Ge(1), Le(4)]  # of a supply
