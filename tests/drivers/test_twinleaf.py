"""Twinleaf: packets by hand, a stream described in any order, lost samples, what must not be said."""

from __future__ import annotations

import struct
import zlib
from typing import Any

import pytest

from drivers.framing import tio
from drivers.twinleaf import Twinleaf
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.errors import InstrumentError
from labcal.testing.drivers import installed

LATER = 10  # looks: what comes in the same one as the last answer is not waited for
ABOUT = (b"dev.desc", b"dev.serial", b"dev.firmware.serial")
TIMEBASE = bytes.fromhex("0000 00 01 0000000000000000 88130000 01000000 00000000 00000000") + bytes(16)  # 5000 µs
VECTOR = bytes.fromhex("0100 0000 01000000 00000000 00000000 0000 0300 42") + b"vector\tx,y,z\tField\tnT"
THERM = bytes.fromhex("0200 0000 01000000 00000000 00000000 0000 0100 42") + b"therm\t\tTemperature\tC"
STREAM = (bytes.fromhex("0000 0000 01000000 00000000 0000000000000000 0200 0000")
          + bytes.fromhex("0200 0000 01000000 00000000") + bytes.fromhex("0100 0000 01000000 00000000"))  # fmt: skip


def framed(kind: int, payload: bytes) -> bytes:
    """A packet by hand: head, payload, CRC-32, and the two bytes that SLIP writes otherwise."""
    whole = bytes([kind, 0, len(payload), 0]) + payload
    whole += struct.pack("<I", zlib.crc32(whole))
    return b"\xc0" + whole.replace(b"\xdb", b"\xdb\xdd").replace(b"\xc0", b"\xdb\xdc") + b"\xc0"


def asked(number: int, name: bytes) -> bytes:
    return framed(2, bytes([number, 0, len(name), 0x80]) + name)


def told(number: int, data: bytes) -> bytes:
    return framed(3, bytes([number, 0]) + data)


def sample(number: int, *values: float) -> bytes:
    """Temperature first, then the field."""
    return framed(128, struct.pack("<I4f", number, 21.5, *values))


def described(*after: bytes, order: tuple[int, ...] = (0, 1, 2, 3)) -> Exchange:
    parts = [framed(6, TIMEBASE), framed(7, VECTOR), framed(7, THERM), framed(8, STREAM)]
    return asked(1, b"data.send_all"), [*(parts[k] for k in order), told(1, b""), *[b""] * LATER, *after]


def taken(*after: bytes, **stated: Any) -> tuple[list[list[float]], list[float], dict[str, int]]:
    """Values, stamps and mishaps of what comes behind the description."""
    with scripted(Twinleaf, [described(*after), (framed(5, b""), None)], **stated) as driver:
        driver.start()
        blocks = driver.read_until(driver._clock.now() + 1.0)
        lost = {e.data["fault"]: e.data["lost"] for e in driver.events()}
    return [r for b in blocks for r in b.values.tolist()], [float(t) for b in blocks for t in b.t_s], lost


def test_who_it_is() -> None:
    said = (b"Twinleaf VMR R8 (A1B2)", b"A1B2", b"2.7.1")
    wire = [(asked(k, name), told(k, one)) for k, (name, one) in enumerate(zip(ABOUT, said, strict=True), 1)]
    with scripted(Twinleaf, wire) as driver:
        who = driver.identify()
    assert (who.manufacturer, who.model, who.serial, who.firmware) == (
        "Twinleaf",
        "Twinleaf VMR R8 (A1B2)",
        "A1B2",
        "2.7.1",
    )


