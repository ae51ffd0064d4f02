"""What workers answer: one frozen dataclass for each kind of result. Arrays are thinned for pictures."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.coils.state import PlatformReading
from labcal.bench.parameters import ParameterSpec
from labcal.gui.ipc.bench_facts import Bench as Bench
from labcal.gui.ipc.bench_facts import Cage as Cage
from labcal.gui.ipc.bench_facts import CoilEnd as CoilEnd
from labcal.gui.ipc.bench_facts import Doubt as Doubt
from labcal.gui.ipc.bench_facts import EarlierSupply as EarlierSupply
from labcal.gui.ipc.bench_facts import Earth as Earth
from labcal.gui.ipc.bench_facts import Instrument as Instrument
from labcal.gui.ipc.bench_facts import Reference as Reference
from labcal.gui.ipc.run_line import RunLine as RunLine
from labcal.gui.ipc.wire import Fault
from labcal.model.records import EffectRecord
from labcal.record.run import Dut
from labcal.record.stream import Measurement
from labcal.uncertainty.conformity import Changes, Judged

Array = NDArray[np.float64]
Matrix = tuple[tuple[float, ...], ...]
Verdict = Literal["clean", "explained", "partly-explained", "ambiguous", "unexplained"]


@dataclass(frozen=True, slots=True)
class SettingLine:
    """A setting of a bench file: as written ("" where not), what holds then, unit, meaning; whether changed `here`."""

    keys: tuple[str, ...]
    value: str
    usual: str
    unit: str
    meaning: str
    here: bool


@dataclass(frozen=True, slots=True)
class BenchText:
    """A bench file as it is written, and its settings, limits first.

    `difference`: the lines that changes make other ones; `objection`: why it is no bench file with them ("": it is).
    """

    text: str
    settings: tuple[SettingLine, ...]
    difference: str = ""
    objection: str = ""


@dataclass(frozen=True, slots=True)
class MappedLine:
    """One line of a recording's mapping: keys, value as written, what is said of it, the first rows of its columns."""

    keys: tuple[str, ...]
    value: str
    remark: str
    first: tuple[str, ...]


@dataclass(frozen=True, slots=True, eq=False)
class RecordingMapped:
    """A recording of others by its mapping `text`. `rows` (n, 4): time [s], x, y, z [µT].

    `objection`: why it is not imported so ("": it is).
    """

    text: str
    lines: tuple[MappedLine, ...]
    rows: Array
    remarks: tuple[str, ...]
    objection: str


@dataclass(frozen=True, slots=True)
class InstrumentAnswer:
    """Who an instrument says it is, or why it does not."""

    name: str
    role: str
    link: str
    identity: str
    fault: Fault | None = None
    serial: str = ""


@dataclass(frozen=True, slots=True)
class Identified:
    """Every instrument's answer, and what became of the doubt about zero where there was one."""

    instruments: tuple[InstrumentAnswer, ...]
    doubt: Doubt | None = None


@dataclass(frozen=True, slots=True)
class SwitchedOff:
    """Every axis of the bench, and the doubt that stands about zero ("": none), with what a person can do about it.

    `platform`: as it was brought to a stop; None where whoever drives it does that, or it has no motor.
    """

    coils: tuple[CoilEnd, ...]
    doubt: str = ""
    advice: str = ""
    platform: PlatformReading | None = None
    earlier: tuple[EarlierSupply, ...] = ()


@dataclass(frozen=True, slots=True)
class Ended:
    """How a run has ended. `failed`: measurements beyond their limits. `ending`: how it ended, in words."""

    run_id: str
    status: str
    fault: Fault | None = None
    failed: tuple[str, ...] = ()
    ending: str = ""


@dataclass(frozen=True, slots=True)
class Procedure:
    """What there is to run, and its parameters."""

    name: str
    title: str
    resumable: bool
    needs: str
    lasts_min: float | None
    parameters: tuple[ParameterSpec, ...]


@dataclass(frozen=True, slots=True)
class Procedures:
    """Those that load, and by name why the others do not."""

    found: tuple[Procedure, ...]
    broken: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class FitFigures:
    """One method's answer in figures (contract: FIT)."""

    ok: bool
    why_not: str | None = None
    K: Matrix | None = None
    k_nT: tuple[float, ...] | None = None
    covariance: Matrix | None = None
    frame_known: bool = False
    holdout_rms_scalar_nT: float | None = None
    axis_error_deg: tuple[float, ...] | None = None
    seconds: float | None = None


@dataclass(frozen=True, slots=True)
class ShellLeft:
    """What a map left on a shell of one magnitude, by degree of spherical harmonics; the noise is its scatter's."""

    magnitude_nT: float
    rms_nT: tuple[float, ...]
    noise_nT: tuple[float, ...]


@dataclass(frozen=True, slots=True, eq=False)
class Fitted:
    """One method's answer; where it has a map also the residual (n,) and the calibrated readings (n, 3) [nT].

    `noise_nT` is what the method makes of its own residual, `stated_nT` what the run states of its sensors.
    `shells` where the run was at rest in fields all round at one magnitude, or at several. `specification`: the lines
    that the run's specification comes to for this map. `left_open` where the run does not determine it whole.
    """

    fit: FitFigures
    noise_nT: float | None = None
    residual: Array | None = None
    after: Array | None = None
    shells: tuple[ShellLeft, ...] = ()
    stated_nT: float | None = None
    specification: tuple[Judged, ...] = ()
    left_open: str = ""  # of the map, by this run: a sentence


