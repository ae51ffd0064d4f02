"""The World Magnetic Model beside another model of another package, and its own edges."""

from __future__ import annotations

from datetime import date

import numpy as np
import pytest

from labcal.earth.igrf import igrf_nT
from labcal.earth.wmm import wmm
from labcal.errors import InputError

DAY = date(2026, 3, 2)
PLACES = [(52.1, 11.6, 80.0), (-33.9, 151.2, 20.0), (0.0, -78.5, 2850.0), (64.1, -21.9, 10.0), (-54.8, -68.3, 400.0)]


@pytest.mark.parametrize("place", PLACES)
def test_it_agrees_with_the_igrf_far_within_its_error_model(place: tuple[float, float, float]) -> None:
    """Two candidates for the same core field differ by tens of nT; another order of axes or sign by thousands."""
    expected = wmm(*place, DAY)
    apart = expected.field_nT - igrf_nT(*place, DAY, "ned")
    assert np.all(np.abs(apart) < 50)
    assert np.any(apart != 0)
    assert np.allclose(wmm(*place, DAY, "enu").field_nT, expected.field_nT[[1, 0, 2]] * [1, 1, -1])


def test_the_error_model_is_that_of_the_edition() -> None:
    """WMM2025's report: 137 nT north, 89 east, 141 down, 138 of the total intensity (one standard deviation)."""
    now, before = wmm(*PLACES[0], DAY), wmm(*PLACES[0], date(2022, 7, 1))
    assert (now.model, before.model) == ("WMM2025", "WMM2020")
    assert now.u_nT.tolist() == [137, 89, 141]
    assert (now.u_magnitude_nT, before.u_magnitude_nT) == (138, 148)
    assert 20 < now.magnitude_nT - before.magnitude_nT < 400  # a few tens of nT a year in Europe


@pytest.mark.parametrize(("when", "height_m"), [(date(2014, 12, 31), 0.0), (date(2030, 1, 1), 0.0), (DAY, 9e5)])
def test_outside_its_years_and_heights_it_is_refused(when: date, height_m: float) -> None:
    with pytest.raises(InputError, match="WMM"):
        wmm(52.1, 11.6, height_m, when)
