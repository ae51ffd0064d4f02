"""The words of a procedure: record, turn, set a field, ask. Each is a generator for `yield from`.

with ExitStack() as afterwards:
afterwards.callback(bench.make_safe)          # the undo, before anything is energised
yield from energise(bench, (0, 0, 20_000))
blocks = yield from recorded(bench, segment, record(bench, 10.0))
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import replace
from functools import partial
from math import inf
from typing import TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.bench.bench import Bench
from labcal.bench.plan import Plan as Plan  # procedures have both from here
from labcal.bench.plan import Resume as Resume
from labcal.bench.remarks import not_used as not_used
from labcal.bench.remarks import note as note
from labcal.bench.remarks import read_back as read_back
from labcal.bench.remarks import set_point as set_point
from labcal.bench.streams.samples import Samples, samples
from labcal.errors import InputError, InstrumentError, LimitNotMet
from labcal.record.run import Segment
from labcal.record.stream import (
    FAULT,
    Block,
    Event,
    Item,
    Measurement,
    ModeChanged,
    Prompt,
    SegmentClosed,
    SegmentOpened,
)
from labcal.record.vector import Matrix

T = TypeVar("T")
Work = Generator[Item, str | None, T]  # yields what it measured, receives answers, returns what the caller needs
Procedure = Work[None]
Blocks = list[Block]
QUESTION = "question"  # in the drawing of "hands off" that was refused: what is about to happen
HANDS_OFF, ROUNDING = "Hands off?", 1e-6
ANEW = "again"  # in that of a step that failed: what comes on and turns where it is tried again
MARGIN_S = 0.3
AT_REST_DEG = 0.5  # a dial so near is not turned again
TICK_S, VIRTUAL_TICK_S = 0.5, 5.0  # samples are handed on at least so often; on a virtual clock nobody waits


def record(
    bench: Bench, seconds: float, *, from_s: float | None = None, look: Callable[[Blocks], None] | None = None
) -> Work[Blocks]:
    """Hand on what the streams send for `seconds`; return what is stamped from now, or from `from_s` on.

    The frames as they came over the wire are for the record alone: what is returned goes without. `look`, at each tick,
    at what came until then; what it raises ends it.
    """
    kept: Blocks = []
    then = None if look is None else partial(look, kept)
    yield from listen(bench, seconds, lambda block: kept.append(replace(block, raw=b"")), from_s=from_s, then=then)
    return kept


def listen(
    bench: Bench,
    seconds: float,
    see: Callable[[Block], None],
    *,
    from_s: float | None = None,
    then: Callable[[], None] | None = None,
) -> Work[None]:
    """As `record`, for hours: what comes is shown to `see` and not kept; `then`, once it is in the record."""
    begun, tick_s = bench.clock.now(), VIRTUAL_TICK_S if np.isinf(bench.clock.listen_s) else TICK_S
    while (now := bench.clock.now()) < begun + seconds:
        blocks = bench.stream_until(min(now + tick_s, begun + seconds))
        for block in blocks:
            see(since(begun if from_s is None else from_s, block))
        yield from blocks
        if then is not None:
            then()


def since(start_s: float, block: Block) -> Block:
    """The part of `block` that is stamped from `start_s` on: what came while the coils ramped is not the new field."""
    rows = block.t_s >= start_s
    return block if rows.all() else replace(block, t_s=block.t_s[rows], values=block.values[rows])


def turn(
    bench: Bench, to_deg: float, rate_deg_per_s: float, look: Callable[[Blocks], None] | None = None
) -> Work[Blocks]:
    """Turn the platform to `to_deg` while the streams are handed on; return what they sent. `look`: as `record`."""
    limit = bench.config.dut.limits.rate_deg_per_s
    if limit is not None and rate_deg_per_s > limit:
        raise InputError(f"{rate_deg_per_s:g} deg/s is beyond the DUT's limit of {limit:g} deg/s; nothing was moved.")
    if abs(to_deg - bench.platform.angle_deg()) > AT_REST_DEG:
        yield from hands_off(bench, f"The platform turns to {to_deg:g}°.", 0.0)
    seconds = abs(to_deg - bench.platform.angle_deg()) / rate_deg_per_s
    bench.platform.move_to(to_deg, rate_deg_per_s)
    kept = yield from record(bench, seconds, look=look)
    while bench.platform.moving():
        kept += yield from record(bench, TICK_S)
    return kept


def turn_by_hand(bench: Bench, to_deg: float) -> Work[None]:
    """Ask a person to turn the dial to `to_deg`, and what it then reads. Raises InstrumentError for an abort."""
    assert bench.by_hand is not None
    bench.platform.move_to(to_deg, bench.platform.max_rate_deg_per_s)
    limit = bench.config.dut.limits.rate_deg_per_s
    text, drawing = bench.by_hand.question(), {"angle_deg": to_deg}
    text += f" No faster than {limit:g} deg/s." if limit else ""
    answer = yield Prompt(bench.clock.now(), f"turn-{to_deg:g}", text, (), acts=True, drawing=drawing)
    bench.by_hand.confirm(answer or "")
    bench.hands_near = False  # as the question asks


def to_angle(bench: Bench, angle_deg: float, *, then_asks: bool = False) -> Work[None]:
    """Bring the platform to `angle_deg`, homed first where it does not know where it is; without a motor, by hand.

    `then_asks`: a question comes next, and nothing else that was promised before it.
    """
    if bench.by_hand is not None:
        if bench.platform.moving() or abs(bench.platform.angle_deg() - angle_deg) > AT_REST_DEG:
            yield from turn_by_hand(bench, angle_deg)
        return
    if not bench.homed:
        what = f"Next the platform looks for its zero and turns to {angle_deg:g}°."
        yield from hands_off(bench, what, 0.0, alone=then_asks)
    elif abs(bench.platform.angle_deg() - angle_deg) > AT_REST_DEG:  # to find its zero it turns as well
        yield from hands_off(bench, f"The platform turns to {angle_deg:g}°.", 0.0, alone=then_asks)
    bench.platform.home()
    bench.homed = True
    while bench.platform.moving():
        yield from record(bench, TICK_S)
    yield from turn(bench, angle_deg, rate_between(bench))


def rate_between(bench: Bench) -> float:
    """How fast the platform is brought to where something is to be measured [deg/s]."""
    return min(bench.platform.max_rate_deg_per_s, bench.config.dut.limits.rate_deg_per_s or np.inf, 30.0)


def recorded(bench: Bench, segment: Segment, work: Work[T]) -> Work[T]:
    """Do `work` inside a segment; a little is recorded on either side, so that its ends can be interpolated.

    Raises InputError where a pause has taken the field to zero that the procedure means to have.
    """
    if bench.field_taken:
        raise InputError(
            f"the pause took the field to zero, and the procedure did not bring it back before {segment.id}: nothing "
            "was measured in a wrong field. Begin the run anew, without a pause; who wrote the "
            "procedure lets each step say its field (energise, energise_again or coils_off)."
        )
    yield from record(bench, MARGIN_S)
    yield SegmentOpened(bench.clock.now(), segment)
    try:
        result = yield from work
    except (InstrumentError, LimitNotMet):
        yield SegmentClosed(bench.clock.now())
        raise
    yield SegmentClosed(bench.clock.now())
    yield from record(bench, MARGIN_S)
    return result


def rest(
    bench: Bench, name: str, seconds: float, *, mode: str | None = None, body_from_cage: ArrayLike | None = None
) -> Work[Blocks]:
    """Record a standstill of `seconds` as a segment; `body_from_cage` (3, 3) where the attitude is stated."""
    stated = None if body_from_cage is None else matrix_of(body_from_cage)
    segment = Segment(name, "static", mode=mode, body_from_cage=stated)
    return (yield from recorded(bench, segment, record(bench, seconds)))


def matrix_of(rows: ArrayLike) -> Matrix:
    """A (3, 3) array as the tuples that a segment holds."""
    x, y, z = ((float(a), float(b), float(c)) for a, b, c in np.asarray(rows, dtype=float))
    return x, y, z


def measure_ambient(bench: Bench, seconds: float, *, name: str = "zero") -> Work[Blocks]:
    """Coils off, a standstill outside any segment; what the reference then sees becomes the cage's ambient field."""
    yield from coils_off(bench)
    blocks = yield from record(bench, seconds)
    reference = samples(blocks, "reference")
    for column, value, u in zip(reference.columns, reference.mean, reference.u_mean, strict=True):
        yield from measured(bench, f"{name}: {column}", value, u, "nT")
    take_ambient(bench, reference.mean)
    return blocks


