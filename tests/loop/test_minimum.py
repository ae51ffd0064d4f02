"""The least of a function of one number, beside scipy's own."""

import numpy as np
import pytest

from labcal.loop.minimum import least

FUNCTIONS = {
    "a bend": lambda x: np.sin(3 * x + 1) + 0.3 * x**2,
    "a corner": lambda x: abs(x - 0.61),
    "plateaus": lambda x: round(np.sin(5 * x), 2),
    "at the bound": np.exp,
    "flat": lambda x: 1.0,
}


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("most", [18, 60])
def test_it_asks_for_the_very_points_that_scipys_bounded_search_does(name: str, most: int) -> None:
    from scipy.optimize import minimize_scalar

    f = FUNCTIONS[name]
    theirs, ours = [], []
    options = {"maxiter": most, "xatol": 3e-3}
    found = minimize_scalar(lambda x: [theirs.append(x), f(x)][1], bounds=(-1, 2), method="bounded", options=options)
    x, value = least(lambda x: [ours.append(x), f(x)][1], -1, 2, within=3e-3, most=most)
    assert np.allclose(ours, theirs, rtol=0, atol=1e-9)
    assert (x, value) == pytest.approx((found.x, found.fun), abs=1e-9)
