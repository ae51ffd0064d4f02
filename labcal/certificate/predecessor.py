"""The calibration before this one of the same DUT, and what changed since."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

from labcal.certificate.calibration_file import read_calibration
from labcal.errors import InputError
from labcal.model import Calibration
from labcal.uncertainty.conformity import Changes, changes


def changed_from(calibration: Calibration, before: Path) -> Changes:
    """What changed from the calibration in the file `before`. Raises InputError where that is another DUT's."""
    try:
        return changes(calibration, read_calibration(before))
    except ValueError as error:
        raise error if isinstance(error, InputError) else InputError(str(error), file=before) from None


def changed_since(calibration: Calibration, folder: Path, started_utc: Mapping[str, str]) -> Changes | None:
    """What changed since the last calibration in `folder` of the same DUT; None where none is before.

    Which was before follows from when their runs were `started_utc` {run id: ISO 8601}; a file whose run is not known
    there, or that cannot be read, is passed over.
    """
    own = started_utc.get(calibration.run_id)
    if own is None:
        return None
    earlier = ((started_utc.get(one.run_id, own), one) for one in _like(calibration, folder))
    before = max(((at, one) for at, one in earlier if at < own), key=lambda pair: pair[0], default=None)
    return None if before is None else changes(calibration, before[1])


def _like(calibration: Calibration, folder: Path) -> Iterator[Calibration]:
    """The calibrations in `folder` that it can be compared with."""
    dut = calibration.dut
    for path in sorted(folder.glob("*.json")):
        try:
            found = read_calibration(path)
        except (InputError, OSError):
            continue
        same = (found.dut.serial, found.dut.unit, found.dut.nominal_nT_per_unit, found.simulated)
        if same == (dut.serial, dut.unit, dut.nominal_nT_per_unit, calibration.simulated):
            yield found
