"""The calibration file: RFC 8785 JSON in and out, checked with a path to the fault (contract: calibration file).

A key this version does not know is refused: a signed sentence nobody reads could change what the file says, and a
reader that skips it would still call the file valid. A new meaning is a new `format`. Opening a file runs no code.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Mapping
from datetime import date
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
import rfc8785
from numpy.typing import NDArray
from pydantic import (
    AfterValidator,
    BaseModel,
    ConfigDict,
    Field,
    SerializerFunctionWrapHandler,
    ValidationError,
    model_serializer,
    model_validator,
)

from labcal.certificate.file_fields import (
    Covariance,
    JointCovariance,
    Name,
    Names,
    Plain,
    Row,
    Sha256,
    Span,
    Table,
    Text,
    Uncertainty,
    Utc,
    checked_map,
    checked_square,
    positive,
)
from labcal.errors import InputError
from labcal.files.plain_file import read_limited
from labcal.model import AffineMap, Calibration, EffectRecord, Parameter, Validity
from labcal.model.affine import MAP_PARAMETERS
from labcal.model.records import Rival
from labcal.model.smooth import Basis, Domain
from labcal.record import Dut

LARGEST_BYTES = 4 * 2**20  # a thousand times a usual file
NEW_OF_EFFECTS = frozenset({"group", "inputs", "basis", "domain"})


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False, from_attributes=True)


class _Dut(_Part):
    serial: Name
    model: Text
    unit: Literal["nT", "count"]
    nominal_nT_per_unit: Annotated[float, Field(gt=0)]


class _Parameter(_Part):
    name: Name
    value: float
    u: Uncertainty
    unit: Text


class _Rival(_Part):
    effect: Name
    channels: Names
    holdout_rms_after_nT: Uncertainty


class _Basis(_Part):
    kind: Name
    knots: Table
    degree: Annotated[int, Field(ge=0, le=9)]
    functions: Table
    projection: Table
    prior_nT: Uncertainty
    coefficients: Table
    covariance: Annotated[Table, AfterValidator(checked_square), AfterValidator(positive)]


class _Domain(_Part):
    inputs: Annotated[Names, Field(min_length=1, max_length=2)]
    hull: Annotated[Table, Field(min_length=2)]


class _Effect(_Part):
    effect: Name
    channels: Names
    reference_value: dict[Name, float]
    belongs_to: Literal["sensor", "rig", "data"]
    provisional: bool = False
    parameters: tuple[_Parameter, ...]
    holdout_rms_before_nT: Uncertainty | None = None
    holdout_rms_after_nT: Uncertainty | None = None
    improvement_ci95_nT: Span | None = None
    p_value: Annotated[float, Field(ge=0, le=1)] | None = None
    rivals: tuple[_Rival, ...] = ()
    why: Text = ""
    group: Text = ""
    inputs: Annotated[Names, Field(max_length=2)] = ()
    basis: _Basis | None = None
    domain: tuple[_Domain, ...] = ()

    @model_serializer(mode="wrap")
    def _what_is_there(self, whole: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Without what only some effects have: readers before them know no such keys."""
        stated: dict[str, Any] = whole(self)
        return {name: value for name, value in stated.items() if name not in NEW_OF_EFFECTS or value}


class _Validity(_Part):
    field_nT: Span
    temperature_C: Span | None
    modes: Names
    until: date | None


class _Metrics(_Part):
    before: dict[Name, Uncertainty]
    after: dict[Name, Uncertainty]


def _of_the_sensor(effects: tuple[_Effect, ...]) -> tuple[_Effect, ...]:
    if strangers := [e.effect for e in effects if e.belongs_to != "sensor"]:
        raise ValueError(f"holds the sensor's effects only; {strangers[0]} belongs under findings")
    return effects


def _not_of_the_sensor(effects: tuple[_Effect, ...]) -> tuple[_Effect, ...]:
    if strangers := [e.effect for e in effects if e.belongs_to == "sensor"]:
        raise ValueError(f"holds the rig's and the data's effects; {strangers[0]} belongs under effects")
    return effects


class _BudgetRow(_Part):
    source: Name
    type: Literal["A", "B"]
    distribution: Text
    u: Uncertainty
    unit: Text
    sensitivity: float
    share: Annotated[float, Field(ge=0, le=1)]
    dof: Annotated[float, Field(gt=0)] | None


