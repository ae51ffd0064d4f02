"""The live estimators against filterpy's: time of one `update`, alternating in one process.

`centered-sequential` has no counterpart there and stands beside the extended filter. Both see the same readings and
start from the same state; filterpy is given the measurement model in plain numpy, as the paper writes it, its
derivative, and the identity for its prediction, as its documentation shows.

    python -m venv /tmp/filterpy && /tmp/filterpy/bin/pip install numpy scipy filterpy
    OPENBLAS_NUM_THREADS=1 PYTHONPATH=. /tmp/filterpy/bin/python benchmarks/filters_filterpy.py
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from filterpy.kalman import ExtendedKalmanFilter, MerweScaledSigmaPoints, UnscentedKalmanFilter

from labcal.fit.filters.centered_sequential import CenteredSequential
from labcal.fit.filters.ekf import EKF
from labcal.fit.filters.sequential import LiveFilter
from labcal.fit.filters.ukf import UKF, AugmentedUKF
from labcal.fit.scalar import scalar_check, twostep

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


def regressors(B: np.ndarray) -> np.ndarray:
    """L (9,), (2c) and (4a), as it stands in the paper."""
    x, y, z = B
    return np.concatenate([2 * B, -np.array([x * x, y * y, z * z, 2 * x * y, 2 * x * z, 2 * y * z])])


def matrix(six: np.ndarray) -> np.ndarray:
    """The symmetric matrix (3, 3) of 11 22 33 12 13 23, (2d)."""
    return np.array([[six[0], six[3], six[4]], [six[3], six[1], six[5]], [six[4], six[5], six[2]]])


def predicted(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """h(x), (24) with (27a)."""
    return np.array([regressors(B) @ x - x[:3] @ np.linalg.solve(np.eye(3) + matrix(x[3:]), x[:3])])


def slope(x: np.ndarray, B: np.ndarray) -> np.ndarray:
    """H(x) (1, 9), (26) with (27b)."""
    inner = np.linalg.solve(np.eye(3) + matrix(x[3:]), x[:3])
    pairs = -np.outer(inner, inner)
    of_E = [pairs[0, 0], pairs[1, 1], pairs[2, 2], 2 * pairs[0, 1], 2 * pairs[0, 2], 2 * pairs[1, 2]]
    return (regressors(B) - np.concatenate([2 * inner, of_E]))[None]


def variance(x: np.ndarray, B: np.ndarray, H: float) -> float:
    """σ²(x), (5b): 4 hᵀΣh + 2 Tr Σ², with Σ = s² M and h along M B − c, of length |H|."""
    M = np.eye(3) + matrix(x[3:])
    h = M @ B - x[:3]
    length = h @ np.linalg.solve(M, h)
    return float(4 * SIGMA**2 * H * H * (h @ h) / length + 2 * SIGMA**4 * np.trace(M @ M))


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
