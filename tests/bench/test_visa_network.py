"""visa:// over the network by pyvisa-py itself: a supply behind HiSLIP and behind VXI-11, and one that goes."""

from __future__ import annotations

import gc
import time
import warnings
from contextlib import closing
from typing import Any

import pytest
from visa_servers import Device, Hislip, Server, Vxi11

from drivers.emulators.scpi_table import TableEmulator
from drivers.scpi_table import Settings, TableSupply
from labcal.bench.clock import RealClock
from labcal.bench.find.questions import asked
from labcal.bench.links import open_link
from labcal.errors import InputError, InstrumentError
from labcal.twin import open_twin

pytest.importorskip("pyvisa_py")
STATED = Settings(model="agilent-66xx", timeout_s=30.0)
KINDS = {Hislip: "visa://TCPIP0::127.0.0.1::hislip0,{}::INSTR", Vxi11: "visa://TCPIP0::127.0.0.1,{}::inst0::INSTR"}


@pytest.fixture(params=KINDS)
def server(request: pytest.FixtureRequest) -> Any:
    served = request.param(Device(TableEmulator(open_twin({}, 1), {"coil-x": {}}, STATED)))
    yield served
    served.close()


def link_of(server: Server) -> str:
    return KINDS[type(server)].format(server.port)


def test_a_supply_on_the_network_is_found_and_driven(server: Server) -> None:
    clock, link = RealClock(), link_of(server)
    (found,) = asked(link, clock, TableSupply.recognise)
    assert (found.driver, found.settings) == ("scpi-table", 'model = "agilent-66xx"')
    with closing(open_link(link, clock)) as line:
        supply = TableSupply("x", line, clock, STATED)
        assert supply.identify().model == "6632B"
        supply.output(True)
        supply.set_current(0.5)
        begun = time.monotonic()
        while abs(supply.measure_current() - 0.5) > 0.005:
            assert time.monotonic() < begun + 30.0
        supply.make_safe()
        assert supply.set_point() == 0.0


def test_a_supply_that_goes_is_told_as_lost_or_silent(server: Server) -> None:
    clock = RealClock()
    with closing(open_link(link_of(server), clock)) as line:
        supply = TableSupply("x", line, clock, Settings(model="agilent-66xx", timeout_s=0.5))
        supply.identify()
        server.close()
        with pytest.raises(InstrumentError) as caught:
            supply.measure_current()
        assert caught.value.fault in ("link lost", "silent")


def test_a_name_that_the_instrument_has_not_is_refused_in_words(server: Server) -> None:
    other = link_of(server).replace("hislip0", "hislip1").replace("inst0", "inst1")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # pyvisa-py leaves its socket to the collector
        with pytest.raises((InputError, InstrumentError)):
            open_link(other, RealClock())
        gc.collect()
