"""pynmea2 decodes what a DUT sends by itself: sentences with a checksum."""

from __future__ import annotations

from itertools import pairwise

import pynmea2
import pytest
from served_benches import Line
from waiting import heard


@pytest.mark.met("pmag", "pynmea2", "ten sentences: form and checksum, and a reading of the Earth's size")
def test_pynmea2(line: Line) -> None:
    sentences = [pynmea2.parse(one.decode(), check=True) for one in heard(line, b"\r\n", 10)]
    fields = [list(map(float, sentence.data[-5:])) for sentence in sentences]
    assert [round(b[0] - a[0], 3) for a, b in pairwise(fields)] == [0.1] * 9
    assert all(1_000 < sum(v * v for v in row[1:4]) ** 0.5 < 200_000 for row in fields)
