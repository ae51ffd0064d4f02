"""What must never go over a line, whoever asks for it: checked where the bytes leave."""

from __future__ import annotations

import re
from collections.abc import Iterable

from labcal.errors import InstrumentError

MBAP = 6  # bytes of a Modbus TCP header before the unit, with which an RTU frame begins


class DenyList:
    """Byte patterns (regular expressions) that a line refuses to send; each driver brings its own as `never`."""

    def __init__(self) -> None:
        self._patterns: list[tuple[re.Pattern[bytes], bytes]] = []

    def add(self, patterns: Iterable[bytes], unit: int | None = None) -> None:
        """From now on these are refused; with `unit` only in frames to that Modbus address, and to all (0)."""
        heads = b"" if unit is None else bytes([0, unit])
        flags = re.DOTALL | (re.IGNORECASE if unit is None else 0)  # letters have a case, numbers have none
        self._patterns += [(re.compile(pattern, flags), heads) for pattern in patterns]

    def check(self, url: str, data: bytes) -> None:
        """Raise InstrumentError (forbidden) where `data` is on the list; nothing has been sent then."""
        frame = data[MBAP:] if url.startswith("modbus-tcp://") else data
        for pattern, heads in self._patterns:
            if (not heads or frame[:1] in heads) and pattern.search(frame):
                raise InstrumentError(
                    f"{url}: {data!r} is never sent by labcal; nothing was sent.",
                    fault="forbidden",
                    remedy="Do it on the instrument's own panel, with the coils disconnected.",
                )
