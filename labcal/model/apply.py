"""Readings in, field out: a calibration applied row by row, with its uncertainty and flags."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.model.affine import jacobian
from labcal.model.calibration import Calibration
from labcal.model.effects import Fitted, Scene, load_shipped, of_temperature
from labcal.model.effects.inputs import channels_of
from labcal.model.gaps import bridged
from labcal.model.pieces import Recording, Taken, Walk, remembers
from labcal.model.plausibility import bends, saturated, second_difference_outliers
from labcal.model.readings import Applied, Readings
from labcal.model.records import EffectRecord
from labcal.model.seen import Seen
from labcal.model.switched import EitherLevel

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]
FLAGS = ("saturated", "outlier", "field", "temperature", "rate", "mode", "time", "domain")
MATERIAL = 1.15  # held-out residuals beyond this many times the noise are more than noise
SPAN_ROWS = 200  # over which the size of an effect of the run's own clock is taken
SETTLED_S = 1e5  # after which a slow response has settled
FEW = 8  # rows of a channel: fewer do not tell what it does in a gap


def needed_columns(calibration: Calibration) -> tuple[str, ...]:
    """Columns beside the reading without which the calibration's effects cannot be computed."""
    names = dict.fromkeys(name for record in calibration.effects for name in record.channels)
    for effect in map(load_shipped, calibration.effects):
        if effect.family.is_bound_to_run(effect.term) or remembers(effect):
            names["t_s"] = None
        if remembers(effect):
            names["segment"] = None
        if effect.family.modes is not None:
            names["mode"] = None
    return tuple(names)


def apply(calibration: Calibration, readings: Readings, *, begins_known: bool = False) -> Applied:
    """B = K m − k − Σ e_i of the sensor's effects, for every row (contract: calibration, `apply`).

    u_nT is the root mean square over the components of: covariance of K and k, noise of the reading through K, each
    effect's parameters, what is left out, what an effect with memory may have met before the first row, unless that
    `begins_known`, and at which level a load was that was switched between two samples. A channel's gaps are bridged
    where they can be estimated. Raises InputError where a needed column is
    missing, or an effect of the file is not whole.
    """
    return next(apply_in_pieces(calibration, readings, max(len(readings), 1), begins_known=begins_known))


def apply_in_pieces(
    calibration: Calibration, readings: Readings, most: int, *, begins_known: bool = False
) -> Iterator[Applied]:
    """As `apply`, for `most` rows at a time, each as if all were there: what they take from the whole is found first.

    All rows are one piece where an effect of another package remembers, or one remembers and time goes back.
    """
    have = {*readings.channels, *(n for n in ("t_s", "segment", "mode") if getattr(readings, n) is not None)}
    for name in needed_columns(calibration):
        if name not in have:
            raise InputError("the calibration's effects need this column; it is missing", column=name)
    readings, filled = _filled(readings)
    recording = Recording(readings, begins_known)
    pieces = _pieces(_walks(calibration, recording), len(readings), most)
    alone = list(_corrected(calibration, recording, pieces)) if len(pieces) == 1 else None  # not twice
    whole = _survey(calibration, readings, pieces, alone or _corrected(calibration, recording, pieces))
    for rows, part in zip(pieces, alone or _corrected(calibration, recording, pieces), strict=True):
        yield _applied(calibration, readings.rows(rows.start, rows.stop), part, whole, filled, rows)


def linearised(calibration: Calibration, readings: Readings) -> tuple[Array, Array]:
    """The field (n, 3) [nT], and how it depends on K row by row, k and every effect's parameters (n, 3, p)."""
    (part,) = _corrected(calibration, Recording(readings), [slice(0, len(readings))])
    return part.field_nT, _slopes(readings.reading, part)


@dataclass(frozen=True, slots=True, eq=False)
class _Corrected:
    """Some rows with the effects taken off, and what each effect was there."""

    field_nT: Array  # (n, 3)
    effects: tuple[Taken, ...]


@dataclass(frozen=True, slots=True, eq=False)
class _Whole:
    """What a row's result takes from the whole recording (n rows)."""

    sizes: tuple[Array, ...]  # (3,) of each effect: its mean square, for rows that go without it
    mean_square_step: tuple[Array, ...]  # (3,) of each effect: the mean square of its change from row to row
    spreads: tuple[Array, ...]  # (3,) of each effect: its variance over the rows that have it
    saturated: Mask  # (n,)
    outlier: Mask  # (n,)


