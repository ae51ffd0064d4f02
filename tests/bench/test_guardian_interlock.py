"""An interlock behind the guardian, with real processes: what is left when none of labcal's processes is."""

from __future__ import annotations

import os
import re
import signal
import sys

import numpy as np
import pytest
from served_lab import (
    ZERO_A,
    Served,
    Sessions,
    at_zero,
    children_of,
    example,
    guardians,
    kill_all,
    log,
    of_bench,
    until,
)

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs SIGKILL, SIGSTOP and ptys, which Windows lacks")
WATCHDOG_S = 3.0
LATE_S = 15.0  # at most: a beat that was on its way when its sender died, on a busy machine


def with_interlock(timeout_s: float = 15.0) -> str:
    """The served example with a relay through which all coils' currents go."""
    entry = '[instruments.guard]\ndriver = "waveshare-interlock"\nlink = "emulated://"\nrole = "interlock"\n'
    return example(timeout_s).replace("[instruments.stage]", f"{entry}\n[instruments.stage]")


@pytest.fixture
def bench_text() -> str:
    return with_interlock()


def opened_s(lab: Served) -> float:
    """When the contact opens, or has opened, on the clock of the lab."""
    return float(lab.coils["x"].closed_until_s["interlock"])


def flowed(lab: Served, t_s: float) -> list[float]:
    return [abs(float(coil.at(np.array([t_s]))[0])) for coil in lab.coils.values()]


def test_all_three_killed_the_interlock_falls_open(lab: Served, session: Sessions) -> None:
    child = session("idle")
    kill_all(child)
    killed_s = lab.clock.now()
    assert not at_zero(lab)
    until(lambda: at_zero(lab))
    assert not of_bench(lab.file)
    print(f"contact open {opened_s(lab) - killed_s:.2f} s after the deed")
    assert 0 < opened_s(lab) - killed_s <= WATCHDOG_S + LATE_S
    assert all(coil._wanted_A > ZERO_A for coil in lab.coils.values())  # the supplies would go on for ever
    assert log().count("to zero") == 1  # before the session began


@pytest.mark.slow
def test_after_that_the_next_session_finds_the_supplies_on_and_closes_the_contact_with_all_of_them_at_zero(
    lab: Served, session: Sessions
) -> None:
    kill_all(session("idle"))
    until(lambda: at_zero(lab))
    armed, coil = list[list[float]](), lab.coils["x"]
    close = coil.close

    def closing(t_s: float, by: str, until_s: float) -> None:
        armed.append([abs(other._wanted_A) for other in lab.coils.values()])
        close(t_s, by, until_s)

    coil.close = closing
    session("idle", "0.5,0.4,0.3")
    assert max(armed[0]) < ZERO_A


@pytest.mark.slow
def test_at_an_orderly_end_the_coils_are_at_zero_before_the_contact_opens(lab: Served, session: Sessions) -> None:
    child = session("idle", popen=lambda: {"preexec_fn": lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)})
    child.send_signal(signal.SIGINT)
    until(lambda: not guardians())
    assert opened_s(lab) < lab.clock.now()
    assert max(flowed(lab, opened_s(lab) - 0.02)) < ZERO_A
    assert "read back: coil x" in log().rpartition("to zero")[2]


@pytest.mark.slow
def test_a_beat_that_cannot_be_sent_takes_the_coils_to_zero_and_is_named(lab: Served, session: Sessions) -> None:
    child = session("measure")
    lab.emulator("guard").emit = lambda until_s: []
    until(lambda: at_zero(lab))
    _, said = child.communicate(timeout=90)
    assert "guard: " in said
    assert "no valid Modbus reply" in said
    assert re.search(r"heartbeat of guard: .*no valid Modbus reply(?s:.)*to zero: guard: ", log())


@pytest.mark.slow
@pytest.mark.parametrize("bench_text", [with_interlock(timeout_s=1.5)], ids=["impatient"])
def test_a_supply_that_does_not_obey_is_cut_off(lab: Served, session: Sessions) -> None:
    child = session("idle")
    supply = lab.emulator("supply_x")
    supply.take = lambda t_s, data: None
    child.kill()
    until(lambda: at_zero(lab))
    assert lab.coils["x"]._wanted_A == pytest.approx(1.0, abs=0.01)
    del supply.take


@pytest.mark.slow
def test_a_guardian_that_is_replaced_closes_the_contact_again(lab: Served, session: Sessions) -> None:
    child = session("idle")
    (first,) = guardians()
    until(lambda: len(children_of(first)) == 2)
    os.kill(first, signal.SIGKILL)
    until(lambda: at_zero(lab))
    child.kill()
    child.wait()
    session("idle", "0.5,0.4,0.3")