def take_ambient(bench: Bench, mean_nT: NDArray[np.float64]) -> None:
    """What a vector reference saw at the coils' zero, (3,) in C, is the cage's ambient field from now on."""
    if len(mean_nT) == 3:
        bench.cage.ambient_nT = mean_nT
        bench.cage.check.take_ambient(mean_nT, bench.clock.now())


def attempt(bench: Bench, name: str, work: Callable[[], Work[T]]) -> Work[T | None]:
    """Do `work`; where an instrument fails, coils off and ask: stop, retry, or skip with a reason (then None).

    A stopped step never restarts by itself: the first choice is to stop.
    """
    while True:
        bench.announced.clear()
        try:
            return (yield from work())
        except InstrumentError as fault:
            said = bench.named(str(fault))
            yield Event(bench.clock.now(), FAULT, said, {"step": name, "fault": fault.fault})
            bench.zero_and_stop()
            yield _coils_read_back(bench)
            yield from standstill(bench)
            text = f"{name}: {said} ({bench.sentence()})"
            again = {ANEW: bench.promised[0] or " ".join(dict.fromkeys(bench.announced))}
            drawing = _of_fault(bench, fault) | again
            choices = ("stop", "retry", "skip")
            answer = yield Prompt(bench.clock.now(), f"failed-{name}", text, choices, drawing=drawing)
            if answer == "retry" and (still := bench.still_wrong()):
                answer = yield Prompt(
                    bench.clock.now(), f"failed-{name}", still, choices, drawing={FAULT: still} | again
                )
            if answer == "stop":
                raise
            bench.hands_near = answer != "retry" or bool(bench.still_wrong())  # "Hands off: try again"
            if answer == "skip":
                reason = yield Prompt(bench.clock.now(), f"skip-{name}", f"Why is {name} skipped?", ())
                yield Event(bench.clock.now(), "skip", f"{name} skipped: {reason}", {"step": name, "reason": reason})
                return None


