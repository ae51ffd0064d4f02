"""Readings in, field out: a calibration applied row by row, with its uncertainty and what to be wary of."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.model.affine import jacobian
from labcal.model.calibration import Calibration, EffectRecord
from labcal.model.effects import Fitted, Scene, load_shipped
from labcal.model.effects.following import has_memory, time_constants
from labcal.model.gaps import bridged
from labcal.model.plausibility import bends, saturated, second_difference_outliers
from labcal.model.readings import Applied, Readings
from labcal.model.seen import Seen

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
FLAGS = ("saturated", "outlier", "field", "temperature", "rate", "mode", "time")
TEMPERATURE = frozenset({"offset-temperature", "gain-temperature"})
MATERIAL = 1.15  # held-out residuals beyond this many times the noise are more than noise
FEW = 8  # rows of a channel: fewer do not tell what it does in a gap
REMEMBERING = frozenset({"lag", "hysteresis"})  # and whatever has a time constant


def needed_columns(calibration: Calibration) -> tuple[str, ...]:
    """Columns beside the reading without which the calibration's effects cannot be computed."""
    names = dict.fromkeys(name for record in calibration.effects for name in record.channels)
    for effect in map(load_shipped, calibration.effects):
        if effect.family.bound_to_run or remembers(effect):
            names["t_s"] = None
        if remembers(effect):
            names["segment"] = None
        if effect.family.id == "offset-mode":
            names["mode"] = None
    return tuple(names)


def remembers(effect: Fitted) -> bool:
    """Whether a row's effect depends on the rows before it."""
    return (has_memory(effect.term) and not effect.family.bound_to_run) or effect.family.id in REMEMBERING


def forgets(effect: Fitted) -> bool:
    """Whether nothing of an effect that remembers goes over into another segment."""
    kept = any(shape.name == "kept" and shape.value == 1 for shape in effect.term.shape)
    delayed = any(shape.name == "delay_s" for shape in effect.term.shape)
    return not kept and not delayed and not any(time_constants(effect.term))


def apply(calibration: Calibration, readings: Readings) -> Applied:
    """B = K m − k − Σ e_i of the sensor's effects, for every row (contract: calibration, `apply`).

    u_nT is the root mean square over the components of: covariance of K and k, noise of the reading through K, each
    effect's parameters, and what is left out. A channel's gaps are bridged where they can be told. Raises InputError
    where a needed column is missing, or an effect of the file is not whole.
    """
    return next(apply_in_pieces(calibration, readings, max(len(readings), 1)))


def apply_in_pieces(calibration: Calibration, readings: Readings, most: int) -> Iterator[Applied]:
    """As `apply`, for `most` rows at a time, each as if all were there: what they take from the whole is found first.

    Where effects remember, a stretch that they remember is one piece, however long it is.
    """
    have = {*readings.channels, *(n for n in ("t_s", "segment", "mode") if getattr(readings, n) is not None)}
    for name in needed_columns(calibration):
        if name not in have:
            raise InputError("the calibration's effects need this column; it is missing", column=name)
    readings, filled = _filled(readings)
    pieces = _pieces(calibration, readings, most)
    alone = _corrected(calibration, readings.rows(0, len(readings))) if len(pieces) == 1 else None  # not twice
    whole = _survey(calibration, readings, pieces, alone)
    for rows in pieces:
        part = readings.rows(rows.start, rows.stop)
        yield _applied(calibration, part, alone or _corrected(calibration, part), whole, filled, rows)


@dataclass(frozen=True, slots=True, eq=False)
class _Corrected:
    """Some rows with the effects taken off, and what each effect was there."""

    field_nT: Array  # (n, 3)
    values: tuple[Array, ...]  # of each effect (n, 3)
    variances: tuple[Array, ...]  # of each effect (n, 3)
    usable: tuple[Mask, ...]  # of each effect: rows (n,) that have what it needs
    flags: dict[str, Mask]


@dataclass(frozen=True, slots=True, eq=False)
class _Whole:
    """What a row's result takes from the whole recording (n rows)."""

    sizes: tuple[Array, ...]  # (3,) of each effect: its mean square, for rows that go without it
    restless: tuple[Array, ...]  # (3,) of each effect: the mean square of its change from row to row
    saturated: Mask  # (n,)
    outlier: Mask  # (n,)


