"""What a session read of each coil through its guardian, and when: reported where nobody answers any more."""

from __future__ import annotations

import time
from datetime import timedelta

from labcal.bench.clock import Clock
from labcal.errors import InstrumentError

REMEDY = (
    "Where it lives, or another stands by, that one takes the coils to zero: guardian.log says what was read back, and "
    "`labcal bench off` sets zero and reads it back. Then start the run again."
)


class LastRead:
    """The last current of each axis."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._words = dict[str, str]()

    def keep(self, axis: str, current_A: float, read_s: float | None = None) -> None:
        """`read_s`: when, on the monotonic clock; None: just now."""
        age = timedelta(seconds=0.0 if read_s is None else time.monotonic() - read_s)
        self._words[axis] = f"coil {axis} {current_A:+.4f} A at {self._clock.utc() - age:%H:%M:%S}"

    def gone(self) -> InstrumentError:
        """That nobody answers any more, and what was known then: reported later, it is as true."""
        read = ", ".join(self._words.values())
        known = f"last read before that (UTC): {read}" if read else "no current was read through it"
        what = f"the connection to the guardian was lost; {known}."
        return InstrumentError(what, fault="guardian lost", remedy=REMEDY)
