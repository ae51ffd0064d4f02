"""SM15K, a connection for each message, at the emulated Delta Elektronika."""

from __future__ import annotations

import pytest
from deltaelektronika.SM15K import SM15K, Communication
from served_benches import Line
from waiting import settled, until


@pytest.mark.met("delta-sm", "SM15K", "identity, set-points in long words, output, measured values; a connection each")
def test_delta_elektronika(line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Communication, "port_name", line.port)
    monkeypatch.setattr(Communication, "timeout", 30)
    supply = SM15K("127.0.0.1")
    assert "DELTA" in supply.Identification().upper()
    supply.source.SetVoltage(20.0)
    supply.source.SetCurrent(0.5)
    until(lambda: float(supply.source.ReadCurrentSet()) == 0.5)
    assert float(supply.source.ReadVoltageSet()) == 20.0
    supply.output.SetOutput(1)
    assert settled(lambda: float(supply.measure.MeasureCurrent()), 0.5)
    assert 0 < float(supply.measure.MeasureVoltage()) < 20
    supply.output.SetOutput(0)
    until(lambda: supply.output.ReadOutputSet().strip() == "0")
    assert settled(lambda: float(supply.measure.MeasureCurrent()), 0.0)
