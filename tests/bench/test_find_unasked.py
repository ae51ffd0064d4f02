"""What `bench find` knows of without a question: numbers on USB, what VISA lists, what announces itself by mDNS."""

from __future__ import annotations

import socket
import sys
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from labcal.bench import find as looking
from labcal.bench.clock import RealClock
from labcal.bench.find import Found, draft, find, places
from labcal.bench.links import plugged, visa
from labcal.bench.links.announced import SERVICES, Announced, announced
from labcal.bench.links.plugged import Plugged
from labcal.bench.loading import recogniser
from labcal.cli import execute
from labcal.errors import InputError

TRIES = 20  # of 3 s each: a busy machine answers within one of them
FACTS = {"Manufacturer": "Siglent Technologies", "Model": "SPD3303X", "SerialNumber": "A1", "FirmwareVersion": "1.01"}


@pytest.mark.parametrize(
    ("device", "driver", "says"),
    [
        (Plugged(0x0403, 0xFAF0, "Kinesis K10CR1", "/dev/null"), "thorlabs-apt", "USB 0403:faf0 Kinesis K10CR1"),
        (Plugged(0x0403, 0x6001, "FT232R USB UART", "/dev/null"), "", "an FTDI adapter; nobody answered"),
        (Plugged(0x232E, 0x0010, "PS 2000 B", "/dev/null"), "ea-ps2000b", "odd parity"),
        (Plugged(0xBEEF, 0x0001, "", "/dev/null"), "", "USB beef:0001: a device that is not known"),
    ],
)
def test_a_port_where_nobody_answers_is_named_by_its_numbers(
    device: Plugged, driver: str, says: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(looking, "asked", lambda link, clock, recognise: [])
    monkeypatch.setattr(looking, "serial_ports", lambda: [device, Plugged(0x1A86, 0x7523, "", "/dev/zero")])
    (one,) = find(["serial:///dev/null"], RealClock())
    assert (one.link, one.driver) == ("serial:///dev/null", driver)
    assert says in one.said


def test_what_is_no_port_is_known_by_its_numbers_too(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name, numbers in {"1-1": ("0cd5", "0006"), "1-2": ("046d", "c31c"), "1-1:1.0": ()}.items():
        (folder := tmp_path / name).mkdir()
        for file, number in zip(("idVendor", "idProduct"), numbers, strict=False):
            (folder / file).write_text(f"{number}\n")
    (tmp_path / "1-1" / "product").write_text("LabJack U6\n")
    monkeypatch.setattr(plugged, "DEVICES", tmp_path)
    (one,) = find(["usb://"], RealClock())
    assert (one.link, one.driver, one.kind) == ("daq://u6", "daq-inputs", "reference")
    assert one.said.startswith("USB 0cd5:0006 LabJack U6")
    assert "uT_per_V = [ , , ]" in draft([one])


def test_every_driver_and_kind_of_the_numbers_is_one_of_ours() -> None:
    from importlib.metadata import entry_points

    from labcal.bench.find.known_usb import KNOWN

    drivers = {entry.name for entry in entry_points(group="labcal.drivers")}
    assert {one.driver for one in KNOWN.values()} - {""} <= drivers
    assert all(bool(one.driver) == bool(one.kind) for one in KNOWN.values())


def test_visa_is_asked_what_it_sees_here_and_the_network_is_only_told(monkeypatch: pytest.MonkeyPatch) -> None:
    seen = ("GPIB0::5::INSTR", "TCPIP::10.0.0.7::INSTR", "ASRL/dev/ttyS0::INSTR", "TCPIP::10.0.0.8::5025::SOCKET",
            "GPIB0::INTFC")  # fmt: skip
    module = SimpleNamespace(ResourceManager=lambda backend: SimpleNamespace(list_resources=lambda query: seen))
    monkeypatch.setitem(sys.modules, "pyvisa", module)
    questions = list[str]()

    def asked(link: str, clock: Any, recognise: Any) -> Iterator[Found]:
        questions.append(link)
        yield Found(link, "HEWLETT-PACKARD,6632B,US1,A.02", "scpi-table", "coil")

    monkeypatch.setattr(looking, "asked", asked)
    found = list(find(["visa://"], RealClock()))
    assert questions == ["visa://GPIB0::5::INSTR"]
    assert [(one.link, one.driver) for one in found] == [
        ("visa://GPIB0::5::INSTR", "scpi-table"), ("visa://TCPIP::10.0.0.7::INSTR", ""),
    ]  # fmt: skip
    assert "not asked" in found[1].said


def test_a_backend_that_cannot_look_sees_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(query: str) -> list[str]:
        raise NotImplementedError

    module = SimpleNamespace(ResourceManager=lambda backend: SimpleNamespace(list_resources=fails))
    monkeypatch.setitem(sys.modules, "pyvisa", module)
    assert visa.resources() == []


@pytest.mark.parametrize(("place", "module"), [("visa://", "pyvisa"), ("mdns://", "zeroconf")])
def test_an_extra_that_is_missing_is_named(
    place: str, module: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    assert execute(["bench", "find", place]) == 2
    assert "pip install 'labcal[" in capsys.readouterr().err


def test_unasked_it_looks_where_the_extras_are_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.bench.find.where.DEVICES", ("/dev/zero",))
    monkeypatch.setattr("labcal.bench.find.where.find_spec", lambda module: None if module == "pyvisa_py" else module)
    assert places([]) == ["serial:///dev/zero", "usb://", "mdns://"]


@pytest.fixture
def announcing() -> Iterator[socket.socket]:
    """An instrument that announces itself on loopback alone, and its port, at which nobody should knock."""
    zeroconf = pytest.importorskip("zeroconf")
    with (
        socket.create_server(("127.0.0.1", 0)) as port,
        closing(zeroconf.Zeroconf(interfaces=["127.0.0.1"], ip_version=zeroconf.IPVersion.V4Only)) as network,
    ):
        for kind, number in (("_lxi._tcp.local.", 80), ("_scpi-raw._tcp.local.", port.getsockname()[1])):
            told = {"port": number, "addresses": [socket.inet_aton("127.0.0.1")], "properties": FACTS}
            network.register_service(zeroconf.ServiceInfo(kind, f"labcal test {number}.{kind}", **told))
        yield port


def test_what_announces_itself_is_named_and_nobody_connects_to_it(announcing: socket.socket) -> None:
    link = f"tcp://127.0.0.1:{announcing.getsockname()[1]}"
    for _ in range(TRIES):
        found = list(find(["mdns://127.0.0.1"], RealClock(), recogniser("scpi-table")))
        if mine := [one for one in found if one.link == link]:
            break
    assert [(one.driver, one.settings) for one in mine] == [("scpi-table", 'model = "siglent-spd3303x"')]
    assert mine[0].said.startswith("Siglent Technologies,SPD3303X,A1,1.01: announces itself; not asked")
    announcing.setblocking(False)
    with pytest.raises(BlockingIOError):
        announcing.accept()


def test_what_does_not_say_who_it_is_goes_by_the_name_of_its_service(monkeypatch: pytest.MonkeyPatch) -> None:
    said = Announced("10.0.0.9", "http://10.0.0.9:80", "Oscilloscope\n[instruments.x]")
    monkeypatch.setattr(looking, "announced", lambda interface: [said])
    (one,) = find(["mdns://"], RealClock())
    assert one.driver == ""
    assert one.said.endswith("`labcal bench find 10.0.0.9` asks its usual ports")
    assert "\n[instruments.x]" not in draft([one])


def test_what_a_device_says_of_itself_reaches_no_terminal_unseen() -> None:
    from labcal.bench.links.announced import in_words
    from labcal.bench.links.plugged import printable

    info: Any = SimpleNamespace(decoded_properties={"model": "M\x1b[2J", "Manufacturer": "A\n"})
    assert in_words(info, "x._lxi._tcp.local.") == "A ,M [2J,,"
    assert in_words(SimpleNamespace(decoded_properties={}), "\x1b]0;x\x07" + "y" * 500)[:5] == " ]0;x"
    assert printable("U6\x1b[31m\n") == "U6[31m"


def test_an_address_that_is_none_of_this_computer_is_refused() -> None:
    pytest.importorskip("zeroconf")
    with pytest.raises(InputError, match="state an IPv4 address of this computer"):
        announced("192.0.2.1")


def test_every_service_has_a_link() -> None:
    assert {link.partition("://")[0] for link in SERVICES.values()} == {"tcp", "visa", "http"}
