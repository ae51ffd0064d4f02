"""`labcal fit --json` as the contract has it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal.fit.result import Fit
from labcal.record import Run

FORMAT = "labcal-fit/1"


def document(run: Run, fits: Sequence[Fit]) -> dict[str, Any]:
    """The whole answer to `labcal fit`, ready for JSON: finite numbers only."""
    return {"format": FORMAT, "run_id": run.run_id, "n_samples": len(run), "fits": [one(found) for found in fits]}


def one(found: Fit) -> dict[str, Any]:
    """One FIT; `D` is absent where the method has none, all else is there or null."""
    out = {
        "method": found.method,
        "ok": found.ok,
        "why_not": found.why_not,
        "K": _listed(found.affine.K) if found.affine else None,
        "k_nT": _listed(found.affine.k_nT) if found.affine else None,
        "covariance": _listed(found.covariance),
        "frame_known": found.frame_known,
        "bias_nT": _listed(found.bias_nT),
        "rms_scalar_nT": found.rms_scalar_nT,
        "holdout_rms_scalar_nT": found.holdout_rms_scalar_nT,
        "axis_error_deg": list(found.axis_error_deg) if found.axis_error_deg else None,
        "seconds": found.seconds,
        "effects": [asdict(effect) for effect in found.effects],
    }
    return out if found.D is None else out | {"D": _listed(found.D)}


def _listed(values: NDArray[np.float64] | None) -> Any:
    """Nested lists, or None where there is nothing, or nothing finite, to say."""
    return values.tolist() if values is not None and np.isfinite(values).all() else None
