"""Readings that remember where the field came from: loops of Dahl's, stops, a saturating loop, a core's magnetisation.

A stop of threshold r follows the field until it is r away from where it turned, several of them make a rounded loop
(Prandtl-Ishlinskii; Visintin, Differential Models of Hysteresis, 1994, ch. III). Dahl's loop (ASME J. Dyn. Syst. 98,
1976) approaches its branch exponentially over a field w. A magnetic part near saturation is a bounded function of the
play, the field less the stop: Preisach's relays of one width (Visintin, ch. IV), about a curve of its own: the relays'
saturation, and powers for what is uneven in it. Relays of a real core are of all widths, their coercive fields spread
log-normally (Visintin, ch. IV; Bertotti, Hysteresis in Magnetism, 1998, ch. 13). A core whose walls are pinned follows
its curve behind it (`labcal.model.effects.magnetised`). How relays and core were magnetised where each segment of the
run began is fitted with them.
Each segment starts at rest in the field it is in; with `kept`, demagnetised before the field came on: each segment
(0), or the first alone, its memory kept from one to the next (1). The loop follows the field along the sensor's own
axes, or along those of the body (`body_…`: a part beside the sensor, which knows nothing of the sensor's misalignment).
Loops that a reference drove in the run are driven by the field without themselves (`less_itself`), others by the
field a that holds them.
A soft bar follows the field along one direction of the body, `lon_deg` from x to y and `lat_deg` towards z, and its own
field points anywhere.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from labcal.model.effects import c_loops
from labcal.model.effects.c_form import CForm, real
from labcal.model.effects.magnetised import bent, langevin, magnetised
from labcal.model.effects.memory import nowhere
from labcal.model.effects.nonlinearity import SATURATION, SATURATION_nT, bend
from labcal.model.effects.past import ANYWHERE, Past
from labcal.model.effects.protocol import Array, Family
from labcal.model.effects.recursion import affine_recursion, clipped_recursion
from labcal.model.effects.regressors import (
    AXES,
    BODY,
    driving,
    driving_in_c,
    on_each_axis,
    per_axis,
    powered,
    stretches,
)
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import ANGLE, BEGINNING, BEGINNING_ON, GIVEN, LESS_ITSELF, SCALE, THRESHOLD, Shape
from labcal.model.effects.term import Term
from labcal.record import Run, offers

THRESHOLDS_nT = (500.0, 1000.0, 2000.0, 4000.0, 10000.0, 25000.0)
SEVERAL_nT = ((500.0, 1500.0, 4000.0, 12000.0), (500.0, 1000.0, 2000.0, 4000.0, 8000.0, 16000.0))
WIDTHS_nT = (1000.0, 4000.0)
OWN_NOISE = 90.0  # deviations of a reading: a narrower loop, driven by the readings, would take off their noise
CORES_nT, PINS_nT = (9000.0, 30000.0), (2000.0, 4000.0, 8000.0, 16000.0)
MOST_BEGINNINGS = 40  # segments: how more began is not fitted
BAR_nT = (2000.0, 6000.0, 18000.0)
LON_deg = (30.0, 90.0, 150.0, 210.0, 270.0, 330.0)
LAT_deg = (20.0, 65.0)  # of half the sphere: nothing is farther than 35 degrees from one of these or its opposite
RELAYS_nT = (2000.0, 6000.0)
TO_AND_FRO = 2.0**1.5  # standard deviations that a sine is wide
BENDS = (2, 3, 4, 5)  # powers of the curve in the middle of a saturating loop, beside its own saturation
STOP, WIDTH = (Shape(name, 0.0, "nT", kind=THRESHOLD) for name in ("r_nT", "w_nT"))
LON, LAT = Shape("lon_deg", 0.0, "deg", LON_deg, ANGLE), Shape("lat_deg", 0.0, "deg", LAT_deg, ANGLE)
SPREAD = Shape("sd_ln", 0.6, "1", (0.6,))  # the standard deviation of ln(coercive field)
MIDDLES = Shape("middles_nT", 0.0, "nT", (6000.0, 20000.0))  # how far apart the middles of the relays' widths lie
KEPT = Shape("kept", 0.0, "1", kind=GIVEN)
CORE, PIN = Shape("a_nT", 0.0, "nT", CORES_nT, SCALE), Shape("pinning_nT", 0.0, "nT", kind=THRESHOLD)
ON_CURVE = Shape("begins_on", 1.0, "1", kind=BEGINNING_ON)  # the part of its curve that a core begins with
ALONE = Shape("less_itself", 1.0, "1", kind=LESS_ITSELF)  # as a reference drives it in the fit
BEGINS = Shape("begins", 1.0, "1", kind=BEGINNING)  # how far from rest, or from demagnetised; 1: anywhere


POINTS, _weights = np.polynomial.hermite_e.hermegauss(7)  # of a normal distribution
WEIGHTS = _weights / _weights.sum()

Before = tuple[Array, Array]  # drive and state (k,) each, of the row before the first


def stop(
    drive: Array,
    threshold: Array | float,
    starts: Sequence[int] = (0,),
    *,
    at_rest: bool = True,
    before: Before | None = None,
    astray: float = 0.0,
) -> Array:
    """The stop operator along rows of drive (n, k) [nT]: within ± threshold (one, or k).

    It starts anew in each row of `starts`, at rest in the field there or at drive 0; the first row goes on from the one
    `before` it where it is no start. `astray` starts so many standard deviations of anywhere from the middle, by less
    than one as much nearer to where it would be.
    """
    steps, first = np.diff(drive, axis=0, prepend=drive[:1]), np.asarray(starts, dtype=np.intp)
    rest = 0.0 if at_rest else np.clip(drive[first], -np.asarray(threshold), threshold)
    steps[first] = (1 - abs(astray)) * rest + astray * ANYWHERE * threshold
    if before is None:
        return clipped_recursion(steps, threshold, first)
    steps[0] = before[1] + (drive[0] - before[0])
    return clipped_recursion(steps, threshold, np.r_[0, first])


def dahl(
    drive: Array, width: float, starts: Sequence[int] = (0,), before: Before | None = None, astray: float = 0.0
) -> Array:
    """Dahl's loop along rows of drive (n, k), within ± 1: dz = (sign(dx) − z) |dx| / width; at rest in `starts`.

    There it may be `astray` by so many standard deviations of anywhere.
    """
    at, state = (drive[0], 0.0) if before is None else before
    steps, first = np.diff(drive, axis=0, prepend=at[None]), np.asarray(starts, dtype=np.intp)
    steps[first] = 0.0
    keep = np.exp(-np.abs(steps) / width)
    keep[first] = 0.0
    add = np.sign(steps) * (1 - keep)
    add[first] = astray * ANYWHERE
    return affine_recursion(keep, add, state)


def kernel(term: Term, scene: Scene) -> Array:
    """The loops z(s_i) along each axis: Dahl's of a width, saturating ones, relays, or stops of the thresholds.

    Against a vector reference s is the reference's: the reading's own noise would drive the loop, and in a field that
    stands still be taken off by it.
    """
    s = driving(term, scene if scene.rig is None else replace(scene, denoised_field_nT=scene.rig.prediction_nT))
    names, off = {shape.name for shape in term.shape}, _astray(term, scene)
    if "pinning_nT" in names:
        return _of_a_core(term, scene, s)
    if SPREAD.name in names:
        return _of_relays(term, scene, s)
    if "w_nT" in names:
        loops = [_along(scene, s, lambda starts, before: dahl(s, term.at("w_nT"), starts, before, off))]
    elif "s_nT" in names:
        play = s - _along(scene, s, lambda starts, before: stop(s, term.at("r_nT"), starts, before=before, astray=off))
        level = term.at("s_nT")
        loops = [np.tanh(play / level) - np.tanh(s / level), bend(s / level), *(s**k for k in BENDS)]
    elif "lon_deg" in names:
        along = s @ _direction(term.at("lon_deg"), term.at("lat_deg"))
        loops = _stopped(term, scene, along[:, None])
        return np.concatenate([on_each_axis(loop[:, 0]) for loop in loops], axis=2)
    else:
        loops = _stopped(term, scene, s)
    return _along_axes(loops, scene)


def _astray(term: Term, scene: Scene) -> float:
    """How far off the loops begin, in deviations of anywhere: other recordings as the run's own segments did."""
    return 0.0 if scene.past is None else scene.past.astray * _begins(term)


