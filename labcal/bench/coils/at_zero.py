"""How a coil axis ended. By itself, so that who only says off loads nothing else."""

from __future__ import annotations

import time
from collections.abc import Iterable
from dataclasses import dataclass

from labcal.errors import InstrumentError

BY_WORD = "by the supply's word only"  # of who has no reference to ask
ORDERED = "taking the coils to zero: ordered, not read back yet …"
FROM_HERE = "taking to zero from here what no guardian holds: not read back yet …"
NOT_ORDERED = "waiting for a guardian that takes the order of zero …"
FREE_S = 5.0  # so long whoever orders zero waits for a guardian that does not answer, and for the ports it has
FRESH_S = 2.0  # what was read back longer ago is reported as past
SLOW_S = 0.7  # so long after it was wanted that is said


@dataclass(frozen=True, slots=True)
class AtZero:
    """How one axis ended. `fault` is what went wrong on the way; then `current_A` may be unknown (None).

    `read_s`: when the current was read back, on `time.monotonic`. `from_A`: what its supply held when it was set to
    zero without a ramp, as far as that is known. `asked_s`: when it was last asked, where that was not in this round.
    `earlier_at`: the port of a supply that an earlier session drove and the bench file does not name, of no coil of it.
    """

    axis: str
    current_A: float | None
    opened: bool
    fault: InstrumentError | None = None
    read_s: float | None = None
    from_A: float = 0.0
    asked_s: float | None = None
    earlier_at: str = ""

    @property
    def link_is_gone(self) -> bool:
        """Whether nothing is at its port any more, by the computer's own word: no more than silence, and no less."""
        return self.fault is not None and self.fault.fault == "link lost" and "the link was lost" in self.fault.what

    @property
    def abrupt(self) -> bool:
        """Whether current flowed and stepped to zero: that changes the magnetic history of what is near."""
        return self.current_A is not None and self.from_A > 0

    @property
    def words(self) -> str:
        """The end state in words: "zero, open" or "zero, not open", and what went wrong before; else why not."""
        if self.current_A is None:
            return self._not_read
        ended = "zero, open" if self.opened else "zero, not open"
        return ended if self.fault is None else f"{ended}; before that: {self.fault.what.removesuffix('.')}"

    @property
    def why_left(self) -> str:
        """The axis, and why it was not read back at zero; a fault of the coil names it itself."""
        return f"coil {self.axis}: {self.words.removeprefix(f'coil {self.axis}: ')}"

    @property
    def age_words(self) -> str:
        """When it was read back, where that is not just now."""
        age_s = 0.0 if self.read_s is None else time.monotonic() - self.read_s
        return f", read back {age_s:.0f} s ago" if age_s > FRESH_S else ""

    @property
    def _not_read(self) -> str:
        """Why it was not read back at zero: what was found now, or what is known of the last round and its age."""
        if self.asked_s is None:
            return str(self.fault)
        return f"not asked this time; {time.monotonic() - self.asked_s:.1f} s ago: {self.fault}"


def of_this_bench(ended: Iterable[AtZero]) -> list[AtZero]:
    """Those whose supplies the bench file names: what an earlier session drove elsewhere is no coil of it."""
    return [end for end in ended if not end.earlier_at]


def words_of_slow_zero(since_s: float | None, ordered: bool) -> str:
    """What may be said of a way to zero wanted at `since_s` (monotonic; None: nobody wants one) that takes long."""
    if since_s is None or time.monotonic() - since_s < SLOW_S:
        return ""
    return ORDERED if ordered else NOT_ORDERED
