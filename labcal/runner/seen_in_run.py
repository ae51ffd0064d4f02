"""What the outcome says of a run's items, taken down while they pass on."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, field

from labcal.errors import InstrumentError, LimitNotMet
from labcal.record.stream import NOT_KEPT, SLOW_DISK, Event, Item, Measurement, Step
from labcal.runner.drive import OnItem
from labcal.store.writer import SAY_S


@dataclass
class SeenInRun:
    """What the outcome says of a run's items, taken down while they pass on to `on_item`."""

    on_item: OnItem
    failed: dict[str, Measurement] = field(default_factory=dict)
    energised: bool = False
    steps: set[str] = field(default_factory=set)
    store_told_s: float = -math.inf
    wait_told: bool = False
    waited_s: int = 0

    def waits(self, t_s: float, waited_s: float) -> None:
        """Tell every second that rows wait for a busy disk, and that they do no more."""
        before, self.waited_s = self.waited_s, int(waited_s)
        if self.waited_s > before:
            self.on_item(Event(t_s, SLOW_DISK, f"the disk is slow: rows wait {self.waited_s} s in memory"))
        elif before and not self.waited_s:
            self.on_item(Event(t_s, SLOW_DISK, "the disk takes what is recorded again"))

    def not_kept(self, t_s: float, fault: InstrumentError) -> None:
        """Tell once that the end of the run waits for the store; not just after it was told that the store ended it."""
        if not self.wait_told and time.monotonic() - self.store_told_s > SAY_S:
            self.wait_told = True
            self.notice(Event(t_s, NOT_KEPT, f"the end of the run waits: {fault.what}"))

    def nothing_new(self, fault: BaseException, done: frozenset[str]) -> bool:
        """Whether a run that was gone on with ended as it was: with no coil energised, or in a check of its opening."""
        return not self.energised or (isinstance(fault, LimitNotMet) and self.steps <= done)

    def notice(self, item: Item) -> None:
        """Take down what counts of it, and hand it on."""
        if isinstance(item, Step):
            self.steps.add(item.name)
        if isinstance(item, Measurement):
            self.failed.pop(item.name, None)
            if item.verdict == "FAIL":
                self.failed[item.name] = item
        if isinstance(item, Event):
            self.energised |= item.kind == "set-point"
            if item.kind == NOT_KEPT:
                self.store_told_s = time.monotonic()
        self.on_item(item)
