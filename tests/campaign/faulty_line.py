"""A line on which things go wrong on command, byte for byte, between the host's end and the emulated instrument."""

from __future__ import annotations

import random
from dataclasses import dataclass, field
from typing import Any

from faulty_ends import End

LOOK_S = 0.002  # an emulator that does not foresee its next bytes is looked at so often


@dataclass(frozen=True)
class Trouble:
    """What is wrong with a line; nothing, as it stands here. Odds are of one piece of bytes."""

    request_late_s: float = 0.0  # the instrument obeys late
    reply_late_s: float = 0.0  # it obeys at once and answers late
    doubled_requests: bool = False
    doubled_replies: bool = False
    corrupt_requests: float = 0.0
    corrupt_replies: float = 0.0
    lost_requests: float = 0.0
    lost_replies: float = 0.0
    junk_bytes: int = 0  # without an end of line, at every look


WELL, DEAF, MUTE = Trouble(), Trouble(lost_requests=1.0), Trouble(lost_replies=1.0)


@dataclass
class FaultyLine:
    """`hears` is the instrument; `overhears` takes every byte as it was sent, whatever becomes of it on the way."""

    name: str
    end: End
    hears: Any
    overhears: Any
    trouble: Trouble = WELL
    chance: random.Random = field(default_factory=random.Random)
    log: list[tuple[float, str, str]] = field(default_factory=list)  # when, "sent"/"heard"/"said", the bytes
    _requests: list[tuple[float, bytes]] = field(default_factory=list)
    _replies: list[tuple[float, bytes]] = field(default_factory=list)

    def carry(self, now: float) -> None:
        """Carry bytes both ways, as late and as badly as it is told."""
        trouble = self.trouble
        if sent := self.end.read():
            self._note(now, "sent", sent)
            self.overhears.take(now, sent)
            pieces = self._mistreated(sent, trouble.lost_requests, trouble.corrupt_requests, trouble.doubled_requests)
            self._requests += [(now + trouble.request_late_s, piece) for piece in pieces]
        for piece in _due(self._requests, now):
            self._note(now, "heard", piece)
            self.hears.take(now, piece)
        self.overhears.emit(now)
        for _, said in self.hears.emit(now):
            pieces = self._mistreated(said, trouble.lost_replies, trouble.corrupt_replies, trouble.doubled_replies)
            self._replies += [(now + trouble.reply_late_s, piece) for piece in pieces]
        if replies := b"".join(_due(self._replies, now)):
            self._note(now, "said", replies)
            self.end.write(replies)
        if trouble.junk_bytes:
            self.end.write(b"\x55" * trouble.junk_bytes)

    def due_s(self, now: float) -> float:
        """When it must be looked at next."""
        own = self.hears.due_s() if hasattr(self.hears, "due_s") else now + LOOK_S
        waiting = [t_s for t_s, _ in self._requests[:1] + self._replies[:1]]
        return min([max(own, now + LOOK_S / 2), *waiting])

    def unplug(self) -> None:
        """Out; what was on its way is lost."""
        self.end.unplug()
        self._requests.clear()
        self._replies.clear()

    def _mistreated(self, data: bytes, lost: float, corrupt: float, doubled: bool) -> list[bytes]:
        if self.chance.random() < lost:
            return []
        if self.chance.random() < corrupt:
            place = self.chance.randrange(len(data))
            data = data[:place] + bytes([data[place] ^ 1 << self.chance.randrange(7)]) + data[place + 1 :]
        return [data] * (1 + doubled)

    def _note(self, now: float, what: str, data: bytes) -> None:
        if self.name.startswith("supply"):
            self.log.append((now, what, data.decode("latin-1")))


def _due(queue: list[tuple[float, bytes]], now: float) -> list[bytes]:
    due = [piece for t_s, piece in queue if t_s <= now]
    queue[:] = [(t_s, piece) for t_s, piece in queue if t_s > now]
    return due
