"""`telemetry`: bias that varies with housekeeping currents, from magnitudes (Springmann & Cutler 2011, (9) to (15)).

The paper solves (12) to (14), B̃ = T B + o + Σ s_j I_j with T lower triangular, for B and fits |B|² to the field's. Here
the same model is written B = (I + D) B̃ − b − Σ e_j I_j, D symmetric; T = (I + D)⁻¹ up to a rotation that magnitudes do
not see, and `foster_elkaim.parameters` gives the paper's numbers. Rows are weighted by the variance of |B|², which (10)
leaves out, and the noise that the slopes share with |B|² is taken off as in `moments`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.fit.autocorrelation import variance_inflation
from labcal.fit.result import Fit
from labcal.fit.scalar import scalar_check, twostep
from labcal.fit.scalar.moments import determined, row_covariance, weighted
from labcal.fit.scalar.scalar_check import COLUMN, MISSING, PERFECT, ROW, TWICE, Estimate
from labcal.fit.scalar.scalar_run import ROUNDS, Scalars, as_fit, scalars, usable
from labcal.model import EffectRecord, Parameter
from labcal.model.effects import offset_current
from labcal.model.effects.regressors import middle, per_axis
from labcal.record import Channel, Run

Array = NDArray[np.float64]
STEPS, SETTLED = 60, 1e-8
DEPENDENT = 1e-6  # of a current's own spread: what must be left of it beside the others


@dataclass(frozen=True, slots=True, eq=False)
class TelemetryEstimate:
    """`affine` holds b and D; `e` (currents, 3) field per ampere; `covariance` of b, D and e row by row."""

    affine: Estimate
    e: Array
    covariance: Array


def telemetry(run: Run, *, channels: Sequence[str] | None = None) -> Fit:
    """Calibrate `run` from magnitudes with an offset in proportion to each current.

    `channels` names the currents; None takes every current of the DUT. Raises InputError for a channel that does not
    exist or is no current; refuses currents that are linearly dependent, naming them.
    """
    chosen = currents_of(run, channels)
    zero = {c.name: middle(c) for c in chosen}
    current = np.column_stack([np.empty((len(run), 0)), *[c.values - zero[c.name] for c in chosen]])
    known = np.flatnonzero(np.isfinite(current).all(axis=1))
    try:
        refuse_dependent(current[known], [c.name for c in chosen])
        run = run.select(known)
        rows = usable(run)
        seen, current = scalars(run), current[known][rows]
        seen, found = settle_currents(seen, current)
    except np.linalg.LinAlgError:
        return Fit("telemetry", ok=False, why_not=f"the magnitudes do not determine all parameters: {MISSING}")
    except (ArithmeticError, ValueError) as error:
        return Fit("telemetry", ok=False, why_not=str(error))
    wider = variance_inflation(residual(seen, current, found)[:, None], run.segment_index[rows])
    widened = found.covariance * wider
    fitted = as_fit(run, "telemetry", seen, replace(found.affine, spread=lambda: widened[:9, :9]), widened=True)
    u = np.sqrt(np.diag(widened)[9:]).reshape(-1, 3)
    return replace(fitted, effects=tuple(map(record, chosen, zero.values(), found.e, u))) if fitted.ok else fitted


def currents_of(run: Run, channels: Sequence[str] | None) -> list[Channel]:
    """The channels by name, or all currents of the DUT. Raises InputError for one that is no current of the DUT."""
    if channels is None:
        return [c for c in run.channels if c.quantity == "current" and c.role == "dut"]
    known = {c.name: c for c in run.channels}
    for name in channels:
        if name not in known:
            raise InputError(f"run {run.run_id} has no channel {name!r}; it has {', '.join(known) or 'none'}")
        if known[name].quantity != "current" or known[name].role != "dut":
            raise InputError(f"channel {name!r} is no current of the DUT, which is what `telemetry` takes")
    return [known[name] for name in channels]


def refuse_dependent(current: Array, names: Sequence[str]) -> None:
    """Raise ValueError where a current (column) is constant, or a sum of the others, and say which."""
    moves = current - current.mean(axis=0)
    spread = np.sqrt(np.mean(moves**2, axis=0))
    level = np.abs(current).max(axis=0)
    still = ", ".join(name for name, s, most in zip(names, spread, level, strict=True) if s <= 1e-9 * most)
    if still:
        raise ValueError(f"the current {still} never changes, so its offset is part of the bias: leave it out")
    if not len(names):
        return
    _, singular, directions = np.linalg.svd(moves / spread, full_matrices=False)
    if singular[-1] < DEPENDENT * np.sqrt(len(moves)):
        share = np.abs(directions[-1])
        which = [name for name, part in zip(names, share, strict=True) if part > 1e-3 * share.max()]
        raise ValueError(f"the currents {', '.join(which)} are linearly dependent: leave one of them out")


def settle_currents(seen: Scalars, current: Array) -> tuple[Scalars, TelemetryEstimate]:
    """Estimate and noise in turn until they agree."""
    found = estimate(seen.reading, seen.magnitude, current, seen.noise, seen.reference_noise, unbiased=False)
    for _ in range(ROUNDS):
        r = residual(seen, current, found)
        scale = float(np.sqrt(r @ r / (len(r) - len(found.covariance))))
        seen = seen.with_noise_times(scale)
        found = estimate(seen.reading, seen.magnitude, current, seen.noise, seen.reference_noise, near=found)
        if abs(scale - 1) < 0.002:
            break
    return seen, found


def estimate(
    reading: Array,
    magnitude: Array,
    current: Array,
    noise: Array,
    reference_noise: float = 0.0,
    *,
    unbiased: bool = True,
    near: TelemetryEstimate | None = None,
) -> TelemetryEstimate:
    """B, D and e from readings (n, 3), field magnitudes (n,) and currents (n, l); one unit of field.

    `noise` (3, 3) is the covariance of a reading, `reference_noise` the standard deviation of a magnitude. Raises
    ArithmeticError where the rows do not determine 9 + 3 l parameters.
    """
    unit = float(np.sqrt(np.mean(magnitude**2)))
    ampere = np.sqrt(np.mean(current**2, axis=0))
    rows = ScaledRows(reading / unit, magnitude / unit, current / ampere, noise / unit**2, reference_noise / unit)
    to_unit = np.concatenate([np.full(3, unit), np.ones(6), np.repeat(unit / ampere, 3)])
    if near is None:
        q = np.zeros(9 + 3 * current.shape[1])
        q[:9] = first_guess(rows)
    else:
        q = np.concatenate([near.affine.theta, near.e.ravel()]) / to_unit
    q, covariance = descend(rows, q, unbiased=unbiased)
    q, covariance = q * to_unit, covariance * np.outer(to_unit, to_unit)
    affine = Estimate(q[:3], scalar_check.unstacked(q[3:9]), lambda: covariance[:9, :9])
    return TelemetryEstimate(affine, q[9:].reshape(-1, 3), covariance)


@dataclass(frozen=True, slots=True, eq=False)
class ScaledRows:
    """Readings (n, 3), magnitudes (n,), currents (n, l) and noises in units in which they are of order one."""

    reading: Array
    magnitude: Array
    current: Array
    noise: Array
    reference_noise: float

    def field(self, q: Array) -> tuple[Array, Array]:
        """K = I + D (3, 3), and B = K B̃ − b − Σ e_j I_j (n, 3), at the parameters q = (b, D, e)."""
        K = np.eye(3) + scalar_check.unstacked(q[3:9])
        return K, self.reading @ K - q[:3] - self.current @ q[9:].reshape(-1, 3)

    def excess(self, K: Array, field: Array) -> tuple[Array, Array]:
        """|B|² − |H|² less its mean (n,), and its variance (n,), (5) of Crassidis et al."""
        square = np.einsum("ij,ij->i", field, field)
        u = field @ K
        spread = np.einsum("ij,jk,ik->i", u, self.noise, u) * self.magnitude**2 / square
        mean = float(np.sum(self.noise * (K @ K)))
        variance = 4 * (spread + (self.reference_noise * self.magnitude) ** 2) + 2 * mean**2 / 3
        return square - self.magnitude**2 - mean, variance

    def slopes(self, K: Array, field: Array) -> tuple[Array, Array]:
        """d|B|²/dq (n, p), and its derivative by each component of the reading (3, n, p)."""
        slope = self._by_parameters(field, self.reading)
        by_reading = np.empty((3, *slope.shape))
        for axis in range(3):
            by_reading[axis] = self._by_parameters(np.broadcast_to(K[axis], field.shape), self.reading)
            by_reading[axis, :, 3:9] += symmetric(field, np.broadcast_to(np.eye(3)[axis], field.shape))
        return slope, by_reading

    def _by_parameters(self, field: Array, reading: Array) -> Array:
        by_current = -2 * (self.current[:, :, None] * field[:, None, :]).reshape(len(field), -1)
        return np.hstack([-2 * field, symmetric(field, reading), by_current])


def symmetric(a: Array, b: Array) -> Array:
    """Derivative of 2 aᵀ D b (n,) by the six numbers of D, (n, 6)."""
    return TWICE * (a[:, ROW] * b[:, COLUMN] + a[:, COLUMN] * b[:, ROW])


def first_guess(rows: ScaledRows) -> Array:
    """B and D (9,) without the currents: where TWOSTEP starts, or a perfect sensor."""
    try:
        L, perfect, square = scalar_check.regressors(rows.reading.T), np.zeros(9), rows.magnitude**2
        variance = scalar_check.noise_variance(L, square, perfect, rows.noise, rows.reference_noise)
        mean = scalar_check.noise_mean(perfect, rows.noise)
        L_and_square = np.vstack([L, square])
        found = weighted(L_and_square[3:] / variance, L_and_square, mean, row_covariance(rows.noise))
        bias, D = scalar_check.to_b_D(twostep.start(found, perfect[:3]) - PERFECT)
    except (ArithmeticError, np.linalg.LinAlgError):
        return np.zeros(9)
    return np.concatenate([bias, scalar_check.stacked(D)])


def descend(rows: ScaledRows, q: Array, *, unbiased: bool) -> tuple[Array, Array]:
    """Parameters (p,) at the minimum and their covariance (p, p), by damped Gauss-Newton. Raises ArithmeticError."""
    damping, loss, before = 1e-6, np.inf, q
    for _ in range(STEPS):
        K, field = rows.field(q)
        v, variance = rows.excess(K, field)
        now = float(np.sum(v * v / variance))
        if not now <= 1.01 * loss + len(q):  # taking the noise's share off may raise it a little
            damping, q = damping * 10, before + (q - before) / 4
            continue
        slope, by_reading = rows.slopes(K, field)
        weighted = slope.T / variance
        information, gradient = weighted @ slope, -weighted @ v
        share = np.zeros_like(information)
        if unbiased:
            covariance = 2 * field @ K @ rows.noise / variance[:, None]  # Cov(B̃, v) / σ²
            gradient += np.einsum("anp,na->p", by_reading, covariance, optimize=True)
            noisy = np.tensordot(rows.noise, by_reading, 1) / variance[:, None]
            share = np.sum(noisy.transpose(0, 2, 1) @ by_reading, axis=0)
        back = np.linalg.inv(information - share + damping * np.diag(np.diag(information)))
        step = back @ gradient
        before, loss, q, damping = q, now, q + step, damping / 10
        if np.abs(step).max() < SETTLED:
            if unbiased:
                determined(information - share, share)
            back = np.linalg.inv(information - share)
            return q, back @ information @ back.T
    raise ArithmeticError(f"Gauss-Newton does not settle, so the magnitudes hardly determine the parameters: {MISSING}")


def residual(seen: Scalars, current: Array, found: TelemetryEstimate) -> Array:
    """|B|² − |H|² less its mean over its standard deviation (n,)."""
    rows = ScaledRows(seen.reading, seen.magnitude, current, seen.noise, seen.reference_noise)
    v, variance = rows.excess(*rows.field(np.concatenate([found.affine.theta, found.e.ravel()])))
    return np.asarray(v / np.sqrt(variance))


def record(channel: Channel, zero: float, e: Array, u: Array) -> EffectRecord:
    """The effect of one current: nT of B per its unit, counted from `zero`."""
    named = zip(per_axis("c", f"nT/{channel.unit}"), e.tolist(), u.tolist(), strict=True)
    parameters = tuple(Parameter(name, value, spread, unit) for (name, unit), value, spread in named)
    return EffectRecord(offset_current.FAMILY.id, (channel.name,), {channel.name: zero}, "sensor", parameters)
