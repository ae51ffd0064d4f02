"""Who may open what: one link a port, other programs kept out; adapters that echo; instruments on USB 488.2."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
import termios
import threading
import tty
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest
import serial
from frames import rtu

from drivers.metrolab import Metrolab
from drivers.metrolab import Settings as MetrolabSettings
from labcal.bench.clock import RealClock
from labcal.bench.links import Link, open_link
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.links.usbtmc import UsbtmcPort
from labcal.errors import InputError, InstrumentError

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
LONG_S = 60.0  # a busy machine answers within it
OPENS = """
import sys
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
link = open_link(sys.argv[1], RealClock())
print("open", flush=True)
sys.stdin.read()
"""


@contextmanager
def terminal() -> Iterator[tuple[int, str]]:
    """A pty: its master, and the path of its slave."""
    master, slave = pty.openpty()
    tty.setraw(slave)
    try:
        yield master, os.ttyname(slave)
    finally:
        os.close(slave)
        os.close(master)


def fault_of_opening(url: str) -> InstrumentError:
    with pytest.raises(InstrumentError) as caught:
        open_link(url, RealClock())
    return caught.value


def test_a_port_has_one_link_in_this_process_and_in_all_others() -> None:
    with terminal() as (_, path):
        url = f"serial://{path}?baud=9600"
        with closing(open_link(url, RealClock())):
            assert str(os.getpid()) in str(fault_of_opening(url.replace("9600", "115200")))
        with subprocess.Popen([sys.executable, "-c", OPENS, url], stdin=-1, stdout=-1, text=True) as other:
            assert other.stdout is not None
            try:
                assert other.stdout.readline() == "open\n"
                fault = fault_of_opening(f"modbus-rtu://{path}")
            finally:
                other.kill()
        assert fault.fault == "in use"
        assert f"(process {other.pid}) holds this port" in str(fault)
        open_link(url, RealClock()).close()


def test_another_program_that_keeps_a_port_to_itself_is_named_as_such() -> None:
    with terminal() as (_, path):
        with serial.Serial(path, exclusive=True):
            fault = fault_of_opening(f"serial://{path}")
        assert fault.fault == "in use"
        assert "another program has opened it" in str(fault)
        with closing(open_link(f"serial://{path}", RealClock())), pytest.raises(serial.SerialException):
            serial.Serial(path, exclusive=True)


class EchoingDevice:
    """An RS-485 adapter that hears itself, and behind it a device that gives `answers` in turn."""

    def __init__(self, master: int, answers: list[bytes]) -> None:
        self._master, self._answers = master, answers
        self._thread = threading.Thread(target=self._run, daemon=True)
        self._thread.start()

    def _run(self) -> None:
        for answer in self._answers:
            heard = os.read(self._master, 256)
            os.write(self._master, heard[:3])
            os.write(self._master, heard[3:] + answer)

    def join(self) -> None:
        self._thread.join(LONG_S)


def modbus_over_echo(options: str) -> list[int]:
    with terminal() as (master, path):
        device, clock = EchoingDevice(master, [rtu("0103 02 0007")]), RealClock()
        patience_s = LONG_S if options else 0.3
        link = ModbusLink(open_link(f"modbus-rtu://{path}{options}", clock), clock, timeout_s=patience_s, quiet_s=0.1)
        try:
            return link.read_holding(1, 7, 1)
        finally:
            device.join()
            link.close()


def test_an_adapters_echo_is_taken_off_where_the_link_says_that_it_echoes() -> None:
    assert modbus_over_echo("?echo=1") == [7]


def test_an_echo_that_is_not_stated_is_no_reply() -> None:
    with pytest.raises(InstrumentError) as caught:
        modbus_over_echo("")
    assert caught.value.fault in ("silent", "wrong reply")


def test_two_that_talk_at_once_are_noticed() -> None:
    with terminal() as (master, path), closing(open_link(f"serial://{path}?echo=1", RealClock())) as link:
        os.write(master, b"noise")
        with pytest.raises(InstrumentError, match="came back") as caught:
            link.ask(b"*IDN?\n", end=b"\n", timeout_s=LONG_S)
        assert caught.value.fault == "wrong reply"
        assert os.read(master, 10) == b"*IDN?\n"


# usbtmc://


@contextmanager
def usbtmc(answers: list[bytes], *, patience_s: float = 20.0) -> Iterator[tuple[Link, RealClock, list[bytes]]]:
    """A pty that stands in for /dev/usbtmc0: reads that find nothing end after `patience_s`, as the kernel's do."""
    heard: list[bytes] = []
    with terminal() as (master, path):
        slave = os.open(path, os.O_RDWR)
        attributes = termios.tcgetattr(slave)
        attributes[6][termios.VMIN], attributes[6][termios.VTIME] = 0, round(10 * patience_s)
        termios.tcsetattr(slave, termios.TCSANOW, attributes)
        os.close(slave)

        def answer() -> None:
            for reply in answers:
                heard.append(os.read(master, 4096))
                os.write(master, reply)

        thread = threading.Thread(target=answer, daemon=True)
        thread.start()
        clock = RealClock()
        with closing(open_link(f"usbtmc://{path}", clock)) as link:
            yield link, clock, heard
            thread.join(LONG_S)


