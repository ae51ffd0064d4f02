"""What several effects share: axes' names, moving channels, first-order filters and delays within a segment."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from labcal.model.between_rows import between
from labcal.model.effects.memory import LEAD
from labcal.model.effects.past import Past
from labcal.model.effects.recursion import affine_recursion
from labcal.model.effects.scene import Array, Scene
from labcal.model.effects.shape import MOMENT, Shape
from labcal.model.effects.term import Term
from labcal.model.gaps import is_known_enough
from labcal.record import Run, offers
from labcal.record.run import Channel
from labcal.record.vector import Vector

WEATHER = ("temperature", "pressure", "humidity")
AXES = ("x", "y", "z")
FIELD_IN_C = "now->field"  # the field along the axes of B
BODY = "body_"  # begins the names of parameters that are driven by the field along the axes of B
STRAIGHT = 0.1  # of the square that a line may leave: what leaves more has switched, and held its level before
STEP = Shape("t_step_s", 0.0, "s", kind=MOMENT)
ALIKE = 0.999  # correlation of currents, or of one and its square, that a run does not tell apart
CARRIED = 3.0  # time constants: over a longer gap between segments a state is not carried
LEARNED = 10.0  # time constants from a beginning on: what happens there says what may have happened before
FEWEST = 5  # rows that make a line
TRIED = 32  # rows of them at which it is begun anew
Ends = tuple[float, float]


def per_axis(name: str, unit: str) -> tuple[tuple[str, str], ...]:
    """Three parameters, one for each axis."""
    return tuple((f"{name}_{axis}", unit) for axis in AXES)


def powered(order: int) -> str:
    """The unit of the coefficient of this power of the field."""
    return "1/nT" if order == 2 else f"1/nT^{order - 1}"


def on_each_axis(drive: Array) -> Array:
    """The same drive (n,) on each body axis, (n, 3, 3)."""
    out = np.zeros((len(drive), 3, 3))
    out[:, range(3), range(3)] = drive[:, None]
    return out


def driving(term: Term, scene: Scene) -> Array:
    """The field (n, 3) [nT] that drives the form: along the sensor's own axes, or along those of the body."""
    return scene.driving_field_nT if term.parameters[0][0].startswith(BODY) else scene.on_axes(scene.driving_field_nT)


def driving_in_c(term: Term) -> str:
    """The same in C."""
    return FIELD_IN_C if term.parameters[0][0].startswith(BODY) else "now->along"


def moving(run: Run, quantities: Iterable[str]) -> list[Channel]:
    """Channels of the sensor's side with one of these quantities that move and are known, or sure, in half the rows."""
    return [c for c in run.channels if c.role == "dut" and c.quantity in quantities and _moves(run, c)]


def of_the_rig(run: Run) -> list[Channel]:
    """Channels of platform and room, a motor, a door, a lift, that move and are known, or sure, in half the rows.

    What the coils carry makes the cage's own field, which the reference sees; the weather moves nothing magnetic.
    """
    rig = [c for c in run.channels if c.role in ("platform", "room") and c.quantity not in WEATHER]
    return [c for c in rig if _moves(run, c)]


def coils(run: Run) -> list[Channel]:
    """Currents of the cage's coils that move and are known in all rows.

    Of one that is recorded twice, and of coils driven in proportion, the first: the run does not tell them apart.
    """
    currents = [c for c in run.channels if c.role == "coil" and c.quantity == "current"]
    known = [c for c in currents if bool(np.isfinite(c.values).all()) and _moves(run, c)]
    return [c for k, c in enumerate(known) if not any(_are_alike(c, other) for other in known[:k])]


def _are_alike(one: Channel, other: Channel) -> bool:
    return abs(float(np.corrcoef(one.values, other.values)[0, 1])) > ALIKE


def is_its_own_square(channel: Channel) -> bool:
    """Whether its square is a line in it, as of what is on or off, or nothing at all, as of what is reversed."""
    known = channel.values[np.isfinite(channel.values)]
    square = known**2
    return not np.ptp(square) or abs(float(np.corrcoef(known, square)[0, 1])) > ALIKE


def room_temperatures(run: Run) -> list[Channel]:
    """Temperatures of the room that move and are known for half of the rows: what the rig's instruments follow."""
    return [c for c in run.channels if c.role == "room" and c.quantity == "temperature" and _moves(run, c)]


def some_moment(run: Run) -> Shape:
    """Where a step may lie: the residual shows where it is looked for."""
    return replace(STEP, value=float(run.t_s[0] + run.t_s[-1]) / 2)


def mountings(run: Run) -> dict[int, Vector]:
    """The axis in B of each mounting that turns, by its number from 1 in the order of first segments."""
    names = list(dict.fromkeys(s.mounting or i for i, s in enumerate(run.segments)))
    return {
        names.index(s.mounting or i) + 1: s.axis_body
        for i, s in enumerate(run.segments)
        if s.kind == "rotation" and offers(run, s) == "vector" and s.axis_body is not None and len(run.rows(i))
    }


