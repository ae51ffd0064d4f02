"""visa://: names of resources, one port however it is spelt, and an instrument behind pyvisa's own face."""

from __future__ import annotations

import sys
from contextlib import closing
from types import SimpleNamespace

import pytest

from drivers.scpi_table import Settings, TableSupply
from labcal.bench.clock import RealClock
from labcal.bench.links import messages, open_link, ports, urls, visa
from labcal.errors import InputError, InstrumentError

PATIENCE_S = 60.0


@pytest.mark.parametrize(
    ("address", "whole"),
    [
        ("GPIB::5", "GPIB0::5::INSTR"),
        ("gpib1::5::instr", "GPIB1::5::INSTR"),
        ("TCPIP::192.168.0.7", "TCPIP0::192.168.0.7::INSTR"),
        ("USB0::0x0957::0x0807::MY51::INSTR", "USB0::0x0957::0x0807::MY51::INSTR"),
        ("tcpip::h::hislip0", "TCPIP0::h::hislip0::INSTR"),
    ],
)
def test_a_resource_is_called_by_its_whole_name(address: str, whole: str) -> None:
    assert visa.canonical(address) == whole
    assert ports.port_of(f"visa://{address}") == ports.port_of(f"visa://{whole}?backend=ivi")


@pytest.mark.parametrize(
    ("address", "told"),
    [
        ("ASRL3::INSTR", "serial://"),
        ("TCPIP::h::5025::SOCKET", "tcp://"),
        ("", "no VISA resource"),
        ("GPIB", "no VISA resource"),
        ("GPIB0::", "no VISA resource"),
        ("/dev/usbtmc0", "no VISA resource"),
        ("GPIB0::5?backend=sim", "backend=sim is none of py, ivi"),
    ],
)
def test_what_is_no_resource_is_refused(address: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        urls.split(f"visa://{address}")


def test_without_pyvisa_it_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyvisa", None)
    with pytest.raises(InputError, match=r"pip install 'labcal\[visa\]'"):
        open_link("visa://GPIB0::5::INSTR", RealClock())


class VisaIOError(Exception):
    """As pyvisa's."""

    def __init__(self, abbreviation: str) -> None:
        super().__init__(abbreviation)
        self.abbreviation, self.description = abbreviation, "as VISA says it"


class Resource:
    """An instrument behind pyvisa's face: it answers one message after another; a text is an error of VISA.

    A reply is announced, as 488.2 has it, where `announces`; where that is None, the bus has no status byte.
    """

    timeout = 0.0
    announces: bool | None = None

    def __init__(self, *replies: bytes | str) -> None:
        self._replies, self.heard, self.cleared = list(replies), list[bytes](), 0
        self.read = 0

    def write_raw(self, data: bytes) -> None:
        self.heard.append(data)

    def read_stb(self) -> int:
        if self.announces is None:
            raise VisaIOError("VI_ERROR_NSUP_OPER")
        return 0x10 if self.announces and self._replies and self._replies[0] != "VI_ERROR_TMO" else 0

    def read_raw(self) -> bytes:
        self.read += 1
        reply = self._replies.pop(0)
        if isinstance(reply, str):
            raise VisaIOError(reply)
        return reply

    def clear(self) -> None:
        self.cleared += 1

    def close(self) -> None:
        """Nothing."""


def behind(monkeypatch: pytest.MonkeyPatch, *replies: bytes | str) -> Resource:
    """A stand-in for pyvisa with this instrument at GPIB0::5; elsewhere there is none."""
    resource = Resource(*replies)

    def open_resource(name: str, open_timeout: int) -> Resource:
        if name != "GPIB0::5::INSTR":
            raise VisaIOError("VI_ERROR_RSRC_NFOUND")
        return resource

    manager = SimpleNamespace(open_resource=open_resource)
    errors = SimpleNamespace(VisaIOError=VisaIOError)
    module = SimpleNamespace(ResourceManager=lambda backend: manager, errors=errors)
    monkeypatch.setitem(sys.modules, "pyvisa", module)
    return resource


def test_a_supply_behind_visa_says_who_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    resource = behind(monkeypatch, b"HEWLETT-PACKARD,6632B,US36350101,A.02.04\n", b'+0,"No error"\n')
    clock = RealClock()
    with closing(open_link("visa://GPIB::5", clock)) as link:
        supply = TableSupply("x", link, clock, Settings(model="agilent-66xx", timeout_s=PATIENCE_S))
        assert supply.identify().model == "6632B"
        link.never.add(TableSupply.never)
        with pytest.raises(InstrumentError, match="never sent"):
            link.send(b"*RST\n")
    assert resource.heard == [b"*IDN?\n", b"SYST:ERR?\n"]


def test_it_is_read_only_where_it_was_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    behind(monkeypatch)
    clock = RealClock()
    with closing(open_link("visa://GPIB0::5::INSTR", clock)) as link:
        link.send(b"CURR 0.0\n")
        assert link.receive(clock.now()) == []


@pytest.mark.parametrize(("said", "fault"), [("VI_ERROR_TMO", "silent"), ("VI_ERROR_CONN_LOST", "link lost")])
def test_silence_and_a_lost_instrument_are_told_apart(monkeypatch: pytest.MonkeyPatch, said: str, fault: str) -> None:
    resource = behind(monkeypatch, said)
    with closing(open_link("visa://GPIB0::5", RealClock())) as link, pytest.raises(InstrumentError) as caught:
        link.ask(b"*IDN?\n", end=b"\n", timeout_s=0.2)
    assert caught.value.fault == fault
    assert resource.cleared == (fault == "silent"), "what comes later must not answer the next question"


def test_who_announces_replies_is_not_read_before_one_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    resource = behind(monkeypatch, b"6632B\n", "VI_ERROR_TMO")
    resource.announces = True
    clock = RealClock()
    with closing(open_link("visa://GPIB0::5", clock)) as link:
        assert link.ask(b"*IDN?\n", end=b"\n", timeout_s=PATIENCE_S) == b"6632B\n"
        with pytest.raises(InstrumentError) as caught:
            link.ask(b"CURR?\n", end=b"\n", timeout_s=0.2)
        assert (caught.value.fault, resource.read) == ("silent", 1), "a read waits for two seconds and cannot be ended"
        link.send(b"CURR 0.0\n")
        assert resource.heard[-1] == b"CURR 0.0\n"
        asked_s = clock.now()
        link.send(b"CURR?\n")
        while not resource.cleared:
            assert link.receive(clock.now() + 0.01) == []
        assert clock.now() - asked_s >= messages.TIMEOUT_S, "a reply that comes later answers no other question"


@pytest.mark.parametrize("announces", [None, False])
def test_who_announces_nothing_is_read_all_the_same(monkeypatch: pytest.MonkeyPatch, announces: bool | None) -> None:
    resource = behind(monkeypatch, b"6032A\n", b"1.5\n")
    resource.announces = announces
    clock = RealClock()
    with closing(open_link("visa://GPIB0::5", clock)) as link:
        asked_s = clock.now()
        assert link.ask(b"ID?\n", end=b"\n", timeout_s=PATIENCE_S) == b"6032A\n"
        assert (clock.now() - asked_s >= messages.UNANNOUNCED_S) is (announces is False)
        resource.announces = True
        assert link.ask(b"IOUT?\n", end=b"\n", timeout_s=PATIENCE_S) == b"1.5\n"


def test_an_instrument_that_is_not_there_is_a_lost_link(monkeypatch: pytest.MonkeyPatch) -> None:
    behind(monkeypatch)
    with pytest.raises(InstrumentError) as caught:
        open_link("visa://GPIB0::6", RealClock())
    assert caught.value.fault == "link lost"
