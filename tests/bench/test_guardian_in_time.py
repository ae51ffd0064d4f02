"""The stopwatch on the guardian, on a machine with nothing else to do: every coil at zero within two seconds.

Measured from the deed to the moment when the simulated lab's currents are below a milliampere's few, at the largest
currents that the example allows; the guardian's own log then says when it was all read back.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from datetime import datetime

import pytest
from served_lab import (
    LABCAL,
    Served,
    Sessions,
    at_zero,
    children_of,
    example,
    guardians,
    log,
    on_a_terminal,
    three_on_one_pair,
    until,
)

from labcal.bench.guardian.standbys import HOW_MANY

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL, SIGSTOP and ptys, which Windows lacks"),
]
IN_TIME_S = 2.0
MOST_A = "1.8,0.7,0.3"  # 98 of the 100 µT that the DUT bears


def killed(lab: Served, session: Sessions) -> Callable[[], object]:
    return session("idle", MOST_A).kill


def stopped(lab: Served, session: Sessions) -> Callable[[], object]:
    child = session("idle", MOST_A)
    return lambda: os.kill(child.pid, signal.SIGSTOP)


def terminal_lost(lab: Served, session: Sessions) -> Callable[[], object]:
    _, terminal = on_a_terminal(session, MOST_A)
    return lambda: os.close(terminal)


def standing_by(lab: Served, session: Sessions) -> tuple[int, list[int]]:
    """A guardian of energised coils, and those that stand by it, ready."""
    session("idle", MOST_A)
    (first,) = guardians()
    until(lambda: len(children_of(first)) == HOW_MANY)
    time.sleep(6)
    return first, children_of(first)


def guardian_killed(lab: Served, session: Sessions) -> Callable[[], object]:
    first, _ = standing_by(lab, session)
    return lambda: os.kill(first, signal.SIGKILL)


def guardian_hung(lab: Served, session: Sessions) -> Callable[[], object]:
    first, _ = standing_by(lab, session)
    return lambda: os.kill(first, signal.SIGSTOP)


def guardian_and_standby_killed(lab: Served, session: Sessions) -> Callable[[], object]:
    first, standbys = standing_by(lab, session)
    return lambda: [os.kill(pid, signal.SIGKILL) for pid in (standbys[0], first)]


def said_off(lab: Served, session: Sessions) -> Callable[[], object]:
    session("idle", MOST_A)
    command = [*LABCAL, "bench", "off", str(lab.file)]
    return lambda: threading.Thread(target=subprocess.run, args=(command,)).start()


def read_back_s() -> float:
    """From the order to zero to its last read-back, by the guardian's own stamps."""
    stamps = re.findall(r"^(\S+)Z \[\d+\] (to zero|read back): (?!.*session begins)", log(), re.MULTILINE)
    (_, order), (_, read) = stamps[-2:]
    assert (order, read) == ("to zero", "read back")
    times = [datetime.fromisoformat(stamp) for stamp, _ in stamps[-2:]]
    return (times[1] - times[0]).total_seconds()


@pytest.mark.parametrize("bench_text", [example(), three_on_one_pair()], ids=["tti", "riden-on-one-pair"])
@pytest.mark.parametrize(
    "deed",
    [killed, stopped, terminal_lost, guardian_killed, guardian_hung, guardian_and_standby_killed, said_off],
)
def test_every_coil_is_at_zero_within_two_seconds(
    lab: Served, session: Sessions, deed: Callable[[Served, Sessions], Callable[[], object]]
) -> None:
    act, begun = deed(lab, session), time.monotonic()
    act()
    until(lambda: at_zero(lab))
    took_s = time.monotonic() - begun
    until(lambda: log().splitlines()[-1].count("zero, open") == 3)
    print(f"{deed.__name__}: zero after {took_s:.2f} s, order to read-back {read_back_s():.2f} s")
    assert took_s < IN_TIME_S
