"""What no run can see and only a declaration can cover: a turn common to all mountings, the reference's own errors."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from labcal.geometry import skew
from labcal.model import AffineMap
from labcal.record import Run

Array = NDArray[np.float64]


def widen(run: Run, affine: AffineMap, covariance: Array, *, frame_known: bool) -> Array:
    """`covariance` (12, 12) and the declared uncertainties that the residuals do not show (contract: u_axis_*, u_…).

    A common turn by w changes K by [w]× K and k by [w]× k, a scale of the reference both in proportion, its zero k
    alone. A turn says nothing where the frame is not known. What is not declared is not covered.
    """
    out = covariance.copy()
    reference = run.reference
    if reference.u_scale_ppm:
        step = 1e-6 * reference.u_scale_ppm * affine.parameters
        out += np.outer(step, step)
    if reference.u_offset_nT:
        out[9:, 9:] += reference.u_offset_nT**2 * np.eye(3)
    if frame_known:
        u = np.hypot(mounting_rad(run), np.radians(reference.u_align_deg or 0.0))
        for turn in skew(u * np.eye(3)):
            step = np.concatenate([(turn @ affine.K).ravel(), turn @ affine.k_nT])
            out += np.outer(step, step)
    return out


def mounting_rad(run: Run) -> float:
    """Root mean square of the declared uncertainties of the rotation axes [rad], body's and cage's together."""
    stated = [(s.u_axis_body_deg or 0.0) ** 2 + (s.u_axis_cage_deg or 0.0) ** 2 for s in run.segments]
    stated = [s for s in stated if s > 0]
    return float(np.radians(np.sqrt(np.mean(stated)))) if stated else 0.0
