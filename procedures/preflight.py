"""The whole calibration before flight: three body axes, two magnitudes, one reversed, every power mode, closed."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import ExitStack
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import Annotated, Any, Literal

import numpy as np
from numpy.typing import NDArray

from labcal.bench.axis_up import WrongAxis
from labcal.bench.bench import Bench
from labcal.bench.coverage import refuse_unseen
from labcal.bench.mounting import AXES, attitude, how_to_mount, inclined_field
from labcal.bench.parameters import Least, Limits
from labcal.bench.position import Position, position
from labcal.bench.rotation import Rotation, refuse_too_fast, rotate_once
from labcal.bench.steps import (
    AT_REST_DEG,
    Blocks,
    Procedure,
    Resume,
    Work,
    attempt,
    coils_off,
    energise,
    hands_off,
    measure_ambient,
    measured,
    mount,
    not_used,
    note,
    record,
    standstill,
    switch_mode,
    to_angle,
)
from labcal.bench.turn_diagnostics import Turned, delay_of, look_at_turn
from labcal.errors import LimitNotMet
from labcal.record.closure import Standstill
from labcal.record.stream import CLOSURE, Event, Prompt
from procedures.axes_check import check_axes
from procedures.preflight_plan import POSITIONS, PreflightPlan, first_of
from procedures.running_estimate import RunningEstimate
from procedures.sync_check import check_sync

NEEDS, LASTS_MIN = "the DUT on the platform, remounted three times; a vector reference", 48

Array = NDArray[np.float64]
REFERENCE = ("ref_x", "ref_y", "ref_z")
REMOUNT = "remount"
ONE_AXIS = (
    "No whole calibration can come of one body axis: it does not determine all 12 parameters of the map. "
    "It repeats or checks turns."
)
AXES_nT, SYNC_nT = 5_000.0, 8_000.0  # that the coils make in axes-check and sync-check
LONGEST_DELAY_S = 0.5  # of an axis, as sync-check allows


@dataclass(frozen=True, slots=True)
class First:
    """What a run began with, coils off and in the first field; after an interruption numbers alone."""

    excess_nT: tuple[float, ...]
    spots: tuple[Position, Position] | None


def preflight(
    bench: Bench,
    *,
    axes: Annotated[
        tuple[Literal["x", "y", "z"], ...],
        Least(2, ONE_AXIS),
        "body axes, each mounted along the platform axis in turn",
    ] = ("x", "y", "z"),
    magnitudes_nT: Annotated[tuple[float, ...], Limits(1e3, 1e5, unit="nT"), "field magnitudes"] = (20e3, 50e3),
    reverse: Annotated[bool, "the last magnitude also reversed"] = True,
    inclination_deg: Annotated[float, Limits(35, 65, unit="deg"), "field from the platform axis"] = 50.0,
    modes: Annotated[tuple[str, ...], "the DUT's power modes"] = ("nominal", "full"),
    rate_deg_per_s: Annotated[float, Limits(0, 60, unit="deg/s"), "0: as fast as timing and the range allow"] = 0.0,
    timing_nT: Annotated[float, Limits(0.1, 1_000, unit="nT"), "error that timing may make"] = 8.0,
    u_time_s: Annotated[float, Limits(1e-6, 1, unit="s"), "timing uncertainty, at least"] = 0.005,
    step_deg: Annotated[float, Limits(0, 90, unit="deg"), "0: continuous, else stepped"] = 0.0,
    dwell_s: Annotated[float, Limits(0.5, 60, unit="s"), "recorded at a position"] = 5.0,
    zero_s: Annotated[float, Limits(2, 600, unit="s"), "coils-off zero, first and last"] = 10.0,
    closure_nT: Annotated[float, Limits(1, 100_000, unit="nT"), "largest closure that passes"] = 500.0,
    u_mounting_deg: Annotated[float, Limits(0.01, 10, unit="deg"), "how well an axis is mounted"] = 0.5,
    resume: Resume | None = None,
) -> Procedure:
    """The whole calibration before flight, from the zero to the closing."""
    fields = (*magnitudes_nT, *((-magnitudes_nT[-1],) if reverse else ()))
    wanted = PreflightPlan(
        axes, fields, modes, inclination_deg, rate_deg_per_s > 0, rate_deg_per_s, timing_nT, u_time_s, step_deg,
        dwell_s, zero_s, closure_nT, u_mounting_deg, RunningEstimate(bench),
    )  # fmt: skip
    refuse_too_fast(bench, rate_deg_per_s)
    done = resume.done if resume else frozenset[str]()
    setting = wanted.at_rate_of(bench).after(resume)
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        mounted = next((axis for axis in axes if setting.to_mount(axis)), axes[0])
        first = yield from _open_and_check_axes(bench, setting, mounted, resume)
        setting = yield from _check_sync(bench, setting, mounted)
        before = ""
        for axis in filter(setting.to_mount, axes):
            kept_nT = resume.measured[first_of(axis)] if resume and axis in setting.unclosed else None
            yield from _about(bench, setting, axis, done, mounted, before, kept_nT)
            before = axis
        yield from _closing(bench, setting, first, before)


def _open_and_check_axes(bench: Bench, setting: PreflightPlan, axis: str, resume: Resume | None) -> Work[First]:
    """The opening and the axes; where they are not as they should be it is mounted again, and both begin anew.

    Nothing of a turn hangs on them yet: what was measured of the wrong mounting stays in the record, as do its limits
    that were not met until they are. Raises LimitNotMet where the person stops.
    """
    stood = setting.stood(resume.done) if resume else ""
    while True:
        try:
            first = yield from _open(bench, setting, axis, resume, stood)
            yield setting.plan().begin(bench, "axes-check")
            yield from check_axes(bench, axis, AXES_nT, 2.0, 20.0, 15.0)
            return first
        except LimitNotMet as wrong:
            yield from _mounted_wrongly(bench, "opening-failed", wrong)
            stood = ""


def _open(bench: Bench, setting: PreflightPlan, axis: str, resume: Resume | None, stood: str) -> Work[First]:
    """Mount, then the zero and the first position; where turns are kept they are compared with what they were."""
    yield setting.plan().begin(bench, "zero")
    if resume is not None:
        yield note(bench, _of_what_is_kept(setting, resume))
    yield from _mounted(bench, axis, stood)
    yield from switch_mode(bench, setting.modes[0])
    yield from _all_hands_off(bench, setting)
    yield from to_angle(bench, 0.0)
    spots = yield from _zero_and_first_position(bench, setting, "zero")
    if resume is None or not setting.turned(resume.done):
        return First(tuple(spot.excess for spot in spots), spots)
    moved = [resume.measured.get(f"zero: {c}", b) - b for c, b in zip(REFERENCE, bench.cage.ambient_nT, strict=True)]
    yield from _must_close(bench, "zero since the interruption", float(np.linalg.norm(moved)), 0.0, setting.closure_nT)
    before = (resume.measured.get(f"zero: {name}", spot.excess) for name, spot in zip(POSITIONS, spots, strict=True))
    return First(tuple(before), None)


def _of_what_is_kept(setting: PreflightPlan, resume: Resume) -> str:
    """For whoever sees it begin with its first step again."""
    turns = sum(name in resume.done for axis in setting.axes for name, _, _ in setting.turns(axis))
    if not turns:
        return "no turn was finished before the interruption: it begins anew, and nothing of before is used"
    why = "they tell whether anything moved or drifted since"
    again = f"the zero, the axes and the timing are measured again: {why}"
    return f"turns kept from before the interruption: {turns}; {again}"


def _mounted(bench: Bench, axis: str, stood: str) -> Work[None]:
    """The DUT mounted along `axis`: by a person now, or as it `stood` before the interruption where it still does."""
    if axis == stood:
        yield from coils_off(bench)  # nobody has read them since, and the person is sent to look
        yield from standstill(bench)
        text = f"Is the DUT still mounted with body {axis.upper()} up, exactly as it was before the interruption?"
        up = list(bench.config.platform.axis_cage)
        drawing = {"body_from_cage": attitude(bench, axis).tolist(), "axis_cage": up}
        if (yield Prompt(bench.clock.now(), "mounting-stands", text, ("yes", "no"), True, drawing)) == "yes":
            return
    yield from mount(bench, f"mount-{axis}", attitude(bench, axis), how_to_mount(axis))


def _first_mode_again(bench: Bench, setting: PreflightPlan) -> Work[None]:
    """Mounted anew the DUT is in its first mode: asked for where there are others, for it may come up in any."""
    if len(setting.modes) > 1:
        yield from switch_mode(bench, setting.modes[0])


def _check_sync(bench: Bench, setting: PreflightPlan, axis: str) -> Work[PreflightPlan]:
    """Timing; the rate follows from the timing uncertainty found."""
    yield setting.plan().begin(bench, "sync-check")
    u_time_s = yield from check_sync(bench, axis, SYNC_nT, 15, 1.0, 40.0, 0.5)
    found = replace(setting, u_time_s=max(u_time_s, setting.u_time_s)).at_rate_of(bench)
    yield from measured(bench, "rotation rate", found.rate_deg_per_s, 0.0, "deg/s")
    return found


def _about(
    bench: Bench,
    setting: PreflightPlan,
    axis: str,
    done: frozenset[str],
    mounted: str,
    last: str,
    kept_nT: float | None,
) -> Work[None]:
    """Mount one body axis, unless the `last` one is to be redone first; then every turn about it.

    Where the turns are kept, its closure alone, with what the first position was then (`kept_nT`).
    """
    yield setting.plan().begin(bench, f"mount-{axis}")
    if axis != mounted:
        yield from _mount_or_redo(bench, setting, f"mount-{axis}", f"mount-{axis}", axis, last)
        yield from _first_mode_again(bench, setting)
    if kept_nT is None:
        yield from _turns_about_it(bench, setting, axis, done)
    else:
        yield from _close_since(bench, setting, axis, kept_nT)


def _close_since(bench: Bench, setting: PreflightPlan, axis: str, kept_nT: float) -> Work[None]:
    """The closure that an interruption has kept from being measured: as that of the closing, by magnitudes."""
    yield setting.plan().begin(bench, f"closure-{axis}")
    yield from _all_hands_off(bench, setting)
    after = yield from _first_position(bench, setting)
    moved, u = abs(after.excess - kept_nT), float(np.sqrt(2) * after.u)
    yield from _closed(bench, f"closure {axis}", moved, u, setting.closure_nT, None)


def _turns_about_it(bench: Bench, setting: PreflightPlan, axis: str, done: frozenset[str]) -> Work[None]:
    """Every turn about one body axis; where another was up nothing of them is used, and they begin anew."""
    while True:
        try:
            return (yield from _turns(bench, setting, axis, done))
        except WrongAxis as wrong:
            yield from _mounted_wrongly(bench, f"wrong-axis-{axis}", wrong)
            yield not_used(bench, [name for name, _, _ in setting.left(axis, done)], str(wrong))
            setting.estimate.forget()
            yield setting.plan().begin(bench, f"mount-{axis}")
            yield from mount(bench, f"mount-{axis}", attitude(bench, axis), how_to_mount(axis))
            yield from _first_mode_again(bench, setting)


def _mounted_wrongly(bench: Bench, key: str, wrong: LimitNotMet) -> Work[None]:
    """Coils off, and ask whether it is mounted again. Raises `wrong` where the person stops."""
    yield from coils_off(bench)
    yield from standstill(bench)
    if (yield Prompt(bench.clock.now(), key, str(wrong), ("stop", REMOUNT))) != REMOUNT:
        raise wrong


def _mount_or_redo(bench: Bench, setting: PreflightPlan, step: str, key: str, axis: str, last: str) -> Work[None]:
    """Ask to mount `axis`; until that is done, the `last` axis may be mounted and turned anew, and then this `step`."""
    redo = (f"redo {last}",) if last else ()
    while (yield from mount(bench, key, attitude(bench, axis), how_to_mount(axis), *redo)) != "done":
        asked = f"Why is axis {last.upper()} redone? What was measured stays in the record, marked as not used."
        reason = yield Prompt(bench.clock.now(), f"redo-{last}", asked, ())
        yield not_used(bench, [name for name, _, _ in setting.turns(last)], reason or "")
        setting.estimate.forget()
        yield from mount(bench, f"mount-{last}", attitude(bench, last), how_to_mount(last))
        yield from _first_mode_again(bench, setting)
        setting = setting.without(last)
        yield from _turns_about_it(bench, setting, last, frozenset())
        yield setting.plan().begin(bench, step)


def _turns(bench: Bench, setting: PreflightPlan, axis: str, done: frozenset[str]) -> Work[None]:
    """Every turn about one body axis, with the first position before and after."""
    plan, mode_now, seen = setting.plan(), setting.modes[0], list[Turned]()
    yield from _all_hands_off(bench, setting)
    before = yield from _first_position(bench, setting)
    yield from measured(bench, first_of(axis), before.excess, before.u, "nT")
    for name, mode, field_nT in setting.left(axis, done):
        yield plan.begin(bench, name)
        if mode != mode_now:
            yield from switch_mode(bench, mode_now := mode)
            yield from _all_hands_off(bench, setting)
        work = partial(_one_turn, bench, setting, axis, setting.mounting(axis, done), name, mode, field_nT)
        blocks = yield from attempt(bench, name, work)
        seen += [look_at_turn(bench, AXES[axis], blocks)] if blocks else []
        if blocks and mode == setting.modes[0]:  # another mode may have another offset
            yield from setting.estimate.take(blocks)
    if (late := delay_of(seen)) is not None:
        yield from measured(bench, f"delay {axis}", *late, "s", LONGEST_DELAY_S)
    yield plan.begin(bench, f"closure-{axis}")
    if mode_now != setting.modes[0]:
        yield from switch_mode(bench, setting.modes[0])
        yield from _all_hands_off(bench, setting)
    after = yield from _first_position(bench, setting)
    moved = after.moved_from(before, attitude(bench, axis))
    u, mode = float(np.hypot(before.u, after.u)), setting.modes[0]
    ends = _two(before.standstill(mode), after.standstill(mode), attitude(bench, axis).tolist())
    yield from _closed(bench, f"closure {axis}", float(np.linalg.norm(moved)), u, setting.closure_nT, ends)


def _one_turn(
    bench: Bench, setting: PreflightPlan, axis: str, mounting: str, name: str, mode: str, field_nT: float
) -> Work[Blocks]:
    """One turn there or back, so that no cable is wound up; from where it begins, where one was broken off."""
    begins_deg = 360.0 if bench.platform.angle_deg() > 180 else 0.0
    if abs(bench.platform.angle_deg() - begins_deg) > AT_REST_DEG:
        yield from to_angle(bench, begins_deg)
    yield from energise(bench, inclined_field(bench, field_nT, setting.inclination_deg))
    to_deg = 360.0 - begins_deg
    rotation = Rotation(
        name, AXES[axis], mode, setting.rate_deg_per_s, to_deg, mounting, setting.step_deg, setting.dwell_s,
        setting.u_mounting_deg, setting.u_time_s,
    )  # fmt: skip
    blocks = yield from rotate_once(bench, rotation)
    refuse_unseen(bench, blocks)  # the DUT still stands there: the turn can be begun again
    return blocks


def _closing(bench: Bench, setting: PreflightPlan, first: First, last: str) -> Work[None]:
    """The first mounting, the first position and the zero again."""
    yield setting.plan().begin(bench, "closing")
    axis = setting.axes[0]
    yield from _mount_or_redo(bench, setting, "closing", f"mount-{axis}-again", axis, last)
    yield from _all_hands_off(bench, setting)
    spots, mode = (yield from _zero_and_first_position(bench, setting, "closing")), setting.modes[0]
    for number, (name, spot) in enumerate(zip(POSITIONS, spots, strict=True)):
        moved, u_nT = abs(spot.excess - first.excess_nT[number]), float(np.sqrt(2) * spot.u)
        ends = first.spots and _two(first.spots[number].standstill(mode), spot.standstill(mode), None)
        yield from _closed(bench, f"closure, {name}", moved, u_nT, setting.closure_nT, ends)
    yield from coils_off(bench)


def _two(before: Standstill, after: Standstill, body_from_cage: list[list[float]] | None) -> dict[str, Any]:
    return {"before": asdict(before), "after": asdict(after), "body_from_cage": body_from_cage}


def _zero_and_first_position(bench: Bench, setting: PreflightPlan, name: str) -> Work[tuple[Position, Position]]:
    """Coils off and in the first field: |DUT| − |reference| is what no remounting changes by much.

    Signs are left to axes-check, which follows the first time and has the DUT as a second witness.
    """
    off = yield from measure_ambient(bench, setting.zero_s, name=name)
    for field_nT in setting.fields_nT:  # known here, not an hour later
        bench.cage.refuse_beyond_limits(inclined_field(bench, field_nT, setting.inclination_deg))
    first_field = inclined_field(bench, setting.fields_nT[0], setting.inclination_deg)
    yield from energise(bench, first_field, confirm_signs=False)
    on = yield from record(bench, setting.dwell_s)
    spots = [position(bench, blocks) for blocks in (off, on)]
    for what, spot in zip(POSITIONS, spots, strict=True):
        yield from measured(bench, f"{name}: {what}", spot.excess, spot.u, "nT")
    return spots[0], spots[1]


def _all_hands_off(bench: Bench, setting: PreflightPlan) -> Work[None]:
    strongest = max(AXES_nT, SYNC_nT, *map(abs, setting.fields_nT)) / 1000
    yield from hands_off(bench, f"The coils go up to {strongest:g} µT and the platform turns.")


def _first_position(bench: Bench, setting: PreflightPlan) -> Work[Position]:
    """DUT and reference in the first field at angle 0."""
    yield from to_angle(bench, 0.0)
    yield from energise(bench, inclined_field(bench, setting.fields_nT[0], setting.inclination_deg))
    blocks = yield from record(bench, setting.dwell_s)
    return position(bench, blocks)


def _closed(
    bench: Bench, name: str, moved_nT: float, u_nT: float, limit_nT: float, ends: Mapping[str, Any] | None
) -> Work[None]:
    """A closure enters the uncertainty of the zero, as a drift that lies anywhere within it, and has to be met.

    `ends` are its two standstills, where both are known: the loop takes the effects that it finds off them.
    """
    data = {"name": name, "u_offset_nT": moved_nT / np.sqrt(12), **(ends or {})}
    yield Event(bench.clock.now(), CLOSURE, f"{name}: {moved_nT:.0f} nT, within which the zero lies", data)
    yield from _must_close(bench, name, moved_nT, u_nT, limit_nT)


def _must_close(bench: Bench, name: str, moved_nT: float, u_nT: float, limit_nT: float) -> Work[None]:
    result = yield from measured(bench, name, moved_nT, u_nT, "nT", limit_nT)
    if result.verdict == "FAIL":
        raise LimitNotMet(f"{name}: {moved_nT:.0f} nT is beyond {limit_nT:.0f} nT; something moved or drifted")
