"""Every driver of ours keeps the promises of `labcal.testing`; others' drivers are tried by their own packages."""

from __future__ import annotations

import inspect
import os
import pty
import re
import sys
import tty
from contextlib import closing
from functools import cache
from importlib.metadata import entry_points
from pathlib import Path

import pytest
from stated import DRIVERS, SETTINGS

from drivers.framing import tio
from drivers.framing.tmcl import summed
from labcal.bench.clock import RealClock
from labcal.bench.links import EmulatedLink, WiredLink, open_link
from labcal.errors import InstrumentError
from labcal.testing.drivers import DriverCase, Promise, installed, keep, promises
from labcal.testing.drivers.every import OUTSIDE, imported

ROOT = Path(__file__).parents[2]
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
    "scpi-table": [b"*RST\n", b"*rcl 1\n", b"CURR 1;CAL:STAT ON\n", b"OUTP:TRAC ON\n", b"INST:COUP:OUTP ALL\n"],
    "microcontroller": [b"SET 1 5\n", b"1 SAVE*00\n", b"1 SET 1 5*00\n2 X*00\n", b"1 OUT 1 2*00\n", b"*RST\n"],
    "pmag": [b"$"],
    "lemi-025": [b"L"],
    "replay": [b"1"],
    "rm3100": [b"\x01"],
    "ros-topic": [b"\0"],
    "i2c-board": [b"\x01"],
    "iaga-2002": [b"\n"],
    "text-line": [b"x"],
    "alphalab": [bytes([code, 0, 0, 0, 0, 0]) for code in (0x04, 0x05, 0x0B, 0x0C, 0x0E, 0x14)],
    "metrolab": [b"*RST\n", b":CAL\n", b":SYST:PRES\n", b":INIT;*SAV 1\n", b":MEM:DATA?\n"],
    "can-dbc": [b"\0"],
    "ccsds": [b"\xc0"],
    "kepco-bop": [b"DIAG:TST?\n", b"diag:tst?\n", b"*RST\n", b"*TST?\n", b"CAL:CURR\n", b"OUTP 1;DIAG:TST?\n"],
    "riden-rd60xx": [bytes.fromhex(h) for h in ("010601001601", "010600360001", "01060013", "000601001601", "0110")],
    "ea-9000": [bytes.fromhex(h) for h in ("00060000", "000F0195", "001001F4", "000501955500", "0005019BFF00")],
    "ea-ps2000b": [bytes.fromhex(h) for h in ("f100266400017b", "f10036f0f00307", "f100360a0a013b", "f00001000f")],
    "keysight-e36300": [b"*RST\n", b"*SAV 1\n", b"OUTP:PAIR SER\n", b"OUTP:TRAC ON\n", b"CAL:SEC:STAT OFF\n"],
    "korad-ka3005p": [b"SAV1", b"RCL1", b"rcl2\n", b"TRACK1"],
    "hp-603x": [b"CLR\n", b"rst\n", b"RCL 3\n", b"STO 3\n", b"HOLD 1\n", b"FOLD 2\n", b"TEST?\n", b"ISET 1;CLR\n"],
    "genesys": [b"RST\r", b"SAV\r", b"rcl\r", b"\\\r", b"AST 1\r", b"FLD ON\r", b"RMT LLO\r", b"\xa1", b"PC 1\rRST\r"],
    "newport-esp301": [b"1PR5\r", b"1MV+\r", b"1DH\r", b"SM\r", b"RS\r", b"1PA5;1PR5\r", b"1SN7\r"],
    "newport-smc100": [b"1PR5\r\n", b"1PW1\r\n", b"1RS\r\n", b"1SA2\r\n", b"1ZX3\r\n"],
    "oriental-az": [bytes.fromhex(h) for h in ("01060058", "011000580010200000000000000002", "0110007C00020400000040")],
    "leadshine": [bytes.fromhex(h) for h in ("010618012211", "010618014001", "010660020021", "0110620000060C0041")],
    "labjack-t7": [
        bytes.fromhex(h) for h in ("010603E80001", "011003E80002", "0110EA600002", "01059C4000FF", "0110A410")
    ],
    "mavlink": [  # ARM, a parameter set, a message of MAVLink 2, two frames in one
        bytes.fromhex(h)
        for h in (
            "fe2100ffbe4c" + "00" * 35,
            "fe1700ffbe17" + "00" * 25,
            "fd1400000000ff" + "00" * 25,
            "fe1400ff0014" * 5,
        )
    ],
    "pos-1": [b"standby on\0", b"time 12:00:00\0", b"auto 5\0", b"mode binary\0", b"run\0auto 5\0"],
    "daq-inputs": [b"dac 0 5\n", b"who\nwho\n", b"ain 0,1,2 single 10 1"],
    "gsm": [b"F"],
    "twinleaf": [tio.request(1, b"dev.reset"), tio.request(2, b"dev.name", b"a"), tio.request(3, b"dev.desc", b"a"),
                 tio.packet(tio.HEARTBEAT) * 2, b"dev.desc\r"],
    "manual": [b"x"],
    "pi-gcs2": [b"MVR 1 5\n", b"POS 1 0\n", b"SEP 100 1 0x50 4\n", b"SPA 1 0x1 9\n", b"RBT\n", b"MOV 1 5\nMVR 1 5\n"],
    "standa-8smc5": [b"movr" + bytes(14), b"left", b"rigt", b"save", b"spos" + bytes(22), b"cmdf", b"getsleft"],
    "velmex-vxm": [b"I1M400,R\r", b"C,S1M80,I1M5,R\r", b"N\r", b"C,IA1M-0,R\rI1M5,R\r", b"setM1M4\r", b"rst\r"],
    "trinamic-tmcl": [  # endless, relative, another parameter, to memory, an output, factory settings, its driver
        summed(1, command, kind, 0, 5)
        for command, kind in ((1, 0), (4, 1), (5, 6), (7, 4), (14, 0), (137, 0), (147, 0))
    ],
    "thorlabs-apt": [  # relative, endless, jog, a new zero, to flash, an immediate stop of a rack, two messages in one
        bytes.fromhex(h)
        for h in (
            "48040600d001010055150200", "570401015001", "6a0401015001", "10040600d001010000000000",
            "b9040400d00101005304", "650401012101", "110401005001480401005001",
        )
    ],
}  # fmt: skip
TO_PANEL = {  # what a supply's driver says last, once zero and off are read back; the others' panels need no word
    "tti-pl": b"LOCAL\n",
    "rigol-dp800": b":SYST:LOC\n",
    "scpi-table": b"SYST:LOC\n",
    "keysight-e36300": b"SYST:LOC\n",
    "ea-9000": bytes.fromhex("000501920000"),
    "ea-ps2000b": bytes.fromhex("f1003610000137"),
}
ABSOLUTE = {"oriental-az"}  # whose encoder knows its place
LONGEST = 150  # lines of a driver
LONGER = {"EaSupply": "remote control is taken from one interface, held and given back"}