def _begins(term: Term) -> float:
    found = term.of(BEGINNING)
    return BEGINS.value if found is None else found.value


def _part(term: Term) -> float:
    found = term.of(BEGINNING_ON)
    return ON_CURVE.value if found is None else found.value


def _of_a_core(term: Term, scene: Scene, s: Array) -> Array:
    """What its magnetisation lags behind its curve, the curve's bend, and what was left of each beginning."""
    a, k, left = term.at(CORE.name), term.at(PIN.name), np.zeros_like(s)

    def loop(starts: Sequence[int], before: Before | None) -> Array:
        off, anew = _astray(term, scene) * ANYWHERE, np.asarray(starts, dtype=np.intp)
        state, left[:] = magnetised(s, a, k, anew, before, off, _part(term))
        return state

    state = _along(scene, s, loop)
    drives = [state - langevin(s / a), bent(s / a), *_begun(term, scene, left)]
    return _along_axes(drives, scene)


def _begun(term: Term, scene: Scene, left: Array) -> list[Array]:
    """What is left (n, 3) of each segment's beginning, in its own rows; the rows of the fit alone know theirs."""
    names = (name for name, _ in term.parameters[2 * len(AXES) :: len(AXES)])
    numbers = (int(name.removeprefix(BODY).split("_")[0].removeprefix("m")) for name in names)
    return [left * (scene.of_the_fit & (scene.segment == number))[:, None] for number in numbers]


