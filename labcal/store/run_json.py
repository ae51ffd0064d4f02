"""run.json, the header of a run bundle: what it may say, and where it is wrong."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict
from difflib import get_close_matches
from functools import lru_cache
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import AfterValidator, BaseModel, ConfigDict, Field, ValidationError, model_validator

from labcal.errors import InputError
from labcal.files.text_safety import replace_control
from labcal.record import Administrative, Dut, Reference, Run, Segment, Specification
from labcal.record.administrative import without_nothing
from labcal.record.closure import Closure, Standstill
from labcal.record.physical import LARGEST_FIELD_nT
from labcal.record.run import Quantity, Role, SegmentKind
from labcal.record.run_id import checked_run_id
from labcal.record.vector import Vector
from labcal.store.field_types import Axis, Celsius, Day, Mode, Name, Nanotesla, Rotation, Spread, Text, Utc, null_is
from labcal.store.json_text import check_json, line_of, refuse, refuse_too_many
from labcal.store.limits import MOST_KEYS
from labcal.store.table import decode

FORMAT = "labcal-run/1"
FIXED_COLUMNS = (
    *("t_s", "segment", "dut_x", "dut_y", "dut_z", "ref_x", "ref_y", "ref_z", "ref_f"),
    *("angle_deg", "mode"),
)
UNITS: Mapping[str, tuple[str, ...]] = {
    "temperature": ("degC", "K", "degF"),
    "current": ("A", "mA", "uA", "µA", "nA", "kA"),
    "voltage": ("V", "mV", "uV", "µV", "kV"),
    "power": ("W", "mW", "uW", "µW", "kW"),
    "rate": ("deg/s", "rad/s", "rpm", "Hz", "kHz", "1/s", "1/min", "count/s", "nT/s", "bit/s", "kbit/s", "degC/s"),
    "pressure": ("Pa", "hPa", "kPa", "MPa", "mbar", "bar", "Torr"),
    "humidity": ("%", "%RH", "1"),
    "count": ("count", "1", ""),
}
SPELT = {  # other ways to write them, which no other quantity uses
    "temperature": {"°C": "degC", "℃": "degC", "C": "degC", "celsius": "degC", "°F": "degF", "kelvin": "K"},
    "current": {"ampere": "A", "amps": "A", "μA": "µA"},  # a Greek mu
    "voltage": {"volt": "V", "volts": "V", "μV": "µV"},
    "power": {"watt": "W", "watts": "W", "μW": "µW"},
    "rate": {"°/s": "deg/s", "dps": "deg/s", "RPM": "rpm", "rev/min": "rpm", "s^-1": "1/s"},
    "humidity": {"percent": "%", "%rH": "%RH", "percentRH": "%RH"},
    "count": {"counts": "count", "ct": "count", "cts": "count", "LSB": "count"},
}
LONGEST_KEY = 40


@lru_cache(maxsize=4 * MOST_KEYS)
def _misspelt(key: str, absent: tuple[str, ...]) -> str | None:
    """The absent key that `key` most likely means. Every segment has the same ones."""
    if len(key) > LONGEST_KEY:
        return None
    return next(iter(get_close_matches(key, absent, n=1, cutoff=0.8)), None)


class _Part(BaseModel):
    """A JSON object: more keys than known are let be, a known key misspelt is refused."""

    model_config = ConfigDict(strict=True, frozen=True, allow_inf_nan=False, extra="allow")

    @model_validator(mode="after")
    def _spelling(self) -> Self:
        absent = sorted(type(self).model_fields.keys() - self.model_fields_set)
        for key in self.model_extra or ():
            if meant := _misspelt(key, tuple(absent)):
                raise ValueError(f"unknown key {key!r}; is {meant!r} meant?")
        return self

    def known(self) -> dict[str, Any]:
        """The keys of the format, by name."""
        return {name: getattr(self, name) for name in type(self).model_fields}


class DutPart(_Part):
    """The device under test."""

    serial: Text
    model: Annotated[Text, null_is("")] = ""
    unit: Literal["nT", "count"]
    nominal_nT_per_unit: float = Field(gt=0, le=LARGEST_FIELD_nT)
    noise_nT: Nanotesla | None = None


class CertificatePart(_Part):
    """The certificate of the reference's own calibration."""

    number: Text | None = None
    issuer: Text | None = None
    date: Day | None = None
    due: Day | None = None
    U: Text | None = None  # as it states it, with k
    temperature_C: Celsius | None = None  # at which it holds