@cache
def case_of(name: str) -> DriverCase:
    return installed(
        name,
        forbidden=FORBIDDEN[name],
        settings=SETTINGS.get(name, {}),
        to_panel=TO_PANEL.get(name, b""),
        knows_its_place=name in ABSOLUTE,
    )


CASES = [
    pytest.param(name, promise, id=f"{name}-{promise.__name__}")
    for name in sorted(set(DRIVERS) & set(FORBIDDEN))
    for promise in promises(case_of(name))
]
SUPPLIES = sorted(name for name, entry in DRIVERS.items() if "coil" in entry.load().roles)


@pytest.mark.parametrize(("name", "promise"), CASES)
def test_it_keeps_its_promise(name: str, promise: Promise) -> None:
    keep(promise, case_of(name))


def test_every_driver_has_an_emulator_and_a_forbidden_message_that_is_tried() -> None:
    ours = {e.name for e in entry_points(group="labcal.emulators") if e.value.startswith("drivers.emulators.")}
    assert set(DRIVERS) == ours, (
        "give each driver its emulator under the same name in pyproject.toml, then install again"
    )
    assert set(DRIVERS) == set(FORBIDDEN), "state in FORBIDDEN a message that this driver must never send"


def test_every_driver_stands_in_the_docs_and_every_supply_says_whether_it_has_a_watchdog() -> None:
    named = re.findall(r"^\|( `.*?) \|", (ROOT / "docs" / "bench.md").read_text(), re.MULTILINE)
    missing = set(DRIVERS) - set(re.findall(r"`([\w-]+)`", " ".join(named)))
    assert missing == set(), "give each a row in the table of drivers in docs/bench.md"
    watchdogs = (ROOT / "docs" / "instruments.md").read_text().partition("## A supply's own watchdog")[2]
    makers = {"tti-pl": "Aim-TTi", "ea-9000": "EA", "ea-ps2000b": "EA PS 2000 B", "scpi-table": "A table's"}
    for name in SUPPLIES:
        maker = makers.get(name, name.split("-")[0].title())
        assert maker in watchdogs, f"say of {maker} whether it has a watchdog: docs/instruments.md"


@pytest.mark.parametrize("name", sorted(set(SUPPLIES) - set(TO_PANEL)))
def test_a_supply_whose_panel_needs_no_word_says_none(name: str) -> None:
    rig = case_of(name).rig()
    rig.driver.identify()
    rig.driver.output(True)
    rig.driver.make_safe()
    assert [said for said in rig.sent if said.startswith(tuple(TO_PANEL.values()))] == [], "name it in TO_PANEL"


@pytest.mark.parametrize("name", sorted(DRIVERS))
def test_a_driver_is_short(name: str) -> None:
    driver = DRIVERS[name].load()
    lines = Path(inspect.getfile(driver)).read_text().count("\n")
    assert lines <= LONGEST or driver.__name__ in LONGER, f"{lines} lines: a driver has 40 to {LONGEST}"


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no ptys")
def test_no_dangerous_message_reaches_a_real_line() -> None:
    master, slave = pty.openpty()
    tty.setraw(slave)
    os.set_blocking(master, False)
    for name in DRIVERS:
        case = case_of(name)
        scheme = "modbus-rtu" if case.modbus else "serial"
        with closing(open_link(f"{scheme}://{os.ttyname(slave)}", RealClock())) as link:
            link.never.add(case.driver.never, case.forbidden[0][0] if case.modbus else None)
            for message in case.forbidden:
                with pytest.raises(InstrumentError, match="never sent"):
                    link.send(message)
    with pytest.raises(BlockingIOError):
        os.read(master, 1)
    os.close(slave)
    os.close(master)


def test_only_the_send_of_a_link_puts_bytes_on_a_line_and_it_asks_the_list_first() -> None:
    for path in (ROOT / "drivers").rglob("*.py"):
        assert not imported(path) & OUTSIDE, path
    for link in (WiredLink, EmulatedLink):
        source = inspect.getsource(link)
        send = inspect.getsource(link.send)
        assert send.index("never.check") < min(send.find(way) for way in (".write(", ".take(") if way in send)
        assert sum(source.count(way) for way in (".write(", ".take(", "sendall", "sendto")) == 1
