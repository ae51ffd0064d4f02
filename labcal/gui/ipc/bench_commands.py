"""What the worker does with a bench: look at it, identify its instruments, run a procedure on it, switch it off."""

from __future__ import annotations

import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from labcal.bench.parameters import CALIBRATION
from labcal.errors import InputError
from labcal.files.home import home
from labcal.gui.ipc.answers import (
    Bench,
    Cage,
    CoilEnd,
    Doubt,
    EarlierSupply,
    Earth,
    Ended,
    Identified,
    Instrument,
    InstrumentAnswer,
    Procedure,
    Procedures,
    Reference,
    SwitchedOff,
)
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.handlers import handles
from labcal.gui.ipc.lab_messages import InstrumentRead, PrepareToRead
from labcal.gui.ipc.messages import (
    CheckZero,
    EarlierAreGone,
    GoesOn,
    Identify,
    ListProcedures,
    ReadBench,
    ReadLab,
    Rehearse,
    Rejoin,
    ResumeRun,
    RunProcedure,
    SwitchOff,
)
from labcal.gui.ipc.run_began import began_at
from labcal.gui.ipc.simulated_clock import simulated_clock
from labcal.gui.ipc.wire import fault_of
from labcal.record import Dut

if TYPE_CHECKING:
    from labcal.bench.coils.zero import AtZero
    from labcal.bench.config import BenchConfig, CageConfig, SiteConfig
    from labcal.bench.identify import Identified as Answered
    from labcal.bench.look_again import Looked
    from labcal.bench.reading import InstrumentReading
    from labcal.runner import FoundProcedure, Outcome


def read_bench(channel: Channel, asked: ReadBench) -> Bench:
    """What a bench file states: names, roles, limits, the cage's matrix, what is known of the reference."""
    from labcal.bench.coils.cage_file import calibrated
    from labcal.bench.config import read_config
    from labcal.bench.fastest import fastest_stated
    from labcal.bench.named_serials import stated_serial

    config, _ = calibrated(read_config(Path(asked.bench)), Path(asked.bench))
    dut, reference = config.dut, config.reference
    return Bench(
        name=config.name,
        simulated=config.unreal,
        dut=Dut(dut.serial, dut.model, dut.unit, dut.nominal_nT_per_unit, dut.noise_nT),
        reference=Reference(reference.u_offset_nT, reference.u_scale_ppm, reference.calibration),
        cage=_cage(config.cage),
        instruments={
            name: Instrument(i.role, i.link, i.driver, stated_serial(config, name))
            for name, i in config.instruments.items()
        },
        serial_pattern=dut.serial_pattern,
        modes=dut.limits.modes,
        fastest_deg_per_s=fastest_stated(Path(asked.bench), config),
        virtual_time=config.simulated,
        camera=config.camera or "",
        laboratory=_laboratory(config),
        earth=None if config.site is None else _earth(config.site),
    )


def _laboratory(config: BenchConfig) -> str:
    """Its name, by the bench file or labcal's folder; "" where nobody says it, or not in a way that can be read."""
    from labcal.certificate.laboratory import FILE, read_laboratory

    if config.laboratory is not None:
        return config.laboratory.name
    with suppress(InputError):
        own = read_laboratory(home() / FILE).laboratory
        return own.name if own is not None else ""
    return ""


def _earth(site: SiteConfig) -> Earth | None:
    """What the World Magnetic Model expects at the bench's place today; None in years that it does not hold for."""
    from labcal.earth.wmm import FIRST_YEAR, LAST_YEAR, wmm

    today = datetime.now(UTC).date()
    if not FIRST_YEAR <= today.year < LAST_YEAR:
        return None
    found = wmm(site.latitude_deg, site.longitude_deg, site.height_m, today)
    return Earth(found.model, found.magnitude_nT, 2.0 * found.u_magnitude_nT)


def _cage(config: CageConfig) -> Cage:
    x, y, z = config.matrix.tolist()
    limits = config.limits
    return Cage(
        *((x, y, z), config.matrix_nT_per_A is not None, config.calibration),
        *(limits.current_A, limits.field_nT, limits.ramp_A_per_s),
    )


