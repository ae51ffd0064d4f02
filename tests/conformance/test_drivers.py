"""Every registered driver keeps the house's promises, on its own emulator, byte for byte."""

from __future__ import annotations

import ast
import dataclasses
import inspect
import os
import pty
import random
import re
import sys
import tty
from collections.abc import Iterator
from contextlib import closing, suppress
from datetime import UTC, datetime
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, get_type_hints

import numpy as np
import pytest

from drivers.emulators.modbus_rtu import crc
from labcal.bench.clock import RealClock, VirtualClock
from labcal.bench.instrument import quantity
from labcal.bench.links import EmulatedLink, WiredLink, open_link
from labcal.bench.links.modbus import ModbusLink
from labcal.bench.roles import (
    CoilSupply,
    DutStream,
    Identity,
    Instrument,
    Interlock,
    Magnetometer,
    PolarityRelay,
    RotationPlatform,
    Unacknowledged,
    Watched,
)
from labcal.errors import InstrumentError, LimitError
from labcal.twin import open_twin

DRIVERS = {entry.name: entry for entry in entry_points(group="labcal.drivers")}
EMULATORS = {entry.name: entry for entry in entry_points(group="labcal.emulators")}
ROLES: dict[str, type] = {
    "coil": CoilSupply,
    "polarity": PolarityRelay,
    "interlock": Interlock,
    "platform": RotationPlatform,
    "reference": Magnetometer,
    "dut": DutStream,
}
FIRST = {"coil": "coil-x"}
SETTINGS: dict[str, dict[str, Any]] = {  # what a driver cannot do without
    "waveshare-relay": {"x": 0, "y": 1, "z": 2},
    "replay": {"file": str(Path(__file__).parents[1] / "drivers" / "replayed.csv")},
    "csv-line": {"columns": ("t", "x", "y", "z", "temp_dut", "i_eps"), "serial": "7"},
}
FORBIDDEN = {  # a message of each driver's deny-list
    "tti-pl": [b"*RST\n", b"*rst\n", b"SAV1 1\n", b"RCL1 1\n"],
    "rigol-dp800": [b"*RST\n", b"*SAV 1\n", b"*RCL 1\n", b"*TST?\n"],
    "zaber": [b"/1 1 01 move rel 5\r\n", b"/1 1 01 move vel 5\r\n", b"/1 0 01 system restore\r\n", b"/renumber\r\n"],
    "hmr2300": [b"*00SP\r", b"*99RST\r", b"*99!BR=F\r", b"*99ID=07\r", b"*00T\r", b"*00D\r", b"*00ZN\r"],
    "waveshare-relay": [bytes.fromhex(h) for h in ("010500005500", "010500FFFF00", "010602000007", "010F00000008")],
    "waveshare-interlock": [
        bytes.fromhex(h)
        for h in (
            "01050000FF00",
            "010500005500",
            "010500FF0000",
            "01050200FF00",
            "010502000000",
            "01050400000A",
            "0105010000FF",
            "010602000007",
            "010F00000008",
        )
    ],
    "csv-line": [b"x"],
    "pmag": [b"$"],
    "lemi-025": [b"L"],
    "replay": [b"1"],
    "rm3100": [b"\x01"],
    "text-line": [b"x"],
    "alphalab": [bytes([code, 0, 0, 0, 0, 0]) for code in (0x04, 0x05, 0x0B, 0x0C, 0x0E, 0x14)],
    "metrolab": [b"*RST\n", b":CAL\n", b":SYST:PRES\n", b":INIT;*SAV 1\n", b":MEM:DATA?\n"],
    "ccsds": [b"\xc0"],
    "kepco-bop": [b"DIAG:TST?\n", b"diag:tst?\n", b"*RST\n", b"*TST?\n", b"CAL:CURR\n", b"OUTP 1;DIAG:TST?\n"],
    "riden-rd60xx": [bytes.fromhex(h) for h in ("010601001601", "010600360001", "01060013", "000601001601", "0110")],
    "ea-9000": [bytes.fromhex(h) for h in ("00060000", "000F0195", "001001F4", "000501955500", "0005019BFF00")],
    "keysight-e36300": [b"*RST\n", b"*SAV 1\n", b"OUTP:PAIR SER\n", b"OUTP:TRAC ON\n", b"CAL:SEC:STAT OFF\n"],
    "korad-ka3005p": [b"SAV1", b"RCL1", b"rcl2\n", b"TRACK1"],
    "newport-esp301": [b"1PR5\r", b"1MV+\r", b"1DH\r", b"SM\r", b"RS\r", b"1PA5;1PR5\r", b"1SN7\r"],
    "newport-smc100": [b"1PR5\r\n", b"1PW1\r\n", b"1RS\r\n", b"1SA2\r\n", b"1ZX3\r\n"],
    "oriental-az": [bytes.fromhex(h) for h in ("01060058", "011000580010200000000000000002", "0110007C00020400000040")],
    "leadshine": [bytes.fromhex(h) for h in ("010618012211", "010618014001", "010660020021", "0110620000060C0041")],
    "manual": [b"x"],
}
TO_PANEL = {  # what a supply's driver says last, once zero and off are read back; the others' panels need no word
    "tti-pl": b"LOCAL\n",
    "rigol-dp800": b":SYST:LOC\n",
    "keysight-e36300": b"SYST:LOC\n",
    "ea-9000": bytes.fromhex("000501920000"),
}
LONGER = {
    "EaSupply": "remote control is taken from one interface, held and given back",
}


