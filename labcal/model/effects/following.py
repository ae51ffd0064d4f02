"""Offsets that follow a channel: at once, behind it by a time constant or a delay, or as a sum of several responses."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from labcal.model.effects import memory
from labcal.model.effects.regressors import AXES, delayed, low_passed, middle, on_each_axis, per_axis, stretches
from labcal.model.effects.scene import Array, Scene
from labcal.model.effects.shape import CARRIED_OFF, DELAY, LEVEL, TIME_CONSTANT, Shape
from labcal.model.effects.term import Kernel, Term
from labcal.record import Run, period_s
from labcal.record.run import Channel

LONGEST_S = 5.0  # delay either way that is searched: a channel's clock may be ahead as well
ROWS = 4  # the same where rows are far apart
POINTS = 20  # of the grid on either side
BEHIND = Shape("tau_s", 100.0, "s", kind=TIME_CONSTANT)
LATE = Shape("delay_s", 0.0, "s", kind=DELAY)
OFF = Shape("begins_off", 0.0, "1", kind=LEVEL)  # in units of the drive
WITHIN = Shape("begins_within", 0.0, "1", kind=CARRIED_OFF)  # in units of the drive; half its range, until it is fitted
MOVES = 0.1  # of its range, within a segment: a channel that moves less there stands still
MOST_BEGINNINGS = 12  # segments: how more began is not fitted
OF_THE_RANGE = (-0.5, -0.25, 0.0, 0.25, 0.5)  # of what the channel was seen to do: how far off a response may begin


def instantaneous(channel: Channel, kernel: Kernel) -> Term:
    """C in nT of B for each unit of the channel."""
    return Term(kernel, per_axis("c", f"nT/{channel.unit}"), (channel.name,), {channel.name: middle(channel)})


def first_order(channel: Channel, kernel: Kernel, tau: Shape) -> Term:
    """The same through a first-order response of time constant `tau`."""
    term = instantaneous(channel, kernel)
    return Term(kernel, term.parameters, term.channels, term.reference_value, (tau,))


def begun_elsewhere(response: Term, channel: Channel) -> Term:
    """The same response, begun anywhere: what the channel did before the run nobody recorded.

    So far off the channel's first value, in its units, in the run of the fit; how another recording begins it does not
    say.
    """
    known = channel.values[np.isfinite(channel.values)]
    grid = tuple(part * float(np.ptp(known)) for part in OF_THE_RANGE)
    return replace(response, shape=(*response.shape, replace(OFF, unit=channel.unit, grid=grid)))


def begun_anew(response: Term, channel: Channel, run: Run) -> list[Term]:
    """The same response, begun anywhere in each segment: what the channel did between two of them nobody recorded.

    How far off, on each axis, in deviations of half of what the channel was seen to do; it holds in the run of the fit
    alone. Only in segments in which the channel moves, for where it stands still it had stood; at least two, and not
    very many. Nor slower than the longest lasts: what fades in none is a constant of its own in each.
    """
    known = channel.values[np.isfinite(channel.values)]
    pieces = [(int(run.segment_index[rows.start]), rows) for rows in stretches(run.segment_index)]
    moved = {number for number, rows in pieces if _range(channel.values[rows]) >= MOVES * np.ptp(known)}
    longest_s, numbers = max(float(np.ptp(run.t_s[rows])) for _, rows in pieces), sorted(moved)
    (tau,) = response.shape
    seen = tuple(tau_s for tau_s in tau.grid if tau_s <= longest_s)
    if not seen or not 1 < len(numbers) <= MOST_BEGINNINGS:
        return []
    begun = tuple(p for number in numbers for p in per_axis(f"b{number}", response.parameters[0][1]))
    within = replace(WITHIN, value=float(np.ptp(known)) / 2, unit=channel.unit)
    shape, parameters = (replace(tau, grid=seen), within), (*response.parameters, *begun)
    return [replace(response, parameters=parameters, shape=shape, of_beginnings=len(begun))]


def _range(values: Array) -> float:
    known = values[np.isfinite(values)]
    return float(np.ptp(known)) if len(known) else 0.0


def carried_off(term: Term) -> float:
    """How far off a state may be that is carried over a gap, as a standard deviation in units of the drive."""
    within = term.of(CARRIED_OFF)
    return 0.0 if within is None else within.value


def beginnings(term: Term, scene: Scene) -> list[Array]:
    """What is left of each segment's beginning (n,), as far off as the channel's half range; zero in other segments."""
    if not term.of_beginnings:
        return []
    left, within = np.zeros(len(scene)), term.at(WITHIN.name)
    for rows in stretches(scene.segment):
        left[rows] = within * np.exp(-(scene.t_s[rows] - scene.t_s[rows][0]) / time_constants(term)[0])
    numbers = (int(name.removeprefix("b").partition("_")[0]) for name, _ in term.parameters[term.lasting :: len(AXES)])
    return [left * (scene.of_the_fit & (scene.segment == number)) for number in numbers]


def begins_off(term: Term, scene: Scene) -> float | None:
    """How far off the channel the response begins: in the rows of the fit as that found it, in others nobody knows."""
    known = scene.past is None and any(shape.name == OFF.name for shape in term.shape)
    return term.at(OFF.name) if known else None


def delayed_terms(channel: Channel, kernel: Kernel, run: Run, most: int = POINTS) -> list[Term]:
    """The same after a delay: E(t) = c (q(t − delay_s) − q_ref), a negative one where the channel's clock is behind.

    Of `most` delays either way at most.
    """
    grid = _delays(run.t_s, most)
    if not grid:
        return []
    term = instantaneous(channel, kernel)
    shape = replace(LATE, value=grid[0], grid=grid)
    return [Term(kernel, term.parameters, term.channels, term.reference_value, (shape,))]


def _delays(t_s: Array, most: int) -> tuple[float, ...]:
    """Delays [s] either way, a row apart where that is not too fine."""
    if len(t_s) < 2 * ROWS:
        return ()
    step = period_s(t_s)
    reach = max(LONGEST_S, ROWS * step)
    count = min(round(reach / step), most)
    return tuple(reach / count * k for k in (*range(-count, 0), *range(1, count + 1)))


def multi_tau(channel: Channel, kernel: Kernel, run: Run, taus_s: Sequence[int]) -> list[Term]:
    """A sum of responses, each with its own c: `c12s_x` belongs to 12 s, `c0s_x` to none.

    One that is slower than the run is long sums the channel up: several such are a drift in time, whatever its cause.
    """
    seen = [tau for tau in taus_s if tau < float(np.ptp(run.t_s))]
    if len(seen) < 2:
        return []
    term = instantaneous(channel, kernel)
    parameters = tuple(p for tau in seen for p in per_axis(f"c{tau}s", f"nT/{channel.unit}"))
    return [Term(kernel, parameters, term.channels, term.reference_value)]


def responses(term: Term, scene: Scene) -> Array:
    """The columns (n, 3, p) of all four."""
    drive = term.drive(scene)
    if (late := term.of(DELAY)) is not None:
        return on_each_axis(delayed(scene.t_s, scene.segment, drive, late.value))
    ends, off = term.ends_of_drive(scene), begins_off(term, scene)
    unsure, taus = carried_off(term), time_constants(term)
    behind = [low_passed(scene.t_s, scene.segment, drive, tau, scene.past, ends, off, unsure) for tau in taus]
    return np.concatenate([on_each_axis(one) for one in (*behind, *beginnings(term, scene))], axis=2)


def time_constants(term: Term) -> list[float]:
    """Of each response to a channel [s]: `tau_s`, or 12 for `c12s_x`; 0 for one that is prompt."""
    if term.shape:
        return memory.time_constants(term)
    found = [re.match(r"c(\d+)s_", name) for name, _ in term.parameters[::3]]
    return [float(match[1]) if match else 0.0 for match in found]


def reach_s(term: Term) -> float | None:
    """How far [s] from a row the rows lie that it looks at; a sum of responses is a state, one that is prompt none."""
    return memory.reach_s(term) if term.shape else (0.0 if any(time_constants(term)) else None)
