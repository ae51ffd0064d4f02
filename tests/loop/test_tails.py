"""Upper tails of the distributions, beside scipy's."""

import pytest

from labcal.loop import tails

FREEDOMS = [1, 2, 5, 30, 333, 5000]


@pytest.mark.parametrize("freedoms", [10, 20, 30])
def test_chi_squared_is_scipys(freedoms: int) -> None:
    from scipy.special import chdtrc

    for x in (0.0, 0.3, 9.0, 30.0, 120.0, 900.0):
        assert tails.of_chi2(freedoms, x) == pytest.approx(float(chdtrc(freedoms, x)), rel=1e-11)
    assert tails.of_chi2(freedoms, 1e40) == 0


def test_the_normal_tail_is_scipys() -> None:
    from scipy.special import ndtr

    assert [tails.of_normal(z) for z in (-3, 0, 0.5, 4, 12)] == pytest.approx([ndtr(-z) for z in (-3, 0, 0.5, 4, 12)])


@pytest.mark.parametrize("above", FREEDOMS)
@pytest.mark.parametrize("below", FREEDOMS)
def test_the_ratio_of_mean_squares_is_scipys(above: int, below: int) -> None:
    from scipy.special import fdtrc

    for ratio in (0.0, 0.01, 0.7, 1.0, 1.1, 3.0, 40.0):
        assert tails.of_f(above, below, ratio) == pytest.approx(float(fdtrc(above, below, ratio)), rel=1e-8, abs=1e-250)