def _walks(calibration: Calibration, recording: Recording) -> list[Walk]:
    return [Walk(calibration, record, recording) for record in calibration.effects]


def _pieces(walks: list[Walk], n: int, most: int) -> list[slice]:
    """Slices of `most` rows, or of as many as an effect reaches over; one where an effect needs all at once."""
    most = max([most, *(walk.rows_within_reach() for walk in walks)])
    if any(walk.at_once for walk in walks):
        most = max(most, n)
    return [slice(a, min(a + most, n)) for a in range(0, n, most)] or [slice(0, 0)]


def _corrected(calibration: Calibration, recording: Recording, pieces: list[slice]) -> Iterator[_Corrected]:
    """Each piece with the effects taken off, which walk along the recording."""
    walks = _walks(calibration, recording)
    either = [] if recording.begins_known else [EitherLevel(calibration, one, recording) for one in calibration.effects]
    for rows in pieces:
        taken = (walk.take(rows) for walk in walks)
        found = (
            tuple(one.with_variance(rows, e) for one, e in zip(either, taken, strict=True)) if either else tuple(taken)
        )
        field_nT = calibration.affine.apply(recording.readings.reading[rows])
        for one in found:
            field_nT -= one.value
        yield _Corrected(field_nT, found)


def _survey(
    calibration: Calibration, readings: Readings, pieces: list[slice], corrected: Iterable[_Corrected]
) -> _Whole:
    """Sums over all rows in their order, so that they are the same however the rows are cut."""
    seen = [Seen() for _ in calibration.effects]
    bend, last = np.zeros(len(readings)), np.empty((0, 3))
    for rows, part in zip(pieces, corrected, strict=True):
        for one, effect in zip(seen, part.effects, strict=True):
            one.take(effect.value, effect.usable)
        joined = np.concatenate([last, part.field_nT])
        start = rows.start - len(last) + 1
        if len(joined) > 2:
            bend[start : start + len(joined) - 2] = bends(joined)
        last = joined[-2:]
    records = zip(calibration.effects, map(load_shipped, calibration.effects), seen, strict=True)
    return _Whole(
        tuple(left_out_variance(calibration, record, effect, one) for record, effect, one in records),
        tuple(one.mean_square_step for one in seen),
        tuple(one.variance for one in seen),
        saturated(calibration, readings.reading),
        second_difference_outliers(bend, readings.segment, reading_noise(calibration)),
    )


def _applied(
    calibration: Calibration, readings: Readings, part: _Corrected, whole: _Whole, filled: dict[str, Mask], rows: slice
) -> Applied:
    variance, flags = _noise_variance(calibration, readings.reading), _flags(part, len(readings))
    variance += _parameters_variance(calibration, readings.reading, part)
    of_effects = zip(calibration.effects, part.effects, whole.sizes, whole.mean_square_step, whole.spreads, strict=True)
    for record, effect, size, mean_square_step, spread in of_effects:
        variance += effect.variance
        variance[~effect.usable] += size
        for name in record.channels:
            variance[filled[name][rows]] += mean_square_step
        if effect.late is not None:
            variance[effect.late] += spread
    flags["saturated"] |= whole.saturated[rows]
    flags["outlier"] |= whole.outlier[rows] & ~flags["saturated"]
    _beyond_validity(calibration, readings, part.field_nT, flags)
    u = np.sqrt(variance.mean(axis=1)) * _growth(calibration, readings, part.field_nT, flags)
    if not is_u_known(calibration):
        u = np.full(len(readings), np.nan)
    return Applied(part.field_nT, u, tuple(_words(flags)))


def _flags(part: _Corrected, n: int) -> dict[str, Mask]:
    """What the effects flag, of each word of FLAGS (n,)."""
    flags = {word: np.zeros(n, dtype=bool) for word in FLAGS}
    for effect in part.effects:
        for word, rows in effect.flags.items():
            flags[word] |= rows
    return flags


