"""tenma-serial at the emulated Korad, which Tenma sells as 72-2540."""

from __future__ import annotations

from contextlib import closing

import pytest
from served_benches import Line
from tenma.tenmaDcLib import Tenma72_2540, TenmaException
from waiting import settled

BY = "tenma-serial"


@pytest.mark.met("korad-ka3005p", BY, "name, set-points and read-back, output, status, current and voltage")
def test_tenma(line: Line) -> None:
    with closing(Tenma72_2540(line.path)) as supply:
        assert "KA3005P" in supply.getVersion()
        assert supply.setVoltage(1, 20_000) == 20.0
        assert supply.setCurrent(1, 500) == 0.5
        supply.ON()
        assert supply.getStatus()["outEnabled"]
        assert settled(lambda: supply.runningCurrent(1), 0.5)
        assert 0 < supply.runningVoltage(1) < 20
        with pytest.raises(TenmaException):
            supply.setCurrent(1, 9_000)
        supply.OFF()
        assert not supply.getStatus()["outEnabled"]
