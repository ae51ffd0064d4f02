"""One run from its header to its true final status, and one that goes on after it broke off."""

from __future__ import annotations

import secrets
import time
import tomllib
import traceback
from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from datetime import datetime
from itertools import count
from pathlib import Path
from typing import Any

from labcal.bench.bench import Bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.at_zero import AtZero
from labcal.bench.coils.state import NOT_READ, LabState
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.parameters import POWER_MODES, settings
from labcal.bench.stated import refuse_overdue, stated_administrative, stated_environment, stated_reference
from labcal.errors import InputError, InstrumentError, LimitError, LimitNotMet, Stopped
from labcal.plugin_loading import said
from labcal.record import Dut, RunHeader, Specification
from labcal.record.bench_kind import bench_kind, kind_of
from labcal.record.header import ChannelSpec
from labcal.record.person import check_operator
from labcal.record.stream import NOT_USED, REMARK, RESUMED, Event, Item, Measurement
from labcal.runner.ambient_before import remember_ambient
from labcal.runner.catalogue import FoundProcedure
from labcal.runner.control import Control
from labcal.runner.drive import CLOCK_BACK, Drive, Ending, OnItem, Show
from labcal.runner.prompts import Answer
from labcal.runner.resume_state import resume_state
from labcal.runner.seen_in_run import SeenInRun
from labcal.store import RunWriter, Store
from labcal.store.writer import iso
from labcal.version import __version__

INTERRUPTED = "interrupted"
STORE_GONE = "store gone"
BY_STORE = "interrupted by its store"
KNOWN = (InputError, InstrumentError, LimitNotMet, Stopped)  # faults that say themselves what is wrong
LATE_S = 10.0  # so long rows wait in memory for a busy disk; then true coils go to zero, and the run ends
LONG_S = 2.0  # that a run waited so long for its end to be kept is said
GAP_S = 1.0  # at least so much time lies between what was recorded before an interruption and after


@dataclass(frozen=True, slots=True)
class Outcome:
    """A run that has ended: its id, its true final status, what went wrong, and the limits that were not met.

    `lab` is the lab as the run left it, by the computer's monotonic clock; None where it never came so far. `ending`:
    how it ended and what the store had to do with it; `resumable`, whether it can be gone on with.
    """

    run_id: str
    status: str
    fault: BaseException | None
    failed: tuple[Measurement, ...] = ()
    lab: LabState | None = None
    ending: str = ""
    resumable: bool = False

    @property
    def at_rest(self) -> str:
        """What may be said of the coils now: "coils at zero" only as long as that was read back just now."""
        return self.lab.sentence(time.monotonic()) if self.lab is not None else NOT_READ

    def parted(self, ended: Iterable[AtZero]) -> Outcome:
        """With the guardian's last word of the coils, as the session parted from it."""
        return self if self.lab is None else replace(self, lab=self.lab.with_ends(ended))

    def raise_fault(self) -> None:
        """Raise what went wrong, or LimitNotMet where a measurement failed; return where all is well."""
        if self.fault is not None:
            raise self.fault
        if self.failed:
            worst = self.failed[0]
            raise LimitNotMet(f"{worst.name}: {worst.value:.4g} {worst.unit} is beyond its limit of {worst.limit:.4g}")


