"""A bench of our own for the estimators' tests."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from labcal.model import AffineMap
from labcal.record import Run
from labcal.testing.made_up_runs import made_up_run

Array = NDArray[np.float64]
Bench = Callable[..., tuple[Run, AffineMap, Array]]


def make(**stated: Any) -> tuple[Run, AffineMap, Array]:
    """A run of one full turn per axis and field, its true map, and the true field (n, 3) in B."""
    made = made_up_run(**stated)
    return made.run, made.true, made.field_nT


@pytest.fixture(scope="session")
def bench() -> Bench:
    """The function that makes simulated runs."""
    return make
