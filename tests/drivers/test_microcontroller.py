"""labcal-coil/1: the driver's bytes, and one list of lines for three firmwares: emulator, C++, MicroPython."""

from __future__ import annotations

import ast
import importlib.util
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from drivers.framing.coil_line import crc8, opened, sealed
from drivers.microcontroller import CoilBoard, Settings
from labcal.bench.clock import RealClock
from labcal.bench.driver_kit.testing import SILENT, scripted
from labcal.bench.links import open_link
from labcal.errors import InstrumentError, LimitError
from labcal.testing.drivers import installed

FIRMWARE = Path(__file__).parents[2] / "examples" / "microcontroller"
COMPILER = shutil.which("c++") or shutil.which("g++") or shutil.which("clang++")
compiled = pytest.mark.skipif(COMPILER is None or sys.platform == "win32", reason="no C++ compiler, or no ptys")
PATIENCE_S = 60.0
WHO = b"9 OK labcal-coil/1 my-lab h-bridge 0001 1.0 channels=3 unit=uA limit=2500000 watchdog_ms=1000 sense=1*7F\n"

LINES: list[tuple[bytes, str | None]] = [  # from power-up, of a board of 3 A; None: not a word
    (b"1 SET? 1", "1 OK 0"), (b"2 OUT? 1", "2 OK 0"), (b"3 TRIP? 1", "3 OK none"), (b"4 MEAS? 1", "4 OK 0"),
    (b"5 SET 1 500000", "5 ERR off"), (b"6 SET 1 0", "6 OK 0"), (b"7 OUT 1 1", "7 OK 1"),
    (b"8 SET 1 -500000", "8 OK -500000"), (b"9 SET? 1", "9 OK -500000"), (b"10 SET? 2", "10 OK 0"),
    (b"11 SET 1 3000001", "11 ERR range"), (b"12 SET 1 -3000001", "12 ERR range"), (b"13 SET? 1", "13 OK -500000"),
    (b"14 OUT 1 1", "14 OK 1"), (b"15 SET? 1", "15 OK -500000"), (b"16 OUT 4 1", "16 ERR channel"),
    (b"17 OUT 0 1", "17 ERR channel"), (b"18 OUT 1 2", "18 ERR number"), (b"19 SET 1", "19 ERR number"),
    (b"20 SET 1 5 5", "20 ERR number"), (b"21 SET 1 5.0", "21 ERR number"), (b"22 SET 1 1234567890", "22 ERR number"),
    (b"23 RST", "23 ERR word"), (b"24 set 1 0", "24 ERR word"), (b"25 WHO 1", "25 ERR number"),
    (b"1000 SET? 1", None), (b"SET? 1", None), (b" 1 SET? 1", None), (b"", None), (b"-1 SET? 1", None),
    (b"26 SET 1 1*00", None), (b"27 SET 1 1", "27 OK 1"), (b"28 SET 1 " + b"0" * 60, None),
    (b"29 SET? 1", "29 OK 1"), (b"30 OUT 1 0", "30 OK 0"), (b"31 SET? 1", "31 OK 0"), (b"255 OUT? 1", "255 OK 0"),
]  # fmt: skip
Say = Callable[[bytes], bytes]


def line_of(text: bytes) -> bytes:
    return text + b"\n" if text.endswith(b"*00") else sealed(text.decode())


@contextmanager
def emulator() -> Iterator[Say]:
    rig = installed("microcontroller", forbidden=[]).rig()

    def say(line: bytes) -> bytes:
        rig.emulator.take(rig.clock.now(), line)
        rig.wait(0.01)
        return b"".join(piece for _, piece in rig.emulator.emit(rig.clock.now()))

    yield say


class Bridges:
    def __init__(self) -> None:
        self.flows = [0, 0, 0]

    def drive(self, c: int, value: int) -> None:
        self.flows[c] = value

    def open(self, c: int) -> None:
        self.flows[c] = 0

    def measured(self, c: int) -> int:
        return self.flows[c]


def pico(watchdog_ms: int = 1000) -> Any:
    spec = importlib.util.spec_from_file_location("pico_protocol", FIRMWARE / "pico" / "coil_protocol.py")
    assert spec is not None
    assert spec.loader is not None
    spec.loader.exec_module(module := importlib.util.module_from_spec(spec))
    who = {"maker": "labcal", "model": "pico", "serial": "1", "firmware": "1.0", "channels": 3, "unit": "uA",
           "limit": 3_000_000, "watchdog_ms": watchdog_ms, "sense": 1}  # fmt: skip
    protocol = module.Protocol(who, Bridges())
    protocol.begin()
    return protocol