def _of_fault(bench: Bench, fault: InstrumentError) -> dict[str, str]:
    """What is shown of it to who sees coils and step beside it: the whole, its parts, and who does not answer."""
    what = bench.named(fault.what, brief=True)
    name = what.partition(":")[0]
    lost = fault.fault in ("link lost", "silent") and name in bench.config.instruments
    said = {FAULT: bench.named(str(fault), brief=True), "what": what, "remedy": fault.remedy}
    return said | ({"no_answer": name} if lost else {})


def energise(bench: Bench, b_nT: ArrayLike, *, confirm_signs: bool = True) -> Work[None]:
    """Bring the total field at the centre to `b_nT` (3,) in C, and say so in the record; as `Cage.set_field`."""
    b = [float(v) for v in np.asarray(b_nT)]
    bench.cage.refuse_beyond_limits(b)  # before anybody is asked for what cannot be done
    most_nT = float(np.linalg.norm(b))
    yield from hands_off(bench, f"The field goes to {most_nT / 1000:g} µT{_and_turns(bench)}.", most_nT)
    bench.cage.set_field(b, confirm_signs=confirm_signs)
    bench.field_taken = False
    yield set_point(bench, f"field {b[0]:.0f} {b[1]:.0f} {b[2]:.0f} nT", field_nT=b)


def energise_again(bench: Bench, b_nT: ArrayLike) -> Work[None]:
    """`energise` where nothing flows: a pause before this step took the field of the one before to zero."""
    if not bench.cage.on:
        yield from energise(bench, b_nT)


def drive(bench: Bench, i_A: ArrayLike, *, confirm_signs: bool = True) -> Work[None]:
    """Bring the coil currents to `i_A` (3,), and say so in the record; as `Cage.set_currents`."""
    i = [float(v) for v in np.asarray(i_A)]
    if any(i):
        most_nT = float(np.linalg.norm(bench.cage.matrix_nT_per_A @ i))
        yield from hands_off(bench, f"The coils go to {most_nT / 1000:.3g} µT{_and_turns(bench)}.", most_nT)
    bench.cage.set_currents(i, confirm_signs=confirm_signs)
    bench.field_taken = False
    yield set_point(bench, f"currents {i[0]:.4f} {i[1]:.4f} {i[2]:.4f} A", current_A=i)


def coils_off(bench: Bench) -> Work[None]:
    """All coils to zero, read back, and say so in the record."""
    bench.cage.zero()
    bench.field_taken = False
    yield _coils_read_back(bench)


def _coils_read_back(bench: Bench) -> Event:
    return read_back(bench, "read-back", current_A=bench.cage.currents_A().tolist())


def standstill(bench: Bench) -> Work[None]:
    """The platform stopped wherever it is, seen to stand, and that in the record."""
    if said := bench.stop_platform():
        yield Event(bench.clock.now(), "standstill", said)


