"""The drivers that come with labcal, and what a bench file would have to state of each."""

from __future__ import annotations

from importlib.metadata import entry_points
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]
DRIVERS = {e.name: e for e in entry_points(group="labcal.drivers") if e.value.startswith("drivers.")}
SETTINGS: dict[str, dict[str, Any]] = {  # what a driver cannot do without
    "waveshare-relay": {"x": 0, "y": 1, "z": 2},
    "replay": {"file": str(ROOT / "tests" / "drivers" / "replayed.csv")},
    "csv-line": {"columns": ("t", "x", "y", "z", "temp_dut", "i_eps"), "serial": "7"},
    "scpi-table": {"model": "rohde-schwarz-hmp"},
    "can-dbc": {
        "file": str(ROOT / "tests" / "drivers" / "magnetometer.dbc"),
        "signals": {"x": "Field.Bx", "y": "Field.By", "z": "Field.Bz", "count": "Field.Counter"},
    },
    "daq-inputs": {"uT_per_V": (10.0, 10.0, 10.0)},
    "labjack-t7": {"uT_per_V": (10.0, 10.0, 10.0)},
    "velmex-vxm": {"home": "negative"},
    "gsm": {"period_s": 0.1},
    "iaga-2002": {"period_s": 0.1},
    "pos-1": {"period_s": 0.15},  # faster than any is, so that there are samples enough
}
