"""A run: who measured what with which instruments, and the samples. Frozen; NaN is a missing value."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.record.administrative import Administrative
from labcal.record.closure import Closure
from labcal.record.specification import Specification
from labcal.record.vector import Matrix, Vector

Array = NDArray[np.float64]

SegmentKind = Literal["rotation", "static", "free"]
Quantity = Literal["temperature", "current", "voltage", "power", "rate", "pressure", "humidity", "count", "other"]
Role = Literal["dut", "coil", "platform", "room"]


@dataclass(frozen=True, slots=True)
class Segment:
    """A stretch recorded in one way: a rotation about one axis, a standstill, or free motion.

    `axis_cage` is the platform axis in C, `axis_body` the unit vector of B mounted along it, and
    `body_from_cage` the attitude at angle zero; None is "not stated" (contract: frames and signs).
    """

    id: str
    kind: SegmentKind
    mode: str | None = None
    note: str = ""
    axis_body: Vector | None = None
    axis_cage: Vector | None = None
    body_from_cage: Matrix | None = None
    reference_frame: Literal["cage", "body"] = "cage"
    mounting: str | None = None
    angle_noise_deg: float | None = None
    u_axis_body_deg: float | None = None
    u_axis_cage_deg: float | None = None
    u_time_s: float | None = None


@dataclass(frozen=True, slots=True)
class Dut:
    """The device under test. `noise_nT` is the standard deviation of one axis of one sample."""

    serial: str
    model: str = ""
    unit: Literal["nT", "count"] = "nT"
    nominal_nT_per_unit: float = 1.0
    noise_nT: float | None = None


@dataclass(frozen=True, slots=True)
class Reference:
    """The reference sensor, and what is stated about it; None is unknown, and results say so."""

    kind: Literal["vector", "scalar", "none"]
    serial: str = ""
    noise_nT: float | None = None
    place: Literal["dut", "remote", "computed"] | None = None
    position_m: Vector | None = None
    u_scale_ppm: float | None = None
    u_offset_nT: float | None = None
    u_align_deg: float | None = None
    u_time_s: float | None = None
    calibration: str | None = None
    tc_ppm_per_K: float | None = None  # what is known of it and not corrected
    u_tc_ppm_per_K: float | None = None
    tc_nT_per_K: float | None = None
    u_tc_nT_per_K: float | None = None
    drift_nT_per_year: float | None = None
    u_drift_nT_per_year: float | None = None
    certificate: Mapping[str, str | float] | None = None  # number, issuer, date, due, U, temperature_C


@dataclass(frozen=True, slots=True, eq=False)
class Channel:
    """A housekeeping quantity along the run. Only channels of role `dut` may drive a sensor's effect."""

    name: str
    unit: str
    quantity: Quantity
    values: Array = field(repr=False)  # (n,), in `unit`
    role: Role = "dut"


@dataclass(frozen=True, slots=True, eq=False)
class Run:
    """Samples (n rows, time-ordered) and all that is said about them.

    The arrays cannot be written to. `reading` is in `dut.unit`, body axes; `reference_vector` [nT] in C
    (in B where the segment says so); `reference_magnitude` [nT]; `angle_deg` the platform angle.
    """

    run_id: str
    started_utc: str
    simulated: bool
    operator: str
    dut: Dut
    reference: Reference
    segments: tuple[Segment, ...]
    t_s: Array  # (n,)
    segment_index: NDArray[np.intp]  # (n,) into `segments`
    reading: Array  # (n, 3)
    reference_vector: Array | None = None  # (n, 3)
    reference_magnitude: Array | None = None  # (n,)
    angle_deg: Array | None = None  # (n,)
    row_mode: NDArray[np.str_] | None = None  # (n,) where rows state it, "" where not
    environment: Mapping[str, float] | None = None  # as run.json has it: temperature_C, gradient_nT_per_m …
    channels: tuple[Channel, ...] = ()
    specification: Specification | None = None  # of the DUT, chosen before the run began
    closures: tuple[Closure, ...] = ()  # in `reference.u_offset_nT` whole, as they were recorded
    administrative: Administrative | None = None

    def __post_init__(self) -> None:
        for value in (getattr(self, f.name) for f in fields(self)):
            if isinstance(value, np.ndarray):
                value.setflags(write=False)
        for channel in self.channels:
            channel.values.setflags(write=False)

    def __len__(self) -> int:
        return len(self.t_s)

    @property
    def reading_nT(self) -> Array:
        """Readings (n, 3) times the nominal nT per unit."""
        return self.reading * self.dut.nominal_nT_per_unit

    @property
    def mode(self) -> NDArray[np.str_]:
        """Power mode of each row (n,): the row's own, else its segment's, else ""."""
        of_segment = np.array([s.mode or "" for s in self.segments], dtype=np.str_)[self.segment_index]
        if self.row_mode is None:
            return of_segment
        return np.where(self.row_mode != "", self.row_mode, of_segment)

    @property
    def magnitude_nT(self) -> Array:
        """|reference| (n,): derived where the reference is a vector. Raises ValueError where there is none."""
        if self.reference_vector is not None:
            return np.asarray(np.linalg.norm(self.reference_vector, axis=1))
        if self.reference_magnitude is not None:
            return self.reference_magnitude
        raise ValueError(f"run {self.run_id} has no reference")

    def channel(self, name: str) -> Channel:
        """Return the channel called `name`. Raises KeyError with the names there are."""
        for channel in self.channels:
            if channel.name == name:
                return channel
        raise KeyError(f"no channel {name!r} in run {self.run_id}; it has {[c.name for c in self.channels]}")

    def with_channels(self, names: Collection[str]) -> Run:
        """The same run with only the channels of these names. Raises KeyError as `channel` does."""
        return replace(self, channels=tuple(self.channel(name) for name in names))

    def rows(self, segment: int) -> NDArray[np.intp]:
        """Row numbers of one segment, by its place in `segments`."""
        return np.flatnonzero(self.segment_index == segment)

    def select(self, rows: NDArray[Any]) -> Run:
        """The same run with only these rows (mask or numbers, in time order); all segments stay."""
        cut: dict[str, Any] = {
            name: value[rows]
            for name in (
                "t_s",
                "segment_index",
                "reading",
                "reference_vector",
                "reference_magnitude",
                "angle_deg",
                "row_mode",
            )
            if (value := getattr(self, name)) is not None
        }
        channels = tuple(replace(c, values=c.values[rows]) for c in self.channels)
        return replace(self, **cut, channels=channels)

    def header(self) -> Mapping[str, Any]:
        """Everything but the samples, for people: `labcal show` and reports."""
        return {
            "run_id": self.run_id,
            "started_utc": self.started_utc,
            "simulated": self.simulated,
            "operator": self.operator,
            "dut": self.dut,
            "reference": self.reference,
            "segments": self.segments,
            "channels": [(c.name, c.unit, c.quantity, c.role) for c in self.channels],
        }
