"""bench.toml: what stands in the lab, on which lines, and within which limits. Read and validated here."""

from __future__ import annotations

import re
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Annotated, Any, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, model_validator

from labcal.bench import serials
from labcal.bench.check_standard import CheckStandardConfig
from labcal.bench.essentials import AXES as AXES
from labcal.bench.essentials import OWNED
from labcal.errors import InputError
from labcal.files.toml_file import read_toml
from labcal.record.administrative import Address, Equipment, Item, Laboratory
from labcal.record.physical import LARGEST_CURRENT_A, LARGEST_FIELD_nT

SERVED_AT = ("emulated://", "//127.0.0.1:", "//localhost:", "//localhost.:", "///dev/pts/", "///dev/ttys")
RUNTIME_LONGEST = 60  # of the 107 bytes that the name of a socket may have
Positive = Annotated[float, Field(gt=0, allow_inf_nan=False, strict=True)]
Finite = Annotated[float, Field(allow_inf_nan=False, strict=True)]
Field_nT = Annotated[float, Field(gt=0, le=LARGEST_FIELD_nT, allow_inf_nan=False, strict=True)]
Current_A = Annotated[float, Field(gt=0, le=LARGEST_CURRENT_A, allow_inf_nan=False, strict=True)]
PerAmpere = Annotated[float, Field(ge=-LARGEST_FIELD_nT, le=LARGEST_FIELD_nT, allow_inf_nan=False, strict=True)]
Vector = tuple[Finite, Finite, Finite]
Matrix = tuple[Vector, Vector, Vector]
RoleName = Literal["coil-x", "coil-y", "coil-z", "polarity", "interlock", "platform", "reference", "dut"]


def _each_axis(value: Any) -> Any:
    if isinstance(value, (int, float)):
        return (value,) * 3
    if not isinstance(value, (list, tuple)) or len(value) != 3:
        raise ValueError("must be one number, or three, one for each axis")
    return value


def _for_people(value: str) -> str:
    if not value.isprintable():
        raise ValueError("has characters that cannot be printed")
    return value


def _day(value: Any) -> str:
    try:
        return date.fromisoformat(str(value)).isoformat()
    except ValueError:
        raise ValueError("must be a date such as 2026-03-02") from None


def _days_as_text(value: Any) -> Any:
    """TOML has dates of its own: a record has their ISO 8601 text."""
    if isinstance(value, dict):
        return {name: _days_as_text(one) for name, one in value.items()}
    return value.isoformat() if type(value) is date else value


def _group_name(value: str) -> str:
    if not re.fullmatch(r"\w[\w.@-]{0,31}", value):
        raise ValueError("must be the name of a group of this computer's users")
    return value


def _folder_name(value: str) -> str:
    if not re.fullmatch(r"(/[\w@-][\w.@-]*)+", value) or len(value) > RUNTIME_LONGEST:
        raise ValueError(
            f"must be the whole path of a folder, of at most {RUNTIME_LONGEST} letters, digits, '/', '-', '_', '.', '@'"
        )
    return value


def _of_length_one(value: Vector) -> Vector:
    if abs(float(np.linalg.norm(value)) - 1) > 1e-6:
        raise ValueError("must be a unit vector")
    return value


PerAxis = Annotated[tuple[Positive, Positive, Positive], BeforeValidator(_each_axis)]  # one number, or one an axis
Currents = Annotated[tuple[Current_A, Current_A, Current_A], BeforeValidator(_each_axis)]
Constants = Annotated[tuple[Field_nT, Field_nT, Field_nT], BeforeValidator(_each_axis)]
Three_nT = tuple[PerAmpere, PerAmpere, PerAmpere]
Text = Annotated[str, AfterValidator(_for_people)]
Day = Annotated[str, BeforeValidator(_day)]
Unit = Annotated[Vector, AfterValidator(_of_length_one)]


def _is_served(link: str) -> bool:
    """Whether emulated instruments may stand there: nowhere, or at a port of this computer."""
    return any(place in link.lower() for place in SERVED_AT)


class _Table(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, strict=False)


class CageLimits(_Table):
    """What the coils may do. A set-point beyond a limit is refused."""

    current_A: Currents
    ramp_A_per_s: PerAxis
    field_nT: Field_nT  # of the field at the centre
    rms_current_A: Currents | None = None  # root mean square over `rms_window_s`: what the wire bears for ever
    rms_window_s: Positive = 600.0
    temperature_C: Finite | None = None  # of the windings, where a channel tells it


