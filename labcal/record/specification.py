"""What the DUT has to keep, and the rule that decides: stated before it is measured (ISO/IEC 17025:2017, 7.1.3)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any, ClassVar, Literal

Rule = Literal["simple-acceptance", "guard-band"]
FIELD_UNITS: Mapping[str, float] = {"nT": 1.0, "pT": 1e-3, "uT": 1e3, "µT": 1e3}  # in nT
GREEK_MU, MICRO = "\u03bc", "\u00b5"  # two letters that look alike: keyboards have either
RATIO_UNITS: Mapping[str, float] = {"1": 1.0, "%": 1e-2, "ppm": 1e-6}
ANGLE_UNITS: Mapping[str, float] = {"deg": 1.0, "arcmin": 1 / 60, "arcsec": 1 / 3600, "mrad": 0.18 / 3.141592653589793}
UNITS: Mapping[str, Mapping[str, float]] = {
    "offset": FIELD_UNITS,
    "scale": RATIO_UNITS,
    "non_orthogonality": ANGLE_UNITS,
    "noise": FIELD_UNITS,
    "linearity": {**FIELD_UNITS, **RATIO_UNITS},  # a ratio is one of the largest field seen along the axis
    "residual": FIELD_UNITS,
}
LONGEST_TITLE = 200
LARGEST_LIMIT = 1e12  # beyond it nothing is limited
LARGEST_GUARD = 10.0  # of r in w = r U; 3 leaves a risk of false acceptance below 1e-9 (ILAC G8:09/2019, table 1)
_STRICTLY = {"extra": "forbid", "strict": True, "allow_inf_nan": False}  # for what pydantic reads


@dataclass(frozen=True, slots=True)
class Limit:
    """The largest absolute value that is allowed, in `unit`. A value that is exactly at it conforms."""

    limit: float
    unit: str
    __pydantic_config__: ClassVar[dict[str, Any]] = _STRICTLY

    def __post_init__(self) -> None:
        if not 0 < self.limit <= LARGEST_LIMIT:
            raise ValueError(f"limit must be a number greater than 0, at most {LARGEST_LIMIT:g}")
        object.__setattr__(self, "unit", self.unit.replace(GREEK_MU, MICRO))


@dataclass(frozen=True, slots=True)
class Specification:
    """Limits of the sensor's figures, None where nothing is asked, and the decision rule.

    `guard-band` accepts as far as the limit less w = r U, with U of 95 %; `simple-acceptance` is r = 0. `title` says
    which specification this is. Raises ValueError for another unit than the figure has, and where nothing is limited.
    """

    offset: Limit | None = None  # zero reading of each axis
    scale: Limit | None = None  # scale factor of each axis, from nominal
    non_orthogonality: Limit | None = None  # of each pair of axes, from 90°
    noise: Limit | None = None  # standard deviation of one axis of one sample
    linearity: Limit | None = None  # each axis, from its best straight line
    residual: Limit | None = None  # rms of what the calibration leaves on held-out time
    rule: Rule = "guard-band"
    r: float = 1.0
    title: str = ""
    __pydantic_config__: ClassVar[dict[str, Any]] = _STRICTLY

    def __post_init__(self) -> None:
        if not self.limits:
            raise ValueError(f"limits nothing: state one of {', '.join(UNITS)}")
        for name, limit in self.limits.items():
            if limit.unit not in UNITS[name]:
                raise ValueError(f"{name} has no unit {limit.unit!r}: expected one of {', '.join(UNITS[name])}")
        if not 0 <= self.r <= LARGEST_GUARD:
            raise ValueError(f"r must lie between 0 and {LARGEST_GUARD:g}: the guard band is w = r U")
        if self.rule == "simple-acceptance" and self.r not in (0.0, 1.0):
            raise ValueError(
                f"simple-acceptance has no guard band: state no r, or rule = 'guard-band' for w = {self.r:g} U"
            )
        if len(self.title) > LONGEST_TITLE or not self.title.isprintable():
            raise ValueError(f"title must be one printable line of at most {LONGEST_TITLE} letters")

    @property
    def limits(self) -> Mapping[str, Limit]:
        """The limits that are stated, by figure."""
        stated = ((f.name, getattr(self, f.name)) for f in fields(self))
        return {name: value for name, value in stated if isinstance(value, Limit)}

    @property
    def guard(self) -> float:
        """The r of w = r U; 0 for simple acceptance."""
        return 0.0 if self.rule == "simple-acceptance" else self.r
