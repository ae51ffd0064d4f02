"""What goes wrong on a wire, for every driver that asks: each case gives the value that was sent, or a named fault.

The questions and answers stand in wires.py; what is special to one instrument stands in its own file.
"""

from __future__ import annotations

import re
import socket
import threading
import time
from contextlib import suppress
from dataclasses import fields
from datetime import UTC, datetime
from typing import Any, get_type_hints

import pytest
from frames import rtu
from wires import DRIVERS, WIRES

from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.config import DutLimits, PlatformConfig
from labcal.bench.driver_kit.testing import SILENT, UNPLUGGED, Exchange, scripted
from labcal.bench.links import EmulatedLink, open_link
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.platform import BenchPlatform
from labcal.errors import InstrumentError, LimitError

PAUSE_S, LONG_S = 0.02, 60.0
ASKING = sorted(WIRES)
MODBUS = [name for name in ASKING if WIRES[name].ask(0)[0] == rtu(WIRES[name].ask(0)[0][:-2].hex())]


def answered(name: str, *replies: Any, **options: Any) -> list[float]:
    """What the driver reads where its questions are answered so; the first fault ends it."""
    wire = WIRES[name]
    script = [*wire.before, *((wire.ask(k)[0], reply) for k, reply in enumerate(replies))]
    with scripted(DRIVERS[name], script, **wire.settings, **options) as driver:
        wire.prepare(driver)
        return [wire.call(driver) for _ in replies]


def fault_of(name: str, *replies: Any) -> str:
    with pytest.raises(InstrumentError) as caught:
        answered(name, *replies)
    assert caught.value.remedy
    return caught.value.fault


def test_every_driver_is_here_or_only_listens() -> None:
    slow = {"pos-1", "mavlink", "twinleaf"}  # what it answers comes with a later look: test_pos1.py and their own
    listens = {
        "can-dbc", "ccsds", "csv-line", "gsm", "i2c-board", "iaga-2002", "lemi-025", "pmag", "replay", "rm3100",
        "ros-topic",
        "text-line",
    }  # fmt: skip
    assert set(WIRES) | listens | slow | {"manual"} == set(DRIVERS), "give it one question and its answer in wires.py"


@pytest.mark.parametrize("name", ASKING)
def test_its_own_bytes_are_the_value_whole_or_byte_by_byte(name: str) -> None:
    wire = WIRES[name]
    replies = wire.ask(0)[1], [bytes([byte]) for byte in wire.ask(1)[1]]
    assert answered(name, *replies) == pytest.approx([wire.value] * 2)


