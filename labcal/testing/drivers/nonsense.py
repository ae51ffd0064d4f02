"""An emulator goes on whatever it is sent; a driver that is answered nonsense raises InstrumentError and no other."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from typing import Any

from labcal.errors import InstrumentError
from labcal.testing.drivers.rig import DriverCase, DriverRig
from labcal.testing.require import require

NUMBERS = (b"", b"?", b"-", b".", b"1.2.3", b"-7", b"1e999", b"999999999999", b"\xc2\xb2", b"nan")
LAST_NUMBER = re.compile(rb"-?\d+\.?\d*(?=\D*$)")
FUNCTIONS = (1, 3, 4, 5, 6, 15, 16, 22)  # of Modbus
HOMES_IN_S, STEP_S = 8.0, 0.1
STEPS: tuple[Callable[[Any], object], ...] = (
    lambda d: d.identify(),
    lambda d: d.start(),
    lambda d: d.home(),
    lambda d: d.output(True),
    lambda d: d.set_current(0.5),
    lambda d: d.set_polarity("x", -1),
    lambda d: d.move_to(30.0, 5.0),
    lambda d: d.moving(),
    lambda d: d.measure_current(),
    lambda d: d.angle_deg(),
    lambda d: d.make_safe(),
)
ASKED: tuple[tuple[Any, ...], ...] = (  # methods and what they are given; a function is given the time
    ("identify",), ("output", True), ("set_current", 0.1), ("set_point",), ("measure_current",), ("trip",), ("feed",),
    ("set_polarity", "x", -1), ("polarity", "x"), ("arm",), ("home",), ("move_to", 10.0, 5.0), ("moving",),
    ("angle_deg",), ("state",), ("start",), ("read_until", lambda now_s: now_s + 1.0), ("stop",), ("make_safe",),
)  # fmt: skip


DAMAGES: Mapping[str, Callable[[bytes], bytes]] = {
    "their first byte turned": lambda data: b"\xff" + data[1:],
    "a byte turned": lambda data: data[: len(data) // 2] + b"\xb2" + data[len(data) // 2 + 1 :],
    "no digits": lambda data: re.sub(rb"\d", b"x", data),
    "lost their first half": lambda data: data[len(data) // 2 :],
}


def whatever_it_is_sent_its_emulator_goes_on(case: DriverCase) -> None:
    """Every message it knows with other numbers, cut, and with a byte turned; then the driver identifies it again."""
    rig = case.rig()
    _use(rig)
    chance, heard = random.Random(1), rig.sent or [b"hello\r\n"]
    for message in (*case.forbidden, *sorted(set(heard))):
        for nonsense in _spoilt(message, chance):
            _send(rig, nonsense)
    rig.wait(1.0)
    rig.emulator.take(rig.clock.now(), b"\x1b\r\n")  # ends a stream, and what was cut
    rig.wait(1.0)
    rig.line.flush()
    sentence = f"{rig.name} cannot identify its emulator after nonsense: the emulator must drop what it does not know."
    require(not rig.sent or rig.driver.identify().model, sentence)


def _send(rig: DriverRig, nonsense: bytes) -> None:
    rig.wait(0.2)
    try:
        rig.emulator.take(rig.clock.now(), nonsense)
        rig.emulator.emit(rig.clock.now() + 0.1)
    except Exception as error:
        sentence = f"The emulator of {rig.name} fails when it is sent {nonsense!r} ({type(error).__name__}: {error})"
        raise AssertionError(f"{sentence}: answer as the instrument would, with an error or not at all.") from error


def whatever_it_is_answered_it_raises_no_other_error(case: DriverCase) -> None:
    """Answers that came damaged are InstrumentErrors, or look sound: no error of Python's leaves the driver."""
    for damage, turned in DAMAGES.items():
        rig = case.rig()
        rig.driver.identify()
        end: Any = rig.line._emulator
        emit = end.emit
        end.emit = lambda until_s, emit=emit, turned=turned: [(t_s, turned(data)) for t_s, data in emit(until_s)]
        for name, *stated in ASKED:
            if (method := getattr(rig.driver, name, None)) is not None:
                _try(rig, damage, name, method, stated)


def _try(rig: DriverRig, damage: str, name: str, method: Callable[..., object], stated: list[Any]) -> None:
    try:
        method(*(one(rig.clock.now()) if callable(one) else one for one in stated))
    except InstrumentError:
        return
    except Exception as error:
        what = f"{rig.name} raised {type(error).__name__} ({error}) in {name} where its answers had {damage}"
        raise AssertionError(f"{what}: raise InstrumentError(…, fault='wrong reply').") from error


def _use(rig: DriverRig) -> None:
    """Have the driver say most of what it can."""
    for number, step in enumerate(STEPS):
        with suppress(AttributeError, InstrumentError):
            step(rig.driver)
        rig.wait(HOMES_IN_S if number == 2 else STEP_S)


def _spoilt(message: bytes, chance: random.Random) -> Iterator[bytes]:
    """It with other numbers and none, cut, with a byte turned, and, of a Modbus frame, any request that is sound."""
    for other in NUMBERS:
        yield LAST_NUMBER.sub(lambda _, other=other: other, message)  # type: ignore[misc]
    for _ in range(10):
        at = chance.randrange(len(message))
        yield message[:at] + chance.randbytes(1) + message[at + 1 :]
        yield message[:at] + message[-1:]
        pdu = message[:1] + bytes([chance.choice(FUNCTIONS), *chance.randbytes(4)])
        pdu += b"" if pdu[1] not in (15, 16) else bytes([2]) + chance.randbytes(2)
        yield pdu + _crc(pdu)


def _crc(frame: bytes) -> bytes:
    """CRC-16/MODBUS, low byte first; apart from any emulator's own, which it tries."""
    value = 0xFFFF
    for byte in frame:
        value ^= byte
        for _ in range(8):
            value = (value >> 1) ^ 0xA001 if value & 1 else value >> 1
    return value.to_bytes(2, "little")


PROMISES = (whatever_it_is_sent_its_emulator_goes_on, whatever_it_is_answered_it_raises_no_other_error)
