"""The live estimators against filterpy's: time of one `update`, alternating in one process.

`centered-sequential` has no counterpart there and stands beside the extended filter. Both see the same readings and
start from the same state; filterpy is given the measurement model in numpy, its derivative, and the identity for its
prediction, as its documentation shows.

    python -m venv /tmp/filterpy && /tmp/filterpy/bin/pip install numpy scipy filterpy
    OPENBLAS_NUM_THREADS=1 PYTHONPATH=. /tmp/filterpy/bin/python benchmarks/filters_filterpy.py
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

from labcal.fit import scalar_check, twostep
from labcal.fit.centered_sequential import CenteredSequential
from labcal.fit.ekf import EKF
from labcal.fit.live import LiveFilter
from labcal.fit.ukf import UKF, AugmentedUKF

SIGMA, START, UPDATES = 1e-3, 400, 2000
Reading = tuple[np.ndarray, float]


def readings() -> tuple[np.ndarray, np.ndarray]:
    """Readings (n, 3) and magnitudes (n,) of a tumbling sensor, in units of the field."""
    random = np.random.default_rng(0)
    field = random.standard_normal((START + UPDATES, 3))
    field *= random.uniform(0.5, 1.2, (len(field), 1)) / np.linalg.norm(field, axis=1, keepdims=True)
    return field * 1.03 + [0.02, 0.05, -0.03] + SIGMA * random.standard_normal(field.shape), np.linalg.norm(
        field, axis=1
    )


def predicted(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """h(x), (24)."""
    return np.array([scalar_check.regressors(B[None].T)[:9, 0] @ x - scalar_check.bias_square(x)[0]])


def slope(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """H(x), (26)."""
    return scalar_check.regressors(B[None].T)[:9].T - scalar_check.bias_square(x)[1]


def variance(x: np.ndarray, B: np.ndarray, H: float) -> float:
    """σ²(x), (5b)."""
    return float(
        scalar_check.noise_variance(scalar_check.regressors(B[None].T), np.array([H * H]), x, SIGMA**2 * np.eye(3))[0]
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


def ours(kind: type[LiveFilter | CenteredSequential], B: np.ndarray, H: np.ndarray) -> Callable[..., None]:
    """`update` of labcal's, once the readings (n, 3) and magnitudes (n,) have started it."""
    live = kind(SIGMA**2 * np.eye(3))
    for reading, magnitude in zip(B, H.tolist(), strict=True):
        live.update(reading, magnitude)
    live.estimate()
    return live.update


def main() -> None:
    """Print the median processor time of an update, in turns, and the ratio."""
    B, H = readings()
    first, rest = (B[:START], H[:START]), list(zip(B[START:], H[START:].tolist(), strict=True))
    found = twostep.estimate(*first, SIGMA**2 * np.eye(3))
    carried = scalar_check.jacobian(found.bias, found.D)
    start = scalar_check.to_c_E(found.bias, found.D), carried @ found.covariance @ carried.T
    pairs = {
        "ekf": (EKF, theirs_extended),
        "ukf": (UKF, theirs_unscented),
        "ukf-augmented": (AugmentedUKF, theirs_unscented),
        "centered-sequential": (CenteredSequential, theirs_extended),
    }
    for name, (kind, rival) in pairs.items():
        turns = [rival(*start), ours(kind, *first)]
        times = 1e6 * np.array([[clock(update, b, h) for update in turns] for b, h in rest])
        (alone, before), (quick, after) = np.quantile(times, [0.05, 0.5], axis=0).T
        print(
            f"{name}: filterpy {before:.0f} µs, labcal {after:.1f} µs, ratio {before / after:.1f}; "
            f"undisturbed (fastest twentieth) {alone:.0f} and {quick:.1f} µs, ratio {alone / quick:.1f}"
        )


def clock(update: Callable[[np.ndarray, float], None], B: np.ndarray, H: float) -> float:
    """Processor seconds of one update."""
    start = time.process_time()
    update(B, H)
    return time.process_time() - start


if __name__ == "__main__":
    main()
