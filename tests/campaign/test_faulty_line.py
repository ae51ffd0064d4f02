"""The campaign's own lines: each does to the bytes what it says, and is overheard as they were sent."""

from __future__ import annotations

import sys
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("needs ptys, which Windows lacks", allow_module_level=True)

from faulty_line import DEAF, MUTE, WELL, FaultyLine, Trouble
from faulty_supply import Front, panel

from drivers.emulators.kepco_bop import KepcoEmulator
from drivers.emulators.korad_ka3005p import KoradEmulator
from drivers.emulators.riden_rd60xx import RidenEmulator
from drivers.emulators.tti_pl import TtiEmulator
from labcal.twin.coils import Coil

REQUEST, REPLY = b"I1 1.5\n", b"yes\r\n"


class End:
    """A host that sends one request and keeps what comes."""

    def __init__(self) -> None:
        self.to_send, self.got = [REQUEST], list[bytes]()

    def read(self) -> bytes:
        return self.to_send.pop() if self.to_send else b""

    def write(self, data: bytes) -> None:
        self.got.append(data)


class Ear:
    """An instrument that answers whatever it hears at once."""

    def __init__(self) -> None:
        self.heard, self._said = list[tuple[float, bytes]](), list[tuple[float, bytes]]()

    def take(self, t_s: float, data: bytes) -> None:
        self.heard.append((t_s, data))
        self._said.append((t_s, REPLY))

    def emit(self, until_s: float) -> list[tuple[float, bytes]]:
        said, self._said = self._said, []
        return said


def carried(trouble: Trouble, *at_s: float) -> tuple[FaultyLine, End, Ear, Ear]:
    end, hears, overhears = End(), Ear(), Ear()
    line = FaultyLine("supply_x", end, hears, overhears, trouble)
    for t_s in (0.0, *at_s):
        line.carry(t_s)
    return line, end, hears, overhears


@pytest.mark.parametrize(
    ("trouble", "heard", "got"),
    [
        (WELL, [(0.0, REQUEST)], REPLY),
        (DEAF, [], b""),
        (MUTE, [(0.0, REQUEST)], b""),
        (replace(WELL, doubled_requests=True), [(0.0, REQUEST)] * 2, REPLY * 2),
        (replace(WELL, doubled_replies=True), [(0.0, REQUEST)], REPLY * 2),
        (replace(WELL, request_late_s=1.5), [(1.6, REQUEST)], REPLY),
        (replace(WELL, reply_late_s=1.5), [(0.0, REQUEST)], REPLY),
        (replace(WELL, request_late_s=9.0), [], b""),
        (replace(WELL, reply_late_s=9.0), [(0.0, REQUEST)], b""),
    ],
)
def test_bytes_are_mistreated_as_told_and_overheard_as_sent(trouble: Trouble, heard: Any, got: bytes) -> None:
    _, end, hears, overhears = carried(trouble, 1.0, 1.6)
    assert hears.heard == heard
    assert b"".join(end.got) == got
    assert overhears.heard == [(0.0, REQUEST)]


def test_corrupt_bytes_are_as_many_and_others() -> None:
    _, end, hears, _ = carried(Trouble(corrupt_requests=1.0, corrupt_replies=1.0))
    ((_, request),) = hears.heard
    assert (len(request), len(end.got[0])) == (len(REQUEST), len(REPLY))
    assert request != REQUEST
    assert end.got[0] != REPLY


def test_what_was_on_its_way_when_the_cable_came_out_is_lost() -> None:
    end, hears = End(), Ear()
    end.unplug = lambda: None  # type: ignore[attr-defined]
    line = FaultyLine("supply_x", end, hears, Ear(), Trouble(request_late_s=1.0))
    line.carry(0.0)
    line.unplug()
    line.carry(5.0)
    assert hears.heard == []


class Lab:
    """Three coils and nothing else."""

    def __init__(self) -> None:
        self.coils = {axis: Front(Coil(6.0, 0.02)) for axis in "xyz"}


@pytest.mark.parametrize("kind", [TtiEmulator, KoradEmulator, KepcoEmulator, RidenEmulator])
def test_every_supply_of_the_campaign_trips_reboots_and_lies(kind: Any) -> None:
    lab, settings = Lab(), SimpleNamespace(address=1, terminator="")
    front = lab.coils["x"]
    device = kind(lab, {"coil-x": {"address": 1}}, settings)
    panel(device, front, 1.0, 0.8, True)
    assert front.coil.current.now(2.0) == pytest.approx(0.8, abs=1e-3)
    assert front.orders[-1] == (1.0, 0.8)
    front.lie(measures_truly=False)
    panel(device, front, 3.0, 0.0, False)
    assert front.current.now(4.0) == pytest.approx(0.0, abs=1e-3)
    assert front.coil.current.now(4.0) == pytest.approx(0.8, abs=1e-3)
    front.repent(5.0)
    assert front.coil.current.now(6.0) == pytest.approx(0.0, abs=1e-3)
