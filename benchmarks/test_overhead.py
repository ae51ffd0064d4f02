"""What a driver costs above the bare line: the same question put by hand and by the driver, in turn, in one run.

`pytest benchmarks/test_overhead.py -s` prints the ratios of docs/performance.md.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from contextlib import closing
from functools import partial

import numpy as np
import pytest
from frames import rtu

from drivers.hmr2300 import Hmr2300
from drivers.hmr2300 import Settings as HmrSettings
from drivers.riden_rd60xx import RidenSupply
from drivers.riden_rd60xx import Settings as RidenSettings
from drivers.rigol_dp800 import RigolSupply
from drivers.rigol_dp800 import Settings as RigolSettings
from labcal.bench.clock import RealClock
from labcal.bench.links import Link, open_link
from labcal.bench.links.modbus import ModbusLink

REPLY_S = 0.005  # quicker than any of these instruments answers
QUESTIONS = 200
STATE = bytes.fromhex("01030008000b85cf")  # eleven registers from 8
REPLIES = {
    "rigol-dp800": b"0.4990\n",
    "hmr2300": b"SER# 0000000000012345\r",
    "riden-rd60xx": rtu("0103 16 01f4 01f4 01e0 01f3 0000 00e6 0960 0000 0000 0001 0001"),
}
ANSWERER = """
import socket, sys, time
server = socket.create_server(("127.0.0.1", 0))
print(server.getsockname()[1], flush=True)
host = server.accept()[0]
host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
reply, delay = bytes.fromhex(sys.argv[1]), float(sys.argv[2])
while host.recv(4096):
    time.sleep(delay)
    host.sendall(reply)
"""


def seconds(clock: RealClock, ask: Callable[[], object]) -> float:
    begun = clock.now()
    ask()
    return clock.now() - begun


def ratio(clock: RealClock, name: str, bare: Callable[[], object], driven: Callable[[], object]) -> float:
    """The driver's time for a question over the bare line's, asked in turn; the quicker fifth, for a busy machine."""
    times = np.array([(seconds(clock, bare), seconds(clock, driven)) for _ in range(QUESTIONS)])
    by_hand, by_driver = np.percentile(times, 20, axis=0)
    print(f"\n{name}: bare {1e3 * by_hand:.2f} ms, driver {1e3 * by_driver:.2f} ms, ratio {by_driver / by_hand:.3f}")
    return float(by_driver / by_hand)


def pair(name: str, link: Link, clock: RealClock) -> tuple[Callable[[], object], Callable[[], object]]:
    """The question put on the bare line, and by the driver."""
    if name == "rigol-dp800":
        supply = RigolSupply(name, link, clock, RigolSettings(gap_s=0.0))
        return partial(link.ask, b":MEAS:CURR? CH1\n", end=b"\n", timeout_s=2.0), supply.measure_current
    if name == "hmr2300":
        sensor = Hmr2300(name, link, clock, HmrSettings())
        return partial(link.ask, b"*00#\r", end=b"\r", timeout_s=2.0), partial(sensor._words.ask, "#", "SER#")
    riden = RidenSupply(name, ModbusLink(link, clock), clock, RidenSettings(gap_s=0.0))
    riden._scale = 100, 1000
    return partial(link.ask, STATE, end=len(REPLIES[name]), timeout_s=2.0), riden.measure_current


@pytest.mark.parametrize("name", sorted(REPLIES))
def test_a_question_costs_less_than_a_tenth_more_than_on_the_bare_line(name: str) -> None:
    command = [sys.executable, "-c", ANSWERER, REPLIES[name].hex(), str(REPLY_S)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as answerer:
        assert answerer.stdout is not None
        clock, port = RealClock(), int(answerer.stdout.readline())
        scheme = "modbus-rtu://socket://" if name == "riden-rd60xx" else "tcp://"
        with closing(open_link(f"{scheme}127.0.0.1:{port}", clock)) as link:
            assert ratio(clock, name, *pair(name, link, clock)) < 1.10
        answerer.kill()