@dataclass(frozen=True, slots=True, eq=False)
class Growth:
    """A filter's offset and its standard uncertainty (n, 3) [nT] as readings came."""

    t_s: Array
    bias_nT: Array
    u_nT: Array


@dataclass(frozen=True, slots=True, eq=False)
class Change:
    """The residual before and after (n, 3), or (n, 1) of the magnitude [nT], and what it may be drawn against."""

    before: Array
    after: Array
    against: Mapping[str, Array]


@dataclass(frozen=True, slots=True, eq=False)
class Compared:
    """One of two runs beside each other: magnitude residual (n,) and field (n, 3) [nT] by its own calibration.

    `calibration` is its file's name; "" where none was there and the run was fitted now. Time begins with the run.
    """

    run_id: str
    dut: str
    calibration: str
    noise_nT: float | None
    residual: Array | None
    after: Array
    against: Mapping[str, Array]
    noise_stated: bool = False  # by the run, of its sensors; else it is what the fit makes of its own residual


@dataclass(frozen=True, slots=True, eq=False)
class Comparison:
    """Two runs; what changed from the older to the newer, or why that cannot be said (`refused`)."""

    older: Compared
    newer: Compared
    changes: Changes | None
    refused: str = ""

    @property
    def two_duts(self) -> bool:
        """Whether nothing of them is a change of one DUT."""
        return self.older.dut != self.newer.dut


@dataclass(frozen=True, slots=True)
class Proposal:
    """The experiment that would tell more."""

    why: str
    do: str
    procedure: str | None = None
    settings: Mapping[str, str] = field(default_factory=dict)  # with which the procedure does that


@dataclass(frozen=True, slots=True, eq=False)
class Loop:
    """The closed loop: verdict, causes, and the change that all named ones make; `draft` is the file written."""

    verdict: Verdict
    summary: str
    before_nT: float  # held-out rms
    after_nT: float
    noise_floor_nT: float
    noise_floor_source: str
    set_aside: Mapping[str, int]
    accepted: tuple[EffectRecord, ...]
    rejected: tuple[EffectRecord, ...]
    next_experiment: Proposal | None
    remarks: tuple[str, ...]
    draft: str
    change: Change
    drawn_against: Mapping[str, str] = field(default_factory=dict)  # by effect: "time", "angle" or "field"
    phrases: Mapping[str, str] = field(default_factory=dict)  # by effect: what happens, in plain words


@dataclass(frozen=True, slots=True, eq=False)
class Look:
    """A run as it was recorded: readings (n, 3) [nominal nT], and what they may be drawn against, by name with unit.

    `segment_index` (n,) into `segments`, by name; empty where they are not told apart. `fits`, by method, and `loop`:
    what was worked out of it before and is kept.
    """

    run_id: str
    dut: str
    n_samples: int
    before: Array
    against: Mapping[str, Array]
    segments: tuple[str, ...] = ()
    segment_index: Array = field(default_factory=lambda: np.empty(0))
    fits: Mapping[str, Fitted] = field(default_factory=dict)
    loop: Loop | None = None


@dataclass(frozen=True, slots=True)
class Checked:
    """The last run that checked something: its worst measurement that has a limit, and the verdict."""

    run: RunLine
    measurement: Measurement | None
    verdict: str


@dataclass(frozen=True, slots=True)
class Signature:
    """One signature file: whose it is, and what is wrong with it ("": nothing)."""

    file: str
    signer: str | None
    objection: str | None


@dataclass(frozen=True, slots=True)
class Standing:
    """How the signatures of a calibration file stand; `status` as in `labcal verify --json`."""

    path: str
    valid: bool
    provisional: bool
    signers: tuple[str, ...]
    signatures: tuple[Signature, ...]
    sentences: tuple[str, ...]
    status: str = ""


@dataclass(frozen=True, slots=True)
class Person:
    """Somebody of the trust list, and what they may do: measure, approve, release."""

    name: str
    roles: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class BudgetLine:
    """One quantity of a calibration's budget: its U, and its sources with their shares, the largest first."""

    quantity: str
    at: str
    U: float
    k: float
    unit: str
    sources: tuple[tuple[str, float], ...]


@dataclass(frozen=True, slots=True)
class Figure:
    """A figure of the map, in `unit`: its U at k = 2, and the limit it was judged by; None where there is none."""

    kind: str  # offset, scale or non_orthogonality
    quantity: str
    value: float
    U: float | None
    unit: str
    limit: float | None = None


@dataclass(frozen=True, slots=True)
class CalibrationFile:
    """What a calibration file says, and how its signatures stand. `u` (12,) of K row by row, then k."""

    path: str
    run_id: str
    dut: Dut
    K: Matrix
    k_nT: tuple[float, ...]
    k_means: str  # what k belongs to, as "at i_eps = 0.0532 A"
    u: tuple[float, ...] | None
    budget: tuple[BudgetLine, ...]
    effects: tuple[EffectRecord, ...]
    findings: tuple[EffectRecord, ...]
    operator: str
    approvers: tuple[str, ...]
    standing: Standing
    specification: tuple[Judged, ...] = ()
    until: str = ""  # the last day on which it is good
    left_open: tuple[str, ...] = ()  # what the specification limits and nothing determined
    figures: tuple[Figure, ...] = ()
    method: str = ""  # of the fit, or closed-loop
    simulated: bool = False
    unexplained: str = ""  # by the loop that made it: a sentence
    not_measured: tuple[str, ...] = ()  # of K and k: held as they stand
    left_nT: float | None = None  # of |b| in held-out rows, by the fit that made it
    phrases: Mapping[str, str] = field(default_factory=dict)  # by effect: what happens, in plain words