def identify(channel: Channel, asked: Identify) -> Identified:
    """Ask every instrument who it is; where the reference did not see a zero, measure that again and say so."""
    from labcal import session

    answers = tuple(_instrument_answer(one) for one in session.identify_instruments(Path(asked.bench)))
    looked = session.look_again(Path(asked.bench))
    return Identified(answers, None if looked is None else _doubt(looked))


def check_zero(channel: Channel, asked: CheckZero) -> Doubt:
    """Coils to zero, then what the reference sees; where nothing is in doubt, that."""
    from labcal import session

    looked = session.look_again(Path(asked.bench))
    return Doubt("", True) if looked is None else _doubt(looked)


def _doubt(looked: Looked) -> Doubt:
    words = f"{looked.words} {looked.advice}".strip()
    return Doubt(words, looked.lifted, tuple(map(_coil_end, looked.ended)), looked.before)


def _instrument_answer(one: Answered) -> InstrumentAnswer:
    fault = None if one.fault is None else fault_of(one.fault)
    return InstrumentAnswer(one.name, one.role, one.link, one.identity, fault, one.serial)


def read_lab(channel: Channel, asked: ReadLab) -> tuple[InstrumentRead, ...]:
    """Each instrument as it is now; nothing is set."""
    from labcal import session

    return tuple(map(_instrument_read, session.read_lab(Path(asked.bench), asked.names)))


def prepare_to_read(channel: Channel, asked: PrepareToRead) -> bool:
    """Whoever is asked to read next has no file to load first."""
    from labcal import session

    session.prepare_to_read(Path(asked.bench))
    return True


def _instrument_read(one: InstrumentReading) -> InstrumentRead:
    fault = None if one.fault is None else fault_of(one.fault)
    return InstrumentRead(one.name, one.role, one.link, one.identity, fault, one.held, one.read_s, one.current_A,
                          one.zero, one.field_nT, one.angle_deg, one.moving, one.serial, one.until)  # fmt: skip


def switch_off(channel: Channel, asked: SwitchOff) -> SwitchedOff:
    """Every coil to zero and open, one report an axis, with when it was read and the doubt that stands about zero."""
    from labcal import session
    from labcal.bench.coils.at_zero import of_this_bench
    from labcal.bench.coils.doubt import advice_of, doubt_of

    path = Path(asked.bench)
    with channel.on_the_way_to_zero():
        ended, platform = session.coils_off_and_stopped(path)
    earlier = tuple(_earlier(end) for end in ended if end.earlier_at and end.fault is not None)
    coils = tuple(map(_coil_end, of_this_bench(ended)))
    return SwitchedOff(coils, doubt_of(path), advice_of(path), platform, earlier)


def _earlier(one: AtZero) -> EarlierSupply:
    flows = one.fault is not None and one.fault.fault == "not zero"
    return EarlierSupply(one.axis, one.earlier_at, one.words, one.link_is_gone, flows)


def earlier_are_gone(channel: Channel, asked: EarlierAreGone) -> bool:
    """Have nobody ask for these again. Raises InputError: nobody says so, or the audit log takes no entry."""
    from labcal import session

    session.earlier_supplies_are_gone(Path(asked.bench), asked.ports, asked.who)
    return True


def _coil_end(one: AtZero) -> CoilEnd:
    mends = "" if one.fault is None else one.fault.mends  # no technician's business
    words = one.words.replace(mends, "").rstrip() if mends else one.words
    return CoilEnd(one.axis, one.current_A, words, one.fault is None, one.read_s)


def run(channel: Channel, asked: RunProcedure) -> Ended:
    """Run a procedure, in simulated time after the run `after`; answers, stop and all else come in by `channel`."""
    from labcal import session

    by = asked.answered_for
    lets = None if by is None else session.Override(by.who, by.because, by.key or None, by.passphrase)

    def work(**common: Any) -> Outcome:
        return session.run(
            asked.procedure,
            Path(asked.bench),
            asked.given,
            dut=asked.dut,
            operator=asked.operator,
            override=lets,
            **common,
        )

    return _on_bench(channel, asked, work, asked.after)


