"""How uncertain a procedure's figure is: all that is declared of the reference, through the figure itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from labcal.record import Run
from labcal.uncertainty.budget import PROBABILITY, coverage_factor
from labcal.uncertainty.declared import DeclaredError, declared_errors
from labcal.uncertainty.unstated import ALL_COVERED, not_covered

Array = NDArray[np.float64]
Figure = Callable[[Run], float]
Errors = Callable[[Run], Array]  # (n,)
Size = Callable[[Array], Array]  # (…, n) to (…)
TAIL = (1 - PROBABILITY) / 2
NUMBERS, DRAWS = 250_000, (2_000, 10_000)  # drawn in all, and of each error
HALVINGS, EXACT = 12, 1e-6


def u_declared(run: Run, figure: Figure) -> float:
    """Standard uncertainty of `figure` by all that `run` declares, each independent of the others (GUM, 5.1.2)."""
    return float(np.linalg.norm([u_by(run, error, figure) for error in declared_errors(run)] or [0.0]))


def u_by(run: Run, error: DeclaredError, figure: Figure) -> float:
    """What one declared error does: root mean square of the changes by one standard deviation either way.

    It is |c u| of a smooth figure (GUM, 5.1.3, note 2). A root mean square that begins at zero has no slope there: then
    it is how large the error alone makes it.
    """
    here, one, other = figure(run), figure(error.change(run)), figure(error.change(run, -1.0))
    return float(np.hypot(one - here, other - here) / np.sqrt(2))


def half_expanded(*known: tuple[float, float]) -> float:
    """Half the U of 95.45 % of independent standard uncertainties, each with its degrees of freedom (GUM, G.4.2)."""
    u = float(np.linalg.norm([u for u, _ in known]))
    inverse = sum((part / u) ** 4 / dof for part, dof in known) if u else 0.0
    return u * coverage_factor(1 / inverse if inverse else np.inf) / 2


def u_of_size(run: Run, errors: Errors, size: Size, u_noise: ArrayLike, dof: float = np.inf) -> float:
    """Standard uncertainty, half the U of 95.45 %, of how large the true errors are by `size`: their rms, the largest.

    `errors` (n,) are those that a run shows, `u_noise` (n,) or a number is their own noise, known with `dof` degrees of
    freedom. They are the true ones and
    a draw of all that is declared and of noise: the draw raises their size more than it lowers it, and by how much it
    did scatters as few independent errors do, so that no slope of the figure is its uncertainty. By drawn distributions
    (JCGM 101): not above what the seen errors less a draw come to in all but 2.3 % of the draws, nor below errors of
    the same shape that with a draw would look as large in 2.3 %.
    """
    seen = errors(run)
    here, drawn = float(size(seen)), _drawn(run, errors, np.broadcast_to(u_noise, seen.shape), dof)
    most = float(np.quantile(size(seen - drawn), 1 - TAIL))

    def as_large(part: float) -> float:
        return float(np.mean(size(part * seen + drawn) >= here))

    if as_large(0.0) >= TAIL:
        return max(most - here, here) / 2
    near = max(0.0, 1 - 4 * max(most / here - 1, EXACT))
    least, above = (near if as_large(near) < TAIL else 0.0), 1.0
    for _ in range(HALVINGS):
        middle = (least + above) / 2
        least, above = (middle, above) if as_large(middle) < TAIL else (least, middle)
    return max(most - here, here * (1 - least)) / 2


def _drawn(run: Run, errors: Errors, u_noise: Array, dof: float) -> Array:
    """Draws (draws, n) of what declared errors and noise make of the errors that a run shows.

    Noise whose size was estimated is distributed as Student's t, of one size in all of a draw (JCGM 101, 6.4.9).
    """
    n = len(u_noise)
    count = int(np.clip(NUMBERS // n, *DRAWS))
    random = np.random.default_rng(count)  # the same figure twice has the same uncertainty
    moved = np.array([error.moves(run, errors) for error in declared_errors(run)]).reshape(-1, n)
    noise = random.normal(size=(count, n)) * u_noise
    if np.isfinite(dof):
        noise *= np.sqrt(dof / random.chisquare(dof, size=(count, 1)))
    return np.asarray(random.normal(size=(count, len(moved))) @ moved + noise)


def rms(values: Array) -> Array:
    """Root mean square along the last axis."""
    return np.asarray(np.sqrt(np.mean(values**2, axis=-1)))


def largest(values: Array) -> Array:
    """The largest size along the last axis."""
    return np.asarray(np.abs(values).max(axis=-1))


def in_body(run: Run) -> Array:
    """The reference (n, 3) [nT] carried into B by each segment's attitude."""
    assert run.reference_vector is not None
    attitudes = np.array([segment.body_from_cage for segment in run.segments])[run.segment_index]
    return np.asarray(np.einsum("nij,nj->ni", attitudes, run.reference_vector))


def uncovered(run: Run, more: Iterable[str] = ()) -> str:
    """One sentence that names what no uncertainty of a procedure's figures covers; empty where that is nothing."""
    left = [said for said in not_covered(run) if said != ALL_COVERED]
    left += [f"{said[:1].upper()}{said[1:]}." for said in more]
    return f"Not covered by the uncertainties: {' '.join(left)}" if left else ""
