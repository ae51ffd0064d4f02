"""What must never go over a line, whoever asks for it: checked where the bytes leave."""

from __future__ import annotations

import re
from collections.abc import Iterable

from labcal.errors import InstrumentError


class DenyList:
    """Byte patterns (regular expressions) that a line refuses to send; each driver brings its own as `never`."""

    def __init__(self) -> None:
        self._patterns: list[re.Pattern[bytes]] = []

    def add(self, patterns: Iterable[bytes]) -> None:
        """From now on these are refused."""
        self._patterns += [re.compile(pattern, re.DOTALL | re.IGNORECASE) for pattern in patterns]

    def check(self, url: str, data: bytes) -> None:
        """Raise InstrumentError (forbidden) where `data` is on the list; nothing has been sent then."""
        for pattern in self._patterns:
            if pattern.search(data):
                raise InstrumentError(
                    f"{url}: {data!r} is never sent by labcal; nothing was sent.",
                    fault="forbidden",
                    remedy="Do it on the instrument's own panel, with the coils disconnected.",
                )
