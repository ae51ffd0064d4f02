"""The sensor's figures that only a run shows: noise, linearity, and what the calibration leaves.

All three are read off the magnitude residual |b| - |ref|, which every kind of run with a reference has. An error e of b
moves it by b̂ · e. The reference's own nonlinearity is in it, and its noise where none is stated; its scale, zero and
attitude are not in noise and linearity.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.model import Calibration, EffectRecord
from labcal.model.effects import find
from labcal.record import Run
from labcal.uncertainty.conformity.decision import Measured
from labcal.uncertainty.conformity.of_the_map import AXES

Array = NDArray[np.float64]
FEW = 50  # rows; fewer tell no standard deviation to 10 %
GRID = np.linspace(-1.0, 1.0, 201)
UNSEEN = 1e-6  # of the largest singular value: a direction below it is not determined
SQUARE = np.array([(a, b) for a in range(3) for b in range(a, 3)])


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """The rows (n,) that are whole: field b [nT], magnitude residual [nT], segment."""

    field_nT: Array  # (n, 3)
    residual_nT: Array  # (n,)
    segment: NDArray[np.intp]


def figures_of_the_run(calibration: Calibration, run: Run) -> tuple[Measured, ...]:
    """Noise, linearity of each axis and residual, as far as `run` determines them; none without a reference."""
    if run.reference.kind == "none":
        return ()
    corrected, raw = _seen(calibration, run), _seen(_not_straightened(calibration), run)
    if len(corrected.residual_nT) < FEW:
        return ()
    return (*_noise(corrected, run.reference.noise_nT or 0.0), *_linearity(raw), *_residual(calibration, corrected))


def _seen(calibration: Calibration, run: Run) -> _Seen:
    applied = calibration.apply(run)
    residual = np.linalg.norm(applied.field_nT, axis=1) - run.magnitude_nT
    odd = {flag: bool({"saturated", "outlier"} & set(flag.split())) for flag in set(applied.flags)}
    rows = np.isfinite(residual) & ~np.array([odd[flag] for flag in applied.flags], dtype=bool)
    return _Seen(applied.field_nT[rows], residual[rows], run.segment_index[rows])


def _not_straightened(calibration: Calibration) -> Calibration:
    """Without the effects that correct how the sensor answers the field alone: its linearity is asked, not theirs."""
    kept = tuple(effect for effect in calibration.effects if not _of_the_field_alone(effect))
    return replace(calibration, effects=kept, covariance=None)


def _of_the_field_alone(effect: EffectRecord) -> bool:
    family = find(effect.effect)
    return family is not None and family.of_field and not effect.channels


def _noise(seen: _Seen, of_reference_nT: float) -> list[Measured]:
    """From the differences d of neighbours: σ² = Σ d² / 2N, with 2N/3 degrees of freedom (von Neumann et al. 1941).

    Neighbouring differences share a reading: their squares correlate by 1/4, which leaves two thirds of the N. Of the
    reference's own variance somewhere between none and all is in it, as it is brought to the rows: half is taken off,
    and the rest is a rectangular distribution's (GUM, 4.3.7).
    """
    inside = np.diff(seen.segment) == 0
    d = np.diff(seen.residual_nT)[inside]
    variance = float(np.mean(d**2) / 2)
    ours = variance - of_reference_nT**2 / 2
    if ours <= 0:
        return []
    u_variance = np.hypot(variance * np.sqrt(2 / (2 * len(d) / 3)), of_reference_nT**2 / np.sqrt(12))
    return [Measured("noise", "noise", float(np.sqrt(ours)), float(u_variance / (2 * np.sqrt(ours))), signed=False)]


def _residual(calibration: Calibration, seen: _Seen) -> list[Measured]:
    """The rms on held-out time, with a relative standard uncertainty of 1/√(2ν), ν the independent numbers in it."""
    after = calibration.metrics.get("after", {})
    value = after.get("holdout_rms_nT", after.get("holdout_rms_scalar_nT"))
    if value is None:
        return []
    rho = autocorrelations(seen.residual_nT)
    independent = len(seen.residual_nT) / (1 + 2 * float(np.sum(rho**2)))
    return [Measured("residual", "residual", value, value / float(np.sqrt(2 * independent)), signed=False)]


def _linearity(seen: _Seen) -> list[Measured]:
    """Of each axis the largest deviation, over the field it saw, from its best straight line: c₂ P₂ + c₃ P₃.

    Legendre's polynomials of b over its largest are what is left of a cubic beside the line of least squares. They are
    fitted together with a map of their own (an offset and a symmetric matrix), so that none of it is mistaken for them.
    """
    largest = np.abs(seen.field_nT).max(axis=0)
    unit = seen.field_nT / np.linalg.norm(seen.field_nT, axis=1)[:, None]
    design = np.hstack([*_map_columns(unit, seen.field_nT / largest.max()), *_bends(unit, seen.field_nT / largest)])
    found = _least_squares(design, seen.residual_nT)
    if found is None:
        return []
    coefficients, covariance = found
    out = []
    for axis, name in enumerate(AXES):
        at = design.shape[1] - 6 + axis + np.array([0, 3])
        shape = np.stack(_bend(GRID))
        deviation = coefficients[at] @ shape
        worst = int(np.argmax(np.abs(deviation)))
        variance = shape[:, worst] @ covariance[np.ix_(at, at)] @ shape[:, worst]
        scale = float(largest[axis])
        u = float(np.sqrt(variance))
        out.append(Measured("linearity", f"linearity {name}", float(deviation[worst]), u, full_scale_nT=scale))
    return out


def _map_columns(unit: Array, x: Array) -> tuple[Array, Array]:
    """What an offset (n, 3) and a symmetric matrix (n, 6) do to the magnitude."""
    return unit, unit[:, SQUARE[:, 0]] * x[:, SQUARE[:, 1]]


def _bends(unit: Array, x: Array) -> tuple[Array, Array]:
    second, third = _bend(x)
    return unit * second, unit * third


def _bend(x: Array) -> tuple[Array, Array]:
    """Legendre's P₂ and P₃."""
    return (3 * x**2 - 1) / 2, (5 * x**3 - 3 * x) / 2


def _least_squares(design: Array, y: Array) -> tuple[Array, Array] | None:
    """Coefficients and covariance, widened for residuals that correlate; None where a direction is not determined."""
    size = np.linalg.norm(design, axis=0)
    if len(y) <= len(size) or not size.all():
        return None
    left, singular, right = np.linalg.svd(design / size, full_matrices=False)
    if singular[-1] < UNSEEN * singular[0]:
        return None
    coefficients = (right.T / singular) @ (left.T @ y) / size
    residual = y - design @ coefficients
    inverse = (right.T / singular**2) @ right / np.outer(size, size)
    inflation = max(1.0, 1 + 2 * float(np.sum(autocorrelations(residual))))
    return coefficients, inverse * float(residual @ residual) / (len(y) - len(size)) * inflation


def autocorrelations(y: Array) -> Array:
    """ρ_1, ρ_2 … about zero, up to the first that is within its noise, 2/√n; at most a tenth of the n lags."""
    power = np.abs(np.fft.rfft(y, 2 * len(y))) ** 2
    products = np.fft.irfft(power)[: max(len(y) // 10, 1)]
    rho = products[1:] / products[0] if products[0] > 0 else np.zeros(0)
    small = np.flatnonzero(rho < 2 / np.sqrt(len(y)))
    return np.asarray(rho[: small[0]] if len(small) else rho)