@contextmanager
def micropython() -> Iterator[Say]:
    protocol = pico()
    yield lambda line: b"".join(protocol.take(line[k : k + 1]) or b"" for k in range(len(line)))


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The firmware, built for this computer."""
    path = tmp_path_factory.mktemp("board") / "board"
    words = [str(COMPILER), "-std=c++11", "-Wall", "-Wextra", "-Werror", "-O1", "-o", str(path), "main.cpp"]
    subprocess.run(words, cwd=FIRMWARE / "pc", check=True, timeout=600)
    return path


@contextmanager
def board(program: Path, watchdog_ms: int) -> Iterator[str]:
    """It runs; gives the URL of its line. It ends with its standard input."""
    with subprocess.Popen([program, str(watchdog_ms)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as run:
        assert run.stdin is not None
        assert run.stdout is not None
        yield f"serial://{run.stdout.readline().strip()}?baud=115200"
        run.stdin.close()
        assert run.wait(PATIENCE_S) == 0


@contextmanager
def on_the_board(program: Path, watchdog_ms: int, **stated: Any) -> Iterator[CoilBoard]:
    clock = RealClock()
    with board(program, watchdog_ms) as url, closing(open_link(url, clock)) as link:
        settings = Settings(max_current_A=2.5, watchdog_s=watchdog_ms / 1000, timeout_s=PATIENCE_S, **stated)
        yield CoilBoard("board", link, clock, settings)


def replies(say: Say) -> None:
    """What a firmware answers to all of LINES, whole and sealed."""
    for text, answer in LINES:
        said = say(line_of(text))
        assert said == (b"" if answer is None else sealed(answer)), text


@pytest.mark.parametrize("firmware", [emulator, micropython])
def test_each_firmware_answers_the_same(firmware: Callable[[], Any]) -> None:
    with firmware() as say:
        replies(say)


@compiled
def test_the_c_firmware_answers_the_same(program: Path) -> None:
    clock = RealClock()
    with board(program, 0) as url, closing(open_link(url, clock)) as link:

        def say(line: bytes) -> bytes:
            """Its reply; after a line that is answered by nothing the next one's alone."""
            link.send(line)
            link.send(sealed("99 TRIP? 3"))
            said = link.ask(b"", end=sealed("99 OK none"), timeout_s=PATIENCE_S)
            return said.removesuffix(sealed("99 OK none"))

        replies(say)


@compiled
def test_the_driver_drives_the_c_firmware_over_a_real_line(program: Path) -> None:
    with on_the_board(program, 60_000, channel=2) as supply:
        who = supply.identify()
        assert (who.manufacturer, who.model, who.serial) == ("labcal", "pc-board", "0001")
        supply.output(True)
        supply.set_current(-0.75)
        assert supply.measure_current() == -0.75
        supply.feed()
        supply.write_current(0.25)
        assert supply.set_point() == 0.25
        with pytest.raises(LimitError, match="nothing was sent"):
            supply.set_current(2.6)
        supply.make_safe()
        assert (supply.set_point(), supply.measure_current(), supply.enabled) == (0.0, 0.0, 0.0)


@compiled
def test_the_c_firmware_falls_to_zero_by_itself_and_says_so(program: Path) -> None:
    with on_the_board(program, 1) as supply:
        until_s = time.monotonic() + PATIENCE_S
        while supply.trip() != "watchdog" and time.monotonic() < until_s:  # a line that comes within 1 ms saves it
            with suppress(InstrumentError):
                supply.output(True)
        with pytest.raises(InstrumentError, match="its watchdog has taken it to zero") as caught:
            supply.set_current(1.0)
        assert caught.value.fault == "tripped"
        assert (supply.set_point(), supply.measure_current()) == (0.0, 0.0)


def test_silence_takes_the_micropython_firmware_to_zero_and_a_beat_does_not_bring_it_back() -> None:
    protocol = pico()

    def say(text: str) -> bytes:
        return b"".join(protocol.take(bytes([byte])) or b"" for byte in sealed(text))

    assert say("1 OUT 1 1") == sealed("1 OK 1")
    say("2 SET 1 700000")
    protocol.tick(900)
    assert protocol.bridges.flows == [700_000, 0, 0]
    assert say("3 BEAT") == sealed("3 OK 100"), "what was left, so that the margin is seen"
    protocol.tick(1001)
    assert protocol.bridges.flows == [0, 0, 0]
    assert say("4 BEAT") == sealed("4 ERR watchdog")
    assert say("5 SET 1 700000") == sealed("5 ERR watchdog")
    assert say("6 TRIP? 1") == sealed("6 OK watchdog")
    assert say("7 OUT 1 1") == sealed("7 OK 1")
    assert say("8 SET? 1") == sealed("8 OK 0"), "switched on anew it is at zero"


@compiled
def test_the_arduino_sketch_compiles(tmp_path: Path) -> None:
    (tmp_path / "Arduino.h").write_text(
        "#include <stdint.h>\nenum { LOW, HIGH, OUTPUT, A0 = 14, A1, A2 };\nvoid digitalWrite(int, int);\n"
        "void pinMode(int, int);\nvoid analogWrite(int, int);\nint analogRead(int);\nunsigned long millis();\n"
        "struct Port { void begin(long); int available(); int read(); void write(const char*); };\n"
        "extern Port Serial;\n"
    )
    sketch = FIRMWARE / "coil_supply" / "coil_supply.ino"
    words = [str(COMPILER), "-std=c++11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-include", "Arduino.h"]
    subprocess.run([*words, f"-I{tmp_path}", "-x", "c++", str(sketch)], check=True, timeout=600)


