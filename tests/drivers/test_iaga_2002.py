"""IAGA-2002 lines as they are written: columns, heads, what is missing, gaps, times."""

from __future__ import annotations

from datetime import UTC, datetime
from typing import Literal

import numpy as np
import pytest
from listening import Sender, cut, heard, listening

from drivers.iaga_2002 import Iaga2002, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError

FIRST = b"cut off\n"
HEAD = (
    b" Format                 IAGA-2002                                    |\n"
    b" Station Name           Somewhere                                    |\n"
    b" # a comment                                                         |\n"
    b"DATE       TIME         DOY     ABCX      ABCY      ABCZ      ABCF   |\n"
)
ROWS = (
    b"2026-03-01 00:00:00.000 060     21000.12   -100.50  43000.00  47853.00\n"
    b"2026-03-01 00:00:01.000 060     21000.22   -100.40  43000.10  47853.10\n"
)
FIELD = [[21000.12, -100.5, 43000.0], [21000.22, -100.4, 43000.1]]


@pytest.mark.parametrize("size", [1, 13, 1000])
def test_rows_in_any_cutting_behind_their_head(size: int) -> None:
    blocks, lost = heard(Iaga2002, cut(FIRST + HEAD + ROWS, [size]), station="ABC")
    assert np.vstack([block.values for block in blocks]).tolist() == FIELD
    assert np.diff(np.concatenate([block.t_s for block in blocks])).tolist() == [1.0]
    assert lost == {}


def test_the_quickest_row_is_its_delay_old_when_it_comes() -> None:
    ((block,), _) = heard(Iaga2002, [(9.0, FIRST + ROWS)], delay_s=2.0)  # two rows at once: the later came the quicker
    assert block.t_s.tolist() == [6.0, 7.0]


def test_the_rows_own_time_is_the_bench_s_where_that_is_stated() -> None:
    row = b"2026-01-01 00:00:05.250 001     21000.12   -100.50  43000.00  47853.00\n"
    ((block,), _) = heard(Iaga2002, [(30.0, FIRST + row)], stamp="utc")  # the bench opened at 00:00:00
    assert block.t_s.tolist() == pytest.approx([5.25])


def test_horizontal_field_and_declination_in_minutes_become_north_and_east() -> None:
    row = b"2026-03-01 00:00:00.000 060     20000.00   1800.00  43000.00  88888.00\n"  # 30 degrees
    ((block,), _) = heard(Iaga2002, [(9.0, FIRST + row)], elements="HDZF", reads="HDZ")
    assert block.values[0] == pytest.approx([20000 * 3**0.5 / 2, 10000.0, 43000.0])


def test_the_magnitude_alone() -> None:
    ((block,), _) = heard(Iaga2002, [(9.0, FIRST + ROWS)], reads="F")
    assert (block.columns, block.values.tolist()) == (("ref_f",), [[47853.0], [47853.1]])


def test_a_value_that_is_missing_and_rows_that_are_make_a_gap() -> None:
    missing = ROWS.replace(b"   -100.50", b"  99999.00")
    late = b"2026-03-01 00:00:05.000 060     21000.12   -100.50  43000.00  88888.00\n"
    ((block,), lost) = heard(Iaga2002, [(9.0, FIRST + missing + late)])
    assert block.values.tolist() == [FIELD[1], FIELD[0]]  # F was not recorded, and is not read
    assert lost == {"gap": 1 + 3}


@pytest.mark.parametrize(
    "row",
    [ROWS[:71].replace(b" 060 ", b" 061 "), ROWS[:71].replace(b"00:00:00", b"00:61:00"), ROWS[:60] + b"\n",
     ROWS[:71].replace(b"21000.12", b"21000,12"), ROWS[:71].replace(b"21000.12", b"     nan"), b"x" * 400 + b"\n"],
)  # fmt: skip
def test_what_is_no_row_is_noted(row: bytes) -> None:
    assert heard(Iaga2002, [(9.0, FIRST + row)]) == ([], {"bad frame": 1})


@pytest.mark.parametrize("said", [{"elements": "HDZF", "reads": "HDZ"}, {"station": "XYZ"}])
def test_a_head_of_another_station_or_other_elements_is_refused(said: dict[str, str]) -> None:
    with pytest.raises(InstrumentError, match="its head says 'ABCX ABCY ABCZ ABCF'") as caught:
        heard(Iaga2002, [(9.0, FIRST + HEAD + ROWS)], **said)
    assert caught.value.fault == "another instrument"


@pytest.mark.parametrize(("elements", "reads"), [("XYZ", "XYZ"), ("XYZF", "HDZ"), ("XXZF", "XYZ")])
def test_elements_that_cannot_be_are_refused(elements: str, reads: Literal["XYZ", "HDZ"]) -> None:
    with pytest.raises(ValueError, match="elements must be four letters"):
        Settings(elements, reads)


def test_minutes_are_waited_for_three_of_them() -> None:
    assert listening(Iaga2002, [(100.0, FIRST + ROWS)], period_s=60.0).identify().model == "XYZF"
    with pytest.raises(InstrumentError, match="nothing came in 3 s"):
        listening(Iaga2002, [(100.0, FIRST + ROWS)]).identify()


def test_what_it_reads_is_read_again_from_a_record() -> None:
    clock = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC))
    line = EmulatedLink("emulated://line", Sender([(1.0, FIRST + HEAD + ROWS)]), clock)
    listener = Iaga2002("it", line, clock, Settings())
    (block,) = listener.read_until(9.0)
    assert Iaga2002.parse_again(Settings(), block.raw).tolist() == FIELD
