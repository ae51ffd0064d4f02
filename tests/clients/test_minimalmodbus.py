"""minimalmodbus, a master of its own making, at the emulated supplies, relays, stages and inputs on RS-485."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import minimalmodbus
import pytest
from served_benches import Line
from waiting import settled, until

BY = "minimalmodbus"
PATIENT_S = 15.0
REFUSED_S = 3.0  # a refusal is shorter than an answer: the master waits for the rest as long as it may
FULL = 52428  # of EA: the nominal value


@contextmanager
def opened(line: Line, address: int = 1) -> Iterator[minimalmodbus.Instrument]:
    """A master on the line; the port is let go at the end."""
    master = minimalmodbus.Instrument(line.path, address)
    master.serial.baudrate, master.serial.timeout = line.baud, PATIENT_S
    try:
        yield master
    finally:
        master.serial.close()


@pytest.mark.met("waveshare-relay", BY, "version, single and many contacts, read back, an address that it has not")
def test_relay_board(line: Line) -> None:
    with opened(line) as board:
        assert board.read_register(0x8000) >= 200
        board.write_bits(0, [0] * 8)
        board.write_bit(2, 1)
        assert board.read_bits(0, 8, functioncode=1) == [0, 0, 1, 0, 0, 0, 0, 0]
        board.write_bits(0, [1, 0, 0, 0, 0, 0, 0, 1])
        assert board.read_bits(0, 8, functioncode=1) == [1, 0, 0, 0, 0, 0, 0, 1]
        board.write_bits(0, [0] * 8)
        board.serial.timeout = REFUSED_S
        with pytest.raises(minimalmodbus.ModbusException):
            board.read_bits(4, 8, functioncode=1)


@pytest.mark.met("riden-rd60xx", BY, "all registers in one block, set-points, output, measured current, a trip")
def test_riden(line: Line) -> None:
    with opened(line) as supply:
        assert supply.read_registers(0, 84)[0] == 60062
        supply.write_registers(8, [2000, 500])  # 20 V, 0.5 A
        supply.write_registers(82, [6200, 6200])
        supply.write_register(18, 1, functioncode=6)
        assert settled(lambda: supply.read_register(11, 3), 0.5)
        supply.write_register(83, 400)  # over-current, 0.4 A
        assert settled(lambda: supply.read_register(11, 3), 0.0)
        assert supply.read_registers(16, 3)[::2] == [2, 0]  # tripped, off


@pytest.mark.met("ea-9000", BY, "type, nominal values, refusal before remote control, set-points, output, current")
def test_ea_9000(line: Line) -> None:
    with opened(line) as supply:
        assert supply.read_string(1, 20).rstrip("\0") == "PSI 9080-60 T"
        volts, amps = supply.read_float(121), supply.read_float(123)
        assert (volts, amps) == (80.0, 60.0)
        supply.write_bit(402, 0)
        supply.serial.timeout = REFUSED_S
        with pytest.raises(minimalmodbus.ModbusException):
            supply.write_register(501, 100, functioncode=6)
        supply.serial.timeout = PATIENT_S
        supply.write_bit(402, 1)
        for register, share in ((500, 20 / volts), (501, 0.6 / amps), (502, 0.5)):
            supply.write_register(register, round(FULL * share), functioncode=6)
        supply.write_bit(405, 1)
        assert settled(lambda: supply.read_register(508) / FULL * amps, 0.6)
        supply.write_bit(405, 0)
        assert settled(lambda: supply.read_register(508) / FULL * amps, 0.0)
        supply.write_bit(402, 0)


@pytest.mark.met("oriental-az", BY, "direct data of a move, position in two registers, ready bit, stop")
def test_az(line: Line) -> None:
    with opened(line) as drive:
        begun = drive.read_long(0xCC, signed=True)
        drive.write_registers(0x58, _longs([0, 1, begun + 600, 500, 1000, 1000, 1000, 1]))
        until(lambda: drive.read_long(0xCC, signed=True) == begun + 600)
        until(lambda: bool(drive.read_register(0x7F) & 1 << 5))
        assert drive.read_long(0xC6, signed=True) == begun + 600
        drive.write_registers(0x58, _longs([0, 1, begun + 9000, 100, 1000, 1000, 1000, 1]))
        drive.write_registers(0x7C, [0, 1 << 5])
        until(lambda: bool(drive.read_register(0x7F) & 1 << 5))  # it brakes
        stood = drive.read_long(0xCC, signed=True)
        assert begun + 600 <= stood < begun + 9000
        assert drive.read_long(0xCC, signed=True) == stood
        drive.write_registers(0x7C, [0, 0])


@pytest.mark.met("leadshine", BY, "pulses a turn, homing, a path that is triggered, its status bits and position")
def test_leadshine(line: Line) -> None:
    with opened(line) as drive:
        assert drive.read_register(0x0001) > 0
        drive.write_register(0x6002, 0x0020, functioncode=6)
        until(lambda: bool(drive.read_register(0x1003) & 64) and not drive.read_register(0x1003) & 4)
        assert drive.read_long(0x602A, signed=True) == 0
        drive.write_registers(0x6200, [1, 0, 2000, 60, 100, 100])
        drive.write_register(0x6002, 0x0010, functioncode=6)
        until(lambda: drive.read_register(0x1003) & 0x34 == 0x30)
        assert drive.read_long(0x602A, signed=True) == 2000


def _longs(values: list[int]) -> list[int]:
    return [word for value in values for word in divmod(value & 0xFFFFFFFF, 0x10000)]
