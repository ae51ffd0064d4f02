"""Every driver at every other instrument's emulator: it takes none for its own, in time, and nothing flows or turns."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Any

import pytest
from stated import DRIVERS, SETTINGS

from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.bench.links.modbus import ModbusLink
from labcal.errors import InstrumentError
from labcal.testing.drivers import installed
from labcal.twin import open_twin

NO_LINE = {"manual", "replay"}
NAMES = sorted(set(DRIVERS) - NO_LINE)
ALIKE = {  # a driver, another's emulator, and why that is no mistake
    ("text-line", "rm3100"): "its counts are three numbers with commas, as a text line is stated to be",
    ("waveshare-interlock", "waveshare-relay"): "one board",
    ("waveshare-relay", "waveshare-interlock"): "one board",
}
LONG_S = 40.0  # of the simulated lab; a person waits for it


class Swapped:
    """A driver whose line leads to another's instrument."""

    def __init__(self, name: str, other: str) -> None:
        case, there = (installed(each, forbidden=(), settings=SETTINGS.get(each, {})) for each in (name, other))
        settings, its = case.types["settings"](**case.settings), there.types["settings"](**there.settings)
        self.lab, self.clock = open_twin({}, 1), VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
        role = there.driver.roles[0]
        emulator = there.emulator(self.lab, {"coil-x" if role == "coil" else role: {}}, its)
        line = EmulatedLink("emulated://swapped", emulator, self.clock)
        line.never.add(case.driver.never, settings.address if case.modbus else None)
        link: Any = ModbusLink(line, self.clock) if case.modbus else line
        self.driver = case.driver("swapped", link, self.clock, settings)

    @property
    def rests(self) -> bool:
        """Whether no current flows and the platform stands where it stood."""
        now = self.clock.now()
        currents = (float(coil.current.now(now)) for coil in self.lab.coils.values())
        return not any(currents) and float(self.lab.platform.now(now)[0]) == 0.0


def refusal(driver: Any) -> InstrumentError | None:
    try:
        driver.identify()
    except InstrumentError as fault:
        return fault
    return None


@pytest.mark.parametrize(
    "name", [pytest.param(one, marks=pytest.mark.slow if n % 3 else ()) for n, one in enumerate(NAMES)]
)
def test_another_s_instrument_is_not_taken_for_its_own(name: str) -> None:
    for other in NAMES:
        if other == name or (name, other) in ALIKE:
            continue
        swapped = Swapped(name, other)
        fault = refusal(swapped.driver)
        assert fault is not None, f"{name} takes a {other} for its own"
        assert (bool(fault.fault), bool(fault.remedy)) == (True, True), other
        assert swapped.rests, other
        assert swapped.clock.now() < LONG_S, other