def _pieces(calibration: Calibration, readings: Readings, most: int) -> list[slice]:
    """Slices of about `most` rows; where effects remember, cut where they forget alone."""
    n, effects = len(readings), [e for e in map(load_shipped, calibration.effects) if remembers(e)]
    cuts = np.arange(most, n, most)
    if effects:
        segment = readings.segment if all(map(forgets, effects)) else None
        changed = cuts[:0] if segment is None else np.flatnonzero(segment[1:] != segment[:-1]) + 1
        last = np.searchsorted(changed, cuts, side="right") - 1
        cuts = np.unique(changed[last[last >= 0]])
    return [slice(a, b) for a, b in pairwise([0, *cuts.tolist(), n])]


def _corrected(calibration: Calibration, readings: Readings) -> _Corrected:
    field_nT = calibration.affine.apply(readings.reading)
    flags = {word: np.zeros(len(readings), dtype=bool) for word in FLAGS}
    found = [_effect(calibration, record, readings, field_nT, flags) for record in calibration.effects]
    corrected = field_nT.copy()
    for value, _, _ in found:
        corrected -= value
    values, variances, usable = zip(*found, strict=True) if found else ((), (), ())
    return _Corrected(corrected, values, variances, usable, flags)


def _survey(calibration: Calibration, readings: Readings, pieces: list[slice], alone: _Corrected | None) -> _Whole:
    """Sums over all rows in their order, so that they are the same however the rows are cut."""
    seen = [Seen() for _ in calibration.effects]
    bend, last = np.zeros(len(readings)), np.empty((0, 3))
    for rows in pieces:
        part = alone or _corrected(calibration, readings.rows(rows.start, rows.stop))
        for one, value, usable in zip(seen, part.values, part.usable, strict=True):
            one.take(value, usable)
        joined = np.concatenate([last, part.field_nT])
        start = rows.start - len(last) + 1
        if len(joined) > 2:
            bend[start : start + len(joined) - 2] = bends(joined)
        last = joined[-2:]
    records = zip(calibration.effects, map(load_shipped, calibration.effects), seen, strict=True)
    return _Whole(
        tuple(_size(calibration, record, effect, one) for record, effect, one in records),
        tuple(one.restless for one in seen),
        saturated(calibration, readings.reading),
        second_difference_outliers(bend, readings.segment, reading_noise(calibration)),
    )


def _applied(
    calibration: Calibration, readings: Readings, part: _Corrected, whole: _Whole, filled: dict[str, Mask], rows: slice
) -> Applied:
    variance, flags = _base_variance(calibration, readings.reading), part.flags
    of_effects = zip(calibration.effects, part.variances, part.usable, whole.sizes, whole.restless, strict=True)
    for record, uncertain, usable, size, restless in of_effects:
        uncertain[~usable] += size
        for name in record.channels:
            uncertain[filled[name][rows]] += restless
        variance += uncertain
    flags["saturated"] |= whole.saturated[rows]
    flags["outlier"] |= whole.outlier[rows] & ~flags["saturated"]
    _beyond_validity(calibration, readings, part.field_nT, flags)
    u = np.sqrt(variance.mean(axis=1)) * _growth(calibration, readings, part.field_nT, flags)
    return Applied(part.field_nT, u, tuple(_words(flags)))


def _words(flags: dict[str, Mask]) -> list[str]:
    """The flags of each row in words; most rows have none."""
    words = [""] * len(flags["field"])
    for row in np.flatnonzero(np.any(list(flags.values()), axis=0)).tolist():
        words[row] = " ".join(word for word in FLAGS if flags[word][row])
    return words


def reading_noise(calibration: Calibration) -> float:
    """Noise of one axis of one reading [nT], as the fit found it; 0 where the file says nothing."""
    return float(calibration.metrics.get("after", {}).get("noise_nT", 0.0))


def misfit_variance(calibration: Calibration, noise: float) -> float:
    """What the run's held-out residuals keep beyond the noise, as a variance of one component [nT²].

    `noise` is that of the field's three components together (rms). Residuals within 1.15 of it count as noise alone.
    """
    held_out = calibration.metrics.get("after", {}).get("holdout_rms_nT", 0.0)
    expected = noise if calibration.frame_known else noise / np.sqrt(3)
    if held_out <= MATERIAL * expected:
        return 0.0
    return float((held_out**2 - expected**2) / (3 if calibration.frame_known else 1))


def temperature_channel(calibration: Calibration, names: Mapping[str, Array]) -> str | None:
    """The column that the calibration's temperature range speaks of."""
    used = [r.channels[0] for r in calibration.effects if r.effect in TEMPERATURE and r.channels]
    return next((name for name in (*used, "temp_dut") if name in names), None)