class EnvironmentPart(_Part):
    """The room, the field outside, and its gradients where device and reference stand."""

    temperature_C: Celsius | None = None
    pressure_hPa: Spread | None = None
    humidity_percent: Annotated[float, Field(ge=0, le=100)] | None = None
    ambient_nT: Nanotesla | None = None  # magnitude with the coils at zero
    ambient_variation_nT: Nanotesla | None = None  # of it while it was measured, peak to peak
    Kp: Annotated[float, Field(ge=0, le=9)] | None = None  # planetary index of those hours
    gradient_nT_per_m: Nanotesla | None = None  # with the coils at zero, of any component along any direction
    gradient_ppm_per_m: Spread | None = None  # of what the coils make


class ReferencePart(_Part):
    """The reference sensor and what is stated about it."""

    kind: Literal["vector", "scalar", "none"]
    serial: Annotated[Text, null_is("")] = ""
    noise_nT: Nanotesla | None = None
    place: Literal["dut", "remote", "computed"] | None = None
    position_m: Vector | None = None
    u_scale_ppm: Spread | None = None
    u_offset_nT: Nanotesla | None = None
    u_align_deg: Spread | None = None
    u_time_s: Spread | None = None
    calibration: Text | None = None
    tc_ppm_per_K: float | None = None
    u_tc_ppm_per_K: Spread | None = None
    tc_nT_per_K: float | None = None
    u_tc_nT_per_K: Spread | None = None
    drift_nT_per_year: float | None = None
    u_drift_nT_per_year: Spread | None = None
    certificate: CertificatePart | None = None

    def known(self) -> dict[str, Any]:
        """The keys of the format, by name."""
        return super().known() | {"certificate": _plain(self.certificate)}


class SegmentPart(_Part):
    """One segment; its axes are of unit length, its attitude is a rotation, and they agree."""

    id: Name
    kind: SegmentKind
    axis_body: Axis | None = None
    axis_cage: Axis | None = None
    body_from_cage: Rotation | None = None
    reference_frame: Annotated[Literal["cage", "body"], null_is("cage")] = "cage"
    mode: Mode | None = None
    note: Annotated[Text, null_is("")] = ""
    mounting: Text | None = None
    angle_noise_deg: Spread | None = None
    u_axis_body_deg: Spread | None = None
    u_axis_cage_deg: Spread | None = None
    u_time_s: Spread | None = None

    @model_validator(mode="after")
    def _agree(self) -> Self:
        if self.body_from_cage is None or self.axis_cage is None or self.axis_body is None:
            return self
        off = np.linalg.norm(np.array(self.body_from_cage) @ self.axis_cage - self.axis_body)
        if off > 1e-3:
            raise ValueError(f"body_from_cage · axis_cage must be axis_body; they differ by {off:.3g}")
        return self

    def known(self) -> dict[str, Any]:
        """The keys of the format, by name; an axis that the attitude carries from the other one is there too."""
        stated, R = super().known(), np.array(self.body_from_cage)
        if self.body_from_cage is not None and self.axis_cage is None and self.axis_body is not None:
            return stated | {"axis_cage": tuple((R.T @ self.axis_body).tolist())}
        if self.body_from_cage is not None and self.axis_body is None and self.axis_cage is not None:
            return stated | {"axis_body": tuple((R @ self.axis_cage).tolist())}
        return stated


class ChannelPart(_Part):
    """What a housekeeping column means."""

    unit: Text
    quantity: Quantity
    role: Annotated[Role, null_is("dut")] = "dut"

    @property
    def spelt_unit(self) -> str:
        """The unit as labcal writes it."""
        return SPELT.get(self.quantity, {}).get(self.unit, self.unit)

    @model_validator(mode="after")
    def _unit_exists(self) -> Self:
        known = UNITS.get(self.quantity)
        if known is not None and self.spelt_unit not in known:
            units = ", ".join(unit for unit in known if unit)
            raise ValueError(f"there is no unit {self.unit!r} of {self.quantity}; expected one of {units}")
        return self


class StandstillPart(_Part):
    """Means over some seconds at rest."""

    t_s: float
    dut_nT: Vector
    reference_nT: tuple[float] | Vector
    mode: Mode = ""
    channels: dict[Name, float] = {}

    def known(self) -> dict[str, Any]:
        """The keys of the format, by name."""
        return super().known() | {"channels": dict(self.channels)}


class ClosurePart(_Part):
    """The device in one field twice, and what that adds to the zero's uncertainty before any effect."""

    name: Name
    u_offset_nT: Nanotesla
    before: StandstillPart
    after: StandstillPart
    body_from_cage: Rotation | None = None

    @model_validator(mode="after")
    def _alike(self) -> Self:
        if len(self.before.reference_nT) != len(self.after.reference_nT):
            raise ValueError("reference_nT of before and after must be of one length")
        return self


