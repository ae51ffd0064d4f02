"""Whatever ends the lines of what sends by itself, and however they are cut, the same readings come."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from listening import cut, heard

from drivers.csv_line import CsvLine
from drivers.framing import nmea
from drivers.gsm import Gsm
from drivers.i2c_board import I2cBoard, sealed
from drivers.pmag import Pmag
from drivers.rm3100 import Rm3100
from drivers.text_line import TextLine

PMAG = [nmea.build("PMAG", [f"{k}.5", "100.1", "-2.5", f"{k}", "21.5"]).strip() for k in (1, 2, 3)]
SENT: list[tuple[Any, list[bytes]]] = [
    (CsvLine, [b"1.5,100,-200,1", b"2.5,100,-200,2", b"3.5,100,-200,3"]),
    (TextLine, [b"100,-200,1", b"100,-200,2", b"100,-200,3"]),
    (Rm3100, [b"100,-200,1", b"100,-200,2", b"100,-200,3"]),
    (Pmag, PMAG),
    (Gsm, [b"48000.11 99", b"48000.12 99", b"48000.13 99"]),
    (I2cBoard, [sealed(f"{k} rm3100 {50 * k} 100 -200 {k}").strip() for k in (1, 2, 3)]),
]  # fmt: skip
EACH = pytest.mark.parametrize(("driver", "lines"), SENT, ids=[driver.__name__ for driver, _ in SENT])


def readings(driver: Any, pieces: list[tuple[float, bytes]]) -> tuple[Any, Any]:
    blocks, lost = heard(driver, pieces)
    assert lost == {}
    of_sensor = [block for block in blocks if block.stream != "channel"]
    return np.vstack([block.values for block in of_sensor]), np.concatenate([block.t_s for block in of_sensor])


@EACH
@pytest.mark.parametrize("sizes", [[1000], [1], [7, 2], [3]])
def test_cr_lf_or_both_end_a_line(driver: Any, lines: list[bytes], sizes: list[int]) -> None:
    values = {
        end: readings(driver, cut(end.join([b"9", *lines, b""]), sizes))[0].tolist() for end in (b"\n", b"\r\n", b"\r")
    }
    assert len(values[b"\n"]) == 3
    assert values[b"\r"] == values[b"\r\n"] == values[b"\n"]


@EACH
def test_a_line_is_stamped_at_its_first_byte_though_the_end_before_comes_in_two_pieces(
    driver: Any, lines: list[bytes]
) -> None:
    ends = [(float(k), line + b"\r") for k, line in enumerate(lines, 2)]
    rests = [(k + 0.5, b"\n") for k in (1, 2, 3, 4)]
    late = 0.5 if driver is Gsm else 0.0  # its delay_s
    _, t_s = readings(driver, sorted([(1.0, b"9\r"), *ends, *rests]))
    np.testing.assert_allclose(t_s, np.array([2.0, 3.0, 4.0]) - late)


@EACH
def test_what_is_too_long_for_a_line_is_noted_whole(driver: Any, lines: list[bytes]) -> None:
    blocks, lost = heard(driver, [(1.0, b"\n" + b"7" * 5000 + b"\r" + lines[0] + b"\r")])
    assert lost == {"bad frame": 1}
    assert len(blocks[0].values) == 1
