"""labcal-mag/1: chips as their data sheets have them, read alike by C++ and MicroPython, and the driver's bytes."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from listening import heard, listening

from drivers.i2c_board import I2cBoard, sealed
from labcal.errors import InstrumentError

FIRMWARE = Path(__file__).parents[2] / "examples" / "microcontroller"
COMPILER = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
compiled = pytest.mark.skipif(COMPILER is None or sys.platform == "win32", reason="no C++ compiler")
FIELD_nT = 20_000.0, -45_000.0, 1_000.0
Registers = dict[int, int]


class Chip:
    """Registers of a chip that senses FIELD_nT; `who`: its register and word of identity."""

    def __init__(self, at: int, who: tuple[int, int], status: tuple[int, int], dummies: int = 0) -> None:
        self.at, self.dummies, self.full, self.there = at, dummies, False, True
        self.written: list[tuple[int, int]] = []
        self.registers: Registers = dict([who, status])

    def put(self, at: int, register: int, value: int) -> None:
        if at != self.at or not self.there:
            raise OSError("no acknowledgement")
        self.written.append((register, value))
        self.measured()

    def get(self, at: int, register: int, count: int) -> bytes:
        if at != self.at or not self.there:
            raise OSError("no acknowledgement")
        held = bytes(self.registers.get(register + k, 0) for k in range(count - self.dummies))
        return bytes(self.dummies) + held

    def measured(self) -> None:
        """What stands in the data registers once it has measured."""
        for register, value in enumerate(self.data(), self.first()):
            self.registers[register] = value

    def first(self) -> int:
        return 0

    def data(self) -> bytes:
        raise NotImplementedError

    def writeto_mem(self, at: int, register: int, data: bytes) -> None:
        """As `machine.I2C` has it."""
        self.put(at, register, data[0])

    readfrom_mem = get


class Rm3100(Chip):
    """75 counts a µT at 200 cycles, as its manual's table has it."""

    def __init__(self) -> None:
        super().__init__(0x20, (0x36, 0x22), (0x34, 0x80))

    def first(self) -> int:
        return 0x24

    def data(self) -> bytes:
        counts = [0x7FFFFF if self.full else round(nT * 75e-3) for nT in FIELD_nT]
        return b"".join(count.to_bytes(3, "big", signed=True) for count in counts)


class Mmc5983(Chip):
    """16384 counts a gauss about 131072, and an offset of its bridge that RESET turns about."""

    def __init__(self) -> None:
        super().__init__(0x30, (0x2F, 0x30), (0x08, 0x01))

    def data(self) -> bytes:
        sign = next((1 if value == 0x08 else -1 for at, value in self.written[::-1] if at == 9 and value > 1), 1)
        counts = [262_143 if self.full else 131_072 + 700 + sign * round(nT / 1e5 * 16_384) for nT in FIELD_nT]
        low = sum((count & 3) << (6 - 2 * k) for k, count in enumerate(counts))
        return bytes([b for count in counts for b in (count >> 10, count >> 2 & 0xFF)] + [low])


class Low(Chip):
    """16 bits, low byte first."""

    def data(self) -> bytes:
        counts = [32_767 if self.full else round(nT / 1e5 * self.per_gauss) for nT in FIELD_nT]
        return b"".join(count.to_bytes(2, "little", signed=True) for count in counts)


class Lis3mdl(Low):
    per_gauss = 6842

    def __init__(self) -> None:
        super().__init__(0x1C, (0x0F, 0x3D), (0x27, 0x08))

    def first(self) -> int:
        return 0xA8


class Qmc5883(Low):
    per_gauss = 12_000

    def __init__(self) -> None:
        super().__init__(0x0D, (0x0D, 0xFF), (0x06, 0x01))

    def measured(self) -> None:
        super().measured()
        self.registers[0x06] = 0x03 if self.full else 0x01


class Bmm350(Chip):
    """0.00707 µT a count across its plane and 0.00718 along z; two bytes before each answer."""

    def __init__(self) -> None:
        super().__init__(0x14, (0x00, 0x33), (0x30, 0x04), dummies=2)

    def first(self) -> int:
        return 0x31

    def data(self) -> bytes:
        per_count = zip(FIELD_nT, (7.07, 7.07, 7.18), strict=True)
        counts = [0x7FFFFF if self.full else round(nT / per) for nT, per in per_count]
        return b"".join(count.to_bytes(3, "little", signed=True) for count in counts)


CHIPS: dict[str, type[Chip]] = {
    "rm3100": Rm3100, "mmc5983": Mmc5983, "lis3mdl": Lis3mdl, "qmc5883": Qmc5883, "bmm350": Bmm350,
}  # fmt: skip
Lines = Callable[[str, Any, int], list[str]]


