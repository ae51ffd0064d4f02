"""What the form of an effect may miss: a smooth function of its own inputs, which must become nobody's name.

An effect of another form in the same inputs is the effect's own columns times something smooth in its channel, in the
field and in the angle, or the same columns earlier, later or smeared in time (Kennedy & O'Hagan's discrepancy, J. R.
Stat. Soc. B 63, 425, 2001, of one effect alone). A cause that stands beside another has to show what such a function
of the other's inputs does not; of two forms in the same inputs the likelier one is found with it integrated out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate, Span
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.coloured import NullModel
from labcal.loop.noise.marginal import NullEliminated
from labcal.loop.noise.nuisance import orthogonal_complement, principal_span
from labcal.model.effects import Scene
from labcal.model.effects.regressors import delayed, low_passed
from labcal.model.smooth import b_splines
from labcal.record import period_s

Array = NDArray[np.float64]
HARMONICS = (1, 2)  # of the platform's angle
LATE_ROWS = 2  # earlier and later
SMEARED_ROWS = (3, 12, 50)  # time constants of first-order responses
RESPONSES: tuple[tuple[Callable[[Array, NDArray[np.intp], Array, float], Array], float], ...] = (
    *((delayed, k) for k in (-LATE_ROWS, LATE_ROWS)),
    *((low_passed, k) for k in SMEARED_ROWS),
)
CUBIC, SPLINES = 3, 8  # degree of the splines over a channel's range, and how many
MOST_DIRECTIONS = 300  # of a misfit that are integrated over: the work grows as their cube
KEPT = 1e-6  # of the squares of the largest direction: smaller ones are no part of a misfit


def misfits(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Span]:
    """What the forms of the accepted effects may miss; nothing of a sensor's that goes by the run's time alone."""
    parts = (part for one in accepted for part in one.parts)
    return [_misfit(pool, part) for part in parts if part.belongs_to == "rig" or not part.family.bound_to_run]


def mistimed(pool: CandidateSet, accepted: Sequence[Candidate]) -> list[Span]:
    """What the effects would be if they came earlier, later or smeared in time, and were of their form all the same."""
    return [_mistimed(pool, part) for one in accepted for part in one.parts]


def evidence_beside_misfit(
    pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, missed: Sequence[Span]
) -> float:
    """The evidence for a cause beside `others` [nats] where it may miss a function of `missed`, integrated out.

    The prior of that function is as wide as makes the data likeliest: where the form is whole, it costs nothing.
    """
    null = pool.null_model(others)
    found = likeliest(pool.null_model([*others, chosen]), missed)
    return found - null.null.log - pool.penalty(chosen, pool.score(chosen, null).rank)


def evidence_over_misfit(
    pool: CandidateSet, others: Sequence[Candidate], chosen: Candidate, missed: Sequence[Span]
) -> float:
    """The evidence for a cause [nats] where the null may miss such a function as well, each at its likeliest prior."""
    null = pool.null_model(others)
    gain = likeliest(pool.null_model([*others, chosen]), missed) - likeliest(null, missed)
    return gain - pool.penalty(chosen, pool.score(chosen, null).rank)


def likeliest(model: NullModel, missed: Sequence[Span]) -> float:
    """The log-likelihood [nats] of a model that misses a function of `missed`, or nothing, whichever is likelier.

    Each direction is a priori as wide as its column is long; of very many the longest count.
    """
    columns = np.concatenate([span.columns for span in missed], axis=2)
    if not columns.shape[2]:  # a form that is in the base whole has nothing to miss
        return model.null.log
    if columns.shape[2] > MOST_DIRECTIONS:
        columns = columns[:, :, np.argsort(-np.einsum("nqc,nqc->c", columns, columns))[:MOST_DIRECTIONS]]
    found = NullEliminated.of(model, columns, range(len(model.bands.spectra))).best()
    return max(found.log, model.null.log)


def gain_of(model: NullModel, missed: Sequence[Span]) -> float:
    """What a function of `missed` adds to the log-likelihood of a model [nats]; zero where nothing is missed."""
    return likeliest(model, missed) - model.null.log


def _misfit(pool: CandidateSet, chosen: Candidate) -> Span:
    def made() -> Span:
        driven, carried = (_transformed(pool, chosen, forms) for forms in (_otherwise_driven, _otherwise_carried))
        own = orthogonal_complement(pool.base, pool.transformed_columns(chosen))
        driven = orthogonal_complement(np.concatenate([pool.base, own], axis=2), driven)
        return Span(principal_span(np.concatenate([driven, carried], axis=2), tolerance=KEPT, common=True))

    return pool.cached("misfit", (chosen,), made)


def _mistimed(pool: CandidateSet, chosen: Candidate) -> Span:
    def made() -> Span:
        timed = orthogonal_complement(pool.base, _transformed(pool, chosen, _otherwise_timed))
        return Span(principal_span(timed, tolerance=KEPT, common=True))

    return pool.cached("mistimed", (chosen,), made)


def _transformed(pool: CandidateSet, chosen: Candidate, forms: Callable[[Scene, Candidate], Iterator[Array]]) -> Array:
    """These forms of the effect as the pool's columns are: whitened, binned, and cosine-transformed."""
    shape = pool.whole.scene.field_nT.shape

    def on_all_rows() -> Array:
        return pool.problem.whitened(np.concatenate([np.zeros((*shape, 0)), *forms(pool.whole.scene, chosen)], axis=2))

    return pool.transformed(pool.store.memo.get(forms, (chosen,), on_all_rows))


