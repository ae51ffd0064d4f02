"""What looks wrong in a recording, named before anything is fitted.

A doubt (units, axes, attitude, clocks, constant, time) would spoil every fit: the import refuses it unless the mapping
accepts it. What else was found (gaps, missing values, a delay between streams) is reported, and the run is made.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from numpy.typing import NDArray

from labcal.importers.stamps import LAST_DATE_S
from labcal.record import Run, carry

Array = NDArray[np.float64]

FACTORS = (10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e9)  # between nT, mG, µT, G, mT, T
NEAR = 0.2  # of a factor, for it to be the one of two units
FAR = 4.0  # a reading that many times its reference, or one part of it, is reported
SMALLEST_nT = 200.0  # a median field below says nothing about its unit
BETTER = 3.0  # times smaller has the rms to be under other axes
AS_GOOD = 1.5  # times the best rms leave axes that fit as well
GAP = 5.0  # median steps that make a gap
SHORTEST_S, LONGEST_S = 1e-5, 3600.0  # between two samples
MOST_ROWS = 4000  # that are looked at for axes and delays
DELAY = 1.5  # of the slower stream's period, for a delay to be reported
MOST_ppm = 50_000.0  # between two clocks, of which one may count rows of a nominal rate
CLEARER = 0.7  # what it must leave of the rms
FEW = 20
REACH, FAR_REACH = 20, 200  # half periods either way, of the delays that are tried
POOR = 0.3  # of the readings' spread: what leaves more is tried further away, and must leave that part of it there
MOST_IN_A_ROW = 20_000
TOO_GOOD = 0.003  # of the readings' spread: a fit that leaves less has no delay to be reported


@dataclass(frozen=True, slots=True)
class ImportFinding:
    """One sentence; `doubt` is the word by which a mapping accepts it, None where it is only reported."""

    text: str
    doubt: str | None = None


@dataclass(frozen=True, slots=True, eq=False)
class StampStatistics:
    """The stamps of one group: first and last [s], period [s], how many, how many without a value, and the steps."""

    first_s: float
    last_s: float
    period_s: float
    n: int
    missing: int
    steps: Array


def doubts(run: Run, clocks: Mapping[str, StampStatistics], attitude: Array | None = None) -> list[ImportFinding]:
    """What no fit should see, the most fundamental first; `attitude` (n, 3, 3) turned the reference into the body."""
    return [*_times(clocks), *_apart(clocks), *_constant(run), *_units(run), *_axes(run, attitude)]


def findings(run: Run, clocks: Mapping[str, StampStatistics]) -> list[ImportFinding]:
    """What a person should know, and may be as it is."""
    return [*_gaps(clocks), *_missing(run, clocks), *_still(run), *_delay(run, clocks)]


def _times(clocks: Mapping[str, StampStatistics]) -> Iterator[ImportFinding]:
    for name, clock in clocks.items():
        if clock.n > 1 and not SHORTEST_S <= clock.period_s <= LONGEST_S:
            what = f"the samples of {name} would be {clock.period_s:.3g} s apart: is the unit of its time right?"
            yield ImportFinding(what, "time")
        elif clock.last_s > LAST_DATE_S:  # milliseconds since 1970 that were stated as seconds
            what = f"the stamps of {name} reach {clock.last_s:.4g} s, and no clock has counted so far"
            yield ImportFinding(f"{what}: is the unit of its time right?", "time")


def _apart(clocks: Mapping[str, StampStatistics]) -> Iterator[ImportFinding]:
    """Streams whose spans share less than half of the reading's: two clocks, or two recordings."""
    for name, clock in clocks.items():
        own = clocks.get(name.replace(name.partition(" of ")[0], "reading", 1)) or clocks.get("reading")
        if own is None or clock is own:
            continue
        shared = min(own.last_s, clock.last_s) - max(own.first_s, clock.first_s)
        if shared < 0.5 * (own.last_s - own.first_s):
            spans = (f"{c.first_s:.10g} to {c.last_s:.10g} s" for c in (own, clock))
            message = f"two clocks: the reading runs from {next(spans)}, {name} from {next(spans)}"
            yield ImportFinding(
                f"{message}; clock_offset_s = {own.first_s - clock.first_s:.6g} lets both begin together", "clocks"
            )


def _constant(run: Run) -> Iterator[ImportFinding]:
    known = run.reading[np.isfinite(run.reading).all(axis=1)]
    if len(known) < 3:
        yield ImportFinding(f"only {len(known)} rows have all three readings", "constant")
        return
    for name, column in zip("xyz", known.T, strict=True):
        if np.ptp(column) == 0:
            yield ImportFinding(
                f"the reading {name} is {column[0]:g} in all {len(known)} rows: is it recorded?", "constant"
            )