def run_procedure(
    bench: Bench,
    procedure: FoundProcedure,
    given: Mapping[str, str],
    *,
    store: Store,
    answer: Answer,
    operator: str = "",
    dut_serial: str | None = None,
    bench_file: str = "",
    cage_sha256: str | None = None,
    specification: Specification | None = None,
    run_id: str | None = None,
    filled: Mapping[str, Any] | None = None,
    remark: str | None = None,
    control: Control | None = None,
    on_item: OnItem = lambda item: None,
    show: Show = lambda state: None,
    first: tuple[str, str, Mapping[str, Any]] | None = None,
) -> Outcome:
    """Run `procedure` with the settings `given` ({key: text}) into a new run of `store`.

    `filled` are keywords that no text can state, such as a calibration that was read from its file. The record begins
    with the event `first` (kind, text, data), and has the `remark` before its first sample.
    Raises InputError before anything moves where a setting is wrong, or the DUT has no serial number; what goes
    wrong later is in the Outcome, and so is how the coils were left.
    """
    values = settings(procedure.parameters, given)
    check_operator(operator)
    _refuse_modes(bench, values)
    refuse_overdue(bench)
    identities = bench.identities()
    header = RunHeader(
        run_id=run_id or new_run_id(bench, store),
        started_utc=iso(bench.clock.utc()),
        simulated=bench.config.unreal,
        operator=operator,
        dut=_dut(bench, dut_serial),
        reference=stated_reference(bench, identities[bench.reference.name].serial),
        channels=tuple(ChannelSpec(c.name, c.unit, c.quantity, c.role) for c in bench.channels),
        procedure=procedure.name,
        parameters=values,
        source_sha256=procedure.sha256,
        environment=stated_environment(bench),
        bench=bench_file,
        instruments=_named(identities),
        software=f"labcal {__version__}",
        cage_sha256=cage_sha256,
        specification=specification,
        administrative=stated_administrative(bench),
    )
    writer = store.begin(header, lambda: iso(bench.clock.utc()))
    _report_lifted(bench, writer, bench.clock.now())
    if first is not None:
        writer.write(Event(bench.clock.now(), *first))
    _remark(remark, writer, bench.clock.now(), on_item)
    return _drive(
        bench, procedure, {**values, **(filled or {})}, header.dut.serial, writer, answer, control, on_item, show, 0.0
    )


def resume_run(
    bench: Bench,
    procedure: FoundProcedure,
    run_id: str,
    *,
    store: Store,
    answer: Answer,
    dut_serial: str | None = None,
    remark: str | None = None,
    control: Control | None = None,
    on_item: OnItem = lambda item: None,
    show: Show = lambda state: None,
) -> Outcome:
    """Go on with an interrupted run after its last finished step.

    Given up before a coil is energised, or where a check fails before anything new was begun, it stays interrupted.

    What was measured before is reported first, and counts in the outcome.
    Raises InputError where the run was not interrupted, the procedure cannot be resumed, is another or has changed
    since, or another DUT (`dut_serial` where it is stated) or another bench's instruments stand there.
    """
    header = store.header(run_id)
    refuse_overdue(bench)
    _refuse_another(bench, procedure, header, dut_serial)
    before = list(store.items(run_id, but="block"))
    done, at_s = resume_state(before), store.end_s(run_id) + GAP_S
    values = {spec.name: spec.restore(header.parameters[spec.name]) for spec in procedure.parameters}
    writer = store.resume(run_id, lambda: iso(bench.clock.utc()))
    offset = at_s - bench.clock.now()
    software = {"software": f"labcal {__version__}"}
    writer.write(Event(at_s, RESUMED, "goes on after an interruption", software))
    _report_lifted(bench, writer, at_s)
    _remark(remark, writer, at_s, on_item)
    values["resume"] = done
    remember_ambient(bench, header, before)
    return _drive(bench, procedure, values, header.dut.serial, writer, answer, control, on_item, show, offset, before)


def _report_lifted(bench: Bench, writer: RunWriter, t_s: float) -> None:
    """Who lifted the doubt that the coils were at zero, and what was measured, into the first record after it."""
    if (doubt := bench.cage.latch.take_lifted()) is not None:
        writer.write(Event(t_s, "zero-in-doubt", f"{doubt.utc}: {doubt.words}; lifted: {doubt.lifted}", asdict(doubt)))


def _remark(text: str | None, writer: RunWriter, t_s: float, on_item: OnItem) -> None:
    if text is not None:
        item = Event(t_s, REMARK, text)
        writer.write(item)
        on_item(item)


