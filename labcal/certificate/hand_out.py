"""A calibration for somebody else: its file, its signatures, and the public keys they are checked against."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from labcal.certificate.allowed_signers import Signer
from labcal.certificate.signing import signature_files
from labcal.certificate.timestamp import token_file
from labcal.errors import InputError
from labcal.files.atomic import replaceable, write_bytes, write_text
from labcal.files.outputs import claim


def hand_out(calibration: Path, folder: Path, signers: Sequence[Signer], name: str = "") -> None:
    """Copy `calibration`, its signatures and their time-stamps to `folder`, and `signers` as its trust list.

    There it is called `name`.json, where that is given, and its signatures after it: they are of its content alone.

    Raises InputError, before anything is copied, where another file of one of these names is there.
    """
    [trust] = claim("hand out", folder / "allowed_signers")
    signatures = signature_files(calibration)
    tokens = [token for file in signatures if (token := token_file(file)).exists()]
    called = f"{name}.json" if name else calibration.name
    files = (calibration, *signatures, *tokens)
    copies = {folder / (called + file.name.removeprefix(calibration.name)): file.read_bytes() for file in files}
    for copy, content in copies.items():
        replaceable(copy)
        if copy.exists() and copy.read_bytes() != content:
            raise InputError("another file of this name is there already", file=copy)
    for copy, content in copies.items():
        write_bytes(copy, content)
    with trust.writing() as file:
        write_text(file, "".join(f"{signer.line()}\n" for signer in signers))