class GeometryConfig(_Table):
    """How the pairs are wound: side or diameter, distance of the halves over it; `halves` that a person can reverse."""

    shape: Literal["square", "round"] = "square"
    size_m: PerAxis
    spacing: PerAxis = (0.5445, 0.5445, 0.5445)
    u_size_m: Positive = 0.005
    u_halves: Positive = 0.002  # of the difference of what the two halves of a pair make, relative
    halves: tuple[Literal["x", "y", "z"], ...] = ()


class CageConfig(_Table):
    """The coils: the measured current-to-field matrix, here or in a file of its own, or constants; and their limits."""

    constants_nT_per_A: Constants | None = None
    matrix_nT_per_A: tuple[Three_nT, Three_nT, Three_nT] | None = None  # columns are the coil axes in C
    calibration: str | None = None  # a cage calibration file, from the folder of bench.toml
    limits: CageLimits
    geometry: GeometryConfig | None = None
    settle_s: Annotated[float, Field(ge=0, le=60, strict=True)] = 0.2  # after a ramp, before the field is believed

    @model_validator(mode="after")
    def _one_of_two(self) -> Self:
        stated = (self.constants_nT_per_A, self.matrix_nT_per_A, self.calibration)
        if sum(way is not None for way in stated) != 1:
            raise ValueError("state one of constants_nT_per_A, matrix_nT_per_A and calibration")
        if self.calibration is None and np.linalg.cond(self.matrix) > 100:
            raise ValueError("matrix_nT_per_A is singular: its columns are the three coil axes")
        return self

    @property
    def matrix(self) -> NDArray[np.float64]:
        """Current-to-field matrix (3, 3) [nT/A]; columns are the coil axes in C."""
        if self.matrix_nT_per_A is not None:
            return np.array(self.matrix_nT_per_A)
        if self.constants_nT_per_A is None:
            raise ValueError(f"the matrix stands in {self.calibration}: see labcal.bench.coils.cage_file.calibrated")
        return np.diag(np.array(self.constants_nT_per_A))


class PlatformConfig(_Table):
    """The rotation platform: its axis in C and the sense of its own scale."""

    axis_cage: Unit = (0.0, 0.0, 1.0)
    angle_sign: Literal[1, -1] = 1
    wrap_deg: Positive = 400.0  # |angle| that the cables bear
    poll_s: Positive = 0.1
    angle_noise_deg: Positive | None = None
    u_axis_cage_deg: Positive | None = None


class CertificateConfig(_Table):
    """The certificate of the reference's own calibration."""

    number: Text | None = None
    issuer: Text | None = None
    date: Day | None = None
    due: Day | None = None  # after it no procedure begins
    U: Text | None = None  # as it states it, with k
    temperature_C: Finite | None = None  # at which it holds


class EnvironmentConfig(_Table):
    """The room, the field outside, and its gradients where device and reference stand."""

    temperature_C: Finite | None = None
    pressure_hPa: Positive | None = None
    humidity_percent: Annotated[float, Field(ge=0, le=100, strict=True)] | None = None
    ambient_nT: Field_nT | None = None  # magnitude with the coils at zero
    ambient_variation_nT: Field_nT | None = None  # of it while it was measured, peak to peak
    Kp: Annotated[float, Field(ge=0, le=9, strict=True)] | None = None  # planetary index of those hours
    gradient_nT_per_m: Positive | None = None  # with the coils at zero, of any component along any direction
    gradient_ppm_per_m: Positive | None = None  # of what the coils make


class SiteConfig(_Table):
    """Where on Earth the bench stands: what field is expected there."""

    latitude_deg: Annotated[float, Field(ge=-90, le=90, strict=True)]
    longitude_deg: Annotated[float, Field(ge=-180, le=360, strict=True)]
    height_m: Annotated[float, Field(ge=-1000, le=10_000, strict=True)] = 0.0  # above the sea


