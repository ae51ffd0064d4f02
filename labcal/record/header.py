"""What is known about a run before its first sample: who, with what, by which procedure."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from labcal.record.administrative import Administrative
from labcal.record.run import Dut, Quantity, Reference, Role
from labcal.record.specification import Specification


@dataclass(frozen=True, slots=True)
class ChannelSpec:
    """A housekeeping channel that a run will have: what its column in "channel" blocks means."""

    name: str
    unit: str
    quantity: Quantity
    role: Role = "dut"


@dataclass(frozen=True, slots=True)
class RunHeader:
    """The head of a record; it is written once, when the run begins."""

    run_id: str
    started_utc: str  # ISO 8601
    simulated: bool
    operator: str
    dut: Dut
    reference: Reference
    channels: tuple[ChannelSpec, ...] = ()
    environment: Mapping[str, float] | None = None
    procedure: str = ""
    parameters: Mapping[str, Any] = field(default_factory=dict)
    source_sha256: str = ""  # of the procedure's own file
    bench: str = ""  # bench.toml, its whole text
    instruments: tuple[Mapping[str, str], ...] = ()  # name, manufacturer, model, serial, firmware
    software: str = ""
    cage_sha256: str | None = None  # of the approved cage calibration's file
    specification: Specification | None = None  # chosen before the measurement
    administrative: Administrative | None = None