def test_what_it_does_not_know_is_left_empty_and_another_maker_s_is_refused() -> None:
    wire = [(asked(1, b"dev.desc"), told(1, b"VMR")), *(
        (asked(k, name), framed(4, bytes([k, 0, 2, 0]))) for k, name in enumerate(ABOUT[1:], 2))]  # fmt: skip
    with scripted(Twinleaf, wire) as driver:
        assert driver.identify().serial == ""
    other = [(asked(1, b"dev.desc"), told(1, b"Acme 9"))]
    with scripted(Twinleaf, other) as driver, pytest.raises(InstrumentError, match="not a Twinleaf") as caught:
        driver.identify()
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize("order", [(0, 1, 2, 3), (3, 2, 1, 0), (2, 0, 3, 1)])
def test_a_row_is_read_as_it_is_described_in_whatever_order(order: tuple[int, ...]) -> None:
    wire = [described(sample(192, 20_000.5, -1.0, 219.0), order=order), (framed(5, b""), None)]
    with scripted(Twinleaf, wire) as driver:
        driver.start()
        (block,) = driver.read_until(driver._clock.now() + 1.0)
    assert block.values.tolist() == [[20_000.5, -1.0, 219.0]]


def test_samples_keep_the_device_s_spacing_and_a_missing_number_is_a_gap() -> None:
    values, stamps, lost = taken(sample(7, 1, 2, 3), sample(8, 1, 2, 3), sample(12, 4, 5, 6))
    assert values == [[1, 2, 3], [1, 2, 3], [4, 5, 6]]
    assert [round(t - stamps[0], 6) for t in stamps] == [0, 0.005, 0.025]
    assert lost == {"gap": 3}


def test_a_wrong_sum_a_short_row_and_no_number_are_noted_and_give_none() -> None:
    bad = bytearray(sample(7, 1, 2, 3))
    bad[14] ^= 1
    values, _, lost = taken(bytes(bad), framed(128, bytes(12)), sample(8, 1, float("nan"), 3), sample(8, 4, 5, 6))
    assert values == [[4, 5, 6]]
    assert lost == {"checksum": 1, "bad frame": 2}


def test_a_device_behind_a_hub_is_another() -> None:
    whole = bytes([128, 1, 20, 0]) + struct.pack("<I4f", 7, 0, 9, 9, 9) + b"\0"
    other = b"\xc0" + whole + struct.pack("<I", zlib.crc32(whole)) + b"\xc0"
    assert taken(other, sample(7, 1, 2, 3))[::2] == ([[1, 2, 3]], {})


def test_full_scale_is_a_fault_and_so_is_a_stream_that_it_has_not() -> None:
    with pytest.raises(InstrumentError) as caught:
        taken(sample(1, 100_001, 0, 0), full_scale_nT=100_000.0)
    assert caught.value.fault == "overloaded"
    with (
        scripted(Twinleaf, [described()], source="gmr") as driver,
        pytest.raises(InstrumentError, match="no stream 'gmr' of three numbers; it speaks of therm, vector"),
    ):
        driver.start()


def test_a_unit_that_it_does_not_say_must_be_stated() -> None:
    unsaid = framed(7, VECTOR.replace(b"nT", b""))
    wire = [(described()[0], [framed(6, TIMEBASE), unsaid, framed(7, THERM), framed(8, STREAM), told(1, b""),
             *[b""] * LATER, sample(1, 2, 3, 4)])] * 2  # fmt: skip
    with scripted(Twinleaf, [wire[0], (framed(5, b""), None)]) as driver:
        driver.start()
        with pytest.raises(InstrumentError, match="its unit is ''; state unit_nT"):
            driver.read_until(driver._clock.now() + 1.0)
    with scripted(Twinleaf, [wire[0], (framed(5, b""), None)], unit_nT=1000.0) as driver:
        driver.start()
        assert driver.read_until(driver._clock.now() + 1.0)[0].values.tolist() == [[2000, 3000, 4000]]


def test_it_is_told_nothing_but_these_questions() -> None:
    rig = installed("twinleaf", forbidden=[]).rig()
    for name in (b"data.send_all", *ABOUT):
        for number in (1, 100):
            rig.line.send(tio.request(number, name))
    for order in (tio.request(1, b"data.rate", b"\0\0\0\x40"), tio.request(1, b"dev.stop"), tio.packet(9)):
        with pytest.raises(InstrumentError, match="never sent"):
            rig.line.send(order)
