"""Runs and calibrations of the archive as files of a folder: each fetched once, and called by what it holds."""

from __future__ import annotations

import re
from hashlib import sha256
from pathlib import Path
from typing import Any

from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.session.archiving import archived_runs, bundle_from_archive
from labcal.session.opened_archive import opened
from labcal.store import save_bundle

SHA256 = re.compile(r"[0-9a-f]{64}")


def run_from_archive(given: str | None, row: dict[str, Any], folder: Path) -> Path:
    """The bundle of the run that a row of the archive names, in `folder`."""
    if not SHA256.fullmatch(row["sha256"]):  # whoever may push writes the row: it would be part of a path
        raise InputError(f"its SHA-256 in the archive is none: {row['sha256'][:80]!r}")
    place = folder / f"{row['sha256']}.zip"
    folder.mkdir(parents=True, exist_ok=True)
    if not place.exists():
        save_bundle(bundle_from_archive(given, row["sha256"]), place)
    return place


def runs_from_archive(given: str | None, folder: Path, dut: str | None = None) -> list[tuple[dict[str, Any], Path]]:
    """All runs that this role may see, of one DUT where it is named, each with its bundle in `folder`."""
    mine = (row for row in archived_runs(given) if dut in (None, row["dut_serial"]))
    rows = {row["sha256"]: row for row in mine}  # two sites may have the same run
    return [(row, run_from_archive(given, row, folder)) for row in rows.values()]


def calibrations_from_archive(given: str | None, folder: Path) -> None:
    """Write all calibrations that this role may see into `folder`."""
    with opened(given) as archive:
        from labcal.archive.contents import calibrations

        folder.mkdir(parents=True, exist_ok=True)
        for one in calibrations(archive):
            write_bytes(folder / f"{sha256(one.content).hexdigest()}.json", one.content)