def _refuse_modes(bench: Bench, values: Mapping[str, Any]) -> None:
    """Raise InputError for a power mode that the DUT may not be in, before anything is asked or energised."""
    for stated in map(values.get, POWER_MODES):
        for mode in (stated,) if isinstance(stated, str) else stated or ():
            bench.config.dut.limits.refuse_mode(mode)


def new_run_id(bench: Bench, store: Store) -> str:
    """The UTC time of its start and four letters: 20261121T070000-3f9c.

    Simulated runs begin at one moment, hundreds of them: where another has these letters, more are drawn.
    """
    utc = bench.clock.utc()
    return next(drawn for size in count(2) if not store.has(drawn := run_id_at(utc, size)))


def run_id_at(utc: datetime, size: int = 2) -> str:
    """The same of a moment, with twice as many letters as `size`."""
    return f"{utc:%Y%m%dT%H%M%S}-{secrets.token_hex(size)}"


def _drive(
    bench: Bench,
    procedure: FoundProcedure,
    values: Mapping[str, Any],
    dut_serial: str,
    writer: RunWriter,
    answer: Answer,
    control: Control | None,
    on_item: OnItem,
    show: Show,
    offset_s: float,
    before: Iterable[Item] = (),
) -> Outcome:
    seen = SeenInRun(on_item)
    for item in filter(_still_counts, before):  # else a limit that was not met before the interruption is forgotten
        seen.notice(item)
    if isinstance(bench.clock, VirtualClock):
        writer.repeats = True
    else:
        writer.late_s = LATE_S

    def kept() -> None:
        seen.waits(bench.clock.now() + offset_s, writer.waited_s)
        writer.check()

    bench.dut_serial = dut_serial
    drive = Drive(bench, writer.write, answer, control or Control(), seen.notice, show, offset_s, kept)
    ending = _in_whose_file(procedure, drive.run(procedure.function(bench, **values)))
    if "resume" in values and ending.fault is not None and seen.nothing_new(ending.fault, values["resume"].done):
        ending = Ending(INTERRUPTED, ending.fault)
    wanted = drive.control.to_be_resumed and isinstance(ending.fault, Stopped)
    if procedure.resumable and (wanted or _may_go_on(ending.fault)):
        ending = Ending(INTERRUPTED, ending.fault, ending.by_store)
    lab = drive.state and drive.state.shifted(time.monotonic() - drive.read_at_s)
    writer.waits = lambda fault: seen.not_kept(bench.clock.now() + offset_s, fault)
    status, fault, words = _written(writer, ending)
    lost = getattr(fault, "fault", "") == STORE_GONE
    resumable = status == INTERRUPTED and procedure.resumable and not lost
    if status == INTERRUPTED and not procedure.resumable:
        words = f"{words}; {procedure.name} cannot be gone on with: start it anew"
    return Outcome(writer.run_id, status, fault, tuple(seen.failed.values()), lab, words, resumable)


def _may_go_on(fault: BaseException | None) -> bool:
    """Whether an instrument ended the run: it goes on when that is mended.

    A set-point beyond a limit would be refused again, and what a clock that was set back has stamped stands.
    """
    lost = isinstance(fault, InstrumentError) and not isinstance(fault, LimitError)
    return lost and getattr(fault, "fault", "") != CLOCK_BACK


def _still_counts(item: Item) -> bool:
    """Whether it says something of a run that goes on: what was measured, and what of it is not used."""
    return isinstance(item, Measurement) or (isinstance(item, Event) and item.kind == NOT_USED)


def _in_whose_file(procedure: FoundProcedure, ending: Ending) -> Ending:
    """A mistake in a procedure of one's own is reported with its line, as any other wrong input."""
    if not procedure.own or ending.fault is None or isinstance(ending.fault, KNOWN):
        return ending
    frames = traceback.extract_tb(ending.fault.__traceback__)
    lines = [frame.lineno for frame in frames if Path(frame.filename).resolve() == procedure.source]
    if not lines:
        return ending
    error = InputError(said(ending.fault), file=procedure.source, line=lines[-1])
    return Ending(f"failed: {error}", error)