class ReferenceConfig(_Table):
    """The reference sensor as far as it is stated. `cage_from_sensor` turns its axes into C."""

    kind: Literal["vector", "scalar"] = "vector"
    cage_from_sensor: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    offset_nT: Three_nT = (0.0, 0.0, 0.0)  # in the sensor's axes, subtracted first
    noise_nT: Field_nT | None = None
    place: Literal["dut", "remote", "computed"] | None = None
    position_m: Vector | None = None
    u_scale_ppm: Positive | None = None
    u_offset_nT: Field_nT | None = None
    u_align_deg: Positive | None = None
    u_time_s: Positive | None = None
    calibration: str | None = None
    tc_ppm_per_K: Finite | None = None  # what is known of it and not corrected; each with its own uncertainty
    u_tc_ppm_per_K: Positive | None = None
    tc_nT_per_K: Finite | None = None
    u_tc_nT_per_K: Positive | None = None
    drift_nT_per_year: Finite | None = None
    u_drift_nT_per_year: Positive | None = None
    certificate: CertificateConfig | None = None
    silent_s: Positive = 3.0  # without a sample so long, it is silent
    stuck_s: Positive = 60.0  # with the same reading so long, it is stuck


class DutLimits(_Table):
    """What the device under test may be put through; binds every procedure."""

    field_nT: Field_nT | None = None
    rate_deg_per_s: Positive | None = None
    temperature_C: tuple[Finite, Finite] | None = None
    modes: tuple[str, ...] = ()

    @model_validator(mode="after")
    def _in_order(self) -> Self:
        if self.temperature_C is not None and self.temperature_C[0] >= self.temperature_C[1]:
            raise ValueError("temperature_C must be [lowest, highest]")
        return self

    def refuse_mode(self, mode: str) -> None:
        """Raise InputError where the DUT may not be in this power mode; no modes stated: it may be in any."""
        if self.modes and mode not in self.modes:
            raise InputError(f"power mode {mode!r} is none of the DUT's: {', '.join(self.modes)}")


class DutConfig(_Table):
    """The device under test."""

    serial: Text = Field(min_length=1)
    serial_pattern: Annotated[Text, AfterValidator(serials.usable_pattern)] = serials.USUAL  # of a whole serial
    serial_at_mounting: bool = False  # after each mounting its serial is asked for, and no other is taken
    model: Text = ""
    item: Annotated[Item, BeforeValidator(_days_as_text)] | None = None  # as it came in
    unit: Literal["nT", "count"] = "nT"
    nominal_nT_per_unit: Field_nT = 1.0
    noise_nT: Field_nT | None = None  # of one axis of one sample
    silent_s: Positive = 30.0
    stuck_s: Positive = 120.0
    limits: DutLimits = DutLimits()
    specification: dict[str, Any] | str | None = None  # a table, or a file: labcal.bench.specification

    def refuse_serial(self, serial: str) -> None:
        """Raise InputError where `serial` does not match the pattern of this bench's serials."""
        if said := serials.objection(serial, self.serial_pattern):
            raise InputError(said)


class SafetyConfig(_Table):
    """Who, beside the user whose session drives the coils, may bring them to zero."""

    group: Annotated[str, AfterValidator(_group_name)] | None = None  # of the computer's users
    runtime: Annotated[str, AfterValidator(_folder_name)] | None = None  # of its locks and sockets; /run/labcal-GROUP

    @model_validator(mode="after")
    def _of_a_group(self) -> Self:
        if self.runtime is not None and self.group is None:
            raise ValueError("runtime is the folder of a group: state group too")
        return self


class InstrumentConfig(_Table):
    """One instrument: which driver speaks to it, over which link, and what it is for."""

    driver: str
    link: str = Field(pattern=r"^[a-z-]+://")
    role: RoleName
    settings: dict[str, Any] = {}  # the driver's own; checked by the driver's Settings


