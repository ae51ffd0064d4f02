"""Test vectors: readings and channels, and the field and u that `apply` gives for them.

They are rows of the calibration's own run where that is at hand, else made up within its validity. Where effects bound
to the run are left out, the rows' clock is moved beyond the run's span: there `apply` leaves them out too.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.certificate.flight.content import Content, Flown, stamps, without_lag
from labcal.model import Calibration
from labcal.model.apply import apply, linearised, needed_columns
from labcal.model.effects import DELAY, Scene
from labcal.model.effects.c_form import Input, mode_enumerator
from labcal.model.effects.inputs import channels_of
from labcal.model.effects.regressors import delayed
from labcal.model.pieces import Recording, Walk
from labcal.model.readings import Applied, Readings, readings_of
from labcal.model.seen import Seen
from labcal.record import Run

Array = NDArray[np.float64]
MOST = 3000  # rows
STRETCHES = 6
APART_S = 1000.0  # from the run's span
WAY = 0.2  # of a made-up channel about where it counts from, where nothing states what was seen of it
BEYOND = 1.1  # of what was seen: a term is left out outside
UNSURE = {"saturated", "outlier", "rate"}  # flags that rest on rows to come: u is not compared there


@dataclass(frozen=True, slots=True, eq=False)
class Vectors:
    """n rows: as flight software is given them, as `apply` was, and what it answered."""

    rows: Readings  # segments are numbers from 0
    stamped: Readings  # at the time that the field belongs to
    applied: Applied
    late: NDArray[np.bool_]  # (n,) a channel that is ahead ends before: u is larger than anybody in flight can know
    of_the_run: bool


def vectors_of(content: Content, run: Run | None) -> Vectors:
    """The rows that the generated test checks."""
    rows = _complete(content, readings_of(run)) if run is not None else None
    measured = rows is not None and len(rows) > 0
    rows = _thinned(rows) if rows is not None and measured else _made_up(content)
    assert rows.t_s is not None
    if content.left_out:
        rows = replace(rows, t_s=rows.t_s - rows.t_s[0] + content.calibration.span_s[1] + APART_S)
    stamped = _stamped(rows, content.lag_s)
    applied = apply(without_lag(content.calibration), stamped, begins_known=True)  # flight software knows of no before
    if any(stamps(one.effect) for one in content.effects):
        applied = _by_slopes_behind(content, stamped, applied)
    return Vectors(rows, stamped, applied, _late(content, stamped), measured)


def scene(content: Content, readings: Readings) -> Scene:
    """What the inputs of effects are worked out from."""
    assert readings.t_s is not None
    assert readings.segment is not None
    field = content.calibration.affine.apply(readings.reading)
    numbers = np.unique(readings.segment, return_inverse=True)[1]
    return Scene(readings.t_s, numbers, field, readings.channels, readings.mode, content.axes)


def input_columns(content: Content, inputs: tuple[Input, ...], vectors: Vectors) -> Array:
    """The inputs of each row (n, k): channels as recorded, all else for the time that the field belongs to."""
    given, stamped = scene(content, vectors.rows), scene(content, vectors.stamped)
    columns = [one.values(given if one.channel else stamped) for one in inputs]
    begins = np.r_[True, np.diff(given.segment) != 0]
    columns = [np.where(begins, c, 0.0) if i.where_it_begins else c for i, c in zip(inputs, columns, strict=True)]
    return np.column_stack(columns) if columns else np.zeros((len(vectors.rows), 0))


def compared(vectors: Vectors) -> NDArray[np.bool_]:
    """Rows (n,) whose u rests on nothing that comes later."""
    unsure = [bool(UNSURE & set(flag.split())) for flag in vectors.applied.flags]
    return ~(np.array(unsure, dtype=bool) | vectors.late)


def seen(content: Content, vectors: Vectors) -> list[Seen]:
    """How large each effect that flies is over the rows."""
    recording, found = Recording(vectors.stamped), []
    for one in content.effects:
        taken = Walk(content.calibration, one.record, recording).take(slice(0, len(recording)))
        found.append(Seen())
        found[-1].take(taken.value, taken.usable)
    return found


def written(content: Content, inputs: tuple[Input, ...], modes: dict[str, int], vectors: Vectors) -> str:
    """The CSV: t_s, segment, mode, dut_x …, inputs; then t_field_s, b_x …, u_nT (empty where it is not compared)."""
    names = ["t_s", "segment", "mode", "dut_x", "dut_y", "dut_z", *(one.name for one in inputs)]
    rows, applied = vectors.rows, vectors.applied
    mode = [""] * len(rows) if rows.mode is None else rows.mode.tolist()
    numbers = np.column_stack([rows.reading, input_columns(content, inputs, vectors)])
    assert rows.t_s is not None
    assert rows.segment is not None
    assert vectors.stamped.t_s is not None
    lines = [",".join([*names, "t_field_s", "b_x", "b_y", "b_z", "u_nT"])]
    for i, known in enumerate(compared(vectors)):
        head = [_cell(rows.t_s[i]), str(rows.segment[i]), str(modes.get(mode_enumerator(mode[i]), -1))]
        tail = [vectors.stamped.t_s[i], *applied.field_nT[i]]
        u = _cell(applied.u_nT[i]) if known else ""
        lines.append(",".join([*head, *map(_cell, numbers[i]), *map(_cell, tail), u]))
    return "\n".join(lines) + "\n"


def _cell(value: float) -> str:
    return repr(float(value))


def _complete(content: Content, readings: Readings) -> Readings | None:
    """Those rows of a recording that lack nothing, their segments numbered; None where it lacks a column."""
    wanted = [n for n in needed_columns(content.calibration) if n not in ("t_s", "segment", "mode")]
    if not set(wanted) <= readings.channels.keys() or readings.t_s is None or readings.segment is None:
        return None
    channels = {name: readings.channels[name] for name in wanted}
    numbers = np.column_stack([readings.reading, *channels.values()])
    known = np.asarray(np.isfinite(numbers).all(axis=1))
    edges = Recording(readings).edges
    number = np.searchsorted(edges[1:-1], np.arange(len(readings)), side="right")
    return _some(Readings(readings.reading, readings.t_s, number, readings.mode, channels), known)


def _thinned(readings: Readings) -> Readings:
    """A few long stretches of a recording that has very many rows."""
    n = len(readings)
    if n <= MOST:
        return readings
    length = MOST // STRETCHES
    starts = np.linspace(0, n - length, STRETCHES).astype(int)
    return _some(readings, np.isin(np.arange(n), np.concatenate([np.arange(a, a + length) for a in starts])))


def _some(readings: Readings, which: NDArray[np.bool_]) -> Readings:
    t_s, segment, mode = (None if c is None else c[which] for c in (readings.t_s, readings.segment, readings.mode))
    channels = {name: values[which] for name, values in readings.channels.items()}
    return Readings(readings.reading[which], t_s, segment, mode, channels)


def _made_up(content: Content) -> Readings:
    """Two turns of the field through the validity, channels moving through where they were seen, and a little on."""
    calibration, n = content.calibration, 400
    t = 0.25 * np.arange(n, dtype=np.float64)
    segment = np.repeat([0, 1], n // 2)
    turn = t / 6 + segment
    direction = np.column_stack([np.cos(turn), np.sin(turn), np.cos(2.3 * turn)])
    length = np.mean(calibration.validity.field_nT) or 1.0
    field = length * direction / np.linalg.norm(direction, axis=1)[:, None]
    reading = np.asarray((field + calibration.affine.k_nT) @ np.linalg.inv(calibration.affine.K).T, dtype=np.float64)
    moves = {name: (at, WAY) for record in calibration.effects for name, at in record.reference_value.items()}
    moves |= {name: ((low + high) / 2, BEYOND * (high - low) / 2) for name, (low, high) in _seen_ends(calibration)}
    channels = {name: at + way * np.sin(t / (5 + i)) for i, (name, (at, way)) in enumerate(moves.items())}
    modes = np.array(calibration.validity.modes or ("",))[np.arange(n) // 20 % max(len(calibration.validity.modes), 1)]
    return Readings(reading, t, segment, modes, channels)


def _seen_ends(calibration: Calibration) -> Iterator[tuple[str, tuple[float, float]]]:
    """Each channel that a domain states, and between which values it was seen."""
    for domain in (one for record in calibration.effects for one in record.domain):
        corners = np.array(domain.hull)
        for place, given in enumerate(domain.inputs):
            for name in channels_of((given,)):
                yield name, (float(corners[:, place].min()), float(corners[:, place].max()))


def _stamped(rows: Readings, lag_s: float) -> Readings:
    """The same at the time that the field belongs to: channels are taken there, as far back as they are known."""
    if lag_s == 0:
        return rows
    t_s, segment = rows.t_s, rows.segment
    assert t_s is not None
    assert segment is not None
    back = max(lag_s, 0.0)
    channels = {name: delayed(t_s, segment, values, back) for name, values in rows.channels.items()}
    return replace(rows, t_s=t_s - lag_s, channels=channels)


def _by_slopes_behind(content: Content, readings: Readings, applied: Applied) -> Applied:
    """The same with the part of u that is a lag's from the slope since the reading before: the next is not there yet.

    Rows that have a flag, and so another u, are flagged as not to be compared.
    """
    _, slopes = linearised(without_lag(content.calibration), readings)
    own, covariance = slopes.copy(), content.calibration.joint_covariance()
    assert readings.t_s is not None
    assert readings.segment is not None
    field = content.calibration.affine.apply(readings.reading)
    slope = np.diff(field, axis=0, prepend=field[:1]) / np.diff(readings.t_s, prepend=np.inf)[:, None]
    slope[np.r_[True, np.diff(readings.segment) != 0]] = 0.0
    for one in content.effects:
        if stamps(one.effect):
            own[:, :, _column(content, one)] = slope
    more = np.sum(own @ covariance * own - slopes @ covariance * slopes, axis=2).mean(axis=1)
    flags = tuple(f"{flag} rate" if flag else "" for flag in applied.flags)
    return replace(applied, u_nT=np.sqrt(applied.u_nT**2 + more), flags=flags)


def _column(content: Content, one: Flown) -> int:
    """Where its first linear parameter stands among those of the whole calibration."""
    before = sum(len(record.parameters) for record in content.calibration.effects[: one.place])
    names = [p.name for p in one.record.parameters]
    return 12 + before + names.index(one.effect.term.parameters[0][0])


def _late(content: Content, readings: Readings) -> NDArray[np.bool_]:
    found = np.zeros(len(readings), dtype=bool)
    for one in content.effects:
        taken = Walk(content.calibration, one.record, Recording(readings)).take(slice(0, len(readings)))
        delay = one.effect.term.of(DELAY)
        if taken.late is not None and delay is not None and delay.value < 0:
            found |= taken.late
    return found
