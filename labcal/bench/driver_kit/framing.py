"""Cutting a stream of bytes into lines, each stamped at its first byte."""

from __future__ import annotations

from collections.abc import Iterable


class Lines:
    """Collects pieces and gives whole lines, without their end; what has no end yet waits for the next piece.

    Which lines come does not depend on how the bytes were cut into pieces. A line longer than `longest` is noise: it
    is dropped and counted in `too_long`. The first line may be cut in half: `skip_first` drops it.
    """

    def __init__(self, end: bytes = b"\n", *, longest: int = 4096, skip_first: bool = False) -> None:
        self._end, self._longest, self._skip = end, longest, skip_first
        self._rest, self._stamp, self._overflown = b"", 0.0, False
        self.too_long = 0

    def feed(self, pieces: Iterable[tuple[float, bytes]]) -> list[tuple[float, bytes]]:
        """Stamped whole lines out of stamped pieces."""
        lines: list[tuple[float, bytes]] = []
        for stamp, data in pieces:
            if not self._rest and not self._overflown:
                self._stamp = stamp
            *whole, self._rest = (self._rest + data).split(self._end)
            for line in whole:
                self._close(line, lines)
                self._stamp = stamp
            if len(self._rest) > self._longest + len(self._end):
                self._overflown, self._rest = True, self._rest[-len(self._end) :]
        return lines

    def _close(self, line: bytes, lines: list[tuple[float, bytes]]) -> None:
        if self._overflown or len(line) > self._longest:
            self.too_long += 1
        elif not self._skip:
            lines.append((self._stamp, line))
        self._skip = self._overflown = False