class Foretold:
    """An emulator that is held to what it foresees: who serves it sleeps until then."""

    def __init__(self, emulator: Any) -> None:
        self._emulator, self.take, self.due_s = emulator, emulator.take, emulator.due_s

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        due_s, pieces = self.due_s(), self._emulator.emit(until_s)
        assert min(t for t, _ in pieces) == pytest.approx(due_s, abs=1e-6) if pieces else due_s > until_s
        return pieces


class Rig:
    """One driver on its emulator, and what went over the line."""

    def __init__(self, name: str, **stated: Any) -> None:
        self.name = name
        self.driver_class, emulator = DRIVERS[name].load(), EMULATORS[name].load()
        hints = get_type_hints(self.driver_class.__init__)
        self.settings = hints["settings"](**SETTINGS.get(name, {}), **stated)
        self.role = self.driver_class.roles[0]
        self.lab, self.clock = open_twin({}, 1), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
        roles = {FIRST.get(self.role, self.role): {}}
        self.line = EmulatedLink("emulated://rig", Foretold(emulator(self.lab, roles, self.settings)), self.clock)
        modbus = hints["link"] is ModbusLink
        self.line.never.add(self.driver_class.never, self.settings.address if modbus else None)
        self.sent: list[bytes] = []
        send = self.line.send
        self.line.send = lambda data: (send(data), self.sent.append(data))[0]
        link: Any = ModbusLink(self.line, self.clock) if modbus else self.line
        self.driver: Any = self.driver_class("rig", link, self.clock, self.settings)

    def wait(self, seconds: float) -> None:
        self.clock.wait_until(self.clock.now() + seconds)


@pytest.fixture(params=sorted(DRIVERS))
def rig(request: pytest.FixtureRequest) -> Rig:
    return Rig(request.param)


@pytest.fixture(params=sorted(name for name, entry in DRIVERS.items() if "coil" in entry.load().roles))
def supply(request: pytest.FixtureRequest) -> Rig:
    rig = Rig(request.param)
    rig.driver.identify()
    return rig


def test_every_driver_has_an_emulator_and_a_forbidden_message_that_is_tried() -> None:
    assert set(DRIVERS) == set(EMULATORS)
    assert set(DRIVERS) == set(FORBIDDEN)