def widths(term: Term) -> Array:
    """The widths (7,) [nT] that stand for relays whose coercive fields are spread log-normally."""
    return np.asarray(term.at(STOP.name) * np.exp(term.at(SPREAD.name) * POINTS))


def _of_relays(term: Term, scene: Scene, s: Array) -> Array:
    """Preisach's relays of all widths, less their curve; the curve's bend; and what was left of each beginning.

    A relay switches where the play of its width passes its middle: over middles that are spread, a bounded function of
    the play. It is straight enough in where a segment begins to be fitted by its secant.
    """
    level, each = term.at(MIDDLES.name), widths(term)
    drive, limits = np.tile(s, len(each)), np.repeat(each, s.shape[1])

    def relays(astray: float) -> Array:
        def stopped(starts: Sequence[int], before: Before | None) -> Array:
            return stop(drive, limits, starts, before=before, astray=astray)

        magnetised_by = np.tanh((drive - _along(scene, drive, stopped)) / level)
        return np.asarray(WEIGHTS @ magnetised_by.reshape(len(s), len(each), -1))

    left = np.zeros_like(s)
    if term.of_beginnings and scene.of_the_fit:
        left = (relays(-1.0) - relays(1.0)) / (2 * ANYWHERE)  # the higher its play, the more is magnetised
    drives = [relays(_astray(term, scene)) - np.tanh(s / level), bend(s / level), *_begun(term, scene, left)]
    return _along_axes(drives, scene)


def _along_axes(drives: Sequence[Array], scene: Scene) -> Array:
    """Three columns (n, 3, 3 m) for each of m drives (n, 3): each axis by its own."""
    return np.concatenate(drives, axis=1)[:, None, :] * np.tile(scene.axes, len(drives))


def in_c(term: Term) -> CForm:
    """The same in C (`labcal.model.effects.c_loops`)."""
    s = driving_in_c(term)
    places = {shape.name: f"R(shape[{place}])" for place, shape in enumerate(term.shape)}
    if "pinning_nT" in places:
        return c_loops.core(s, places["a_nT"], places["pinning_nT"], places.get(ON_CURVE.name, "R(1.0)"))
    if "w_nT" in places:
        return c_loops.dahl(s, places["w_nT"])
    if SPREAD.name in places:
        return c_loops.relays(s, places["r_nT"], places[MIDDLES.name], places[SPREAD.name], POINTS, WEIGHTS)
    if "s_nT" in places:
        return c_loops.saturating(s, places["r_nT"], places["s_nT"], BENDS)
    thresholds = [places["r_nT"]] if "r_nT" in places else [real(r) for r in _thresholds(term)]
    begins = "0" if "kept" not in places else "1" if term.at("kept") == 0 else "2"
    if "lon_deg" in places:
        lon, lat = (places[name][2:-1] for name in ("lon_deg", "lat_deg"))  # they stay double
        return c_loops.bar(lon, lat, thresholds, begins)
    return c_loops.stops(s, thresholds, begins)


