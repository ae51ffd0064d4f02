"""When a current has a square of its own."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.model.effects.regressors import is_its_own_square
from labcal.record import Channel


@pytest.mark.parametrize(
    ("levels_A", "itself"),
    [((0.0, 0.6), True), ((0.1, 0.9), True), ((-0.3, 0.3), True), ((0.1, 0.5, 0.9, 1.6), False), ((-1.0, 0, 1), False)],
)
def test_a_load_that_is_on_or_off_or_reversed_has_no_square_of_its_own(
    levels_A: tuple[float, ...], itself: bool
) -> None:
    values = np.asarray(levels_A)[np.arange(300) // 7 % len(levels_A)]
    values[250] = np.nan
    assert is_its_own_square(Channel("i", "A", "current", values)) is itself