def test_every_driver_stands_in_the_docs_and_every_supply_says_whether_it_has_a_watchdog() -> None:
    docs = Path(__file__).parents[2] / "docs"
    named = re.findall(r"^\|( `.*?) \|", (docs / "bench.md").read_text(), re.MULTILINE)
    assert set(DRIVERS) <= set(re.findall(r"`([\w-]+)`", " ".join(named)))
    watchdogs = (docs / "instruments.md").read_text().partition("## A supply's own watchdog")[2]
    makers = {"tti-pl": "Aim-TTi", "ea-9000": "EA"}
    for name in (n for n, entry in DRIVERS.items() if "coil" in entry.load().roles):
        assert makers.get(name, name.split("-")[0].title()) in watchdogs, name


def test_it_says_who_it_is(rig: Rig) -> None:
    identity = rig.driver.identify()
    assert isinstance(identity, Identity)
    assert identity.model


def test_it_has_the_methods_of_its_role(rig: Rig) -> None:
    assert isinstance(rig.driver, Instrument)
    assert isinstance(rig.driver, ROLES[rig.role])


def test_make_safe_may_be_called_twice(rig: Rig) -> None:
    rig.driver.identify()
    rig.driver.make_safe()
    rig.driver.make_safe()
    rig.driver.close()


def test_it_explains_itself(rig: Rig) -> None:
    module = inspect.getmodule(rig.driver_class)
    assert module is not None
    public = [v for k, v in vars(rig.driver_class).items() if not k.startswith("_") and callable(v)]
    for thing in (module, rig.driver_class, type(rig.settings), *public):
        assert (inspect.getdoc(thing) or "").strip(), thing


def test_its_numbers_have_units_and_words_and_what_is_set_has_limits(rig: Rig) -> None:
    for name, number in vars(rig.driver_class).items():
        if isinstance(number, quantity):
            assert number.unit, name
            assert number.__doc__, name
            assert not number.set or number.limits is not None, f"{name} can be set without a limit"


def test_its_settings_are_frozen_and_have_defaults(rig: Rig) -> None:
    assert dataclasses.is_dataclass(rig.settings)
    assert type(rig.settings).__dataclass_params__.frozen


def test_a_dangerous_message_cannot_be_sent(rig: Rig) -> None:
    name = next(n for n, entry in DRIVERS.items() if entry.load() is rig.driver_class)
    for message in FORBIDDEN[name]:
        with pytest.raises(InstrumentError, match="never sent") as caught:
            rig.line.send(message)
        assert caught.value.fault == "forbidden"
    assert rig.sent == []


def use(rig: Rig) -> None:
    """Have the driver say most of what it can."""
    for step in ("identify", "start", "home", lambda d: d.output(True), lambda d: d.set_current(0.5),
                 lambda d: d.set_polarity("x", -1), lambda d: d.move_to(30.0, 5.0), lambda d: d.moving(),
                 lambda d: d.measure_current(), lambda d: d.angle_deg(), "make_safe"):  # fmt: skip
        with suppress(AttributeError, InstrumentError):
            step(rig.driver) if callable(step) else getattr(rig.driver, step)()
        rig.wait(8.0 if step == "home" else 0.1)


def spoilt(message: bytes, chance: random.Random) -> Iterator[bytes]:
    """It with other numbers and none, cut, with a byte turned, and, of a Modbus frame, any request that is sound."""
    for other in (b"", b"?", b"-", b".", b"1.2.3", b"-7", b"1e999", b"999999999999", b"\xc2\xb2", b"nan"):
        yield re.sub(rb"-?\d+\.?\d*(?=\D*$)", lambda _, other=other: other, message)
    for _ in range(10):
        at = chance.randrange(len(message))
        yield message[:at] + chance.randbytes(1) + message[at + 1 :]
        yield message[:at] + message[-1:]
        pdu = message[:1] + bytes([chance.choice((1, 3, 4, 5, 6, 15, 16, 22)), *chance.randbytes(4)])
        pdu += b"" if pdu[1] not in (15, 16) else bytes([2]) + chance.randbytes(2)
        yield pdu + crc(pdu)


