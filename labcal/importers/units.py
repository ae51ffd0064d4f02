"""Units that recordings come in, and what a run is written in: nT, s, degrees, °C, A, V."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Literal

FieldUnit = Literal["nT", "uT", "µT", "μT", "mT", "T", "mG", "G", "count"]
TimeUnit = Literal["s", "ms", "us", "µs", "μs", "ns", "min", "iso"]
AngleUnit = Literal["deg", "rad"]

nT_OF: Mapping[str, float] = {
    "nT": 1.0, "uT": 1e3, "µT": 1e3, "μT": 1e3, "mT": 1e6, "T": 1e9, "mG": 1e2, "G": 1e5, "count": 1.0,
}  # fmt: skip
s_OF: Mapping[str, float] = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "µs": 1e-6, "μs": 1e-6, "ns": 1e-9, "min": 60.0}
# Of channels: what a run has instead, and value times factor plus offset.
CHANNEL_OF: Mapping[str, tuple[str, float, float]] = {
    "K": ("degC", 1.0, -273.15), "°C": ("degC", 1.0, 0.0), "degF": ("degC", 5 / 9, -160 / 9),
    "cdegC": ("degC", 0.01, 0.0),
    "mA": ("A", 1e-3, 0.0), "uA": ("A", 1e-6, 0.0), "µA": ("A", 1e-6, 0.0), "cA": ("A", 0.01, 0.0),
    "mV": ("V", 1e-3, 0.0), "mW": ("W", 1e-3, 0.0),
}  # fmt: skip
QUANTITY_OF: Mapping[str, str] = {
    "degC": "temperature", "A": "current", "V": "voltage", "W": "power", "Pa": "pressure", "hPa": "pressure",
    "%RH": "humidity", "deg/s": "rate", "rad/s": "rate", "rpm": "rate", "count": "count",
}  # fmt: skip
