"""Cross-validation by blocks of time: errors on rows that neither the fit nor the selection saw, with guard gaps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.parallel import parallel_map
from labcal.model.effects import Scene
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
FOLDS = 5
TWO_BLOCKS = 24  # rows of a segment that is cut in two at least
NEVER = -1
BLOCKS = 40  # about so many blocks in a run, none shorter than so many
CORRELATION_TIMES, BLOCK_ROWS = 5, 8  # of the residual, and rows
DRAWS = 500
INTERVAL_95 = (2.5, 97.5)  # percentiles: the contract's improvement_ci95_nT


@dataclass(frozen=True, slots=True, eq=False)
class BlockFolds:
    """Which block and which fold each row belongs to, and how far training keeps away."""

    block: NDArray[np.intp]  # (n,)
    fold: NDArray[np.intp]  # (n,) NEVER where a row is never held out
    guard_s: float

    def training(self, t_s: Array, fold: int) -> NDArray[np.bool_]:
        """Rows that a fit may see when `fold` is held out: none within the guard of a held-out row."""
        held = self.fold == fold
        times = t_s[held]
        place = np.searchsorted(times, t_s)
        before = np.abs(t_s - times[np.maximum(place - 1, 0)])
        after = np.abs(times[np.minimum(place, len(times) - 1)] - t_s)
        return np.asarray(~held & (np.minimum(before, after) > self.guard_s))

    def restricted_to(self, rows: NDArray[np.bool_]) -> BlockFolds:
        """The same blocks where no other rows than these are ever held out."""
        return BlockFolds(self.block, np.where(rows, self.fold, NEVER), self.guard_s)


def block_folds(
    problem: LinearProblem, correlation_s: float, block_s: float | None = None, seed: int = 0
) -> BlockFolds:
    """Blocks of `block_s` (a fortieth of the recorded time, not less than five correlation times) in random folds.

    A segment is at least two blocks, and more where segments are few: without the blocks of one fold there are others
    to hold out of the rest. The guard is at most a third of the shortest, so that training keeps its rows.
    """
    t, segment = problem.scene.t_s, problem.scene.segment
    parts = stretches(segment)
    recorded = sum(float(t[p][-1] - t[p][0]) for p in parts)
    length = block_s or max(
        recorded / BLOCKS, CORRELATION_TIMES * correlation_s, BLOCK_ROWS * float(np.median(np.diff(t)))
    )
    block, count, shortest, fewest = np.empty(len(t), dtype=np.intp), 0, length, max(2, -(-FOLDS // len(parts)))
    fold_of: list[int] = []
    draw = np.random.default_rng(seed)
    for part in parts:
        span = float(t[part][-1] - t[part][0])
        rows = t[part].size
        pieces = max(round(span / length), min(fewest, 2 * rows // TWO_BLOCKS) if rows >= TWO_BLOCKS else 1)
        inside = np.minimum((t[part] - t[part][0]) / max(span, 1e-9) * pieces, pieces - 1e-9).astype(int)
        block[part] = count + inside
        count, shortest = count + pieces, min(shortest, span / pieces)
        while len(fold_of) < count:
            fold_of += draw.permutation(FOLDS).tolist()
    folds = np.array(fold_of)[:count][block]
    return BlockFolds(block, folds, min(correlation_s, shortest / 3))


@dataclass(frozen=True, slots=True, eq=False)
class HeldOutErrors:
    """Held-out residual lengths of each row [nT], with the base alone and with the effects.

    All is judged by what is left beside the errors that the run declares, as likely as the other rows make them.
    """

    block: NDArray[np.intp]
    before_nT: Array  # (n,)
    after_nT: Array  # (n,)
    rows: NDArray[np.bool_]  # (N,) which of the whole problem's they are
    plain_nT: tuple[Array, Array] | None = None  # the same with declared errors in; None where none is declared

    @property
    def before(self) -> float:
        """Rms before [nT]."""
        return rms(self.before_nT)

    @property
    def after(self) -> float:
        """Rms after [nT]."""
        return rms(self.after_nT)

    @property
    def plain(self) -> tuple[float, float]:
        """Rms before and after [nT] with what declared errors leave."""
        before, after = self.plain_nT or (self.before_nT, self.after_nT)
        return rms(before), rms(after)

    def on(self, rows: NDArray[np.bool_]) -> HeldOutErrors:
        """The same on fewer rows (N,)."""
        kept = rows[self.rows]
        plain = self.plain_nT and (self.plain_nT[0][kept], self.plain_nT[1][kept])
        return HeldOutErrors(self.block[kept], self.before_nT[kept], self.after_nT[kept], self.rows & rows, plain)

    def against(self, base: HeldOutErrors) -> HeldOutErrors:
        """The same with what another base leaves before; zero on rows that it never held out."""

        def before(lengths: Array) -> Array:
            out = np.zeros(len(self.rows))
            out[base.rows] = lengths
            return out[self.rows]

        plain = self.plain_nT and base.plain_nT and (before(base.plain_nT[0]), self.plain_nT[1])
        return replace(self, before_nT=before(base.before_nT), plain_nT=plain or None)

    def improvement(self) -> tuple[float, float]:
        """95 % interval of the fall of the rms [nT], over draws of whole blocks."""
        blocks = np.unique(self.block)
        place = np.searchsorted(blocks, self.block)
        count = np.bincount(place)
        sums = np.stack([np.bincount(place, v**2) for v in (self.before_nT, self.after_nT)])
        drawn = np.random.default_rng(1).integers(len(blocks), size=(DRAWS, len(blocks)))
        means = sums[:, drawn].sum(axis=2) / count[drawn].sum(axis=1)
        low, high = np.percentile(np.sqrt(means[0]) - np.sqrt(means[1]), INTERVAL_95)
        return float(low), float(high)


def rms(values: Array) -> float:
    """Root mean square over the rows."""
    return float(np.sqrt(np.mean(values**2)))


def cross_validate(
    pool: CandidateSet,
    blocks: BlockFolds,
    choose: Callable[[CandidateSet], Sequence[Candidate]],
    before: Sequence[Candidate] = (),
) -> HeldOutErrors:
    """Residuals of every row by fits that did not see its block; `choose` picks the effects on the training rows.

    Left out are the rows between the last training row before a step and the first one after it: a fit that did not see
    them cannot know on which side of the step they lie. So are those of a segment before its first training row, where
    an effect may begin anywhere in it.
    """
    problem, whole = pool.problem, pool.whole
    block, folds = (part if problem.bins is None else problem.bins.spread(part) for part in (blocks.block, blocks.fold))
    out, known = np.full((2, 2, len(whole)), np.nan), list[tuple[Candidate, Array]]()
    numbers = np.unique(blocks.fold[blocks.fold != NEVER]).tolist()
    parts = [pool.on(blocks.training(problem.scene.t_s, fold) & pool.rows) for fold in numbers]
    for fold, part, chosen in zip(numbers, parts, parallel_map(choose, parts), strict=True):
        seen_s = problem.scene.t_s[part.rows]
        test = (folds == fold) & pool.valid & ~_beside_changepoint(whole.scene.t_s, seen_s, [*before, *chosen])
        if any(part_of.term.of_beginnings for c in (*before, *chosen) for part_of in c.parts):
            test &= ~_not_begun(problem.scene, part.rows, whole.scene)
        known = [(c, _columns_of(c, known, pool)) for c in (*before, *chosen)]
        for which, effects in enumerate((before, chosen)):
            A = np.concatenate([whole.T[test], *(_columns_of(c, known, pool)[test] for c in effects)], axis=2)
            left = whole.y[test] - A @ part.coefficients(effects)
            beside = left - whole.declared[test] @ part.declared_errors(effects)
            out[:, which, test] = [residual_lengths(whole, lengths, test) for lengths in (beside, left)]
    seen = np.isfinite(out).all(axis=(0, 1))
    judged, plain = out[:, :, seen]
    stated = (plain[0], plain[1]) if whole.declared.shape[2] else None
    return HeldOutErrors(block[seen], judged[0], judged[1], seen, stated)


def fixed_choice(accepted: Sequence[Candidate]) -> Callable[[CandidateSet], Sequence[Candidate]]:
    """The same effects whatever the training rows."""
    return lambda part: accepted


def own_proof(
    pool: CandidateSet, blocks: BlockFolds, others: Sequence[Candidate], members: Sequence[Candidate], one: Candidate
) -> HeldOutErrors:
    """Held-out errors without and with `one` of the members, all the rest in."""
    rest = [*others, *(m for m in members if m is not one)]
    return cross_validate(pool, blocks, fixed_choice([*rest, one]), rest)


def _beside_changepoint(t_s: Array, known_s: Array, effects: Sequence[Candidate]) -> NDArray[np.bool_]:
    """Rows (n,) between the two known times that a step of one of these effects lies between."""
    out = np.zeros(len(t_s), dtype=bool)
    for moment in filter(None, (c.term.found_by("changepoints") for c in effects)):
        after = int(np.searchsorted(known_s, moment.value))
        low, high = np.concatenate([[-np.inf], known_s, [np.inf]])[after : after + 2]
        out |= (t_s > low) & (t_s < high)
    return out


def _not_begun(scene: Scene, training: NDArray[np.bool_], whole: Scene) -> NDArray[np.bool_]:
    """Rows (N,) of the whole that lie before the first training row of their segment."""
    begun = np.full(int(whole.segment.max()) + 1, np.inf)
    np.minimum.at(begun, scene.segment[training], scene.t_s[training])
    return np.asarray(whole.t_s < begun[whole.segment])


def _columns_of(candidate: Candidate, known: Sequence[tuple[Candidate, Array]], pool: CandidateSet) -> Array:
    """Its columns on every row, from what is known where they are there."""
    for other, columns in known:
        if other is candidate:
            return columns
    return pool.full_columns(candidate)


def residual_lengths(problem: LinearProblem, whitened: Array, rows: NDArray[np.bool_]) -> Array:
    """Length [nT] of whitened residuals (m, q) of some rows: of the vector, or of the magnitude."""
    W = problem.whiten[rows]
    if problem.kind == "vector":
        return np.asarray(np.linalg.norm(np.linalg.solve(W, whitened[:, :, None])[:, :, 0], axis=1))
    return np.asarray(np.abs(whitened[:, 0]) / np.linalg.norm(W[:, 0], axis=1))
