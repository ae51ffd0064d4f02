"""Damaged streams against every parser: never a crash, a hang, or a value that was not sent.

What the format can notice is what is damaged: with a checksum any one byte of a frame (turned, lost or put in), without
one bytes that are lost or put in. For plain text, which can notice neither, a value is good that stands in a line.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from listening import cut

from drivers import ccsds as ccsds_driver
from drivers import csv_line, i2c_board, lemi_025, pmag, rm3100, text_line
from drivers.emulators.ccsds import own_time
from drivers.framing import alphalab, ccsds, cobs, hmr2300, lemi, nmea, slip
from drivers.framing.crc16 import crc16
from drivers.framing.mishaps import Mishaps
from labcal.errors import InstrumentError
from labcal.record.stream import Block

FRAMES = 40
Damage = tuple[int, str, int, int]  # which frame, what, where, with what
DAMAGES = st.lists(
    st.tuples(st.integers(0, FRAMES - 1), st.sampled_from(["turn", "lose", "put"]), st.integers(0, 10**6),
              st.integers(1, 255)),
    max_size=12, unique_by=lambda damage: damage[0],
)  # fmt: skip


@dataclass(frozen=True)
class Target:
    """Frame number k; the parser, new; what may come out of the damaged bytes; kinds of damage it must notice."""

    frame: Callable[[int], bytes]
    parser: Callable[[], Any]
    allowed: Callable[[bytes], set[tuple[float, ...]]]
    damage: tuple[str, ...] = ("turn", "lose", "put")
    first: bytes = b""
    rows: int = 1  # samples in a frame
    cost: int = 2  # frames that one damage may cost
    last: int = 1  # frames that may still be waited for
    whole: bool = False  # frames come in pieces of their own, as datagrams do


def xyz(k: int) -> tuple[float, float, float]:
    return float(k * 0xC0), -float(k), 219.0


def sent(_: bytes) -> set[tuple[float, ...]]:
    return {xyz(k) for k in range(FRAMES)}


def in_lines(data: bytes, scale: float = 1.0) -> set[tuple[float, ...]]:
    """The last three numbers of every line, read by another rule than the parser's."""
    found = set()
    for line in re.split(rb"[\r\n]", data):  # either ends one: text has no checksum to tell a digit from an end
        text = line.decode("latin-1").strip("\r \0")
        if re.fullmatch(r"[\d.,+\-eE \t]+", text):
            try:
                found.add(tuple(float(part) * scale for part in text.split(",")[-3:]))
            except ValueError:
                continue
    return found


def space_packet(k: int, options: ccsds_driver.Settings) -> bytes:
    data = own_time(options, 0.1 * k) + struct.pack(">3f", *xyz(k)) + b"\0\0"
    body = ccsds.build(100, k, data, secondary=True)[:-2]
    return body + crc16(body).to_bytes(2, "big")


def packets(framing: Any, encode: Callable[[bytes], bytes], first: bytes = b"") -> Target:
    options = ccsds_driver.Settings(framing=framing)
    return Target(
        lambda k: encode(space_packet(k, options)),
        lambda: ccsds_driver.Parser("dut", options, Mishaps("dut")),
        sent,
        first=first,
        whole=framing == "datagram",
    )


class Hmr2300Parser:
    """Its text as blocks of counts; what it sends in binary has a campaign of its own (test_hmr2300_sync.py)."""

    def __init__(self) -> None:
        self._frames = hmr2300.TextFrames()

    def feed(self, pieces: list[tuple[float, bytes]]) -> list[Block]:
        found = self._frames.feed(pieces)
        return [Block("reference", "ref", ("x", "y", "z"), np.array([t]), np.array([c]), raw) for t, c, raw in found]


def hmr2300_text(k: int) -> bytes:
    columns = [f"{'-' if v < 0 else ' '}{abs(v) // 1000:2d},{abs(v) % 1000:03d}" for v in map(int, xyz(k))]
    return ("  ".join(columns) + "  \r").encode()


def lines_of(driver: Any, columns: bool, **options: Any) -> Target:
    form = "{:.1f},{:.0f},{:.0f},{:.0f}\n" if columns else "{:.0f},{:.0f},{:.0f}\r\n"
    chosen = driver.Settings(**options)
    scale = getattr(chosen, "nT_per_count", 1.0)
    return Target(
        lambda k: form.format(*((0.1 * k,) if columns else ()), *xyz(k)).encode(),
        lambda: driver.Parser("dut", chosen, Mishaps("dut")),
        lambda data: in_lines(data, scale),
        first=b"\n",
    )


