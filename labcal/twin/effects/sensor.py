"""Effects of the sensor: what it reads beside the field, in nT of its own axes (n, 3), given the field it sees."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from labcal.twin.housekeeping import telegraph, walk
from labcal.twin.moment import Moment

Array = NDArray[np.float64]
Rng = np.random.Generator
Effect = Callable[[Moment, Array], Array]  # (moment, field seen (n, 3)) -> what it reads too much (n, 3)
Three = Sequence[float]


def offset_current(_: Rng, channel: str = "i_eps", nT_per_A: Three = (900.0, -600.0, 400.0)) -> Effect:
    """A supply line beside the sensor: offset in proportion to its current."""
    return lambda moment, seen: np.outer(moment.channels[channel], nT_per_A)


def offset_current_squared(_: Rng, channel: str = "i_payload", nT_per_A2: Three = (-700.0, 500.0, 900.0)) -> Effect:
    """Offset with the square of a current."""
    return lambda moment, seen: np.outer(moment.channels[channel] ** 2, nT_per_A2)


def offset_temperature(
    _: Rng, channel: str = "temp_dut", nT_per_C: Three = (60.0, -45.0, 30.0), reference_C: float = 20.0
) -> Effect:
    """Offset in proportion to temperature."""
    return lambda moment, seen: np.outer(moment.channels[channel] - reference_C, nT_per_C)


def offset_channel(
    _: Rng, channel: str = "v_bus", nT_per_unit: Three = (2500.0, 1500.0, -2000.0), reference: float = 8.0
) -> Effect:
    """Offset in proportion to any channel."""
    return lambda moment, seen: np.outer(moment.channels[channel] - reference, nT_per_unit)


def gain_temperature(
    _: Rng, channel: str = "temp_dut", per_C: Three = (1.2e-3, -0.9e-3, 1.5e-3), reference_C: float = 20.0
) -> Effect:
    """Each axis' scale factor follows temperature."""
    return lambda moment, seen: seen * np.outer(moment.channels[channel] - reference_C, per_C)


def offset_drift(_: Rng, nT_per_h: Three = (500.0, -350.0, 250.0), settles_s: float = 5000.0) -> Effect:
    """Offset creeping with time, ever slower: settles_s long it goes at nT_per_h."""
    return lambda moment, seen: np.outer(
        settles_s / 3600 * (1 - np.exp(-np.maximum(moment.t_s, 0) / settles_s)), nT_per_h
    )


def offset_step(_: Rng, at_s: float = 700.0, nT: Three = (180.0, -120.0, 150.0)) -> Effect:
    """Something jumps once."""
    return lambda moment, seen: np.outer(moment.t_s >= at_s, nT)


def offset_mode(_: Rng, nT: Mapping[str, Three] | None = None) -> Effect:
    """Another offset in each power mode."""
    by_mode = nT or {"full": (150.0, 90.0, -200.0), "safe": (-80.0, 60.0, 40.0)}

    def effect(moment: Moment, seen: Array) -> Array:
        out = np.zeros_like(seen)
        for mode, offset in by_mode.items():
            out[moment.mode == mode] = offset
        return out

    return effect


def nonlinearity(_: Rng, cubic_per_uT2: float = 8e-6) -> Effect:
    """Each axis reads c B³ too much; `cubic_per_uT2` is c in 1/µT²."""
    return lambda moment, seen: np.asarray(cubic_per_uT2 * 1e-6 * seen**3)


def soft_saturation(_: Rng, full_scale_nT: float = 250_000.0) -> Effect:
    """Each axis bends like F tanh(B / F)."""
    return lambda moment, seen: full_scale_nT * np.tanh(seen / full_scale_nT) - seen


def cross_field(_: Rng, per_uT: float = 1.0e-4) -> Effect:
    """An axis' sensitivity falls with the field across it: B_i (B_j + B_k), as of a magnetoresistive bridge."""
    return lambda moment, seen: per_uT * 1e-3 * seen * (seen.sum(axis=1, keepdims=True) - seen)


