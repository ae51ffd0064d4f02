"""Adapters that hear what they send, as on many RS-485 pairs: what was sent is taken off what comes back."""

from __future__ import annotations

from labcal.bench.links.quoting import quoted
from labcal.errors import InstrumentError

Pieces = list[tuple[float, bytes]]


class Echo:
    """`echo=1` in a link's URL. What was sent must come back first, byte for byte."""

    def __init__(self, url: str) -> None:
        self._url, self._due = url, b""

    def sent(self, data: bytes) -> None:
        """This will come back."""
        self._due += data

    def forget(self) -> None:
        """The line was opened again."""
        self._due = b""

    def taken_off(self, pieces: Pieces) -> Pieces:
        """What is left of `pieces`. Raises InstrumentError (wrong reply) where something else came back."""
        return [(t_s, rest) for t_s, data in pieces if (rest := self._rest(data))]

    def _rest(self, data: bytes) -> bytes:
        length = min(len(data), len(self._due))
        expected, self._due = self._due[:length], self._due[length:]
        if data[:length] != expected:
            self._due = b""
            raise InstrumentError(
                f"{self._url}: {quoted(expected)} was sent and {quoted(data[:length])} came back.",
                fault="wrong reply",
                remedy="Do two talk on this line at once? Without an adapter that echoes, take echo=1 out of the link.",
            )
        return data[length:]