def micropython(name: str, chip: Any, count: int) -> list[str]:
    spec = importlib.util.spec_from_file_location("mag_chips", FIRMWARE / "pico_magnetometer" / "mag_chips.py")
    assert spec is not None
    assert spec.loader is not None
    spec.loader.exec_module(module := importlib.util.module_from_spec(spec))
    kind = next(kind for kind in vars(module).values() if getattr(kind, "name", "") == name)
    sensor, lines = kind(chip), module.Lines()
    if chip.there:
        assert sensor.begin()
    return [lines.of(sensor, 50 * k) for k in range(count)]


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The C++ firmware's chips, built for this computer."""
    path = tmp_path_factory.mktemp("chips") / "chips"
    words = [str(COMPILER), "-std=c++11", "-Wall", "-Wextra", "-Werror", "-O1", "-o", str(path), "magnetometer.cpp"]
    subprocess.run(words, cwd=FIRMWARE / "pc", check=True, timeout=600)
    return path


def in_c(program: Path, name: str, chip: Any, count: int) -> list[str]:
    with subprocess.Popen([program, name, f"{count}"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as run:
        assert run.stdin is not None
        assert run.stdout is not None
        said = list[str]()
        for line in run.stdout:
            word, *rest = line.split()
            if word in ("put", "get"):
                run.stdin.write(answer(chip, word, *map(int, rest)))
                run.stdin.flush()
            elif word == "line":
                said.append(line.removeprefix("line ").strip())
            else:
                assert rest == [f"{chip.there:d}"]
    return said


def answer(chip: Any, word: str, at: int, register: int, value: int) -> str:
    try:
        if word == "put":
            chip.put(at, register, value)
            return "1\n"
        return " ".join(map(str, [1, *chip.get(at, register, value)])) + "\n"
    except OSError:
        return "0\n"


@compiled
@pytest.mark.parametrize("name", CHIPS)
def test_both_firmwares_send_the_same_lines_and_they_are_the_field(name: str, program: Path) -> None:
    lines = micropython(name, CHIPS[name](), 3)
    assert in_c(program, name, CHIPS[name](), 3) == lines
    blocks, lost = heard(I2cBoard, [(1.0, "\n".join(["", *lines, ""]).encode())], chip=name)
    assert lost == {}
    for row in blocks[0].values.tolist():
        assert row == pytest.approx(FIELD_nT, rel=2.5e-3, abs=15)


@compiled
@pytest.mark.parametrize("name", CHIPS)
@pytest.mark.parametrize(("state", "fault"), [("full", "overloaded"), ("none", "silent")])
def test_a_chip_that_is_full_or_away_is_no_value(name: str, state: str, fault: str, program: Path) -> None:
    def chip() -> Any:
        made: Any = CHIPS[name]()
        made.full, made.there = state == "full", state != "none"
        made.measured()
        return made

    lines = micropython(name, chip(), 2)
    assert in_c(program, name, chip(), 2) == lines
    with pytest.raises(InstrumentError) as caught:
        heard(I2cBoard, [(1.0, "\n".join(["", *lines, ""]).encode())], chip=name)
    assert caught.value.fault == fault


def line(number: int, x: float, ms: int = 0) -> bytes:
    return sealed(f"{number} rm3100 {ms} {x:.0f} 0 -75")


def test_a_gap_and_a_wrong_checksum_are_noted_and_no_value_is_made_up() -> None:
    lines = [b"\n", line(998, 75), line(999, 150), line(1, 225), line(2, 300).replace(b"300", b"301"), b"1 rm31\n"]
    blocks, lost = heard(I2cBoard, [(1.0, b"".join(lines))], nT_per_count=(13.0, 13.0, 13.0))
    assert blocks[0].values[:, 0].tolist() == [975.0, 1950.0, 2925.0]
    assert lost == {"gap": 1, "checksum": 1, "bad frame": 1}


def test_another_chip_is_refused() -> None:
    with pytest.raises(InstrumentError, match="a rm3100 answers, not a bmm350") as caught:
        heard(I2cBoard, [(1.0, b"\n" + line(0, 1))], chip="bmm350")
    assert caught.value.fault == "another instrument"


def test_the_boards_own_clock_goes_on_where_its_counter_begins_again() -> None:
    ends = [b"\n", line(0, 1, 2**32 - 50), line(1, 1, 0), line(2, 1, 50)]
    blocks, lost = heard(I2cBoard, [(1.0, b"".join(ends))], stamp="device")
    t = blocks[0].t_s
    assert (t[1:] - t[:-1]).tolist() == pytest.approx([0.05, 0.05], abs=1e-3)
    assert lost == {}


def test_who_it_is_states_the_scale() -> None:
    board = listening(I2cBoard, [(0.1, b"\n" + line(0, 1) + line(1, 1))], serial="7")
    who = board.identify()
    assert (who.manufacturer, who.model, who.serial) == ("labcal-mag/1", "rm3100", "7")
    assert who.firmware.startswith("13.34")