def _words(flags: dict[str, Mask]) -> list[str]:
    """The flags of each row in words; most rows have none."""
    words = [""] * len(flags["field"])
    for row in np.flatnonzero(np.any(list(flags.values()), axis=0)).tolist():
        words[row] = " ".join(word for word in FLAGS if flags[word][row])
    return words


def reading_noise(calibration: Calibration) -> float:
    """Noise of one axis of one reading [nT], as the fit found it; 0 where the file says nothing."""
    return float(calibration.metrics.get("after", {}).get("noise_nT", 0.0))


def is_u_known(calibration: Calibration) -> bool:
    """Whether the file says anything of its uncertainty; one that another program made does not."""
    return calibration.covariance is not None or "noise_nT" in calibration.metrics.get("after", {})


def misfit_variance(calibration: Calibration, noise: float) -> float:
    """What the run's held-out residuals keep beyond the noise, as a variance of one component [nT²].

    `noise` is that of the field's three components together (rms). Residuals within 1.15 of it count as noise alone.
    What errors left that the run declares is in the parameters' covariance already, and what reference, angle and time
    scatter is in no reading of the device.
    """
    after, seen = calibration.metrics.get("after", {}), held_out_components(calibration)
    held_out = after.get("holdout_beside_declared_nT", after.get("holdout_rms_nT", 0.0))
    own, expected = held_out**2 - after.get("noise_beside_readings_nT", 0.0) ** 2, noise**2 * seen / 3
    return (own - expected) / seen if own > MATERIAL**2 * expected else 0.0


def held_out_components(calibration: Calibration) -> int:
    """Of how many components the held-out residual is the length: three of a vector, or one, the magnitude's.

    A run that knows the frame may have been closed on magnitudes all the same, as by axes without angles. Files of
    before do not say it: then the frame says it.
    """
    stated = calibration.metrics.get("after", {}).get("holdout_components")
    return 1 if stated == 1 or (stated is None and not calibration.frame_known) else 3


def temperature_channel(calibration: Calibration, names: Collection[str]) -> str | None:
    """The column that the calibration's temperature range speaks of."""
    used = [r.channels[0] for r in calibration.effects if of_temperature(r) and r.channels]
    return next((name for name in (*used, "temp_dut") if name in names), None)


def ends_of_channels(calibration: Calibration) -> dict[str, tuple[float, float]]:
    """Between which values each channel was seen that an effect with a name follows; not that of the temperatures."""
    named = [domain for record in calibration.effects if record.basis is None for domain in record.domain]
    seen = {name: (d.hull[0][0], d.hull[-1][0]) for d in named for name in channels_of(d.inputs)}
    if calibration.validity.temperature_C is not None and (warm := temperature_channel(calibration, seen)):
        del seen[warm]
    return seen


def _noise_variance(calibration: Calibration, reading: Array) -> Array:
    """Variance of each component (n, 3) [nT²] from the reading's noise, and from what the run's residuals keep."""
    per_unit = calibration.affine.K / calibration.dut.nominal_nT_per_unit
    noise = reading_noise(calibration) ** 2 * np.sum(per_unit**2, axis=1)
    return np.asarray(noise + np.full(reading.shape, misfit_variance(calibration, float(np.sqrt(noise.sum())))))


def _parameters_variance(calibration: Calibration, reading: Array, part: _Corrected) -> Array:
    """Variance of each component (n, 3) [nT²]: J Σ Jᵀ over K, k and every effect's parameters together (GUM, 5.2.2)."""
    covariance, J = calibration.joint_covariance(), _slopes(reading, part)
    if calibration.covariance is None:
        J, covariance = J[:, :, 12:], covariance[12:, 12:]
    return np.asarray(np.sum(J @ covariance * J, axis=2))


def _slopes(reading: Array, part: _Corrected) -> Array:
    """d(field)/d(K row by row, k, every effect's parameters in their order), (n, 3, p)."""
    return np.concatenate([jacobian(reading), *(-effect.jacobian for effect in part.effects)], axis=2)