def _some(segments: tuple[SegmentPart, ...]) -> tuple[SegmentPart, ...]:
    if not segments:
        raise ValueError("expected at least 1 segment, found none: the run recorded no samples")
    return segments


class RunJson(_Part):
    """The whole of run.json."""

    format: Literal["labcal-run/1"]
    run_id: Name
    started_utc: Utc
    simulated: bool
    operator: Annotated[Text, null_is("")] = ""
    dut: DutPart
    reference: ReferencePart
    segments: Annotated[tuple[SegmentPart, ...], AfterValidator(_some)]
    channels: dict[Name, ChannelPart] = {}
    specification: Specification | None = None
    environment: EnvironmentPart | None = None
    closures: tuple[ClosurePart, ...] = ()
    administrative: Administrative | None = None

    @model_validator(mode="after")
    def _names(self) -> Self:
        ids = [segment.id for segment in self.segments]
        before = set[str]()
        for name in ids:
            if name in before:
                raise ValueError(f"two segments have the id {name!r}")
            before.add(name)
        for name in self.channels:
            if name in FIXED_COLUMNS:
                raise ValueError(f"a channel cannot be called {name!r}: samples.csv has a column of that name")
        return self

    def stated_environment(self) -> dict[str, float] | None:
        """The environment as the record knows it."""
        return _plain(self.environment)

    def record_segments(self) -> tuple[Segment, ...]:
        """The segments as the record knows them."""
        return tuple(Segment(**segment.known()) for segment in self.segments)

    def record_closures(self) -> tuple[Closure, ...]:
        """The closures as the record knows them."""
        ends = ({e: Standstill(**getattr(c, e).known()) for e in ("before", "after")} for c in self.closures)
        return tuple(Closure(**c.known() | of) for c, of in zip(self.closures, ends, strict=True))


def _plain(part: _Part | None) -> dict[str, Any] | None:
    """What a part states, by name; None where it states nothing."""
    stated = {} if part is None else {name: value for name, value in part.known().items() if value is not None}
    return stated or None


def read_run_json(data: bytes, *, file: object, of_store: bool = False) -> RunJson:
    """Read and check run.json. Raises InputError with the line, the key and what was expected.

    What the store holds already (`of_store`) may be called as no run is any more.
    """
    text = decode(data, file=str(file))
    refuse_too_many(check_json(text, str(file)), str(file))
    try:
        found = RunJson.model_validate_json(text)
    except ValidationError as error:
        refuse(error, text, str(file))
    try:
        of_store or checked_run_id(found.run_id)
    except ValueError as error:
        raise InputError(str(error), file=file, line=line_of(text, ("run_id",)), column="run_id") from None
    return found


def write_run_json(run: Run) -> bytes:
    """The header of `run` as run.json: fixed order, only what is stated, UTF-8 with LF; it reads back.

    What an instrument or a person put in and no text may hold (`labcal.files.text_safety`) is marked: the run is never
    lost for it.
    """
    header = {
        "format": FORMAT,
        "run_id": run.run_id,
        "started_utc": run.started_utc,
        "simulated": run.simulated,
        "operator": run.operator,
        "dut": _stated(run.dut),
        "reference": _stated(run.reference),
        "segments": [_stated(segment) for segment in run.segments],
        "channels": {c.name: {"unit": c.unit, "quantity": c.quantity, "role": c.role} for c in run.channels},
    }
    if run.specification is not None:
        header["specification"] = stated_specification(run.specification)
    if run.environment is not None:
        header["environment"] = dict(run.environment)
    if run.closures:
        header["closures"] = [asdict(closure) for closure in run.closures]
    if run.administrative is not None:
        header["administrative"] = without_nothing(asdict(run.administrative))
    return (json.dumps(replace_control(header), indent=1, ensure_ascii=False, allow_nan=False) + "\n").encode()


def stated_specification(specification: Specification) -> dict[str, Any]:
    """A specification as run.json has it: the limits that are stated, the rule and its r, and a title."""
    limits = {name: asdict(limit) for name, limit in specification.limits.items()}
    title = {"title": specification.title} if specification.title else {}
    return {**title, **limits, "rule": specification.rule, "r": specification.r}


def _stated(part: Dut | Reference | Segment) -> dict[str, Any]:
    always = {"noise_nT"}
    return {key: value for key, value in asdict(part).items() if value is not None or key in always}
