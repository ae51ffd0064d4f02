"""ea-psu-controller at the emulated EA PS 2000 B."""

from __future__ import annotations

from contextlib import closing

import pytest
from ea_psu_controller import PsuEA
from served_benches import Line
from waiting import settled, until


class OnAPty(PsuEA):
    """Found where it is told to be, not by the name of a device file."""

    def _PsuEA__find_devices(self, comport: str, sn: None, desi: None) -> None:
        self._port = comport.removeprefix("/dev/")


@pytest.mark.met("ea-ps2000b", "ea-psu-controller", "nominal values, protections, set-points, output, current, a trip")
def test_ea_ps_2000_b(line: Line) -> None:
    with closing(OnAPty(line.path)) as supply:
        assert "PS 2" in str(supply.get_device_description())
        assert supply.remote_on() == 0
        assert (supply.get_nominal_voltage(), supply.get_nominal_current()) == (42.0, 10.0)
        supply.set_voltage(20)
        supply.set_current(0.5)
        assert supply.output_on() == 0
        assert settled(supply.get_current, 0.5)
        status = supply.get_status()
        assert (status["remote on"], status["output on"], status["OCP activ"]) == (True, True, False)
        supply.set_ocp(0.3)
        until(lambda: supply.get_status()["OCP activ"])
        assert not supply.get_status()["output on"]
        supply.remote_off()
