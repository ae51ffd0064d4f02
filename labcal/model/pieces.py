"""One effect along a recording, some rows at a time, each as if all were there.

What follows as a state is carried from piece to piece; what looks at rows near by has them beside the piece's own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial

import numpy as np
from numpy.typing import NDArray

from labcal.model.between_rows import MOST
from labcal.model.calibration import Calibration
from labcal.model.effects import DELAY, LESS_ITSELF, Fitted, Scene, Shape, Term, load_shipped
from labcal.model.effects.inputs import channels_of, outside
from labcal.model.effects.past import Past, State
from labcal.model.readings import Readings
from labcal.model.records import EffectRecord

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
EITHER_WAY = {"begun high": 1.0, "begun low": -1.0}  # standard deviations of a state of which nothing is known yet
ROUNDS, SETTLED_nT = 100, 1e-7  # of a field without the effect that it drives; and the change that ends them
BESIDE = MOST  # usable rows beyond an effect's reach that a piece has on either side: what lies between rows needs them


@dataclass(frozen=True, slots=True, eq=False)
class Taken:
    """One effect in some rows (n), which is zero where it is not known."""

    value: Array  # (n, 3)
    jacobian: Array  # (n, 3, p) by its parameters in their order; zero where it is not known
    variance: Array  # (n, 3) of what its parameters do not say: what went before it, what comes after
    usable: Mask  # (n,) rows that have what it needs
    flags: Mapping[str, Mask]  # each (n,)
    late: Mask | None  # (n,) rows where its channel is not known so much earlier or later


@dataclass(frozen=True, eq=False)
class Recording:
    """All rows, and where their segments begin."""

    readings: Readings
    begins_known: bool = False  # whether what went before the first row left nothing that is unknown

    def __len__(self) -> int:
        return len(self.readings)

    @cached_property
    def edges(self) -> NDArray[np.intp]:
        """The first row of each segment, and the end."""
        segment = self.readings.segment
        changes = np.empty(0, dtype=np.intp) if segment is None else np.flatnonzero(segment[1:] != segment[:-1]) + 1
        return np.concatenate([[0], changes, [len(self)]]).astype(np.intp)

    @cached_property
    def in_order(self) -> bool:
        """Whether time grows from each row to the next."""
        t_s = self.readings.t_s
        return t_s is not None and bool((t_s[1:] > t_s[:-1]).all())

    def segments(self, rows: slice) -> NDArray[np.intp]:
        """Which segment each of the rows is of, counted from the recording's start."""
        return np.searchsorted(self.edges[1:-1], np.arange(rows.start, rows.stop), side="right")

    def out_of_reach(self, rows: slice, lag_s: Array | float) -> Mask:
        """Rows whose reading a lag later lies beyond their segment's ends."""
        t_s, number = self.readings.t_s, self.segments(rows)
        assert t_s is not None
        later = t_s[rows] + lag_s
        return np.asarray((later < t_s[self.edges[number]]) | (later > t_s[self.edges[number + 1] - 1]))


def remembers(effect: Fitted) -> bool:
    """Whether a row's effect depends on other rows."""
    return effect.family.reach_s(effect.term) is not None and not effect.family.bound_to_run


