"""The cage calibration file: what a run of `cage-calibration` found, once a person has approved it.

bench.toml names it as `[cage] calibration = "cage.json"`; the matrix is then this file's, and so is what carries the
reading of a remote reference to the DUT's place.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from numpy.typing import NDArray
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from labcal.bench.config import BenchConfig, Matrix, Vector, line_of
from labcal.errors import InputError
from labcal.files.atomic import write_text

Array = NDArray[np.float64]
Name = Annotated[str, Field(min_length=1)]
Row12 = Annotated[tuple[float, ...], Field(min_length=12, max_length=12)]


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True, allow_inf_nan=False)


class Place(_Part):
    """b = M I + b0 at one place, or the difference of two; `covariance` (12, 12) orders M row by row, then b0."""

    matrix_nT_per_A: Matrix
    offset_nT: Vector
    covariance: Annotated[tuple[Row12, ...], Field(min_length=12, max_length=12)]

    def at(self, currents_A: Array) -> Array:
        """The field (n, 3) [nT, C] that currents (n, 3) make, ambient included."""
        return np.asarray(currents_A @ np.array(self.matrix_nT_per_A).T + self.offset_nT)

    @property
    def u_matrix_nT_per_A(self) -> float:
        """The largest standard uncertainty of an element of the matrix."""
        return float(np.sqrt(np.diag(self.covariance)[:9].max()))

    @property
    def u_offset_nT(self) -> float:
        """The largest standard uncertainty of a component of the offset."""
        return float(np.sqrt(np.diag(self.covariance)[9:].max()))


class CageCalibration(_Part):
    """An approved cage calibration. `carry` is what the DUT's place has beyond the reference's, None for one place."""

    format: Literal["labcal-cage/1"] = "labcal-cage/1"
    run_id: Name
    simulated: bool
    measured_utc: Name
    operator: str
    approved_by: Name
    dut: Place
    carry: Place | None = None
    reference_position_m: Vector | None = None


def cage_text(calibration: CageCalibration) -> str:
    """What the file holds."""
    return json.dumps(calibration.model_dump(mode="json"), indent=1, ensure_ascii=False) + "\n"


def write_cage(calibration: CageCalibration, out: Path) -> None:
    """Write the file, whole or not at all."""
    write_text(out, cage_text(calibration))


def read_cage(path: Path) -> CageCalibration:
    """Read the file. Raises InputError naming the key that is wrong."""
    try:
        return CageCalibration.model_validate_json(path.read_bytes())
    except ValidationError as error:
        first = error.errors()[0]
        raise InputError(f"{'.'.join(map(str, first['loc'])) or 'the file'}: {first['msg']}", file=path) from error


def calibrated(config: BenchConfig, path: Path) -> tuple[BenchConfig, CageCalibration | None]:
    """`config` of the bench file `path` with the matrix of the cage calibration that it names, and that calibration.

    Raises InputError where the file is not there or no cage calibration, of a simulated cage on a real bench, or
    measured with the reference at another working place.
    """
    if config.cage.calibration is None:
        return config, None
    file = path.parent / config.cage.calibration
    line = line_of(path.read_text(encoding="utf-8"), ("cage", "calibration"))
    if not file.is_file():
        raise InputError(f"cage.calibration: there is no file {file}", file=path, line=line)
    found, own = read_cage(file), config.reference.position_m
    if found.simulated and not config.unreal:
        raise InputError(f"cage.calibration: {file.name} is of a simulated cage", file=path, line=line)
    if found.carry is not None and found.reference_position_m != own:
        where = f"the reference at {found.reference_position_m}, not at {own}"
        raise InputError(f"cage.calibration: {file.name} was measured with {where}", file=path, line=line)
    cage = config.cage.model_copy(update={"matrix_nT_per_A": found.dut.matrix_nT_per_A})
    return config.model_copy(update={"cage": cage}), found


def sha256_of(config: BenchConfig, path: Path) -> str | None:
    """SHA-256 of the cage calibration file that the bench file `path` names; None where it names none."""
    named = config.cage.calibration
    return None if named is None else hashlib.sha256((path.parent / named).read_bytes()).hexdigest()
