"""The field as a simulator outside wants it: followed as fast as the coils settle, with latency and jitter measured."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import asdict

import numpy as np
from numpy.typing import NDArray

from labcal.bench.bench import Bench
from labcal.bench.config import AXES
from labcal.bench.steps import (
    Plan,
    Procedure,
    Work,
    coils_off,
    energise,
    measure_ambient,
    measured,
    note,
    ready,
    recorded,
)
from labcal.bench.streams.field_datagrams import WantedField
from labcal.bench.streams.field_source import FieldSource, open_line
from labcal.errors import InstrumentError
from labcal.record.run import Segment
from labcal.record.stream import Block, Event

Array = NDArray[np.float64]
LISTEN_S = 0.02  # between two looks at the source while nothing new is there
PATIENT_S = 0.2  # likewise, before the first
AMBIENT, WAIT = ("ambient field", 5.0), "wait for the source"  # steps
FIRST_S = 60.0  # for the simulator to be started, with the coils at zero


class Followed:
    """What came of it: the reference less the field wanted last at that moment [nT], and how long each field took."""

    def __init__(self) -> None:
        self.latencies_s: list[float] = []  # from a field's arrival until it stood
        self._wanted: list[WantedField] = []  # the one that held at the last sample, and those after it
        self._n, self._squares = 0, 0.0

    def want(self, wanted: Sequence[WantedField]) -> None:
        """Fields as they came."""
        self._wanted += wanted

    def see(self, block: Block) -> None:
        """Take in what the reference has sent since the first field stood."""
        if block.stream != "reference" or not len(block):
            return
        arrived = [wanted.arrived_s for wanted in self._wanted]
        holds = np.maximum(np.searchsorted(arrived, block.t_s, side="right") - 1, 0)
        if self.latencies_s:
            self._n += len(block)
            self._squares += float(np.sum((block.values - [self._wanted[k].b_nT for k in holds]) ** 2))
        self._wanted = self._wanted[holds[-1] :]

    @property
    def rms_nT(self) -> tuple[float, float]:
        """Root mean square of the tracking error, and its standard uncertainty. Raises InstrumentError (silent)."""
        if not self._n:
            raise InstrumentError("no field stood for as long as one sample of the reference.", fault="silent")
        rms = float(np.sqrt(self._squares / self._n))
        return rms, rms / float(np.sqrt(2 * self._n))


def follow(bench: Bench, url: str, duration_s: float, silent_s: float, max_age_s: float, limit_nT: float) -> Procedure:
    """Follow the source until it ends, or for `duration_s`; coils to zero where it is not to be believed."""
    plan = Plan((AMBIENT, (WAIT, FIRST_S), ("play", duration_s)), frozenset({WAIT}))
    followed = Followed()
    with ExitStack() as afterwards:
        afterwards.callback(bench.cage.zero)  # the undo, before anything is energised
        link = open_line(url, bench.clock)
        afterwards.callback(link.close)
        yield plan.begin(bench, AMBIENT[0])
        yield from measure_ambient(bench, AMBIENT[1])
        yield plan.begin(bench, WAIT)
        largest = min(bench.config.cage.limits.field_nT, bench.config.dut.limits.field_nT or np.inf) / 1000
        yield from ready(bench, f"Fields up to {largest:g} µT are played as {url} wants them. Hands off?")
        source = FieldSource(
            link, bench.clock, refuse=bench.cage.refuse_beyond_limits, ramp_s=lambda step: ramp_s(bench, step),
            silent_s=FIRST_S, max_age_s=max_age_s,
        )  # fmt: skip
        yield from _first(bench, source)
        source.silent_s = silent_s
        yield plan.begin(bench, "play")
        with watched(bench, source.look):
            yield from recorded(bench, Segment("play", "free"), _followed(bench, source, followed, duration_s))
        yield from coils_off(bench)
    yield from _report(bench, source, followed, limit_nT)


def ramp_s(bench: Bench, step_nT: Array) -> float:
    """How long the coils need for a step of the field (3,) [nT] at their own ramp."""
    step_A = np.abs(np.linalg.solve(bench.cage.matrix_nT_per_A, step_nT))
    limits = zip(AXES, bench.config.cage.limits.ramp_A_per_s, strict=True)
    rates = [min(limit, bench.cage.supplies[axis].ramp_A_per_s) for axis, limit in limits]
    return float(np.max(step_A / rates))


@contextmanager
def watched(bench: Bench, look: Callable[[], None]) -> Iterator[None]:
    """Have `look` called whenever anybody waits, in the middle of a ramp too: what it raises ends the waiting."""
    before = bench.look

    def both() -> None:
        before()
        look()

    bench.look = both
    try:
        yield
    finally:
        bench.look = before


def _first(bench: Bench, source: FieldSource) -> Work[None]:
    """Wait for the first field, with the coils at zero. It is set like any other."""
    source.begin()
    while source.counts.received == 0:
        yield from bench.stream_until(bench.clock.now() + PATIENT_S)
        source.look()


def _followed(bench: Bench, source: FieldSource, followed: Followed, duration_s: float) -> Work[None]:
    """Set the newest field, wait until it stands, tell the source, and take the newest again."""
    end_s = bench.clock.now() + duration_s
    while bench.clock.now() < end_s:
        followed.want(taken := source.taken())
        if taken:
            yield from _set(bench, source, followed, taken[-1])
        elif source.ended:
            return
        yield from _heard(bench, 0.0 if taken else LISTEN_S, followed)


def _heard(bench: Bench, seconds: float, followed: Followed) -> Work[None]:
    """Hand on what the streams have sent until `seconds` from now."""
    blocks = bench.stream_until(bench.clock.now() + seconds)
    for block in blocks:
        followed.see(block)
    yield from blocks


def _set(bench: Bench, source: FieldSource, followed: Followed, wanted: WantedField) -> Work[None]:
    yield from energise(bench, wanted.b_nT)
    if not followed.latencies_s:  # what came in the first ramp is no error
        yield from bench.stream_until(bench.clock.now())
    latency_s = bench.clock.now() - wanted.arrived_s
    followed.latencies_s.append(latency_s)
    source.update(wanted, latency_s, bench.cage.matrix_nT_per_A @ bench.cage.flowing_A + bench.cage.ambient_nT)
    text = f"field number {wanted.number} stands {latency_s:.3f} s after it came"
    data = {"number": wanted.number, "source_s": wanted.t_s, "arrived_s": wanted.arrived_s, "latency_s": latency_s}
    yield Event(bench.clock.now(), "field-source", text, data)


def _report(bench: Bench, source: FieldSource, followed: Followed, limit_nT: float) -> Work[None]:
    """Error, latency and jitter into the record, and what was lost on the way."""
    latency, n = np.array(followed.latencies_s), len(followed.latencies_s)
    rms, u_rms = followed.rms_nT
    yield note(bench, "Not covered by the uncertainty of the tracking error: the reference's own errors.")
    yield from measured(bench, "rms tracking error", rms, u_rms, "nT", limit_nT)
    if n > 1:
        scatter = float(latency.std(ddof=1))
        yield from measured(bench, "latency", float(latency.mean()), scatter / np.sqrt(n), "s")
        yield from measured(bench, "jitter of the latency", scatter, scatter / np.sqrt(2 * (n - 1)), "s")
    if (received := source.counts.received) > 1:
        jitter = source.offsets.jitter_s
        yield from measured(bench, "jitter of the source", jitter, jitter / np.sqrt(2 * (received - 1)), "s")
    data = asdict(source.counts) | {"set": n, "largest_latency_s": float(latency.max())}
    said = ", ".join(f"{count} {name}" for name, count in asdict(source.counts).items())
    yield Event(bench.clock.now(), "field-source", f"{said}; {n} fields set", data)