def test_whatever_it_is_told_an_emulator_goes_on(rig: Rig) -> None:
    use(rig)
    emulator, chance, heard = rig.line._emulator, random.Random(1), rig.sent or [b"hello\r\n"]
    for message in (*FORBIDDEN[rig.name], *sorted(set(heard))):
        for nonsense in spoilt(message, chance):
            rig.wait(0.2)
            emulator.take(rig.clock.now(), nonsense)
            emulator.emit(rig.clock.now() + 0.1)
    rig.wait(1.0)
    emulator.take(rig.clock.now(), b"\x1b\r\n")  # ends a stream, and what was cut
    rig.wait(1.0)
    rig.line.flush()
    assert not rig.sent or rig.driver.identify().model


def test_a_driver_is_short(rig: Rig) -> None:
    lines = Path(inspect.getfile(rig.driver_class)).read_text().count("\n")
    assert lines <= 150 or rig.driver_class.__name__ in LONGER, f"{lines} lines: a driver has 40 to 150"


def test_a_supply_sets_reads_back_and_measures(supply: Rig) -> None:
    supply.driver.set_current(0.0)
    supply.driver.output(True)
    supply.driver.set_current(0.5)
    supply.wait(0.5)
    assert supply.driver.set_point() == pytest.approx(0.5, abs=0.001)
    assert supply.driver.measure_current() == pytest.approx(0.5, abs=0.01)
    assert supply.lab.coils["x"].current.now(supply.clock.now()) == pytest.approx(0.5, abs=0.001)


def test_a_supply_whose_answers_are_all_lost_hears_zero_and_off_at_once(supply: Rig) -> None:
    supply.driver.output(True)
    supply.driver.set_current(0.5)
    supply.wait(0.5)
    begun_s, emulator = supply.clock.now(), supply.line._emulator
    emit, emulator.emit = emulator.emit, lambda until_s: (emit(until_s), [])[1]
    assert isinstance(supply.driver, Unacknowledged)
    with pytest.raises(LimitError):
        supply.driver.write_current(99.0)
    supply.driver.write_current(0.2)
    supply.driver.write_current(0.0)
    took_s = supply.clock.now() - begun_s
    supply.wait(0.3)
    assert supply.lab.coils["x"].current.now(supply.clock.now()) == pytest.approx(0.0, abs=0.001)
    supply.driver.write_off()
    assert took_s < 0.6
    emulator.emit = emit
    supply.wait(1.0)
    supply.line.flush()
    assert supply.driver.set_point() == 0.0
    assert getattr(supply.driver, "enabled", 0) == 0


def test_a_supply_refuses_what_is_too_much_and_sends_nothing(supply: Rig) -> None:
    before = len(supply.sent)
    with pytest.raises(LimitError, match=r"99 A.*nothing was sent"):
        supply.driver.set_current(99.0)
    if not supply.driver.bipolar:
        with pytest.raises(LimitError):
            supply.driver.set_current(-0.1)
    assert len(supply.sent) == before


def test_a_supply_made_safe_has_no_current_and_no_output_and_its_panel_back(supply: Rig) -> None:
    supply.driver.output(True)
    supply.driver.set_current(1.0)
    supply.wait(0.5)
    supply.driver.make_safe()
    if last := TO_PANEL.get(supply.name):
        assert supply.sent[-1].startswith(last)
    assert [said for said in supply.sent[:-1] if said.startswith(tuple(TO_PANEL.values()))] == []
    supply.wait(0.5)
    assert supply.driver.measure_current() == pytest.approx(0.0, abs=supply.driver.zero_current_A)
    assert supply.driver.set_point() == 0.0


def test_a_supply_ramps_its_full_current_in_time(supply: Rig) -> None:
    assert supply.settings.max_current_A / supply.driver.ramp_A_per_s <= 1.5
    assert 0 < supply.driver.zero_current_A < 0.1


INTERLOCKS = sorted(n for n, e in DRIVERS.items() if "interlock" in e.load().roles)


