"""Which number a certificate gets, and when it was issued: at an approval, or at the first signature without one."""

from __future__ import annotations

import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

from labcal.certificate import register
from labcal.certificate.laboratory import FILE as LABORATORY
from labcal.certificate.laboratory import read_laboratory
from labcal.certificate.recomputed import FIRST_VERSION
from labcal.certificate.register import NumberEntry
from labcal.certificate.signing import CLOCKS_DIFFER, signature_files
from labcal.errors import InputError
from labcal.files.home import home
from labcal.model import Calibration
from labcal.record import RunHeader
from labcal.session.audited import note, noted_number
from labcal.store import Store
from labcal.store.listing import FILE as STORE

Issue = Callable[[Calibration], Calibration]
SIMULATED, UNNAMED = "SIM", "LAB"
WITHOUT = "number: none is stated, and an approval gives one; nothing was written: make the draft again, and approve it"


@contextmanager
def issuing(path: Path) -> Iterator[Issue]:
    """Hand out what gives the draft at `path` its number, if it has none yet, and the time of now.

    A number that was taken and did not come into the file is kept as void, with the reason. Raises InputError for a
    number that is void or another calibration's.
    """
    taken = list[str]()

    def issue(draft: Calibration) -> Calibration:
        if draft.format == FIRST_VERSION:
            return draft  # it has no field for either
        utc = datetime.now(UTC).isoformat(timespec="seconds").replace("+00:00", "Z")
        if draft.number is None and len(draft.approvers) > 1:
            raise InputError(WITHOUT, file=path)
        if draft.number is None:
            taken.append(register.take(home(), *_bench_of(draft), draft.run_id, path.name, utc))
            _refuse_one_given_before(taken[-1])
        elif len(draft.approvers) == 1:
            raise InputError(_by_hand(draft.number), file=path)
        else:
            _check(draft, draft.number)
        return replace(draft, number=draft.number or taken[-1], issued_utc=utc)

    try:
        yield issue
    except BaseException as fault:
        for number in taken:
            if number.encode() not in path.read_bytes():
                register.void(home(), number, f"{path.name} was not written: {str(fault) or type(fault).__name__}")
        raise


def check_number(calibration: Calibration, path: Path) -> None:
    """Raise InputError where what is about to be signed bears a number that is not its own, or lost that it had."""
    first = not signature_files(path)
    if calibration.number is not None:
        if first and not calibration.approvers and "sign" not in noted_number(calibration.number):
            raise InputError(_by_hand(calibration.number), file=path)
        _check(calibration, calibration.number, sha256(path.read_bytes()).hexdigest())
    elif first and calibration.approvers and calibration.format != FIRST_VERSION:
        raise InputError(WITHOUT, file=path)


def _check(draft: Calibration, number: str, digest: str = "") -> None:
    register.check(home(), number, draft.run_id, digest)
    if "void" in noted_number(number):
        raise InputError(f"number: {number} is void, as the audit log says; make the draft again")
    code = bench = ""
    with suppress(InputError):  # a laboratory.toml that cannot be read keeps nobody from signing
        code, bench = _bench_of(draft)
    series = number.rsplit("-", 2)[0]
    if bench and series not in (f"{code}-{register.part_of(part)}" for part in (bench, "")):
        raise InputError(f"number: {number} is none of the bench {bench}, which recorded its run; make the draft again")


def against_the_register(stated: Calibration) -> tuple[str, ...]:
    """What the register has against number and date of issue of a calibration whose run was recorded here.

    A number that the audit log alone still knows stands: the register was lost, or put back as it was before.
    """
    if stated.number is None or not (home() / register.FILE).exists():
        return ()
    given = next((one for one in register.listed(home()) if one.number == stated.number), None)
    if given is None and noted_number(stated.number):
        return ()
    try:
        register.check(home(), stated.number, stated.run_id)
    except InputError as fault:
        return (fault.what.partition(";")[0],)
    if given and stated.issued_utc and _time(stated.issued_utc) < _time(given.utc):
        return (f"issued_utc: {stated.issued_utc} is before {given.utc}, when its number was given out",)
    return ()


def check_clock(draft: Calibration, path: Path, now: datetime) -> None:
    """Raise InputError where this computer's clock is before the run that is approved or signed began."""
    header = header_of(draft.run_id)
    if header is not None and not header.simulated and now + CLOCKS_DIFFER < _time(header.started_utc):
        text = f"this computer's clock, {now:%Y-%m-%d %H:%M} UTC, is before its run began, {header.started_utc}"
        raise InputError(f"issued_utc: {text}: one of them is wrong; nothing was written", file=path)


def _time(utc: str) -> datetime:
    return datetime.fromisoformat(utc)


def _by_hand(number: str) -> str:
    text = f"number: {number} is stated, and a draft that nobody has approved has none"
    return f"{text}; nothing was written: make the draft again"


def _refuse_one_given_before(number: str) -> None:
    """A register that was lost, or put back as it was before, begins again with numbers that others have."""
    if noted_number(number):
        text = f"{number} was given out before, as the audit log says, and the register has lost it"
        raise InputError(f"number: {text}: put back the newest {register.FILE} that you have", file=home())


def keep_signed(calibration: Calibration, content: bytes) -> None:
    """Keep in the register that these bytes were signed with their number."""
    if calibration.number is not None:
        register.signed(home(), calibration.number, calibration.run_id, sha256(content).hexdigest())


def numbers() -> tuple[NumberEntry, ...]:
    """Every certificate number that this lab has given out, void ones too."""
    return register.listed(home())


def void_number(number: str, reason: str) -> None:
    """Keep a number as void, with its reason. Raises InputError where it was signed with, or is unknown."""
    register.void(home(), number, reason)
    note("void", number=number, reason=reason)


def _bench_of(draft: Calibration) -> tuple[str, str]:
    """The laboratory's code and the bench's name that a number begins with; simulated ones have their own series."""
    header = header_of(draft.run_id)
    stated = None if header is None or header.administrative is None else header.administrative.laboratory
    if stated is None and (home() / LABORATORY).exists():
        stated = read_laboratory(home() / LABORATORY).laboratory
    code = SIMULATED if draft.simulated else UNNAMED if stated is None else stated.code
    return code, "" if header is None else bench_name(header.bench)


def header_of(run_id: str) -> RunHeader | None:
    """The head of the record of a run of the local store; None where it is not there."""
    if not (home() / STORE).exists():
        return None
    with suppress(InputError), Store.open() as store:
        return store.header(run_id) if store.has(run_id) else None
    return None


def bench_name(bench: str) -> str:
    """The name that a bench file states; empty where its text is none."""
    try:
        return str(tomllib.loads(bench).get("name", ""))
    except tomllib.TOMLDecodeError:
        return ""
