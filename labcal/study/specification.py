"""A study as a person states it: a TOML file, checked whole before the first job."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError, model_validator

from labcal.bench.config import line_of, sentence
from labcal.errors import InputError
from labcal.files.toml_file import read_toml

MOST_JOBS = 100_000
Angle = Annotated[float, Field(gt=0, le=180, allow_inf_nan=False)]
Seed = Annotated[int, Field(ge=0, le=2**32 - 1)]


class _Stated(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)
    format: Literal["labcal-study/1"]


class _Simulated(_Stated):
    """A procedure on the simulated bench. `lab` is what differs in the bench file, `settings` its parameters."""

    bench: Path | None = None  # that of the demo
    procedure: str = "preflight"
    seeds: Annotated[int, Field(ge=1, le=MOST_JOBS)] | tuple[Seed, Seed] = 10  # how many from 0, or first and last
    lab: dict[str, Any] = {}
    settings: dict[str, Any] = {}
    grid: dict[str, Any] = {}

    @property
    def all_seeds(self) -> range:
        """Every seed, in order."""
        return range(self.seeds) if isinstance(self.seeds, int) else range(self.seeds[0], self.seeds[1] + 1)

    @model_validator(mode="after")
    def _in_order(self) -> _Simulated:
        if not self.all_seeds:
            raise ValueError("seeds: the last one comes before the first")
        return self


class _Judged(_Simulated):
    """The accuracy of directions in a field of `field_nT`."""

    field_nT: Annotated[float, Field(ge=1_000, le=200_000)] = 50_000.0


class MonteCarlo(_Judged):
    """Runs, their fits, and the errors against the truth."""

    kind: Literal["monte-carlo"]
    method: str = "ml"
    accuracy_deg: Angle | None = None  # asked of every point of the grid


class Blind(_Simulated):
    """The loop on effects that are not declared to it."""

    kind: Literal["blind"]


class Design(_Judged):
    """The rotations of a preflight that reach an accuracy in the least lab time."""

    kind: Literal["design"]
    accuracy_deg: tuple[Angle, ...] | Angle
    mount_s: Annotated[float, Field(ge=0, le=86_400)] = 180.0  # a person's, each time an axis is mounted

    @property
    def accuracies_deg(self) -> tuple[float, ...]:
        """Each that is asked for."""
        return self.accuracy_deg if isinstance(self.accuracy_deg, tuple) else (self.accuracy_deg,)


class NamedEffect(BaseModel):
    """An effect that is to be in every calibration, and the channels that drive it."""

    model_config = ConfigDict(extra="forbid", frozen=True)
    id: str
    channels: tuple[str, ...] = ()


class FleetStudy(_Stated):
    """Existing calibrations, worked out again from their runs."""

    kind: Literal["fleet"]
    runs: Path | None = None  # a folder of bundles; else this lab's store
    calibrations: Path | None = None  # a folder; else that of the runs, else this lab's own
    archive: str | None = None  # its URL, without a password: all that is there, fetched into the folder of results
    by: str = "as-made"  # or close-loop, or a method of fit
    effect: NamedEffect | None = None

    @model_validator(mode="after")
    def _one_way(self) -> FleetStudy:
        if self.effect is not None and self.by != "as-made":
            raise ValueError("by: an effect that is named is added to each calibration as made; leave `by` out")
        return self


Simulated = MonteCarlo | Blind | Design
Study = Annotated[MonteCarlo | Blind | Design | FleetStudy, Field(discriminator="kind")]
_ADAPTER: TypeAdapter[MonteCarlo | Blind | Design | FleetStudy] = TypeAdapter(Study)
KINDS = ("monte-carlo", "blind", "design", "fleet")


def read_study(path: Path) -> MonteCarlo | Blind | Design | FleetStudy:
    """Read a study file. Raises InputError with the file, the line and the key; paths count from its own folder."""
    text, table = read_toml(path)
    if table.get("kind") not in KINDS:
        raise InputError(
            f"kind must be one of {', '.join(KINDS)}", file=path, line=line_of(text, ("kind",)) if table else None
        )
    try:
        stated = _ADAPTER.validate_python(table)
    except ValidationError as error:
        raise _first_fault(error, text, path) from None
    places = {name: _from(path, getattr(stated, name)) for name in ("bench", "runs", "calibrations")
              if getattr(stated, name, None) is not None}  # fmt: skip
    return stated.model_copy(update=places)


def _first_fault(error: ValidationError, text: str, path: Path) -> InputError:
    """A misspelt key first: it also leaves another missing."""
    faults = error.errors()
    first = next((f for f in faults if f["type"] == "extra_forbidden"), faults[0])
    keys = tuple(str(part) for part in first["loc"][1:])  # after the kind
    stated = tuple(key for key in keys if not key.startswith(("constrained", "tuple", "float", "int", "function")))
    name, said = ".".join(stated), sentence(first)
    between = "" if not name else " " if said.startswith(("is ", "has ", "must ")) else ": "
    return InputError(f"{name}{between}{said}", file=path, line=line_of(text, stated))


def _from(path: Path, place: Path) -> Path:
    return path.parent / place.expanduser()


def texts(settings: Mapping[str, Any]) -> dict[str, str]:
    """Settings of a procedure as `--set` takes them: a list with commas, yes and no. Raises ValueError for a table."""
    return {name: _text(name, value) for name, value in settings.items()}


def _text(name: str, value: Any) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, list):
        return ",".join(_text(name, one) for one in value)
    if isinstance(value, str | int | float):
        return str(value)
    raise ValueError(f"settings.{name}: a procedure takes numbers, words and lists of them")
