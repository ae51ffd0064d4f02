"""One folder with everything that goes to the customer, and what each file of it is."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from labcal.certificate.handed import CONTENTS, kind_of
from labcal.files.outputs import claim
from labcal.session import hand_out
from labcal.session.reporting import report

KINDS = {
    "certificate": "the certificate, for people",
    "calibration": "the calibration, for programs: the file that is signed",
    "signature": "the signature of the calibration file",
    "time-stamp": "a time-stamp: when that signature was there already",
    "keys": "public keys, by which the signatures are checked",
    "contents": "this list",
}


def hand_out_whole(calibration: Path, folder: Path, name: str) -> None:
    """The calibration with its signatures and keys, its certificate as `name`.pdf, and a list of what is what.

    Raises InputError where a file of one of these names is there that is not of labcal.
    """
    hand_out(calibration, folder, name)
    report(str(calibration), folder / f"{name}.pdf")
    [contents] = claim("hand out", folder / f"{name}{CONTENTS}")
    with contents.writing() as file:
        names = sorted({one.name for one in folder.iterdir()} | {file.name})
        file.write_text(_contents(calibration.name, names, name), encoding="utf-8")


def _contents(source: str, names: Iterable[str], name: str) -> str:
    known = [(one, kind_of(one, name)) for one in names]
    width = max(len(one) for one, kind in known if kind)
    lines = [f"{one:{width}}  {KINDS[kind]}" for one, kind in known if kind]
    check = f"To verify: labcal verify {name}.json --allowed-signers allowed_signers"
    return "\n".join((f"Calibration {source.removesuffix('.json')}", "", *lines, "", check, ""))
