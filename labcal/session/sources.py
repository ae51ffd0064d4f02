"""What a run is named by: an id of the local store, a path to a bundle, or the run itself."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from labcal.errors import InputError
from labcal.model import Calibration
from labcal.record import Run
from labcal.store import Bundle, Store, bundle_files, bundle_of, load_bundle

Source = str | Path | Run  # a run id of the local store or a path to a bundle, a path, or the run itself


def load_run(run: Source, channels: Sequence[str] | None = None) -> Run:
    """The run that `run` names, with all its channels or only those of these names. Raises InputError."""
    measured = run if isinstance(run, Run) else _run_of_name(run)
    try:
        return measured if channels is None else measured.with_channels(channels)
    except KeyError as error:
        raise InputError(str(error.args[0])) from None


def _run_of_name(run: str | Path) -> Run:
    if is_path(run):
        return load_bundle(Path(run)).run()
    with Store.open() as store:
        return store.run(str(run))


def run_bundle(run: Source, *, with_chain: bool = False) -> Bundle:
    """The exported bundle of the run that `run` names, byte for byte; its `sha256` is the contract's run_sha256.

    `with_chain` adds chain.jsonl of a run of the store. Raises InputError where the run does not fit its chain.
    """
    if isinstance(run, Run):
        return bundle_of(run)
    if is_path(run):
        return load_bundle(Path(run))
    with Store.open() as store:
        return store.bundle(str(run), with_chain=with_chain)


def paths(run: Source) -> list[Path]:
    """The files that `run` names, where it is none of the store's ids: what a command reads it from.

    Of a folder those of a bundle, its chain though it may have none: what else lies there is not read.
    """
    if isinstance(run, Run) or not is_path(run):
        return []
    return bundle_files(Path(run)) if Path(run).is_dir() else [Path(run)]


def is_path(run: str | Path) -> bool:
    """A plain word is a run id, unless a bundle of that name lies right here."""
    if isinstance(run, Path):
        return True
    here = Path(run)
    return "/" in run or "\\" in run or run.lower().endswith(".zip") or here.is_file() or (here / "run.json").is_file()


def run_of(calibration: Calibration) -> Run | None:
    """The run a calibration came from, where this store has it unchanged."""
    try:
        bundle = run_bundle(calibration.run_id)
    except InputError:
        return None
    return bundle.run() if bundle.sha256 == calibration.run_sha256 else None
