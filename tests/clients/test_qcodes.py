"""QCoDeS' own drivers, through pyvisa-py, at the emulated supplies on the network."""

from __future__ import annotations

from contextlib import closing

import pytest
from qcodes.instrument_drivers.AimTTi import AimTTiPL303QMTP
from qcodes.instrument_drivers.rigol import RigolDP832
from served_benches import Line
from waiting import settled

BY = "QCoDeS"
PATIENT_S = 30


@pytest.mark.met("rigol-dp800", BY, "identity, options, selection, set-points, output, mode, current")
def test_rigol(line: Line) -> None:
    with closing(RigolDP832("rigol", line.visa, visalib="@py", timeout=PATIENT_S, terminator="\n")) as supply:
        assert supply.get_idn()["model"] == "DP832"
        channel = supply.ch1
        supply.write("*RST;*CLS")
        channel.set_voltage(10)
        channel.set_current(0.5)
        assert (channel.set_voltage(), channel.set_current()) == (10, 0.5)
        channel.state("on")
        assert settled(channel.current, 0.5)
        assert 0 < channel.voltage() < 10
        assert channel.mode() == "ConstantCurrent"
        channel.state("off")
        assert channel.state().lower() == "off"
        assert supply.ask(":SYST:ERR?") == '0,"No error"'


@pytest.mark.met("tti-pl", BY, "identity, set-points, steps up and down, interface lock, output")
def test_aim_tti(line: Line) -> None:
    with closing(AimTTiPL303QMTP("tti", line.visa, visalib="@py", timeout=PATIENT_S, terminator="\r\n")) as supply:
        assert "PL303QMT" in supply.get_idn()["model"]
        channel = supply.ch1
        channel.output(False)
        channel.volt(12)
        channel.curr(0.3)
        assert (channel.volt(), channel.curr()) == (12, 0.3)
        channel.curr_step_size(0.1)
        channel.increment_curr_by_step_size()
        assert channel.curr() == 0.4
        channel.output(True)
        assert channel.output()
        channel.output(False)
        assert not channel.output()
