"""Whether the archive's catalogue still says what the bundles and files that it names say themselves.

The server keeps rows from being changed by those who push, not from being added false, and not the folder of bundles.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from labcal import audit, certificate
from labcal.archive import rows
from labcal.archive.bundles import get
from labcal.archive.contents import OfCalibration, calibrations, runs
from labcal.archive.server import Archive
from labcal.errors import InputError
from labcal.store import Bundle, load_bundle

Row = Mapping[str, Any]
LISTED = 5  # of what differs


def faults(archive: Archive, place: str, on_remark: Callable[[str], None]) -> Iterator[str]:
    """A sentence for each run and calibration of which the catalogue, or its bundle at `place`, says something else."""
    for row in runs(archive):
        on_remark(f"run {row['run_id']} of {row['site']}")
        try:
            refuse_other_row(rows.run_row(bundle_of_row(place, row).run(), "", ""), row)
        except InputError as fault:
            yield f"{row['site']}: run {row['run_id']}: {fault} (pushed by {row['pushed_by']})"
    for made in calibrations(archive):
        on_remark(f"calibration {made.row['sha256'][:12]} of {made.row['site']}")
        try:
            _refuse_other_rows(made)
        except InputError as fault:
            said = f"calibration of run {made.row['run_id']}: {fault} (pushed by {made.row['pushed_by']})"
            yield f"{made.row['site']}: {said}"


def bundle_of_row(place: str, row: Row) -> Bundle:
    """The bundle that a row of the catalogue names. Raises InputError: not there, damaged, or another run's."""
    content = get(place, row["bundle_sha256"])
    with TemporaryDirectory() as folder:
        kept = Path(folder) / "run.zip"
        kept.write_bytes(content)
        bundle = load_bundle(kept)
    if bundle.sha256 != row["sha256"]:
        raise InputError(f"the bundle that {row['site']} names for run {row['sha256'][:12]} is another run")
    return bundle


def refuse_other_row(said: Row, row: Row) -> None:
    """Raise InputError where the catalogue says something else of a run than its bundle does.

    Status and procedure are not compared: a bundle does not say them.
    """
    _refuse({**said, "status": row["status"], "procedure": row["procedure"]}, row)


def _refuse_other_rows(made: OfCalibration) -> None:
    if audit.link_of(made.content) != made.row["sha256"]:
        raise InputError("its content is not the one that it is called by")
    calibration = certificate.parse_calibration(made.content, Path(made.row["run_id"]))
    _refuse(rows.calibration_row(calibration), made.row)
    _refuse_others("effects", rows.effect_rows(calibration), made.effects)
    _refuse_others("parameters", rows.parameter_rows(calibration), made.parameters)
    _refuse_others("instruments", rows.instruments_of_calibration(calibration), made.instruments)
    for name, digest, content in made.documents:
        if audit.link_of(content) != digest:
            raise InputError(f"the content of {name!r} beside it is not the one that it is called by")


def _refuse(said: Row, row: Row) -> None:
    other = [name for name, value in said.items() if row[name] != value]
    if other:
        each = "; ".join(f"{name} {row[name]}, and it is {said[name]}" for name in other[:LISTED])
        raise InputError(f"the catalogue says {each}")


def _refuse_others(what: str, said: Iterable[Row], found: Iterable[Row]) -> None:
    if list(map(dict, said)) != list(map(dict, found)):
        raise InputError(f"its {what} in the catalogue are not those of its file")
