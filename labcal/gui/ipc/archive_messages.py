"""What a window asks of the archive: it is read, and nothing is written there. One frozen dataclass each.

The URL may state a password: it goes to the worker by its standard input, and stands in no text.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from labcal.gui.ipc.answers import Figure, Matrix, RunLine
from labcal.gui.ipc.kinds import Command


@dataclass(frozen=True, slots=True)
class ArchivedCalibration:
    """A calibration in the archive, as the trend of its DUT shows it. `u` (12,) of K row by row, then k."""

    site: str
    run_id: str
    measured_utc: str
    K: Matrix
    u: tuple[float, ...] | None
    figures: tuple[Figure, ...]


@dataclass(frozen=True, slots=True)
class ListArchivedRuns(Command[tuple[RunLine, ...]]):
    """The runs of the archive that this role may see, the newest first."""

    url: str = field(repr=False)


@dataclass(frozen=True, slots=True)
class ListArchivedCalibrations(Command[tuple[ArchivedCalibration, ...]]):
    """The calibrations of one DUT in the archive, the oldest first."""

    url: str = field(repr=False)
    dut: str


@dataclass(frozen=True, slots=True)
class FetchRun(Command[str]):
    """Write the bundle of a run of the archive, as it was pushed, to `out`, a zip; answers where."""

    url: str = field(repr=False)
    sha256: str
    site: str
    out: str
