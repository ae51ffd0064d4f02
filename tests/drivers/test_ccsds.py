"""Space packets: SLIP, COBS and datagrams; gaps, late packets, wrong CRCs, noise, cut packets."""

from __future__ import annotations

import struct

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from listening import cut, heard

from drivers.ccsds import Ccsds
from drivers.framing import ccsds, cobs, slip
from drivers.framing.crc16 import crc16
from labcal.bench.driver_kit.testing import scripted
from labcal.errors import InputError

TIMED = {"framing": "datagram", "columns": ("x", "y", "z", "temp_dut"), "layout": ">3hH"}


def packet(count: int, xyz: tuple[float, ...] = (1.0, -2.0, 3.0), *, seconds: float = 0.0, apid: int = 100) -> bytes:
    """A packet with CUC time 4+2, three floats and a CRC."""
    data = round(seconds * 65536).to_bytes(6, "big") + struct.pack(">3f", *xyz) + b"\0\0"
    body = ccsds.build(apid, count, data, secondary=True)[:-2]
    return body + crc16(body).to_bytes(2, "big")


def test_the_header_byte_for_byte() -> None:
    by_hand = bytes.fromhex("0864 C005 0013") + bytes(6) + struct.pack(">3f", 1, -2, 3)  # 6 + 12 + 2 - 1 = 13h
    assert packet(5) == by_hand + crc16(by_hand).to_bytes(2, "big")
    read = ccsds.parse(packet(5), crc_bytes=2)
    assert read is not None
    assert (read.apid, read.count, read.unsegmented, read.secondary, len(read.data)) == (100, 5, True, True, 18)


@pytest.mark.parametrize("encode", [slip.encode, cobs.encode])
def test_packets_in_frames_in_any_cutting(encode: object) -> None:
    framing = "slip" if encode is slip.encode else "cobs"
    end = slip.END if encode is slip.encode else cobs.END
    data = end + b"".join(encode(packet(k, (192.0, 219.0, float(k)))) for k in range(50))
    for sizes in ([1], [7], [1000], [3, 29]):
        blocks, lost = heard(Ccsds, cut(data, sizes), framing=framing)
        np.testing.assert_array_equal(blocks[0].values, [[192, 219, k] for k in range(50)])
        assert lost == {}


def test_gaps_late_packets_and_a_restart_are_told_apart() -> None:
    counts = [16380, 16383, 0, 5, 4, 5, 6, 3000, 1000, 1001]
    blocks, lost = heard(Ccsds, [(k, packet(c, (c, 0, 0))) for k, c in enumerate(counts)], framing="datagram")
    np.testing.assert_array_equal(blocks[0].values[:, 0], [16380, 16383, 0, 5, 6, 3000, 1000, 1001])
    assert lost == {"gap": 2 + 4 + 2993, "late": 2, "restart": 0}


def test_its_own_time_becomes_the_benchs() -> None:
    pieces = [(10 + 0.1 * k + jitter, packet(k, seconds=500 + 0.1 * k)) for k, jitter in enumerate([0.03, 0.0, 0.05])]
    blocks, _ = heard(Ccsds, pieces, framing="datagram", stamp="device")
    np.testing.assert_allclose(blocks[0].t_s, [10.0, 10.1, 10.2], atol=2e-5)


def test_cds_time_and_counts_with_housekeeping() -> None:
    data = struct.pack(">HI3hH", 3, 4500, 100, -200, 300, 291)
    whole = ccsds.build(7, 1, data, secondary=True)
    blocks, _ = heard(Ccsds, [(1.0, whole)], **TIMED, time="cds", crc=False, apid=7, stamp="device", scale=2.0)
    np.testing.assert_array_equal(blocks[0].values, [[200, -400, 600]])
    np.testing.assert_array_equal(blocks[1].values, [[291]])


@pytest.mark.parametrize(
    ("bad", "lost"),
    [
        (packet(1)[:-1] + b"\x00", {"checksum": 1, "gap": 1}),
        (packet(1)[:10], {"checksum": 1, "gap": 1}),
        (b"", {"bad frame": 1, "gap": 1}),
        (packet(1, (1.0, float("nan"), 3.0)), {"bad frame": 1}),
        (packet(1, apid=101), {"gap": 1}),
    ],
)
def test_what_is_no_good_packet_gives_no_value(bad: bytes, lost: dict[str, int]) -> None:
    blocks, said = heard(Ccsds, [(0.0, packet(0)), (0.1, bad), (0.2, packet(2))], framing="datagram")
    assert len(blocks[0]) == 2
    assert said == lost


def test_a_broken_escape_costs_one_packet() -> None:
    data = slip.END + slip.encode(packet(0)) + b"\xdb\x01" + slip.END + slip.encode(packet(1))
    blocks, lost = heard(Ccsds, [(0.0, data)])
    assert len(blocks[0]) == 2
    assert lost == {"bad frame": 1}


@pytest.mark.parametrize(
    "settings",
    [{"layout": ">2f"}, {"layout": "3f"}, {"layout": ">3q!"}, {"apid": 2047}, {"columns": ("x", "y")}],
)
def test_settings_that_make_no_sense_are_refused(settings: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"layout|apid|columns"):
        heard(Ccsds, [], **settings)


def test_datagrams_need_a_line_that_keeps_them_apart() -> None:
    with scripted(Ccsds, []) as dut:
        dut._link.url = "serial:///dev/ttyUSB0"
        with pytest.raises(InputError, match="udp://"):
            Ccsds("dut", dut._link, dut._clock, type(dut.settings)(framing="datagram"))


@given(st.integers(0, 25), st.integers(1, 255), st.sampled_from(["slip", "cobs", "datagram"]))
def test_one_broken_byte_never_gives_another_value(place: int, flip: int, framing: str) -> None:
    good = {"slip": slip.encode, "cobs": cobs.encode, "datagram": bytes}[framing](packet(3))
    at = place % len(good)
    broken = good[:at] + bytes([good[at] ^ flip]) + good[at + 1 :]
    first = {"slip": slip.END, "cobs": cobs.END, "datagram": b""}[framing]
    blocks, _ = heard(Ccsds, [(0.0, first + broken)], framing=framing)
    assert all((b.values == [[1, -2, 3]]).all() for b in blocks)