class Walk:
    """An effect of a calibration that walks along a recording once, piece after piece from the first row on."""

    def __init__(self, calibration: Calibration, record: EffectRecord, recording: Recording) -> None:
        self._calibration, self._record, self._recording = calibration, record, recording
        self.effect = load_shipped(record)
        self._reach_s = (self.effect.family.reach_s(self.effect.term) or 0.0) if remembers(self.effect) else 0.0
        self._left: dict[str, Mapping[str, State]] = {}
        self._ends = {n: (d.hull[0][0], d.hull[-1][0]) for d in record.domain for n in channels_of(d.inputs)}
        self._steps = self._steps_of_shapes()

    @property
    def at_once(self) -> bool:
        """Whether all rows are one piece: of an effect that remembers in its own way, or where time goes back."""
        return remembers(self.effect) and not (self.effect.family.in_pieces and self._recording.in_order)

    def rows_within_reach(self) -> int:
        """How many rows, on the mean, the effect reaches over."""
        t_s = self._recording.readings.t_s
        if self._reach_s == 0 or t_s is None or len(t_s) < 2 or self.at_once:
            return 0
        return int(len(t_s) * min(self._reach_s / (t_s[-1] - t_s[0]), 1.0))

    def take(self, rows: slice) -> Taken:
        """The effect in the rows that follow."""
        lacking, n = self._lacking(rows), rows.stop - rows.start
        usable, flags = ~np.logical_or.reduce(list(lacking.values())), {w: m for w, m in lacking.items() if w}
        value, variance, jacobian = np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n, 3, len(self._record.parameters)))
        if usable.any():
            columns, slopes = self._columns(rows, self.effect.term), self._slopes(rows)
            value[usable] = columns @ self.effect.beta
            linear = [name for name, _ in self.effect.term.parameters]
            for place, parameter in enumerate(self._record.parameters):
                if parameter.name in linear:
                    jacobian[usable, :, place] = columns[:, :, linear.index(parameter.name)]
                elif parameter.name in slopes:
                    jacobian[usable, :, place] = (slopes[parameter.name] - value[usable]) / self._steps[parameter.name]
            if self._left.get("") and not self._recording.begins_known:  # it is a state, that begins somewhere
                begun = [self._columns(rows, self.effect.term, one) @ self.effect.beta for one in EITHER_WAY]
                variance[usable] = np.mean([np.square(one - value[usable]) for one in begun], axis=0)
            if (off := self.effect.family.unsure) is not None:
                missed = self._columns(rows, self.effect.term, "unsure", partial(off, self.effect.term))
                variance[usable] += np.square(missed @ self.effect.beta)
        if self._record.domain:
            flags["domain"] = flags.get("domain", False) | self._outside(rows)
        if self._record.basis is not None:  # what has no name is no more than it was seen to be
            usable &= ~flags["domain"]
            value[~usable], jacobian[~usable] = 0.0, 0.0
        if self.effect.term.found_by("own secant") is not None:
            ahead_s = self.effect.family.secant_s(self.effect.term, self._time(rows))
            flags["rate"] = self._recording.out_of_reach(rows, ahead_s)
            variance[flags["rate"]] += value[flags["rate"]] ** 2
        if (moment := self.effect.term.found_by("changepoints")) is not None:
            unsure = self._beside(moment, rows)
            flags["time"] = flags.get("time", unsure) | unsure
            variance[unsure] += self._jump(rows, unsure) ** 2 / 4
        return Taken(value, jacobian, variance, usable, flags, self._late(rows))

    def _outside(self, rows: slice) -> Mask:
        """Rows (n,) that have what the effect depends on, and lie where it was not seen."""
        around = self._near(rows) if self._reach_s and not self.at_once else rows
        usable = self._usable(around)
        out = np.zeros(len(usable), dtype=bool)
        if usable.any():
            out[usable] = outside(self._record.domain, self._scene(around, usable, None))
        return out[rows.start - around.start : rows.stop - around.start]

    def _slopes(self, rows: slice) -> dict[str, Array]:
        """The effect (m, 3) in the usable ones of the rows, each uncertain shape of it a step further."""
        shapes = {shape.name: shape for shape in self.effect.term.shape}
        moved = {n: self.effect.term.with_values(**{n: shapes[n].value + step}) for n, step in self._steps.items()}
        return {name: self._columns(rows, term, name) @ self.effect.beta for name, term in moved.items()}

    def _steps_of_shapes(self) -> dict[str, float]:
        """Steps over which the effect is straight in its uncertain shapes; moments and secants have rules of their own.

        One of an hour's rows where the recording has no time.
        """
        t_s, u = self._time(slice(None)), {p.name: p.u for p in self._record.parameters}
        if len(t_s) < 2 or not t_s[-1] > t_s[0]:
            t_s = np.linspace(0.0, 3600.0, 3601)
        searched = [s for s in self.effect.term.shape if s.kind.found_by not in ("changepoints", "own secant")]
        steps = {s.name: s.step(t_s) for s in searched if u[s.name] > 0}
        return {name: step for name, step in steps.items() if np.isfinite(step) and step > 0}

    def _columns(
        self, rows: slice, term: Term, variant: str = "", columns_of: Callable[[Scene], Array] | None = None
    ) -> Array:
        """A term's columns in the usable ones of the rows; what it leaves is where that variant goes on from.

        Of an effect that the field without it drives, where that field holds no more than was taken off it.
        """
        if term.of(LESS_ITSELF) is None:
            return self._driven(rows, term, variant, columns_of, 0.0)
        went_before, change = self._left.get(variant, {}), np.inf
        held: Array | float = 0.0
        for _ in range(ROUNDS):
            self._left[variant] = went_before
            columns = self._driven(rows, term, variant, columns_of, held)
            value = columns @ self.effect.beta
            last, change = change, float(np.max(np.abs(value - held), initial=0.0))
            held = value
            if change < SETTLED_nT or not change < last:
                break
        return columns

    def _driven(
        self,
        rows: slice,
        term: Term,
        variant: str,
        columns_of: Callable[[Scene], Array] | None,
        less_nT: Array | float,
    ) -> Array:
        """The same in the field less so much (m, 3)."""
        around = self._near(rows) if self._reach_s and not self.at_once else rows
        while True:
            usable = self._usable(around)
            first, last = rows.start - around.start, rows.stop - around.start
            before, own = int(usable[:first].sum()), int(usable[first:last].sum())
            astray = EITHER_WAY.get(variant, 0.0)
            past = Past(own, self._left.get(variant, {}), astray=astray, ends=self._ends)
            columns = (columns_of or term.columns)(self._scene(around, usable, past).moved(-less_nT))
            if not self._beyond(around.stop, past.until_s):
                self._left[variant] = past.after
                return columns[before : before + own]
            around = slice(rows.start, int(np.searchsorted(self._time(slice(None)), past.until_s, side="right")))

    def _beyond(self, row: int, until_s: float) -> bool:
        """Whether there are rows from `row` on until then."""
        return row < len(self._recording) and until_s > -np.inf and bool(self._time(slice(row, row + 1))[0] <= until_s)

    def _near(self, rows: slice) -> slice:
        """The rows and those within reach of them, and a few beyond that are usable too."""
        t_s = self._time(slice(None))
        start = int(np.searchsorted(t_s, t_s[rows.start] - self._reach_s))
        stop = int(np.searchsorted(t_s, t_s[rows.stop - 1] + self._reach_s, side="right"))
        back = ahead = BESIDE
        while start > back and self._usable(slice(start - back, start)).sum() < BESIDE:
            back *= 2
        while stop + ahead < len(t_s) and self._usable(slice(stop, stop + ahead)).sum() < BESIDE:
            ahead *= 2
        return slice(max(start - back, 0), min(stop + ahead, len(t_s)))

    def _usable(self, rows: slice) -> Mask:
        return np.asarray(~np.logical_or.reduce(list(self._lacking(rows).values())))

    def _lacking(self, rows: slice) -> dict[str, Mask]:
        """Rows (n,) that lack what the effect needs, by the flag that they get, "" where they get none."""
        readings, record = self._recording.readings, self._record
        lacking: dict[str, Mask] = {"": np.asarray(~np.isfinite(self._field(rows)).all(axis=1))}
        for name in record.channels:
            word = "temperature" if self.effect.family.of_temperature else "domain"
            missing = ~np.isfinite(readings.channels[name][rows])
            lacking[word] = lacking[word] | missing if word in lacking else missing
        if self.effect.family.is_bound_to_run(self.effect.term) and readings.t_s is not None:
            first, last = self._calibration.span_s
            lacking["time"] = ~((readings.t_s[rows] >= first) & (readings.t_s[rows] <= last))
        own_modes, mode = self.effect.family.modes, readings.rows(rows.start, rows.stop).mode
        if own_modes is not None and mode is not None:
            lacking["mode"] = ~np.isin(mode, self._known_modes(own_modes(self.effect.term)))
        return lacking

    def _scene(self, rows: slice, usable: Mask, past: Past | None) -> Scene:
        part = self._recording.readings.rows(rows.start, rows.stop)
        channels = {name: part.channels[name][usable] for name in self._record.channels}
        mode = None if part.mode is None else part.mode[usable]
        axes = self._calibration.affine.K / self._calibration.dut.nominal_nT_per_unit
        segment, field_nT = self._recording.segments(rows)[usable], self._field(rows)[usable]
        return Scene(self._time(rows)[usable], segment, field_nT, channels, mode, axes, past=past)

    def _field(self, rows: slice) -> Array:
        return self._calibration.affine.apply(self._recording.readings.reading[rows])

    def _time(self, rows: slice) -> Array:
        t_s = self._recording.readings.t_s
        return np.zeros(len(range(*rows.indices(len(self._recording))))) if t_s is None else t_s[rows]

    def _known_modes(self, own: Sequence[str]) -> list[str]:
        """Modes that have parameters of their own, and the one that k belongs to: that may be "", a row without one."""
        base = [mode for mode in self._calibration.validity.modes if mode not in own]
        return [*own, *(base or [""])]

    def _beside(self, moment: Shape, rows: slice) -> Mask:
        """Rows (n,) of which nobody knows on which side of the moment they lie: it was between two rows of the run."""
        u = next(p.u for p in self._record.parameters if p.name == moment.name)
        return np.asarray(np.abs(self._time(rows) - moment.value) < np.sqrt(3) * u * (1 - 1e-6))

    def _jump(self, rows: slice, which: Mask) -> Array:
        """What the effect is after its moment (m, 3), in some of the rows; 0 where it lacks what it needs."""
        usable, jump = self._usable(rows) & which, np.zeros((len(which), 3))
        jump[usable] = self.effect.term.stepped().columns(self._scene(rows, usable, None)) @ self.effect.beta
        return jump[which]

    def _late(self, rows: slice) -> Mask | None:
        """Rows (n,) whose channel a delay earlier lies beyond their segment's ends; None for an effect without one."""
        delay = self.effect.term.of(DELAY)
        return self._recording.out_of_reach(rows, -delay.value) if delay is not None and delay.value else None