def _units(run: Run) -> Iterator[ImportFinding]:
    """A reading that is larger or smaller than its reference by what lies between two units."""
    if run.reference.kind == "none" or run.dut.unit == "count":
        return
    read, there = (float(np.nanmedian(v)) if np.isfinite(v).any() else np.nan
                   for v in (np.linalg.norm(run.reading_nT, axis=1), run.magnitude_nT))  # fmt: skip
    if not (np.isfinite(read) and np.isfinite(there)) or min(read, there) == 0 or max(read, there) < SMALLEST_nT:
        return
    ratio = read / there
    large = max(ratio, 1 / ratio)
    sizes = f"readings of {read:.4g} nT in the median beside a reference of {there:.4g} nT"
    if any(abs(large / factor - 1) < NEAR for factor in FACTORS):
        yield ImportFinding(f"{sizes}: is the unit of one of them wrong, by a factor of {large:.3g}?", "units")
    elif large > FAR:
        yield ImportFinding(f"{sizes}: a large offset, or a wrong unit")


def _axes(run: Run, attitude: Array | None) -> Iterator[ImportFinding]:
    """Readings that fit their reference in other axes, or turned the other way, far better than as stated."""
    rows, body, read = _pairs(run)
    if len(rows) < FEW:
        return
    as_stated = _left(body, read)
    tried = sorted((_left(body @ p.T, read), _word(p)) for p in _signed_axes())
    best, axes = tried[0]
    inverse = np.inf if attitude is None else _left(_turned_back_twice(body, attitude[rows]), read)
    if as_stated > BETTER * inverse:
        yield ImportFinding("the attitude fits far better the other way round: is `maps` inverted?", "attitude")
    elif as_stated > BETTER * best:
        as_good = [word for left, word in tried[1:4] if left < AS_GOOD * best]
        axes = " or ".join([axes, *as_good])  # along an axis that saw little field no sign can be determined
        what = f"the readings fit the reference with axes {axes} {as_stated / best:.1f} times better than as stated"
        yield ImportFinding(f"{what}: are axes swapped or turned about?", "axes")


def _turned_back_twice(body: Array, attitude: Array) -> Array:
    """The reference (n, 3) as it were in the body's axes if `attitude` (n, 3, 3) were its own inverse."""
    return np.asarray(np.einsum("nji,nkj,nk->ni", attitude, attitude, body))


