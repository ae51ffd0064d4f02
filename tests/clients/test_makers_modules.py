"""LabJack's and National Instruments' own modules under our link: their numbers, their names and arguments."""

from __future__ import annotations

import inspect
from contextlib import closing
from typing import Any

import LabJackPython
import nidaqmx
import nidaqmx.constants
import nidaqmx.system
import pytest
import u6
from nidaqmx.task.collections import AIChannelCollection

from drivers.daq_inputs import DaqInputs, Settings
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link

READINGS = 20
FACTS = {"FirmwareVersion": "1.45", "SerialNumber": 360018234, "DeviceName": "U6"}


@pytest.mark.met("daq-inputs", "LabJackPython", "20 readings: its volts of a U6's counts in our driver's nanotesla")
def test_a_u6_below_its_own_module(monkeypatch: pytest.MonkeyPatch) -> None:
    counts = [3_000_000 + 511_111 * k for k in range(3 * READINGS + 3)]  # of 24 bits, as the box sends them
    left = iter(counts)

    def feedback(self: Any, *asked: Any) -> list[dict[str, Any]]:
        assert [(one.positiveChannel in range(3), one.gainIndex, bool(one.differential)) for one in asked] == [
            (True, 0, False)
        ]
        return [{"AIN": next(left), "GainIndex": 0, "ResolutionIndex": 8, "Status": 0}]

    monkeypatch.setattr(LabJackPython, "staticLib", object())
    monkeypatch.setattr(u6.U6, "open", lambda self, **how: None)
    monkeypatch.setattr(u6.U6, "configU6", lambda self: FACTS)
    monkeypatch.setattr(u6.U6, "getFeedback", feedback)
    monkeypatch.setattr(u6.U6, "close", lambda self: None)
    theirs, clock = u6.U6(autoOpen=False), RealClock()
    with closing(open_link("daq://u6", clock)) as link:
        driver = DaqInputs("u6", link, clock, Settings(uT_per_V=(10.0, 10.0, 10.0), full_scale_V=99.0, rate=100.0))
        assert driver.identify().serial == "360018234"
        for k in range(1, READINGS + 1):
            driver.start()
            ((values,),) = (block.values.tolist() for block in driver.read_until(driver._polls._next_s))
            volts = [theirs.binaryToCalibratedAnalogVoltage(0, one) for one in counts[3 * k : 3 * k + 3]]
            assert values == pytest.approx([10_000.0 * volt for volt in volts], abs=0.01)


@pytest.mark.met("daq-inputs", "nidaqmx", "the names and arguments of what our link calls; nothing is measured by it")
def test_nidaqmx_has_what_is_called() -> None:
    inspect.signature(AIChannelCollection.add_ai_voltage_chan).bind(
        None, "Dev1/ai0", terminal_config=nidaqmx.constants.TerminalConfiguration.RSE, min_val=-10.0, max_val=10.0
    )
    inspect.signature(nidaqmx.Task.read).bind(None, number_of_samples_per_channel=4)
    inspect.signature(nidaqmx.system.Device).bind("Dev1")
    assert nidaqmx.constants.TerminalConfiguration.DIFF
    assert {"product_type", "serial_num"} <= set(dir(nidaqmx.system.Device))
