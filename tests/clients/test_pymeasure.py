"""PyMeasure's own drivers, through pyvisa-py, at the emulated supplies and stages."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from pymeasure.instruments.aimtti import PL303QMTP
from pymeasure.instruments.bkprecision import BKPrecision9130B
from pymeasure.instruments.keithley import Keithley2260B
from pymeasure.instruments.kepco import KepcoBOP3612
from pymeasure.instruments.keysight import KeysightE3631A, KeysightE36312A
from pymeasure.instruments.newport import ESP300
from pymeasure.instruments.rohdeschwarz import HMP4040
from pymeasure.instruments.siglenttechnologies import SPD1305X
from pymeasure.instruments.tdk import TDK_Gen40_38
from served_benches import Line
from waiting import settled, until

pytestmark = pytest.mark.filterwarnings("ignore:It is not known whether:FutureWarning")
PATIENT_MS = 30_000
BY = "PyMeasure"
COMMON = {"visa_library": "@py", "timeout": PATIENT_MS, "write_termination": "\n", "read_termination": "\n"}


@contextmanager
def opened(kind: Callable[..., Any], line: Line, **more: Any) -> Iterator[Any]:
    """PyMeasure's driver on a line; the port is let go at the end."""
    how = COMMON | ({} if line.port else {"baud_rate": line.baud}) | more
    how = {key: value for key, value in how.items() if value is not None}
    instrument = kind(line.visa, **how)
    try:
        yield instrument
    finally:
        instrument.adapter.close()


@pytest.mark.met("tti-pl", BY, "identity, set-points, output, measured current, refusal of an illegal range")
def test_aim_tti(line: Line) -> None:
    with opened(PL303QMTP, line, read_termination="\r\n") as supply:
        assert "THANDAR" in supply.id
        supply.ch_1.voltage_setpoint, supply.ch_1.current_limit = 20, 0.5
        assert (supply.ch_1.voltage_setpoint, supply.ch_1.current_limit) == (20, 0.5)
        supply.ch_1.current_range = "HIGH"
        supply.ch_1.output_enabled = True
        assert settled(lambda: supply.ch_1.current, 0.5)
        assert 0 < supply.ch_1.voltage < 20
        supply.ch_1.current_range = "LOW"  # with the output on
        assert supply.ask("EER?") == "104"
        supply.all_outputs_enabled = False
        assert settled(lambda: supply.ch_1.current, 0.0)
        assert not supply.ch_1.output_enabled


@pytest.mark.met("keysight-e36300", BY, "identity, set-points with a blank after the comma, output, current")
def test_keysight_e36312a(line: Line) -> None:
    with opened(KeysightE36312A, line) as supply:
        assert "E36312A" in supply.id
        supply.ch_1.voltage_setpoint, supply.ch_1.current_limit = 6, 0.25
        supply.ch_1.output_enabled = True
        assert settled(lambda: supply.ch_1.current, 0.25)
        assert (supply.ch_1.voltage_setpoint, supply.ch_1.current_limit) == (6, 0.25)
        supply.ch_1.output_enabled = False
        assert settled(lambda: supply.ch_1.current, 0.0)
        assert supply.check_errors() == []


@pytest.mark.met("kepco-bop", BY, "deaf before SYST:REM ON, then identity, current mode, both signs, self-test")
def test_kepco_bop(line: Line) -> None:
    with opened(KepcoBOP3612, line, write_termination=None, read_termination=None) as supply:
        assert supply.id.startswith("KEPCO,BIT 4886")
        supply.write("SYST:REM OFF")
        supply.current_setpoint = 1.0
        assert supply.next_error[0] == -221
        supply.write("SYST:REM ON")
        supply.operating_mode = "CURR"
        assert supply.operating_mode == "CURR"
        supply.voltage_setpoint = 20
        supply.output_enabled = True
        for amps in (0.1, -1.5, 0.0):
            supply.current_setpoint = amps
            assert settled(lambda amps=amps: supply.current, amps)
        supply.output_enabled = False
        assert supply.confidence_test == 0
        assert supply.check_errors() == []


@pytest.mark.met("newport-esp301", BY, "software limits, unit, motor on, homing, a move and its end, errors")
def test_esp300(line: Line) -> None:
    with opened(ESP300, line, write_termination="\r", read_termination="\r\n") as stage:
        stage.x.disable()
        stage.x.position = 10
        assert stage.error != 0
        stage.x.enable()
        assert stage.x.enabled
        assert stage.x.units == "degree"
        assert (stage.x.left_limit, stage.x.right_limit) == (-720, 720)
        stage.x.home()
        stage.x.wait_for_stop()
        stage.x.position = 12.5
        until(lambda: stage.x.position == pytest.approx(12.5, abs=1e-3))
        assert stage.error == 0


