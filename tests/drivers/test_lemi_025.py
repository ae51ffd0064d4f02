"""LEMI-025: records byte by byte, BCD time, GPS lost, missing seconds, cut records, noise."""

from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from listening import cut, heard, listening

from drivers.framing import lemi
from drivers.lemi_025 import Lemi025
from labcal.errors import InstrumentError

BEGAN = 1767225600.0  # 2026-01-01 00:00:00 UTC
FIELD = np.arange(30.0).reshape(10, 3) - 15


def record(second: int, gps: bool = True, field: np.ndarray = FIELD) -> bytes:
    return lemi.build(b"L025", BEGAN + second, gps, field)


def test_a_record_by_hand() -> None:
    by_hand = b"L025\x01" + bytes.fromhex("26 12 31 23 59 58") + struct.pack("<8h", 2150, -480, 0, 0, 0, 400, 0, 0)
    by_hand += b"\x00" + struct.pack("<30f", *range(30)) + bytes([0, 0, 121]) + b"A" + b"\x00"
    assert len(by_hand) == 153
    read = lemi.parse(by_hand, 100.0)
    assert read is not None
    assert (read.second_s, read.gps) == (1798761598, True)
    assert (read.sensor_C, read.electronics_C, read.supply_V) == (21.5, -4.8, 12.1)
    np.testing.assert_array_equal(read.xyz_uT[1], [3, 4, 5])


def test_ten_samples_a_second_in_nanotesla_at_gps_seconds() -> None:
    blocks, lost = heard(Lemi025, [(5.0, record(0)[:50]), (5.1, record(0)[50:]), (6.25, record(1))])
    np.testing.assert_array_equal(blocks[0].values, FIELD * 1000)
    np.testing.assert_allclose(blocks[0].t_s, 5.0 - 1.0 - 0.3 + np.arange(10) / 10)
    np.testing.assert_allclose(blocks[1].t_s, blocks[0].t_s + 1)  # not the 0.25 s by which it came late
    assert lost == {}


def test_without_gps_the_time_of_arrival_counts() -> None:
    blocks, _ = heard(Lemi025, [(5.0, record(0, gps=False)), (6.25, record(1, gps=False))])
    assert blocks[1].t_s[0] - blocks[0].t_s[0] == pytest.approx(1.25)


def test_missing_seconds_are_a_gap() -> None:
    assert heard(Lemi025, [(1.0, record(0)), (4.0, record(3))])[1] == {"gap": 20}


@pytest.mark.parametrize(
    "bad",
    [
        record(1)[:100],  # bytes lost, the next record follows at once
        record(1)[:-1],
        record(1)[:5] + b"\xfa" + record(1)[6:],  # no BCD
        record(1)[:6] + b"\x13" + record(1)[7:],  # month 13
        record(1)[:151] + b"X" + record(1)[152:],
        record(1, field=FIELD * 1e4),
        record(1, field=FIELD * np.nan),
    ],
)
def test_a_bad_record_costs_itself_and_gives_no_value(bad: bytes) -> None:
    blocks, lost = heard(Lemi025, [(1.0, record(0)), (2.0, bad), (3.0, record(2)), (4.0, record(3))])
    assert all((b.values == FIELD * 1000).all() for b in blocks)
    assert len(blocks) >= 3
    assert lost.keys() <= {"bad frame", "gap"}
    assert lost


def test_noise_between_records_costs_nothing() -> None:
    assert len(heard(Lemi025, [(1.0, b"\x00L02L0" + record(0) + b"xyzL" + record(1))])[0]) == 2


def test_silence_is_a_fault() -> None:
    with pytest.raises(InstrumentError) as caught:
        listening(Lemi025, []).identify()
    assert caught.value.fault == "silent"


@given(st.lists(st.integers(1, 200), min_size=1, max_size=6), st.integers(0, 152), st.integers(1, 10))
def test_lost_bytes_give_no_wrong_value_in_any_cutting(sizes: list[int], place: int, lost: int) -> None:
    whole = b"".join(record(k) for k in range(4))
    blocks, _ = heard(Lemi025, cut(whole[:place] + whole[place + lost :], sizes))
    assert all((b.values == FIELD * 1000).all() for b in blocks)
    assert len(blocks) >= 2


def test_records_of_another_tag_are_named() -> None:
    reference = listening(Lemi025, [(0.1 + second, record(second)) for second in range(3)], tag="L036")
    with pytest.raises(InstrumentError, match="Its records begin with 'L025': state that as tag"):
        reference.identify()
