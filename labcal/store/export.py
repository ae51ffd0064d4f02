"""A run for other programs: HDF5 and MATLAB. Missing values are NaN; the same run gives the same bytes."""

from __future__ import annotations

import io
import re
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from labcal.errors import InputError
from labcal.files.spreadsheet import first_formula
from labcal.record import Run
from labcal.store.bundle import Bundle
from labcal.store.limits import SAMPLES_CSV
from labcal.store.run_json import write_run_json

MAT_TITLE = b"MATLAB 5.0 MAT-file, a labcal run".ljust(116)  # scipy writes the date there


def csv_table(bundle: Bundle) -> bytes:
    """The samples of `bundle`, byte for byte. Raises InputError where a spreadsheet would run one of the cells."""
    if found := first_formula(bundle.samples_csv.decode(errors="replace")):
        line, cell = found
        text = f"a spreadsheet would take {cell[:40]!r} for a formula; --format bundle writes it as it stands"
        raise InputError(text, file=bundle.source / SAMPLES_CSV, line=line)
    return bundle.samples_csv


def hdf5(run: Run) -> bytes:
    """An HDF5 file: group `samples` with one dataset a column and its unit, and run.json as an attribute."""
    import h5py

    buffer = io.BytesIO()
    with h5py.File(buffer, "w", libver=("earliest", "v110")) as file:
        file.attrs["format"] = "labcal-run/1"
        file.attrs["run_json"] = write_run_json(run).decode()
        samples = file.create_group("samples")
        for name, unit, values in _columns(run):
            stored = values.astype(h5py.string_dtype()) if values.dtype.kind == "U" else values
            samples.create_dataset(name.replace("/", "_"), data=stored).attrs["unit"] = unit
    return buffer.getvalue()


def mat(run: Run) -> bytes:
    """A MATLAB 5 file: a struct `samples` of column vectors (texts as cells), a struct `units`, the text `run_json`.

    A column whose name is no MATLAB name has other signs replaced by `_`.
    """
    from scipy.io import savemat

    columns = {_matlab_name(name): (unit, values) for name, unit, values in _columns(run)}
    content = {
        "run_json": write_run_json(run).decode(),
        "samples": {name: _column_vector(values) for name, (_, values) in columns.items()},
        "units": {name: unit for name, (unit, _) in columns.items()},
    }
    with TemporaryDirectory() as folder:
        path = Path(folder) / "run.mat"
        savemat(str(path), content, long_field_names=True, do_compression=True)
        return MAT_TITLE + path.read_bytes()[len(MAT_TITLE) :]


def _columns(run: Run) -> Iterator[tuple[str, str, np.ndarray[Any, Any]]]:
    """Name, unit and values (n,) of each column, in the order of samples.csv."""
    yield "t_s", "s", run.t_s
    yield "segment", "", np.array([segment.id for segment in run.segments], dtype=np.str_)[run.segment_index]
    for axis, reading in zip("xyz", run.reading.T, strict=True):
        yield f"dut_{axis}", run.dut.unit, reading
    if run.reference_vector is not None:
        for axis, field in zip("xyz", run.reference_vector.T, strict=True):
            yield f"ref_{axis}", "nT", field
    if run.reference_magnitude is not None:
        yield "ref_f", "nT", run.reference_magnitude
    if run.angle_deg is not None:
        yield "angle_deg", "deg", run.angle_deg
    yield "mode", "", run.mode
    for channel in run.channels:
        yield channel.name, channel.unit, channel.values


def _column_vector(values: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    return (values.astype(object) if values.dtype.kind == "U" else values)[:, None]


def _matlab_name(name: str) -> str:
    plain = re.sub(r"[^A-Za-z0-9_]", "_", name)[:63]
    return plain if plain[0].isalpha() else f"c{plain}"[:63]