def test_the_picos_program_is_python_and_minds_its_watchdog() -> None:
    text = (FIRMWARE / "pico" / "main.py").read_text()
    ast.parse(text)
    assert "WDT(" in text
    assert text.index("kbd_intr(-1)") < text.index("while True"), "a byte 03h must not end the program"


def test_the_checksum_is_the_one_that_is_documented() -> None:
    assert crc8(b"123456789") == 0xF4
    assert opened(WHO) is not None
    assert opened(WHO.replace(b"2500000", b"2500001")) is None


def test_who_it_is_and_what_it_may() -> None:
    with scripted(CoilBoard, [(b"9 WHO*C8\n", WHO)], watchdog_s=1.0) as supply:
        who = supply.identify()
        assert (who.manufacturer, who.model, who.serial, who.firmware) == ("my-lab", "h-bridge", "0001", "1.0")


@pytest.mark.parametrize(
    ("stated", "told"),
    [
        ({}, "watchdog takes 1 s.*settings say otherwise"),
        ({"watchdog_s": 1.0, "channel": 4}, "it has 3 channels"),
        ({"watchdog_s": 1.0, "full_scale_A": 4.0}, "it counts in uA"),
        ({"watchdog_s": 1.0, "max_current_A": 2.6}, "limit is 2.5 A"),
        ({"watchdog_s": 1.0, "unsensed": True}, "it measures its current"),
    ],
)
def test_settings_that_are_not_the_boards_are_refused(stated: dict[str, Any], told: str) -> None:
    number = 8 | stated.get("channel", 1)
    wire = [(sealed(f"{number} WHO"), sealed(f"{number} {opened(WHO)[2].join(('OK ', ''))}"))]  # type: ignore[index]
    with scripted(CoilBoard, wire, **stated) as supply, pytest.raises(InstrumentError, match=told) as caught:
        supply.identify()
    assert caught.value.fault == "wrong set-up"


def test_a_board_that_starts_when_its_port_is_opened_is_asked_again() -> None:
    wire = [(b"9 WHO*C8\n", SILENT), (sealed("17 WHO"), SILENT), (sealed("25 WHO"), sealed("25" + WHO[1:-4].decode()))]
    with scripted(CoilBoard, wire, watchdog_s=1.0) as supply:
        assert supply.identify().model == "h-bridge"


def test_a_current_is_whole_microamperes_and_is_read_back() -> None:
    wire = [(sealed("9 SET 1 -500000"), sealed("9 OK -500000")), (sealed("17 SET? 1"), sealed("17 OK -500000")),
            (sealed("25 MEAS? 1"), sealed("25 OK -499712"))]  # fmt: skip
    with scripted(CoilBoard, wire) as supply:
        supply.set_current(-0.5)
        assert supply.measure_current() == -0.499712


def test_a_duty_is_millionths_of_what_flows_at_full_duty() -> None:
    wire = [(sealed("9 SET 1 125000"), sealed("9 OK 125000")), (sealed("17 SET? 1"), sealed("17 OK 125000")),
            (sealed("25 MEAS? 1"), sealed("25 OK 498000"))]  # fmt: skip
    with scripted(CoilBoard, wire, full_scale_A=4.0) as supply:
        supply.set_current(0.5)
        assert supply.measure_current() == 0.498


def test_an_answer_with_another_number_is_late_and_answers_nothing() -> None:
    wire = [(sealed("9 MEAS? 1"), sealed("1 OK 999999") + sealed("9 OK 250000"))]
    with scripted(CoilBoard, wire) as supply:
        assert supply.measure_current() == 0.25


@pytest.mark.parametrize(
    ("reply", "fault"),
    [
        (b"9 OK 250000*00\n", "wrong reply"),
        (sealed("9 OK 2.5"), "wrong reply"),
        (sealed("9 OK 99999999999"), "wrong reply"),
        (sealed("9 ERR channel"), "refused"),
        (sealed("9 ERR watchdog"), "tripped"),
        (sealed("9 ERR hm"), "refused"),
        (SILENT, "silent"),
    ],
)
def test_what_is_no_answer_is_named(reply: Any, fault: str) -> None:
    with scripted(CoilBoard, [(sealed("9 MEAS? 1"), reply)]) as supply, pytest.raises(InstrumentError) as caught:
        supply.measure_current()
    assert caught.value.fault == fault


def test_a_current_that_the_watchdog_ended_is_named() -> None:
    wire = [(sealed("9 SET 1 500000"), sealed("9 OK 500000")), (sealed("17 SET? 1"), sealed("17 OK 500000")),
            (sealed("25 MEAS? 1"), sealed("25 OK 12")), (sealed("33 TRIP? 1"), sealed("33 OK watchdog"))]  # fmt: skip
    with scripted(CoilBoard, wire) as supply:
        supply.set_current(0.5)
        with pytest.raises(InstrumentError, match="its watchdog protection tripped"):
            supply.measure_current()
