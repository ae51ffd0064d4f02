"""From streams, each at its own stamps, to a `Run`: one row is one DUT sample. Pure numpy."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.record.closure import Closure, Standstill
from labcal.record.header import RunHeader
from labcal.record.run import Channel, Reference, Run, Segment
from labcal.record.sampling import period_s
from labcal.record.stream import (
    CLOSURE,
    NOT_USED,
    RESUMED,
    Block,
    Event,
    Item,
    ModeChanged,
    SegmentClosed,
    SegmentOpened,
    Stream,
)

Array = NDArray[np.float64]

DUT = ("dut_x", "dut_y", "dut_z")
REACH = 2.0  # periods of a stream that a neighbour may be away from the row (contract: run bundle)
SHORTEST_S = 1e-6  # between two samples


def assemble(header: RunHeader, items: Iterable[Item]) -> Run:
    """The run that `items` recorded: the DUT's samples inside segments, everything else brought to their stamps.

    Reference, angle and channels are interpolated linearly between the two neighbours where both lie within two
    of their stream's own periods (`period_s`), else NaN; they are never held. The angle is unwrapped before. Modes
    are the last known. Samples between segments belong to none and are left out; so do those of segments that an
    Event says are not used.
    """
    items = list(items)
    stretches = _stretches(items)
    t, readings = _readings(_blocks(items, "dut"), DUT)
    place = _place(stretches, t)
    t, readings, place = t[place >= 0], readings[place >= 0], place[place >= 0]
    references, kind = _blocks(items, "reference"), header.reference.kind
    angles = _blocks(items, "angle")
    return Run(
        run_id=header.run_id,
        started_utc=header.started_utc,
        simulated=header.simulated,
        operator=header.operator,
        dut=header.dut,
        reference=_with_closure(header.reference, items),
        segments=tuple(stretch.segment for stretch in stretches),
        t_s=t,
        segment_index=place,
        reading=readings,
        reference_vector=interpolated(t, *_readings(references, ("ref_x", "ref_y", "ref_z")))
        if kind == "vector"
        else None,
        reference_magnitude=interpolated(t, *_readings(references, ("ref_f",)))[:, 0] if kind == "scalar" else None,
        angle_deg=_angle(t, angles) if angles else None,
        row_mode=_modes(t, items),
        environment=header.environment,
        channels=_channels(header, t, items),
        specification=header.specification,
        closures=_closures(items),
        administrative=header.administrative,
    )


def _with_closure(reference: Reference, items: Iterable[Item]) -> Reference:
    """`reference` with the largest closure in the uncertainty of its zero; one that is not stated stays unknown."""
    moved = [float(i.data["u_offset_nT"]) for i in items if isinstance(i, Event) and i.kind == CLOSURE]
    if reference.u_offset_nT is None or not moved:
        return reference
    return replace(reference, u_offset_nT=float(np.hypot(reference.u_offset_nT, max(moved))))


def _closures(items: Iterable[Item]) -> tuple[Closure, ...]:
    """Those whose two standstills were recorded; of a run that was broken off only numbers are left of the first."""
    events = (item for item in items if isinstance(item, Event) and item.kind == CLOSURE and "before" in item.data)
    return tuple(
        Closure(
            event.data["name"],
            float(event.data["u_offset_nT"]),
            Standstill(**event.data["before"]),
            Standstill(**event.data["after"]),
            event.data["body_from_cage"],
        )
        for event in events
    )


@dataclass(frozen=True, slots=True)
class _Stretch:
    segment: Segment
    start_s: float
    end_s: float
    named: str  # as it was opened, without a number


def _stretches(items: Sequence[Item]) -> list[_Stretch]:
    """Segments that are used, with their times; one that is opened again is of its own, a number behind its id.

    One that was open when the run broke off ends where the run is gone on with: what is recorded from there on is
    of other steps.
    """
    found: list[_Stretch] = []
    unused: set[str] = set()
    for item in items:
        if isinstance(item, Event) and item.kind == NOT_USED:
            unused |= {one.segment.id for one in found if one.named in item.data["segments"]}
        if not isinstance(item, SegmentOpened | SegmentClosed | Event):
            continue
        if isinstance(item, Event) and item.kind != RESUMED:
            continue
        if found and found[-1].end_s == np.inf:
            found[-1] = replace(found[-1], end_s=item.t_s)
        if isinstance(item, SegmentOpened):
            found.append(_Stretch(_own_id(item.segment, found), item.t_s, np.inf, item.segment.id))
    return [one for one in found if one.segment.id not in unused]


def _own_id(segment: Segment, before: Sequence[_Stretch]) -> Segment:
    taken, name, number = {stretch.segment.id for stretch in before}, segment.id, 1
    while name in taken:
        number += 1
        name = f"{segment.id}-{number}"
    return segment if number == 1 else replace(segment, id=name)


def _place(stretches: Sequence[_Stretch], t: Array) -> NDArray[np.intp]:
    """Which stretch each time (n,) lies in; -1 where in none. A stretch begins with its start, its end is outside."""
    if not stretches:
        return np.full(len(t), -1, dtype=np.intp)
    starts = np.array([stretch.start_s for stretch in stretches])
    ends = np.array([stretch.end_s for stretch in stretches])
    place = np.searchsorted(starts, t, side="right") - 1
    return np.where((place >= 0) & (t < ends[place]), place, -1)


def _blocks(items: Iterable[Item], stream: Stream) -> list[Block]:
    return [item for item in items if isinstance(item, Block) and item.stream == stream and len(item)]


def _samples(blocks: Sequence[Block], columns: Sequence[str]) -> tuple[Array, Array]:
    """Stamps (n,), growing, and values (n, k) of the blocks that have `columns`; of equal stamps the first counts."""
    t, values, _ = _stacked(blocks, columns)
    if np.all(np.diff(t) > 0):
        return t, values
    t, first = np.unique(t, return_index=True)
    return t, values[first]


def _readings(blocks: Sequence[Block], columns: Sequence[str]) -> tuple[Array, Array]:
    """As `_samples`, but all of a block: those that came in one piece have one stamp, and are put apart."""
    t, values, block = _stacked(blocks, columns)
    if np.all(np.diff(t) > 0):
        return t, values
    order = np.argsort(t, kind="stable")
    t, values, block = t[order], values[order], block[order]
    _, first, which = np.unique(t, return_index=True, return_inverse=True)
    ours = block == block[first[which]]
    return _apart(t[ours]), values[ours]


def _stacked(blocks: Sequence[Block], columns: Sequence[str]) -> tuple[Array, Array, NDArray[np.intp]]:
    """Stamps (n,) and values (n, k) as they were recorded, and the number of the block of each."""
    useful = [block for block in blocks if set(columns) <= set(block.columns)]
    if not useful:
        return np.empty(0), np.empty((0, len(columns))), np.empty(0, dtype=np.intp)
    picked = [block.values[:, [block.columns.index(c) for c in columns]] for block in useful]
    number = np.repeat(np.arange(len(useful)), [len(block) for block in useful])
    return np.concatenate([block.t_s for block in useful]), np.concatenate(picked), number


def _apart(t: Array) -> Array:
    """Sorted stamps (n,) made to grow: equal ones lie the mean period apart, or closer where the next stamp is near."""
    distinct, first, count = np.unique(t, return_index=True, return_counts=True)
    period = max(float(t[-1] - t[0]) / (len(t) - 1), SHORTEST_S)
    step = np.minimum(np.append(np.diff(distinct), np.inf) / count, period)
    place = np.arange(len(t)) - np.repeat(first, count)
    return np.asarray(t + place * np.repeat(step, count))


def interpolated(when: Array, t: Array, values: Array) -> Array:
    """`values` (n, k) at stamps `t` (n,) brought to `when` (m,): shape (m, k), NaN where a neighbour is too far."""
    period = period_s(t) if len(t) > 1 else 0.0
    if not len(t) or not np.isfinite(values).all():
        return np.stack([_column_at(when, t, column, period) for column in values.T], axis=1)
    beyond = _beyond(when, t, period)
    return np.stack([np.where(beyond, np.nan, np.interp(when, t, column)) for column in values.T], axis=1)


def _column_at(when: Array, t: Array, values: Array, period: float) -> Array:
    there = np.isfinite(values)
    t, values = t[there], values[there]
    if not len(t):
        return np.full(len(when), np.nan)
    return np.where(_beyond(when, t, period), np.nan, np.interp(when, t, values))


def _beyond(when: Array, t: Array, period: float) -> NDArray[np.bool_]:
    """Which of `when` (m,) have a neighbour among `t` (n,) that is too far, or none on one side."""
    after = np.clip(np.searchsorted(t, when, side="left"), 0, len(t) - 1)
    before = np.where(t[after] == when, after, after - 1).clip(0)
    far = np.maximum(np.abs(when - t[before]), np.abs(t[after] - when)) > REACH * period * (1 + 1e-9)
    return np.asarray(far | (when < t[0]) | (when > t[-1]))


def _angle(when: Array, blocks: Sequence[Block]) -> Array:
    t, values = _samples(blocks, ("angle_deg",))
    there = np.isfinite(values[:, 0])
    return interpolated(when, t[there], np.unwrap(values[there], period=360.0, axis=0))[:, 0]


def _modes(when: Array, items: Iterable[Item]) -> NDArray[np.str_] | None:
    changes = sorted((item for item in items if isinstance(item, ModeChanged)), key=lambda change: change.t_s)
    if not changes:
        return None
    names = np.array(["", *(change.mode for change in changes)], dtype=np.str_)
    return names[np.searchsorted([change.t_s for change in changes], when, side="right")]


def _channels(header: RunHeader, when: Array, items: Iterable[Item]) -> tuple[Channel, ...]:
    """The header's channels that were recorded, in the header's order."""
    blocks = _blocks(items, "channel")
    recorded = {column for block in blocks for column in block.columns}
    return tuple(
        Channel(
            spec.name, spec.unit, spec.quantity, interpolated(when, *_samples(blocks, (spec.name,)))[:, 0], spec.role
        )
        for spec in header.channels
        if spec.name in recorded
    )
