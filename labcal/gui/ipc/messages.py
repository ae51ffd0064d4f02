"""Every message between the window and its workers: commands, words into a run, events. One frozen dataclass each.

A command names its answer: `class FitRun(Command[Fitted])`. Its one handler, in one of the `*_commands`, does it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

from labcal.bench.coils.state import LabState
from labcal.gui.ipc import answers
from labcal.gui.ipc.answered_for import AnswersFor as AnswersFor
from labcal.gui.ipc.archive_messages import FetchRun as FetchRun
from labcal.gui.ipc.archive_messages import ListArchivedCalibrations as ListArchivedCalibrations
from labcal.gui.ipc.archive_messages import ListArchivedRuns as ListArchivedRuns
from labcal.gui.ipc.customer_messages import HandOut as HandOut
from labcal.gui.ipc.customer_messages import StateNames as StateNames
from labcal.gui.ipc.customer_messages import WhoIsNamed as WhoIsNamed
from labcal.gui.ipc.kinds import Command as Command
from labcal.gui.ipc.kinds import Event as Event
from labcal.gui.ipc.kinds import Word as Word
from labcal.gui.ipc.lab_messages import CheckZero as CheckZero
from labcal.gui.ipc.lab_messages import EarlierAreGone as EarlierAreGone
from labcal.gui.ipc.lab_messages import FindSimulatedBench as FindSimulatedBench
from labcal.gui.ipc.lab_messages import Identify as Identify
from labcal.gui.ipc.lab_messages import PrepareToRead as PrepareToRead
from labcal.gui.ipc.lab_messages import ReadLab as ReadLab
from labcal.gui.ipc.record_messages import LookForLeft as LookForLeft
from labcal.gui.ipc.record_messages import TellRecord as TellRecord
from labcal.gui.ipc.record_messages import TellResults as TellResults
from labcal.gui.ipc.record_messages import TellTurned as TellTurned
from labcal.gui.ipc.wire import Fault
from labcal.gui.ipc.words import Abort as Abort
from labcal.gui.ipc.words import Answer as Answer
from labcal.gui.ipc.words import Beat as Beat
from labcal.gui.ipc.words import GoOn as GoOn
from labcal.gui.ipc.words import HangUp as HangUp
from labcal.gui.ipc.words import LinesTaken as LinesTaken
from labcal.gui.ipc.words import Note as Note
from labcal.gui.ipc.words import Pause as Pause
from labcal.gui.ipc.words import Stop as Stop
from labcal.record.stream import Item
from labcal.uncertainty.conformity import Changes


@dataclass(frozen=True, slots=True)
class ReadBench(Command[answers.Bench]):
    """What a bench file states."""

    bench: str


@dataclass(frozen=True, slots=True)
class SwitchOff(Command[answers.SwitchedOff]):
    """Every coil of a bench to zero and open."""

    bench: str


@dataclass(frozen=True, slots=True)
class EditBench(Command[answers.BenchText]):
    """A bench file read, and what `changes` (keys, value as it is written) of `before` make of it; `save` writes it."""

    bench: str
    before: str = ""
    changes: tuple[tuple[tuple[str, ...], str], ...] = ()
    save: bool = False


@dataclass(frozen=True, slots=True)
class FindOnLines(Command[tuple[str, ...]]):
    """Who answers on this computer's lines, a line each; `out` is the draft of a bench file."""

    out: str


@dataclass(frozen=True, slots=True)
class RunProcedure(Command[answers.Ended]):
    """Run a procedure. `given` holds settings as text; simulated time goes on after the run `after`.

    `answered_for`: by whom, where the check standard keeps runs from beginning.
    """

    procedure: str
    bench: str
    given: Mapping[str, str] = field(default_factory=dict)
    dut: str = ""
    operator: str = ""
    pace: str = "at once"
    seed: int | None = None
    after: str = ""
    answered_for: AnswersFor | None = None


@dataclass(frozen=True, slots=True)
class ResumeRun(Command[answers.Ended]):
    """Go on with an interrupted run of the DUT `dut`."""

    run: str
    bench: str
    dut: str
    pace: str = "at once"
    seed: int | None = None
    procedure: str = ""
    operator: str = ""


@dataclass(frozen=True, slots=True)
class Rejoin(Command[answers.Ended]):
    """Come back to the run that this worker goes on with: GoesOn and all that was Recorded first, then its end."""


@dataclass(frozen=True, slots=True)
class Rehearse(Command[tuple[str, ...]]):
    """What a procedure would do, a line each; nothing real is touched."""

    procedure: str
    bench: str
    given: Mapping[str, str] = field(default_factory=dict)
    seed: int | None = None


@dataclass(frozen=True, slots=True)
class ListProcedures(Command[answers.Procedures]):
    """What there is to run."""


@dataclass(frozen=True, slots=True)
class ListMethods(Command[tuple[str, ...]]):
    """The names of all estimators; whoever asks first waits for what everything else here needs."""


@dataclass(frozen=True, slots=True)
class LookAt(Command[answers.Look]):
    """A run as it was recorded."""

    run: str


@dataclass(frozen=True, slots=True)
class FitRun(Command[answers.Fitted]):
    """One method's calibration of a run."""

    run: str
    method: str


@dataclass(frozen=True, slots=True)
class WriteDraft(Command[str]):
    """Write the draft calibration of a method; answers its path."""

    run: str
    method: str


@dataclass(frozen=True, slots=True)
class CloseLoop(Command[answers.Loop]):
    """Trace the residual of a run to its cause; a draft is written."""

    run: str


