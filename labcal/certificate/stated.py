"""What people state of a calibration beside its numbers: until when it is good, and which one it takes the place of."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from datetime import date, datetime
from hashlib import sha256
from pathlib import Path

from labcal.certificate.calibration_file import LARGEST_BYTES, calibration_bytes, parse_calibration
from labcal.certificate.signing import CLOCKS_DIFFER, signature_files
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.plain_file import read_limited
from labcal.model import Calibration


@dataclass(frozen=True, slots=True)
class Stated:
    """`until` is an ISO date; `supersedes` the SHA-256 of the file that is superseded. None leaves what is there."""

    until: str | None = None
    supersedes: str | None = None
    superseded_serial: str | None = None

    def on(self, draft: Calibration) -> Calibration:
        """The draft with it. Raises InputError where an approver has seen another statement, or of another DUT."""
        if self.superseded_serial not in (None, draft.dut.serial):
            raise InputError(
                f"supersedes: that is a calibration of {self.superseded_serial}, not of {draft.dut.serial}"
            )
        validity = replace(draft.validity, until=self.until or draft.validity.until)
        stated = replace(draft, validity=validity, supersedes=self.supersedes or draft.supersedes)
        changed = (validity.until, stated.supersedes) != (draft.validity.until, draft.supersedes)
        if changed and draft.approvers:
            text = (
                f"{', '.join(draft.approvers)} approved it as it is: another `until` or `supersedes` needs a new draft"
            )
            raise InputError(f"{text}; nothing was written")
        return stated


def state(path: Path, stated: Stated) -> Calibration:
    """Write it into the draft at `path`, for who works alone. Raises InputError, also after any signature."""
    draft = parse_calibration(read_limited(path, LARGEST_BYTES), path)
    if signed := signature_files(path):
        raise InputError(f"is signed already ({signed[0].name}); `until` and `supersedes` are a draft's", file=path)
    changed = stated.on(draft)
    if changed != draft:
        write_bytes(path.resolve(), calibration_bytes(changed))
    return changed


def stated_by_people(until: str | None, supersedes: Path | None, today: date | None = None) -> Stated:
    """What a command was given. Raises InputError for a day that is none or past, and a file that is no calibration."""
    if until is not None:
        day = _day(until)
        if day < (today or datetime.now().astimezone().date()):
            raise InputError(f"until: {until} is past")
    if supersedes is None:
        return Stated(until)
    content = read_limited(supersedes, LARGEST_BYTES)
    return Stated(until, sha256(content).hexdigest(), parse_calibration(content, supersedes).dut.serial)


def check_stated(calibration: Calibration, path: Path, now: datetime) -> None:
    """Raise InputError, naming the field, for what nobody can have stated of a file that is signed `now`."""
    if (until := calibration.validity.until) is not None and date.fromisoformat(until) < now.date():
        raise InputError(f"validity.until: {until} is past; nothing was written", file=path)
    supersedes = calibration.supersedes
    if supersedes is not None and not re.fullmatch("[0-9a-f]{64}", supersedes, re.ASCII):
        raise InputError("supersedes: is the SHA-256 of no file; nothing was written", file=path)
    if calibration.issued_utc is not None and calibration.number is not None:
        _check_issued(calibration.issued_utc, path, now)


def _check_issued(stated: str, path: Path, now: datetime) -> None:
    if datetime.fromisoformat(stated) > now + CLOCKS_DIFFER:
        text = f"issued_utc: {stated} is later than this computer's clock, {now:%Y-%m-%d %H:%M} UTC"
        raise InputError(f"{text}: one of them is wrong; nothing was written", file=path)


def _day(stated: str) -> date:
    try:
        return datetime.strptime(stated, "%Y-%m-%d").date()
    except ValueError:
        raise InputError(f"until: {stated!r} is no date like 2027-11-21") from None
