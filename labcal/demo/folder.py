"""The demo's folder: nothing gives way to a demo but what an earlier demo left, which is recognised by its content."""

from __future__ import annotations

import os
import re
from pathlib import Path

from labcal.certificate import read_allowed_signers, signature_files, sshsig
from labcal.certificate.keys import SIMULATED
from labcal.errors import InputError, InstrumentError
from labcal.files.outputs import claim
from labcal.store import Store, load_bundle
from labcal.store.run_json import read_run_json

RUN, CALIBRATION, TRUST, REPORT = "run.zip", "calibration.json", "allowed_signers", "report.html"
STORE, SIGNATURE = "labcal-demo.sqlite", f"{CALIBRATION}.sshsig"
NAMES = (SIGNATURE, CALIBRATION, TRUST, REPORT, RUN, STORE)  # in the order in which they go
CALIBRATION_SAYS = re.compile(rb'"run_id":"demo-\d+".*"simulated":true', re.DOTALL)
REPORT_SAYS = re.compile(rb"\A<!doctype html>.*\brun demo-\d+\b", re.DOTALL | re.IGNORECASE)


def make_room(folder: Path, *, force: bool = False) -> None:
    """Make the folder; what an earlier demo left there goes, and other files of those names where `force` says so.

    Raises InputError, before anything goes, for a folder of labcal's own, a file of a leaf's name that no demo left, or
    that a person signed.
    """
    there = [folder / name for name in NAMES if os.path.lexists(folder / name)]
    spoilt = (path for path in there if not _left_by_a_demo(path))
    absent = (folder / name for name in NAMES if name != SIGNATURE and folder / name not in there)
    claim("demo", *spoilt, *absent, force=force, with_folder=True)
    folder.mkdir(parents=True, exist_ok=True)
    for path in (*there, folder / f"{STORE}-wal", folder / f"{STORE}-shm"):
        path.unlink(missing_ok=True)


def _left_by_a_demo(path: Path) -> bool:
    try:
        return path.is_file() and IS_LEFT[path.name](path)
    except (InputError, InstrumentError, OSError, sshsig.BadSignature):
        return False


def _signature(path: Path) -> bool:
    """Whether the key that lived in a demo's memory made it: the one that the trust list beside it names."""
    own = {signer.key for signer in read_allowed_signers(path.with_name(TRUST)) if signer.principal == SIMULATED}
    return sshsig.parse(path.read_bytes()).public_key in own


def _calibration(path: Path) -> bool:
    """Whether it is of a demo's run, and signed by nobody but the demo."""
    signed = signature_files(path)
    return CALIBRATION_SAYS.search(path.read_bytes()) is not None and all(
        file.name == SIGNATURE and _signature(file) for file in signed
    )


def _trust(path: Path) -> bool:
    return {signer.principal for signer in read_allowed_signers(path)} == {SIMULATED}


def _report(path: Path) -> bool:
    return REPORT_SAYS.search(path.read_bytes()) is not None


def _run(path: Path) -> bool:
    run = read_run_json(load_bundle(path).run_json, file=path)
    return run.simulated and run.run_id.startswith("demo-")


def _store(path: Path) -> bool:
    with Store.open(path) as store:
        return all(run.simulated and run.run_id.startswith("demo-") for run in store.runs())


IS_LEFT = {
    SIGNATURE: _signature,
    CALIBRATION: _calibration,
    TRUST: _trust,
    REPORT: _report,
    RUN: _run,
    STORE: _store,
}