def _moves(run: Run, channel: Channel) -> bool:
    known = channel.values[np.isfinite(channel.values)]
    return len(known) > 0 and float(np.ptp(known)) > 0 and is_known_enough(run.t_s, channel.values)


def middle(channel: Channel) -> float:
    """Where a channel counts as zero: its median."""
    return float(np.nanmedian(channel.values))


def stretches(segment: NDArray[np.intp]) -> list[slice]:
    """The runs of rows between changes of segment."""
    edges = np.flatnonzero(np.diff(segment)) + 1
    starts, ends = [0, *edges.tolist()], [*edges.tolist(), len(segment)]
    return [slice(a, b) for a, b in zip(starts, ends, strict=True)]


def low_passed(
    t_s: Array,
    segment: NDArray[np.intp],
    drive: Array,
    tau_s: float,
    past: Past | None = None,
    ends: Ends | None = None,
    off: float | None = None,
    carried_off: float = 0.0,
) -> Array:
    """First-order response (n,) to `drive` with time constant `tau_s`, exact for a drive that is linear between rows.

    A negative one undoes a response: the drive was seen through a slow thermometer.

    What follows slowly does not start anew where a segment does: over a gap of up to CARRIED time constants the state
    is carried, the drive bridged linearly. After a longer one, and before the first row, the drive is taken to have
    moved as it does over the next tau_s where that is a line, as far as it does so elsewhere, and to have stood where
    it is not; or the first row begins `off` from its drive. With `past` the first row may go on from one before; where
    none went before, the state begins astray by so many standard deviations as the past says, `ends` being those
    between which the drive was seen; one that is carried over a gap is as many times `carried_off` astray.
    """
    if tau_s == 0 or len(t_s) == 0:
        return drive
    if tau_s < 0:
        return inverted(t_s, segment, drive, -tau_s)
    past, name = past or Past(len(t_s)), f"behind by {tau_s}"
    at_s, within, driven, state = past.before.get(name, (t_s[0], segment[0], drive[0], 0.0))
    steps = np.diff(t_s, prepend=at_s) / tau_s
    anew = (np.diff(segment, prepend=within) != 0) & ((steps <= 0) | (steps > CARRIED))
    anew[0] |= name not in past.before
    steps = np.maximum(steps, 0.0)
    keep = np.exp(-steps)
    ramp = np.where(steps > 0, (1 - keep) / np.where(steps > 0, steps, 1.0), 1.0)
    add = (ramp - keep) * np.concatenate([[driven], drive[:-1]]) + (1 - ramp) * drive
    over_a_gap = (np.diff(segment, prepend=within) != 0) & ~anew & (steps > 0)
    add[over_a_gap] += past.astray * carried_off
    for start, stop in pairwise([*np.flatnonzero(anew).tolist(), len(t_s)]):
        rows = slice(start, start + int(np.sum(t_s[start:stop] <= t_s[start] + LEARNED * tau_s)))
        add[start] = _begun(t_s[rows], drive[rows], tau_s, np.zeros(1, dtype=np.intp))[0]
        if start < past.own:
            past.until_s = max(past.until_s, t_s[start] + tau_s * LEARNED)
        like_a_line = 1.0
        if add[start] != drive[start]:
            followed = affine_recursion(np.r_[0.0, keep[rows][1:]], add[rows], 0.0)
            like_a_line = _share_of_a_line(t_s[rows], drive[rows], followed, tau_s)
            add[start] = drive[start] + like_a_line * (add[start] - drive[start])
        if start == 0 and off is not None:
            add[start] = drive[start] + off
        if start < past.own and past.astray:
            followed = affine_recursion(np.r_[0.0, keep[rows][1:]], add[rows], 0.0)
            add[start] += past.astray * _unknown_beginning(t_s[rows], drive[rows], followed, tau_s, ends, like_a_line)
    keep[anew] = 0.0
    followed, last = affine_recursion(keep, add, state), past.own - 1
    past.after[name] = t_s[last], segment[last], drive[last], followed[last]
    return followed


def _share_of_a_line(t_s: Array, drive: Array, followed: Array, tau_s: float) -> float:
    """How far behind the drive the state is where it begins, over how far it would be had the drive come as a line.

    By least squares over other rows (n,) at which it is begun anew, in which this one's own error has faded by so much;
    that the drive came as it goes on counts as one observation, of one time constant.
    """
    tried, anew, each = _begun_anew(t_s, drive, tau_s)
    own, along = followed[0] - drive[0], anew - drive[tried]
    weight = each * (1 - np.exp(-(t_s[tried] - t_s[0]) / tau_s))
    seen = (followed[tried] - drive[tried]) * along
    share = (own**2 + float(np.sum(weight * seen))) / (own**2 + float(np.sum(weight * along**2)))
    return float(np.clip(share, 0.0, 1.0))


