"""Coils off: how steady, how quiet and how free of mains the room is, and whether it is fit for the job."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.parameters import Limits
from labcal.bench.samples import Samples, samples
from labcal.bench.steps import Procedure, Work, coils_off, measured, record
from labcal.record.stream import Event, Stream

Array = NDArray[np.float64]
BLIND_HZ = 0.05  # an alias nearer to zero than this looks like a field


def ambient(
    bench: Bench,
    *,
    duration_s: Annotated[float, Limits(10, 86_400, unit="s"), "how long to listen"] = 60.0,
    mains_hz: Annotated[float, Limits(16, 61, unit="Hz"), "the mains"] = 50.0,
    harmonics: Annotated[int, Limits(1, 10), "of the mains, looked for"] = 3,
    rate_deg_per_s: Annotated[float, Limits(0.1, 60, unit="deg/s"), "of the rotation that is planned"] = 2.4,
    drift_nT_per_min: Annotated[float, Limits(0.01, 1e5, unit="nT/min"), "fastest drift that passes"] = 20.0,
    noise_nT: Annotated[float, Limits(0.01, 1e5, unit="nT"), "largest noise of one sample that passes"] = 20.0,
) -> Procedure:
    """Measure mean, drift, noise and mains of the room, and say whether it is fit for the job."""
    yield from coils_off(bench)
    blocks = yield from record(bench, duration_s)
    reference, faults = samples(blocks, "reference"), list[str]()
    for axis, name in enumerate(reference.columns):
        faults += yield from _one_component(bench, reference, axis, name, drift_nT_per_min, noise_nT)
    streams: tuple[Stream, ...] = ("reference", "dut")
    for stream in streams:
        rate = 1 / samples(blocks, stream).period_s
        for n in range(1, harmonics + 1):
            faults += yield from _alias(bench, stream, rate, n * mains_hz, rate_deg_per_s / 360)
    verdict = "the room is not fit for the job: " + "; ".join(faults) if faults else "the room is fit for the job"
    yield Event(bench.clock.now(), "ambient", verdict, {"faults": faults})


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
    if min(abs(folded - n * turn_hz) for n in (1, 2)) < turn_hz / 10:
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
