"""Coils off: how steady, how quiet and how free of mains the room is, and whether it is fit for the job."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.roles import Paced
from labcal.bench.samples import Samples, samples
from labcal.bench.steps import Procedure, Work, coils_off, measured, note, record, rest
from labcal.record.stream import Event, Stream

NEEDS, LASTS_MIN = "the cage as it will be used, coils off", 1

Array = NDArray[np.float64]
MAINS_OFF_HZ = 0.1  # how far the mains may be from its nominal frequency
ROTATION_HARMONICS = (1, 2, 3, 4)  # nonlinearity and hysteresis show up to here
BLIND_HZ = 0.05  # an alias nearer to zero than this looks like a field


def ambient(
    bench: Bench,
    *,
    duration_s: Annotated[float, Limits(10, 86_400, unit="s"), "how long to listen"] = 60.0,
    mains_hz: Annotated[float, Limits(16, 61, unit="Hz"), "the mains"] = 50.0,
    harmonics: Annotated[int, Limits(1, 10), "of the mains, looked for"] = 3,
    mains_s: Annotated[float, Limits(5, 600, unit="s"), "how long to listen for it, at the fastest rate"] = 20.0,
    mains_nT: Annotated[float, Limits(0.01, 1e5, unit="nT"), "largest amplitude of it that passes"] = 50.0,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of the rotation that is planned"] = 2.4,
    drift_nT_per_min: Annotated[float, Limits(0.01, 1e5, unit="nT/min"), "fastest drift that passes"] = 20.0,
    noise_nT: Annotated[float, Limits(0.01, 1e5, unit="nT"), "largest noise of one sample that passes"] = 20.0,
) -> Procedure:
    """Measure mean, drift, noise and mains of the room, and say whether it is fit for the job."""
    yield from coils_off(bench)
    faults = yield from _mains(bench, mains_hz, harmonics, mains_s, mains_nT)
    blocks = yield from rest(bench, "room", duration_s)
    reference = samples(blocks, "reference")
    for axis, name in enumerate(reference.columns):
        faults += yield from _one_component(bench, reference, axis, name, drift_nT_per_min, noise_nT)
    streams: tuple[Stream, ...] = ("reference", "dut")
    for stream in streams:
        rate = 1 / samples(blocks, stream).period_s
        for n in range(1, harmonics + 1):
            faults += yield from _alias(bench, stream, rate, n * mains_hz, rate_deg_per_s / 360)
    verdict = "the room is not fit for the job: " + "; ".join(faults) if faults else "the room is fit for the job"
    yield Event(bench.clock.now(), "ambient", verdict, {"faults": faults})


def _mains(bench: Bench, mains_hz: float, harmonics: int, seconds: float, limit_nT: float) -> Work[list[str]]:
    """The amplitude of the mains and its harmonics, with the reference as fast as its line bears."""
    with ExitStack() as afterwards:
        if isinstance(reference := bench.reference, Paced):
            afterwards.callback(reference.set_rate, reference.rate_hz)
            reference.set_rate(max(reference.rates_hz()))
        fast, faults = samples((yield from record(bench, seconds)), "reference"), list[str]()
        rate, told = 1 / fast.period_s, dict[int, float]()
        for n in range(1, harmonics + 1):
            seen, folded = tone(fast, n * mains_hz, n * MAINS_OFF_HZ), alias(n * mains_hz, rate)
            same = [f"{k * mains_hz:g} Hz" for k, at in told.items() if abs(at - folded) < (k + n) * MAINS_OFF_HZ]
            if seen is None or same:
                other = same[0] if same else "a steady field"
                yield note(bench, f"{n * mains_hz:g} Hz is not told from {other} at {rate:.4g}/s")
                continue
            told[n] = folded
            found = yield from measured(bench, f"amplitude of {n * mains_hz:g} Hz", *seen, "nT", limit_nT)
            faults += [f"{found.name} {found.value:.3g} nT"] if found.verdict == "FAIL" else []
    return faults


def tone(seen: Samples, frequency_hz: float, off_hz: float) -> tuple[float, float] | None:
    """Amplitude [nT] of a tone within `off_hz` of `frequency_hz`, folded where it is sampled, and its uncertainty.

    The largest length over the components of A = 2/n Σ b exp(−2πi f t) among frequencies a quarter of 1 / duration
    apart; u = σ sqrt(2/n), one component's, with σ from what a straight line leaves. None where the tone folds
    nearer to zero than the record tells, and is a part of the mean.
    """
    rate, span_s = 1 / seen.period_s, float(np.ptp(seen.t_s))
    folded = alias(frequency_hz, rate)
    if folded - off_hz < 1.5 / span_s:
        return None
    columns = np.column_stack([np.ones(len(seen)), seen.t_s - seen.t_s.mean()])
    left = seen.values - columns @ np.linalg.lstsq(columns, seen.values, rcond=None)[0]
    tried = np.arange(folded - off_hz, folded + off_hz + 0.25 / span_s, 0.25 / span_s)
    spectrum = 2 / len(seen) * np.exp(-2j * np.pi * np.outer(tried, seen.t_s)) @ left
    return float(np.linalg.norm(spectrum, axis=1).max()), float(left.std() * np.sqrt(2 / len(seen)))


def _one_component(
    bench: Bench, reference: Samples, axis: int, name: str, drift_nT_per_min: float, noise_nT: float
) -> Work[list[str]]:
    slope, u_slope = trend(reference.t_s, reference.values[:, axis])
    sigma = noise(reference.values[:, axis])
    density = sigma * np.sqrt(2 * reference.period_s)
    yield from measured(bench, f"mean {name}", reference.mean[axis], reference.u_mean[axis], "nT")
    drift = yield from measured(bench, f"drift {name}", 60 * slope, 60 * u_slope, "nT/min", drift_nT_per_min)
    quiet = yield from measured(bench, f"noise {name}", sigma, sigma / np.sqrt(2 * len(reference)), "nT", noise_nT)
    yield from measured(bench, f"noise density {name}", density, density / np.sqrt(2 * len(reference)), "nT/√Hz")
    return [f"{m.name} {m.value:.3g} {m.unit}" for m in (drift, quiet) if m.verdict == "FAIL"]


def _alias(bench: Bench, stream: str, rate_hz: float, mains_hz: float, turn_hz: float) -> Work[list[str]]:
    """Where the mains falls when it is sampled so slowly: near zero, or on a harmonic of the rotation, it is unseen."""
    folded = alias(mains_hz, rate_hz)
    yield from measured(bench, f"{mains_hz:g} Hz in {stream} samples", folded, 0.0, "Hz")
    if folded < BLIND_HZ:
        return [f"{mains_hz:g} Hz is seen as a steady field at {rate_hz:.4g} {stream} samples/s"]
    if min(abs(folded - n * turn_hz) for n in ROTATION_HARMONICS) < turn_hz / 10:
        return [f"{mains_hz:g} Hz falls on the rotation at {rate_hz:.4g} {stream} samples/s"]
    return []


def alias(frequency_hz: float, rate_hz: float) -> float:
    """The frequency at which a tone appears when it is sampled at `rate_hz`: |f − round(f / rate) rate|."""
    return abs(frequency_hz - round(frequency_hz / rate_hz) * rate_hz)


def trend(t_s: Array, values: Array) -> tuple[float, float]:
    """Slope [1/s] of a straight line and its standard uncertainty, by least squares with white residuals."""
    t = t_s - t_s.mean()
    slope = float(t @ values / (t @ t))
    left = values - values.mean() - slope * t
    return slope, float(np.sqrt(left @ left / (len(t) - 2) / (t @ t)))


def noise(values: Array) -> float:
    """Standard deviation of one sample from successive differences (von Neumann): drift does not enter."""
    return float(np.sqrt(np.mean(np.diff(values) ** 2) / 2))
