"""Data checks before any search: the reference's frame and axes, the angle's sense, clocks, units, excitation.

A base model that misses by far more than any effect of a sensor is not explained by an effect. Before any is searched
the run is fitted again as it would be without one such fault; where that explains nearly all, the fault is named.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.fit.vector.observations import SCALAR
from labcal.loop import policy
from labcal.loop.data.batch_fit import BatchFit
from labcal.loop.data.credible import without_wild_rows
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.data.noise_floor import NoiseFloor
from labcal.loop.parallel import parallel_map
from labcal.loop.result import Finding
from labcal.record import Run

Array = NDArray[np.float64]
AXES = "xyz"
QUICK_FIT_ROWS = 160  # rows of a run in the batch fits
AXIS_ROUNDING = 0.4  # of a turn's elements: farther from 0 and ±1 it exchanges no axes
MIN_FIELD_nT = 1.0  # of a field: less is none
OFFSETS_S = np.concatenate([np.arange(1.0, 10.1, 0.5), np.arange(12.0, 61.0, 2.0)])  # less is an effect's lag
STEPS_S = (1.0, 0.5, 0.25, 0.1)  # about the best of these, by turns


@dataclass(frozen=True, slots=True)
class DataFault:
    """A possible fault of a run, the run corrected for it, and how many changes that takes."""

    says: str
    corrected: Run
    changes: int
    axes: Array | None = None  # (3, 3) of the reference


def check_data(problem: LinearProblem, level: NoiseFloor) -> Finding | None:
    """The fault that explains a gross misfit of the base model; else None.

    A few wild rows are no such misfit: a frame, a clock or a unit that is wrong is so in all rows.
    """
    field = float(np.sqrt(np.mean(problem.observations.magnitude**2)))
    if (finding := _dead_axis(problem) or units(problem, field)) is not None:
        return finding
    left = float(np.sqrt(np.mean(problem.length_nT(without_wild_rows(problem.residual_nT)) ** 2)))
    law = policy.POLICY
    if left < law.floor_ratio * level.nT:
        return None
    run, gross = _thinned(problem.run), max(law.gross_factor * level.nT, law.max_field_uncertainty * field)
    declared, _ = _batch_fit(problem, [run]).fitted(0)
    if min(left, declared) < gross:
        return _insufficient_excitation(problem, left)
    mistake = _frame(problem, run, declared) or _clock(problem, declared)
    return mistake or _insufficient_excitation(problem, left) or incoherent(left, field)


def _dead_axis(problem: LinearProblem) -> Finding | None:
    """Axes of the device with the same reading in every row."""
    dead = [axis for axis, values in zip(AXES, problem.observations.reading.T, strict=True) if np.ptp(values) == 0]
    if not dead:
        return None
    return Finding("dead-axis", "data", f"The reading along {' and '.join(dead)} is the same in every row.")


def units(problem: LinearProblem, field: float) -> Finding | None:
    """Readings of another order of magnitude than the field: no gain and no offset explains them."""
    readings = problem.observations.reading * problem.observations.scale * problem.run.dut.nominal_nT_per_unit
    size, spread = (float(np.sqrt(np.mean(np.sum(v**2, axis=1)))) for v in (readings, readings - readings.mean(axis=0)))
    factor = policy.POLICY.unit_factor
    if not (size * factor < field or spread > factor * max(field, MIN_FIELD_nT)):
        return None
    text = f"The readings come to {size:.3g} nT, the reference to {field:.3g} nT"
    return Finding("units", "data", f"{text}: the unit or nominal_nT_per_unit of one of them is not as declared.")


def _insufficient_excitation(problem: LinearProblem, left: float) -> Finding | None:
    """A map that this run does not determine, where a whole one would leave far less than the base that it does."""
    if problem.base == "affine" or problem.kind != "vector":
        return None
    whole, _ = _batch_fit(problem, [_thinned(problem.run)]).fitted(0)
    if whole * policy.POLICY.floor_ratio > left:
        return None
    text = f"This run does not determine the whole map ({problem.base} alone): too few axes or fields are excited"
    change = f"a whole map would leave {whole:.0f} instead of {left:.0f} nT, and be anyone's guess"
    return Finding("excitation", "data", f"{text}; {change}. Turn about the other body axes too.")


def turned_axes(problem: LinearProblem) -> Finding | None:
    """Axes that the fitted map exchanges or flips: it fits, but the device's axes are not the declared ones."""
    if bool((problem.observations.kind == SCALAR).all()) or problem.base != "affine":
        return None
    u, _, v = np.linalg.svd(problem.affine.K)
    near = np.round(u @ v)
    clear = np.abs(u @ v - near).max() < AXIS_ROUNDING and bool((np.abs(near).sum(axis=0) == 1).all())
    if not clear or bool((near == np.eye(3)).all()):
        return None
    seen = ", ".join(f"{AXES[i]} is the device's {_signed(row)}" for i, row in enumerate(near))
    kind = "mirrors" if np.linalg.det(near) < 0 else "turns"
    cause = "an axis of the device or of the reference is flipped or two are swapped" if kind == "mirrors" else (
        "the mounting or the names of the axes are not as declared"
    )  # fmt: skip
    return Finding("axes", "data", f"The fitted map {kind} the axes ({seen}): {cause}.")


