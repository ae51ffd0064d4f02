"""What is written into the lab's audit log; a run that has ended hears of whatever becomes of its entry."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace
from datetime import datetime
from hashlib import sha256
from pathlib import Path

from labcal import audit
from labcal.errors import InputError, InstrumentError
from labcal.files.home import home
from labcal.runner import Outcome
from labcal.store import Store


def note(deed: audit.Deed, who: str = "", **about: str | None) -> None:
    """Add to the log what was done, and to what; without `who` the user of the machine did it. Raises InputError."""
    note_all(deed, [about], who)


def note_all(deed: audit.Deed, abouts: Iterable[Mapping[str, str | None]], who: str = "") -> None:
    """The same of several, an entry for each, at one go."""
    stated = ({name: value for name, value in about.items() if value is not None} for about in abouts)
    try:
        audit.append(home(), deed, who, *stated)
    except InputError as fault:
        raise InputError(f"done ({deed}), but not in the audit log: {fault.what}", file=fault.file) from None


def note_file(
    deed: audit.Deed, who: str, path: Path, signature: Path | None = None, number: str | None = None, **about: str
) -> None:
    """The same of a file by its name, the SHA-256 of what it holds now, so is its new `signature`, its number."""
    signed = None if signature is None else _sha256(signature)
    note(deed, who, file=path.name, sha256=_sha256(path), signature=signed, number=number, **about)


def note_run(outcome: Outcome, store: Store, who: str) -> Outcome:
    """Add a run as it ended, with the head of its chain; the outcome says so where the log does not take it."""
    try:
        head, first = _head(store, outcome.run_id), _first(store)
        note("run", who, run=outcome.run_id, status=outcome.status, chain=head, first=first)
    except InputError as fault:
        return replace(outcome, ending=f"{outcome.ending}; {fault}")
    return outcome


def note_import(run: str, store: Store) -> None:
    """Add a run that was taken in, with the one that the store began with. Raises InputError."""
    note("import", run=run, first=_first(store))


def noted_utc(signature: bytes) -> datetime | None:
    """When the log took down that these bytes signed a file; None where it did not, or is not as it was written."""
    digest = sha256(signature).hexdigest()
    with suppress(InputError):
        if any(digest.encode() in text for _, text, _ in audit.stored(home())):
            return noted_signatures().get(digest)
    return None


def noted_signatures() -> dict[str, datetime]:
    """When the log took down each signature, by its SHA-256; none where it is not as it was written."""
    found, latest = dict[str, datetime](), ""
    with suppress(InputError):
        log = audit.read(home())
        for entry in () if log.fault else log.entries:
            latest = max(latest, entry.utc)  # a clock that was put back shows nothing earlier than what it had shown
            if entry.deed in ("sign", "approve") and "signature" in entry.about:
                found.setdefault(entry.about["signature"], datetime.fromisoformat(latest))
    return found


def noted_heads() -> dict[str, tuple[str, ...]]:
    """The heads that the chain of each run had whenever it ended here, as the log took them down, in its order."""
    found = dict[str, tuple[str, ...]]()
    with suppress(InputError):
        if not any(b'"deed":"run"' in text for _, text, _ in audit.stored(home())):
            return found
        for entry in audit.read(home()).entries:
            if entry.deed == "run" and "chain" in entry.about:
                run = entry.about["run"]
                found[run] = (*found.get(run, ()), entry.about["chain"])
    return found


def noted_runs() -> dict[str, str]:
    """Every run that the log says was recorded or taken in here, in its order, with the one the store then began with.

    "" where an entry of before that was stated says nothing of it. One that came into another store again counts there.
    """
    found = dict[str, str]()
    with suppress(InputError):
        for entry in audit.read(home()).entries:
            if entry.deed == "import":
                found.pop(entry.about["run"], None)
            if entry.deed in ("run", "import"):
                found[entry.about["run"]] = entry.about.get("first", "")
    return found


def noted_cages(bench: str) -> list[audit.Entry]:
    """The approvals of cage calibrations of a bench by its name, in the order of the log."""
    with suppress(InputError):
        if any(b'"measured_utc"' in text for _, text, _ in audit.stored(home())):
            entries = audit.read(home()).entries
            return [one for one in entries if one.deed == "approve" and one.about.get("cage") == bench]
    return []


def noted_number(number: str) -> set[str]:
    """What the log says was done with a certificate number: approve, sign, void."""
    with suppress(InputError):
        if any(number.encode() in text for _, text, _ in audit.stored(home())):
            return {entry.deed for entry in audit.read(home()).entries if entry.about.get("number") == number}
    return set()


def _sha256(path: Path) -> str:
    return sha256(path.read_bytes()).hexdigest()


def _head(store: Store, run_id: str) -> str | None:
    """The head of a run's chain; None where its store cannot tell any more."""
    try:
        return store.head_of(run_id)
    except (InputError, InstrumentError):
        return None


def _first(store: Store) -> str | None:
    try:
        return store.first_and_last()[0]
    except (InputError, InstrumentError):
        return None


def read_audit() -> audit.Audit:
    """The lab's audit log, every entry looked at. Raises InputError where the file is none."""
    return audit.read(home())
