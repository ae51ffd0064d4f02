"""Our own driver through visa:// at instruments that pyvisa-sim plays: GPIB and USBTMC without a bus."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

import pytest
import pyvisa

from drivers.hp_603x import Hp603x
from drivers.hp_603x import Settings as HpSettings
from drivers.scpi_table import Settings, TableSupply
from labcal.bench.clock import RealClock
from labcal.bench.find.questions import asked
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
  older:
    eom:
      GPIB INSTR: {q: "\\n", r: "\\r\\n"}
    error: {}
    dialogues:
      - {q: "ID?", r: "ID HP6038A"}
      - {q: "ERR?", r: "ERR 0"}
      - {q: "STS?", r: "STS 2"}
    properties:
      current:
        default: 0.0
        getter: {q: "ISET?", r: "ISET {:.4f}"}
        setter: {q: "ISET {:.4f}"}
        specs: {min: 0, max: 10.2, type: float}
      voltage:
        default: 0.0
        getter: {q: "VSET?", r: "VSET {:.3f}"}
        setter: {q: "VSET {:.4f}"}
        specs: {min: 0, max: 61, type: float}
      output:
        default: 1
        getter: {q: "OUT?", r: "OUT {:d}"}
        setter: {q: "OUT {:d}"}
        specs: {min: 0, max: 1, type: int}
      foldback:
        default: 1
        getter: {q: "FOLD?", r: "FOLD {:d}"}
        setter: {q: "FOLD {:d}"}
        specs: {min: 0, max: 2, type: int}
resources:
  GPIB0::8::INSTR: {device: older}
  GPIB0::5::INSTR: {device: supply}
  USB0::0x0957::0x0807::MY51::INSTR: {device: supply}
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


@pytest.mark.met(
    "hp-603x", BY, "our driver over visa:// by GPIB: `bench find`, its own words with CR LF, foldback, output"
)
def test_an_older_supply_on_a_bus(played: None) -> None:
    clock, link = RealClock(), "visa://GPIB0::8::INSTR"
    (found,) = asked(link, clock)
    assert (found.driver, found.said) == ("hp-603x", "ID HP6038A")
    with closing(open_link(link, clock)) as line:
        supply = Hp603x("x", line, clock, HpSettings(timeout_s=PATIENCE_S))
        assert supply.identify().model == "6038A"
        supply.make_safe()
        supply.output(True)
        supply.set_current(0.5)
        assert supply.set_point() == 0.5
        supply.make_safe()
        assert supply.set_point() == 0.0
