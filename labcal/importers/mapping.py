"""What a person says about a recording: which columns are what, in which unit, frame and clock. TOML, strict."""

from __future__ import annotations

from collections.abc import Iterator
from datetime import date, datetime
from pathlib import Path
from typing import Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, StrictBool, ValidationError, model_validator

from labcal.errors import InputError
from labcal.files.text_safety import checked_text
from labcal.files.toml_file import read_toml
from labcal.importers.recording import CsvForm
from labcal.importers.toml_line import line_of
from labcal.importers.units import CHANNEL_OF, QUANTITY_OF, AngleUnit, FieldUnit, TimeUnit
from labcal.record import Segment
from labcal.record.physical import LARGEST_FIELD_nT
from labcal.record.run import Quantity, Role, SegmentKind
from labcal.record.run_id import checked_run_id
from labcal.store.limits import MOST_SEGMENTS, shortened

FORMAT = "labcal-mapping/1"
Axis = Literal["x", "y", "z", "-x", "-y", "-z"]
Doubt = Literal["units", "axes", "attitude", "clocks", "constant", "time"]


def _utc(text: str) -> str:
    try:
        datetime.fromisoformat(text)
    except ValueError:
        raise ValueError("expected a date and time in ISO 8601, such as 2026-03-02T08:15:00Z") from None
    return text


def _signed_axes(axes: tuple[Axis, Axis, Axis]) -> tuple[Axis, Axis, Axis]:
    if len({axis[-1] for axis in axes}) != 3:
        raise ValueError("each of x, y and z must be there once, with or without a minus")
    return axes


Text = Annotated[str, Field(max_length=200), AfterValidator(checked_text)]
Name = Annotated[str, Field(min_length=1, max_length=200), AfterValidator(checked_text)]
Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Spread = Annotated[float, Field(strict=True, ge=0, allow_inf_nan=False)]
Field_nT = Annotated[float, Field(strict=True, ge=-LARGEST_FIELD_nT, le=LARGEST_FIELD_nT)]
Vector = tuple[Number, Number, Number]
Three = tuple[Name, Name, Name]
Axes = Annotated[tuple[Axis, Axis, Axis], AfterValidator(_signed_axes)]
Utc = Annotated[str, AfterValidator(_utc)]


class _Part(BaseModel):
    """A table of the mapping; a key that nobody knows is refused."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)


class TimePart(_Part):
    """The clock of every group that states none of its own, or the rate of rows without one; and what to do with
    stamps that do not grow.
    """

    column: Name | None = None
    unit: TimeUnit | None = None
    rate_Hz: Annotated[float, Field(strict=True, ge=1e-4, le=1e5)] | None = None
    duplicates: Literal["refuse", "drop"] = "refuse"
    backward: Literal["refuse", "drop"] = "refuse"

    @model_validator(mode="after")
    def _one_clock(self) -> Self:
        if (self.column is None) == (self.rate_Hz is None):
            raise ValueError("needs a column, or rate_Hz where the rows have no stamps, and not both")
        if (self.unit is None) != (self.column is None):
            raise ValueError("a column of stamps needs a unit, and nothing else does")
        return self


class ColumnSource(_Part):
    """Where a group's columns are, and its clock: run time = (stamp · unit) · (1 + rate) + offset."""

    file: Text | None = None
    format: Literal["csv", "ulog", "dataflash", "rosbag", "mat", "iaga", "imagcdf"] | None = None
    stream: Text = ""
    time: Name | None = None
    time_unit: TimeUnit | None = None
    clock_offset_s: Number = 0.0
    clock_rate_ppm: Number = 0.0


class ReadingPart(ColumnSource):
    """The DUT's three columns. `axes` says where the body's x, y and z come from: ["y", "x", "-z"] turns them.

    `every`: of a recording that is faster than anything in it, one row of so many is taken, as it is.
    """

    columns: Three
    unit: FieldUnit
    axes: Axes = ("x", "y", "z")
    every: Annotated[int, Field(strict=True, ge=1, le=10_000)] = 1