def _written(writer: RunWriter, ending: Ending) -> tuple[str, BaseException | None, str]:
    """The status as it stands in the store, the fault, and how it ended in words.

    Where the status could not be written the run shows as interrupted, and the store's fault counts for more than that
    the operator had stopped it.
    """
    said, begun_s = _said(ending), time.monotonic()
    try:
        writer.finish(ending.status)
    except Exception as fault:
        what = fault.what if isinstance(fault, InputError | InstrumentError) else str(fault)
        first = ending.fault is None or ending.by_store or isinstance(ending.fault, Stopped | KeyboardInterrupt)
        gone = getattr(fault, "fault", "") == STORE_GONE
        lost = "what it held is lost where there is no copy" if gone else "what was not committed is lost"
        missing = f"{what.removesuffix('.')}; {lost}"
        if ending.by_store:
            return INTERRUPTED, fault, f"{BY_STORE}: {missing}"
        words = f"{said}, but the store has not kept its end and shows it as interrupted: {missing}"
        return INTERRUPTED, fault if first else ending.fault, words
    waited_s = time.monotonic() - begun_s
    late = f", kept by the store {waited_s:.0f} s later" if waited_s > LONG_S and not ending.by_store else ""
    return ending.status, ending.fault, f"{said}{late}"


def _said(ending: Ending) -> str:
    """The status, and where that is `interrupted` by what."""
    if ending.status != INTERRUPTED:
        return ending.status.removesuffix(".")
    why = ending.fault.what if isinstance(ending.fault, InputError | InstrumentError) else str(ending.fault)
    if ending.by_store:
        return f"{BY_STORE}: {why.removesuffix('.')}; every row is kept by now"
    return f"{INTERRUPTED}: {why.removesuffix('.')}"


def _refuse_another(bench: Bench, procedure: FoundProcedure, header: RunHeader, dut_serial: str | None) -> None:
    if procedure.name != header.procedure:
        raise InputError(f"run {header.run_id} is of {header.procedure}, not of {procedure.name}")
    if not procedure.resumable:
        raise InputError(f"{procedure.name} cannot go on after an interruption: start it anew")
    if procedure.sha256 != header.source_sha256:
        raise InputError(f"{procedure.name} was changed since run {header.run_id} began: start it anew")
    kind = bench_kind(header.bench)
    if kind and kind != kind_of(simulated=bench.config.simulated, served=bench.config.served):
        raise InputError(
            f"run {header.run_id} was begun on another bench: a real, a simulated and a served one are not the same"
        )
    stands = dut_serial or _standing(bench, header)
    if stands != header.dut.serial:
        raise InputError(f"run {header.run_id} is of DUT {header.dut.serial}, the bench has {stands}")
    for then, now in zip(header.instruments, _named(bench.identities()), strict=False):
        if dict(then) != dict(now):
            raise InputError(
                f"{then['name']} was {_words(then)} when run {header.run_id} began, now it is {_words(now)}"
            )


def _standing(bench: Bench, header: RunHeader) -> str:
    """The DUT on the bench: what its file says, unless it said the same when the run was begun with another serial."""
    now, then = bench.config.dut.serial, tomllib.loads(header.bench).get("dut", {}).get("serial")
    return header.dut.serial if now == then else now


def _words(identity: Mapping[str, str]) -> str:
    return f"{identity['manufacturer']} {identity['model']} {identity['serial']}"


def _named(identities: Mapping[str, Identity]) -> tuple[Mapping[str, str], ...]:
    return tuple({"name": name} | asdict(identity) for name, identity in identities.items())


def _dut(bench: Bench, serial: str | None) -> Dut:
    config = bench.config.dut
    chosen = config.serial if serial is None else serial
    if not chosen.strip():
        raise InputError("a run needs the serial number of its DUT: --dut SERIAL")
    config.refuse_serial(chosen)
    return Dut(chosen, config.model, config.unit, config.nominal_nT_per_unit, config.noise_nT)
