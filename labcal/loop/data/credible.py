"""Effects driven by the reference that the base would have to undo almost whole: no field that a lab makes.

The map is driven by readings, the rig's effects and a few of the sensor's by the reference. One that is nearly a turn
or a stretch of the whole field differs from the same turn of the map by the residual itself, turned or stretched: made
as large as the field, it takes any residual off, whatever its cause. A direction of which the share s of the square is
new to the base, and which takes off a residual of rms r, has the rms r / √s itself; what would be more than half of the
field (`max_share_of_field`) is left out.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.loop import policy
from labcal.loop.noise.nuisance import MIN_NEW_SHARE, new_directions, unit_lengths
from labcal.model.effects import Term, families

Array = NDArray[np.float64]
WILD = 10.0  # times the median: longer residuals are cut before anything is known of them


def of_the_rig(term: Term) -> bool:
    """Whether it is no effect of the sensor."""
    return any(family.owner(term) == "rig" for family in families() if family.kernel is term.kernel)


def follows_reference(term: Term) -> bool:
    """Whether the reference drives it, where that is a vector."""
    return of_the_rig(term) or any(f.follows_reference for f in families() if f.kernel is term.kernel)


def driven_by_field(term: Term) -> bool:
    """Whether it follows the reference's field, not the run's clock alone: a drift has no field to be half of."""
    return follows_reference(term) and not any(f.bound_to_run for f in families() if f.kernel is term.kernel)


def min_new_share(apart_nT: Array, field_nT: Array) -> float:
    """The share of a column's square that has to be new to the base, where readings and reference are `apart_nT`.

    Both (n, 3) on the rows of the fit; `apart_nT` by the best map (`left_by_the_best_map`), no effect taken off.
    """
    part = float(np.sum(apart_nT**2) / np.sum(field_nT**2))
    return max(MIN_NEW_SHARE, part / policy.POLICY.max_share_of_field**2)


def left_by_the_best_map(T: Array, whiten: Array, apart_nT: Array) -> Array:
    """What a step of the base, of columns T (n, q, t), leaves of readings and reference apart (n, 3) [nT].

    A map that was found beside an effect leaves as much of them apart as it took of that effect, however large.
    """
    if whiten.shape[1] != whiten.shape[2]:
        return apart_nT
    y, flat = (whiten @ apart_nT[:, :, None]).ravel(), T.reshape(-1, T.shape[2])
    left = y - flat @ np.linalg.lstsq(flat, y, rcond=None)[0]
    return np.asarray(np.linalg.solve(whiten, left.reshape(*apart_nT.shape, 1))[:, :, 0])


def is_beyond_half(effect_nT: Array, reference_nT: Array, apart_nT: float) -> bool:
    """Whether an effect is more than half of the field that drives it, in a direction in which the field changes.

    Both (n, 3) in C. Two may be, each the other's undoing: iron beside coils that are not alike leaves the reference
    less what the coils make, so all that the reference drifts. Changes of less than twice what readings and reference
    are apart say nothing: there an effect may be as large as what drives it.
    """
    reference, effect = reference_nT - reference_nT.mean(axis=0), effect_nT - effect_nT.mean(axis=0)
    squares, directions = np.linalg.eigh(reference.T @ reference / len(reference))
    most = policy.POLICY.max_share_of_field**2
    large = squares * most > apart_nT**2
    along = (reference @ directions[:, large]).T @ effect / len(effect) / squares[large, None]
    return bool((np.sum(along**2, axis=1) > most).any())


def without_wild_rows(residual_nT: Array) -> Array:
    """A residual (n, 3) whose rows are no longer than ten times their median: outliers are not known yet."""
    length = np.linalg.norm(residual_nT, axis=1)
    limit = WILD * float(np.median(length))
    return np.asarray(residual_nT * (np.minimum(length, limit) / np.maximum(length, 1e-300))[:, None])


def credible(columns: Array, base: Array, share: float) -> Array:
    """Columns (n, q, p) without the directions of which no more than this share is new to the orthonormal `base`."""
    flat = columns.reshape(-1, columns.shape[2])
    out = not_credible(flat.T @ flat, base.reshape(len(flat), -1).T @ flat, share)
    return columns if out is None else np.asarray(columns - columns @ out)


def not_credible(gram: Array, onto: Array, share: float) -> Array | None:
    """What credible columns are less by, as a combination (p, p) of themselves; None where all are.

    From their Gram matrix (p, p), and their products (b, p) with the orthonormal columns that span the base.
    """
    length = unit_lengths(gram)
    gram, onto = gram / np.outer(length, length), onto / length
    shares, directions = new_directions(gram, gram - onto.T @ onto, share)
    kept = directions[:, shares > share]
    if kept.shape[1] == len(length):
        return None
    return np.asarray(np.eye(len(length)) - kept @ (kept.T @ gram) * length / length[:, None])