def mount(bench: Bench, key: str, body_from_cage: ArrayLike, text: str, *instead: str) -> Work[str]:
    """Coils off, platform to zero, then ask the person to mount the DUT so; `body_from_cage` (3, 3) at angle 0.

    Returns the answer: "done", or one of what may be chosen `instead`.
    """
    yield from coils_off(bench)
    yield from to_angle(bench, 0.0, then_asks=True)
    bench.look_at_platform()
    attitude = np.asarray(body_from_cage, dtype=float)
    drawing = {"body_from_cage": attitude.tolist(), "axis_cage": list(bench.config.platform.axis_cage)}
    answer = (yield Prompt(bench.clock.now(), key, text, ("done", *instead), True, drawing)) or "done"
    if answer == "done" and bench.config.dut.serial_at_mounting:
        yield from serial_of_what_is_mounted(bench, key)
    return answer


def serial_of_what_is_mounted(bench: Bench, key: str) -> Work[None]:
    """Ask for the serial of what stands on the platform until it is that of the run's DUT; each answer is recorded."""
    wanted = bench.dut_serial
    text = f"Scan the serial of the DUT as it is mounted now: this run is of {wanted}."
    while True:
        said = yield Prompt(bench.clock.now(), f"serial-{key}", text, (), acts=True, drawing={"serial": wanted})
        if (said or "").strip() == wanted:
            return
        text = f"{said or 'nothing'}: that is not the DUT of this run. Mount {wanted}, then scan its serial again."


def switch_mode(bench: Bench, mode: str) -> Work[None]:
    """Coils off where they are on, as hands go near; then ask the person to bring the DUT into `mode`.

    A DUT of which bench.toml states that mode alone is in it: nobody is asked.
    """
    bench.config.dut.limits.refuse_mode(mode)
    if bench.config.dut.limits.modes == (mode,):
        yield ModeChanged(bench.clock.now(), mode)
        return
    if bench.cage.on:
        yield from coils_off(bench)
    text = f"Switch the DUT to power mode {mode}."
    yield Prompt(bench.clock.now(), f"mode-{mode}", text, acts=True, drawing={"mode": mode})
    yield ModeChanged(bench.clock.now(), mode)


def ready(bench: Bench, text: str) -> Work[None]:
    """Ask whether all hands are off; whoever says so stands back until the next question.

    `text` names the largest field [µT] that comes before that: it is what a pause, or a step that failed, asks anew.
    While an instrument is lost nobody's word is taken: who puts it right has a hand at its plug. It is asked again.
    """
    still, drawing = "", dict[str, str]()
    while True:
        yield Prompt(bench.clock.now(), "ready", f"{still} {text}".strip(), acts=True, drawing=drawing)
        if not (still := bench.still_wrong()):
            break
        drawing = {QUESTION: text}  # whole: what comes on and turns is said until it is answered
        yield from record(bench, TICK_S)  # what stays away for too long ends this, whoever answers
    bench.hands_near, bench.promised = False, (text.removesuffix(HANDS_OFF).strip(), inf)


def hands_off(bench: Bench, what: str, most_nT: float = inf, *, alone: bool = False) -> Work[None]:
    """Before anything is energised or turned: `ready`, unless nobody was asked for anything since it was answered.

    `what` is about to happen, with a field of `most_nT`; inf: nothing stronger comes before the next question. Every
    question may bring hands to the lab, for a person mounts, switches, puts right. After a pause what was promised
    before it still comes, and is asked anew, but for what is done `alone` before a question. Nobody who was told of
    one field stands near a stronger one.
    """
    bench.announced.append(what)
    words, promised_nT = bench.promised
    stronger = most_nT > promised_nT * (1 + ROUNDING)
    if alone:
        if bench.hands_near:
            yield from ready(bench, f"{what} {HANDS_OFF}")
            bench.promised = words, promised_nT
    elif bench.hands_near or (stronger and most_nT < inf):
        if stronger or most_nT == inf or not words:
            words, promised_nT = what, most_nT
        yield from ready(bench, f"{words} {HANDS_OFF}")
        bench.promised = words, promised_nT


def _and_turns(bench: Bench) -> str:
    """Who stands back from the coils stands back from a platform as well: no other question comes before it turns."""
    return ", and the platform may turn" if bench.by_hand is None else ""


def measured(
    bench: Bench, name: str, value: float, u: float, unit: str, limit: float | None = None
) -> Work[Measurement]:
    """Put a measurement into the record and return it with its verdict."""
    result = Measurement(bench.clock.now(), name, float(value), float(u), unit, limit)
    yield result
    return result


def dut_nT(bench: Bench, blocks: Sequence[Block]) -> Samples:
    """The DUT's readings as nominal nT, body axes."""
    raw = samples(blocks, "dut")
    return replace(raw, values=raw.values * bench.config.dut.nominal_nT_per_unit)
