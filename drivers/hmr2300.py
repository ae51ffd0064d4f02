"""Honeywell HMR2300 three-axis magnetoresistive magnetometer, ASCII and binary, polled and continuous."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Annotated, Literal

import numpy as np
from pydantic import Field

from drivers.framing.hmr2300 import LENGTH, NT_PER_COUNT, BinaryFrames, BinaryReplies, TextFrames, samples_again
from drivers.framing.hmr2300_words import ESC, Words
from drivers.framing.mishaps import Mishaps, overloaded
from drivers.framing.polling import Polled, Polls
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import Positive
from labcal.bench.links import Link
from labcal.record.stream import Block, Event

RATES = (10, 20, 25, 30, 40, 50, 60, 100, 123, 154)
FASTEST = {("ascii", 9600): 30, ("ascii", 19200): 50, ("binary", 9600): 100, ("binary", 19200): 154}
FULL_SCALE = 30_000
COLUMNS = ("ref_x", "ref_y", "ref_z")


@dataclass(frozen=True, slots=True)
class Settings:
    """`rate` in samples per second. `set_reset`: alternate the bridge's polarity; calibrate in the mode used.

    `invalid`: readings after the start that are dropped, for those after a pulse are not valid (data sheet, p. 10).
    """

    id: Annotated[int, Field(ge=0, le=98)] = 0
    format: Literal["ascii", "binary"] = "ascii"
    mode: Literal["continuous", "polled"] = "continuous"
    rate: int = 20
    baud: int = 9600
    set_reset: bool = True
    invalid: Annotated[int, Field(ge=0)] = 3
    timeout_s: Positive = 0.5

    def __post_init__(self) -> None:
        fastest = FASTEST.get((self.format, self.baud), 0)
        if self.rate not in RATES or self.rate > fastest:
            raise ValueError(
                f"rate {self.rate} is not one of {RATES} up to {fastest} ({self.format}, {self.baud} baud)"
            )


class Hmr2300(Polled):
    """Counts become nT at 15000 a gauss. A reading at full scale is a fault, not a value."""

    roles = ("reference",)
    parse_again = staticmethod(samples_again)
    never = (rb"\*\d\d(SP|RST|D|ID=\d|!BR|ZN|ZR|[TVZ]\r)",)  # what is kept when it is off, and toggles

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._streaming, self._polls, self._mishaps = False, Polls(clock, settings.rate), Mishaps(name)
        self._words = Words(name, link, clock, settings.id, settings.timeout_s)
        self._frames: TextFrames | BinaryFrames | BinaryReplies = TextFrames()

    @property
    def rate_hz(self) -> float:
        """Samples per second."""
        return self.settings.rate

    def rates_hz(self) -> tuple[float, ...]:
        """What its line bears, the slowest first."""
        return tuple(rate for rate in RATES if rate <= FASTEST[self.settings.format, self.settings.baud])

    def set_rate(self, rate_hz: float) -> None:
        """Sample so fast from now on. Raises ValueError where the line does not bear it."""
        self.settings = replace(self.settings, rate=int(rate_hz))
        if self._streaming:
            self.start()

    def identify(self) -> Identity:
        """Ask for its serial number and firmware; it must not be streaming."""
        self._words.hush()
        serial, version = self._words.ask("#", "SER#"), self._words.ask("F", "S/W vers:")
        return Identity("Honeywell", "HMR2300", serial, version)

    def start(self) -> None:
        """Set format, rate and the modes that calibration needs, then begin."""
        s = self.settings
        self._words.hush()
        for words, reply in (
            ("A" if s.format == "ascii" else "B", "ASCII_ON" if s.format == "ascii" else "BINARY_ON"),
            ("ZF", "ZERO_OFF"),
            ("VF", "AVG_OFF"),
            ("TN" if s.set_reset else "TF", "S/R_ON" if s.set_reset else "S/R_OFF"),
            (f"R={s.rate}", "OK"),
        ):
            self._words.change(words, reply)
        self._streaming, self._polls = True, Polls(self._clock, s.rate)
        if s.mode == "polled":
            self._polls.start()
        binary = BinaryReplies if s.mode == "polled" else BinaryFrames
        self._begin((binary if s.format == "binary" else TextFrames)(s.invalid))

    def read_until(self, t_s: float) -> list[Block]:
        """Samples that arrived up to `t_s` [nT, its own axes]."""
        polled = self.settings.mode == "polled"
        frames = self._frames.feed(self._polled(t_s) if polled else self._link.receive(t_s))
        for stamp in self._frames.bad:
            self._mishaps.note("lost sync" if self._frames.lost else "bad frame", stamp)
        self._frames.bad.clear()
        if self._frames.lost:
            self._words.silenced()
            self._begin(BinaryFrames(self.settings.invalid, self._frames.familiar))  # its first byte is a frame's
        if not frames:
            return []
        counts = np.array([c for _, c, _ in frames], dtype=float)
        if np.abs(counts).max() >= FULL_SCALE:
            raise overloaded(self.name)
        raw = b"".join(frame for _, _, frame in frames)
        return [Block("reference", self.name, COLUMNS, np.array([t for t, _, _ in frames]), counts * NT_PER_COUNT, raw)]

    def events(self) -> list[Event]:
        """Frames that were no good."""
        return self._mishaps.events()

    def stop(self) -> None:
        """End the stream."""
        self._streaming = False
        self._polls.stop()
        self._link.send(ESC)

    def make_safe(self) -> None:
        """End the stream."""
        self.stop()

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _begin(self, frames: TextFrames | BinaryFrames | BinaryReplies) -> None:
        self._frames = frames
        if self.settings.mode == "continuous":
            self._words.send("C")

    def _polled(self, t_s: float) -> list[tuple[float, bytes]]:
        end = LENGTH if self.settings.format == "binary" else b"\r"
        return [(stamp, self._words.poll(end)) for stamp in self._polls.due(t_s)]
