"""The live filters against filterpy's: time of one update, alternating in one process.

Both see the same readings and start from the same state; filterpy is given the measurement model in numpy, its
derivative, and the identity for its prediction, as its documentation shows.

    python -m venv /tmp/filterpy && /tmp/filterpy/bin/pip install numpy scipy filterpy
    OPENBLAS_NUM_THREADS=1 PYTHONPATH=. /tmp/filterpy/bin/python benchmarks/filters_filterpy.py
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

from labcal.fit import ekf, scalar_check, twostep, ukf

SIGMA, UPDATES = 1e-3, 500
Reading = tuple[np.ndarray, float]


def readings() -> tuple[np.ndarray, np.ndarray]:
    """Readings (n, 3) and magnitudes (n,) of a tumbling sensor, in units of the field."""
    random = np.random.default_rng(0)
    field = random.standard_normal((UPDATES + 200, 3))
    field *= random.uniform(0.5, 1.2, (len(field), 1)) / np.linalg.norm(field, axis=1, keepdims=True)
    return field * 1.03 + [0.02, 0.05, -0.03] + SIGMA * random.standard_normal(field.shape), np.linalg.norm(
        field, axis=1
    )


def predicted(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """h(x), (24)."""
    return np.array([scalar_check.regressor(B[None])[0] @ x - scalar_check.bias_square(x)[0]])


def slope(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """H(x), (26)."""
    return scalar_check.regressor(B[None]) - scalar_check.bias_square(x)[1]


def variance(x: np.ndarray, B: np.ndarray, H: float) -> float:
    """σ²(x), (5b)."""
    return float(
        scalar_check.noise_variance(scalar_check.regressor(B[None]), np.array([H]), x, SIGMA**2 * np.eye(3))[0]
    )


def theirs_extended(x: np.ndarray, P: np.ndarray) -> Callable[[np.ndarray, float], None]:
    """One prediction and update of filterpy's extended filter."""
    kalman = ExtendedKalmanFilter(dim_x=9, dim_z=1)
    kalman.x, kalman.P, kalman.Q = x.copy(), P.copy(), np.zeros((9, 9))

    def update(B: np.ndarray, H: float) -> None:
        kalman.predict()
        z = np.array([B @ B - H**2 - 3 * SIGMA**2])
        kalman.update(z, slope, predicted, R=variance(kalman.x, B, H), args=(B,), hx_args=(B,))

    return update


def theirs_unscented(x: np.ndarray, P: np.ndarray) -> Callable[[np.ndarray, float], None]:
    """One prediction and update of filterpy's unscented filter."""
    points = MerweScaledSigmaPoints(9, alpha=0.1, beta=2.0, kappa=-6.0)
    kalman = UnscentedKalmanFilter(9, 1, dt=1.0, hx=predicted, fx=lambda state, dt: state, points=points)
    kalman.x, kalman.P, kalman.Q = x.copy(), P.copy(), np.zeros((9, 9))

    def update(B: np.ndarray, H: float) -> None:
        kalman.predict()
        z = np.array([B @ B - H**2 - 3 * SIGMA**2])
        kalman.update(z, R=np.array([[variance(kalman.x, B, H)]]), B=B)

    return update


def ours(
    step: Callable[..., tuple[np.ndarray, np.ndarray, float]],
) -> Callable[..., Callable[[np.ndarray, float], None]]:
    """One step of labcal's."""

    def begin(x: np.ndarray, P: np.ndarray) -> Callable[[np.ndarray, float], None]:
        state, noise = [x, P], SIGMA**2 * np.eye(3)

        def update(B: np.ndarray, H: float) -> None:
            state[0], state[1], _ = step(state[0], state[1], B, H, noise, 0.0)

        return update

    return begin


def main() -> None:
    """Print the median time of an update, in turns, and the ratio."""
    B, H = readings()
    found = twostep.estimate(B[:200], H[:200], SIGMA**2 * np.eye(3))
    carried = scalar_check.jacobian(found.bias, found.D)
    start = scalar_check.to_c_E(found.bias, found.D), carried @ found.covariance @ carried.T
    pairs = {
        "ekf": (theirs_extended, ours(ekf.step)),
        "ukf": (theirs_unscented, ours(ukf.step)),
        "ukf-augmented": (theirs_unscented, ours(ukf.step_augmented)),
    }
    for name, (slow, fast) in pairs.items():
        turns = [f(*start) for f in (slow, fast)]
        times = np.array([[clock(f, b, h) for f in turns] for b, h in zip(B[200:], H[200:].tolist(), strict=True)])
        before, after = np.median(times, axis=0) * 1e6
        print(f"{name}: filterpy {before:.0f} µs, labcal {after:.1f} µs, ratio {before / after:.1f}")


def clock(update: Callable[[np.ndarray, float], None], B: np.ndarray, H: float) -> float:
    """Seconds of one update."""
    start = time.perf_counter()
    update(B, H)
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
