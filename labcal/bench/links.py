"""Links: how bytes reach an instrument. The only module that imports serial and pymodbus."""

from __future__ import annotations

from typing import Protocol


class Link(Protocol):
    """A byte line to one instrument, on the bench's clock."""

    url: str
    emulated: bool

    def send(self, data: bytes) -> None:
        """Put bytes on the line. Raises InstrumentError (fault "link lost") when it is gone."""
        ...

    def receive(self, until_s: float) -> list[tuple[float, bytes]]:
        """All bytes that arrive up to `until_s`, in pieces stamped at their first byte; waits on the clock."""
        ...

    def ask(self, request: bytes, *, end: bytes | int, timeout_s: float) -> bytes:
        """Send, then return the reply up to and with `end` (bytes), or `end` bytes. Raises InstrumentError (silent)."""
        ...

    def flush(self) -> None:
        """Drop what has arrived and was not read."""
        ...

    def close(self) -> None:
        """Let go of the line."""
        ...
