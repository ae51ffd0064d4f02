"""What answers on a line: it is asked who is there, in the words of the drivers, and nothing is set."""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, suppress
from dataclasses import dataclass

from labcal.bench.clock import Clock
from labcal.bench.links import Link, open_link
from labcal.errors import InputError, InstrumentError

BAUDS = (9600, 19200, 57600, 115200)
LISTEN_S, ANSWER_S = 0.3, 0.4
ADDRESSES = range(1, 4)  # of Modbus devices
IDN = (  # of what answers *IDN?, by its text
    (r"(THURLBY|TTI).*", "tti-pl", "coil"),
    (r"RIGOL[^,]*,DP8.*", "rigol-dp800", "coil"),
    (r"KEPCO.*", "kepco-bop", "coil"),
    (r"[^,]*,E3631[123]A,.*", "keysight-e36300", "coil"),
    (r"(KORAD|TENMA|VELLEMAN).*", "korad-ka3005p", "coil"),
    (r"METROLAB.*", "metrolab", "reference"),
    (r"(err[cdv])+", "standa-8smc5", "platform"),  # it does not know the question
    (r"\(C\)[^,]*PHYSIK INSTRUMENTE[^,]*,.*", "pi-gcs2", "platform"),
)
SENDS = (  # of what sends lines by itself, by the last of them
    (rb"\$PMAG.*", "pmag", "dut"),
    (rb"(\d\d-\d\d-\d{4} +)?\d{5,7}(\.\d+)? +\d{5,6}\.\d+( +\d\d)? *", "gsm", "reference"),
    (rb"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d\.\d{3} \d{3}( +-?\d+\.\d\d){4} *", "iaga-2002", "reference"),
    (rb"\d{1,3} (?P<chip>rm3100|mmc5983|lis3mdl|qmc5883|bmm350) \d+ [-a-z\d ]+\*[\dA-F]{4}", "i2c-board", "dut"),
    (rb".*", "csv-line", "dut or reference"),
)
Recognise = Callable[[str], dict[str, str] | None]


@dataclass(frozen=True, slots=True)
class Found:
    """What answers at `link`; `driver` and `kind` of role are "" where no driver of labcal is known to fit."""

    link: str
    said: str
    driver: str = ""
    kind: str = ""
    settings: str = ""


@dataclass(frozen=True, slots=True)
class Probe:
    """A question that sets nothing, in pieces with a pause between them, and the answer that `driver` is known by."""

    pieces: tuple[bytes, ...]
    answer: bytes
    driver: str
    kind: str
    answer_s: float = ANSWER_S


PROBES = (  # each ends first what the one before may have left in another's buffer
    Probe((b"*IDN?", b"\n"), rb"[ -~]*[A-Za-z][ -~]*", "", ""),  # a Korad answers to the first piece
    Probe((b"\n/get system.serial\n",), rb"@\d\d \d( \d\d)? (OK|RJ) .*", "zaber", "platform"),
    Probe((b"\r*99#\r",), rb"SER#.*", "hmr2300", "reference"),
    Probe((b"\n1 WHO*D1\n",), rb"1 OK labcal-coil/1 .*", "microcontroller", "coil"),
    Probe((b"\rVE?\r",), rb"ESP30\d.*", "newport-esp301", "platform"),
    Probe((b"\r\n1VE\r\n",), rb"1VE.*", "newport-smc100", "platform"),
    Probe((b"\rADR 6\rIDN?\r",), rb"(TDK-?)?LAMBDA, ?(GEN|Z).*", "genesys", "coil"),  # at the address of the factory
    Probe((b"\0about\0",), rb"[ -~]*POS[ -~]*", "pos-1", "reference", 2.0),
)


MESSAGES = (  # where a write is a message, it must be a whole one
    Probe((b"*IDN?\n",), PROBES[0].answer, "", "", 2.0),
    Probe((b"ID?\n",), rb"ID +HP ?60\d\d[A-Z]", "hp-603x", "coil", 2.0),  # of before SCPI
)


@dataclass(frozen=True, slots=True)
class Telegram:
    """A question in bytes, and what the answer is by which `driver` is known: `said` has groups of what to show."""

    sent: bytes
    answer: bytes
    driver: str
    kind: str


TELEGRAMS = (  # asked last: to what speaks in lines they are the beginning of one
    Telegram(bytes.fromhex("050000005001"), rb"\x06\0T\0[\x81\x01].{5}([ -~]{3,8}).{72,}", "thorlabs-apt", "platform"),
    Telegram(bytes.fromhex("01880100000000008a"), rb".\x01\x64\x88([\x01-\x2f].).{3}", "trinamic-tmcl", "platform"),
    Telegram(b"geti", rb"geti([ -~]{2,4})\0*.{32,}", "standa-8smc5", "platform"),
    Telegram(b"\xc0\x02\0\x0c\0\x01\0\x08\x80dev.desc" + bytes.fromhex("3d329dabc0"),
             rb".*\xc0\x03\0.\0\x01\0([ -~]+).{4,8}\xc0.*", "twinleaf", "reference"),
)  # fmt: skip


def asked(link: str, clock: Clock, recognise: Recognise = lambda said: None) -> Iterator[Found]:
    """What answers on this link; nothing is yielded where it is silent.

    `recognise`: settings of the driver scpi-table for an answer to *IDN?, where one of its tables fits.
    """
    scheme, _, rest = link.partition("://")
    if scheme == "modbus-tcp":
        yield from _modbus(link, clock, LABJACK)
    elif scheme == "serial":
        yield from _serial(rest.partition("?")[0], clock, recognise)
    elif scheme != "emulated":
        yield from _asked(link, clock, MESSAGES if scheme in ("visa", "usbtmc") else PROBES[:1], recognise)


