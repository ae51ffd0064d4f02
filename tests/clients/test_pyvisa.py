"""pyvisa with pyvisa-py at sockets and serial lines: messages of the manuals that no driver package sends."""

from __future__ import annotations

import time
from binascii import crc_hqx
from collections.abc import Iterator
from contextlib import closing, contextmanager
from typing import Any

import numpy as np
import pytest
import pyvisa
from pyvisa.util import from_ascii_block
from served_benches import Line
from waiting import settled, until

from drivers.gsm import Gsm
from drivers.gsm import Settings as GsmSettings
from drivers.i2c_board import I2cBoard
from drivers.i2c_board import Settings as I2cSettings
from drivers.pos1 import Pos1
from labcal.bench.driver_kit.testing import scripted

BY = "pyvisa with pyvisa-py"
PATIENT_MS, READINGS = 30_000, 20
ESC = b"\x1b"
DEAF_S = 0.06  # an AlphaLab after a chunk: the least pause, nothing to wait for


@contextmanager
def opened(line: Line, end: str = "\n", reply: str | None = None) -> Iterator[Any]:
    """A session on the line, each message ended by `end` and each reply by `reply`."""
    with closing(pyvisa.ResourceManager("@py")) as manager, closing(manager.open_resource(line.visa)) as session:
        session.timeout, session.write_termination, session.read_termination = PATIENT_MS, end, reply or end
        if not line.port:
            session.baud_rate = line.baud
        yield session


@pytest.mark.met("rigol-dp800", BY, "IEEE 488.2's words, several messages a line, an over-current trip, errors")
def test_rigol(line: Line) -> None:
    with opened(line) as supply:
        assert supply.query("*IDN?").startswith("RIGOL TECHNOLOGIES,DP832")
        supply.write("*RST;*CLS")
        assert supply.query(":APPLy CH1,8,0.5;:OUTPut CH1,ON;*OPC?") == "1"
        assert settled(lambda: float(supply.query(":MEASure:CURRent? CH1")), 0.5)
        supply.write(":OUTP:OCP:VAL CH1,0.3;:OUTP:OCP CH1,ON")
        supply.write(":SOUR1:CURR 0.5")
        assert supply.query(":OUTP:OCP:QUES? CH1;:OUTP? CH1") == "YES;OFF"
        supply.write(":OUTP:OCP:CLE CH1;:OUTP:OCP CH1,OFF;:NONSENSE")
        assert supply.query(":SYST:ERR?").startswith("-113")
        assert supply.query(":SYST:ERR?") == '0,"No error"'


@pytest.mark.met("metrolab", BY, "identity, a reading and an array of one axis with unit, averaging, error queue")
def test_metrolab(line: Line) -> None:
    with opened(line) as probe:
        assert probe.query("*IDN?").startswith("Metrolab")
        field = [float(probe.query(f":READ:SCALar:FLUX:{axis}? 9").removesuffix("T")) for axis in "XYZ"]
        assert 1e-6 < sum(value * value for value in field) ** 0.5 < 2e-4
        assert len(probe.query(":FETC:ARR:X? 3,9").split(",")) == 3
        assert probe.query(":AVER:COUN 10;:AVER:COUN?") == "10"
        assert probe.query(":SYSTEM:ERROR?") == '0,"No error"'


@pytest.mark.met("hmr2300", BY, "*99ID, write-enable before a setting, one reading, streaming and its end")
def test_hmr2300(line: Line) -> None:
    with opened(line, "\r") as sensor:
        assert sensor.query("*99ID").startswith("ID=")
        assert sensor.query("*00A") == "WE OFF"
        assert sensor.query("*99WE") == "OK"
        assert sensor.query("*00A") == "ASCII ON"
        one = _counts(sensor.query("*00P"))
        assert 100 < sum(count * count for count in one) ** 0.5 < 30_000
        sensor.write("*00C")
        rows = [_counts(sensor.read()) for _ in range(20)]
        sensor.write_raw(ESC)
        assert all(abs(a - b) < 200 for row in rows for a, b in zip(row, one, strict=True))
        until(lambda: "POLLED" in sensor.query("*00Q"))


