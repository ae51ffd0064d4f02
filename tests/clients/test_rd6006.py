"""rd6006 at the emulated Riden."""

from __future__ import annotations

import minimalmodbus
import pytest
from rd6006 import RD6006
from served_benches import Line
from waiting import settled

PATIENT_S = 15.0


@pytest.mark.met("riden-rd60xx", "rd6006", "model and scale, protections, set-points, output, current and power")
def test_rd6006(line: Line) -> None:
    minimalmodbus.Instrument(line.path, 1).serial.timeout = PATIENT_S  # of the port, which the two share
    supply = RD6006(line.path, baudrate=line.baud)
    assert (supply.type, supply.ampres) == (6006, 1000)
    supply.voltage_protection, supply.current_protection = 30, 2
    supply.voltage, supply.current = 20, 0.5
    assert (supply.voltage, supply.current) == (20, 0.5)
    supply.enable = 1
    assert settled(lambda: supply.meascurrent, 0.5)
    assert supply.measpower == pytest.approx(supply.measvoltage * supply.meascurrent, abs=0.05)
    supply.enable = 0
    assert settled(lambda: supply.meascurrent, 0.0)
    supply.instrument.serial.close()
