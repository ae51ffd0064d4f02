"""The guardian with real processes, real lines and the real clock: whatever happens, the coils are at zero.

What is waited for here has no deadline that a busy machine could miss; `test_guardian_in_time.py` has the stopwatch.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys

import pytest
from served_lab import (
    LABCAL,
    LONG_S,
    Served,
    Sessions,
    at_zero,
    beginning,
    children_of,
    example,
    guardians,
    log,
    on_a_terminal,
    read_back_after,
    until,
)

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL, SIGSTOP and ptys, which Windows lacks")


def test_a_session_that_is_killed_leaves_the_coils_at_zero(lab: Served, session: Sessions) -> None:
    session("idle").kill()
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("has ended"))
    until(lambda: not guardians())


def test_a_session_that_loses_its_terminal_leaves_the_coils_at_zero(lab: Served, session: Sessions) -> None:
    child, terminal = on_a_terminal(session)
    os.close(terminal)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("has ended"))
    assert child.wait(LONG_S) == -signal.SIGHUP


@pytest.mark.parametrize("how", ["SIGSTOP", pytest.param("hang", marks=pytest.mark.slow)])
def test_a_session_that_stops_or_hangs_with_the_lock_held_loses_its_coils(
    lab: Served, session: Sessions, how: str
) -> None:
    child = session("hang" if how == "hang" else "idle")
    if how == "SIGSTOP":
        os.kill(child.pid, signal.SIGSTOP)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("has been silent for"))
    assert child.poll() is None


def test_off_is_obeyed_while_a_session_hangs_and_no_other_session_may_begin(lab: Served, session: Sessions) -> None:
    child = session("idle")  # it does not notice what its coils do before it measures
    second = beginning(lab)
    assert f"session {child.pid} drives this bench" in second.stderr
    assert "energised" not in second.stdout
    os.kill(child.pid, signal.SIGSTOP)
    lab.file.write_text("spoilt meanwhile")
    off = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, check=False)
    assert (off.returncode, off.stdout.count("zero, open")) == (0, 3), off.stderr
    assert at_zero(lab)
    os.kill(child.pid, signal.SIGCONT)
    os.kill(child.pid, signal.SIGUSR1)
    _, said = child.communicate(timeout=LONG_S)
    # a process that takes long to begin may say off after the silence was noticed: both ordered it
    ordered = r"zero was ordered for all coils: (labcal bench off, process \d+|session \d+ has been silent for)"
    assert re.search(ordered, said), said


def test_a_killed_guardian_is_replaced_by_one_that_begins_with_zero(lab: Served, session: Sessions) -> None:
    child = session("measure")
    (first,) = guardians()
    os.kill(first, signal.SIGKILL)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))
    successor = re.search(r"\[(\d+)\] .*its successor begins", log())
    assert successor is not None
    assert int(successor[1]) != first
    _, said = child.communicate(timeout=LONG_S)
    assert re.search(
        r"the connection to the guardian was lost; last read before that \(UTC\): coil x \+1\.0\d* A at", said
    ), said


def test_a_guardian_killed_with_its_session_is_replaced_all_the_same(lab: Served, session: Sessions) -> None:
    child = session("idle")
    (first,) = guardians()
    until(lambda: bool(children_of(first)))
    os.kill(first, signal.SIGKILL)
    child.kill()
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))


@pytest.mark.parametrize("bench_text", [example(timeout_s=1.5)], ids=["impatient"])
def test_one_silent_supply_keeps_no_other_from_zero_and_the_next_start_is_refused(
    lab: Served, session: Sessions
) -> None:
    child = session("idle")
    emulator = lab.emulator("supply_x")
    emulator.emit = lambda until_s: []
    child.kill()
    until(lambda: at_zero(lab, "yz"))
    until(lambda: re.search("NOT confirmed at zero: coil x: .*no reply", log()) is not None)
    assert guardians()
    refused = beginning(lab)
    assert "no reply" in refused.stderr
    assert "energised" not in refused.stdout
    del emulator.emit
    until(lambda: re.search(r"no reply(?s:.)*: coil x [+-]0\.00\d\d A, zero, open", log()) is not None)


@pytest.mark.slow
def test_where_both_guardians_are_killed_the_session_starts_another(lab: Served, session: Sessions) -> None:
    session("idle")
    (first,) = guardians()
    until(lambda: bool(children_of(first)))
    for pid in (*children_of(first), first):
        os.kill(pid, signal.SIGKILL)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))
