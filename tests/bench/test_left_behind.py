"""What was driven stays known when one process after another dies on the ports before it has brought it to zero."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest
from served_lab import LABCAL, LONG_S, Served, Sessions, at_zero, example, kill_all, of_bench, until

from labcal.bench.config import read_config
from labcal.bench.links import locks, ports

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs SIGKILL and ptys")

TAKES_THEM = """
import os, signal, sys
from labcal.bench.links import ports
assert ports.hold(sys.argv[2:])
if sys.argv[1] == "off":
    ports.announce({"pid": os.getpid()})
os.kill(os.getpid(), signal.SIGKILL)
"""


def dies_with_the_ports(who: str, urls: list[str]) -> None:
    """A process that has taken them; `off`: and said who it is, as `labcal bench off` does; else a standby that had no
    time for that.
    """
    assert subprocess.run([sys.executable, "-c", TAKES_THEM, who, *urls]).returncode == -signal.SIGKILL


@pytest.mark.parametrize("bench_text", [example()], ids=["tti"])
@pytest.mark.parametrize(
    "who",
    [
        pytest.param(["standby"], marks=pytest.mark.slow),
        pytest.param(["off"], marks=pytest.mark.slow),
        ["standby", "off", "standby"],
    ],
    ids=" ".join,
)
def test_off_reaches_what_was_driven_after_others_died_on_its_ports(
    lab: Served, session: Sessions, who: list[str]
) -> None:
    urls = read_config(lab.file).guarded_links
    kill_all(session("idle"))
    until(lambda: not of_bench(lab.file))
    for one in who:
        dies_with_the_ports(one, urls)
    lab.file.unlink()
    assert not at_zero(lab)
    said = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
    assert at_zero(lab), said
    assert said.stdout.count("zero, open") == 3, said


@pytest.mark.parametrize("bench_text", [example()], ids=["tti"])
def test_check_says_which_current_flows_that_nobody_watches(lab: Served, session: Sessions) -> None:
    """And nothing of one that its guardian watches, or of none."""
    check = [*LABCAL, "bench", "check", str(lab.file)]

    def said() -> list[str]:
        shown = subprocess.run(check, capture_output=True, text=True, timeout=LONG_S)
        assert shown.returncode in (0, 3), shown  # 3: the session holds other instruments
        return [line for line in shown.stdout.splitlines() if "no guardian" in line]

    processes = session("idle")
    assert said() == []
    kill_all(processes)
    until(lambda: not of_bench(lab.file))
    found = said()
    stated = {axis: float(line.split()[2]) for axis, line in zip("xyz", found, strict=True)}
    assert stated == pytest.approx(lab.currents(), abs=0.02)
    assert all(f"`labcal bench off {lab.file}`" in line for line in found)
    subprocess.run([*LABCAL, "bench", "off", str(lab.file)], check=True, capture_output=True, timeout=LONG_S)
    assert said() == []


@pytest.mark.parametrize("bench_text", [example(timeout_s=1.5)], ids=["impatient"])
def test_off_is_said_again_of_a_coil_that_did_not_answer_the_first_time(lab: Served, session: Sessions) -> None:
    kill_all(session("idle"))
    until(lambda: not of_bench(lab.file))
    emulator, off = lab.emulator("supply_x"), [*LABCAL, "bench", "off", str(lab.file)]
    emulator.take = lambda t_s, data: None  # its cable is out
    lab.file.unlink()
    first = subprocess.run(off, capture_output=True, text=True, timeout=LONG_S)
    assert (first.returncode, at_zero(lab, "yz"), at_zero(lab, "x")) == (3, True, False), first
    del emulator.take
    again = subprocess.run(off, capture_output=True, text=True, timeout=LONG_S)
    assert (again.returncode, at_zero(lab)) == (0, True), again


def left(name: str) -> list[dict[str, object]]:
    """What was left behind of this bench; the folder is that of all this user's labcals."""
    return [card for card in ports.left_behind() if card.get("bench") == name]


def test_nothing_is_left_behind_of_what_was_brought_to_an_end(tmp_path: Path) -> None:
    url = f"tcp://127.0.0.1:{os.getpid() % 60000 + 1}"
    assert ports.hold([url])
    ports.announce({"bench": str(tmp_path), ports.DRIVEN: {"axes": 1}})
    ports.let_go()
    dies_with_the_ports("standby", [url])
    assert not left(str(tmp_path))


def test_who_only_looks_hides_nothing_from_others_who_look(tmp_path: Path) -> None:
    url = f"tcp://127.0.0.1:{os.getpid() % 60000 + 1}"
    card = {"bench": str(tmp_path), ports.DRIVEN: {"axes": 1}}
    assert ports.hold([url])
    ports.announce(card)
    lock = ports._held.pop(ports.port_of(url))  # as when its process dies
    assert lock.file is not None
    lock.file.close()
    with lock.path.open("r+") as another:
        assert locks.try_lock(another, to_look=True)
        assert left(str(tmp_path)) == [card]
        assert locks.look(lock.path) is None
    lock.path.unlink()
