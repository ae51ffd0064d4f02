"""One question of each driver that asks, with its answer in the bytes of the manuals and fact sheets."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass, field
from importlib.metadata import entry_points
from typing import Any

import numpy as np
from frames import read, rtu

from drivers.framing import ximc
from drivers.framing.coil_line import sealed
from drivers.framing.tmcl import summed as tmcl
from labcal.bench.driver_kit.testing import Exchange
from labcal.errors import InstrumentError

DRIVERS = {e.name: e.load() for e in entry_points(group="labcal.drivers") if e.value.startswith("drivers.")}
ALPHALAB = bytes.fromhex("10 00 0000 04D2  10 02 0000 3039  10 09 0000 07D0  10 01 0000 000F  10 01 0000 092E  08")
EA_TEXT = [
    read(f"0003 {at:04X} 0014", [int.from_bytes(text.ljust(40, b"\0")[k : k + 2]) for k in range(0, 40, 2)])
    for at, text in ((1, b"PSI 9080-60 T"), (21, b"EA Elektro-Automatik"), (151, b"2850530001"))
]


@dataclass(frozen=True)
class Wire:
    """`ask(k)`: the k-th question (from 0) and its answer, which is read as `value`; `other` would be another value.

    `before` is what is said first, while `prepare` runs. `nonsense`: replies that are none, beside the common ones.
    `asks`: how often a question is put that nothing answers.
    """

    ask: Callable[[int], tuple[bytes, bytes]]
    call: Callable[[Any], float]
    value: float
    other: bytes
    settings: dict[str, Any] = field(default_factory=dict)
    before: list[Exchange] = field(default_factory=list)
    prepare: Callable[[Any], object] = lambda driver: None
    nonsense: tuple[bytes, ...] = ()
    timeout_s: float = 0.6
    asks: int = 1


def always(request: bytes, reply: bytes) -> Callable[[int], tuple[bytes, bytes]]:
    return lambda _: (request, reply)


def current(driver: Any) -> float:
    return float(driver.measure_current())


def angle(driver: Any) -> float:
    return float(driver.angle_deg())


def polled(driver: Any) -> float:
    """x of the next reading [nT]; a reply that was noted as no good is a fault here."""
    blocks = driver.read_until(driver._polls._next_s if hasattr(driver, "_polls") else driver._next_poll_s)
    if not blocks:
        raise InstrumentError("noted, and no value", fault="wrong reply")
    return float(np.vstack([b.values for b in blocks])[-1, 0])


def words(value: int) -> list[int]:
    return list(divmod(value & 0xFFFFFFFF, 0x10000))


def summed(hexadecimal: str) -> bytes:
    """A telegram of a PS 2000 B."""
    body = bytes.fromhex(hexadecimal)
    return body + bytes(divmod(sum(body), 256))


def riden(milliamps: int) -> tuple[bytes, bytes]:
    return read("0103 0008 000B", [500, 500, 480, milliamps, 0, 230, 2400, 0, 0, 1, 1])


def started(*more: bytes) -> list[Exchange]:
    """An HMR2300 that takes every setting."""
    told = [b"A", b"ASCII_ON", b"ZF", b"ZERO_OFF", b"VF", b"AVG_OFF", b"TN", b"S/R_ON", b"R=20", b"OK"]
    pairs = zip(told[::2], told[1::2], strict=True)
    return [(b"\x1b", None)] + [e for w, r in pairs for e in ((b"*00WE\r", b"OK\r"), (b"*00" + w + b"\r", r + b"\r"))]


def labjack_started() -> list[Exchange]:
    """Inputs 0 to 2 at ±10 V, single-ended, resolution 0: each written and read back."""
    told = []
    for n in range(3):
        for at, words_ in ((0x9C40 + 2 * n, [0x4120, 0]), (0xA028 + n, [199]), (0xA21C + n, [0])):
            count, data = len(words_), "".join(f"{word:04x}" for word in words_)
            told += [(rtu(f"0110{at:04x}{count:04x}{2 * count:02x}{data}"), rtu(f"0110{at:04x}{count:04x}"))]
            told += [read(f"0103{at:04x}{count:04x}", words_)]
    return told


def metrolab_started() -> list[Exchange]:
    told = (b":ABOR", b":INIT:CONT OFF", b":FORM:DATA ASCII", b":AVER:COUN 100", b":TRIG:SOUR IMM", b":TRIG:COUN 1")
    check = (b":SYST:ERR?;*STB?\n", b'0,"No error";0\n')
    return [e for words_ in told for e in ((words_ + b"\n", None), check)]


def zaber(k: int, position: int = 384_000) -> tuple[bytes, bytes]:
    return b"/1 1 %02d get pos\r\n" % (k + 2), b"@01 1 %02d OK IDLE -- %d\r\n" % (k + 2, position)


def standa(steps: int) -> bytes:
    """The status of an 8SMC5 at rest."""
    form = ximc.ANSWERS["gets"]
    return b"gets" + ximc.packed(struct.pack(form, 0, 1, 1, 0, 0, steps, 0, *[0] * 8, 32, 0, 8))


STANDA_PARTS = b"geng" + ximc.packed(struct.pack(ximc.ANSWERS["geng"], 0, 670, 3200, 0, 164, 200, 9, 0))


def apt_position(counts: int) -> bytes:
    """MOT_GET_POSCOUNTER of channel 1."""
    return struct.pack("<HHBBHi", 0x0412, 6, 0x81, 0x50, 1, counts)


APT_WHO = struct.pack("<HHBBI8sH4s60s3H", 6, 84, 0x81, 0x50, 55_000_042, b"K10CR1", 16, b"\3\0\1", b"", 1, 3, 1)
FETCH = b":INIT;:FETC:ARR:X? 1,9;:FETC:ARR:Y? 1,9;:FETC:ARR:Z? 1,9\n"
WIRES: dict[str, Wire] = {
    "rigol-dp800": Wire(
        always(b":MEAS:CURR? CH1\n", b"0.4990\n"), current, 0.499, b"0.9990\n",
        nonsense=(b"nan\n", b"0.\xff#2\n", b"9.91E37\n", b"1_0\n"), timeout_s=1.5,
    ),
    "tti-pl": Wire(
        always(b"I1O?\n", b"0.499A\r\n"), current, 0.499, b"0.999A\r\n",
        nonsense=(b"0.499V\r\n", b"0.499\r\n", b"infA\r\n"), timeout_s=1.5,
    ),
    "kepco-bop": Wire(
        always(b"MEAS:CURR?\n", b"-0.4990\r\n"), current, -0.499, b"0.9990\r\n", nonsense=(b"\x15\n",), timeout_s=1.5
    ),
    "keysight-e36300": Wire(
        always(b"MEAS:CURR? (@1)\n", b"+4.99000000E-01\n"), current, 0.499, b"+9.0E-01\n",
        nonsense=(b"+9.91000000E+37\n",), timeout_s=1.5,
    ),
    "korad-ka3005p": Wire(
        always(b"IOUT1?", b"0.499"), current, 0.499, b"9.999", nonsense=(b"00.49", b"-.499", b"0,499"), timeout_s=0.5,
        asks=2,
    ),
    "hp-603x": Wire(
        always(b"IOUT?\n", b"IOUT   0.4990\r\n"), current, 0.499, b"IOUT   0.9990\r\n",
        nonsense=(b"0.4990\r\n", b"VOUT 0.499\r\n", b"IOUT nan\r\n"), timeout_s=1.5,
    ),
    "genesys": Wire(
        always(b"MC?\r", b"00.499\r"), current, 0.499, b"00.999\r", prepare=current,
        before=[(b"ADR 6\r", b"OK\r"), (b"MC?\r", b"00.000\r")], nonsense=(b"OK\r", b"C01\r", b"nan\r", b"ON\r"),
    ),
    "scpi-table": Wire(
        always(b"INST:NSEL 1;:MEAS:CURR?\n", b"0.4990\n"), current, 0.499, b"0.9990\n",
        settings={"model": "rohde-schwarz-hmp"}, nonsense=(b"nan\n", b"9.91E37\n", b"0.499A\n"), timeout_s=1.5,
    ),
    "microcontroller": Wire(
        lambda k: (sealed(f"{9 + 8 * k} MEAS? 1"), sealed(f"{9 + 8 * k} OK -499000")), current, -0.499,
        sealed("9 OK 999000"), nonsense=(sealed("9 OK nan"), sealed("9 OK 1.5"), b"9 OK 499000\n"), timeout_s=0.5,
    ),
    "riden-rd60xx": Wire(
        always(*riden(499)), current, 0.499, riden(999)[1], before=[read("0103 0000 0004", [60062, 1, 0x86A0, 135])],
        prepare=lambda d: d.identify(),
    ),
    "ea-9000": Wire(
        always(*read("0003 01F9 0004", [0, 0x0883, 0, 437])), current, 437 / 52428 * 60,
        read("0003 01F9 0004", [0, 0x0883, 0, 999])[1],
        before=[*EA_TEXT, read("0003 0079 0004", [0x42A0, 0, 0x4270, 0])], prepare=lambda d: d.identify(),
    ),
    "ea-ps2000b": Wire(
        always(summed("750047"), summed("850047 0105 0000 04FD")), current, 1277 / 25600 * 10,
        summed("850047 0105 0000 0A00"), prepare=current, timeout_s=0.5,
        before=[(summed("750047"), summed("850047 0105 0000 0000")), (summed("730003"), summed("83000341200000"))],
        nonsense=(summed("810033 0500"), summed("850147 0105 0000 04FD")),
    ),
    "waveshare-relay": Wire(
        always(rtu("0101 0000 0001"), rtu("0101 01 01")), lambda d: float(d.polarity("x")), -1.0, rtu("0101 01 00"),
        settings={"x": 0},
    ),
    "waveshare-interlock": Wire(
        always(rtu("0101 0000 0001"), rtu("0101 01 01")), lambda d: float(d.contact_closed()), 1.0, rtu("0101 01 00")
    ),
    "zaber": Wire(
        zaber, angle, 90.0, zaber(0, 5)[1],
        before=[(b"/1 1 01 get limit.cycle.dist\r\n", b"@01 1 01 OK IDLE -- 1536000\r\n")],
        prepare=lambda d: d._steps_per_deg, timeout_s=0.5,
        nonsense=(b"@01 1 02 OK IDLE -- 384000:00\r\n", b"@01 1 02 OK IDLE -- x\r\n"),
    ),
    "newport-esp301": Wire(
        always(b"1TP\r", b"30.5\r\n"), angle, 30.5, b"99.0\r\n", nonsense=(b"nan\r\n", b"1TP\r\n"), timeout_s=0.5
    ),
    "newport-smc100": Wire(
        always(b"1TP\r\n", b"1TP30.5\r\n"), angle, 30.5, b"1TP99.0\r\n", nonsense=(b"2TP30.5\r\n", b"1TS000033\r\n"),
        timeout_s=0.5, settings={"tries": 1},
    ),
    "pi-gcs2": Wire(
        always(b"POS? 1\n", b"1=30.500000\n"), angle, 30.5, b"1=99.0\n",
        nonsense=(b"2=30.5\n", b"1=nan\n", b"30.5\n", b"1 0x50=30.5\n"), timeout_s=0.5,
    ),
    "standa-8smc5": Wire(
        always(b"gets", standa(2440)), angle, 30.5, standa(7), timeout_s=0.5,
        before=[(b"gets", standa(0)), (b"geng", STANDA_PARTS)], prepare=angle,
        nonsense=(standa(2440)[:-1] + b"\0", b"gpos" + standa(2440)[4:]),
    ),
    "velmex-vxm": Wire(
        always(b"X\r", b"+0001220\r"), angle, 30.5, b"+0009999\r", timeout_s=0.5,
        nonsense=(b"X\r", b"1220\r", b"+000122\r", b"+00012.0\r"),
    ),
    "trinamic-tmcl": Wire(
        always(tmcl(1, 6, 1, 0, 0), tmcl(2, 1, 100, 6, 390_400)), angle, 30.5, tmcl(2, 1, 100, 6, 7), timeout_s=0.5,
        nonsense=(tmcl(2, 3, 100, 6, 390_400), tmcl(2, 1, 100, 5, 390_400), tmcl(2, 1, 3, 6, 390_400)),
    ),
    "thorlabs-apt": Wire(
        always(bytes.fromhex("110401005001"), apt_position(4_164_267)), angle, 30.5, apt_position(9_999),
        before=[(bytes.fromhex("120000005001"), None), (bytes.fromhex("050000005001"), APT_WHO)],
        prepare=lambda d: d.identify(), timeout_s=0.5,
        nonsense=(bytes.fromhex("120406008150") + b"\2\0\0\0\0\0", bytes.fromhex("150406008150010000000000")),
    ),
    "oriental-az": Wire(
        always(*read("0103 00CC 0002", words(1525))), angle, 30.5, read("0103 00CC 0002", words(111))[1]
    ),
    "leadshine": Wire(
        always(*read("0103 602A 0004", [*words(76_250), *words(76_250)])), angle, 30.5,
        read("0103 602A 0004", [*words(111), *words(111)])[1],
    ),
    "hmr2300": Wire(
        always(b"*00P\r", b"  1,500  - 1,234   15,000  \r"), polled, 10_000.0, b"  9,999  - 1,234   15,000  \r",
        settings={"mode": "polled", "invalid": 0}, before=started(), prepare=lambda d: d.start(),
        nonsense=(b"  1,50  - 1,234   15,000  \r", b"Re-enter\r", b" 11,5000  - 1,234   15,000  \r"), timeout_s=0.5,
    ),
    "alphalab": Wire(
        always(b"\x03" + bytes(5), ALPHALAB), polled, 12345.0, ALPHALAB[:11] + b"\x0a" + ALPHALAB[12:],
        before=[(b"\x02" + bytes(5), b"RELATIVE=0:ZERO=OFF\x07")], prepare=lambda d: d.start(),
        nonsense=(ALPHALAB[:30] + b"\x07",), timeout_s=0.5,
    ),
    "labjack-t7": Wire(
        always(*read("0103 0000 0006", [0x3F80, 0, 0xBF00, 0, 0, 0])), polled, 10_000.0,
        read("0103 0000 0006", [0x4000, 0, 0, 0, 0, 0])[1], settings={"uT_per_V": (10.0, 10.0, 10.0)},
        before=labjack_started(), prepare=lambda d: d.start(),
    ),
    "daq-inputs": Wire(
        always(b"ain 0,1,2 single 10 1\n", b"1.0000000,-0.5000000,0.0000000\n"), polled, 10_000.0,
        b"2.0000000,0.0000000,0.0000000\n", settings={"uT_per_V": (10.0, 10.0, 10.0)}, prepare=lambda d: d.start(),
        nonsense=(b"? not known\n", b"1,2\n", b"1,2,nan\n", b"LabJack,U6,360018234,1.45\n"), timeout_s=2.0,
    ),
    "metrolab": Wire(
        always(FETCH, b"0.000020000T;-0.000000010T;4.8E-05T\n"), polled, 20_000.0, b"0.000070000T;0T;0T\n",
        before=metrolab_started(), prepare=lambda d: d.start(), nonsense=(b"1T;2T\n", b"1;2;3\n", b"nanT;0T;0T\n"),
        timeout_s=2.0,
    ),
}  # fmt: skip