def _pairs(run: Run) -> tuple[NDArray[np.intp], Array, Array]:
    """At most `MOST_ROWS` rows where both are known, the reference in the body's axes there, and the reading [nT]."""
    if run.reference.kind != "vector":
        return np.empty(0, dtype=np.intp), np.empty((0, 3)), np.empty((0, 3))
    carried = carry(run)
    known = (carried.observation == "vector") & (carried.phase_group < 0)
    known &= np.isfinite(carried.vector).all(axis=1) & np.isfinite(run.reading).all(axis=1)
    rows = np.flatnonzero(known)
    rows = rows[:: max(1, len(rows) // MOST_ROWS)]
    return rows, carried.vector[rows], run.reading_nT[rows]


def _signed_axes() -> Iterator[Array]:
    """The 48 ways to name three axes with signs."""
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            yield np.eye(3)[list(order)] * np.array(signs)[:, None]


def _word(axes: Array) -> str:
    words = (f"{'-' if row.sum() < 0 else ''}{'xyz'[int(np.argmax(np.abs(row)))]}" for row in np.asarray(axes))
    return "[" + ", ".join(f'"{word}"' for word in words) + "]"


def _left(predicted: Array, read: Array) -> float:
    """The rms [nT] that one gain, not below zero, and an offset leave of the readings."""
    p, r = predicted - predicted.mean(axis=0), read - read.mean(axis=0)
    power = float((p * p).sum())
    gain = max(float((p * r).sum()) / power, 0.0) if power > 0 else 0.0
    return float(np.sqrt(np.mean(np.sum((r - gain * p) ** 2, axis=1)))) + 1e-9


def _gaps(clocks: Mapping[str, StampStatistics]) -> Iterator[ImportFinding]:
    of_one_table: set[tuple[float, float, int]] = set()
    for name, clock in clocks.items():
        long = clock.steps[clock.steps > GAP * clock.period_s]
        table = (clock.first_s, clock.last_s, clock.n)
        if long.size and table not in of_one_table:
            of_one_table.add(table)
            yield ImportFinding(f"{name}: {long.size} gap{'s' * (long.size > 1)}, the longest {long.max():.4g} s")


def _missing(run: Run, clocks: Mapping[str, StampStatistics]) -> Iterator[ImportFinding]:
    for name, clock in clocks.items():
        if clock.missing:
            yield ImportFinding(f"{name}: {clock.missing} of {clock.n} rows have no value (NaN or empty)")
    if run.reference.kind != "none" and (lost := int(np.isnan(run.magnitude_nT).sum())):
        yield ImportFinding(f"{lost} of {len(run)} readings have no reference within two of its periods")


def _still(run: Run) -> Iterator[ImportFinding]:
    for channel in run.channels:
        known = channel.values[np.isfinite(channel.values)]
        if not known.size:
            yield ImportFinding(f"channel {channel.name} has no values at the readings' times")
        elif np.ptp(known) == 0:
            yield ImportFinding(
                f"channel {channel.name} is {known[0]:g} {channel.unit} throughout: it can explain nothing"
            )


def _delay(run: Run, clocks: Mapping[str, StampStatistics]) -> Iterator[ImportFinding]:
    """A reference that fits far better at other times: an offset between two clocks, and a drift between the halves."""
    if "reading" not in clocks or "reference" not in clocks:
        return
    period = max(clocks["reading"].period_s, clocks["reference"].period_s)
    halves = np.array_split(np.arange(len(run)), 2)
    first, second = (_best_delay(run, half, period) for half in halves)
    if first is None or second is None or max(abs(first), abs(second)) <= DELAY * period:
        return
    delay, more = (first + second) / 2, ""
    if abs(first - second) > DELAY * period:
        drift = 1e6 * (second - first) / float(run.t_s[halves[1]].mean() - run.t_s[halves[0]].mean())
        if abs(drift) > MOST_ppm:  # no clock is so wrong: one of the halves does not determine its delay
            delay = _best_delay(run, np.arange(len(run)), period) or 0.0
        else:
            halves_say = f" ({first:.3g} in the first half, {second:.3g} in the second)"
            more = f"{halves_say}, and {drift:.0f} more in its clock_rate_ppm"
    if delay:
        yield ImportFinding(f"two clocks: the reference fits best with {delay:.3g} s more in its clock_offset_s{more}")


def _best_delay(run: Run, rows: NDArray[np.intp], period: float) -> float | None:
    """By how much later [s] the reference of these rows fits best; 0 where none is far better, None where unknown."""
    spare = max(0, len(rows) - MOST_IN_A_ROW) // 2
    rows = rows[spare : len(rows) - spare]
    carried = carry(run.select(rows))
    is_vector = (np.isfinite(carried.vector).all(axis=1) & (carried.phase_group < 0)).sum() > FEW
    reference = carried.vector if is_vector else carried.magnitude[:, None]
    seen = run.reading_nT[rows] if is_vector else np.linalg.norm(run.reading_nT[rows], axis=1)[:, None]
    known = np.isfinite(reference).all(axis=1) & np.isfinite(seen).all(axis=1)
    if known.sum() < 5 * FEW or run.reference.kind == "none":
        return None
    t, reference, seen = run.t_s[rows][known], reference[known], seen[known]
    spread = float(np.sqrt(np.mean(np.var(seen, axis=0))))
    delay, left, stated = _best_of(t, reference, seen, REACH, period)
    if stated > POOR * spread:
        far, left_far, _ = _best_of(t, reference, seen, FAR_REACH, period)
        if left_far < min(left, POOR * stated):
            return far
    return delay if left < CLEARER * stated and stated > TOO_GOOD * spread else 0.0


def _best_of(t: Array, reference: Array, seen: Array, reach: int, period: float) -> tuple[float, float, float]:
    """The delay that leaves least, that rms, and what the stated times leave."""
    delays = np.arange(-reach, reach + 1) * period / 2
    left = np.array([_left_at(t, reference, seen, delay) for delay in delays])
    best = int(np.argmin(left))
    return float(delays[best]), float(left[best]), float(left[reach])


def _left_at(t: Array, reference: Array, seen: Array, delay: float) -> float:
    """The rms that an affine map of the reference, moved `delay` later, leaves of what was seen; inf: too few rows."""
    moved = np.stack([np.interp(t - delay, t, column) for column in reference.T], axis=1)
    inside = (t - delay >= t[0]) & (t - delay <= t[-1])
    if inside.sum() < len(t) / 2:
        return math.inf
    design = np.column_stack([moved, np.ones(len(t))])[inside]
    solved, *_ = np.linalg.lstsq(design, seen[inside], rcond=None)
    return float(np.sqrt(np.mean((seen[inside] - design @ solved) ** 2)))
