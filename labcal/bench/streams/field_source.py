"""A source of fields outside this program, listened to and doubted: order, age, size of steps, silence."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from labcal.bench.clock import Clock
from labcal.bench.links import Link, open_link
from labcal.bench.streams.field_datagrams import REMEDY, EndOfSource, WantedField, answer, parse
from labcal.errors import InputError, InstrumentError

Array = NDArray[np.float64]


@dataclass(slots=True)
class Counts:
    """What came: `foreign` is what does not begin as ours does."""

    received: int = 0
    lost: int = 0
    repeated: int = 0
    foreign: int = 0


@dataclass
class Offsets:
    """Bench time of arrival less the source's time, in one pass: least, largest, and scatter [s]."""

    first: float = math.nan
    least: float = math.inf
    most: float = -math.inf
    _n: int = field(default=0, repr=False)
    _mean: float = field(default=0.0, repr=False)
    _squares: float = field(default=0.0, repr=False)

    def take(self, offset_s: float) -> None:
        """One more (Welford's recurrence)."""
        self.first = offset_s if self._n == 0 else self.first
        self.least, self.most = min(self.least, offset_s), max(self.most, offset_s)
        self._n += 1
        before = offset_s - self._mean
        self._mean += before / self._n
        self._squares += before * (offset_s - self._mean)

    @property
    def jitter_s(self) -> float:
        """Standard deviation of one arrival; NaN of fewer than two."""
        return math.sqrt(self._squares / (self._n - 1)) if self._n > 1 else math.nan


class FieldSource:
    """Fields as they come. `refuse` raises for a field (3,) [nT] that the coils may not make; `ramp_s` says how long
    the coils need from one field to another.

    What it cannot believe it raises, InstrumentError: another clock than its own ("stale"), a step that the coils
    cannot follow ("jump"), silence for `silent_s`. What is repeated, late or foreign is passed over and counted.
    """

    def __init__(
        self,
        link: Link,
        clock: Clock,
        *,
        refuse: Callable[[Array], None],
        ramp_s: Callable[[Array], float],
        silent_s: float,
        max_age_s: float,
    ) -> None:
        self._link, self._clock, self._refuse, self._ramp_s = link, clock, refuse, ramp_s
        self.silent_s, self._max_age_s = silent_s, max_age_s
        self.counts, self.offsets = Counts(), Offsets()
        self._last: WantedField | None = None
        self._taken: list[WantedField] = []
        self.ended = False  # the source has said so
        self._since_s = clock.now()

    def begin(self) -> None:
        """From here on it must send: what came before is dropped."""
        self._link.flush()
        self._since_s = self._clock.now()

    def look(self) -> None:
        """Take in what has come. Raises what it cannot believe; LimitError for a field beyond a limit."""
        for stamp, data in self._link.receive(self._clock.now()):
            self._take(parse(data, stamp))
        silent_s = self._clock.now() - self._since_s
        if not self.ended and silent_s > self.silent_s:
            raise InstrumentError(
                f"the field source has sent no new field for {silent_s:.1f} s.", fault="silent", remedy=REMEDY
            )

    def taken(self) -> list[WantedField]:
        """The fields believed since this was asked last, the newest at the end."""
        taken, self._taken = self._taken, []
        return taken

    def update(self, wanted: WantedField, latency_s: float, b_nT: Array) -> None:
        """Tell the source that a field stands."""
        self._link.send(answer(wanted.number, latency_s, b_nT))

    def close(self) -> None:
        """Let go of the port."""
        self._link.close()

    def _take(self, said: WantedField | EndOfSource | None) -> None:
        if said is None:
            self.counts.foreign += 1
        elif self._last is not None and said.number <= self._last.number:
            self.counts.repeated += 1
        elif isinstance(said, EndOfSource):
            self.ended = True
        elif not self.ended:
            self._believe(said)

    def _believe(self, wanted: WantedField) -> None:
        self._refuse(wanted.b_nT)
        self.offsets.take(wanted.arrived_s - wanted.t_s)
        self._refuse_time(wanted)
        if self._last is not None:
            self._refuse_jump(wanted, self._last)
            self.counts.lost += wanted.number - self._last.number - 1
        self.counts.received += 1
        self._taken.append(wanted)
        self._last = wanted
        self._since_s = wanted.arrived_s

    def _refuse_time(self, wanted: WantedField) -> None:
        """Its clock must go on, neither late nor ahead of the bench's by more than the age that is allowed."""
        offset_s, seen = wanted.arrived_s - wanted.t_s, self.offsets
        if self._last is not None and wanted.t_s <= self._last.t_s:
            raise _stale(wanted, f"of t = {wanted.t_s:g} s after t = {self._last.t_s:g} s: its time does not go on")
        if (age_s := offset_s - seen.least) > self._max_age_s:
            raise _stale(wanted, f"that is {age_s:.2f} s old, beside the quickest; {self._max_age_s:g} s are allowed")
        if (ahead_s := seen.first - offset_s) > self._max_age_s:
            raise _stale(wanted, f"whose time has run {ahead_s:.2f} s ahead of ours since it began")

    def _refuse_jump(self, wanted: WantedField, last: WantedField) -> None:
        step_nT, given_s = wanted.b_nT - last.b_nT, wanted.t_s - last.t_s
        if (needed_s := self._ramp_s(step_nT)) > given_s:
            raise InstrumentError(
                f"the field source jumps by {np.linalg.norm(step_nT):.0f} nT in {given_s:.3g} s (number "
                f"{wanted.number}); by [cage.limits] ramp_A_per_s the coils need {needed_s:.3g} s.",
                fault="jump",
                remedy=REMEDY,
            )


def _stale(wanted: WantedField, why: str) -> InstrumentError:
    return InstrumentError(
        f"the field source sent a field (number {wanted.number}) {why}.", fault="stale", remedy=REMEDY
    )


def open_line(url: str, clock: Clock) -> Link:
    """The port at which datagrams come. Raises InputError for a URL that is none, or a clock that waits for nobody."""
    if not url.startswith("udp://"):
        raise InputError(f"source = {url!r}: expected udp://HOST:PORT, an address of this computer")
    if math.isinf(clock.listen_s):
        raise InputError(
            "a source outside sends in true time: say --clock real, or serve the bench (labcal bench serve)"
        )
    return open_link(url, clock)
