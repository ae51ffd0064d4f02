"""Spectral lines of the residual: a periodic effect is tried at the highest peaks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.candidates.library import Candidate, is_observable
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.noise.periodogram import periodogram, running_median
from labcal.model.effects import Family, Shape, Term, families
from labcal.model.effects.regressors import stretches
from labcal.record import Run

Array = NDArray[np.float64]
BELOW_NYQUIST = 0.98  # of the highest frequency: beyond, a line and its alias are one
PEAKS = 3  # frequencies that a periodic effect is tried at


def spectral_lines(problem: LinearProblem, residual: Array) -> list[Candidate]:
    """What shows as a line, at the highest peaks against their neighbourhood, for a residual (n, q).

    What is transformed is the score of an offset along each body axis: a magnitude alone would show the line split by
    the turning of the field.
    """
    able = [family for family in families() if family.found_by("spectral lines") and is_observable(problem, family)]
    terms = [(family, *term) for family in able for term in _with_a_line(family, problem.run)]
    if not terms:
        return []
    offsets = np.einsum("nqj,nq->nj", problem.whiten, residual)
    frequency, power = periodogram(problem.scene.t_s, offsets)
    contrast = np.where(_admissible(problem, frequency), power / running_median(power), 0.0)
    found: list[Candidate] = []
    for _ in range(PEAKS):
        peak = int(np.argmax(contrast))
        if contrast[peak] <= 0:
            break
        for family, term, line in terms:
            at = replace(line, value=float(frequency[peak]), grid=(0.0,))
            found.append(Candidate(family, term.with_shape(at), len(frequency)))
        contrast[max(peak - 8, 0) : peak + 9] = 0.0
    return found


def _with_a_line(family: Family, run: Run) -> list[tuple[Term, Shape]]:
    """The terms that have a frequency, and the frequency."""
    found = [(term, term.found_by("spectral lines")) for term in family.candidates(run)]
    return [(term, line) for term, line in found if line is not None]


def _admissible(problem: LinearProblem, frequency: Array) -> NDArray[np.bool_]:
    """Which frequencies [Hz] are neither a drift's nor those of a motion that repeats in each segment."""
    times = [problem.scene.t_s[part] for part in stretches(problem.scene.segment)]
    law = policy.POLICY
    few = frequency < law.min_cycles / max(float(np.median([np.ptp(t) for t in times])), 1e-9)
    in_step = np.abs(np.mean([np.exp(2j * np.pi * frequency[few] * t[0]) for t in times], axis=0)) > law.phase_locked
    own = (frequency > law.min_cycles / max(times[-1][-1] - times[0][0], 1e-9)) & (
        frequency < BELOW_NYQUIST * frequency[-1]
    )
    own[few] &= ~in_step
    return np.asarray(own)
