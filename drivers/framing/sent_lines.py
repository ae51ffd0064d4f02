"""Lines that an instrument sends by itself, read into rows of numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from drivers.framing.mishaps import Mishaps
from labcal.bench.driver_kit.framing import Lines

Rows = tuple[list[float], list[list[float]], bytes]  # stamps of first bytes, rows, the lines as they came, ends too


class SentLines:
    """Whole lines, ended by CR, LF or both. The first after the start may be cut and is dropped.

    Which lines come does not depend on how the bytes were cut; one longer than `longest` is noise, and is noted.
    """

    def __init__(self, mishaps: Mishaps, longest: int) -> None:
        self._mishaps, self._lines = mishaps, Lines(longest=longest, skip_first=True)

    def rows(self, pieces: Sequence[tuple[float, bytes]], read: Callable[[float, bytes], list[float] | None]) -> Rows:
        """What `read(stamp, line)` makes of each line that these pieces complete; where it is None, nothing."""
        stamps, rows, raw = list[float](), list[list[float]](), list[bytes]()
        ended = [(stamp, data.replace(b"\r", b"\r\n")) for stamp, data in pieces]  # what a CR ends may have no LF
        for stamp, line in self._lines.feed(ended):
            if line.strip(b"\r \0") and (row := read(stamp, line)) is not None:
                stamps.append(stamp)
                rows.append(row)
                raw.append(line + b"\n")
        if self._lines.too_long:
            self._mishaps.note("bad frame", pieces[-1][0], self._lines.too_long)
            self._lines.too_long = 0
        return stamps, rows, b"".join(raw)