NEEDED = {  # by a reference of each kind
    "vector": ("columns", "unit", "frame"), "scalar": ("column", "unit"), "site": ("value_nT",),
    "igrf": ("latitude_deg", "longitude_deg"), "wmm": ("latitude_deg", "longitude_deg"), "none": (),
}  # fmt: skip


class ReferencePart(ColumnSource):
    """The reference: columns of a sensor, a known site's value, or IGRF or WMM at a place and date."""

    kind: Literal["vector", "scalar", "site", "igrf", "wmm", "none"]
    columns: Three | None = None
    column: Name | None = None
    unit: FieldUnit | None = None
    axes: Axes = ("x", "y", "z")
    frame: Literal["cage", "body"] | None = None
    value_nT: Field_nT | tuple[Field_nT, Field_nT, Field_nT] | None = None
    latitude_deg: Annotated[float, Field(strict=True, ge=-90, le=90)] | None = None
    longitude_deg: Annotated[float, Field(strict=True, ge=-180, le=360)] | None = None
    height_m: Annotated[float, Field(strict=True, ge=-10_000, le=1_000_000)] = 0.0
    date: Utc | date | None = None
    cage: Literal["ned", "enu"] = "ned"
    serial: Text = ""
    noise_nT: Spread | None = None
    place: Literal["dut", "remote", "computed"] | None = None
    u_scale_ppm: Spread | None = None
    u_offset_nT: Spread | None = None
    u_align_deg: Spread | None = None
    u_time_s: Spread | None = None

    @model_validator(mode="after")
    def _whole(self) -> Self:
        needs = NEEDED[self.kind]
        for name in needs:
            if getattr(self, name) is None:
                raise ValueError(f"a reference of kind {self.kind!r} needs {name}")
        for name in {"columns", "column", "value_nT", "latitude_deg", "frame"} - {*needs, "frame"}:
            if getattr(self, name) is not None:
                raise ValueError(f"a reference of kind {self.kind!r} has no {name}")
        if self.unit == "count":
            raise ValueError("a reference has a unit of field, no counts")
        return self


class AttitudePart(ColumnSource):
    """A quaternion a row. `maps` says what q v q* does: it takes components in one frame to those in the other."""

    columns: tuple[Name, Name, Name, Name]
    order: Literal["wxyz", "xyzw"]
    maps: Literal["cage-to-body", "body-to-cage"]
    body_axes: Axes = ("x", "y", "z")


class AnglePart(ColumnSource):
    """The platform's angle; `sign` turns its own sense into the right-handed one about `axis_body`."""

    column: Name
    unit: AngleUnit
    sign: Literal[1, -1] = 1


class ChannelPart(ColumnSource):
    """A housekeeping column."""

    column: Name
    unit: Text
    quantity: Quantity | None = None
    role: Role = "dut"

    @property
    def converted(self) -> tuple[str, float, float]:
        """The unit in the run, and value times factor plus offset."""
        return CHANNEL_OF.get(self.unit, (self.unit, 1.0, 0.0))

    @property
    def of_quantity(self) -> Any:
        """The quantity that is stated, else the unit's own."""
        return self.quantity or QUANTITY_OF.get(self.converted[0], "other")


class SegmentPart(_Part):
    """A stretch: a file of its own, or a span of the run's clock [s]; the other keys are those of run.json."""

    id: Name
    file: Text | None = None
    start_s: Number | None = None
    end_s: Number | None = None
    kind: SegmentKind = "free"
    mode: Text | None = None
    note: Text = ""
    axis_body: Vector | None = None
    axis_cage: Vector | None = None
    body_from_cage: tuple[Vector, Vector, Vector] | None = None
    mounting: Text | None = None
    angle_noise_deg: Spread | None = None
    u_axis_body_deg: Spread | None = None
    u_axis_cage_deg: Spread | None = None
    u_time_s: Spread | None = None

    @model_validator(mode="after")
    def _ends_after_it_begins(self) -> Self:
        if self.start_s is not None and self.end_s is not None and self.end_s <= self.start_s:
            raise ValueError(f"the segment ends at {self.end_s:g} s, and begins at {self.start_s:g} s")
        return self

    def segment(self) -> Segment:
        """As the record knows it."""
        return Segment(**{k: v for k, v in self if k not in ("file", "start_s", "end_s")})


