"""`[check_standard]` of bench.toml: the DUT that a bench measures again and again, and what its charts are made of."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Figure = Literal[
    "offset x", "offset y", "offset z", "scale x", "scale y", "scale z",
    "non-orthogonality x-y", "non-orthogonality y-z", "non-orthogonality z-x",
]  # fmt: skip
OFFSETS_AND_SCALES: tuple[Figure, ...] = ("offset x", "offset y", "offset z", "scale x", "scale y", "scale z")
Positive = Annotated[float, Field(gt=0, allow_inf_nan=False, strict=True)]
Finite = Annotated[float, Field(allow_inf_nan=False, strict=True)]


class CheckStandardConfig(BaseModel):
    """While the charts of this DUT are out of control, no run of another one begins here. Offsets in nT, scales in ppm.

    `repeats` runs are a point; the first `baseline` points make the limits; `between` takes the spread of points from
    each other instead of that of the repeats within them.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)
    serial: str = Field(min_length=1)
    procedure: str = "preflight"  # whose runs count
    quantities: Annotated[tuple[Figure, ...], Field(min_length=1)] = OFFSETS_AND_SCALES
    repeats: Annotated[int, Field(ge=1, le=50, strict=True)] = 1
    baseline: Annotated[int, Field(ge=8, le=1000, strict=True)] = 20
    between: bool = False
    sigma: dict[Figure, Positive] = {}  # of one run, where it is known; else the baseline's
    centre: dict[Figure, Finite] = {}
    rules: Annotated[tuple[Literal[1, 2, 3, 4], ...], Field(min_length=1)] = (1, 2, 3, 4)