def test_an_instrument_on_usb_is_asked_by_messages() -> None:
    idn = b"Metrolab Technology SA,THM1176-LF,0000123,EL v2.0 C v3.0\n"
    with usbtmc([idn, b'0,"No error";0\n']) as (link, clock, heard):
        assert Metrolab("ref", link, clock, MetrolabSettings()).identify().model == "THM1176-LF"
    assert heard == [b"*IDN?\n", b":SYST:ERR?;*STB?\n"]


def test_an_instrument_on_usb_is_read_only_where_it_was_asked() -> None:
    with usbtmc([b"stray\n"]) as (link, clock, heard):
        link.send(b":INIT:CONT OFF\n")
        while not heard:
            clock.wait_until(clock.now() + 0.01)
        assert link.receive(clock.now()) == []


def test_an_instrument_on_usb_that_does_not_answer_is_silent() -> None:
    with usbtmc([b""], patience_s=0.1) as (link, _, _), pytest.raises(InstrumentError) as caught:
        link.ask(b"*IDN?\n", end=b"\n", timeout_s=0.1)
    assert caught.value.fault == "silent"


def test_an_instrument_on_usb_that_announces_its_replies_delays_nobody(monkeypatch: pytest.MonkeyPatch) -> None:
    status = [0x10]
    monkeypatch.setattr(UsbtmcPort, "status_byte", lambda _: status[0])
    with usbtmc([b"RIGOL\n"]) as (link, clock, _):
        assert link.ask(b"*IDN?\n", end=b"\n", timeout_s=LONG_S) == b"RIGOL\n"
        status[0] = 0
        began_s = clock.now()
        with pytest.raises(InstrumentError) as caught:
            link.ask(b":CURR?\n", end=b"\n", timeout_s=0.1)
    assert caught.value.fault == "silent"
    assert clock.now() - began_s < 10.0, "it waited in a read that nobody can end"


def test_the_deny_list_binds_an_instrument_on_usb() -> None:
    with usbtmc([]) as (link, _, heard):
        link.never.add(Metrolab.never)
        with pytest.raises(InstrumentError) as caught:
            link.send(b"*RST\n")
    assert caught.value.fault == "forbidden"
    assert heard == []


def test_an_instrument_on_usb_that_is_not_there_is_a_lost_link() -> None:
    assert fault_of_opening("usbtmc:///dev/usbtmc99").fault == "link lost"


def test_no_message_is_written_into_a_file(tmp_path: Path) -> None:
    (tmp_path / "store.sqlite").write_text("a week's work")
    with pytest.raises(InputError, match="is no device file"):
        open_link(f"usbtmc://{tmp_path / 'store.sqlite'}", RealClock()).send(b"*IDN?\n")
    assert (tmp_path / "store.sqlite").read_text() == "a week's work"
