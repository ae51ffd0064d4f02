"""The local store as people use it: list, describe, correct, take in, check, hand out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from labcal import certificate
from labcal.errors import InputError
from labcal.files.atomic import write_bytes
from labcal.files.home import home
from labcal.files.outputs import claim, writing
from labcal.record.person import check_person
from labcal.session import raw_frames
from labcal.session.approved import keep_approved
from labcal.session.audited import note, note_import
from labcal.session.of_its_record import deletions
from labcal.session.sources import is_path, paths, run_bundle
from labcal.session.working_out import keep_corrected
from labcal.store import RunSummary, Store, StoreCheck, bundle_files, describe, export, photos, save_bundle
from labcal.store import check_store as store_check
from labcal.store.limits import CHAIN_JSONL
from labcal.store.listing import FILE as STORE


def runs() -> list[RunSummary]:
    """The runs of the local store, the oldest first."""
    with Store.open() as store:
        return store.runs()


def describe_run(run: str) -> dict[str, Any]:
    """What the run that `run` names is: head, segments and what each offers, channels, measurements."""
    if is_path(run):
        bundle = run_bundle(run)
        return describe(bundle.run(), "a bundle, not in the store", origin=bundle.origin)
    with Store.open() as store:
        return store.describe(run) | {"stopped": store.summary(run).stopped}


def correct_serial(run: str, serial: str, who: str, made: Sequence[Path] = ()) -> None:
    """State another serial of a run's DUT, as an event of its record; the drafts `made` of it follow.

    Raises InputError once one of them is signed.
    """
    check_person(who)
    if signed := [path.name for path in made if certificate.signature_files(path)]:
        raise InputError(f"{signed[0]} is signed: its serial stands; another DUT needs a run of its own")
    with Store.open() as store:
        store.correct_serial(run, serial, who)
        bundle = store.bundle(run)
    for path in made:
        draft = certificate.read_calibration(path)
        corrected = replace(draft, dut=replace(draft.dut, serial=serial.strip()), run_sha256=bundle.sha256)
        corrected = replace(corrected, chain=bundle.stated_chain)
        write_bytes(path, certificate.calibration_bytes(corrected))
        keep_corrected(draft, corrected)
        if draft.approvers:
            keep_approved(corrected)
    note("correct", who, run=run, serial=serial.strip())


def keep_photo(path: Path) -> dict[str, str]:
    """Copy a photograph beside the store; what a note in a record says of it."""
    return photos.keep_photo(path)


def import_bundle(path: Path) -> str:
    """Take a bundle into the local store, byte for byte; returns its run id."""
    with Store.open() as store:
        before, run = store.first_and_last()[1], store.add_bundle(path)
        if store.first_and_last()[1] == run != before:  # else it was there already
            note_import(run, store)
    return run


def check_store(run: str | None = None) -> StoreCheck:
    """Look through the local store, or one run of it, for the first thing that does not fit.

    Where all rows fit, the raw frames are parsed again by the drivers that are here, and held against the samples;
    then the heads of the chains against those of the audit log.
    """
    found = store_check(home() / STORE, run)
    if found.fault:
        return found
    parsed = 0
    with Store.read_only(home() / STORE) as store:
        try:
            for run_id in [run] if run else [one.run_id for one in store.runs()]:
                parsed += raw_frames.compare(store, run_id)
        except raw_frames.Differs as differs:
            return replace(found, fault=str(differs))
        gone = next((said for said in deletions(store) if run is None or said.startswith(f"run {run}:")), "")
    return replace(found, parsed=parsed, fault=gone)


def export_run(run: str, format_: str, out: Path, *, force: bool = False) -> None:
    """Write the run that `run` names to `out` as `format_`: bundle, csv, hdf5 or mat."""
    files, folder = (bundle_files(out), True) if format_ == "bundle" else ([out], False)
    outputs = claim("export", *files, inputs=paths(run), force=force, with_folder=folder)
    bundle = run_bundle(run, with_chain=format_ == "bundle")
    written = [one for one in outputs if bundle.chain or one.path.name != CHAIN_JSONL]
    with writing(written):
        if format_ == "bundle":
            save_bundle(bundle, out)
        elif format_ == "csv":
            write_bytes(out, export.csv_table(bundle))
        else:
            write_bytes(out, export.hdf5(bundle.run()) if format_ == "hdf5" else export.mat(bundle.run()))
    note("export", run=run, format=format_, file=out.name, run_sha256=bundle.sha256)