def _batch_fit(problem: LinearProblem, runs: Sequence[Run]) -> BatchFit:
    return BatchFit.of(runs, problem.parameterisation.name, as_scalar=bool((problem.observations.kind == SCALAR).all()))


def _thinned_rows(run: Run) -> NDArray[np.intp]:
    return np.unique(np.linspace(0, len(run) - 1, QUICK_FIT_ROWS).astype(np.intp))


def _thinned(run: Run) -> Run:
    return run.select(_thinned_rows(run))


def _frame(problem: LinearProblem, run: Run, declared: float) -> Finding | None:
    """The frame, axes or angle with which the reference fits far better."""
    if run.reference_vector is None:
        return None
    law, tried = policy.POLICY, list[tuple[DataFault, float, Array]]()
    worth = law.equivalent_rms * declared / law.gross_factor
    for alike in (*([other] for other in (*_frames(run), *_senses(run))), [*_axes(run)]):
        tries = _batch_fit(problem, [mistake.corrected for mistake in alike])
        tried += [(mistake, *tries.fitted(i, worth)) for i, mistake in enumerate(alike)]
    tried = [(mistake, left, K) for mistake, left, K in tried if is_full_rank(K)]
    least = min((left for _, left, _ in tried), default=np.inf)
    if least * law.gross_factor > declared:
        return None
    as_good = [(mistake, K) for mistake, left, K in tried if left <= law.equivalent_rms * least]
    equal = sorted((_prefer_unmirrored(mistake, K) for mistake, K in as_good), key=lambda m: m.changes)
    also = f" ({' or '.join(m.says for m in equal[1:3])} fits as well)" if len(equal) > 1 else ""
    text = f"The run fits far better {equal[0].says}: the base model leaves {least:.0f} instead of {declared:.0f} nT"
    return Finding("reference-frame", "data", f"{text}{also}.")


def _frames(run: Run) -> Iterator[DataFault]:
    frames = {s.reference_frame for s in run.segments}
    if frames == {"cage"}:
        as_body = replace(run, segments=tuple(replace(s, reference_frame="body") for s in run.segments))
        yield DataFault("with the reference taken in the body's frame, not the cage's", as_body, 1)
    attitudes = all(s.axis_body is not None or s.body_from_cage is not None for s in run.segments)
    if frames == {"body"} and attitudes:
        as_cage = replace(run, segments=tuple(replace(s, reference_frame="cage") for s in run.segments))
        yield DataFault("with the reference taken in the cage's frame, not the body's", as_cage, 1)