def _begun_anew(t_s: Array, drive: Array, tau_s: float) -> tuple[NDArray[np.intp], Array, float]:
    """Some later rows, the state as begun anew in each, and the time constants between them."""
    later = np.flatnonzero(t_s > t_s[0])
    later = later[t_s[later] <= t_s[0] + (LEARNED - 1) * tau_s][:: max(len(later) // TRIED, 1)]
    each = float(t_s[later[-1]] - t_s[0]) / tau_s / len(later) if len(later) else 0.0
    return later, _begun(t_s, drive, tau_s, later), each


def _unknown_beginning(
    t_s: Array, drive: Array, followed: Array, tau_s: float, ends: Ends | None, like_a_line: float
) -> float:
    """How far from its beginning a state may be that follows the drive, as a standard deviation.

    Begun anew in other rows (n,) it is as far off as here, but for what is left there of this beginning's own error:
    V (1 − e^(−2 t / tau)) of its variance V, where errors fade as they do here. That it lies anywhere between the
    drive's ends counts as one observation more, of one time constant: all there is where the drive stood.
    """
    low, high = ends or (float(drive.min()), float(drive.max()))
    square, known = (high - low) ** 2 / 12 + ((low + high) / 2 - followed[0]) ** 2, 1.0
    tried, anew, each = _begun_anew(t_s, drive, tau_s)
    if len(tried):
        begun = drive[tried] + like_a_line * (anew - drive[tried])
        square += each * float(np.sum((begun - followed[tried]) ** 2))
        known += each * float(np.sum(1 - np.exp(-2 * (t_s[tried] - t_s[0]) / tau_s)))
    return float(np.sqrt(square / known))


def _begun(t_s: Array, drive: Array, tau_s: float, at: NDArray[np.intp]) -> Array:
    """In each row of `at` (k,) a state that follows the drive and of which nothing is known from before."""
    stop = np.searchsorted(t_s, t_s[at] + tau_s, side="right")
    along, both, moved = _line_through(t_s - t_s[0], drive - drive[0], at, stop)
    enough = (stop - at >= FEWEST) & (t_s[stop - 1] - t_s[at] >= tau_s / 4)
    slope = both / np.where(enough, along, np.inf)
    return np.asarray(drive[at] - tau_s * np.where(moved - slope * both < STRAIGHT * moved, slope, 0.0))


def inverted(t_s: Array, segment: NDArray[np.intp], seen: Array, tau_s: float) -> Array:
    """What a thermometer of time constant `tau_s` was in (n,), from what it showed: T + tau dT/dt.

    The slope is a line's through the rows of the segment within tau_s / 8 either way: so the noise of a reading counts
    14 times over the root of their number, and what changes within the window is smoothed.
    """
    return np.concatenate([seen[p] + tau_s * slopes(t_s[p], seen[p], tau_s * LEAD) for p in stretches(segment)])


def slopes(t: Array, x: Array, reach_s: float) -> Array:
    """The slope (n,) of a line through the rows within `reach_s` of each, its neighbours at least."""
    rows = np.arange(len(t))
    first = np.maximum(np.minimum(np.searchsorted(t, t - reach_s), rows - 1), 0)
    last = np.minimum(np.maximum(np.searchsorted(t, t + reach_s, side="right"), rows + 2), len(t))
    along, both, _ = _line_through(t - t.mean(), x - x.mean(), first, last)
    return np.asarray(both / np.where(along > 0, along, np.inf))


def _line_through(t: Array, x: Array, first: NDArray[np.intp], stop: NDArray[np.intp]) -> tuple[Array, Array, Array]:
    """Σ t², Σ t x and Σ x² (k,) about their means over rows from each `first` to before its `stop`."""
    powers = np.stack([t, x, t * t, t * x, x * x], axis=1)
    sums = np.concatenate([np.zeros((1, powers.shape[1])), np.cumsum(powers, axis=0)])
    s_t, s_x, s_tt, s_tx, s_xx = (sums[stop] - sums[first]).T
    n = stop - first
    return s_tt - s_t**2 / n, s_tx - s_t * s_x / n, s_xx - s_x**2 / n


def delayed(t_s: Array, segment: NDArray[np.intp], drive: Array, by_s: float) -> Array:
    """`drive` (n,) at t − by_s, straight between the rows of the same segment; its end value beyond its ends."""
    parts = (np.interp(t_s[rows] - by_s, t_s[rows], drive[rows]) for rows in stretches(segment))
    return np.concatenate(list(parts)) if len(t_s) else drive


def shifted(t_s: Array, segment: NDArray[np.intp], values: Array, by_s: Array | float) -> Array:
    """`values` (n, ...) at t + by_s, through the neighbours in the same segment; held slope beyond its ends."""
    return shifted_and_unsure(t_s, segment, values, by_s)[0]


def shifted_and_unsure(
    t_s: Array, segment: NDArray[np.intp], values: Array, by_s: Array | float
) -> tuple[Array, Array]:
    """The same, and how far it may be off (n, ...): what the last rows on either side changed."""
    out, unsure, at_s = np.array(values, dtype=float), np.zeros(np.shape(values)), t_s + by_s
    for rows in stretches(segment):
        t, v = t_s[rows], values[rows]
        if len(t) > 2 and np.all(np.diff(t) > 0):
            out[rows], with_less = between(t, v, at_s[rows])
            unsure[rows] = out[rows] - with_less
    return out, unsure
