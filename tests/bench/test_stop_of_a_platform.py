"""A platform that turns is stopped as soon as zero is ordered: no supply that is dead is waited for."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time
from contextlib import closing, suppress
from typing import Any

import pytest
from served_lab import LABCAL, LONG_S, Served, at_zero, example, three_on_one_pair, until

from labcal import session as labcal_session
from labcal.bench import open_bench
from labcal.errors import InstrumentError

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs ptys, which Windows lacks")
WAITED_FOR_S = 6.0  # a supply
AT_ONCE_S = 1.5
OF_A_PROCESS_S = 4.5  # to end it, and for another to load and to open the line


@pytest.fixture
def bench_text() -> str:
    return example(WAITED_FOR_S)


AFTER_ZERO_S = 15.0  # the guardian lets go of the line once the coils are at zero
ON_THE_SAME_PAIR = three_on_one_pair().replace(
    'driver = "zaber"\nlink = "emulated://"\nrole = "platform"',
    'driver = "oriental-az"\nlink = "emulated://pair"\nrole = "platform"\nsettings = { address = 4 }',
)
TURNS = """
import sys, time
from pathlib import Path
from labcal.bench import open_bench
bench = open_bench(Path(sys.argv[1]))
bench.platform.home()
while bench.platform.moving():
    time.sleep(0.05)
bench.platform.move_to(300.0, 6.0)
print("turns", flush=True)
time.sleep(600)
"""


def turning(lab: Served) -> bool:
    return bool(lab.twin.platform.moving(lab.clock.now()))


def pull(lab: Served, axes: str) -> None:
    """Their plugs are out: whatever they are asked, nothing comes for as long as anybody waits."""
    for axis in axes:
        supply = lab.emulator(f"supply_{axis}")
        supply.take = lambda *_: None
        supply.emit = lambda *_: []


def killed_in_a_turn(lab: Served, dead: str) -> None:
    with subprocess.Popen([sys.executable, "-c", TURNS, str(lab.file)], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "turns\n"
        until(lambda: turning(lab))
        pull(lab, dead)
        child.kill()


def stopped_after(lab: Served, order: Any) -> float:
    """How long after `order`, which may take as long as it likes, the platform stood [s]."""
    ordered = threading.Thread(target=order, daemon=True)
    begun = time.monotonic()
    ordered.start()
    until(lambda: not turning(lab))
    took = time.monotonic() - begun
    ordered.join(LONG_S)
    return took


@pytest.mark.parametrize("dead", [pytest.param("z", marks=pytest.mark.slow), "yz", "xyz"])
def test_in_the_way_out_of_a_run(lab: Served, dead: str) -> None:
    with closing(open_bench(lab.file)) as bench:
        bench.cage.set_currents([0.3, 0.2, 0.2])
        bench.platform.home()
        until(lambda: not bench.platform.moving())
        bench.platform.move_to(300.0, 6.0)
        until(lambda: turning(lab))
        pull(lab, dead)

        def order() -> None:
            with suppress(InstrumentError):
                bench.zero_and_stop()

        assert stopped_after(lab, order) < AT_ONCE_S
        assert at_zero(lab, "".join(axis for axis in "xyz" if axis not in dead))
        assert bench.stop_platform().startswith("platform stands at ")


@pytest.mark.parametrize("dead", [pytest.param("", marks=pytest.mark.slow), "z", "xyz"])
def test_by_whoever_ends_the_process_of_a_run(lab: Served, dead: str) -> None:
    killed_in_a_turn(lab, dead)
    read = list[Any]()
    took = stopped_after(lab, lambda: read.append(labcal_session.coils_off_and_stopped(lab.file)))
    assert took < OF_A_PROCESS_S
    assert [end.axis for end in read[0][0]] == ["x", "y", "z"]


def test_by_labcal_bench_off(lab: Served) -> None:
    killed_in_a_turn(lab, "")
    said = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
    assert not turning(lab)
    assert "platform stands at " in said.stderr


@pytest.mark.parametrize("bench_text", [ON_THE_SAME_PAIR], ids=["one pair"])
@pytest.mark.parametrize("energised", [True, False], ids=["driven", "dark"])
def test_on_the_line_of_the_supplies_it_is_stopped_once_the_coils_are_at_zero(lab: Served, energised: bool) -> None:
    patient = lab.file.read_text().replace("?baud=", "?timeout_ms=3000&baud=")
    lab.file.write_text(patient)  # a busy computer's answers come late, and the run has to begin all the same
    moves = TURNS.replace("bench.platform.move_to", "bench.cage.set_currents([0.3, 0.2, 0.2])\nbench.platform.move_to")
    with subprocess.Popen(
        [sys.executable, "-c", moves if energised else TURNS, str(lab.file)], stdout=subprocess.PIPE, text=True
    ) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "turns\n"
        until(lambda: turning(lab))
        child.kill()
    read = list[Any]()
    took = stopped_after(lab, lambda: read.append(labcal_session.coils_off_and_stopped(lab.file)))
    assert took < AFTER_ZERO_S
    assert at_zero(lab)
    unread = [end.words for end in read[0][0] if end.current_A is None]
    assert unread == []  # one whose answer came late on a busy computer is told to have been so before its zero


def test_of_a_run_that_hangs_and_keeps_the_line_it_is_said(lab: Served) -> None:
    with subprocess.Popen([sys.executable, "-c", TURNS, str(lab.file)], stdout=subprocess.PIPE, text=True) as child:
        assert child.stdout is not None
        assert child.stdout.readline() == "turns\n"
        until(lambda: turning(lab))
        child.send_signal(signal.SIGSTOP)
        said = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
        assert turning(lab)
        kept = f"platform NOT confirmed at a standstill (another process ({child.pid}) keeps the platform's line"
        assert kept in said.stderr
        child.kill()