def _direction(lon_deg: float, lat_deg: float) -> Array:
    lon, lat = np.radians([lon_deg, lat_deg])
    return np.array([np.cos(lat) * np.cos(lon), np.cos(lat) * np.sin(lon), np.sin(lat)])


def _stopped(term: Term, scene: Scene, s: Array) -> list[Array]:
    """The stop of each threshold (n, k), all in one pass."""
    kept = next((shape.value for shape in term.shape if shape.name == "kept"), None)
    thresholds, k = _thresholds(term), s.shape[1]
    drive, limits = np.tile(s, len(thresholds)), np.repeat(thresholds, k)
    off = _astray(term, scene)

    def stopped(starts: Sequence[int], before: Before | None) -> Array:
        return stop(drive, limits, starts, at_rest=kept is None, before=before, astray=off)

    return np.split(_along(scene, drive, stopped, once=kept == 1), len(thresholds), axis=1)


def _along(
    scene: Scene, drive: Array, loop: Callable[[Sequence[int], Before | None], Array], *, once: bool = False
) -> Array:
    """The loop's state (n, k), begun anew in each segment, or `once`; it goes on from the scene's past."""
    past, before = scene.past or Past(len(scene)), None
    starts = [0] if once else [rows.start for rows in stretches(scene.segment)]
    if "loop" in past.before:
        segment, *left = past.before["loop"]
        if once or segment == scene.segment[0]:
            starts, before = starts[1:], (left[0], left[1])
    state, last = loop(starts, before), past.own - 1
    past.after["loop"] = scene.segment[last], drive[last].copy(), state[last].copy()
    return state


def _thresholds(term: Term) -> list[float]:
    if any(shape.name == "r_nT" for shape in term.shape):
        return [term.at("r_nT")]
    return [float(name.removeprefix(BODY)[1:].split("_")[0]) for name, _ in term.parameters[::3]]


def candidates(run: Run) -> list[Term]:
    """Dahl's loop, one stop, several, a saturating loop about a curve, and cores, along either axes; and a bar.

    Stops are tried from rest, and demagnetised before the first segment or before each. From rest no loop is seen that
    is wider than the field goes to and fro within a segment: it would take off the reference's own noise.
    """
    least, travel = _narrowest(run), _travel(run)
    grids = THRESHOLDS_nT, WIDTHS_nT, RELAYS_nT, PINS_nT, BAR_nT
    thresholds, widths, relays, pins, bars = (_above(least, grid) for grid in grids)
    seen, found = tuple(r for r in thresholds if r <= travel), list[Term]()
    for drive in ("", BODY):
        several = [part for part in (_stops(f"{drive}c", _above(least, grid)) for grid in SEVERAL_nT) if part]
        for kept in (KEPT, replace(KEPT, value=1.0)):
            if thresholds:
                found.append(Term(kernel, per_axis(f"{drive}c", "1"), shape=(replace(STOP, grid=thresholds), kept)))
            found += [Term(kernel, part, shape=(kept,)) for part in several]
        if travel <= THRESHOLDS_nT[0]:
            continue
        if len(run.segments) <= MOST_BEGINNINGS:
            found += [_core(run, drive, pins)] if pins else []
            found += [_relays(run, drive, relays)] if relays else []
        units = [("nT", replace(WIDTH, grid=seen)), ("1", replace(STOP, grid=seen))]
        found += [Term(kernel, per_axis(f"{drive}c", unit), shape=(shape,)) for unit, shape in units if seen]
        found += [Term(kernel, part) for part in several]
        if widths:
            shapes = (replace(STOP, grid=widths), replace(SATURATION, value=0.0, grid=SATURATION_nT))
            curve = (*per_axis(f"{drive}t1", "nT"), *(p for k in BENDS for p in per_axis(f"{drive}a{k}", powered(k))))
            found.append(Term(kernel, (*per_axis(f"{drive}c", "nT"), *curve), shape=shapes))
    if bars:
        bar = _stops(f"{BODY}c", bars)
        found += [Term(kernel, bar, shape=(LON, LAT, kept)) for kept in (KEPT, replace(KEPT, value=1.0))]
    common = (BEGINS, ALONE) if _by_reference(run) else (BEGINS,)
    return [replace(term, shape=(*term.shape, *common)) for term in found]


