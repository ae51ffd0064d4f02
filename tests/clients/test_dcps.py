"""dcps at the emulated Rigol, Korad and Aim-TTi, over sockets and a serial line."""

from __future__ import annotations

import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from dcps.AimTTiPLP import AimTTiPLP
from dcps.KoradKAseries import KAseries
from dcps.RigolDP800 import RigolDP800
from served_benches import Line
from waiting import settled

BY = "dcps"
AT_ONCE_S, KORAD_S = 0.0, 0.2
PATIENT_MS = 30_000


@contextmanager
def opened(supply: Any) -> Iterator[Any]:
    """The supply on its line, which is let go at the end."""
    supply.open()
    try:
        yield supply
    finally:
        supply.close()


def drives(supply: Any) -> None:
    """Set-points and their read-back, output on and off, what flows."""
    supply.setVoltage(20.0)
    supply.setCurrent(0.5)
    assert (supply.queryVoltage(), supply.queryCurrent()) == (20.0, 0.5)
    supply.outputOn()
    assert supply.isOutputOn()
    assert settled(supply.measureCurrent, 0.5)
    assert 0 < supply.measureVoltage() < 20
    supply.outputOff()
    assert not supply.isOutputOn()
    assert settled(supply.measureCurrent, 0.0)


@pytest.mark.met("rigol-dp800", BY, "identity, set-points, output, current and voltage, local")
def test_rigol(line: Line) -> None:
    how: dict[str, Any] = {"read_termination": "\n", "write_termination": "\n", "timeout": PATIENT_MS}
    with opened(RigolDP800(line.visa, wait=AT_ONCE_S, **how)) as supply:
        assert "DP832" in supply.idn()
        drives(supply)
        supply.setLocal()


@pytest.mark.met("tti-pl", BY, "identity, set-points, output, current and voltage, local")
def test_aim_tti(line: Line) -> None:
    with opened(AimTTiPLP(line.visa, wait=AT_ONCE_S, timeout=PATIENT_MS)) as supply:
        assert "THANDAR" in supply.idn()
        drives(supply)
        supply.setLocal()


@pytest.mark.met("korad-ka3005p", BY, "set-points, status byte, output, current; a fifth of a second apart")
def test_korad(line: Line) -> None:
    with opened(KAseries(line.visa, wait=0.0, baud_rate=line.baud, timeout=PATIENT_MS)) as supply:

        def paced(name: str, *values: float) -> Any:
            time.sleep(KORAD_S)
            return getattr(supply, name)(*values)

        paced("setVoltage", 20.0)
        paced("setCurrent", 0.5)
        assert (paced("queryVoltage"), paced("queryCurrent")) == (20.0, 0.5)
        paced("outputOn")
        assert paced("isOutputOn")
        assert settled(lambda: float(paced("measureCurrent")), 0.5)
        paced("outputOff")
        assert not paced("isOutputOn")
