"""Forward choice with re-examination: an effect comes in, and those already in have to earn their place again.

A second cause has to explain what a more flexible version of the first one cannot: beside every accepted effect stand
all other looks of its family on the same channels. So the remainder of a shape that is not quite ours is not given
another name.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from labcal.loop.cores import each
from labcal.loop.delays import delays
from labcal.loop.lines import periodic
from labcal.loop.pairs import pairs
from labcal.loop.search import NAMED, Candidate, Search, Weighed
from labcal.loop.spectrum import transformed
from labcal.loop.steps import steps
from labcal.loop.whitened import Whitened
from labcal.model.effects import Form
from labcal.model.effects.following import time_constants

Array = NDArray[np.float64]
Cause = tuple[str, tuple[str, ...]]
MOST = 3  # effects accepted at most
MATERIAL = 0.03  # of the noise's square: a smaller drop of the mean square is not worth a parameter
SHARE = 0.01  # of all that was explained: a smaller part is a detail of the first effect's shape
SHARE_OF_REST = 0.08  # of what still lies above the noise, beside all looks of the first: this is more than a detail
SECANT = "secant_s"  # the shape of a lag
SECANTS = 6  # rounds of a lag's own
DIRECTIONS = 3  # in which columns are compared
COMPANION = 0.7  # of the drop of the heaviest
ROUGHLY, EXACTLY = 1e-2, 3e-3  # of a bracket: where several shapes are searched in turn, and in the end
ALL_BUT_WHITE = 1.5  # times the white level: no frequency of the noise left has more
OWN_PART = 0.03  # of the drop of a cause that extends another: what is its own has to bring as much,
OWN_PART_OF_NOISE = 0.25  # or this part of the noise's square


def forward(
    search: Search, most: int = MOST, refused: Collection[Cause] = ()
) -> tuple[list[Candidate], list[list[Weighed]]]:
    """The causes accepted, in order, and the ranking at each step; those `refused` are not taken."""
    accepted: list[Candidate] = []
    rankings: list[list[Weighed]] = []
    total, out_of_play, left = 0.0, set(refused), set[Cause]()
    while len(accepted) < most:
        open_to = [c for c in looks(search, accepted) if not _same(c, accepted)]
        ranking = search.rank(open_to, accepted)
        if accepted and _nothing_left(search, accepted, ranking):
            rankings.append(ranking)
            break
        if accepted:
            ranking = search.rank(open_to, accepted, neighbourhood(search, accepted))
        rankings.append(ranking)
        best = _best(search, accepted, [w for w in ranking if w.candidate.cause not in out_of_play], total)
        if best is None:
            both = _pair(search, accepted, ranking, out_of_play, total) if len(accepted) + 2 <= most else []
            accepted = [*accepted, *both]
            if not both:
                break
            continue
        chosen = refined(search, best.candidate, accepted)
        kept = reexamined(search, [*accepted, chosen])
        if chosen in kept:
            gone = {c.cause for c in accepted if c not in kept}
            out_of_play |= gone & left  # what leaves for the second time would come and go for ever
            accepted, total, left = kept, total + best.drop, left | gone
        else:
            out_of_play.add(best.candidate.cause)
    return accepted, rankings


def _nothing_left(search: Search, accepted: Sequence[Candidate], ranking: Sequence[Weighed]) -> bool:
    """Whether the accepted effects leave noise that is all but white, and nothing in it weighs half of a name."""
    stage = search.stage(accepted)
    return bool(stage.bands.spectra[stage.null.tried].max() < ALL_BUT_WHITE) and ranking[0].weight < NAMED / 2


def _pair(
    search: Search,
    accepted: Sequence[Candidate],
    ranking: Sequence[Weighed],
    refused: Collection[Cause],
    total: float,
) -> list[Candidate]:
    """Two causes that are material together, each earning its place beside the other; none where no two do."""
    stage = search.stage(accepted, neighbourhood(search, accepted))
    open_to = [w for w in ranking if not _same(w.candidate, accepted)]
    for pair in pairs(search, stage, open_to, {*refused, *(c.cause for c in accepted)}):
        if pair.weight < NAMED or pair.drop < _material(search, accepted, total):
            continue
        one = refined(search, pair.one, [*accepted, pair.other])
        both = [one, refined(search, pair.other, [*accepted, one])]
        if reexamined(search, [*accepted, *both])[-2:] == both:
            return both
    return []


def _material(search: Search, accepted: Sequence[Candidate], total: float) -> float:
    """The least drop of the mean square that is worth a name beside what is accepted."""
    null = search.stage(accepted, neighbourhood(search, accepted)).null
    rest = (null.rss / search.data - 1.0) / search.rows_each
    return max(MATERIAL * null.level**2, min(SHARE * total, SHARE_OF_REST * rest))


def _best(search: Search, accepted: Sequence[Candidate], ranking: list[Weighed], total: float) -> Weighed | None:
    """The heaviest that is material; a companion on a channel already at work goes before a little better stranger."""
    least = _material(search, accepted, total)
    fit = [w for w in ranking if w.drop >= least and w.weight >= NAMED]
    used = {name for c in accepted for name in c.form.channels}
    companions = [w for w in fit if used & set(w.candidate.form.channels) and w.drop >= COMPANION * fit[0].drop]
    return next((w for w in [*companions, *fit] if earned(search, accepted, w)), None)


def earned(search: Search, accepted: Sequence[Candidate], found: Weighed) -> bool:
    """Whether what a cause adds to those that it extends weighs as much as a cause of its own would have to.

    A reference that drifts is a constant field where the drift is nought, a loop a curve where it has no width: the
    larger model always does a little better, and that little may be misfit of the smaller one's form.
    """
    smaller = _spanned(search, found.candidate, found.candidate.family.extends)
    if not smaller:
        return True
    own = search.weigh(found.candidate, search.stage(accepted, smaller))
    return own.weight >= NAMED and own.drop >= min(OWN_PART * found.drop, OWN_PART_OF_NOISE * search.lowest**2)


def looks(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    """All candidates, a lag on its own secant; periods, steps and delays where the present residual shows them."""
    return search.once("looks", [c.form for c in accepted], lambda: _looks(search, accepted))


def _looks(search: Search, accepted: Sequence[Candidate]) -> list[Candidate]:
    left = search.residual(accepted) * search.rows[:, None]
    known = [refined(search, c, accepted) if SECANT in _names(c.form) else c for c in search.candidates]
    sought = [partial(periodic, search.problem, left), *(partial(look, search, accepted) for look in (steps, delays))]
    return [*known, *itertools.chain(*each(lambda seek: seek(), sought))]


def _same(candidate: Candidate, accepted: Sequence[Candidate]) -> bool:
    """The same cause twice; steps and periods may come twice, at another time or frequency."""
    return candidate.family.sought == "grid" and any(covers(c, candidate) for c in accepted)


def covers(one: Candidate, other: Candidate) -> bool:
    """Whether `other` is the same cause as `one`, or its current or square: a detail of the same load."""
    return other.form.channels == one.form.channels and other.family.id in (one.family.id, *one.family.akin)


def neighbourhood(search: Search, accepted: Sequence[Candidate]) -> list[Array]:
    """All other looks of the accepted causes, as a few transformed columns that span them."""
    parts = []
    for chosen in accepted:
        parts += _spanned(search, chosen, (chosen.family.id, *chosen.family.extends, *chosen.family.akin))
        parts += _starts(search, chosen)
    return parts


def _starts(search: Search, chosen: Candidate) -> list[Array]:
    """What the unknown state that a slow response starts from leaves: it dies out with the response's own tau_s."""
    settling = next((c.form for c in search.candidates if c.family.bound_to_run and "tau_s" in _names(c.form)), None)
    if settling is None:
        return []

    def made(tau_s: float) -> Array:
        return transformed(search.problem.columns(settling.reshaped(tau_s=tau_s))[search.moving])

    taus = [tau_s for tau_s in time_constants(chosen.form) if tau_s > 0]
    return [search.once(("starts", tau_s), (settling,), partial(made, tau_s)) for tau_s in taus]


