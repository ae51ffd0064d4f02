"""Effects of other packages: whatever goes wrong in their formulas is said with their name, as a wrong input."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import wraps

import numpy as np

from labcal.errors import InputError
from labcal.model.effects.protocol import Array, Family, Kernel, Scene, Term
from labcal.outside import blamed
from labcal.record import Run


def guarded(family: Family, where: str) -> Family:
    """The same family; its candidates and columns are checked, and a fault names it and `where` it comes from."""
    named = f"the effect {family.id} of another package ({where})"
    return replace(family, kernel=_checked(family.kernel, named), candidates=_candidates(family.candidates, named))


def _candidates(candidates: Callable[[Run], Sequence[Term]], named: str) -> Callable[[Run], Sequence[Term]]:
    @wraps(candidates)
    def found(run: Run) -> Sequence[Term]:
        with blamed(named, f"on run {run.run_id}"):
            return [replace(term, kernel=_checked(term.kernel, named)) for term in candidates(run)]

    return found


def _checked(kernel: Kernel, named: str) -> Kernel:
    @wraps(kernel)
    def columns(term: Term, scene: Scene) -> Array:
        with blamed(named, "in its formula"):
            found = np.asarray(kernel(term, scene), dtype=float)
        wanted = (len(scene), 3, len(term.parameters))
        if found.shape != wanted:
            raise InputError(f"{named} gives columns of shape {found.shape}, not (rows, 3, parameters) = {wanted}")
        known = np.isfinite(scene.field_nT).all() and all(np.isfinite(scene.channels[c]).all() for c in term.channels)
        if known and not np.isfinite(found).all():
            raise InputError(f"{named} gives numbers that are not finite")
        return found

    return columns