def energised(rig: Rig) -> float:
    """What 1 A set on coil x would be now [A]."""
    return abs(rig.lab.coils["x"].current.now(rig.clock.now()))


@pytest.fixture(params=INTERLOCKS)
def interlock(request: pytest.FixtureRequest) -> Rig:
    rig = Rig(request.param)
    rig.driver.identify()
    rig.driver.arm()
    rig.lab.coils["x"].drive(rig.clock.now(), 1.0, 20.0, True)
    rig.wait(0.5)
    return rig


def test_an_interlock_that_is_fed_lets_the_current_through_and_no_longer(interlock: Rig) -> None:
    for _ in range(6):
        assert energised(interlock) == pytest.approx(1.0, abs=0.01)
        interlock.wait(interlock.driver.watchdog_s / 3)
        interlock.driver.feed()
    interlock.wait(interlock.driver.watchdog_s + 0.5)
    assert energised(interlock) < 0.001


def test_an_interlock_that_has_fallen_open_is_not_closed_again_under_a_set_point(interlock: Rig) -> None:
    interlock.wait(interlock.driver.watchdog_s + 0.5)
    before = len(interlock.sent)
    with pytest.raises(InstrumentError, match="falls open") as caught:
        interlock.driver.feed()
    assert (caught.value.fault, len(interlock.sent)) == ("interlock", before)
    assert energised(interlock) < 0.001


def test_an_interlock_that_is_disarmed_or_made_safe_is_open_at_once(interlock: Rig) -> None:
    interlock.driver.make_safe()
    interlock.wait(0.3)
    assert energised(interlock) < 0.001


@pytest.mark.parametrize("name", sorted(n for n, e in DRIVERS.items() if "coil" in e.load().roles))
def test_a_supply_with_a_watchdog_falls_to_zero_when_it_is_not_heard(name: str) -> None:
    known = {f.name for f in dataclasses.fields(get_type_hints(DRIVERS[name].load().__init__)["settings"])}
    rig = Rig(name, **({"watchdog_s": 4} if "watchdog_s" in known else {}))
    assert isinstance(rig.driver, Watched) == ("watchdog_s" in known)
    if "watchdog_s" not in known:
        return
    assert Rig(name).driver.watchdog_s == 0
    rig.driver.identify()
    rig.driver.set_current(0.0)
    rig.driver.output(True)
    rig.driver.set_current(1.0)
    for _ in range(6):
        rig.wait(1.3)
        assert energised(rig) == pytest.approx(1.0, abs=0.01)
        rig.driver.feed()
    rig.wait(4.5)
    assert energised(rig) < 0.001


@pytest.mark.parametrize("name", ["ea-9000", "keysight-e36300"])
def test_a_supply_that_was_given_back_to_its_panel_is_left_alone(name: str) -> None:
    rig = Rig(name, watchdog_s=4)
    rig.driver.output(True)
    rig.driver.make_safe()
    before = len(rig.sent)
    rig.driver.feed()
    assert len(rig.sent) == before


@pytest.mark.parametrize("name", sorted(n for n, e in DRIVERS.items() if {"reference", "dut"} & set(e.load().roles)))
def test_a_stream_gives_finite_ordered_samples_with_their_raw_bytes(name: str) -> None:
    rig = Rig(name)
    rig.driver.identify()
    rig.driver.start()
    blocks = [b for _ in range(20) for b in rig.driver.read_until(rig.clock.now() + 0.37)]
    rig.driver.stop()
    main = [b for b in blocks if b.stream in ("dut", "reference")]
    stamps = np.concatenate([b.t_s for b in main])
    assert len(stamps) > 40
    assert (np.diff(stamps) > 0).all()
    assert all(np.isfinite(b.values).all() and b.raw for b in main)


STAGES = sorted(name for name, entry in DRIVERS.items() if "platform" in entry.load().roles and entry.load().motorised)


