"""A calibration that another program made, taken in as a draft."""

from __future__ import annotations

from pathlib import Path

from labcal import certificate
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.outputs import claim

FOREIGN_CALIBRATIONS = certificate.flight.KINDS


def import_calibration(path: Path, kind: str, out: Path | None = None, *, force: bool = False) -> Path:
    """Write the draft that the file at `path` states to `out`, else beside it; returns where. Raises InputError."""
    target = out or path.parent / f"{path.stem}.calibration.json"
    [output] = claim("import", target, inputs=(path,), force=force)
    draft = certificate.flight.read_foreign(path, kind)
    try:
        content = certificate.calibration_bytes(draft)
    except InputError as error:  # such as a matrix that maps two readings to one field
        raise InputError(error.what, file=path) from None
    with output.writing():
        write_bytes(target, content)
    return target