def _names(form: Form) -> set[str]:
    return {shape.name for shape in form.shape}


def _spanned(search: Search, chosen: Candidate, ids: Collection[str]) -> list[Array]:
    """All looks of these families on the channels of `chosen`, spanned; nothing where there is none."""
    kin = [c for c in search.candidates if c.family.id in ids and c.form.channels == chosen.form.channels]

    forms = [c.form for c in kin]

    def made() -> Array:
        distinct = search.once("distinct", forms, lambda: _distinct(search, kin), everywhere=True)
        parts = [search.moved(c)[:, :, places] for c, places, _ in distinct]
        return spanning(np.concatenate(parts, axis=2), np.concatenate([times for _, _, times in distinct]))

    return [search.once("spanned", forms, made)] if kin else []


def _distinct(search: Search, kin: Sequence[Candidate]) -> list[tuple[Candidate, NDArray[np.intp], Array]]:
    """Where columns that the looks have in common stand first, and how often each comes: a curve's are in every loop's.

    Columns are the same where they are, at unit length, in a few directions drawn at random.
    """
    some = np.concatenate([search.columns(c) for c in kin], axis=2)
    some = some.reshape(-1, some.shape[2])
    drawn = np.random.default_rng(0).normal(size=(DIRECTIONS, len(some))) @ some
    some = np.round(drawn / np.maximum(np.sqrt(np.einsum("nc,nc->c", some, some)), 1e-300), 9)
    _, first, times = np.unique(some, axis=1, return_index=True, return_counts=True)
    order, ends = np.argsort(first), np.cumsum([0, *(len(c.form.parameters) for c in kin)])
    first, times = first[order], times[order].astype(float)
    inside = [(first >= a) & (first < b) for a, b in itertools.pairwise(ends)]
    found = zip(kin, ends[:-1].tolist(), inside, strict=True)
    return [(c, first[here] - start, times[here]) for c, start, here in found if here.any()]