def _senses(run: Run) -> Iterator[DataFault]:
    if run.angle_deg is None:
        return
    yield DataFault("with the platform's angle counted the other way", replace(run, angle_deg=-run.angle_deg), 1)
    in_degrees = replace(run, angle_deg=np.degrees(run.angle_deg))
    yield DataFault("with the platform's angle taken in radians, not degrees", in_degrees, 1)


def _axes(run: Run) -> Iterator[DataFault]:
    """The 24 ways of turning the reference's axes; their mirror images leave as much, for K may change its sign."""
    assert run.reference_vector is not None
    for P in signed_permutations():
        if np.linalg.det(P) > 0 and not np.array_equal(P, np.eye(3)):
            yield DataFault(_describe(P), replace(run, reference_vector=run.reference_vector @ P.T), _changes(P), P)


def signed_permutations() -> list[Array]:
    """The 48 matrices that exchange and flip axes."""
    orders, signs = itertools.permutations(range(3)), list(itertools.product((1.0, -1.0), repeat=3))
    return [np.diag(sign) @ np.eye(3)[list(order)] for order in orders for sign in signs]


def is_full_rank(K: Array) -> bool:
    """Whether every axis is seen: a map that flattens the readings fits any constant."""
    sizes = np.linalg.svd(K, compute_uv=False)
    return bool(sizes[2] * policy.POLICY.gross_factor > sizes[0])


def _prefer_unmirrored(mistake: DataFault, K: Array) -> DataFault:
    """The mirror image where that is the one that leaves the device itself unmirrored."""
    if mistake.axes is None or np.linalg.det(K) > 0:
        return mistake
    return DataFault(_describe(-mistake.axes), mistake.corrected, _changes(-mistake.axes), -mistake.axes)


def _changes(P: Array) -> int:
    """How much is changed: an exchange of two axes counts as one flip does."""
    moved = int(np.sum(np.abs(np.diag(P)) == 0))
    return int(np.sum(P < 0)) + max(moved - 1, 0)


def _describe(P: Array) -> str:
    moved = [AXES[i] for i in range(3) if P[i, i] == 0]
    flipped = [AXES[i] for i in range(3) if P[i].min() < 0]
    words = []
    if len(moved) == 2:
        words.append(f"{moved[0]} and {moved[1]} swapped")
    elif moved:
        words.append("x, y, z read as " + ", ".join(AXES[int(np.argmax(np.abs(row)))] for row in P))
    if flipped:
        words.append(f"{' and '.join(flipped)} flipped")
    return "with the reference's " + " and ".join(words)


def _signed(row: Array) -> str:
    place = int(np.argmax(np.abs(row)))
    return ("−" if row[place] < 0 else "") + AXES[place]


def _clock(problem: LinearProblem, declared: float) -> Finding | None:
    """The stream whose stamps are seconds off, and by how much; in a field that never changes no stamp can be."""
    if _never_changes(problem.run):
        return None
    found = sorted(parallel_map(partial(_offset, problem), _streams(problem.run)), key=lambda o: o.residual_nT)
    equal = [o for o in found if o.residual_nT <= policy.POLICY.equivalent_rms * found[0].residual_nT]
    farthest = max(abs(o.offset_s) for o in equal)
    if found[0].residual_nT * policy.POLICY.gross_factor > declared or farthest < OFFSETS_S.min():
        return None
    text = ", or ".join(f"the stamps of {STREAM_OWNER[o.stream]} {_offset_text(o.offset_s)}" for o in equal)
    change = f"put right, the base model leaves {found[0].residual_nT:.0f} instead of {declared:.0f} nT"
    return Finding("clock", "data", f"The clocks do not agree: {text}; {change}.")


def _never_changes(run: Run) -> bool:
    """Whether the reference is one magnitude throughout: an offset would only choose other rows."""
    magnitude = run.reference_magnitude
    return run.reference_vector is None and magnitude is not None and bool(np.ptp(magnitude) == 0)


def _offset_text(offset_s: float) -> str:
    return f"seem {abs(offset_s):.1f} s {'late' if offset_s > 0 else 'early'}"