def _base_variance(calibration: Calibration, reading: Array) -> Array:
    """Variance of each component (n, 3) [nT²] from the covariance of (K, k) and from the reading's noise."""
    per_unit = calibration.affine.K / calibration.dut.nominal_nT_per_unit
    noise = reading_noise(calibration) ** 2 * np.sum(per_unit**2, axis=1)
    variance = noise + np.full(reading.shape, misfit_variance(calibration, float(np.sqrt(noise.sum()))))
    if calibration.covariance is not None:
        J = jacobian(reading)
        variance += np.einsum("nap,pq,naq->na", J, calibration.covariance, J, optimize=True)
    return np.asarray(variance)


def _filled(readings: Readings) -> tuple[Readings, dict[str, Mask]]:
    """The recording with those gaps of its channels filled that can be told, as a fit fills them; and where."""
    t, channels, filled = readings.t_s, dict(readings.channels), dict[str, Mask]()
    if t is None or not (np.diff(t) > 0).all():
        t = np.arange(len(readings), dtype=float)
    for name, values in readings.channels.items():
        missing = ~np.isfinite(values)
        filled[name] = missing & False
        if missing.any() and (~missing).sum() >= FEW:
            told, sure = bridged(t, values)
            filled[name] = missing & sure
            channels[name] = np.where(filled[name], told, values)
    return replace(readings, channels=channels), filled


def _effect(
    calibration: Calibration, record: EffectRecord, readings: Readings, field_nT: Array, flags: dict[str, Mask]
) -> tuple[Array, Array, Mask]:
    """One effect, its variance (n, 3) each, and the rows (n,) where it is known; elsewhere both are nought."""
    effect = load_shipped(record)
    usable = np.isfinite(field_nT).all(axis=1) & _usable(calibration, record, effect, readings, flags)
    value, variance = np.zeros_like(field_nT), np.zeros_like(field_nT)
    if usable.any():
        columns = effect.term.columns(_scene(calibration, readings, field_nT, usable))
        value[usable] = columns @ effect.beta
        u = {p.name: p.u for p in record.parameters}
        variance[usable] = columns**2 @ np.array([u[name] ** 2 for name, _ in effect.term.parameters])
    if effect.family.id == "lag" and readings.t_s is not None:
        beyond = _out_of_reach(readings, float(effect.beta[0]))
        flags["rate"] |= beyond
        variance[beyond] += value[beyond] ** 2
    if effect.family.id == "offset-step" and readings.t_s is not None:
        unsure = _beside_the_step(record, readings.t_s)
        flags["time"] |= unsure
        variance[unsure] += effect.beta**2 / 4
    delay = next((s.value for s in effect.term.shape if s.name == "delay_s"), 0.0)
    if delay and usable.any():
        variance[_out_of_reach(readings, -delay)] += value[usable].var(axis=0)
    return value, variance, usable


def _usable(
    calibration: Calibration, record: EffectRecord, effect: Fitted, readings: Readings, flags: dict[str, Mask]
) -> Mask:
    """Rows (n,) that have what the effect needs: its channels, the run's time, a mode it knows. Flags the others."""
    usable: Mask = np.ones(len(readings), dtype=bool)
    for name in record.channels:
        missing = ~np.isfinite(readings.channels[name])
        usable = usable & ~missing
        if record.effect in TEMPERATURE:
            flags["temperature"] |= missing
    if effect.family.bound_to_run and readings.t_s is not None:
        first, last = calibration.span_s
        inside = (readings.t_s >= first) & (readings.t_s <= last)
        usable = usable & inside
        flags["time"] |= ~inside
    if effect.family.id == "offset-mode" and readings.mode is not None:
        unknown = ~np.isin(readings.mode, _known_modes(calibration, record))
        usable = usable & ~unknown
        flags["mode"] |= unknown
    return usable


def _scene(calibration: Calibration, readings: Readings, field_nT: Array, rows: Mask) -> Scene:
    n = len(readings)
    t_s = readings.t_s if readings.t_s is not None else np.zeros(n)
    segment = np.zeros(n, dtype=np.intp)
    if readings.segment is not None:
        segment = np.cumsum(np.r_[False, readings.segment[1:] != readings.segment[:-1]]).astype(np.intp)
    channels = {name: values[rows] for name, values in readings.channels.items()}
    mode = None if readings.mode is None else readings.mode[rows]
    axes = calibration.affine.K / calibration.dut.nominal_nT_per_unit
    return Scene(t_s[rows], segment[rows], field_nT[rows], channels, mode, axes)