def _above(least: float, grid: tuple[float, ...]) -> tuple[float, ...]:
    return tuple(r for r in grid if r >= least)


def _stops(name: str, thresholds: tuple[float, ...]) -> tuple[tuple[str, str], ...]:
    """The parameters of several stops."""
    return tuple(p for r in thresholds for p in per_axis(f"{name}{r:.0f}", "1"))


def _core(run: Run, drive: str, pins: tuple[float, ...]) -> Term:
    """A core whose walls are pinned."""
    return _magnetised(run, drive, (CORE, replace(PIN, grid=pins), ON_CURVE))


def _relays(run: Run, drive: str, grid: tuple[float, ...]) -> Term:
    """A core of relays."""
    return _magnetised(run, drive, (replace(STOP, grid=grid), MIDDLES, SPREAD))


def _magnetised(run: Run, drive: str, shape: tuple[Shape, ...]) -> Term:
    """A core with its curve, and with how it was magnetised at the beginning of each segment."""
    begun = tuple(p for number in np.unique(run.segment_index).tolist() for p in per_axis(f"{drive}m{number}", "nT"))
    curve = (*per_axis(f"{drive}c", "nT"), *per_axis(f"{drive}t1", "nT"))
    return Term(kernel, (*curve, *begun), shape=shape, of_beginnings=len(begun))


def _travel(run: Run) -> float:
    """How far [nT] the readings go to and fro within a segment, at most."""
    parts = (run.reading[run.rows(k)] for k in range(len(run.segments)))
    known = (part[np.isfinite(part).all(axis=1)] for part in parts)
    moved = [float(np.std(part, axis=0).max()) for part in known if len(part)]
    return TO_AND_FRO * max(moved, default=0.0) * run.dut.nominal_nT_per_unit


def _narrowest(run: Run) -> float:
    """The narrowest loop [nT] that may be tried: any where a reference drives it, else one far above the noise.

    Infinite where no segment sweeps the field: what ripples there is noise, of the reference as well.
    """
    far = OWN_NOISE * _noise(run)
    known = run.select(np.asarray(np.isfinite(run.reading).all(axis=1)))
    parts = [known.reading[rows] for rows in stretches(known.segment_index)]
    if max(float(np.ptp(part, axis=0).max()) for part in parts) * run.dut.nominal_nT_per_unit < far:
        return np.inf
    return 0.0 if _by_reference(run) else far


def _by_reference(run: Run) -> bool:
    """Whether a reference drives loops: its vector does not hold what they do to the readings."""
    return all(offers(run, segment) == "vector" for segment in run.segments)


def _noise(run: Run) -> float:
    """Of a reading [nT]; a thousandth of it where none is declared."""
    return run.dut.noise_nT or 1e-3 * float(np.sqrt(np.nanmean(run.reading**2))) * run.dut.nominal_nT_per_unit


FAMILY = Family(
    "hysteresis",
    "sensor",
    kernel,
    candidates,
    phrase="magnetic parts remember earlier fields",
    shapes=(STOP, WIDTH, SATURATION, SPREAD, MIDDLES, CORE, PIN, LON, LAT, KEPT, ON_CURVE, BEGINS, ALONE),
    of_field=True,
    follows_reference=True,
    extends=("nonlinearity",),
    experiment="step the field up and down through the same values, or turn backwards",
    reach_s=nowhere,
    in_pieces=True,
    in_c=in_c,
    drawn_against="angle",
)