def resume(channel: Channel, asked: ResumeRun) -> Ended:
    """Go on with an interrupted run."""
    from labcal import session

    return _on_bench(
        channel, asked, lambda **common: session.resume(asked.run, Path(asked.bench), dut=asked.dut, **common)
    )


def rejoin(channel: Channel, asked: Rejoin) -> Ended:
    """Asked of a worker whose run has lost no window (`channel` answers where one has). Raises InputError."""
    raise InputError("no run goes on here that could be come back to")


def _on_bench(
    channel: Channel, asked: RunProcedure | ResumeRun, work: Callable[..., Outcome], after: str = ""
) -> Ended:
    from labcal.bench.config import read_config

    simulated = read_config(Path(asked.bench)).simulated
    channel.run_begins(simulated, going(channel, asked))
    try:
        clock = simulated_clock(asked.pace, *_from(after)) if simulated else None
        ended = work(
            answer=channel.answer,
            clock=clock,
            seed=asked.seed,
            control=channel.control,
            on_item=channel.send_item,
            show=channel.send_state,
        )
    finally:
        channel.run_ends()
    fault = None
    if ended.fault is not None:
        fault = fault_of(ended.fault, "".join(traceback.format_exception(ended.fault)))
    return Ended(ended.run_id, ended.status, fault, tuple(m.name for m in ended.failed), ended.ending)


def going(channel: Channel, asked: RunProcedure | ResumeRun) -> GoesOn:
    """What a window that comes back to this run needs to know first."""
    order, began = asked, f"{datetime.now():%Y-%m-%d %H:%M}"
    if isinstance(order, ResumeRun):
        began = began_at(order.run) or began
        order = RunProcedure(order.procedure, order.bench, {}, order.dut, order.operator, order.pace, order.seed)
    order = replace(order, answered_for=None)  # its passphrase has been used
    return GoesOn(order, began, read_bench(channel, ReadBench(asked.bench)))


def _from(after: str) -> tuple[datetime, float]:
    """Where simulated time begins: now, or where a run has ended."""
    if not after:
        return datetime.now(UTC), 0.0
    from labcal.session import measuring

    return measuring.goes_on(after)


def rehearse(channel: Channel, asked: Rehearse) -> tuple[str, ...]:
    """What a procedure would do, a line each, as rehearsed on the simulated lab; nothing real is touched."""
    from labcal.runner import find
    from labcal.runner.rehearsal import rehearsed

    given = {name: text for name, text in asked.given.items() if name != CALIBRATION.name}  # it is judged afterwards
    return tuple(rehearsed(Path(asked.bench), find(asked.procedure), given, asked.seed).lines())


def procedures(channel: Channel, asked: ListProcedures) -> Procedures:
    """What there is to run, with the parameters of each; of one that does not load its name and the fault."""
    from labcal.runner import catalogue

    found, broken = catalogue()
    return Procedures(tuple(map(_procedure, found.values())), {name: str(e) for name, e in broken.items()})


def _procedure(found: FoundProcedure) -> Procedure:
    asked = (CALIBRATION,) if found.takes(CALIBRATION.name) else ()
    return Procedure(
        found.name, found.title, found.resumable, found.needs, found.lasts_min, (*asked, *found.parameters)
    )


HANDLERS = (
    handles(ReadBench, read_bench),
    handles(Identify, identify),
    handles(ReadLab, read_lab),
    handles(PrepareToRead, prepare_to_read),
    handles(SwitchOff, switch_off),
    handles(CheckZero, check_zero),
    handles(EarlierAreGone, earlier_are_gone),
    handles(RunProcedure, run),
    handles(ResumeRun, resume),
    handles(Rejoin, rejoin),
    handles(Rehearse, rehearse),
    handles(ListProcedures, procedures),
)
