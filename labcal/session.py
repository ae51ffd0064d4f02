"""The line in order: bench → procedure → record → fit → loop → certificate. The command line and the window call it."""

from __future__ import annotations

from datetime import UTC, datetime
from pathlib import Path

from labcal import certificate, fit
from labcal.certificate import Entry, Signer, Verification, read_allowed_signers
from labcal.certificate.report import calibration_page, run_page, write_report
from labcal.errors import InputError
from labcal.home import home
from labcal.model import Calibration
from labcal.record import Run
from labcal.store import Bundle, Store, load_bundle


def load_run(run: str) -> Run:
    """The run that `run` names: a path to a bundle, or a run id of the local store. Raises InputError."""
    if _is_path(run):
        return load_bundle(Path(run)).run()
    with Store.open() as store:
        return store.run(run)


def run_bundle(run: str) -> Bundle:
    """The exported bundle of the run that `run` names, byte for byte; its `sha256` is the contract's run_sha256."""
    if _is_path(run):
        return load_bundle(Path(run))
    with Store.open() as store:
        return store.bundle(run)


def _is_path(run: str) -> bool:
    return Path(run).exists() or "/" in run or "\\" in run or run.lower().endswith(".zip")


def new_key(name: str, passphrase: str) -> Signer:
    """Make a private key for `name` under `passphrase`, and trust its public half."""
    return certificate.keys.new_key(home(), name, passphrase)


def trusted_keys() -> tuple[Entry, ...]:
    """Everybody in the lab's trust list."""
    return certificate.keys.entries(home())


def trust_keys(allowed_signers: Path) -> tuple[Signer, ...]:
    """Take the lines of an allowed_signers file into the lab's trust list; returns the new ones."""
    return certificate.keys.trust(home(), allowed_signers)


def revoke_keys(name: str) -> int:
    """Accept no signature any more by the keys of `name`; returns how many keys those are."""
    return certificate.keys.revoke(home(), name)


def load_calibration(path: Path) -> Calibration:
    """Read a calibration file, checked. Raises InputError."""
    return certificate.read_calibration(path)


def approve(calibration: Path, name: str) -> Calibration:
    """Write the approver's name into a draft."""
    return certificate.approve(calibration, name)


def sign(calibration: Path, name: str, passphrase: str) -> Path:
    """Sign the calibration as `name`; returns the path of the signature."""
    key = certificate.keys.open_key(home(), name, passphrase)
    return certificate.sign(calibration, name, key, certificate.keys.trusted(home()))


def verify(calibration: Path, allowed_signers: Path | None = None, run: str | None = None) -> Verification:
    """Check every signature of the calibration against the lab's trust list, or the one that is named."""
    signers = read_allowed_signers(allowed_signers) if allowed_signers else certificate.keys.trusted(home())
    sha256 = run_bundle(run).sha256 if run else None
    return certificate.verify(calibration, signers, certificate.keys.revoked(home()), datetime.now(UTC), sha256)


def report(source: str, out: Path, allowed_signers: Path | None = None) -> None:
    """Write the report of a calibration file or of a run, as `.html` or `.pdf`."""
    if Path(source).is_file() and source.lower().endswith(".json"):
        return _report_calibration(Path(source), out, allowed_signers)
    bundle = run_bundle(source)
    run = bundle.run()
    return write_report(run_page(run, bundle.sha256, fit.fit(run, holdout=False)), out)


def _report_calibration(path: Path, out: Path, allowed_signers: Path | None) -> None:
    calibration, checked = load_calibration(path), verify(path, allowed_signers)
    now = f"{datetime.now(UTC):%Y-%m-%d %H:%M} UTC"
    write_report(calibration_page(calibration, path.read_bytes(), checked, now, _run_of(calibration)), out)


def _run_of(calibration: Calibration) -> Run | None:
    """The run a calibration came from, where this store has it unchanged."""
    try:
        bundle = run_bundle(calibration.run_id)
    except InputError:
        return None
    return bundle.run() if bundle.sha256 == calibration.run_sha256 else None
