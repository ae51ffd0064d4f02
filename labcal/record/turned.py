"""Where the field was in the DUT's axes in one turn of a run."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, slots=True)
class TurnBefore:
    """A segment that was recorded to its end: `field_nT` (n, 3), nominal, in the DUT's axes, thinned."""

    segment: str
    field_nT: NDArray[np.float64]
