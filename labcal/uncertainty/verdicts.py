"""How uncertain a procedure's figure is: all that is declared of the reference, through the figure itself."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from labcal.record import Run
from labcal.uncertainty.declared import DeclaredError, declared_errors
from labcal.uncertainty.unstated import ALL_COVERED, not_covered

Array = NDArray[np.float64]
Figure = Callable[[Run], float]


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


def u_of_rms(run: Run, figure: Figure, *, alone: float = 0.0, along: float = 0.0) -> float:
    """Standard uncertainty of `figure`, a root mean square of errors: what moves it, and what raises it.

    Squares add: errors of mean square s² beside a true t² make m² = t² + s² on the mean. That is not corrected, so it
    counts whole (GUM, F.2.4.5), however little slope the figure has: as m − √(m² − s²), or as √(m² + s²) − m where m is
    small and the errors may have cancelled. What was fitted to the same reference is not raised by it, and is no case
    for this. `alone` is the root mean square that the figure's own noise makes by itself, `along` what that noise moves
    it by.
    """
    here, slopes, squares = figure(run), [along], alone**2
    for error in declared_errors(run):
        one, other = figure(error.change(run)), figure(error.change(run, -1.0))
        slopes.append((one - other) / 2)
        squares += max((one**2 + other**2) / 2 - here**2, 0.0)
    raised = max(here - np.sqrt(max(here**2 - squares, 0.0)), np.sqrt(here**2 + squares) - here)
    return float(np.hypot(np.linalg.norm(slopes), raised))


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
