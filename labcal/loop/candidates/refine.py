"""Nonlinear parameters of a candidate at their best, by variable projection near the grid point that was found."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.angle_zeros import at_best_zeros
from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.noise.whitening import WhitenedNull
from labcal.model.effects import Term

Array = NDArray[np.float64]
Bracket = tuple[float, float]
SECANT_ROUNDS = 6
TURNS = 3  # of line searches in every parameter, where there are several
FURTHER = 4.0  # times as far as all together went
BRACKETINGS = 18  # of one line search, at most
ROUGHLY, EXACTLY = 1e-2, 3e-3  # of a bracket: where several parameters are searched in turn, and in the end


def refined(pool: CandidateSet, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    """The candidate at its best nonlinear parameters beside the accepted ones, by line searches in turn."""
    return pool.cached("refined", (candidate, *accepted), lambda: _refined(pool, candidate, accepted))


def has_own_secant(candidate: Candidate) -> bool:
    """Whether its columns are a secant over the very lag that is fitted."""
    return candidate.term.found_by("own secant") is not None


def _refined(pool: CandidateSet, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    if has_own_secant(candidate):
        return _on_own_secant(pool, candidate, accepted)
    if candidate.term.found_by("angle zeros"):
        return at_best_zeros(pool, candidate, accepted)
    searched = [shape.name for shape in candidate.term.shape if shape.grid]
    around = _brackets(pool, candidate)
    for _ in range(TURNS if len(searched) > 1 else 0):
        last, gain = candidate, _fixed_noise_gain(pool, candidate, accepted)
        for name in searched:
            candidate = _line_search(pool, candidate, name, around[name], gain, ROUGHLY)
        if candidate is last:
            break
        candidate = _further(pool, last, candidate, around, gain)
    null_model = pool.null_model(accepted)
    for name in searched:
        bracket = _brackets(pool, candidate)[name]
        candidate = _line_search(pool, candidate, name, bracket, lambda X: null_model.with_columns(X)[0].log, EXACTLY)
    return candidate


def _brackets(pool: CandidateSet, candidate: Candidate) -> dict[str, Bracket]:
    """Between which values each parameter of a candidate is searched."""
    return {s.name: s.bracket(pool.problem.scene.t_s) for s in candidate.term.shape if s.grid}


def _fixed_noise_gain(
    pool: CandidateSet, candidate: Candidate, accepted: Sequence[Candidate]
) -> Callable[[Array], float]:
    """What transformed columns gain under the noise that goes with the candidate: cheaper than under every one."""
    null_model = pool.null_model(accepted)
    spectrum = null_model.with_columns(pool.transformed_columns(candidate))[0].spectrum
    return pool.cached(("whitened", spectrum), (null_model,), lambda: WhitenedNull.of(null_model, spectrum)).gain


def _on_own_secant(pool: CandidateSet, candidate: Candidate, accepted: Sequence[Candidate]) -> Candidate:
    """A lag's columns are a secant: taken over the lag that they give, until that changes no less, or no longer."""
    before: Array | float = np.inf
    for _ in range(SECANT_ROUNDS):
        last = candidate.term
        found = pool.coefficients([*accepted, candidate])[-len(last.parameters) :]
        secants = np.array([shape.value for shape in last.own_secants()])
        lags = found[: len(secants)]
        change = np.abs(lags - secants)
        if bool((change >= before).all() or (change < 1e-3 * np.abs(lags) + 1e-6).all()):
            break
        before = change
        candidate = replace(candidate, term=last.over_own_secants(found))
        if candidate.term is last:
            break
    return candidate


def _line_search(
    pool: CandidateSet,
    candidate: Candidate,
    name: str,
    bracket: Bracket,
    gain: Callable[[Array], float],
    within: float,
) -> Candidate:
    def there(value: float) -> Term:
        return candidate.term.with_values(**{name: value})

    return _best_along(pool, candidate, there, bracket, gain, within)


def _further(
    pool: CandidateSet,
    last: Candidate,
    candidate: Candidate,
    around: dict[str, Bracket],
    gain: Callable[[Array], float],
) -> Candidate:
    """The best on the line from `last` on, in all parameters at once: they may depend on each other (Powell 1964)."""
    went = {name: (last.term.at(name), candidate.term.at(name) - last.term.at(name)) for name in around}

    def there(part: float) -> Term:
        return candidate.term.with_values(**{name: start + part * step for name, (start, step) in went.items()})

    ends = ((around[name][step > 0] - start) / step for name, (start, step) in went.items() if step)
    most = min([FURTHER, *ends])
    return _best_along(pool, candidate, there, (1.0, most), gain, ROUGHLY) if most > 1.0 else candidate


def _best_along(
    pool: CandidateSet,
    candidate: Candidate,
    there: Callable[[float], Term],
    bounds: Bracket,
    gain: Callable[[Array], float],
    within: float,
) -> Candidate:
    from scipy.optimize import minimize_scalar

    def cost(term: Term) -> float:
        return -gain(pool.transformed(pool.problem.columns(term)))

    low, high = bounds
    found = minimize_scalar(
        lambda value: cost(there(value)),
        bounds=bounds,
        method="bounded",
        options={"maxiter": BRACKETINGS, "xatol": within * (high - low)},
    )
    return replace(candidate, term=there(float(found.x))) if found.fun < cost(candidate.term) else candidate
