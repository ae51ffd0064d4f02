"""A Twinleaf VMR: describes its stream when it is asked to, counts its samples, answers questions by their names."""

from __future__ import annotations

import struct
from collections.abc import Mapping
from typing import Any

import numpy as np

from drivers.emulators.line import Lab, Pieces, Replies
from drivers.emulators.streaming import SampleClock
from drivers.framing import slip, tio
from labcal.bench.driver_kit.framing import Lines

RATE_HZ, REPLY_S = 40.0, 0.005
FLOAT32, NO_SUCH = 0x42, 2
ABOUT = {
    b"dev.desc": b"Twinleaf VMR R8 (A1B2)", b"dev.name": b"VMR", b"dev.model": b"VMR", b"dev.serial": b"A1B2",
    b"dev.firmware.serial": b"vmr-2.7.1", b"rpc.list": struct.pack("<H", 0), b"dev.session": b"\1\2\3\4",
}  # fmt: skip
SOURCES = ((1, "vector", 3, "x,y,z", "Field", "nT"), (2, "therm", 1, "", "Temperature", "C"))


class TwinleafEmulator(Replies):
    """Field and temperature as float32, forty times a second, whether anybody listens or not."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        super().__init__()
        self._lab, self._delay_s, self._beat = lab, settings.delay_s, SampleClock(RATE_HZ)
        self._lines = Lines(slip.END, longest=2 * tio.LONGEST)

    def take(self, t_s: float, data: bytes) -> None:
        """Bytes from the host; what is no packet is passed over."""
        for _, line in self._lines.feed([(t_s, data)]):
            if line and (packet := tio.parse(line)) is not None and packet[0] == tio.REQUEST and len(packet[1]) >= 4:
                self._answer(t_s + REPLY_S, packet[1])

    def due_s(self) -> float:
        """When it sends next."""
        return min(super().due_s(), self._beat.next_s())

    def emit(self, until_s: float) -> Pieces:
        """Replies and samples that are due."""
        times = self._beat.due(until_s)
        rows = self._lab.reference_nT(times - self._delay_s) * self._lab.reference_nT_per_unit if len(times) else []
        samples = [(t, self._sample(t, row)) for t, row in zip(times.tolist(), rows, strict=True)]
        return sorted(super().emit(until_s) + samples, key=lambda piece: piece[0])

    def _sample(self, t_s: float, field_nT: Any) -> bytes:
        data = struct.pack("<I4f", round(t_s * RATE_HZ), *np.asarray(field_nT), 21.5)
        return tio.packet(tio.DATA, data)

    def _answer(self, t_s: float, asked: bytes) -> None:
        number, length = asked[:2], int.from_bytes(asked[2:4], "little") & 0x7FFF
        name, argument = asked[4 : 4 + length], asked[4 + length :]
        if name not in (*ABOUT, b"data.send_all") or argument:
            self.say(t_s, tio.packet(tio.REFUSAL, number + struct.pack("<H", NO_SUCH)))
            return
        if name == b"data.send_all":
            for kind, payload in _description():
                self.say(t_s, tio.packet(kind, payload))
        self.say(t_s, tio.packet(tio.REPLY, number + ABOUT.get(name, b"")))


def _description() -> list[tuple[int, bytes]]:
    period_us = round(1e6 / RATE_HZ)
    sources = [tio.A_SOURCE.pack(n, 0, 1, 0, 0, 0, channels, FLOAT32) + "\t".join((name, *words)).encode()
               for n, name, channels, *words in SOURCES]  # fmt: skip
    parts = b"".join(tio.A_PART.pack(n, 0, 1, 0) for n, *_ in SOURCES)
    stream = tio.A_STREAM.pack(0, 0, 1, 0, 0, len(SOURCES), 0) + parts
    return [(tio.TIMEBASE, tio.A_TIMEBASE.pack(0, 0, 0, 0, period_us, 1, 0, 1e-6)),
            *((tio.SOURCE, source) for source in sources), (tio.STREAM, stream)]  # fmt: skip