class InHalves:
    """A TCP port that answers as `wire` says, every reply in two sends, the second after a pause."""

    def __init__(self, wire: list[Exchange]) -> None:
        self._wire, self._server = wire, socket.create_server(("127.0.0.1", 0))
        self.url = f"tcp://127.0.0.1:{self._server.getsockname()[1]}"
        self._thread = threading.Thread(target=self._serve, daemon=True)
        self._thread.start()

    def _serve(self) -> None:
        with self._server, self._server.accept()[0] as host:
            host.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            for request, reply in self._wire:
                assert host.recv(len(request), socket.MSG_WAITALL) == request
                for part in (reply[: len(reply) // 2], reply[len(reply) // 2 :]) if isinstance(reply, bytes) else ():
                    host.sendall(part)
                    time.sleep(PAUSE_S)
            host.recv(1)  # until the host has gone: one that is late still finds its line

    def ended(self) -> bool:
        """Whether the whole script has been asked for and answered."""
        self._thread.join(LONG_S)
        return not self._thread.is_alive()


@pytest.mark.parametrize("name", ASKING)
def test_a_reply_that_comes_in_two_parts_over_a_real_line_is_one_reply(name: str) -> None:
    wire, clock, hints = WIRES[name], RealClock(), get_type_hints(DRIVERS[name].__init__)
    known = [f.name for f in fields(hints["settings"])]
    patient = {"timeout_s": LONG_S} if "timeout_s" in known else {}
    port = InHalves([*wire.before, wire.ask(0), wire.ask(1)])
    line = open_link(port.url, clock)
    link = ModbusLink(line, clock, timeout_s=LONG_S) if hints["link"] is ModbusLink else line
    driver = DRIVERS[name](name, link, clock, hints["settings"](**wire.settings, **patient))
    wire.prepare(driver)
    assert [wire.call(driver), wire.call(driver)] == pytest.approx([wire.value] * 2)
    line.close()
    assert port.ended()


@pytest.mark.parametrize("name", ASKING)
@pytest.mark.parametrize(("reply", "fault"), [(SILENT, "silent"), (UNPLUGGED, "link lost")])
def test_silence_and_a_pulled_plug_are_named(name: str, reply: Any, fault: str) -> None:
    assert fault_of(name, reply, *[SILENT] * (WIRES[name].asks - 1) * (reply is SILENT)) == fault


@pytest.mark.parametrize("name", ASKING)
def test_a_reply_cut_short_is_silence(name: str) -> None:
    assert fault_of(name, WIRES[name].ask(0)[1][:-2]) == "silent"


@pytest.mark.parametrize("name", ASKING)
def test_noise_is_no_value(name: str) -> None:
    good = WIRES[name].ask(0)[1]
    for noise in (b"\xff" * len(good) + good[-2:], b"\0" * 40, b"\r\n", *WIRES[name].nonsense):
        assert fault_of(name, noise) in ("silent", "wrong reply", "refused"), noise


@pytest.mark.parametrize("name", ASKING)
def test_an_echo_is_no_value_but_where_the_link_says_that_its_adapter_echoes(name: str) -> None:
    wire = WIRES[name]
    request, reply = wire.ask(0)
    assert fault_of(name, request) in ("silent", "wrong reply")
    with suppress(InstrumentError):
        assert answered(name, request + reply) == pytest.approx([wire.value])
    assert answered(name, reply, wire.ask(1)[1], echo=True, link="emulated://pair?echo=1") == pytest.approx(
        [wire.value] * 2
    )


@pytest.mark.parametrize("name", ASKING)
def test_a_late_reply_does_not_answer_the_next_question(name: str) -> None:
    wire = WIRES[name]
    late = [b""] * (round(wire.timeout_s / 0.005) + 10) + [wire.other]  # 50 ms after it was given up
    request, reply = wire.ask(1)
    again = [(wire.ask(0)[0], SILENT)] * (wire.asks - 1)
    script = [*wire.before, (wire.ask(0)[0], late), *again, (request, [*[b""] * 20, reply])]  # its own after 100 ms
    with scripted(DRIVERS[name], script, **wire.settings) as driver:
        wire.prepare(driver)
        with pytest.raises(InstrumentError) as caught:
            wire.call(driver)
        assert caught.value.fault == "silent"
        assert wire.call(driver) == pytest.approx(wire.value)


@pytest.mark.parametrize("name", ASKING)
def test_a_reply_that_comes_twice_does_not_answer_the_next_question(name: str) -> None:
    wire = WIRES[name]
    script = [*wire.before, (wire.ask(0)[0], wire.other * 2), wire.ask(1)]
    with scripted(DRIVERS[name], script, **wire.settings) as driver:
        wire.prepare(driver)
        with suppress(InstrumentError):  # two at once may be no reply at all
            assert wire.call(driver) != pytest.approx(wire.value)
        assert wire.call(driver) == pytest.approx(wire.value)


class Foreign:
    """A multimeter that somebody has put on this port: it says its name to whatever it is asked."""

    NAME = b"FLUKE, 45, 9080025, 2.0 D2.0\r\n"

    def __init__(self) -> None:
        self.heard, self._said = b"", list[tuple[float, bytes]]()

    def take(self, t_s: float, data: bytes) -> None:
        self.heard += data
        self._said.append((t_s + 0.01, self.NAME))

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        due = [one for one in self._said if one[0] <= until_s]
        self._said = self._said[len(due) :]
        return due

    def due_s(self) -> float:
        return self._said[0][0] if self._said else float("inf")


@pytest.mark.parametrize("name", ASKING)
def test_a_foreign_model_on_its_port_is_refused_and_is_told_no_set_point(name: str) -> None:
    hints, clock, other = (
        get_type_hints(DRIVERS[name].__init__),
        VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)),
        Foreign(),
    )
    line: Any = EmulatedLink("emulated://line", other, clock)
    link = ModbusLink(line, clock) if hints["link"] is ModbusLink else line
    driver = DRIVERS[name]("it", link, clock, hints["settings"](**WIRES[name].settings))
    with pytest.raises(InstrumentError) as caught:
        driver.identify()
    assert caught.value.fault in ("another instrument", "wrong reply", "silent", "refused", "out of step")
    assert caught.value.remedy
    assert clock.now() < 60.0
    assert not re.search(rb"(CURR|ISET|VOLT|VSET|I1|V1|PC|PV|OUTP?\d?) ?[\d.]", other.heard)


