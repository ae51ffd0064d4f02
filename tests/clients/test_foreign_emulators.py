"""The other direction: our drivers and links at instruments that other people's programs play, on real lines.

ISIS's devices for lewis are in no package: `LABCAL_ISIS` names a clone of ISISComputingGroup/EPICS-DeviceEmulator.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, closing
from pathlib import Path

import pytest
import pyvisa
from waiting import LONG_S, until

from drivers.kepco_bop import KepcoBop
from drivers.kepco_bop import Settings as KepcoSettings
from drivers.scpi_table import Settings, Table, TableSupply
from drivers.tti_pl import Settings as TtiSettings
from drivers.tti_pl import TtiSupply
from labcal.bench.clock import RealClock
from labcal.bench.find import find
from labcal.bench.links import open_link
from labcal.bench.links.modbus import modbus_link
from labcal.errors import InstrumentError

MOCK = Table(  # the second device of pyvisa-sim's own default.yaml, in its words
    maker="SCPI", models="MOCK", example="SCPI,MOCK,VERSION_1.0,1",
    set_current=":CURR:IMM:AMPL {value:.3f}", ask_current=":CURR:IMM:AMPL?",
    set_voltage=":VOLT:IMM:AMPL {value:.3f}", ask_voltage=":VOLT:IMM:AMPL?",
    measure_current=":CURR:IMM:AMPL?", output="OUTP {on}", ask_output="OUTP?", errors="", most_A=6.0, most_V=6.0,
)  # fmt: skip
ELECTROMETER = """
devices:
  - name: electrometer
    class: ElettraElectrometer
    package: sinstruments.simulators.elettra
    transports: [{{type: tcp, url: "127.0.0.1:{port}"}}]
