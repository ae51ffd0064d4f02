"""A residual on the sphere by degree, against integrals over the sphere worked out by hand or by quadrature."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit.harmonics import real_harmonics, shells
from procedures.field_sphere import lattice


def quadrature() -> tuple[np.ndarray, np.ndarray]:
    """Directions and weights exact for polynomials up to degree 15: Gauss-Legendre by even longitudes."""
    z, w = np.polynomial.legendre.leggauss(8)
    phi = 2 * np.pi * np.arange(16) / 16
    r = np.sqrt(1 - z**2)
    d = np.stack([np.outer(r, np.cos(phi)), np.outer(r, np.sin(phi)), np.outer(z, np.ones(16))], axis=-1)
    return d.reshape(-1, 3), np.repeat(w, 16) / 32


def test_the_sixteen_harmonics_are_orthonormal_over_the_sphere() -> None:
    d, w = quadrature()
    Y = real_harmonics(d)
    assert np.einsum("n,ni,nj->ij", w, Y, Y) == pytest.approx(np.eye(16), abs=1e-12)


@pytest.mark.parametrize(
    ("residual", "rms"),
    [
        (lambda d: np.tile([3.0, 0, 4.0], (len(d), 1)), (5, 0, 0, 0)),
        (lambda d: d * [6.0, 0, 0], (0, 6 / np.sqrt(3), 0, 0)),
        # x y on z: mean square of x²y² is 1/15
        (lambda d: np.outer(30 * d[:, 0] * d[:, 1], [0, 0, 1.0]), (0, 0, 30 / np.sqrt(15), 0)),
        # x³ on each axis: 3/5 x, and a rest of degree 3 with mean square 1/7 - 3/25 = 4/175
        (lambda d: 100 * d**3, (0, 60.0, 0, 100 * np.sqrt(3 * 4 / 175))),
    ],
)
def test_polynomials_have_the_degrees_that_they_have(residual, rms) -> None:
    d = lattice(48)
    (shell,) = shells(30e3 * d, residual(d))
    assert shell.rms_nT == pytest.approx(rms, abs=1e-9)
    assert shell.magnitude_nT == pytest.approx(30e3)


def test_noise_gives_each_degree_what_is_said_and_chances_are_even() -> None:
    d, rng = lattice(48), np.random.default_rng(4)
    found = [shells(30e3 * d, rng.normal(0, 5.0, (48, 3)))[0] for _ in range(200)]
    power = np.mean([shell.rms_nT**2 for shell in found], axis=0)
    assert power == pytest.approx(np.mean([shell.noise_nT**2 for shell in found], axis=0), rel=0.15)
    assert np.mean([shell.beyond_nT**2 for shell in found]) == pytest.approx(25.0, rel=0.05)
    below = np.mean([shell.p < 0.1 for shell in found])
    assert below == pytest.approx(0.1, abs=0.04)


def test_shells_are_told_by_magnitude_and_one_side_is_no_shell() -> None:
    d = lattice(48)
    noise = np.random.default_rng(5).normal(0, 1.0, (144, 3))
    fields = np.vstack([20e3 * d, 35e3 * (1 + 0.01 * d[:, :1]) * d, 50e3 * d])
    assert [round(s.magnitude_nT, -3) for s in shells(fields, noise)] == [20e3, 35e3, 50e3]
    assert shells(20e3 * lattice(20), noise[:20]) == ()
    half = lattice(96)[:48]
    assert shells(20e3 * half, noise[:48]) == ()
    assert shells(np.linspace(1, 5, 48)[:, None] * 1e4 * d, noise[:48]) == ()
