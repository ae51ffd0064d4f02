"""HMR2300 in binary, in fields whose bytes are the end sign's: a byte lost or too much gives no wrong value, ever."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from drivers.emulators.hmr2300 import Hmr2300Emulator
from drivers.framing.hmr2300 import LONG, BinaryFrames
from drivers.hmr2300 import NT_PER_COUNT, Hmr2300, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink

FRAMES = 160
PAUSE = 2  # frames that pass while the stream is begun again


@dataclass(frozen=True)
class Burst:
    """`count` bytes lost from byte `at` of frame `frame` on, or put in there. Not seven: that shifts nothing."""

    frame: int
    at: int
    count: int
    lost: bool


def field_of(kind: str, rng: np.random.Generator) -> np.ndarray:
    """Counts (FRAMES,) of one axis whose bytes are 0Dh now and then, or always."""
    noise = rng.integers(-2, 3, FRAMES) * rng.integers(0, 2)
    when = np.arange(FRAMES) > rng.integers(20, FRAMES - 20)
    upper, other = 0x0D00 + rng.integers(0x10, 0xF0) + noise, rng.integers(-20_000, 20_000) + noise
    if kind == "upper":
        return upper
    if kind == "lower":
        return np.full(FRAMES, (int(rng.integers(-90, 90)) << 8) | 0x0D)
    if kind == "both":
        return np.full(FRAMES, 0x0D0D)
    if kind == "comes":
        return np.where(when, upper, other)
    if kind == "goes":
        return np.where(when, other, upper)
    if kind == "sweeps":
        return 0x0D80 + np.round(np.linspace(-400, 400, FRAMES)).astype(int) + noise
    return other


KINDS = st.tuples(*[st.sampled_from(["upper", "lower", "both", "comes", "goes", "sweeps", "elsewhere"])] * 3).filter(
    lambda kinds: kinds != ("both",) * 3  # where every byte is the end sign no shift changes anything
)
BURSTS = st.builds(
    lambda first, second, apart: [first, Burst(first.frame + apart, second.at, second.count, second.lost)],
    *[st.builds(Burst, st.integers(0, 60), st.integers(0, 6), st.integers(1, 6), st.booleans())] * 2,
    st.integers(2 * LONG + PAUSE + 6, FRAMES - 61 - LONG - 4),
)  # fmt: skip


def chunks(counts: np.ndarray, bursts: Sequence[Burst], rng: np.random.Generator) -> list[bytes]:
    """The bytes that come in the time of each frame; what a burst loses reaches into the next frame."""
    data = [bytearray(row.astype(">i2").tobytes() + b"\r") for row in counts]
    for burst in bursts:
        if burst.lost:
            behind = data[burst.frame + 1][: max(0, burst.at + burst.count - 7)]
            del data[burst.frame][burst.at : burst.at + burst.count], data[burst.frame + 1][: len(behind)]
        else:
            put = rng.choice([0x0D, 0x0D, 0x00, 0xFF, *rng.integers(0, 256, 4)], burst.count)
            data[burst.frame][burst.at : burst.at] = put.astype(np.uint8).tobytes()
    return [bytes(chunk) for chunk in data]


def read(data: Sequence[bytes]) -> tuple[list[tuple[int, list[int]]], int]:
    """Samples as (frame in whose time it began, counts), and how often it was begun again."""
    frames, samples, again, wait = BinaryFrames(), [], 0, 0
    for number, chunk in enumerate(data):
        if wait:
            wait -= 1
            continue
        samples += [(int(t), counts) for t, counts, _ in frames.feed([(float(number), chunk)])]
        if frames.lost:
            frames, again, wait = BinaryFrames(familiar=frames.familiar), again + 1, PAUSE
    return samples, again


@pytest.mark.parametrize("examples", [50, pytest.param(6000, marks=pytest.mark.slow)])  # of 160 frames each
def test_bursts_lost_and_put_in_where_bytes_are_the_end_sign(examples: int) -> None:
    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(KINDS, BURSTS, st.integers(0, 2**32))
    def campaign(kinds: tuple[str, str, str], bursts: list[Burst], seed: int) -> None:
        rng = np.random.default_rng(seed)
        counts = np.column_stack([field_of(kind, rng) for kind in kinds])
        samples, again = read(chunks(counts, bursts, rng))
        wrong = [(number, row) for number, row in samples if row != counts[number].tolist()]
        assert not wrong
        assert again >= len(bursts)
        assert len(samples) >= FRAMES - again * (LONG + 2 + PAUSE) - LONG - 1

    campaign()


@pytest.mark.parametrize("kind", ["upper", "lower", "both", "comes", "goes", "sweeps", "elsewhere"])
def test_an_undisturbed_stream_loses_nothing_wherever_its_field_stands(kind: str) -> None:
    for axis in range(3):
        for seed in range(5):
            rng = np.random.default_rng(seed)
            counts = np.column_stack([field_of(kind if k == axis else "elsewhere", rng) for k in range(3)])
            samples, again = read(chunks(counts, [], rng))
            assert [row for _, row in samples] == [counts[number].tolist() for number, _ in samples]
            assert again <= 1  # where the first frames leave it in doubt, it is begun a second time
            assert len(samples) >= FRAMES - LONG - 1 - again * (LONG + 2 + PAUSE)


class Lossy(EmulatedLink):
    """A line that loses every 2000th byte of what it is sent."""

    def __init__(self, *parts: Any) -> None:
        super().__init__(*parts)
        self.came = 0

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        kept = []
        for t_s, data in super().receive(until_s):
            numbers = range(self.came + 1, self.came + 1 + len(data))
            self.came += len(data)
            kept.append((t_s, bytes(byte for n, byte in zip(numbers, data, strict=True) if n % 2000)))
        return kept


def test_the_driver_begins_the_stream_again_and_says_so() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))

    def field(times: np.ndarray) -> np.ndarray:
        return np.column_stack(
            [0x0D40 + np.round(1000 * times) % 7, np.round(50 * times) % 300, 0x0D0C + np.round(1000 * times) % 3]
        )

    emulator = Hmr2300Emulator(SimpleNamespace(reference_nT=field), {}, SimpleNamespace(id=0))
    line = Lossy("emulated://", emulator, clock)
    sensor = Hmr2300("ref", line, clock, Settings(format="binary", rate=50))
    sensor.start()
    blocks, events = [], []
    for _ in range(300):
        blocks += sensor.read_until(clock.now() + 0.2)
        events += sensor.events()
    times, counts = np.concatenate([b.t_s for b in blocks]), np.vstack([b.values for b in blocks]) / NT_PER_COUNT
    np.testing.assert_allclose(counts, field(times), atol=1e-6)
    assert {event.data["fault"] for event in events} == {"lost sync"}
    assert len(times) > 0.85 * 60 * 50
