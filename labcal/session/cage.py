"""The cage's own calibration: approved and signed here, and its signature checked before a coil is driven by it."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from datetime import UTC, datetime
from hashlib import sha256
from pathlib import Path

from labcal import certificate
from labcal.bench.coils.cage_file import CageCalibration, cage_text, read_cage, write_cage
from labcal.bench.config import read_config
from labcal.certificate.agent import signed
from labcal.certificate.cage_signature import WHAT_TO_DO, cage_signature_file, cage_signer, check_cage
from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.home import home
from labcal.files.outputs import claim
from labcal.record.person import check_person, perhaps_one_person
from labcal.runner.cage import approved_cage
from labcal.session.audited import note_file, noted_cages
from labcal.session.numbering import bench_name
from labcal.session.signing import shown
from labcal.session.stamping import stamp
from labcal.session.trust import handed_out
from labcal.store import Store


def approve_cage(
    run: str,
    name: str,
    out: Path,
    ask: Callable[[str], str] = lambda signer: "",
    *,
    on_remark: Callable[[str], None] = lambda remark: None,
    force: bool = False,
) -> tuple[CageCalibration, Path | None]:
    """Write what a run of `cage-calibration` found to `out`, approved by `name`; until then it is a draft.

    Signed by them where their key is at hand: `ask` is asked for its passphrase, once all else is well. Returns the
    signature's path too; `on_remark` gets what came of asking for a time stamp.
    """
    check_person(name)
    [output] = claim("bench cage", out, force=force)
    signer = _approver_with_key(name)
    with Store.open() as kept:
        header = kept.header(run)
        found = approved_cage(header, kept.status(run), kept.items(run, but="block"), name)
    armoured = None
    if signer is not None:
        armoured = signed(cage_text(found).encode(), certificate.keys.signing_key(home(), signer, ask(signer)))
    with output.writing():
        write_cage(found, out)
    signature = None if armoured is None else cage_signature_file(out)
    if signature is not None and armoured is not None:
        write_text(signature, armoured)
    about = {"cage": bench_name(header.bench), "measured_utc": found.measured_utc}
    note_file("approve", name, out, signature, **about)
    if signature is not None and (said := stamp(signature, run)) is not None:
        on_remark(said)
    return found, signature


def cage_remark(bench: Path) -> str | None:
    """What is to be said of the cage calibration that a bench file names; None where it is signed and the newest that
    was approved here, or none is named.

    Raises InputError where its signature does not hold, or its operator approved it.
    """
    config = read_config(bench)
    named = config.cage.calibration
    if named is None or not (cage := bench.parent / named).is_file():
        return None  # a file that is not there is reported when the bench is opened
    found: CageCalibration | None = None
    with suppress(
        InputError
    ):  # what is wrong with its text is reported by its signature, else when the bench is opened
        found = read_cage(cage)
    if found is not None and perhaps_one_person(found.operator, found.approved_by):
        text = f"approved_by: {found.approved_by} is its operator, {found.operator}, and another person approves"
        raise InputError(f"{text}; {WHAT_TO_DO}", file=cage)
    approver, gone = found.approved_by if found else "", certificate.keys.revoked(home())
    unsigned = check_cage(cage, approver, handed_out(), gone, datetime.now(UTC), shown)
    older = None if found is None else _older(cage, found, config.name)
    return " ".join(said for said in (unsigned, older) if said) or None


def _older(cage: Path, found: CageCalibration, bench: str) -> str | None:
    """That a later cage calibration of this bench was approved here, as the audit log says; None where none was."""
    if not (approved := noted_cages(bench)):
        return None
    *before, last = approved
    digest = sha256(cage.read_bytes()).hexdigest()
    known = any(entry.about["sha256"] == digest for entry in before)
    if last.about["sha256"] == digest or not (known or found.measured_utc < last.about["measured_utc"]):
        return None
    newest = f"{last.who} approved that of {last.about['measured_utc'][:10]} on {last.utc[:10]}"
    return f"{cage.name}, measured {found.measured_utc[:10]}, is not the newest of this bench: {newest}."


def _approver_with_key(name: str) -> str | None:
    """Whose key at hand signs for the approver `name`; None where they have none here: the file stays unsigned.

    Raises InputError where they lack the role, or this lab has roles, so that it would not be used unsigned.
    """
    trusted = certificate.keys.trusted(home())
    found = cage_signer(name, trusted)
    certificate.check_approver(found or " ".join(name.split()), trusted)
    if found is not None and certificate.keys.has_key_at_hand(home(), found):
        return found
    if any(signer.roles for signer in trusted):
        text = f"in this lab an approver with a role signs a cage calibration, and no key of {name} is at hand here"
        raise InputError(f"{text}; nothing was written")
    return None