@dataclass(frozen=True, slots=True)
class JoinRuns(Command[str]):
    """Keep the run of all rows of both; answers its id."""

    run: str
    new: str


@dataclass(frozen=True, slots=True)
class TryCause(Command[answers.Change]):
    """What one cause alone would change, named by the loop or not."""

    run: str
    effect: str
    channels: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class FilterHistory(Command[answers.Growth]):
    """How a filter's estimate grew."""

    run: str
    method: str


@dataclass(frozen=True, slots=True)
class CompareRuns(Command[answers.Comparison]):
    """Two runs side by side, each by its own calibration."""

    older: str
    newer: str


@dataclass(frozen=True, slots=True)
class ListRuns(Command[tuple[answers.RunLine, ...]]):
    """The runs of the store, the newest first."""


@dataclass(frozen=True, slots=True)
class LastClosingCheck(Command[answers.Checked | None]):
    """The last closing check there is."""


@dataclass(frozen=True, slots=True)
class LastCageCheck(Command[answers.Checked | None]):
    """The last finished cage calibration there is."""


@dataclass(frozen=True, slots=True)
class ListCalibrations(Command[tuple[answers.CalibrationFile, ...]]):
    """Every calibration file of this lab's folder, the newest first."""


@dataclass(frozen=True, slots=True)
class VerifyFile(Command[answers.Standing]):
    """How the signatures of a file stand."""

    path: str


@dataclass(frozen=True, slots=True)
class ListKeys(Command[tuple[str, ...]]):
    """Names with a private key here."""


@dataclass(frozen=True, slots=True)
class ListPeople(Command[tuple[answers.Person, ...]]):
    """Who has which role by the trust list; nobody where it states none, and then everybody may do everything."""


@dataclass(frozen=True, slots=True)
class NewKey(Command[str]):
    """Make a key; answers its name."""

    name: str
    passphrase: str = field(repr=False)


@dataclass(frozen=True, slots=True)
class Approve(Command[answers.CalibrationFile]):
    """Write an approver into a draft, with until when it is good and the file that it supersedes, "" for neither."""

    path: str
    name: str
    until: str = ""
    supersedes: str = ""


@dataclass(frozen=True, slots=True)
class Sign(Command[answers.CalibrationFile]):
    """Sign a calibration; the passphrase is used and forgotten. `until` and `supersedes` as of a draft to approve."""

    path: str
    name: str
    passphrase: str = field(repr=False)
    until: str = ""
    supersedes: str = ""


@dataclass(frozen=True, slots=True)
class WriteReport(Command[str]):
    """Write the report of a run or a calibration; answers where."""

    source: str
    out: str


@dataclass(frozen=True, slots=True)
class WriteLabel(Command[str]):
    """Write the label for the DUT of a calibration; answers where."""

    source: str
    out: str


@dataclass(frozen=True, slots=True)
class ExportRun(Command[str]):
    """Write a run as bundle, csv, hdf5 or mat; answers where."""

    run: str
    format: Literal["bundle", "csv", "hdf5", "mat"]
    out: str


@dataclass(frozen=True, slots=True)
class ImportBundle(Command[str]):
    """Take a bundle into the store; answers the run's id."""

    path: str


@dataclass(frozen=True, slots=True)
class LookAtRecording(Command[answers.RecordingMapped]):
    """A recording of others by the mapping `before` ("": guessed), with `changes` of it (keys, value as written)."""

    path: str
    before: str = ""
    changes: tuple[tuple[tuple[str, ...], str], ...] = ()


@dataclass(frozen=True, slots=True)
class ImportRecording(Command[str]):
    """Take a recording of others into the store by the mapping `text`; answers the run's id."""

    path: str
    text: str


@dataclass(frozen=True, slots=True)
class KeepPhoto(Command[Mapping[str, str]]):
    """Keep a photograph; answers what a note says of it."""

    path: str


@dataclass(frozen=True, slots=True)
class CorrectSerial(Command[str]):
    """State another serial of a run's DUT; answers it."""

    run: str
    serial: str
    who: str


@dataclass(frozen=True, slots=True)
class ApplyCalibration(Command[str]):
    """Correct readings by a calibration; answers how many rows, in words."""

    path: str
    source: str
    out: str
    dut: str


@dataclass(frozen=True, slots=True)
class ChangedSince(Command[Changes | None]):
    """What changed since the calibration before the one at `path` of the same DUT; nothing where none is before."""

    path: str


@dataclass(frozen=True, slots=True)
class Request:
    """A command with the number that its answer bears."""

    number: int
    command: Command[Any]


@dataclass(frozen=True, slots=True)
class Done(Event):
    """The answer to the command of that number, still as JSON: who asked knows its type."""

    number: int
    answer: Any


@dataclass(frozen=True, slots=True)
class Failed(Event):
    """Why the command of that number was not done; 0 of a line that could not be read."""

    number: int
    fault: Fault


@dataclass(frozen=True, slots=True)
class Progress(Event):
    """How far the work is, in words."""

    text: str


@dataclass(frozen=True, slots=True)
class GoesOn(Event):
    """The run that a window has come back to: its order, the time on the wall when it began, what the bench states."""

    order: RunProcedure
    began: str
    bench: answers.Bench


@dataclass(frozen=True, slots=True)
class Recorded(Event):
    """Items of the timeline, in order."""

    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class StateRead(Event):
    """How the lab is, by the clock that all processes of this computer share."""

    state: LabState