@pytest.mark.met("newport-smc100", BY, "not referenced, homing, a move and its state, position, refusal by letter")
def test_smc100(line: Line) -> None:
    with opened(line, "\r\n") as stage:
        if stage.query("1TS").endswith("0A"):
            stage.write("1PA5")
            assert stage.query("1TE") == "1TEH"
            stage.write("1OR")
        until(lambda: stage.query("1TS").endswith(("32", "33")))
        stage.write("1VA20")
        stage.write("1PA7.5")
        until(lambda: stage.query("1TS").endswith("33"))
        assert float(stage.query("1TP")[3:]) == pytest.approx(7.5, abs=1e-3)
        stage.write("1VA9999")
        assert stage.query("1TE") == "1TEC"
        assert stage.query("1TE") == "1TE@"


@pytest.mark.met("microcontroller", BY, "who it is, set and read-back, refusal beyond its limit and while it is off")
def test_microcontroller(line: Line) -> None:
    with opened(line) as board:
        assert "labcal-coil/1" in board.query(_summed("1 WHO"))
        assert board.query(_summed("2 SET 1 500000")).startswith("2 ERR off")
        assert board.query(_summed("3 OUT 1 1")).startswith("3 OK 1")
        assert board.query(_summed("4 SET 1 -500000")).startswith("4 OK -500000")
        assert settled(lambda: int(board.query(_summed("5 MEAS? 1")).split()[2].split("*")[0]) / 1e6, -0.5)
        assert board.query(_summed("6 SET 1 999999999")).startswith("6 ERR range")
        assert board.query(_summed("7 OUT 1 0")).startswith("7 OK 0")


@pytest.mark.met("pos-1", BY, "who it is, text mode, its range, a reading in picotesla with its code")
def test_pos1(line: Line) -> None:
    with opened(line, "\0") as sensor:
        assert sensor.query("about").startswith("POS-1")
        assert sensor.query("mode text") == "ok"
        nT = int(sensor.query("run").split()[0]) / 1000
        assert 20_000 < nT < 100_000
        assert sensor.query(f"range {round(nT)}") == "ok"
        assert "[80]" in sensor.query("run")


@pytest.mark.slow
@pytest.mark.met("pos-1", BY, "20 readings: its numbers of the text in our driver's nanotesla")
def test_pos1_readings(line: Line) -> None:
    with opened(line, "\0") as sensor:
        assert sensor.query("mode text") == "ok"
        said = [sensor.query("run").encode() for _ in range(READINGS)]
    theirs = [from_ascii_block(words.decode(), "f", lambda text: text.split()[:1])[0] / 1000 for words in said]
    wire = [(b"mode text\0", b"ok\0"), *((b"run\0", words + b"\0") for words in said)]
    with scripted(Pos1, wire, period_s=3.0) as ours:
        ours.start()
        blocks = ours.read_until(ours._clock.now() + 3.0 * READINGS - 0.1)
    assert np.vstack([block.values for block in blocks])[:, 0] == pytest.approx(theirs, abs=1e-6)


@pytest.mark.slow
@pytest.mark.met("gsm", BY, "20 readings: the numbers that it reads of its lines in our driver's nanotesla")
def test_gsm_readings(line: Line) -> None:
    with opened(line) as sensor:
        sensor.read()  # it may have begun before we came
        said = [sensor.read() for _ in range(READINGS)]
    theirs = [from_ascii_block(words, "f", str.split) for words in said]
    ours = Gsm.parse_again(GsmSettings(period_s=0.25), "\n".join([*said, ""]).encode())
    assert ours[:, 0].tolist() == [numbers[-2] for numbers in theirs]
    assert all(numbers[-1] == 99 for numbers in theirs)


@pytest.mark.met(
    "i2c-board", BY, "20 lines: the counts that it reads of them times the data sheet's scale in our driver's nT"
)
def test_i2c_board_readings(line: Line) -> None:
    with opened(line, "\r\n") as board:
        board.read()  # it may have begun before we came
        said = [board.read() for _ in range(READINGS)]
    theirs = [from_ascii_block(words.partition("*")[0], "f", lambda text: text.split()[3:6]) for words in said]
    ours = I2cBoard.parse_again(I2cSettings(chip="lis3mdl"), "\r\n".join([*said, ""]).encode())
    assert ours == pytest.approx(np.array(theirs) * 1e5 / 6842)
    assert all(crc_hqx(words[:-5].encode(), 0xFFFF) == int(words[-4:], 16) for words in said)