@pytest.mark.met("siglent-spd1000x", BY, "identity, selection, set-points, output and its status bit, current")
def test_siglent_spd1305x(line: Line) -> None:
    with opened(SPD1305X, line) as supply:
        assert "SPD1305X" in supply.id
        supply.ch_1.voltage_setpoint, supply.ch_1.current_limit = 10, 0.4
        supply.ch_1.enable_output()
        assert supply.selected_channel == 1
        assert settled(lambda: supply.ch_1.current, 0.4)
        assert supply.ch_1.voltage > 0
        assert supply.system_status_code & 16
        supply.ch_1.enable_output(False)
        assert settled(lambda: supply.ch_1.current, 0.0)
        assert "No Error" in supply.ask("SYST:ERR?")


@pytest.mark.met("bk-9130b", BY, "channel by name, set-points in long forms, output, measured current and voltage")
def test_bk_9130b(line: Line) -> None:
    with opened(BKPrecision9130B, line) as supply:
        supply.channel = 1
        assert supply.channel == "CH1"
        supply.voltage, supply.current = 12, 0.3
        supply.source_enabled = True
        assert settled(lambda: supply.current, 0.3)
        assert 0 < supply.voltage < 12
        supply.source_enabled = False
        assert not supply.source_enabled
        assert "No Error" in supply.ask("SYST:ERR?")


@pytest.mark.met("rohde-schwarz-hmp", BY, "remote control, selection, set-points, measured current and voltage")
def test_hmp4040(line: Line) -> None:
    with opened(HMP4040, line) as supply:
        supply.control_method = "REM"
        supply.selected_channel = 1
        assert supply.selected_channel == 1
        supply.voltage, supply.current = 12, 0.2
        assert (supply.voltage, supply.current) == (12, 0.2)
        supply.write("OUTP 1")
        assert settled(lambda: supply.measured_current, 0.2)
        assert 0 < supply.measured_voltage < 12
        supply.write("OUTP 0")
        assert supply.check_errors() == []


@pytest.mark.met("keithley-2260b", BY, "identity, set-points, output, measured current and voltage, error queue")
def test_keithley_2260b(line: Line) -> None:
    with opened(Keithley2260B, line) as supply:
        assert "2260B" in supply.id
        supply.voltage_setpoint, supply.current_limit = 15, 0.6
        assert (supply.voltage_setpoint, supply.current_limit) == (15, 0.6)
        supply.output_enabled = True
        assert settled(lambda: supply.current, 0.6)
        assert 0 < supply.voltage < 15
        supply.output_enabled = False
        assert not supply.output_enabled
        assert supply.check_errors() == []


@pytest.mark.met("agilent-e3631a", BY, "selection in the same line, set-points, output, current and voltage")
def test_e3631a(line: Line) -> None:
    with opened(KeysightE3631A, line) as supply:
        assert "E3631A" in supply.id
        supply.ch_1.voltage_setpoint, supply.ch_1.current_limit = 6, 0.3
        assert (supply.ch_1.voltage_setpoint, supply.ch_1.current_limit) == (6, 0.3)
        supply.output_enabled = True
        assert settled(lambda: supply.ch_1.current, 0.3)
        assert 0 < supply.ch_1.voltage < 6
        supply.output_enabled = False
        assert supply.check_errors() == []


@pytest.mark.met("genesys", BY, "its address, identity, set-points, foldback, output, mode, current, a voltage refused")
def test_genesys(line: Line) -> None:
    with opened(TDK_Gen40_38, line, write_termination=None, read_termination=None) as supply:
        assert supply.id == ["LAMBDA", "GEN40-38"]
        supply.remote = "REM"
        supply.voltage_setpoint, supply.current_setpoint = 20, 0.5
        assert (supply.voltage_setpoint, supply.current_setpoint) == (20, 0.5)
        assert not supply.foldback_enabled
        assert supply.mode == "OFF"
        supply.output_enabled = True
        assert settled(lambda: supply.current, 0.5)
        assert supply.mode == "CC"
        assert 0 < supply.voltage < 20
        assert supply.ask("PV 43") == "E01"  # above 95 % of its over-voltage protection
        supply.output_enabled = False
        assert settled(lambda: supply.current, 0.0)