def _otherwise_driven(scene: Scene, chosen: Candidate) -> Iterator[Array]:
    """The effect bent in its channels, earlier, later and smeared, each (n, 3, p).

    Of a switched load all powers are the same, and a slow response is mostly the load: only what is new counts.
    """
    own = _lasting(scene, chosen)
    bent = [own * drive[:, None, None] for drive in _channels(scene, chosen)]
    yield from bent
    if chosen.belongs_to != "rig" or chosen.term.channels:
        for columns in (own, *bent[:1]):
            yield from _in_time(scene, columns)


def _otherwise_timed(scene: Scene, chosen: Candidate) -> Iterator[Array]:
    """The effect earlier, later and smeared, each (n, 3, p)."""
    yield from _in_time(scene, _lasting(scene, chosen))


def _otherwise_carried(scene: Scene, chosen: Candidate) -> Iterator[Array]:
    """The effect as it would be if it grew with the field or with the platform's angle, each (n, 3, p)."""
    own = _lasting(scene, chosen)
    yield from (own * drive[:, None, None] for drive in _surroundings(scene, chosen))


def _lasting(scene: Scene, chosen: Candidate) -> Array:
    """Its columns (n, 3, p) but for those of how the segments began."""
    return np.nan_to_num(chosen.term.columns(scene)[:, :, : chosen.term.lasting])


def _channels(scene: Scene, chosen: Candidate) -> Iterator[Array]:
    """Its channels and their squares, each (n,)."""
    for name in chosen.term.channels:
        x = scaled(scene.channels[name] - np.median(scene.channels[name]))
        yield from (x, x**2)


def _surroundings(scene: Scene, chosen: Candidate) -> Iterator[Array]:
    """The field, for the rig in the cage, and the angle, each (n,); nothing for what a channel alone drives."""
    if chosen.belongs_to == "rig" and scene.rig is not None:
        yield from scaled(np.nan_to_num(scene.rig.reference_nT)).T
        turning = np.isfinite(scene.rig.angle_rad)
        angle = np.nan_to_num(scene.rig.angle_rad)
        yield from (turning * wave(k * angle) for k in HARMONICS for wave in (np.cos, np.sin) if turning.any())
    elif chosen.family.of_field or not chosen.term.channels:
        yield from scaled(scene.driving_field_nT).T


def _in_time(scene: Scene, columns: Array) -> Iterator[Array]:
    """How columns (n, 3, p) change where they come earlier, later or smeared."""
    flat, step = columns.reshape(len(columns), -1), period_s(scene.t_s)
    live = np.flatnonzero(flat.any(axis=0))
    for response, by_rows in RESPONSES:
        moved = np.zeros_like(flat)
        for j in live:
            moved[:, j] = response(scene.t_s, scene.segment, flat[:, j], by_rows * step) - flat[:, j]
        yield moved.reshape(columns.shape)


def bends(x: Array) -> Array:
    """Smooth functions of x (n,) that add up to any other (n, SPLINES): B-splines over its range."""
    low, high = float(x.min()), float(x.max())
    step = max(high - low, 1e-300) / (SPLINES - CUBIC)
    knots = np.asarray(low + step * (np.arange(SPLINES + CUBIC + 1) - CUBIC), dtype=np.float64)
    return b_splines(knots, CUBIC, x)


def scaled(values: Array) -> Array:
    """Values (n, ...) with a largest magnitude of one."""
    return np.asarray(values / max(float(np.max(np.abs(values))), 1e-300))