class BenchConfig(_Table):
    """A whole bench.toml. `twin` is for the simulated lab alone and is never dumped into a record."""

    name: Text = Field(min_length=1)
    datum: Text = "z along the platform axis, x along the mark on its base"
    cage: CageConfig
    platform: PlatformConfig = PlatformConfig()
    reference: ReferenceConfig = ReferenceConfig()
    dut: DutConfig
    safety: SafetyConfig = SafetyConfig()
    check_standard: CheckStandardConfig | None = None
    environment: EnvironmentConfig = EnvironmentConfig()
    site: SiteConfig | None = None
    laboratory: Laboratory | None = None
    customer: Address | None = None
    equipment: tuple[Annotated[Equipment, BeforeValidator(_days_as_text)], ...] = ()
    camera: Annotated[Text, BeforeValidator(str)] | None = None  # at the cage: its number here, or an address
    served: bool = False  # its instruments are emulated ones on ports of this computer: `labcal bench serve` writes it
    instruments: dict[str, InstrumentConfig]
    twin: dict[str, Any] = Field(default={}, exclude=True, repr=False)

    @model_validator(mode="after")
    def _roles_filled_once(self) -> Self:
        roles = [i.role for i in self.instruments.values()]
        twice = sorted({r for r in roles if roles.count(r) > 1})
        missing = [f"coil-{axis}" for axis in AXES if f"coil-{axis}" not in roles] + [
            role for role in ("platform", "reference", "dut") if role not in roles
        ]
        if twice:
            names = ", ".join(name for name, one in self.instruments.items() if one.role in twice)
            raise ValueError(f"two instruments have the role {', '.join(twice)}: {names}")
        if missing:
            raise ValueError(f"no instrument has the role {', '.join(missing)}")
        if self.twin and not self.simulated:
            raise ValueError("the table [twin] is for benches whose links are all emulated://")
        elsewhere = [i.link for i in self.instruments.values() if not _is_served(i.link)]
        if self.served and elsewhere:
            raise ValueError(f"served: {elsewhere[0]} is no port of this computer that emulated instruments stand at")
        return self

    @property
    def guarded(self) -> list[str]:
        """The instruments that can hurt, or keep from it, by name: supplies, polarity relays and the interlock."""
        return [name for name, entry in self.instruments.items() if entry.role.startswith(OWNED)]

    @property
    def guarded_links(self) -> list[str]:
        """The real links of these."""
        links = [self.instruments[name].link for name in self.guarded]
        return [link for link in links if not link.startswith("emulated://")]

    @property
    def simulated(self) -> bool:
        """Whether every link is emulated."""
        return all(i.link.startswith("emulated://") for i in self.instruments.values())

    @property
    def unreal(self) -> bool:
        """Whether no instrument is a real one: what is measured here is SIMULATED, though served lines be real."""
        return self.simulated or self.served


def read_config(path: Path) -> BenchConfig:
    """Read and validate a bench.toml. Raises InputError with the file, the line and the key."""
    text, table = read_toml(path)
    if table and not table.keys() & BenchConfig.model_fields.keys():
        raise InputError("is no bench file: nothing that stands in it is of a bench", file=path)
    try:
        return BenchConfig.model_validate(table)
    except ValidationError as error:
        faults = error.errors()
        # a misspelt key also leaves a key missing: name the misspelt one
        first = next((f for f in faults if f["type"] == "extra_forbidden"), faults[0])
        keys = tuple(str(part) for part in first["loc"])
        name, said = ".".join(keys), sentence(first)
        between = "" if not name else " " if said.startswith(("is ", "has ", "must ")) else ": "
        raise InputError(f"{name}{between}{said}", file=path, line=line_of(text, keys)) from error


WORDS = {
    "extra_forbidden": "is not a key that is known here",
    "unexpected_keyword_argument": "is not a key that is known here",
    "missing": "is missing",
    "dict_type": "must be a table",
    "model_type": "must be a table",
    "tuple_type": "must be a list",
    "string_pattern_mismatch": "must begin with serial://, tcp://, modbus-rtu://, emulated:// or the like",
    "string_too_short": "must not be empty",
}


def sentence(fault: Mapping[str, Any]) -> str:
    """What pydantic found wrong, as words that follow the name of the key."""
    said = str(fault["msg"]).removeprefix("Value error, ").replace("Input should be", "must be")
    return WORDS.get(str(fault["type"]), said)


def line_of(text: str, keys: tuple[str, ...]) -> int | None:
    """The line (from 1) of a TOML text that comes nearest to stating `keys`; None where nothing of it is there."""
    best, where, table = 0, None, tuple[str, ...]()
    for number, line in enumerate(text.splitlines(), 1):
        head = line.split("#")[0].strip()
        if head.startswith("["):
            table = _path(head.strip("[]"))
            stated = table
        elif "=" in head:
            stated = table + _path(head.split("=")[0])
        else:
            continue
        if len(stated) > best and keys[: len(stated)] == stated:
            best, where = len(stated), number
    return where


def _path(dotted: str) -> tuple[str, ...]:
    return tuple(part.strip(" \"'") for part in dotted.split("."))