"""
Played = Callable[..., int]


@pytest.fixture
def played(tmp_path: Path) -> Iterator[Played]:
    """Starts a program that plays an instrument at a free port, which its words name as {port}; waits until it is."""
    with ExitStack() as afterwards:

        def start(*words: str) -> int:
            with socket.create_server(("127.0.0.1", 0)) as free:
                port = int(free.getsockname()[1])
            said = [sys.executable, "-m", *(word.replace("{port}", str(port)) for word in words)]
            child = subprocess.Popen(said, cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            afterwards.callback(child.wait)
            afterwards.callback(child.kill)
            until(lambda: _answers(port, child))
            return port

        yield start


def _answers(port: int, child: subprocess.Popen[bytes]) -> bool:
    assert child.poll() is None, "it has ended"
    try:
        socket.create_connection(("127.0.0.1", port), 1.0).close()
    except OSError:
        time.sleep(0.1)
        return False
    return True


@pytest.mark.met(
    "scpi-table", "pyvisa-sim's own devices", "identity, both set-points, output; a zero not taken is seen"
)
def test_the_mock_supply_of_pyvisa_sim(monkeypatch: pytest.MonkeyPatch) -> None:
    manager = pyvisa.ResourceManager
    monkeypatch.setattr(pyvisa, "ResourceManager", lambda backend: manager("@sim"))
    clock = RealClock()
    with closing(open_link("visa://GPIB0::9::INSTR", clock)) as link:
        stated = Settings(table=MOCK, max_current_A=3.0, timeout_s=LONG_S)
        supply = TableSupply("x", link, clock, stated)
        assert supply.identify().model == "MOCK"
        for amps in (1.0, 1.25, 2.999):
            supply.set_current(amps)
            assert supply.set_point() == amps
        supply.enabled = 1
        assert supply.enabled == 1
        supply.enabled = 0
        with pytest.raises(InstrumentError) as caught:  # it takes no less than 1 A
            supply.set_current(0.0)
        assert caught.value.fault


@pytest.mark.met(
    "scpi-table", "pyvisa-sim's own devices", "`bench find` by VISA: what is on its buses is asked who it is"
)
def test_the_buses_of_pyvisa_sim_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    manager = pyvisa.ResourceManager
    monkeypatch.setattr(pyvisa, "ResourceManager", lambda backend: manager("@sim"))
    listed = {one.link: one.said for one in find(["visa://"], RealClock())}
    assert listed["visa://GPIB0::9::INSTR"] == "SCPI,MOCK,VERSION_1.0"
    assert "not asked" in listed["visa://TCPIP0::localhost::inst0::INSTR"]
    assert not [link for link in listed if "ASRL" in link or "SOCKET" in link]


@pytest.mark.met("labjack-t7", "lewis", "the link below it: registers and coils by Modbus TCP, and no such address")
def test_the_modbus_device_of_lewis(played: Played) -> None:
    port = played("lewis", "-a", "examples", "-k", "lewis.examples", "modbus_device", "-p",
                  "modbus: {bind_address: 127.0.0.1, port: {port}}")  # fmt: skip
    clock = RealClock()
    with closing(open_link(f"modbus-tcp://127.0.0.1:{port}", clock)) as line:
        master = modbus_link(line, clock)
        for address, word in ((0, 0), (7, 1), (700, 40_000), (65_535, 65_535)):
            master.write_register(1, address, word)
            assert master.read_holding(1, address, 1) == master.read_input(1, address, 1) == [word]
        for on in (True, False):
            master.write_coil(1, 12, on)
            assert master.read_coils(1, 11, 3) == [False, on, False]


@pytest.mark.met("tti-pl", "sinstruments", "its electrometer at our driver: nothing is set, and it is named")
def test_an_electrometer_in_the_place_of_a_supply(played: Played, tmp_path: Path) -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = int(free.getsockname()[1])
    (tmp_path / "played.yml").write_text(ELECTROMETER.format(port=port), encoding="utf-8")
    played_at = tmp_path / "played.yml"
    child = subprocess.Popen([sys.executable, "-m", "sinstruments", "-c", str(played_at)], stderr=subprocess.DEVNULL)
    try:
        until(lambda: _answers(port, child))
        clock = RealClock()
        with closing(open_link(f"tcp://127.0.0.1:{port}", clock)) as link:
            with pytest.raises(InstrumentError) as caught:
                TtiSupply("x", link, clock, TtiSettings()).identify()
            assert caught.value.fault in ("silent", "wrong reply", "another instrument", "link lost")
            assert caught.value.remedy
    finally:
        child.kill()
        child.wait()


ISIS = os.environ.get("LABCAL_ISIS", "")
by_isis = pytest.mark.skipif(not ISIS, reason="LABCAL_ISIS names no clone of ISIS's emulators")


def at_isis(played: Played, device: str) -> str:
    stream = "stream: {bind_address: 127.0.0.1, port: {port}}"
    return f"tcp://127.0.0.1:{played('lewis', '-a', ISIS, '-k', 'lewis_emulators', device, '-p', stream)}"


@by_isis
def test_isis_tti_plp(played: Played) -> None:
    clock = RealClock()
    with closing(open_link(at_isis(played, "ttiplp"), clock)) as link:
        supply = TtiSupply("x", link, clock, TtiSettings(timeout_s=15.0))
        assert supply._scpi.identify(lambda maker, _: "THURLBY" in maker, "an Aim-TTi").model == "PL303-P"
        supply.write("I1 1.2500")  # no event register there: what is told is told without looking
        until(lambda: supply.set_point() == 1.25)
        assert supply.enabled == 0
        assert supply.measure_current() == pytest.approx(0.0, abs=2.0)


@by_isis
def test_isis_kepco(played: Played) -> None:
    clock = RealClock()
    with closing(open_link(at_isis(played, "kepco"), clock)) as link:
        supply = KepcoBop("x", link, clock, KepcoSettings(timeout_s=15.0))
        assert supply._scpi.identify(lambda maker, _: "KEPCO" in maker, "a Kepco").model.startswith("BOP")
        for amps in (-1.25, 0.5):
            supply.write(f"CURR {amps:.4f}")
            until(lambda wanted=amps: supply.set_point() == wanted)
        supply.write("FUNC:MODE CURR")
        until(lambda: supply.mode == 1)
