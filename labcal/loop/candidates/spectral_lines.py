"""Spectral lines of the residual: a periodic effect is tried at the highest peaks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.folded_lines import unfolded_line
from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.periodogram import periodogram, running_median
from labcal.model.effects import Family, Shape, Term, families
from labcal.model.effects.regressors import stretches

Array = NDArray[np.float64]
PEAKS = 3  # frequencies that a periodic effect is tried at
BETWEEN = 8  # places between two frequencies of a spectrum at which the top of a peak is looked for
SKIRT = 8  # frequencies on either side of a peak that belong to it


def spectral_lines(problem: LinearProblem, residual: Array) -> list[Candidate]:
    """What shows as a line, at the highest peaks against their neighbourhood, for a residual (n, q).

    What is transformed is the score of an offset along each axis of the frame that the form is fixed to: in any other
    the turning of the device would split the line.
    """
    able = [family for family in families() if family.found_by("spectral lines") and is_observable(problem, family)]
    terms = [(family, *term) for family in able for term in _with_a_line(family, problem)]
    found: list[Candidate] = []
    for owner in sorted({family.owner(term) for family, term, _ in terms}):
        scores = offset_scores(problem, residual, in_cage=owner == "rig")
        places = _frequencies(problem, scores)
        for family, term, line in (one for one in terms if one[0].owner(one[1]) == owner):
            found += [Candidate(family, term.with_shape(replace(line, value=f, grid=(0.0,))), n) for f, n in places]
    return found


def _frequencies(problem: LinearProblem, scores: Array) -> list[tuple[float, int]]:
    """Where lines are tried [Hz], and of how many frequencies each was chosen."""
    frequency, power = periodogram(problem.scene.t_s, scores)
    peaks = _peaks(np.where(admissible(problem, frequency), power / running_median(power), 0.0))
    found = [(_top(problem.scene.t_s, scores, frequency, peak), len(frequency)) for peak in peaks]
    parts, t_s = stretches(problem.scene.segment), problem.scene.t_s
    above = unfolded_line(t_s, scores, parts) if problem.bins is None else None
    return found if above is None else [*found, above]


def _top(t_s: Array, scores: Array, frequency: Array, peak: int) -> float:
    """The frequency [Hz] about a peak at which the power is largest: the spectrum's own may be a third below it."""
    near = frequency[peak] + (frequency[1] - frequency[0]) * np.linspace(-1.0, 1.0, 2 * BETWEEN + 1)
    power = np.sum(np.abs(np.exp(-2j * np.pi * np.outer(near, t_s)) @ scores) ** 2, axis=1)
    return float(near[int(np.argmax(power))])


def offset_scores(problem: LinearProblem, residual: Array, *, in_cage: bool) -> Array:
    """How a residual (n, q) would change with an offset along each axis of the body, or of the cage (n, 3)."""
    scores = np.einsum("nqj,nq->nj", problem.whiten, residual)
    rig = problem.scene.rig
    return scores if rig is None or not in_cage else np.asarray(np.einsum("nji,nj->ni", rig.to_body, scores))


def _peaks(contrast: Array) -> list[int]:
    """Where a spectrum stands highest above its neighbourhood, highest first."""
    contrast, found = contrast.copy(), list[int]()
    while len(found) < PEAKS and contrast[peak := int(np.argmax(contrast))] > 0:
        found.append(peak)
        contrast[max(peak - SKIRT, 0) : peak + SKIRT + 1] = 0.0
    return found


def _with_a_line(family: Family, problem: LinearProblem) -> list[tuple[Term, Shape]]:
    """The terms that have a frequency, and the frequency; those of the rig where the problem knows it."""
    found = [(term, term.found_by("spectral lines")) for term in family.candidates(problem.run)]
    known = problem.scene.rig is not None
    return [(term, line) for term, line in found if line is not None and (known or family.owner(term) != "rig")]


def admissible(problem: LinearProblem, frequency: Array) -> NDArray[np.bool_]:
    """Which frequencies [Hz] are neither a drift's nor those of a motion that repeats in each segment.

    Nor, as near to the Nyquist frequency as a drift's is to zero, those of which sine and cosine are one.
    """
    times = [problem.scene.t_s[part] for part in stretches(problem.scene.segment)]
    law = policy.POLICY
    few = frequency < law.min_cycles / max(float(np.median([np.ptp(t) for t in times])), 1e-9)
    in_step = np.abs(np.mean([np.exp(2j * np.pi * frequency[few] * t[0]) for t in times], axis=0)) > law.phase_locked
    slowest = law.min_cycles / max(times[-1][-1] - times[0][0], 1e-9)
    own = (frequency > slowest) & (frequency < frequency[-1] - slowest)
    own[few] &= ~in_step
    return np.asarray(own)
