"""Frames and checksums against values worked out by hand, there and back, and against any bytes."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from listening import cut

from drivers.framing import ccsds, cobs, nmea, slip
from drivers.framing.columns import number
from drivers.framing.crc16 import crc16
from labcal.bench.driver_kit.framing import Lines


def test_crc_and_checksum_of_the_sheet() -> None:
    assert crc16(b"123456789") == 0x29B1
    assert crc16(b"123456789\x29\xb1") == 0
    assert nmea.checksum(b"PMAG,1234.500,21034.1,-1890.0,43210.7,23.4") == 0x06


@pytest.mark.parametrize(
    ("plain", "coded"),
    [
        ("11 22 00 33", "03 11 22 02 33 00"),
        ("00", "01 01 00"),
        ("", "01 00"),
        ("01 " * 254, "FF " + "01 " * 254 + "00"),
        ("01 " * 255, "FF " + "01 " * 254 + "02 01 00"),
        ("01 " * 254 + "00", "FF " + "01 " * 254 + "01 01 00"),
    ],
)
def test_cobs_by_hand(plain: str, coded: str) -> None:
    assert cobs.encode(bytes.fromhex(plain)) == bytes.fromhex(coded)
    assert cobs.decode(bytes.fromhex(coded)[:-1]) == bytes.fromhex(plain)


def test_slip_by_hand() -> None:
    assert slip.encode(bytes.fromhex("01 C0 DB 02")) == bytes.fromhex("C0 01 DB DC DB DD 02 C0")
    assert slip.decode(bytes.fromhex("DB DD DC")) == bytes.fromhex("DB DC")
    assert slip.decode(b"\xdb") is slip.decode(b"\xdb\xdb\xdc") is None


@given(st.binary(max_size=800))
def test_there_and_back(packet: bytes) -> None:
    assert cobs.decode(cobs.encode(packet)[:-1]) == packet
    assert 0 not in cobs.encode(packet)[:-1]
    assert slip.decode(slip.encode(packet)[1:-1]) == packet


@given(st.binary(max_size=300), st.lists(st.integers(1, 40), min_size=1, max_size=5), st.sampled_from([b"\n", b"\r\n"]))
def test_lines_do_not_depend_on_the_cutting(data: bytes, sizes: list[int], end: bytes) -> None:
    whole, pieces = Lines(end, longest=20), Lines(end, longest=20)
    assert [x for _, x in whole.feed([(0.0, data)])] == [x for _, x in pieces.feed(cut(data, sizes))]
    assert whole.too_long == pieces.too_long


def test_a_line_too_long_takes_no_other_line_with_it() -> None:
    lines = Lines(longest=5)
    assert [x for _, x in lines.feed([(0, b"good\n123"), (1, b"456789"), (2, b"0\nnext\n")])] == [b"good", b"next"]
    assert lines.too_long == 1


@pytest.mark.parametrize("text", ["1_000", "0x10", "inf", "1,5", "--1", "1e", "١", "1 2", "1.2.3", "+", "."])
def test_what_is_no_plain_number_is_none(text: str) -> None:
    assert number(text) is None


def test_a_decimal_comma_only_where_it_is_stated() -> None:
    assert number("-1,5", ",") == -1.5
    assert number("1.5", ",") is None


@given(st.integers(0, 16383), st.integers(0, 5000))
def test_the_count_finds_every_gap_round_the_circle(start: int, missing: int) -> None:
    counter = ccsds.Counter()
    counter.step(start)
    assert counter.step((start + 1 + missing) % 16384) == (("gap", missing) if missing else ("next", 0))


@given(st.binary(max_size=100))
def test_no_bytes_crash_a_parser(data: bytes) -> None:
    for parse in (cobs.decode, slip.decode, nmea.fields, ccsds.parse):
        parse(data)
