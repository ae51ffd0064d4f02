"""Twinleaf VMR vector magnetometers by their own packets (TIO in SLIP on a serial line), streaming."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from drivers.framing import slip, tio
from drivers.framing.columns import OwnClock
from drivers.framing.listener import Pieces
from drivers.framing.mishaps import Mishaps, overloaded
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.framing import Lines
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.driver_kit.settings import NotNegative, Positive
from labcal.bench.links import Link, abridged
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

ASKED = (b"dev.desc", b"dev.serial", b"dev.firmware.serial", b"data.send_all")
UNITS_NT = {"nT": 1.0, "uT": 1e3, "µT": 1e3, "mG": 1e2, "T": 1e9}
BEAT_S, DESCRIBED_S = 0.5, 3.0


@dataclass(frozen=True, slots=True)
class Settings:
    """`source`: the stream. `unit_nT`: where it does not say it. `delay_s`: from its middle to its first byte."""

    source: str = "vector"
    unit_nT: NotNegative = 0.0
    full_scale_nT: Positive = 200_000.0
    delay_s: NotNegative = 0.0
    timeout_s: Positive = 1.0


class Twinleaf:
    """Samples keep the spacing of the device's own clock; one whose number is missing is reported as a gap."""

    roles = ("reference",)
    never = (tio.all_but(ASKED),)

    def __init__(self, name: str, link: Link, clock: Clock, settings: Settings) -> None:
        self.name, self.settings, self._link, self._clock = name, settings, link, clock
        self._mishaps, self._number, self._beat_s = Mishaps(name), 0, 0.0
        self._began = False
        self._begin()

    def identify(self) -> Identity:
        """Ask what it says of itself, and see that it has the stream."""
        said = self._ask(b"dev.desc")
        if not any(name in said.upper() for name in ("VMR", "TWINLEAF")):
            raise InstrumentError(
                f"{self.name}: {abridged(said)!r} answered, not a Twinleaf.", fault="another instrument"
            )
        return Identity("Twinleaf", said, self._ask(b"dev.serial"), self._ask(b"dev.firmware.serial"))

    def start(self) -> None:
        """Have it describe its stream, and begin. Raises InstrumentError where it has none of that name."""
        self._begin()
        self._link.flush()
        self._ask(b"data.send_all")
        deadline = self._clock.now() + DESCRIBED_S
        while self._description.place(self.settings.source) is None:
            if self._clock.now() > deadline:
                message = f"{self.name}: it has no stream {self.settings.source!r} of three numbers; it speaks of "
                raise InstrumentError(f"{message}{self._description.names()}.", fault="another instrument")
            self._packets(self._link.receive(self._clock.now() + 0.02))
        self._began = True

    def read_until(self, t_s: float) -> list[Block]:
        """Samples that came up to `t_s` [nT, its own axes]."""
        if self._began and self._clock.now() >= self._beat_s:  # without it a device may fall back into text
            self._link.send(tio.packet(tio.HEARTBEAT))
            self._beat_s = self._clock.now() + BEAT_S
        rows = [(stamp, data) for stamp, kind, data in self._packets(self._link.receive(t_s)) if kind == tio.DATA]
        place = self._description.place(self.settings.source)
        return [] if place is None else self._block(rows, place)

    def events(self) -> list[Event]:
        """What was lost or no good."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Say no more; it goes on by itself."""
        self._began = False

    make_safe = stop

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()

    def _begin(self) -> None:
        self._lines, self._description = Lines(slip.END, longest=2 * tio.LONGEST, skip_first=True), tio.Description()
        self._own, self._next, self._mishaps = OwnClock(self._mishaps), -1, Mishaps(self.name)

    def _packets(self, pieces: Pieces) -> list[tuple[float, int, bytes]]:
        """Stamp, type and payload of what is whole."""
        whole = [(stamp, line, tio.parse(line)) for stamp, line in self._lines.feed(pieces) if line]
        for stamp, _, good in whole:
            if good is None and self._began:
                self._mishaps.note("checksum", stamp)
        packets = [(stamp, *good) for stamp, _, good in whole if good is not None]
        for _, kind, payload in packets:
            self._description.take(kind, payload)
        return packets

    def _block(self, rows: list[tuple[float, bytes]], place: tio.RowLayout) -> list[Block]:
        good = [row for row in rows if self._whole(*row, place)]
        if not good:
            return []
        values = np.array([place.of(data) for _, data in good]) * self._nT(place)
        if np.abs(values).max() >= self.settings.full_scale_nT:
            raise overloaded(self.name)
        numbers = [self._counted(stamp, tio.number_of(data)) for stamp, data in good]
        stamps = np.array([stamp for stamp, _ in good]) - self.settings.delay_s
        t = self._own.tie(stamps, np.array(numbers) * place.period_s)
        return [Block("reference", self.name, ("ref_x", "ref_y", "ref_z"), t, values, b"".join(d for _, d in good))]

    def _whole(self, stamp: float, data: bytes, place: tio.RowLayout) -> bool:
        if not (whole := len(data) >= place.least and bool(np.isfinite(place.of(data)).all())):
            self._mishaps.note("bad frame", stamp)
        return whole

    def _counted(self, stamp: float, number: int) -> int:
        if 0 <= self._next < number:
            self._mishaps.note("gap", stamp, number - self._next)
        self._next = number + 1
        return number

    def _nT(self, place: tio.RowLayout) -> float:
        if unit_nT := self.settings.unit_nT or UNITS_NT.get(place.unit, 0.0):
            return unit_nT
        message = f"{self.name}: its unit is {place.unit!r}; state unit_nT in bench.toml."
        raise InstrumentError(message, fault="wrong unit", remedy="Look at its data sheet.")

    def _ask(self, name: bytes) -> str:
        """The answer to a question; "" where it does not know it. Raises InstrumentError (silent)."""
        self._number = self._number % 100 + 1
        mine = self._number.to_bytes(2, "little")
        self._link.send(tio.request(self._number, name))
        deadline = self._clock.now() + self.settings.timeout_s
        while self._clock.now() < deadline:
            for _, kind, payload in self._packets(self._link.receive(self._clock.now() + 0.02)):
                if kind in (tio.REPLY, tio.REFUSAL) and payload[:2] == mine:
                    return payload[2:].decode("utf-8", "replace").strip("\0 ") if kind == tio.REPLY else ""
        raise InstrumentError(f"{self.name}: no answer to {name.decode()}.", fault="silent",
                              remedy="Is it powered, and is the link in bench.toml the right one?")  # fmt: skip