class DutPart(_Part):
    """The device under test."""

    serial: Name
    model: Text = ""
    nominal_nT_per_count: Annotated[float, Field(strict=True, gt=0, le=LARGEST_FIELD_nT)] | None = None
    noise_nT: Spread | None = None


class CsvPart(_Part):
    """How a table of text is written, where looking at it does not tell."""

    delimiter: Literal[",", ";", "\t", " ", "|"] | None = None
    decimal: Literal[".", ","] = "."
    header: StrictBool | None = None
    skip_lines: Annotated[int, Field(strict=True, ge=0, le=100_000)] = 0
    comment: Annotated[str, Field(max_length=8)] = "#"
    missing: Annotated[tuple[Text, ...], Field(max_length=20)] = ()

    def form(self) -> CsvForm:
        """As the reader knows it."""
        return CsvForm(**dict(self))


class Mapping(_Part):
    """The whole of a mapping file."""

    format: Literal["labcal-mapping/1"]
    run_id: Annotated[str, AfterValidator(checked_run_id)] | None = None
    started_utc: Utc | None = None
    operator: Text = ""
    accept: tuple[Doubt, ...] = ()
    segment_column: Name | None = None
    mode_column: Name | None = None
    dut: DutPart
    time: TimePart
    reading: ReadingPart
    reference: ReferencePart
    attitude: AttitudePart | None = None
    angle: AnglePart | None = None
    channels: dict[Name, ChannelPart] = {}
    segments: Annotated[tuple[SegmentPart, ...], Field(max_length=MOST_SEGMENTS)] = ()
    csv: CsvPart = CsvPart()

    @model_validator(mode="after")
    def _agree(self) -> Self:
        if self.segments and self.segment_column:
            raise ValueError("state segments or segment_column, not both")
        if len({segment.id for segment in self.segments}) < len(self.segments):
            raise ValueError("two segments have the same id")
        files = [segment.file is not None for segment in self.segments]
        if any(files) and not all(files):
            raise ValueError("either each segment names a file, or none does")
        if (self.reading.unit == "count") != (self.dut.nominal_nT_per_count is not None):
            raise ValueError("dut.nominal_nT_per_count belongs to readings in unit 'count', and they need it")
        if self.attitude is not None and self.reference.kind == "vector" and self.reference.frame == "body":
            raise ValueError("an attitude turns a reference of the cage's frame; this one is the body's already")
        return self

    def groups(self) -> Iterator[ColumnSource]:
        """Every table that names columns of a recording."""
        known = (self.reading, self.reference, self.attitude, self.angle, *self.channels.values())
        yield from (group for group in known if group is not None)


def read_mapping(path: Path) -> Mapping:
    """Read and check a mapping file. Raises InputError with the line, the key and what was expected."""
    text, stated = read_toml(path)
    try:
        return Mapping.model_validate(stated)
    except ValidationError as error:
        raise _input_error(error, text, path) from None


def _input_error(error: ValidationError, text: str, path: Path) -> InputError:
    found = error.errors(include_url=False)
    first = next((one for one in found if one["type"] == "extra_forbidden"), found[0])  # more often than not misspelt
    place = [part for part in first["loc"] if not str(part).startswith(("function-", "union", "constrained"))]
    what = first["msg"].removeprefix("Value error, ").replace("Input should be", "expected")
    if first["type"] == "extra_forbidden":
        what = "there is no such key in a mapping"
    elif first["type"] == "missing":
        what = "the key is missing"
    elif first["type"] != "value_error":
        what += f", found {str(first['input'])[:40]!r}"
    key = shortened(".".join(map(str, place)), 120) or None
    return InputError(what, file=path, line=line_of(text, place), column=None if key is None else f"key {key}")
