"""GSM-19 and GSM-90: the lines that observatories have of theirs, good and bad."""

from __future__ import annotations

import pytest
from listening import cut, heard, listening

from drivers.gsm import Gsm
from labcal.errors import InstrumentError

FIRST = b"cut off\r\n"
LINES = [
    (b"04-22-2015 142244  48464.53 99", 48464.53),  # with its date, and two blanks
    (b"142244.5 48464.53 99", 48464.53),
    (b"410356.0 48601.02 79", 48601.02),  # an old GSM-19 counts its hours on from the first day
    (b"1702356.0 49000.1 99\r", 49000.1),
    (b" 48464.530 99", 48464.53),
]


@pytest.mark.parametrize(("line", "field_nT"), LINES)
def test_a_line_is_its_field_in_nanotesla(line: bytes, field_nT: float) -> None:
    ((block,), lost) = heard(Gsm, [(9.0, FIRST + line + b"\n")])
    assert (block.columns, block.values.tolist(), lost) == (("ref_f",), [[field_nT]], {})
    assert block.t_s[0] == pytest.approx(8.5)


@pytest.mark.parametrize("size", [1, 7, 200])
def test_lines_in_any_cutting(size: int) -> None:
    blocks, lost = heard(Gsm, cut(FIRST + b"".join(line + b"\n" for line, _ in LINES), [size]))
    assert [float(v) for block in blocks for v in block.values[:, 0]] == [field for _, field in LINES]
    assert lost == {}


@pytest.mark.parametrize(
    "line",
    [b"142244 48464.53 09", b"142244 48464.53", b"48464.53", b"142244 00000.00 99", b"142244 484640.53 99",
     b"142244 48464 99", b"14:22:44 48464.53 99", b"142244 48464.53 99 1", b"\xff\xfe48464.53 99", b"x" * 300],
)  # fmt: skip
def test_what_is_no_good_reading_is_noted_and_gives_none(line: bytes) -> None:
    blocks, lost = heard(Gsm, [(9.0, FIRST + line + b"\r\n")])
    assert (blocks, lost) == ([], {"bad frame": 1})


def test_one_that_says_no_quality_is_taken_where_that_is_stated() -> None:
    ((block,), _) = heard(Gsm, [(9.0, FIRST + b"570301.0 48484.12\r\n")], least_quality=0)
    assert block.values.tolist() == [[48484.12]]


def test_a_slow_one_is_waited_for_three_of_its_periods() -> None:
    late = [(20.0, FIRST + b"142244 48464.53 99\r\n")]
    assert listening(Gsm, list(late), period_s=10.0, serial="702").identify().serial == "702"
    with pytest.raises(InstrumentError, match="nothing came in 9 s"):
        listening(Gsm, list(late)).identify()


@pytest.mark.parametrize(
    ("line", "told"),
    [(b"142244.5 48464.53", "says no quality: least_quality = 0"), (b"142244.5 48464.53 0.12", "gradiometer"),
     (b"142244.5 48464.53 0.12 99", "gradiometer"), (b"142244.5 48464.53 12", "quality")],
)  # fmt: skip
def test_lines_of_another_kind_are_explained(line: bytes, told: str) -> None:
    sent = [(0.5 + n, line + b"\r\n") for n in range(8)]
    with pytest.raises(InstrumentError, match=told):
        listening(Gsm, sent, period_s=1.0).identify()