def _filled(readings: Readings) -> tuple[Readings, dict[str, Mask]]:
    """The recording with those gaps of its channels filled that can be estimated, as a fit fills them; and where."""
    t, channels, filled = readings.t_s, dict(readings.channels), dict[str, Mask]()
    if t is None or not (np.diff(t) > 0).all():
        t = np.arange(len(readings), dtype=float)
    for name, values in readings.channels.items():
        missing = ~np.isfinite(values)
        filled[name] = missing & False
        if missing.any() and (~missing).sum() >= FEW:
            values_bridged, sure = bridged(t, values)
            filled[name] = missing & sure
            channels[name] = np.where(filled[name], values_bridged, values)
    return replace(readings, channels=channels), filled


def left_out_variance(calibration: Calibration, record: EffectRecord, effect: Fitted, seen: Seen) -> Array:
    """Mean square (3,) of an effect that a row goes without: over the run's span, its modes, or the rows that have it.

    The recording may not show it at all: so never less than what it is where its channels are at either end, nor than
    what the run's held-out residual lost by it. Of an empirical term it is its prior, for the mean of the run is no
    more than that.
    """
    if record.basis is not None:
        return np.full(3, record.basis.prior_nT**2)
    if (rows := _where_it_acts(calibration, effect)) is not None:
        return np.asarray(np.mean(effect.predict(rows) ** 2, axis=0))
    before, after = record.holdout_rms_before_nT or 0.0, record.holdout_rms_after_nT or 0.0
    lost = max(before**2 - after**2, 0.0) / held_out_components(calibration)
    return np.asarray(np.max([seen.mean_square, np.full(3, lost), _at_the_ends(calibration, record, effect)], axis=0))


def _at_the_ends(calibration: Calibration, record: EffectRecord, effect: Fitted) -> Array:
    """Mean square (3,) of an effect in the largest field along each axis, each channel at either end of what was seen.

    Of a value that is only known to lie between two ends none scatters more than one that is at either. What a run
    loses by an effect says less: there the map took up its mean.
    """
    ends = [
        (d.hull[0][0], d.hull[-1][0])
        for name in record.channels
        for d in record.domain
        if name in channels_of(d.inputs)
    ]
    if len(ends) != len(record.channels) or not ends:
        return np.zeros(3)
    fields = calibration.validity.field_nT[1] * np.vstack([np.eye(3), -np.eye(3)])
    at = [(field_nT, values) for values in product(*ends) for field_nT in fields for _ in range(2)]  # two rows: at rest
    channels = dict(zip(record.channels, np.array([values for _, values in at]).T, strict=True))
    mode = np.full(len(at), next(iter(calibration.validity.modes), ""))
    axes, field = calibration.affine.K / calibration.dut.nominal_nT_per_unit, np.array([field_nT for field_nT, _ in at])
    rows = Scene(np.tile([0.0, SETTLED_S], len(at) // 2), np.arange(len(at)) // 2, field, channels, mode, axes)
    return np.asarray(np.mean(effect.predict(rows)[1::2] ** 2, axis=0))


def _where_it_acts(calibration: Calibration, effect: Fitted) -> Scene | None:
    """Rows over the run's span, or one in each mode; None for an effect that takes more than that."""
    family, term = effect.family, effect.term
    modes = list(family.modes(term)) if family.modes is not None else []
    if term.channels or family.of_field or not (family.bound_to_run or modes):
        return None
    times = np.linspace(*calibration.span_s, SPAN_ROWS) if family.bound_to_run else np.zeros(len(modes))
    mode = np.resize(np.array(modes, dtype=np.str_), len(times)) if modes else None
    return Scene(times, np.zeros(len(times), dtype=np.intp), np.zeros((len(times), 3)), mode=mode)


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
    for channel, ends in ends_of_channels(calibration).items():
        growth += np.nan_to_num(_excess(readings.channels[channel], ends), nan=0.0)
    growth += flags["mode"].astype(float) + flags["rate"].astype(float)
    useless = flags["saturated"] | flags["outlier"]
    floor = max(reading_noise(calibration), 1.0)
    return np.asarray(growth + np.where(useless, np.nan_to_num(0.1 * length / floor), 0.0))


def _excess(value: Array, limits: tuple[float, float]) -> Array:
    low, high = limits
    width = max(high - low, 0.1 * max(abs(low), abs(high)), 1e-9)
    return np.asarray(np.maximum(np.maximum(low - value, value - high), 0.0) / width)