def by_words(url: str, said: str, recognise: Recognise) -> Found:
    """What an answer to *IDN? is known by."""
    for pattern, driver, kind in IDN:
        if re.fullmatch(pattern, said, re.IGNORECASE):
            return Found(url, said, driver, kind)
    if (stated := recognise(said)) is not None:
        words = ", ".join(f'{key} = "{value}"' for key, value in stated.items())
        return Found(url, said, "scpi-table", "coil", words)
    return Found(url, said)


def _serial(device: str, clock: Clock, recognise: Recognise) -> Iterator[Found]:
    """At each usual rate: listened to, asked in words, by registers, by telegrams; the first that makes sense is it."""
    for baud in BAUDS:
        if found := list(_asked(f"serial://{device}?baud={baud}", clock, PROBES, recognise)):
            yield from found
            return
    for baud in BAUDS:
        if found := list(_modbus(f"modbus-rtu://{device}?baud={baud}", clock, RTU)):
            yield from found
            return
    for baud in BAUDS:
        if found := list(_telegrams(f"serial://{device}?baud={baud}", clock)):
            yield from found
            return


def _asked(url: str, clock: Clock, probes: Sequence[Probe], recognise: Recognise) -> Iterator[Found]:
    with suppress(InstrumentError, InputError), closing(open_link(url, clock)) as link:
        if len(heard := _heard(link, clock, LISTEN_S)) and (talker := _talker(url, heard, SENDS)):
            yield talker
            return
        for probe in probes:
            answer = b""
            for piece in probe.pieces:
                if not answer:
                    link.send(piece)
                    answer = _heard(link, clock, probe.answer_s)
            heard += answer
            for line in re.split(rb"[\r\n\0]+", answer.strip()):
                if re.fullmatch(probe.answer, line):
                    said = line.decode()
                    yield Found(url, said, probe.driver, probe.kind) if probe.driver else by_words(url, said, recognise)
                    return
        if talker := _talker(url, heard, SENDS[:-1]):  # one that is slow
            yield talker


def _telegrams(url: str, clock: Clock) -> Iterator[Found]:
    with suppress(InstrumentError, InputError), closing(open_link(url, clock)) as link:
        for one in TELEGRAMS:
            link.send(one.sent)
            if answer := re.fullmatch(one.answer, _heard(link, clock, ANSWER_S), re.DOTALL):
                words = answer[1].decode("latin-1")
                yield Found(url, words if words.isprintable() else f"module {answer[1].hex()}", one.driver, one.kind)
                return


def _heard(link: Link, clock: Clock, seconds: float) -> bytes:
    return b"".join(data for _, data in link.receive(clock.now() + seconds))


def _talker(url: str, heard: bytes, known: Sequence[tuple[bytes, str, str]]) -> Found | None:
    """What sends lines of text by itself, if its last one is of a form that is known."""
    lines = [line for line in re.split(rb"[\r\n]+", heard) if line]
    if not lines or not all(re.fullmatch(rb"[ -~]+", line) for line in lines):
        return None
    for form, driver, kind in known:
        if found := re.fullmatch(form, lines[-1]):
            chip = found.groupdict().get("chip", b"").decode()
            stated = f'chip = "{chip}"' if chip else ""
            return Found(url, f"sends by itself: {lines[-1].decode()}", driver, kind, stated)
    return None


@dataclass(frozen=True, slots=True)
class Register:
    """Registers that are read, and what a device is that holds such words there."""

    address: int
    count: int
    fits: Callable[[list[int]], bool]
    driver: str
    kind: str
    said: str


RTU = (
    Register(0, 1, lambda w: 60_000 <= w[0] <= 60_999, "riden-rd60xx", "coil", "Riden"),
    Register(
        0x8000, 1, lambda w: 200 <= w[0] < 1000, "waveshare-relay", "polarity or interlock", "Waveshare relay board"
    ),
)
LABJACK = (
    Register(60_000, 2, lambda w: w == list(struct.unpack(">2H", struct.pack(">f", 7.0))), "labjack-t7", "reference",
             "LabJack T7"),
)  # fmt: skip


def _modbus(url: str, clock: Clock, known: Sequence[Register]) -> Iterator[Found]:
    from labcal.bench.links.modbus import ModbusLink  # slow to import

    with suppress(InstrumentError, InputError), closing(open_link(url, clock)) as line:
        framer = "socket" if url.startswith("modbus-tcp") else "rtu"
        master = ModbusLink(line, clock, framer=framer, timeout_s=ANSWER_S, quiet_s=0.1)
        for device in ADDRESSES:
            if one := _device(master.read_holding, device, known):
                settings = f"address = {device}" if device != 1 else ""
                yield Found(url, f"{one[2]} at Modbus address {device}", one[0], one[1], settings)


def _device(read: Callable[[int, int, int], list[int]], device: int, known: Sequence[Register]) -> tuple[str, ...]:
    """Driver, kind and words of what answers at this address; () where nothing does."""
    there = False
    for register in known:
        try:
            fits = register.fits(read(device, register.address, register.count))
        except InstrumentError as fault:
            if fault.fault == "silent" and not there:
                return ()
            there = there or fault.fault == "refused"
            continue
        there = True
        if fits:
            return register.driver, register.kind, register.said
    return ("", "", "a device that is not known") if there else ()
