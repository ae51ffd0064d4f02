"""Cutting a stream of bytes into lines, each stamped at its first byte."""

from __future__ import annotations

from collections.abc import Iterable


class Lines:
    """Collects pieces and gives whole lines, without their end; what has no end yet waits for the next piece.

    A line longer than `longest` is noise and is dropped with all up to the next end. The first line after the start
    may be cut in half: `skip_first` drops it.
    """

    def __init__(self, end: bytes = b"\n", *, longest: int = 4096, skip_first: bool = False) -> None:
        self._end, self._longest, self._skip = end, longest, skip_first
        self._rest, self._stamp = b"", 0.0

    def feed(self, pieces: Iterable[tuple[float, bytes]]) -> list[tuple[float, bytes]]:
        """Stamped whole lines out of stamped pieces."""
        lines: list[tuple[float, bytes]] = []
        for stamp, data in pieces:
            if not self._rest:
                self._stamp = stamp
            *whole, rest = (self._rest + data).split(self._end)
            for number, line in enumerate(whole):
                lines.append((self._stamp if number == 0 else stamp, line))
            if whole:
                self._stamp = stamp
            self._rest = rest
            if len(rest) > self._longest:
                self._rest, self._skip = b"", True
        if self._skip and lines:
            self._skip = False
            return lines[1:]
        return lines
