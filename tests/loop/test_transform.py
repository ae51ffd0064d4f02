"""The cosine transform along the rows, beside scipy's."""

import numpy as np
import pytest

from labcal.loop.spectrum import fast, fast_from, transformed


@pytest.mark.parametrize("n", [1, 2, 3, 64, 135, 1000])
def test_it_is_scipys(n: int) -> None:
    from scipy.fft import dct

    columns = np.random.default_rng(n).normal(size=(n, 3, 4))
    assert np.allclose(transformed(columns), dct(columns, axis=0, norm="ortho"), rtol=0, atol=1e-12)


def test_lengths_are_those_that_scipy_takes_for_fast() -> None:
    from scipy.fft import next_fast_len

    for n in range(1, 3000, 7):
        assert fast_from(n) == next_fast_len(n, real=True)
        assert next_fast_len(fast(n), real=True) == fast(n) <= n < fast_from(fast(n) + 1) + (n == fast(n))
