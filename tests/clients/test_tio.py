"""Twinleaf's own Python package, the part of it that reads and writes packets, at the emulated VMR."""

from __future__ import annotations

import pytest
import serial
import slip
from served_benches import Line
from tio import TIOProtocol
from waiting import LONG_S

from drivers.framing import tio as ours

READINGS, DATA, REPLY = 20, 128, 3


@pytest.mark.met("twinleaf", "tio", "who it is, its stream described, 20 rows in the same numbers as our driver's")
def test_a_vmr(line: Line) -> None:
    theirs, described = TIOProtocol(), ours.Description()
    said, rows = list[bytes](), list[tuple[list[float], bytes]]()
    with serial.Serial(line.path, line.baud, timeout=LONG_S) as port:
        for name in ("dev.desc", "data.send_all"):
            port.write(slip.encode(theirs.req(name, None)[0]))
        while len(rows) < READINGS:
            frame = port.read_until(slip.SLIP_END_CHAR).removesuffix(slip.SLIP_END_CHAR)
            if (good := ours.parse(frame)) is None:
                continue
            packet = theirs.decode_packet(bytes(slip.decode(frame)))
            described.take(*good)
            if packet["type"] == REPLY:
                said.append(bytes(packet["payload"]))
            elif packet["type"] == DATA and theirs.columns:
                rows.append((list(theirs.stream_data(packet)), good[1]))
    assert said[0].startswith(b"Twinleaf VMR")
    assert theirs.columns == ["vector.x", "vector.y", "vector.z", "therm"]
    place = described.place("vector")
    assert place is not None
    assert 1 / place.period_s == pytest.approx(theirs.columnsByName["vector"]["stream_Fs"])
    assert place.unit == theirs.sources["vector"]["source_units"] == "nT"
    for numbers, row in rows:
        assert list(place.of(row)) == numbers[:3]
        assert 2_000.0 < sum(one**2 for one in numbers[:3]) ** 0.5 < 150_000.0
    counts = [ours.number_of(row) for _, row in rows]
    assert counts == list(range(counts[0], counts[0] + READINGS))
