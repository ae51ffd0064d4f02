"""Replies of instruments that speak in messages (IEEE 488.2): looked for without waiting, where they are announced."""

from __future__ import annotations

import time
from typing import Protocol

MAV = 0x10  # IEEE 488.2, 11.2.1.2: bit 4 of the status byte, message available
TIMEOUT_S = 2.0  # a reply comes in that time or not at all
UNANNOUNCED_S = 0.3  # after which an instrument of unknown habit is read, announced or not
POLL_S = 0.005


class MessagePort(Protocol):
    """What the bus offers."""

    def status_byte(self) -> int | None:
        """The status byte, within a tenth of a second; None where the bus cannot ask for it. Raises OSError."""
        ...

    def read_message(self) -> bytes:
        """One reply; waits at most `TIMEOUT_S` for it, b"" where none came. Raises OSError."""
        ...

    def drop_reply(self) -> None:
        """A reply that comes later must not answer the next question."""
        ...


class Replies:
    """The reply to the last question of one port.

    A read that waits cannot be ended, and a supply that fell silent would keep its line from who brings the coil to
    zero. So nothing is read before the status byte announces it. An instrument is held to that from its first
    announced reply on; one that answers without, and one whose status byte cannot be had, is read with waiting.
    """

    def __init__(self, port: MessagePort) -> None:
        self._port = port
        self._asked_s: float | None = None
        self._next_poll_s = 0.0
        self._announces: bool | None = None

    def written(self, message: bytes) -> None:
        """A message has been sent, which asks for a reply where it has a question mark."""
        self._asked_s = time.monotonic() if b"?" in message else None

    def look(self) -> bytes:
        """The reply, or b"" as long as there is none. Raises OSError when the instrument is gone."""
        now_s = time.monotonic()
        if self._asked_s is None or now_s < self._next_poll_s:
            return b""
        self._next_poll_s = now_s + POLL_S
        waited_s = now_s - self._asked_s
        status = None if self._announces is False else self._port.status_byte()
        announced = None if status is None else bool(status & MAV)
        if not announced and waited_s < self._patience_s(announced):
            return b""
        self._asked_s = None
        reply = self._port.read_message() if announced or not self._announces else b""
        if not reply:
            self._port.drop_reply()
        elif self._announces is None:
            self._announces = bool(announced)
        return reply

    def _patience_s(self, announced: bool | None) -> float:
        """How long a reply that is not announced is only looked for."""
        if self._announces:
            return TIMEOUT_S
        return 0.0 if announced is None else UNANNOUNCED_S