class _Budget(_Part):
    quantity: Name
    at: Text
    unit: Text
    U: Uncertainty
    k: Annotated[float, Field(gt=0)]
    dof: Annotated[float, Field(gt=0)] | None
    rows: tuple[_BudgetRow, ...]
    correlations: tuple[Plain, ...]


class _Specified(_Part):
    quantity: Name
    value: float
    U: Uncertainty
    limit: float
    unit: Text
    rule: Text
    result: Literal["pass", "conditional-pass", "conditional-fail", "fail"]
    risk: Annotated[float, Field(ge=0, le=1)] | None
    tur: Annotated[float, Field(ge=0)] | None


class _MadeBy(_Part):
    command: Text
    method: Text
    channels: Names | None
    empirical: bool
    version: Text


class _Chain(_Part):
    head: Sha256
    rows: Annotated[int, Field(ge=0)]


class _File(_Part):
    """Every field of version 1; the order is the contract's (the bytes are sorted by RFC 8785)."""

    format: Literal["labcal-calibration/1"]
    run_id: Name
    simulated: bool
    dut: _Dut
    K: Annotated[tuple[Row, Row, Row], AfterValidator(checked_map)]
    k_nT: Row
    covariance: Covariance | None
    frame_known: bool
    effects: Annotated[tuple[_Effect, ...], AfterValidator(_of_the_sensor)]
    findings: Annotated[tuple[_Effect, ...], AfterValidator(_not_of_the_sensor)]
    validity: _Validity
    span_s: Span
    metrics: _Metrics
    instruments: tuple[dict[Name, Text], ...]
    run_sha256: Sha256
    cage_sha256: Sha256 | None
    supersedes: Name | None
    software: Text
    operator: Text
    approvers: Names


class _File2(_File):
    """Every field of version 2: the covariance is joint, and says of what."""

    format: Literal["labcal-calibration/2"]  # type: ignore[assignment]
    covariance: JointCovariance | None
    covariance_of: Names
    k_at: dict[Name, float]
    budget: tuple[_Budget, ...]
    not_covered: tuple[Text, ...]
    specification: tuple[_Specified, ...]
    made_by: _MadeBy | None
    chain: _Chain | None
    number: Name | None
    issued_utc: Utc | None

    @model_validator(mode="after")
    def _named(self) -> _File2:
        """Raise ValueError unless the covariance says of what it is: the map, then parameters that are there."""
        known = [f"{i}:{p.name}" for i, effect in enumerate(self.effects) for p in effect.parameters]
        if self.covariance_of[:12] != MAP_PARAMETERS or (strangers := set(self.covariance_of[12:]) - set(known)):
            named = f"; {sorted(strangers)[0]} is not there" if self.covariance_of[:12] == MAP_PARAMETERS else ""
            raise ValueError(f"covariance_of: names K row by row, k, then parameters of the effects{named}")
        if self.covariance is not None and len(self.covariance) != len(self.covariance_of):
            raise ValueError(f"covariance: has {len(self.covariance)} rows for {len(self.covariance_of)} names")
        return self


VERSIONS: dict[str, type[_File]] = {"labcal-calibration/1": _File, "labcal-calibration/2": _File2}


def read_calibration(path: Path) -> Calibration:
    """Read the calibration at `path`. Raises InputError with the file and the path to the fault in it."""
    return parse_calibration(read_limited(path, LARGEST_BYTES), path)


def parse_calibration(content: bytes, file: object = "calibration") -> Calibration:
    """The calibration that the bytes `content` state; `file` is named in faults. Raises InputError."""
    version = VERSIONS.get(_format_of(content, file), _File2)
    try:
        stated = version.model_validate_json(content, strict=True)
    except ValidationError as error:
        raise InputError(_first_fault(error), file=file) from None
    return _calibration(stated)


def calibration_bytes(calibration: Calibration) -> bytes:
    """The file's bytes: RFC 8785 JSON, the same for the same calibration.

    `dut.noise_nT` is not part of the file. Raises InputError naming the field, where the calibration could not be
    read again (a NaN, a singular K, an effect under the wrong owner).
    """
    try:
        stated = VERSIONS[calibration.format].model_validate(_fields(calibration))
    except ValidationError as error:
        raise InputError(_first_fault(error), file="calibration to be written") from None
    return rfc8785.dumps(stated.model_dump(mode="json"))


