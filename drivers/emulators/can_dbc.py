"""A DUT that sends frames as its DBC has them, by cantools' own encoder."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import count
from typing import Any

from drivers.emulators.line import Lab
from drivers.emulators.streaming import Talker, dut_rows
from drivers.framing.columns import NT
from drivers.framing.dbc import database, found
from labcal.bench.links.canbus import HEAD


class CanDbcEmulator(Talker):
    """Each message that a signal is asked of, ten times a second; what does not fit into its signal is its end."""

    def __init__(self, lab: Lab, roles: Mapping[str, Mapping[str, Any]], settings: Any) -> None:
        self._messages, self._count = database(settings.file), count()
        self._signals = {name: found(settings.file, path) for name, path in settings.signals.items()}
        self._factor = dict.fromkeys("xyz", 1 / NT[settings.unit])
        super().__init__(dut_rows(lab, tuple(self._signals), settings), self._frame)

    def _frame(self, t_s: float, row: list[float]) -> bytes:
        values = {name: value * self._factor.get(name, 1.0) for name, value in zip(self._signals, row, strict=True)}
        if "count" in values:
            values["count"] = next(self._count) % (1 << self._signals["count"].bits)
        return b"".join(
            self._encoded(frame, values) for frame in dict.fromkeys(s.frame for s in self._signals.values())
        )

    def _encoded(self, frame: int, values: dict[str, float]) -> bytes:
        mine = {s.name: values[name] for name, s in self._signals.items() if s.frame == frame}
        (message,) = {s.message for s in self._signals.values() if s.frame == frame}
        known = self._messages.get_message_by_name(message)
        data = known.encode({s.name: _within(s, mine.get(s.name, 0.0)) for s in known.signals}, strict=False)
        return HEAD.pack(frame, len(data)) + bytes(data)


def _within(signal: Any, value: float) -> float:
    """The value, or the end of what the signal's bits can hold."""
    low, high = (
        (-(1 << signal.length - 1), (1 << signal.length - 1) - 1) if signal.is_signed else (0, (1 << signal.length) - 1)
    )
    ends = sorted(float(raw * signal.scale + signal.offset) for raw in (low, high))
    return max(ends[0], min(ends[1], value))
