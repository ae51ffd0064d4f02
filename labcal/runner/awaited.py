"""A person is awaited on a bench whose time is simulated: what is shown is read anew, as in a lab whose time passes.

No stream sends while time stands. Whoever thinks for longer has a little of it pass again and again; between that
reference and DUT have the age that the clock on the wall gives them, wherever it is said.
"""

from __future__ import annotations

import time
from contextlib import suppress
from dataclasses import replace

from labcal.bench.bench import Bench
from labcal.bench.coils.state import LabState
from labcal.errors import InstrumentError

STREAMS = ("reference", "dut")  # roles
AGAIN_S = 1.5  # sooner than what was read counts as old
SETTLED_S = 3.0  # of the bench's time after a ramp, in which a reference that sends has sent


class Awaited:
    """From when it is made; by the computer's monotonic clock, for the bench's own does not move."""

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._since_s = self._read_s = time.monotonic()

    def state(self) -> LabState:
        """Coils and platform as they answer now; of what streams, what it sent last, with its age."""
        now = time.monotonic()
        if now - self._read_s >= AGAIN_S:
            self._read_s = now
            self._read_again()
        state = self._bench.state().shifted(now - self._bench.clock.now())
        by_s = now - self._since_s
        field = replace(state.field, read_s=_earlier(state.field.read_s, by_s))
        reference = replace(state.reference, read_s=_earlier(state.reference.read_s, by_s))
        roles = self._bench.config.instruments
        heard = (replace(one, heard_s=_earlier(one.heard_s, by_s)) if roles[one.name].role in STREAMS else one
                 for one in state.instruments)  # fmt: skip
        return replace(state, field=field, reference=reference, instruments=tuple(heard))

    def lets_pass(self) -> bool:
        """Whether a little of the bench's time is to pass: what streams would grow old; and on, as long as the field
        was not seen since a ramp, or a zero.
        """
        if time.monotonic() - self._since_s < AGAIN_S:  # who answers at once waits for nothing
            return False
        cage, now = self._bench.cage, self._bench.clock.now()
        unseen = now <= cage.settled_s + SETTLED_S and self._bench.state().field.seen_nT is None
        goes_on = unseen or now <= cage.check.looks_until_s
        self._since_s = time.monotonic() - AGAIN_S * goes_on  # what comes now is of now
        return True

    def _read_again(self) -> None:
        """Who does not answer is no longer known, and ends nothing while nothing is on."""
        for axis in self._bench.cage.supplies:
            with suppress(InstrumentError):
                self._bench.cage.read(axis)
        with suppress(InstrumentError):
            self._bench.look_at_platform()


def _earlier(read_s: float | None, by_s: float) -> float | None:
    return None if read_s is None else read_s - by_s
