"""spacepackets decodes what a DUT sends by itself: CCSDS packets, framed by SLIP."""

from __future__ import annotations

import pytest
from served_benches import Line
from spacepackets.ccsds import PacketType, SequenceFlags, SpacePacketHeader
from waiting import heard

END, ESCAPE = b"\xc0", {b"\xdb\xdc": b"\xc0", b"\xdb\xdd": b"\xdb"}  # RFC 1055


@pytest.mark.met("ccsds", "spacepackets", "ten packets out of SLIP: type, APID, count, length, secondary header")
def test_spacepackets(line: Line) -> None:
    frames = [frame for frame in heard(line, END, 24) if frame][:10]
    for escaped, plain in ESCAPE.items():
        frames = [frame.replace(escaped, plain) for frame in frames]
    headers = [SpacePacketHeader.unpack(frame) for frame in frames]
    assert {(h.packet_type, h.apid, h.seq_flags) for h in headers} == {(PacketType.TM, 42, SequenceFlags.UNSEGMENTED)}
    assert all(h.sec_header_flag and h.packet_len == len(frame) for h, frame in zip(headers, frames, strict=True))
    counts = [h.seq_count for h in headers]
    assert counts == list(range(counts[0], counts[0] + 10))
