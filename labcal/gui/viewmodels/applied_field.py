"""What the coils make, of the currents that were read. No widgets."""

from __future__ import annotations

from typing import Any

import numpy as np

from labcal.gui.viewmodels.lab import Triple


def applied_field(current_A: tuple[float | None, ...], matrix_nT_per_A: Any) -> Triple | None:
    """The field that these currents make; None where one is not known."""
    if None in current_A:
        return None
    x, y, z = np.asarray(matrix_nT_per_A) @ np.asarray(current_A, dtype=float)
    return float(x), float(y), float(z)