@pytest.mark.parametrize("name", STAGES)
@pytest.mark.parametrize("limit_deg_per_s", [25.0, 4.0])
def test_a_stage_homes_no_faster_than_the_dut_may_turn_or_refuses(name: str, limit_deg_per_s: float) -> None:
    rig = Rig(name)
    rig.driver.identify()
    platform, fastest = rig.lab.platform, 0.0
    platform.move(rig.clock.now(), 40.0, 40.0)
    while platform.moving(rig.clock.now()):
        rig.wait(0.1)
    with suppress(LimitError):
        rig.driver.home(limit_deg_per_s)
    for _ in range(20):
        before = platform.now(rig.clock.now())[0]
        rig.wait(0.2)
        fastest = max(fastest, abs(platform.now(rig.clock.now())[0] - before) / 0.2)
    assert fastest <= limit_deg_per_s + 0.01
    assert fastest > 0 or limit_deg_per_s == 4.0 or name == "oriental-az"  # whose encoder knows its place


@pytest.fixture(params=STAGES)
def stage(request: pytest.FixtureRequest) -> Rig:
    rig = Rig(request.param)
    rig.driver.identify()
    rig.driver.home()
    while rig.driver.moving():
        rig.wait(0.1)
    return rig


def test_a_stage_arrives_where_it_was_sent_and_says_so(stage: Rig) -> None:
    for target in (30.5, -12.25):
        stage.driver.move_to(target, 10.0)
        stage.wait(0.5)
        assert stage.driver.moving()
        assert stage.driver.state()[1]
        while stage.driver.moving():
            stage.wait(0.1)
        assert stage.driver.angle_deg() == pytest.approx(target, abs=stage.driver.settings.tolerance_deg)
        assert stage.lab.platform.now(stage.clock.now())[0] == pytest.approx(target, abs=0.02)


def test_a_stage_that_is_held_has_not_arrived(stage: Rig) -> None:
    stage.driver.move_to(60.0, 10.0)
    stage.wait(1.0)
    stage.lab.platform.stop(stage.clock.now())
    stage.wait(3.0)
    with pytest.raises(InstrumentError, match="from its target") as caught:
        stage.driver.moving()
    assert caught.value.fault == "not arrived"


def test_a_stage_made_safe_comes_to_rest_on_its_way(stage: Rig) -> None:
    stage.driver.move_to(90.0, 10.0)
    stage.wait(1.0)
    stage.driver.make_safe()
    stage.wait(4.0)
    assert not stage.driver.moving()
    assert 0.5 < stage.driver.angle_deg() < 80.0


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_no_dangerous_message_reaches_a_real_line() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    for name, entry in DRIVERS.items():
        driver = entry.load()
        modbus = get_type_hints(driver.__init__)["link"] is ModbusLink
        scheme = "modbus-rtu" if modbus else "serial"
        with closing(open_link(f"{scheme}://{os.ttyname(slave)}", RealClock())) as link:
            link.never.add(driver.never, FORBIDDEN[name][0][0] if modbus else None)
            for message in FORBIDDEN[name]:
                with pytest.raises(InstrumentError, match="never sent"):
                    link.send(message)
    with pytest.raises(BlockingIOError):
        os.read(master, 1)
    os.close(slave)
    os.close(master)


def imports(path: Path) -> set[str]:
    """The packages that a module names."""
    nodes = list(ast.walk(ast.parse(path.read_text())))
    plain = {alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names}
    return {n.split(".")[0] for n in plain | {node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)}}


def test_only_the_send_of_a_link_puts_bytes_on_a_line_and_it_asks_the_list_first() -> None:
    for path in Path(inspect.getfile(Rig)).parents[2].joinpath("drivers").rglob("*.py"):
        assert not imports(path) & {"os", "socket", "serial", "subprocess", "pymodbus", "ctypes"}, path
    for link in (WiredLink, EmulatedLink):
        source = inspect.getsource(link)
        send = inspect.getsource(link.send)
        assert send.index("never.check") < min(send.find(way) for way in (".write(", ".take(") if way in send)
        assert sum(source.count(way) for way in (".write(", ".take(", "sendall", "sendto")) == 1