def hysteresis(_: Rng, width_nT: float = 6000.0, share: float = 0.02, operators: int = 4) -> Effect:
    """Play with several widths up to `width_nT`, adding `share` of their output (Prandtl-Ishlinskii)."""
    widths = width_nT * np.arange(1, operators + 1)[:, None] / operators
    state = np.full((operators, 3), np.nan)

    def effect(moment: Moment, seen: Array) -> Array:
        out = np.empty_like(seen)
        if np.isnan(state).any() and len(seen):
            state[:] = seen[0]
        for row, value in enumerate(seen):
            np.clip(state, value - widths, value + widths, out=state)
            out[row] = state.mean(axis=0)
        return share * (out - seen)

    return effect


def hysteresis_preisach(_: Rng, moment_nT: float = 400.0, span_nT: float = 60_000.0, grid: int = 12) -> Effect:
    """Relays of all up and down thresholds on a grid (Preisach), together worth ± `moment_nT`."""
    ticks = np.linspace(-span_nT, span_nT, grid)
    up, down = (v[np.triu_indices(grid, 1)] for v in np.meshgrid(ticks, ticks))
    state = np.where(up + down < 0, 1.0, -1.0)[:, None] * np.ones(3)

    def effect(_: Moment, seen: Array) -> Array:
        out = np.empty_like(seen)
        for row, value in enumerate(seen):
            state[value >= up[:, None]] = 1.0
            state[value <= down[:, None]] = -1.0
            out[row] = state.mean(axis=0)
        return moment_nT * out

    return effect


def first_order_lag(_: Rng, tau_s: float = 0.25) -> Effect:
    """The sensor follows the field with a time constant (exact where the field is linear between samples)."""
    last_t, last_in, last_out = np.nan, np.zeros(3), np.zeros(3)

    def effect(moment: Moment, seen: Array) -> Array:
        nonlocal last_t, last_in, last_out
        out = np.empty_like(seen)
        for row, (t, value) in enumerate(zip(moment.t_s, seen, strict=True)):
            step = t - last_t
            if not step < 10 * tau_s:
                last_out = value
            else:
                slope, fading = (value - last_in) / step, np.exp(-step / tau_s)
                steady = value - slope * tau_s
                last_out = steady + (last_out - last_in + slope * tau_s) * fading
            last_t, last_in, out[row] = t, value, last_out
        return out - seen

    return effect


def periodic(_: Rng, period_s: float = 37.0, nT: Three = (120.0, -90.0, 60.0), phase_rad: float = 0.7) -> Effect:
    """A disturbance with a period of its own."""
    return lambda moment, seen: np.outer(np.sin(2 * np.pi * moment.t_s / period_s + phase_rad), nT)


def random_walk(rng: Rng, nT_per_root_s: float = 4.0) -> Effect:
    """An offset that wanders."""
    path = walk(rng, nT_per_root_s)
    seconds = np.arange(len(path), dtype=float)
    return lambda moment, seen: np.column_stack([np.interp(moment.t_s, seconds, path[:, k]) for k in range(3)])


def telegraph_noise(rng: Rng, nT: Three = (150.0, 100.0, -120.0), mean_s: float = 45.0) -> Effect:
    """An offset that jumps between two states, as a defect in a sensor does."""
    times, states = telegraph(rng, mean_s)
    return lambda moment, seen: np.outer(states[np.searchsorted(times, moment.t_s) % len(states)], nT)


SENSOR: dict[str, Callable[..., Effect]] = {
    "offset-current": offset_current,
    "offset-current-squared": offset_current_squared,
    "offset-temperature": offset_temperature,
    "offset-channel": offset_channel,
    "gain-temperature": gain_temperature,
    "offset-drift": offset_drift,
    "offset-step": offset_step,
    "offset-mode": offset_mode,
    "nonlinearity": nonlinearity,
    "soft-saturation": soft_saturation,
    "cross-field": cross_field,
    "hysteresis": hysteresis,
    "hysteresis-preisach": hysteresis_preisach,
    "first-order-lag": first_order_lag,
    "periodic": periodic,
    "random-walk": random_walk,
    "telegraph-noise": telegraph_noise,
}
