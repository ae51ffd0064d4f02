"""Real lines: served emulators on ptys and TCP ports, the late reply of Modbus RTU, unplugging, datagrams."""

from __future__ import annotations

import select
import socket
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
import pytest
from pymodbus.client import ModbusTcpClient
from pymodbus.framer import FramerType
from served_lab import all_gone, example

from labcal.bench import open_bench
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.links import EmulatedLink, Nobody, open_link
from labcal.bench.links.modbus import ModbusLink, modbus_link
from labcal.errors import InputError, InstrumentError

LABCAL = [sys.executable, "-c", "from labcal.cli import main; main()"]
LONG_S = 60.0  # a busy machine answers within it


@pytest.fixture
def served(tmp_path: Path) -> Iterator[Path]:
    """The example bench on real lines."""
    bench, out = tmp_path / "bench.toml", tmp_path / "served.toml"
    bench.write_text(example(), encoding="utf-8")
    command = [*LABCAL, "bench", "serve", str(bench), "--out", str(out)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            assert process.stdout.readline() == "ready\n"
            yield out
            all_gone(out)  # while there is something that answers them
        finally:
            process.terminate()


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_a_served_bench_is_identified_driven_streamed_and_switched_off_over_real_lines(served: Path) -> None:
    text = served.read_text()
    assert "tcp://127.0.0.1" in text
    assert "modbus-rtu:///dev/pts" in text
    assert "[twin]" not in text
    with open_bench(served) as bench:
        assert not bench.simulated
        bench.start()
        bench.cage.set_currents([0.3, -0.3, 0.1])
        blocks = bench.stream_until(bench.clock.now() + 1.5)
        stamps = np.concatenate([b.t_s for b in blocks if b.stream == "reference"])
        assert np.abs(bench.cage.currents_A() - [0.3, -0.3, 0.1]).max() < 0.005
        assert len(stamps) > 10
        assert (np.diff(stamps) >= 0).all()  # equal where this process was kept from looking
        bench.cage.zero()
    off = subprocess.run([*LABCAL, "bench", "off", str(served)], capture_output=True, text=True, check=False)
    assert off.returncode == 0
    assert off.stdout.count("zero, open") == 3


# late replies


class SlowLine:
    """A TCP line in front of a server that holds the first reply back until `release`; those after it wait behind it.

    With `at_the_next`, a second request releases it: the reply to the first one comes when that to the second is due.
    """

    def __init__(self, server_port: int, *, at_the_next: bool = False) -> None:
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port = self._listener.getsockname()[1]
        self.release, self.passed = threading.Event(), threading.Event()
        self._server_port, self._at_the_next = server_port, at_the_next
        self._thread = threading.Thread(target=self._there, daemon=True)
        self._thread.start()

    def join(self) -> None:
        """Wait until both ways have ended; the host has closed before."""
        self._thread.join()

    def _there(self) -> None:
        place = ("127.0.0.1", self._server_port)
        with self._listener, self._listener.accept()[0] as host, socket.create_connection(place) as server:
            back = threading.Thread(target=self._back, args=(server, host), daemon=True)
            back.start()
            with suppress(ConnectionError):  # a host that closes with a reply unread resets the line
                self._pass_on(host, server)
            with suppress(OSError):
                server.shutdown(socket.SHUT_RDWR)
            back.join()

    def _pass_on(self, host: socket.socket, server: socket.socket) -> None:
        requests = 0
        while data := host.recv(4096):
            requests += 1
            if self._at_the_next and requests == 2:
                self.release.set()
                self.passed.wait(LONG_S)
            server.sendall(data)

    def _back(self, server: socket.socket, host: socket.socket) -> None:
        with suppress(OSError):
            while data := server.recv(4096):
                self.release.wait(LONG_S)
                host.sendall(data)
                self.passed.set()


REGISTERS = """
import asyncio
from pymodbus.framer import FramerType
from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

async def run():
    device = SimDevice(1, [SimData(0, values=list(range(100)), datatype=DataType.REGISTERS)])
    server = ModbusTcpServer(device, framer=FramerType("FRAMER"), address=("127.0.0.1", 0))
    await server.serve_forever(background=True)
    print(server.transport.sockets[0].getsockname()[1], flush=True)
    await asyncio.Event().wait()

asyncio.run(run())
"""


@contextmanager
def serving_registers(framer: FramerType) -> Iterator[int]:
    """A real pymodbus server on a TCP port whose register n holds n; it has a process of its own."""
    command = [sys.executable, "-c", REGISTERS.replace("FRAMER", framer.value)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout is not None
            yield int(process.stdout.readline())
        finally:
            process.kill()


@pytest.fixture(scope="module")
def registers() -> Iterator[int]:
    with serving_registers(FramerType.RTU) as port:
        yield port


@pytest.fixture(scope="module")
def tcp_registers() -> Iterator[int]:
    with serving_registers(FramerType.SOCKET) as port:
        yield port


def test_a_bare_client_takes_a_late_reply_for_the_next_answer(registers: int) -> None:
    """The hazard is real: without it the test below would prove nothing."""
    line = SlowLine(registers, at_the_next=True)
    client = ModbusTcpClient("127.0.0.1", port=line.port, framer=FramerType.RTU, timeout=1.0, retries=0)
    client.connect()
    with pytest.raises(Exception, match="No response"):
        client.read_holding_registers(7, count=1, device_id=1)
    client.comm_params.timeout_connect = LONG_S
    answer = client.read_holding_registers(50, count=1, device_id=1).registers
    client.close()
    line.join()
    assert answer == [7]


def test_a_late_reply_is_never_taken_for_the_next_answer(registers: int, monkeypatch: pytest.MonkeyPatch) -> None:
    slow, clock, quiet_s = SlowLine(registers), RealClock(), 0.5
    line = open_link(f"modbus-rtu://socket://127.0.0.1:{slow.port}", clock)
    receive = line.receive

    def late(until_s: float) -> list[tuple[float, bytes]]:
        if until_s > clock.now() + quiet_s / 2:  # it waits for quiet: the reply comes now
            link._client._timeout_s = LONG_S  # of the requests to come
            slow.release.set()
            assert slow.passed.wait(LONG_S)
        return receive(until_s)

    monkeypatch.setattr(line, "receive", late)
    link = ModbusLink(line, clock, timeout_s=1.0, quiet_s=quiet_s)
    with pytest.raises(InstrumentError) as caught:
        link.read_holding(1, 7, 1)
    assert caught.value.fault == "silent"
    assert link.read_holding(1, 50, 1) == [50]
    assert link.read_holding(1, 8, 3) == [8, 9, 10]
    link.close()
    slow.join()


def test_modbus_tcp_speaks_with_a_real_server(tcp_registers: int) -> None:
    clock = RealClock()
    link = modbus_link(open_link(f"modbus-tcp://127.0.0.1:{tcp_registers}?timeout_ms=60000", clock), clock)
    assert link.read_holding(1, 8, 3) == [8, 9, 10]
    link.write_register(1, 8, 500)
    link.write_registers(1, 9, [600, 700])
    assert link.read_holding(1, 8, 3) == [500, 600, 700]
    with pytest.raises(InstrumentError, match="exception 2") as caught:
        link.read_holding(1, 99, 5)
    assert caught.value.fault == "refused"
    link.close()


def test_a_late_reply_over_modbus_tcp_is_known_by_its_number(tcp_registers: int) -> None:
    line, clock = SlowLine(tcp_registers, at_the_next=True), RealClock()
    tcp = open_link(f"modbus-tcp://127.0.0.1:{line.port}", clock)
    link = ModbusLink(tcp, clock, framer="socket", timeout_s=1.0, quiet_s=0.0)  # nobody waits for quiet
    with pytest.raises(InstrumentError):
        link.read_holding(1, 7, 1)
    link._client._timeout_s = LONG_S
    with suppress(InstrumentError):  # the late reply may cost this request, but does not answer it
        assert link.read_holding(1, 50, 1) == [50]
    while tcp.receive(clock.now() + 0.5):
        pass
    assert link.read_holding(1, 51, 1) == [51]
    link.close()
    line.join()


@pytest.mark.parametrize(("options", "waited_s"), [("", 0.6), ("?timeout_ms=50", 0.05)])
def test_how_long_a_modbus_reply_is_waited_for_is_the_links(
    options: str, waited_s: float, caplog: pytest.LogCaptureFixture
) -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    link = modbus_link(EmulatedLink(f"emulated://nobody{options}", Nobody(), clock), clock)
    with pytest.raises(InstrumentError):
        link.read_holding(1, 0, 1)
    assert clock.now() == pytest.approx(waited_s + 0.5, abs=0.01)  # and half a second of quiet
    assert not caplog.records  # pymodbus would say it on stderr once more
    with pytest.raises(InputError, match="timeout_ms=soon"):
        modbus_link(EmulatedLink("emulated://nobody?timeout_ms=soon", Nobody(), clock), clock)


class Leaping(RealClock):
    """The clock of a computer that is held up for a minute between any two looks at it."""

    leapt_s = 0.0

    def now(self) -> float:
        self.leapt_s += 60.0
        return super().now() + self.leapt_s


def test_a_reply_that_came_while_the_computer_was_held_up_is_a_reply(tcp_registers: int) -> None:
    clock = Leaping()
    with socket.create_server(("127.0.0.1", 0)) as listener:
        link = open_link(f"tcp://127.0.0.1:{listener.getsockname()[1]}", clock)
        with listener.accept()[0] as host:
            host.sendall(b"here\nmore")
            assert link.ask(b"", end=b"\n", timeout_s=1.0) == b"here\n"
            with pytest.raises(InstrumentError, match="only b'more' came"):
                link.ask(b"", end=b"\n", timeout_s=1.0)
        link.close()
    line = open_link(f"modbus-tcp://127.0.0.1:{tcp_registers}", clock)
    send = line.send
    line.send = lambda data: (send(data), select.select([line._port._socket], [], [], LONG_S))
    modbus = ModbusLink(line, clock, framer="socket", timeout_s=1.0)
    assert modbus.read_holding(1, 50, 1) == [50]
    line.close()


# lost lines


def test_a_tcp_line_is_lost_when_the_other_side_goes() -> None:
    with socket.create_server(("127.0.0.1", 0)) as listener:
        link = open_link(f"tcp://127.0.0.1:{listener.getsockname()[1]}", RealClock())
        listener.accept()[0].close()
        with pytest.raises(InstrumentError) as caught:
            link.ask(b"*IDN?\n", end=b"\n", timeout_s=0.5)
        assert caught.value.fault == "link lost"
        link.reopen()
        host = listener.accept()[0]
        host.sendall(b"again\n")
        assert link.ask(b"*IDN?\n", end=b"\n", timeout_s=LONG_S) == b"again\n"
        host.close()
        link.close()


def test_datagrams_come_whole_and_in_order() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as finder:
        finder.bind(("127.0.0.1", 0))
        port = finder.getsockname()[1]
    clock = RealClock()
    link = open_link(f"udp://127.0.0.1:{port}", clock)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for number in range(5):
            sender.sendto(b"packet %d" % number, ("127.0.0.1", port))
        pieces = link.receive(clock.now() + 0.1)
    link.close()
    assert [data for _, data in pieces] == [b"packet %d" % n for n in range(5)]


def test_bytes_are_stamped_when_they_come_even_while_somebody_else_waits() -> None:
    clock, looks = RealClock(), list[float]()
    with socket.create_server(("127.0.0.1", 0)) as listener:
        link = open_link(f"tcp://127.0.0.1:{listener.getsockname()[1]}", clock)
        host = listener.accept()[0]

        def look() -> None:
            looks.append(clock.now())
            if len(looks) == 3:
                host.sendall(b"now")

        clock.while_waiting(look)
        while len(looks) < 20:
            clock.wait_until(clock.now() + 0.1)  # somebody else's waiting
        [(stamp, data)] = link.receive(clock.now())
        host.close()
        link.close()
    assert data == b"now"
    assert looks[2] <= stamp <= looks[10]


@pytest.mark.parametrize("url", ["ssh://x:1", "gpib://3"])
def test_a_scheme_that_is_not_known_is_refused(url: str) -> None:
    with pytest.raises(InputError, match="none of serial://"):
        open_link(url, RealClock())


def test_a_port_that_is_not_there_is_a_lost_link_with_a_remedy() -> None:
    with pytest.raises(InstrumentError) as caught:
        open_link("serial:///dev/no-such-port", RealClock())
    assert caught.value.fault == "link lost"
    assert caught.value.remedy