@pytest.mark.parametrize("name", MODBUS)
def test_a_bad_checksum_is_silence_and_an_exception_is_said(name: str) -> None:
    request, reply = WIRES[name].ask(0)
    assert fault_of(name, reply[:-1] + bytes([reply[-1] ^ 1])) == "silent"
    assert fault_of(name, bytes([reply[0] ^ 4]) + reply[1:]) == "silent"
    assert fault_of(name, rtu(f"{request[0]:02x}{request[1] | 0x80:02x}02")) == "refused"


SUPPLIES = sorted(name for name in ASKING if "coil" in DRIVERS[name].roles)
STAGES = sorted(name for name in ASKING if "platform" in DRIVERS[name].roles)


@pytest.mark.parametrize("name", SUPPLIES)
@pytest.mark.parametrize("amps", [99.0, -99.0, float("nan"), float("inf")])
def test_a_current_out_of_range_sends_nothing(name: str, amps: float) -> None:
    with (
        scripted(DRIVERS[name], [], **WIRES[name].settings) as supply,
        pytest.raises(LimitError, match="nothing was sent"),
    ):
        supply.set_current(amps)


@pytest.mark.parametrize("name", STAGES)
@pytest.mark.parametrize(("angle_deg", "rate"), [(401.0, 5.0), (float("nan"), 5.0), (10.0, 99.0), (10.0, 0.0)])
def test_a_move_out_of_range_sends_nothing(name: str, angle_deg: float, rate: float) -> None:
    with scripted(DRIVERS[name], []) as stage, pytest.raises(LimitError, match="nothing was sent"):
        BenchPlatform(stage, PlatformConfig(), DutLimits()).move_to(angle_deg, rate)


LISTENING = ("ccsds", "csv-line", "gsm", "i2c-board", "iaga-2002", "lemi-025", "pmag", "rm3100", "text-line")


@pytest.mark.parametrize("name", LISTENING)
@pytest.mark.parametrize("noise", [b"", b"\xff\x00\xc0\n" * 50])
def test_a_listener_that_hears_nothing_or_noise_is_silent(name: str, noise: bytes) -> None:
    with scripted(DRIVERS[name], []) as listener:
        listener._link.give_back(0.0, noise)
        with pytest.raises(InstrumentError) as caught:
            listener.identify()
    assert caught.value.fault == "silent"
    assert caught.value.remedy


@pytest.mark.parametrize("name", LISTENING)
def test_a_listener_says_nothing_and_names_a_pulled_plug(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    def lost(until_s: float) -> None:
        raise InstrumentError("the link was lost", fault="link lost")

    with scripted(DRIVERS[name], []) as listener:
        for act in (listener.start, listener.stop, listener.make_safe):
            act()
        monkeypatch.setattr(listener._link, "receive", lost)
        with pytest.raises(InstrumentError) as caught:
            listener.read_until(1.0)
    assert caught.value.fault == "link lost"