@pytest.mark.met("alphalab", BY, "binary requests: its lists in chunks, a reading whose magnitude fits its axes")
def test_alphalab(line: Line) -> None:
    with opened(line) as meter:
        said = meter_list(meter)
        assert said.startswith(b"MODEL=")
        assert b"UNITS=MILLIGAUSS" in said
        meter.write_raw(b"\x03" * 6)
        block = meter.read_bytes(31)
        t, x, y, z, magnitude = (int.from_bytes(block[k + 2 : k + 6], "big") for k in range(0, 30, 6))
        assert t > 0
        assert magnitude == pytest.approx((x * x + y * y + z * z) ** 0.5, abs=1)


@pytest.mark.met("keithley-2200", BY, "short, long and chained words, output, current, a value out of range")
def test_keithley_2200(line: Line) -> None:
    with opened(line) as supply:
        assert "2200-20-5" in supply.query("*IDN?")
        supply.write("SYST:REM;:SOURce:VOLTage:LEVel 12;:CURR 0.25;:OUTP ON")
        assert settled(lambda: float(supply.query("MEASure:CURRent?")), 0.25)
        supply.write("CURR 99;:OUTPut 0")
        assert supply.query("OUTP?;:SYST:ERR?").startswith("0;-222")


@pytest.mark.met("rohde-schwarz-hmc804x", BY, "selection, set-points, output, current")
@pytest.mark.parametrize("channel", [1])
def test_hmc804x(line: Line, channel: int) -> None:
    with opened(line) as supply:
        supply.write(f"*CLS;INST:NSEL {channel};:VOLT 10;:CURR 0.3;:OUTP 1")
        assert supply.query("INST:NSEL?") == f"{channel}"
        assert settled(lambda: float(supply.query("MEAS:CURR?")), 0.3)
        supply.write("OUTP 0")
        assert settled(lambda: float(supply.query("MEAS:CURR?")), 0.0)
        assert supply.query("SYST:ERR?").startswith(("0", "+0"))


@pytest.mark.met("kikusui-pbz", BY, "both signs of current through zero, output, error queue")
def test_kikusui(line: Line) -> None:
    with opened(line) as supply:
        supply.write("*RST;*CLS")
        supply.write("VOLT:LIM:UPP 15;:VOLT:LIM:LOW -15;:OUTP 1")
        for amps in (0.4, -0.4, 0.0):
            supply.write(f"CURR {amps}")
            assert settled(lambda: float(supply.query("MEAS:CURR?")), amps)
        supply.write("OUTP 0")
        assert supply.query("SYST:ERR?").startswith(("0", "+0"))


def _counts(line: str) -> list[int]:
    """Three counts, as they are read where commas are not relied on: a sign, then digits, blanks between."""
    columns = line.replace(",", "").replace("- ", "-").split()
    return _joined(columns)


def _joined(columns: list[str]) -> list[int]:
    whole, sign = list[int](), 1
    for column in columns:
        if column == "-":
            sign = -1
            continue
        whole.append(sign * int(column))
        sign = 1
    return whole


def _summed(words: str) -> str:
    """A line of labcal-coil/1 with its CRC-8, polynomial 07h."""
    rest = 0
    for byte in words.encode():
        rest ^= byte
        for _ in range(8):
            rest = (rest << 1 ^ 7) & 0xFF if rest & 0x80 else rest << 1
    return f"{words}*{rest:02X}"


def meter_list(meter: Any) -> bytes:
    """What it says of itself, in chunks of nineteen letters: 8 stands after one that goes on, 7 after the last."""
    said, request = b"", 0x01
    while not said.endswith(b"\x07"):
        time.sleep(DEAF_S)
        meter.write_raw(bytes([request]) * 6)
        said, request = said.removesuffix(b"\x08") + meter.read_bytes(1), 0x08
        while said[-1] not in (7, 8):
            said += meter.read_bytes(1)
    return said
