"""CAN frames by a DBC: bytes by hand, python-can's virtual bus, what a DBC lacks, frames that are no good."""

from __future__ import annotations

import sys
from contextlib import closing
from pathlib import Path
from typing import Any

import can
import numpy as np
import pytest
from listening import heard, listening

from drivers.can_dbc import CanDbc, Settings
from drivers.framing.dbc import database
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
from labcal.bench.links.canbus import EXTENDED, HEAD
from labcal.errors import InputError, InstrumentError

DBC = str(Path(__file__).parent / "magnetometer.dbc")
XYZ = {"x": "Field.Bx", "y": "Field.By", "z": "Field.Bz"}
STATED: dict[str, Any] = {"file": DBC, "signals": XYZ | {"temp_dut": "Housekeeping.Temperature"}}
HOUSEKEEPING = 2566844672 & 0x1FFFFFFF


def packed(x: int, y: int, z: int, count: int = 0) -> bytes:
    """The 8 bytes of Field, each number of 4 nT in 18 bits from the lowest on (little endian)."""
    bits = sum((n & 0x3FFFF) << 18 * k for k, n in enumerate((x, y, z))) | count << 54
    return bits.to_bytes(8, "little")


def field(x: int, y: int, z: int, count: int = 0) -> bytes:
    return HEAD.pack(256, 8) + packed(x, y, z, count)


def test_a_reading_and_housekeeping_bit_by_bit() -> None:
    temperature = HEAD.pack(HOUSEKEEPING | EXTENDED, 6) + (-1234).to_bytes(2, "big", signed=True) + b"\0\0\1\0"
    blocks, lost = heard(CanDbc, [(1.0, field(100, -200, 131_071)), (1.2, temperature)], **STATED)
    reading, channel = blocks
    np.testing.assert_array_equal(reading.values, [[400.0, -800.0, 524_284.0]])
    assert (reading.stream, reading.t_s.tolist(), reading.raw) == ("dut", [1.0], field(100, -200, 131_071))
    assert (channel.columns, channel.values.tolist()) == (("temp_dut",), [[-12.34]])
    assert lost == {}


def test_a_standard_frame_is_not_the_extended_one_of_the_same_number() -> None:
    pieces = [(0.0, HEAD.pack(256 | EXTENDED, 8) + packed(1, 2, 3)), (0.1, field(1, 2, 3))]
    blocks, lost = heard(CanDbc, pieces, **STATED)
    assert len(blocks[0]) == 1
    assert lost == {}


def test_gaps_and_repeats_of_its_counter() -> None:
    counts = [14, 15, 0, 1, 1, 4]
    pieces = [(0.1 * k, field(c, 0, 0, c)) for k, c in enumerate(counts)]
    blocks, lost = heard(CanDbc, pieces, file=DBC, signals=XYZ | {"count": "Field.Counter"})
    assert blocks[0].values[:, 0].tolist() == [56, 60, 0, 4, 16]
    assert lost == {"gap": 2, "late": 1}


@pytest.mark.parametrize("data", [b"\1\2\3", b""])
def test_a_cut_frame_gives_no_value(data: bytes) -> None:
    blocks, lost = heard(CanDbc, [(0.0, HEAD.pack(256, len(data)) + data), (0.1, field(1, 2, 3))], **STATED)
    assert len(blocks[0]) == 1
    assert lost == {"bad frame": 1}


def test_readings_come_over_a_bus() -> None:
    clock = RealClock()
    with (
        closing(open_link("can://virtual/labcal", clock)) as link,
        can.Bus(interface="virtual", channel="labcal") as bus,
    ):
        driver = CanDbc("dut", link, clock, Settings(**STATED))
        bus.send(can.Message(arbitration_id=256, data=packed(5, 6, 7), is_extended_id=False))
        assert driver.identify().model == "CAN Field"
        driver.start()
        for k in range(30):
            bus.send(can.Message(arbitration_id=256, data=packed(k, -k, 0), is_extended_id=False))
            bus.send(can.Message(arbitration_id=256, is_remote_frame=True, is_extended_id=False))
            bus.send(can.Message(arbitration_id=0x7FF, data=b"\1", is_extended_id=False))
        (block,) = driver.read_until(clock.now() + 0.05)
        np.testing.assert_array_equal(block.values[:, 0], 4 * np.arange(30.0))
        with pytest.raises(InstrumentError):
            link.send(b"x")


@pytest.mark.parametrize(
    ("stated", "says"),
    [
        ({"signals": XYZ | {"z": "Field.Bw"}}, "has no signal 'Field.Bw'"),
        ({"signals": XYZ | {"z": "Housekeeping.Current"}}, "must be signals of one message"),
        ({"signals": XYZ | {"i_x": "Housekeeping.Other"}}, "is multiplexed"),
        ({"signals": XYZ, "unit": "uT"}, "says that x is in nT, and unit = 'uT'"),
        ({"signals": XYZ, "file": "absent.dbc"}, "cannot be read"),
        ({"signals": XYZ, "file": __file__}, "is no CAN database"),
    ],
)
def test_what_the_dbc_does_not_have_is_said(stated: dict[str, Any], says: str) -> None:
    with pytest.raises(InputError, match=says):
        heard(CanDbc, [], **({"file": DBC} | stated))


@pytest.mark.parametrize(
    "stated",
    [
        {},
        {"file": DBC, "signals": {"x": "Field.Bx"}},
        {**STATED, "stamp": "device"},
        {"file": DBC, "signals": XYZ | {"q": "Field.Bx"}},
    ],
)
def test_settings_that_make_no_sense_are_refused(stated: dict[str, Any]) -> None:
    with pytest.raises(ValueError, match=r"signals|quantities"):
        Settings(**stated)


def test_without_the_libraries_the_refusal_says_how_to_install_them(monkeypatch: pytest.MonkeyPatch) -> None:
    database.cache_clear()
    monkeypatch.setitem(sys.modules, "cantools", None)
    monkeypatch.setitem(sys.modules, "can", None)
    with pytest.raises(InputError, match=r"pip install 'labcal\[can\]'"):
        listening(CanDbc, [], **STATED)
    with pytest.raises(InputError, match=r"pip install 'labcal\[can\]'"):
        open_link("can://virtual/labcal", RealClock())


@pytest.mark.parametrize("url", ["can://virtual", "can://nothing/x", "can://virtual/x?bitrate=fast"])
def test_a_bus_that_is_none_is_refused(url: str) -> None:
    with pytest.raises(InputError, match="can://"):
        open_link(url, RealClock())
