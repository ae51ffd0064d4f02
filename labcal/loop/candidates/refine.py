"""Nonlinear parameters of a candidate at their best, by variable projection from its grid point."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.candidates.scorer import Search
from labcal.loop.noise.bands import transformed
from labcal.loop.noise.whitening import Whitened
from labcal.model.effects import Form

Array = NDArray[np.float64]
SECANT = "secant_s"  # the shape of a lag
SECANTS = 6  # rounds of a lag's own
ROUGHLY, EXACTLY = 1e-2, 3e-3  # of a bracket: where several shapes are searched in turn, and in the end


def _names(form: Form) -> set[str]:
    return {shape.name for shape in form.shape}


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
