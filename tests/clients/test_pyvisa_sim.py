"""Our own driver through visa:// at instruments that pyvisa-sim plays: GPIB and USBTMC without a bus."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
import pyvisa

from drivers.scpi_table import Settings, TableSupply
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link

BY = "pyvisa-sim"
PATIENCE_S = 15.0
SUPPLY = """
spec: "1.1"
devices:
  supply:
    eom:
      GPIB INSTR: {q: "\\n", r: "\\n"}
      USB INSTR: {q: "\\n", r: "\\n"}
    error: ERROR
    dialogues:
      - {q: "*IDN?", r: "HEWLETT-PACKARD,6632B,US36350101,A.02.04"}
      - {q: "SYST:ERR?", r: '+0,"No error"'}
      - {q: "STAT:QUES:COND?", r: "0"}
    properties:
      current:
        default: 0.0
        getter: {q: "CURR?", r: "{:.4f}"}
        setter: {q: "CURR {:.4f}"}
        specs: {min: 0, max: 5.1, type: float}
      voltage:
        default: 0.0
        getter: {q: "VOLT?", r: "{:.3f}"}
        setter: {q: "VOLT {:.3f}"}
        specs: {min: 0, max: 20.4, type: float}
      output:
        default: 0
        getter: {q: "OUTP?", r: "{:d}"}
        setter: {q: "OUTP {:d}"}
        specs: {min: 0, max: 1, type: int}
resources:
  GPIB0::5::INSTR: {device: supply}
  USB0::0X0957::0X0807::MY51::INSTR: {device: supply}
"""


@pytest.fixture
def played(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """pyvisa with the instruments above in place of a bus."""
    page, manager = tmp_path / "supply.yaml", pyvisa.ResourceManager
    page.write_text(SUPPLY, encoding="utf-8")
    monkeypatch.setattr(pyvisa, "ResourceManager", lambda backend: manager(f"{page}@sim"))


@pytest.mark.met("agilent-66xx", BY, "our driver over visa:// by GPIB and USBTMC: identity, set-points, output")
@pytest.mark.parametrize("resource", ["GPIB0::5::INSTR", "USB0::0x0957::0x0807::MY51::INSTR"])
def test_a_table_supply_on_a_bus(played: None, resource: str) -> None:
    clock = RealClock()
    with closing(open_link(f"visa://{resource}", clock)) as link:
        supply = TableSupply("x", link, clock, Settings(model="agilent-66xx", timeout_s=PATIENCE_S))
        assert supply.identify().model == "6632B"
        supply.make_safe()
        supply.output(True)
        supply.set_current(0.5)
        assert supply.set_point() == 0.5
        supply.set_current(0.0)
        supply.output(False)
        supply.release()