def _streams(run: Run) -> Iterator[str]:
    yield "reading"
    if run.reference_vector is not None:
        yield "reference_vector"
    elif run.reference_magnitude is not None:
        yield "reference_magnitude"
    if run.angle_deg is not None:
        yield "angle_deg"


STREAM_OWNER = {
    "reading": "the device under test",
    "reference_vector": "the reference",
    "reference_magnitude": "the reference",
    "angle_deg": "the platform's angle",
}


@dataclass(frozen=True, slots=True)
class ClockOffset:
    """What is left [nT] when a stream's stamps are taken to be late by `offset_s`."""

    stream: str
    offset_s: float
    residual_nT: float


def _offset(problem: LinearProblem, stream: str) -> ClockOffset:
    """The smallest offset that does nearly as well as the best one, in whole steps of the rows.

    Between two rows the mean of both would have less noise, and seem to fit better.
    """
    step = float(np.median(np.diff(problem.run.t_s)))
    coarse = np.unique(np.round(np.concatenate([OFFSETS_S, -OFFSETS_S]) / step)) * step
    coarse = coarse[np.argsort(abs(coarse), kind="stable")]
    tries = _at_offsets(problem, stream, coarse)
    enough = 2 * tries.least()
    tried = (ClockOffset(stream, float(s), tries.fitted(i, enough)[0]) for i, s in enumerate(coarse))
    best = next(o for o in tried if o.residual_nT <= enough)
    for width in STEPS_S:
        sides = best.offset_s + max(round(width / step), 1) * step * np.array([-1.0, 1.0])
        tries = _at_offsets(problem, stream, sides)
        near = [ClockOffset(stream, float(s), tries.fitted(i, best.residual_nT)[0]) for i, s in enumerate(sides)]
        better = [o for o in near if policy.POLICY.equivalent_rms * o.residual_nT < best.residual_nT]
        best = min(better, key=lambda o: o.residual_nT, default=best)
    return best


def _at_offsets(problem: LinearProblem, stream: str, offsets_s: Array) -> BatchFit:
    """The run when each row takes the stream's value of this much later; without rows where too few have one."""
    run, rows = problem.run, _thinned_rows(problem.run)
    values = getattr(run, stream)
    if stream == "angle_deg":
        values = np.unwrap(np.where(np.isfinite(values), values, 0.0), period=360.0)
    there = time_shifted(run.t_s, values, (run.t_s[rows] + offsets_s[:, None]).ravel())
    there = there.reshape(len(offsets_s), len(rows), *values.shape[1:])
    known = np.isfinite(there if there.ndim == 2 else there[:, :, 0])
    known[2 * known.sum(axis=1) < len(rows)] = False
    thin, runs = run.select(rows), list[Run]()
    for moved, sure in zip(there, known, strict=True):
        changed: dict[str, Any] = {stream: moved}
        runs.append(replace(thin, **changed).select(sure))
    return _batch_fit(problem, runs)


def time_shifted(t_s: Array, values: Array, at_s: Array) -> Array:
    """`values` (n, ...) at other times, linearly; NaN farther from two neighbours than two usual intervals."""
    place = np.clip(np.searchsorted(t_s, at_s), 1, len(t_s) - 1)
    before, after = t_s[place - 1], t_s[place]
    part = (at_s - before) / np.maximum(after - before, 1e-12)
    known = (part >= 0) & (part <= 1) & (after - before <= 2 * float(np.median(np.diff(t_s))))
    part = np.where(known, part, np.nan).reshape(-1, *[1] * (values.ndim - 1))
    return np.asarray((1 - part) * values[place - 1] + part * values[place])


def incoherent(left: float, field: float) -> Finding | None:
    """A misfit `left` [nT] that is a large part of the `field` [nT]."""
    if left * policy.POLICY.gross_factor < field:
        return None
    text = f"The readings do not follow the reference: the base model leaves {left:.0f} of {field:.0f} nT"
    return Finding(
        "reference", "data", f"{text}, and no flip or exchange of axes and no offset of a clock explains it."
    )
