"""How late this machine is: how much longer a thread takes that sleeps and works a little than it would alone."""

from __future__ import annotations

import threading
import time
from functools import cache

SLEEPS_S, WORKS_S = 0.05, 0.001
_late = list[tuple[float, float]]()  # begun (monotonic clock), how much longer it took [s]


@cache
def begin() -> None:
    """Watch from now on."""
    threading.Thread(target=_watch, daemon=True).start()


def kept_waiting(from_s: float, to_s: float) -> float:
    """How long such a thread was kept waiting between these times [s]."""
    return sum_between(_late, from_s, to_s)


def sum_between(late: list[tuple[float, float]], from_s: float, to_s: float) -> float:
    """What of `late` was going on between these times."""
    return sum(over for begun, over in late if from_s - over <= begun <= to_s)


def _watch() -> None:
    while True:
        begun = time.monotonic()
        time.sleep(SLEEPS_S)
        worked = time.thread_time()
        while time.thread_time() - worked < WORKS_S:
            pass
        over = time.monotonic() - begun - SLEEPS_S - WORKS_S
        if over > WORKS_S:
            _late.append((begun, over))
