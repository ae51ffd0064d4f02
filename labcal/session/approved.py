"""What was approved here, kept by its number: what is signed has to be that."""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import Any

from labcal import certificate
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder
from labcal.model import Calibration

FOLDER = "approved"
BY_PEOPLE = frozenset({"number", "approvers", "issued_utc", "supersedes", "validity.until"})
BY_THE_NEXT = frozenset({"approvers", "issued_utc"})  # what another approval changes


def keep_approved(approved: Calibration) -> None:
    """Keep it as it was approved; nothing where it has no number, or labcal's folder takes nothing."""
    if approved.number is not None:
        with suppress(OSError):
            own_folder(own_folder(home()) / FOLDER)
            write_bytes(_place(approved.number), certificate.calibration_bytes(approved), FILE)


def check_approved(stated: Calibration, path: Path) -> None:
    """Raise InputError naming the field in which `stated`, of the file `path`, is not what was approved here.

    One that was approved on another computer is not known here; who has approved it there since may be in it.
    """
    if stated.number is None or not _place(stated.number).exists():
        _refuse_another_number(stated, path)
        return
    approved = certificate.read_calibration(_place(stated.number))
    count = len(approved.approvers)
    later = len(stated.approvers) > count and stated.approvers[:count] == approved.approvers
    for name in sorted(_different(stated, approved) - (BY_THE_NEXT if later else frozenset())):
        text = f"{name}: is not as {', '.join(approved.approvers)} approved it with number {stated.number}"
        raise InputError(f"{text}; nothing was written: make the draft again", file=path)


def _refuse_another_number(stated: Calibration, path: Path) -> None:
    """Raise InputError where the same was approved here with another number; a draft has none yet."""
    for kept in (home() / FOLDER).glob("*.json") if stated.number else ():
        content = kept.read_bytes()
        if stated.run_sha256.encode() not in content:
            continue
        approved = certificate.parse_calibration(content, kept)
        if not _different(stated, approved) - BY_PEOPLE:
            text = f"number: {stated.number} is stated, and {', '.join(approved.approvers)} approved it as"
            raise InputError(f"{text} {approved.number}; nothing was written: make the draft again", file=path)


def _different(one: Calibration, other: Calibration) -> frozenset[str]:
    """The fields in which two differ."""
    a, b = _document(one), _document(other)
    return frozenset(name for name in a.keys() | b.keys() if a.get(name) != b.get(name))


def _place(number: str) -> Path:
    return home() / FOLDER / f"{sha256(number.encode()).hexdigest()}.json"  # whatever a file calls its number


def _document(calibration: Calibration) -> Mapping[str, Any]:
    stated: dict[str, Any] = json.loads(certificate.calibration_bytes(calibration))
    return stated | {"validity.until": stated["validity"].pop("until")}