TARGETS = {
    "slip": packets("slip", slip.encode, slip.END),
    "cobs": packets("cobs", cobs.encode, cobs.END),
    "datagram": packets("datagram", bytes),
    "hmr2300-ascii": Target(hmr2300_text, Hmr2300Parser, sent, damage=("lose", "put")),
    "pmag": Target(
        lambda k: nmea.build("PMAG", [f"{v:.1f}" for v in (0.1 * k, *xyz(k), 20.0)]),
        lambda: pmag.Parser("dut", pmag.Settings(), Mishaps("dut")),
        sent,
        first=b"\n",
    ),
    "csv-line": lines_of(csv_line, True),
    "text-line": lines_of(text_line, False, full_scale_nT=1e300),
    "rm3100": lines_of(rm3100, False),
    "i2c-board": Target(
        lambda k: i2c_board.sealed(f"{k} rm3100 {50 * k} {' '.join(f'{v:.0f}' for v in xyz(k))}"),
        lambda: i2c_board.Parser("dut", i2c_board.Settings(unit="count"), Mishaps("dut")),
        sent,
        first=b"\n",
    ),
    "lemi-025": Target(
        lambda k: lemi.build(b"L025", 1.7e9 + k, k % 3 > 0, np.tile(np.array(xyz(k)) / 1000, (10, 1))),
        lambda: lemi_025.Parser("dut", lemi_025.Settings(), Mishaps("dut")),
        lambda _: {tuple(np.float32(np.array(xyz(k)) / 1000).astype(float) * 1000) for k in range(FRAMES)},
        damage=("lose", "put"),
        rows=10,
    ),
}


def damaged(target: Target, damages: list[Damage]) -> list[bytes]:
    frames = [target.frame(k) for k in range(FRAMES)]
    for number, what, where, value in damages:
        frame, at = frames[number], where % len(frames[number])
        if what not in target.damage:
            continue
        kept = frame[at:] if what == "put" else frame[at + 1 :]
        new = {"turn": bytes([frame[at] ^ value]), "lose": b"", "put": bytes([value])}[what]
        frames[number] = frame[:at] + new + kept
    return [target.first, *frames] if target.first else frames


def survives(target: Target, damages: list[Damage], sizes: list[int]) -> None:
    """Every value that comes out was sent, and frames that nothing happened to (nor to a neighbour) come out."""
    frames = damaged(target, damages)
    data = b"".join(frames)
    parser, allowed, blocks = target.parser(), target.allowed(data), []
    for piece in [(0.1 * k, frame) for k, frame in enumerate(frames)] if target.whole else cut(data, sizes):
        try:
            blocks += [b for b in parser.feed([piece]) if b.stream != "channel"]
        except InstrumentError:  # digits put in can read as full scale, a point makes a fraction
            return
    found = [tuple(row) for block in blocks for row in block.values.tolist()]
    assert set(found) <= allowed, set(found) - allowed
    assert len(found) >= target.rows * (FRAMES - target.cost * len(damages) - target.last)


@pytest.mark.parametrize("examples", [15, pytest.param(2500, marks=pytest.mark.slow)])  # of 40 frames each
@pytest.mark.parametrize("name", sorted(TARGETS))
def test_no_damage_makes_a_value_that_was_not_sent(name: str, examples: int) -> None:
    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(DAMAGES, st.lists(st.integers(1, 300), min_size=1, max_size=4))
    def campaign(damages: list[Damage], sizes: list[int]) -> None:
        survives(TARGETS[name], damages, sizes)

    campaign()


@pytest.mark.parametrize("examples", [15, pytest.param(2500, marks=pytest.mark.slow)])
def test_alphalab_readings_with_a_damaged_axis_fit_their_magnitude(examples: int) -> None:
    """40 readings each: what comes out is within the stated part of what the meter measured, or nothing does."""

    @settings(max_examples=examples, deadline=None, database=None, suppress_health_check=list(HealthCheck))
    @given(DAMAGES)
    def campaign(damages: list[Damage]) -> None:
        hurt = {number: (where, value) for number, _, where, value in damages}
        for k in range(FRAMES):
            where, value = hurt.get(k, (0, 0))
            x, y, z = 10 * k, -k, 1000
            parts = [(0, k), (1, x), (1, y), (1, z), (1, round(float(np.hypot(np.hypot(x, y), z))))]
            frame = bytearray(b"".join(bytes([16, p | (v < 0) << 3]) + abs(v).to_bytes(4, "big") for p, v in parts))
            frame += b"\x08"
            frame[where % 31] ^= value
            read = alphalab.axes(bytes(frame), 1.0, 0.01)
            if k not in hurt:
                assert read == [x / 10, y / 10, z / 10]
            elif read is not None and 6 <= where % 31 < 24:  # a sign, or a digit too small to matter
                others = np.abs(np.abs(read) - np.abs([x / 10, y / 10, z / 10]))
                assert np.hypot(*np.sort(others)[1:]) <= 50

    campaign()
