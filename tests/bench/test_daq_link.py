"""daq:// against its makers' own faces: what is called, what a box that is pulled or lacks its driver becomes."""

from __future__ import annotations

import sys
from collections.abc import Callable
from contextlib import closing
from enum import Enum
from types import ModuleType, SimpleNamespace
from typing import Any, ClassVar

import pytest

from drivers.daq_inputs import DaqInputs, Settings
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
from labcal.errors import InputError, InstrumentError

VOLTS = {0: 2.0, 1: -0.5, 2: 0.25, 4: 1.5}
SCALE: dict[str, Any] = {"uT_per_V": (10.0, 10.0, 10.0)}


class FakeU6:
    """u6.U6 of LabJackPython, as far as a reader goes: its calls, its names of arguments, its dictionary."""

    lost = False
    calls: ClassVar[list[Any]] = []

    def __init__(self, debug: bool = False, autoOpen: bool = True, **kargs: Any) -> None:
        assert not autoOpen

    def open(self, localId=None, firstFound=True, serial=None, devNumber=None) -> None:
        self.calls.append(("open", firstFound, serial))

    def configU6(self, LocalID: None = None) -> dict[str, Any]:
        return {"FirmwareVersion": "1.45", "SerialNumber": 360018234, "LocalID": 1, "DeviceName": "U6-Pro"}

    def getAIN(self, positiveChannel, resolutionIndex=0, gainIndex=0, settlingFactor=0, differential=False) -> float:
        if self.lost:
            raise RuntimeError("LJUSB_Stream: No such device")
        self.calls.append((positiveChannel, gainIndex, differential))
        return VOLTS[positiveChannel]

    def close(self) -> None:
        self.calls.append("close")


class TerminalConfiguration(Enum):
    """Of nidaqmx.constants."""

    RSE, DIFF = 10083, 10106


class FakeTask:
    """nidaqmx.Task with voltage channels, read on demand."""

    made: ClassVar[list[FakeTask]] = []

    def __init__(self, new_task_name: str = "") -> None:
        self.channels, self.closed, self.ai_channels = list[Any](), False, self
        self.made.append(self)

    def add_ai_voltage_chan(self, physical_channel: str, name_to_assign_to_channel: str = "", terminal_config: Any = -1,
                            min_val: float = -5.0, max_val: float = 5.0) -> None:  # fmt: skip
        self.channels.append((physical_channel, terminal_config.name, min_val, max_val))

    def read(self, number_of_samples_per_channel: int, timeout: float = 10.0) -> list[list[float]]:
        return [[VOLTS[int(name[-1])]] * number_of_samples_per_channel for name, *_ in self.channels]

    def close(self) -> None:
        self.closed = True


def played(name: str, **holds: Any) -> ModuleType:
    """A module of this name that holds these."""
    module = ModuleType(name)
    vars(module).update(holds)
    return module


def device(name: str) -> SimpleNamespace:
    """nidaqmx.system.Device."""
    return SimpleNamespace(product_type="USB-6218", serial_num=0x1A2B3C4)


@pytest.fixture
def boxes(monkeypatch: pytest.MonkeyPatch) -> None:
    """Both makers' modules, played."""
    monkeypatch.setattr(FakeU6, "calls", [])
    monkeypatch.setattr(FakeTask, "made", [])
    for module in (
        played("u6", U6=FakeU6),
        played("LabJackPython", staticLib=object()),
        played("nidaqmx", Task=FakeTask),
        played("nidaqmx.system", Device=device),
        played("nidaqmx.constants", TerminalConfiguration=TerminalConfiguration),
    ):
        monkeypatch.setitem(sys.modules, module.__name__, module)


def on(url: str, then: Callable[[DaqInputs], None], **stated: Any) -> None:
    """The driver on such a link."""
    clock = RealClock()
    with closing(open_link(url, clock)) as link:
        link.never.add(DaqInputs.never)
        then(DaqInputs("fluxgate", link, clock, Settings(**SCALE, **stated)))


def reading(driver: DaqInputs) -> list[float]:
    driver.start()
    found: list[float] = driver.read_until(driver._polls._next_s)[0].values[0].tolist()
    return found


def test_a_u6_is_identified_and_read_with_its_range_and_wiring(boxes: None) -> None:
    def look(driver: DaqInputs) -> None:
        who = driver.identify()
        assert (who.manufacturer, who.model, who.serial, who.firmware) == (
            "LabJack", "U6-Pro", "360018234 MAG-03 7", "1.45")  # fmt: skip
        assert reading(driver) == [20_000.0, 2_500.0, 15_000.0]

    on("daq://u6/360018234", look, inputs=(0, 2, 4), differential=True, range_V=1.0, average=2, serial="MAG-03 7",
       full_scale_V=5.0)  # fmt: skip
    assert FakeU6.calls[0] == ("open", False, 360018234)
    assert FakeU6.calls[1:] == [(0, 1, True), (2, 1, True), (4, 1, True)] * 4 + ["close"]


def test_a_range_that_it_has_not_is_refused_in_words(boxes: None) -> None:
    def look(driver: DaqInputs) -> None:
        with pytest.raises(InstrumentError, match="it cannot: a U6 has the ranges 10, 1") as caught:
            driver.identify()
        assert caught.value.fault == "refused"

    on("daq://u6", look, range_V=5.0)


def test_a_u6_that_is_pulled_is_a_lost_link(boxes: None, monkeypatch: pytest.MonkeyPatch) -> None:
    def look(driver: DaqInputs) -> None:
        driver.identify()
        monkeypatch.setattr(FakeU6, "lost", True)
        with pytest.raises(InstrumentError, match="No such device") as caught:
            reading(driver)
        assert caught.value.fault == "link lost"

    on("daq://u6", look)


def test_a_device_of_ni_has_one_task_of_its_three_inputs(boxes: None) -> None:
    def look(driver: DaqInputs) -> None:
        assert driver.identify().serial == "1A2B3C4"
        assert reading(driver) == [20_000.0, -5_000.0, 2_500.0]

    on("daq://ni/Dev1", look, average=5, range_V=5.0)
    (task,) = FakeTask.made
    assert task.channels == [(f"Dev1/ai{n}", "RSE", -5.0, 5.0) for n in range(3)]
    assert task.closed


@pytest.mark.parametrize("url", ["daq://u6/abc", "daq://ni", "daq://u3", "daq://"])
def test_a_link_that_names_no_box_is_refused(url: str) -> None:
    with pytest.raises(InputError, match="expected daq://u6, daq://u6/SERIAL or daq://ni/NAME"):
        open_link(url, RealClock())


@pytest.mark.parametrize(("url", "package"), [("daq://u6", "LabJackPython"), ("daq://ni/Dev1", "nidaqmx")])
def test_without_its_module_the_extra_is_named(url: str, package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("u6", "nidaqmx"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(InputError, match=rf"needs {package} here; install it: pip install 'labcal\[daq\]'"):
        open_link(url, RealClock())


def test_a_u6_without_its_driver_is_said_and_nothing_is_printed(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for module in (played("u6"), played("LabJackPython", staticLib=None)):
        monkeypatch.setitem(sys.modules, module.__name__, module)
    with pytest.raises(InputError, match="the Exodriver"):
        open_link("daq://u6", RealClock())
    assert capsys.readouterr().out == ""
