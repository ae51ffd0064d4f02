"""The lock that lies on a device itself, and connections on the network: what users who share no folder see."""

from __future__ import annotations

import os
import pty
import socket
import tty
from collections.abc import Iterator
from pathlib import Path

import pytest
from other_users import ALICE, BOB, OF_ROOT, done, user

pytestmark = OF_ROOT
PORT = "tcp://192.0.2.1:9221"


@pytest.fixture
def terminal() -> Iterator[str]:
    """A pty that all may open."""
    master, slave = pty.openpty()
    tty.setraw(slave)
    os.chmod(os.ttyname(slave), 0o666)
    yield os.ttyname(slave)
    for end in (slave, master):
        os.close(end)


def test_a_device_that_another_user_has_open_is_refused_with_his_name(common: Path, terminal: str) -> None:
    url = f"serial://{terminal}?baud=9600"
    opens = f"link = open_link({url!r}, RealClock()); say('open'); sys.stdin.read()"
    tries = f"""
say(ports.hold([{url!r}, {PORT!r}]))
try: open_link({url!r}, RealClock())
except InstrumentError as fault: say([fault.fault, str(fault)])
"""
    with user(ALICE, common, opens) as alice:
        assert alice.says() == "open"
        with user(BOB, common, tries) as bob:
            assert bob.says() is True  # what it can reach it holds
            fault, said = bob.says()
        assert fault == "in use"
        assert f"of user {ALICE} (process {alice.pid}) since 20" in said
        assert f"Ask user {ALICE} to end it" in said
        alice.kill()
        assert done(BOB, common, f"open_link({url!r}, RealClock()); say('open')") == "open"


def test_a_device_stays_locked_while_its_link_is_opened_again(common: Path, terminal: str) -> None:
    url = f"serial://{terminal}"
    keeps = f"""
ports.hold([{url!r}])
link = open_link({url!r}, RealClock())
link.close(); say('closed'); sys.stdin.readline()
link.reopen(); say('open again'); sys.stdin.readline()
ports.let_go(); link.close(); say('let go'); sys.stdin.readline()
"""
    opens = f"""
try: open_link({url!r}, RealClock()); say('open')
except InstrumentError as fault: say(fault.fault)
"""
    with user(ALICE, common, keeps) as alice:
        assert alice.says() == "closed"
        assert done(BOB, common, opens) == "in use"
        alice.go_on()
        assert alice.says() == "open again"
        assert done(BOB, common, opens) == "in use"
        alice.go_on()
        assert alice.says() == "let go"
        assert done(BOB, common, opens) == "open"


def test_a_device_that_was_unplugged_is_let_go_of_and_taken_again(common: Path) -> None:
    work = """
def plug():
    ends = pty.openpty()
    return ends, os.ttyname(ends[1])
ends, name = plug()
url = f"serial://{name}"
ports.hold([url])
link = open_link(url, RealClock())
for end in ends: os.close(end)
try: link.ask(b"x", end=1, timeout_s=0.1)
except InstrumentError as fault: say(fault.fault)
mine = ports._held[name]
say(mine.device is None and mine.file is not None)
ends, again = plug()  # the kernel gives it its name again only when nobody has the old one
say(again == name)
link.reopen()
say(holders.locker(name) == os.getpid())
"""
    with user(ALICE, common, work) as alice:
        assert [alice.says() for _ in range(4)] == ["link lost", True, True, True]


def test_a_terminal_is_shut_to_programs_that_ask_for_no_lock(common: Path, terminal: str) -> None:
    shuts = f"""
devices.NAMED_TERMINAL = "/nowhere"
device = devices.lock({terminal!r})
devices.shut(device, {terminal!r}); say('shut'); sys.stdin.readline()
devices.reopen(device); say('for this process'); sys.stdin.readline()
devices.shut(device, {terminal!r}); devices.unlock(device); say('unlocked'); sys.stdin.readline()
"""
    opens = f"""
try: os.close(os.open({terminal!r}, os.O_RDWR | os.O_NOCTTY)); say('open')
except OSError as error: say(error.errno)
try: devices.unlock(devices.lock({terminal!r}, 0.0)); say('locked')
except BlockingIOError: say('busy')
"""

    def tries() -> list[object]:
        with user(BOB, common, opens) as bob:
            return [bob.says(), bob.says()]

    with user(ALICE, common, shuts) as alice:
        assert alice.says() == "shut"
        assert tries() == [16, "busy"]
        alice.go_on()
        assert alice.says() == "for this process"
        assert tries() == ["open", "busy"]
        alice.go_on()
        assert alice.says() == "unlocked"
        assert tries() == ["open", "locked"]


@pytest.mark.parametrize(
    "link", ["tcp://localhost:{}", "tcp://127.0.0.1:{}", "modbus-rtu://socket://127.0.0.1:{}?baud=9600"]
)
def test_a_network_port_that_another_users_program_has_open_is_refused_with_his_name(common: Path, link: str) -> None:
    connects = "end = socket.create_connection(('127.0.0.1', %d)); say('connected'); sys.stdin.read()"
    tries = """
def tries():
    try: return ports.refuse_connected(["serial:///dev/ttyUSB7", "udp://0.0.0.0:9", "usbtmc:///dev/usbtmc0", %r])
    except InstrumentError as fault: return [fault.fault, str(fault)]
say(tries())
"""
    with socket.create_server(("127.0.0.1", 0)) as supply:
        port = supply.getsockname()[1]
        asked = tries % link.format(port)
        assert done(BOB, common, asked) is None
        with user(ALICE, common, connects % port) as alice:
            assert alice.says() == "connected"
            fault, said = done(BOB, common, asked)
            assert (fault, f"a program of user {ALICE} is connected to it" in said) == ("in use", True)
            assert done(ALICE, common, asked) is None  # his own are told apart by their locks
            asks = f"""
class Config: guarded_links = [{link.format(port)!r}]
(bench := Path(common) / "bench.toml").write_text("")
try: client.GuardianClient(bench, Config, RealClock())
except InstrumentError as fault: say([fault.fault, str(fault)])
"""
            assert done(BOB, common, asks) == [fault, said]  # and no guardian was started
