"""The uncertainty of each effect over the whole working range, and which excitation is missing.

The run's own range of field, temperature and current is the range that its calibration claims. A correction whose
uncertainty somewhere in it exceeds the correction itself is no correction: the run did not excite it there.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.loop.candidates.library import Candidate
from labcal.loop.result import Finding
from labcal.loop.selection.joint_fit import JointFit
from labcal.model.effects import Scene, Term
from labcal.record import Run

Array = NDArray[np.float64]
AXIAL = 0.9  # of a unit vector: a component as large is called along its axis
SETTLED_S = 1e5  # after which a slow response has settled
NOTHING = 1e-9  # of what an effect does in the run: it is as small where all stands still if it follows a change alone
DIRECTIONS = np.vstack([np.eye(3), -np.eye(3), np.array(list(itertools.product((-1, 1), repeat=3))) / np.sqrt(3)])


@dataclass(frozen=True, slots=True)
class RangeUncertainty:
    """An effect over the working range [nT]: its rms, its uncertainty's, and the worst corner in words."""

    rms_nT: float
    u_rms_nT: float
    u_worst_nT: float
    worst: str

    @property
    def supported(self) -> bool:
        """Whether the correction is larger than its uncertainty."""
        return self.u_rms_nT < self.rms_nT


def range_uncertainty(run: Run, after: JointFit, place: int) -> RangeUncertainty | None:
    """Of the effect number `place`; None where it rests on no channel, or follows changes alone."""
    term = after.terms[place]
    if not term.channels or term.basis is not None:  # which ships for where it has been seen alone
        return None
    scene, names = _corners(run, after, term)
    J = term.columns(scene)[1::2]  # the second row of each corner, settled
    if np.abs(J).max() <= NOTHING * np.abs(term.columns(after.problem.scene)).max():
        return None
    start = after.problem.T.shape[2] + sum(len(b) for b in after.beta[:place])
    block = slice(start, start + len(after.beta[place]))
    C = after.covariance[block, block]
    e = J @ after.beta[place]
    variance = np.einsum("nip,pq,niq->n", J, C, J)
    worst = int(np.argmax(variance))
    size, u = (float(np.sqrt(np.mean(v))) for v in (np.sum(e**2, axis=1), np.maximum(variance, 0.0)))
    return RangeUncertainty(size, u, float(np.sqrt(max(variance[worst], 0.0))), names[worst])


def _corners(run: Run, after: JointFit, term: Term) -> tuple[Scene, list[str]]:
    """Every end of every channel of the term with fields of the largest magnitude all around, two rows a corner."""
    ends = [_ends(run, name) for name in term.channels]
    largest = float(np.nanmax(run.magnitude_nT))
    corners = list(itertools.product(itertools.product(*ends), DIRECTIONS))
    n = 2 * len(corners)
    t = np.tile([0.0, SETTLED_S], len(corners)) + np.repeat(np.arange(len(corners)), 2) * 3 * SETTLED_S
    field = np.repeat([direction * largest for _, direction in corners], 2, axis=0)
    channels = {c: np.repeat([values[i] for values, _ in corners], 2) for i, c in enumerate(term.channels)}
    scene = Scene(t, np.repeat(np.arange(n // 2), 2), field, channels, None, after.problem.scene.axes)
    return scene, [_describe_corner(term, values, direction, largest) for values, direction in corners]


def _ends(run: Run, name: str) -> tuple[float, float]:
    values = run.channel(name).values
    return float(np.nanmin(values)), float(np.nanmax(values))


def _describe_corner(term: Term, values: Sequence[float], direction: Array, largest: float) -> str:
    at = ", ".join(f"{name} = {value:.3g}" for name, value in zip(term.channels, values, strict=True))
    place = int(np.argmax(np.abs(direction)))
    along = f"along {'xyz'[place]}" if np.abs(direction).max() > AXIAL else "across the axes"
    return f"{at} in {largest / 1000:.0f} µT {along}"


def findings(run: Run, accepted: Sequence[Candidate], after: JointFit) -> list[Finding]:
    """Corrections that are uncertain in the working range, and parameters that the run does not determine."""
    found = []
    for place, (chosen, parameters) in enumerate(zip(accepted, after.parameters(), strict=True)):
        of = range_uncertainty(run, after, place) if chosen.belongs_to == "sensor" else None
        if of is not None and of.u_worst_nT > after.problem.length_nT(after.problem.residual_nT).max():
            text = f"The correction {chosen.family.id} is uncertain by {of.u_worst_nT:.0f} nT at {of.worst}"
            shipped = "" if of.supported else " It is not written into the calibration."
            said = f"{text}: the run did not go there. {_missing_excitation(chosen)}{shipped}"
            found.append(Finding("working-range", "sensor", said))
        loose = [p.name for p in parameters if p.u > 0 and abs(p.value) < 2 * p.u]
        if loose:
            verb = "are, one by one," if len(loose) > 1 else "is"
            text = (
                f"Of {chosen.family.id}, {', '.join(loose)} {verb} not pinned down by this run (value below U, k = 2)."
            )
            found.append(Finding("not-pinned-down", chosen.belongs_to, text))
    return found


def unsupported(run: Run, accepted: Sequence[Candidate], after: JointFit) -> frozenset[int]:
    """Numbers of the sensor's effects whose correction is smaller than its uncertainty over the working range."""
    reaches = [range_uncertainty(run, after, i) if c.belongs_to == "sensor" else None for i, c in enumerate(accepted)]
    return frozenset(i for i, r in enumerate(reaches) if r is not None and not r.supported)


def _missing_excitation(chosen: Candidate) -> str:
    """Which excitation is missing."""
    channels = " and ".join(chosen.term.channels)
    if chosen.family.of_field:
        return f"Missing: large fields along every axis at both ends of {channels}."
    return f"Missing: both ends of {channels} for long enough."
