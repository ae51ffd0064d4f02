"""The line in order: bench → procedure → record → fit → loop → certificate. The command line and the window call it."""

from __future__ import annotations

from pathlib import Path

from labcal.record import Run
from labcal.store import Bundle, load_bundle


def load_run(run: str) -> Run:
    """The run that `run` names: a run id of the local store, or a path to a bundle. Raises InputError."""
    return run_bundle(run).run()


def run_bundle(run: str) -> Bundle:
    """The exported bundle of the run that `run` names, byte for byte; its `sha256` is the contract's run_sha256."""
    return load_bundle(Path(run))