def looks_like_calibration(path: Path) -> bool:
    """Whether `path` is a file that begins as a calibration does, or is called .json; a bundle is neither."""
    if not path.is_file():
        return False
    with path.open("rb") as source:
        return source.read(1) == b"{" or path.suffix.lower() == ".json"


def _format_of(content: bytes, file: object) -> str:
    """The format that it states, "" for none. Raises InputError for what a JSON parser lets pass in silence.

    That is double keys, NaN, other encodings, numbers without end.
    """
    try:
        stated = json.loads(content.decode(), object_pairs_hook=_unique, parse_constant=_finite_only)
        return str(stated.get("format", "")) if isinstance(stated, dict) else ""
    except json.JSONDecodeError as error:
        raise InputError(f"is not JSON: {error.msg}", file=file, line=error.lineno, column=error.colno) from None
    except UnicodeDecodeError as error:
        raise InputError(f"is not UTF-8 (byte {error.start})", file=file) from None
    except RecursionError:
        raise InputError("is nested too deeply", file=file) from None
    except ValueError as error:
        raise InputError(str(error), file=file) from None


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    seen = dict(pairs)
    if len(seen) < len(pairs):
        twice, _ = Counter(name for name, _ in pairs).most_common(1)[0]
        raise ValueError(f"states {twice[:60]!r} twice")
    return seen


def _finite_only(constant: str) -> float:
    raise ValueError(f"{constant} is not a number that JSON has")


def _first_fault(error: ValidationError) -> str:
    fault = error.errors(include_url=False, include_context=False)[0]
    steps = (f"[{step}]" if isinstance(step, int) else f".{_printable(step)}" for step in fault["loc"])
    message = fault["msg"].removeprefix("Value error, ")
    return f"{''.join(steps).lstrip('.') or 'the file'}: {message[:1].lower()}{message[1:]}"


def _printable(name: str) -> str:
    return name if name.isprintable() else repr(name)


def _fields(c: Calibration) -> Mapping[str, object]:
    return {name: getattr(c, name) for name in VERSIONS[c.format].model_fields if hasattr(c, name)} | {
        "K": c.affine.K.tolist(),
        "k_nT": c.affine.k_nT.tolist(),
        "covariance": None if c.covariance is None else c.covariance.tolist(),
        "metrics": {"before": {}, "after": {}} | dict(c.metrics),
    }


def _calibration(f: _File) -> Calibration:
    until = f.validity.until
    added = f.model_dump(include=_File2.model_fields.keys() - _File.model_fields.keys())
    return Calibration(
        **added,
        format=f.format,
        run_id=f.run_id,
        simulated=f.simulated,
        dut=Dut(**f.dut.model_dump()),
        affine=AffineMap(_frozen(f.K), _frozen(f.k_nT)),
        covariance=None if f.covariance is None else _frozen(f.covariance),
        frame_known=f.frame_known,
        effects=tuple(map(_effect, f.effects)),
        findings=tuple(map(_effect, f.findings)),
        validity=Validity(**f.validity.model_dump() | {"until": until and until.isoformat()}),
        span_s=f.span_s,
        metrics=f.metrics.model_dump(),
        instruments=f.instruments,
        run_sha256=f.run_sha256,
        cage_sha256=f.cage_sha256,
        supersedes=f.supersedes,
        software=f.software,
        operator=f.operator,
        approvers=f.approvers,
    )


def _effect(stated: _Effect) -> EffectRecord:
    parameters = tuple(Parameter(**p.model_dump()) for p in stated.parameters)
    rivals = tuple(Rival(**r.model_dump()) for r in stated.rivals)
    basis = None if stated.basis is None else Basis(**stated.basis.model_dump())
    domain = tuple(Domain(**d.model_dump()) for d in stated.domain)
    plain = stated.model_dump(exclude={"parameters", "rivals", "basis", "domain"})
    return EffectRecord(**plain, parameters=parameters, rivals=rivals, basis=basis, domain=domain)


def _frozen(values: object) -> NDArray[np.float64]:
    array = np.array(values, dtype=float)
    array.setflags(write=False)
    return array
