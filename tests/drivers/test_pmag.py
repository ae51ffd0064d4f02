"""$PMAG: the sheet's own sentence, wrong checksums, noise, cut sentences, other sentences."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from listening import cut, heard, listening

from drivers.framing import nmea
from drivers.pmag import Pmag
from labcal.errors import InstrumentError

GOOD = b"$PMAG,1234.500,21034.1,-1890.0,43210.7,23.4*06\r\n"


def test_the_sheets_own_sentence() -> None:
    blocks, lost = heard(Pmag, [(0.1, b"\n"), (1.0, GOOD[:20]), (1.2, GOOD[20:])], delay_s=0.01)
    np.testing.assert_array_equal(blocks[0].values, [[21034.1, -1890.0, 43210.7]])
    np.testing.assert_array_equal(blocks[1].values, [[23.4]])
    np.testing.assert_allclose(blocks[0].t_s, [0.99])
    assert blocks[0].raw == GOOD
    assert lost == {}


def test_its_own_clock_is_tied_to_the_bench() -> None:
    later = nmea.build("PMAG", ["1234.600", "1", "2", "3", "4"])
    blocks, _ = heard(Pmag, [(0.1, b"\n"), (1.0, GOOD), (1.17, later)], stamp="device")
    np.testing.assert_allclose(blocks[0].t_s, [1.0, 1.1])


@pytest.mark.parametrize(
    ("line", "lost"),
    [
        (GOOD.replace(b"06", b"07"), {"checksum": 1}),
        (GOOD.replace(b"2103", b"2104"), {"checksum": 1}),
        (GOOD[:30] + b"\n", {"bad frame": 1}),
        (b"$PMAG,1,2,3*" + b"%02X" % nmea.checksum(b"PMAG,1,2,3") + b"\n", {"bad frame": 1}),
        (nmea.build("PMAG", ["1", "nan", "2", "3", "4"]), {"bad frame": 1}),
        (nmea.build("PMAG", ["1" * 40, "2" * 40, "3", "4", "5"]), {"checksum": 1}),  # longer than 82
        (nmea.build("PHTR", ["1"]), {}),
        (b"\xff\x80#\n", {"bad frame": 1}),
        (b"\r\n", {}),
    ],
)
def test_what_is_no_good_sentence_is_dropped_and_reported(line: bytes, lost: dict[str, int]) -> None:
    blocks, said = heard(Pmag, [(0.0, b"\n" + line + GOOD)])
    assert len(blocks[0]) == 1
    assert said == lost


def test_noise_before_the_dollar_costs_nothing() -> None:
    assert len(heard(Pmag, [(0.0, b"\n\x00\xfe$PM" + GOOD)])[0][0]) == 1


def test_silence_is_a_fault_with_its_name() -> None:
    with pytest.raises(InstrumentError, match="nothing came") as caught:
        listening(Pmag, []).identify()
    assert caught.value.fault == "silent"
    with pytest.raises(InstrumentError, match=r"ends with b'.*,6'"):
        listening(Pmag, [(0.1, b"1,2,3\n4,5,6")]).identify()


@given(st.integers(0, len(GOOD) - 3), st.integers(1, 255), st.lists(st.integers(1, 30), min_size=1))
def test_one_broken_byte_is_never_taken_for_a_good_sentence(place: int, flip: int, sizes: list[int]) -> None:
    broken = GOOD[:place] + bytes([GOOD[place] ^ flip]) + GOOD[place + 1 :]
    blocks, _ = heard(Pmag, cut(b"\n" + broken, sizes))
    assert all((b.values == [[21034.1, -1890.0, 43210.7]]).all() for b in blocks if b.stream == "dut")
