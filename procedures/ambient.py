"""Coils off: how steady, how quiet and how free of mains the room is, and whether it is fit for the job."""

from __future__ import annotations

from contextlib import ExitStack
from functools import partial
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.driver_kit.roles import Paced
from labcal.bench.parameters import Limits
from labcal.bench.stated import as_positions
from labcal.bench.steps import (
    Plan,
    Procedure,
    Work,
    coils_off,
    listen,
    measured,
    note,
    record,
    recorded,
    take_ambient,
)
from labcal.bench.streams.running import Running
from labcal.bench.streams.samples import Samples, samples
from labcal.earth.wmm import FIRST_YEAR, LAST_YEAR, wmm
from labcal.errors import InstrumentError
from labcal.record import Run
from labcal.record.run import Segment
from labcal.record.stream import Block, Event, Measurement, Stream
from labcal.uncertainty.verdicts import u_declared, uncovered

NEEDS, LASTS_MIN = "the cage as it will be used, coils off", 1

Array = NDArray[np.float64]
MAINS_OFF_HZ = 0.1  # how far the mains may be from its nominal frequency
ROTATION_HARMONICS = (1, 2, 3, 4)  # nonlinearity and hysteresis show up to here
FEWEST = 3  # samples that a trend is estimated from
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
    plan = Plan((("mains", mains_s), ("room", duration_s)))
    yield plan.begin(bench, "mains")
    yield from coils_off(bench)
    faults = yield from _mains(bench, mains_hz, harmonics, mains_s, mains_nT)
    yield plan.begin(bench, "room")
    room = yield from _heard(bench, duration_s)
    take_ambient(bench, room["reference"].mean)
    faults += yield from _components(bench, room["reference"], drift_nT_per_min, noise_nT)
    for stream, seen in room.items():
        for n in range(1, harmonics + 1):
            faults += yield from _alias(bench, stream, 1 / seen.period_s, n * mains_hz, rate_deg_per_s / 360)
    verdict = "the room is not fit for the job: " + "; ".join(faults) if faults else "the room is fit for the job"
    verdict += yield from _beside_the_model(bench, room["reference"])
    yield Event(bench.clock.now(), "ambient", verdict, {"faults": faults})


def _heard(bench: Bench, seconds: float) -> Work[dict[Stream, Running]]:
    """Record the room as a segment; returns what reference and DUT read. Raises InstrumentError for too few samples."""
    streams: tuple[Stream, ...] = ("reference", "dut")
    room = {stream: Running(stream) for stream in streams}

    def see(block: Block) -> None:
        for seen in room.values():
            seen.take(block)

    yield from recorded(bench, Segment("room", "static"), listen(bench, seconds, see))
    for stream, seen in room.items():
        if len(seen) < FEWEST:
            raise InstrumentError(
                f"{stream}: {len(seen)} samples came in {seconds:g} s, too few to say anything.",
                fault="silent",
                remedy="Look at its power and its cable, or listen for longer.",
            )
    return room


def _mains(bench: Bench, mains_hz: float, harmonics: int, seconds: float, limit_nT: float) -> Work[list[str]]:
    """The amplitude of the mains and its harmonics, with the reference as fast as its line bears."""
    with ExitStack() as afterwards:
        if isinstance(reference := bench.reference, Paced):
            afterwards.callback(reference.set_rate, reference.rate_hz)
            reference.set_rate(max(reference.rates_hz()))
        fast, faults = samples((yield from record(bench, seconds)), "reference"), list[str]()
        rate, at_Hz = 1 / fast.period_s, dict[int, float]()
        for n in range(1, harmonics + 1):
            seen, folded = tone(fast, n * mains_hz, n * MAINS_OFF_HZ), alias(n * mains_hz, rate)
            same = [f"{k * mains_hz:g} Hz" for k, at in at_Hz.items() if abs(at - folded) < (k + n) * MAINS_OFF_HZ]
            if seen is None or same:
                other = same[0] if same else "a steady field"
                yield note(bench, f"{n * mains_hz:g} Hz is not distinguishable from {other} at {rate:.4g}/s")
                continue
            at_Hz[n] = folded
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
    spectrum = np.array([2 / len(seen) * np.exp(-2j * np.pi * f * seen.t_s) @ left for f in tried])
    return float(np.linalg.norm(spectrum, axis=1).max()), float(left.std() * np.sqrt(2 / len(seen)))