def spanning(columns: Array, times: Array | float = 1.0, least: float = 1e-4) -> Array:
    """A few columns (n, q, few) that span the given ones, each there so many `times`, to a part `least` of norms."""
    n, q, p = columns.shape
    flat = columns.reshape(n * q, p)
    gram = flat.T @ flat
    size = np.maximum(np.sqrt(np.diag(gram)), 1e-150) / np.sqrt(times)
    values, vectors = np.linalg.eigh(gram / np.outer(size, size))
    kept = values > least**2 * values[-1]
    few = flat @ (vectors[:, kept] / size[:, None] / np.sqrt(values[kept]))
    return np.asarray(few.reshape(n, q, -1))


def reexamined(search: Search, accepted: list[Candidate]) -> list[Candidate]:
    """Those that still earn their place beside the others."""

    def weight(chosen: Candidate) -> float:
        others = [c for c in accepted if c is not chosen]
        return search.weigh(chosen, search.stage(others, neighbourhood(search, others))).weight

    while len(accepted) > 1:
        weights = each(weight, accepted)
        weakest = int(np.argmin(weights))
        if weights[weakest] >= NAMED:
            break
        accepted = [c for i, c in enumerate(accepted) if i != weakest]
    return accepted


def refined(search: Search, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    """The candidate at its best shape near the grid point that was found, by golden section in each shape in turn."""
    about = [c.form for c in (candidate, *accepted)]
    return search.once("refined", about, lambda: _refined(search, candidate, accepted))


def _refined(search: Search, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    if SECANT in _names(candidate.form):
        return _on_secant(search, candidate, accepted)
    searched = [shape.name for shape in candidate.form.shape if shape.grid]
    for name in searched if len(searched) > 1 else ():
        candidate = _along(search, candidate, name, _under_its_noise(search, candidate, accepted), ROUGHLY)
    for name in searched:
        candidate = _along(search, candidate, name, lambda X: search.stage(accepted).beside(X)[0].log, EXACTLY)
    return candidate


def _under_its_noise(search: Search, candidate: Candidate, accepted: Sequence[Candidate]) -> Callable[[Array], float]:
    """What transformed columns gain under the noise that goes with the candidate: cheaper than under every one."""
    stage = search.stage(accepted)
    tried = stage.beside(search.moved(candidate))[0].tried
    return search.once(("whitened", tried), (stage,), lambda: Whitened.of(stage, tried)).gain


def _on_secant(search: Search, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    """A lag's columns are a secant: taken over the lag that they give, until it settles."""
    for _ in range(SECANTS):
        lag = float(search.solved([*accepted, candidate])[-1])
        settled = abs(lag - candidate.form.at(SECANT)) < 1e-3 * abs(lag) + 1e-6
        if settled or abs(lag) < 1e-6:
            break
        candidate = replace(candidate, form=candidate.form.reshaped(**{SECANT: lag}))
    return candidate


def _along(
    search: Search, candidate: Candidate, name: str, worth: Callable[[Array], float], within: float
) -> Candidate:
    from scipy.optimize import minimize_scalar

    low, high = _bracket(search, candidate, name)
    start = candidate.form.at(name)

    def badness(value: float) -> float:
        columns = search.problem.columns(candidate.form.reshaped(**{name: value}))[search.moving]
        return -worth(transformed(columns))

    found = minimize_scalar(
        badness, bounds=(low, high), method="bounded", options={"maxiter": 18, "xatol": within * (high - low)}
    )
    if found.fun < badness(start):
        return Candidate(candidate.family, candidate.form.reshaped(**{name: float(found.x)}), candidate.looks)
    return candidate


def _bracket(search: Search, candidate: Candidate, name: str) -> tuple[float, float]:
    """Between the neighbours on the grid; for a frequency half the resolution, for a delay a step of it either way.

    A loop or a bend narrower than any on the grid is not looked for: it would be driven by ripple and noise.
    """
    shape = next(s for s in candidate.form.shape if s.name == name)
    if name == "f_Hz":
        width = 0.6 / float(np.ptp(search.problem.scene.t_s))
        return shape.value - width, shape.value + width
    if name == "delay_s":
        width = min(abs(g) for g in shape.grid)
        return shape.value - width, shape.value + width
    if name.endswith("_deg"):
        width = float(np.min(np.diff(shape.grid)))
        return shape.value - width, shape.value + width
    below = [g for g in shape.grid if g < shape.value]
    above = [g for g in shape.grid if g > shape.value]
    lower, upper = (3, 1 / 3) if shape.value < 0 else (1 if name.endswith("_nT") else 1 / 3, 3)
    return (max(below) if below else shape.value * lower), (min(above) if above else shape.value * upper)
