"""What the worker does with the archive: it reads. Nothing is written there, nor to this computer's store."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from labcal.files.home import ARCHIVE
from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.archive_messages import (
    ArchivedCalibration,
    FetchRun,
    ListArchivedCalibrations,
    ListArchivedRuns,
)
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.file_commands import figures
from labcal.gui.ipc.handlers import handles

if TYPE_CHECKING:
    from labcal.model import Calibration

SHOWN = ("run_id", "started_utc", "status", "dut_serial", "operator", "procedure", "simulated", "site", "sha256")


def runs(channel: Channel, asked: ListArchivedRuns) -> tuple[RunLine, ...]:
    """The runs of the archive that this role may see, the newest first."""
    from labcal.session import archiving

    _name(asked.url)
    rows = archiving.archived_runs(None)
    return tuple(RunLine(**{name: row[name] for name in SHOWN}) for row in reversed(rows))


def calibrations(channel: Channel, asked: ListArchivedCalibrations) -> tuple[ArchivedCalibration, ...]:
    """The calibrations of one DUT in the archive, the oldest first."""
    from labcal.session import archiving

    _name(asked.url)
    return tuple(_shown(row, found) for row, found in archiving.archived_files(None, asked.dut))


def _shown(row: Mapping[str, Any], found: Calibration) -> ArchivedCalibration:
    joint = found.covariance
    u = None if joint is None else tuple(np.sqrt(np.diag(joint)[:12]).tolist())
    K = found.affine.K.tolist()
    return ArchivedCalibration(row["site"], row["run_id"], row["measured_utc"], K, u, figures(found))


def fetch(channel: Channel, asked: FetchRun) -> str:
    """Write the bundle of a run of the archive; the dialogue has asked."""
    from labcal.session import archiving

    _name(asked.url)
    archiving.fetch_from_archive(None, asked.sha256, asked.site, Path(asked.out), force=True)
    return asked.out


def _name(url: str) -> None:
    """Have the archive at `url` be the one of this process, which it was not started with: nobody else reads it."""
    os.environ[ARCHIVE] = url


HANDLERS = (
    handles(ListArchivedRuns, runs),
    handles(ListArchivedCalibrations, calibrations),
    handles(FetchRun, fetch),
)