def _components(bench: Bench, room: Running, drift_nT_per_min: float, noise_nT: float) -> Work[list[str]]:
    """Mean, drift and noise of each component of the reference; returns what is beyond its limit, in words.

    The mean is as uncertain as all that is declared of the reference; a drift and a noise are not.
    """
    if left := uncovered(_mean_as_run(bench, room)):
        yield note(bench, left)
    beyond, root = list[Measurement](), np.sqrt(2 * len(room))
    density = room.noise * np.sqrt(2 * room.period_s)
    rows = zip(room.columns, room.mean, room.u_mean, *room.trend(), room.noise, density, strict=True)
    for number, (name, mean, noise, slope, u_slope, sigma, per_root_Hz) in enumerate(rows):
        u = float(np.hypot(noise, u_declared(_mean_as_run(bench, room), partial(_component, number))))
        yield from measured(bench, f"mean {name}", mean, u, "nT")
        drift = yield from measured(bench, f"drift {name}", 60 * slope, 60 * u_slope, "nT/min", drift_nT_per_min)
        quiet = yield from measured(bench, f"noise {name}", sigma, sigma / root, "nT", noise_nT)
        yield from measured(bench, f"noise density {name}", per_root_Hz, per_root_Hz / root, "nT/√Hz")
        beyond += [m for m in (drift, quiet) if m.verdict == "FAIL"]
    return [f"{m.name} {m.value:.3g} {m.unit}" for m in beyond]


def _mean_as_run(bench: Bench, room: Running) -> Run:
    """The mean as the reference tells it: a vector's components, or a magnitude."""
    return as_positions(bench, room.mean[None] if len(room.mean) == 3 else room.mean)


def _component(number: int, run: Run) -> float:
    return float((run.magnitude_nT if run.reference_vector is None else run.reference_vector[0])[number])


def _magnitude(run: Run) -> float:
    return float(run.magnitude_nT[0])


def _beside_the_model(bench: Bench, room: Running) -> Work[str]:
    """Magnitude and what the World Magnetic Model expects at the bench's place; returns how they compare, in words.

    Nothing fails by it: a building's iron is worth more than the model's uncertainty. Silent where no place is stated.
    """
    found, (site, today) = float(np.linalg.norm(room.mean)), (bench.config.site, bench.clock.utc().date())
    if site is None:
        return ""
    if not FIRST_YEAR <= today.year < LAST_YEAR:
        return f"; of {today.year} no field is expected: WMM is here from {FIRST_YEAR} to {LAST_YEAR}"
    expected = wmm(site.latitude_deg, site.longitude_deg, site.height_m, today)
    noise = float(np.linalg.norm(room.u_mean * room.mean) / found)
    u = float(np.hypot(noise, u_declared(_mean_as_run(bench, room), _magnitude)))
    yield from measured(bench, "magnitude", found, u, "nT")
    yield from measured(bench, f"magnitude by {expected.model}", expected.magnitude_nT, expected.u_magnitude_nT, "nT")
    apart = found - expected.magnitude_nT
    said = f"; its {found:.0f} nT are {abs(apart):.0f} nT {'above' if apart > 0 else 'below'} what {expected.model}"
    said += f" expects outdoors ({expected.magnitude_nT:.0f} nT, U = {2 * expected.u_magnitude_nT:.0f} nT, k = 2)"
    if abs(apart) <= 2 * np.hypot(expected.u_magnitude_nT, u):
        return said
    return said + ": iron near by, or the reference's unit and scale"


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