def _known_modes(calibration: Calibration, record: EffectRecord) -> list[str]:
    """Modes that have an offset of their own, and the one that k belongs to; that may be "", a row without a mode."""
    own = [p.name.split(" ", 1)[1] for p in record.parameters if " " in p.name]
    base = [mode for mode in calibration.validity.modes if mode not in own]
    return [*own, *(base or [""])]


def _size(calibration: Calibration, record: EffectRecord, effect: Fitted, seen: Seen) -> Array:
    """Mean square (3,) of an effect that a row goes without: over the run's span, its modes, or the rows that have it.

    Never less than what the run's held-out residual lost by it: the recording may not show it at all.
    """
    if effect.family.bound_to_run:
        times = np.linspace(*calibration.span_s, 200)
        there = Scene(times, np.zeros(200, dtype=np.intp), np.zeros((200, 3)))
        return np.asarray(np.mean(effect.predict(there) ** 2, axis=0))
    if effect.family.id == "offset-mode":
        return np.asarray(np.mean(effect.beta.reshape(-1, 3) ** 2, axis=0))
    before, after = record.holdout_rms_before_nT or 0.0, record.holdout_rms_after_nT or 0.0
    lost = max(before**2 - after**2, 0.0) / (3 if calibration.frame_known else 1)
    return np.asarray(np.maximum(seen.mean_square, np.full(3, lost)))


def _beside_the_step(record: EffectRecord, t_s: Array) -> Mask:
    """Rows (n,) of which nobody knows on which side of the step they lie: it was between two rows of the run."""
    step = next(p for p in record.parameters if p.name == "t_step_s")
    return np.asarray(np.abs(t_s - step.value) < np.sqrt(3) * step.u * (1 - 1e-6))


def _out_of_reach(readings: Readings, lag_s: float) -> Mask:
    """Rows whose reading a lag later lies beyond their segment's ends."""
    assert readings.t_s is not None
    t, out = readings.t_s, np.zeros(len(readings), dtype=bool)
    segment = readings.segment if readings.segment is not None else np.zeros(len(t), dtype=np.intp)
    edges = [0, *(np.flatnonzero(segment[1:] != segment[:-1]) + 1).tolist(), len(t)]
    for start, stop in pairwise(edges):
        if start < stop:
            later = t[start:stop] + lag_s
            out[start:stop] = (later < t[start]) | (later > t[stop - 1])
    return out


def _beyond_validity(calibration: Calibration, readings: Readings, field_nT: Array, flags: dict[str, Mask]) -> None:
    """Raise the flags for rows that the run did not cover."""
    noise, validity = reading_noise(calibration), calibration.validity
    length = np.linalg.norm(field_nT, axis=1)
    low, high = validity.field_nT
    flags["field"] |= (length < low - 3 * noise) | (length > high + 3 * noise)
    name = temperature_channel(calibration, readings.channels)
    if name is not None and validity.temperature_C is not None:
        cold, hot = validity.temperature_C
        flags["temperature"] |= (readings.channels[name] < cold) | (readings.channels[name] > hot)
    if readings.mode is not None and validity.modes:
        flags["mode"] |= (readings.mode != "") & ~np.isin(readings.mode, validity.modes)


def _growth(calibration: Calibration, readings: Readings, field_nT: Array, flags: dict[str, Mask]) -> Array:
    """How much larger the uncertainty of a flagged row is (n,): by the part of the range that it lies outside.

    Rows flagged for anything but the range are at least doubled; of saturated rows and outliers a tenth of the field
    is added, since the reading says little.
    """
    growth = np.ones(len(readings))
    length = np.linalg.norm(field_nT, axis=1)
    growth += np.where(flags["field"], _excess(length, calibration.validity.field_nT), 0.0)
    name = temperature_channel(calibration, readings.channels)
    if name is not None and calibration.validity.temperature_C is not None:
        outside = _excess(readings.channels[name], calibration.validity.temperature_C)
        growth += np.where(flags["temperature"], np.nan_to_num(outside, nan=1.0), 0.0)
    growth += flags["mode"].astype(float) + flags["rate"].astype(float)
    useless = flags["saturated"] | flags["outlier"]
    floor = max(reading_noise(calibration), 1.0)
    return np.asarray(growth + np.where(useless, np.nan_to_num(0.1 * length / floor), 0.0))


def _excess(value: Array, limits: tuple[float, float]) -> Array:
    low, high = limits
    width = max(high - low, 0.1 * max(abs(low), abs(high)), 1e-9)
    return np.asarray(np.maximum(np.maximum(low - value, value - high), 0.0) / width)
