"""HMR2300: the datasheet's own values, frames in pieces, noise, a zero byte's worth of trouble in binary."""

from __future__ import annotations

from contextlib import suppress

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.emulators.hmr2300 import column
from drivers.framing.hmr2300 import BinaryFrames, TextFrames
from drivers.hmr2300 import NT_PER_COUNT, Hmr2300, Settings
from labcal.bench.driver_kit.testing import scripted
from labcal.errors import InstrumentError

PLAIN = "0001 0002 0003 0D"
ESC = (b"\x1b", None)


def started(
    fmt: str = "ascii", answers: tuple[bytes, ...] = (b"OK\r",) * 5, **settings: object
) -> list[tuple[bytes, object]]:
    words = [(b"A", b"ASCII_ON\r") if fmt == "ascii" else (b"B", b"BINARY_ON\r"), (b"ZF", b"ZERO_OFF\r"),
             (b"VF", b"AVG_OFF\r"), (b"TN", b"S/R_ON\r"), (b"R=20", b"OK\r")]  # fmt: skip
    wire: list[tuple[bytes, object]] = [ESC]
    for (word, reply), enabled in zip(words, answers, strict=True):
        wire += [(b"*00WE\r", enabled), (b"*00" + word + b"\r", reply)]
    return wire


def reading(fmt: str, pieces: list[bytes]) -> np.ndarray:
    with scripted(Hmr2300, [*started(fmt), (b"*00C\r", pieces)], format=fmt, invalid=0) as sensor:
        sensor.start()
        blocks = sensor.read_until(sensor._clock.now() + 1.0)
        return np.vstack([b.values for b in blocks]) / NT_PER_COUNT if blocks else np.empty((0, 3))


def test_ascii_of_the_datasheet_in_pieces() -> None:
    frame = b"  1,234  - 1,234   15,000  \r"
    np.testing.assert_allclose(reading("ascii", [frame[:5], frame[5:9], frame[9:] + frame]), [[1234, -1234, 15000]] * 2)


@pytest.mark.parametrize(
    ("frame", "counts"),
    [
        (b"     67  -   123      999  \r", [67, -123, 999]),
        (b"      0  -     7   15,000  \r", [0, -7, 15000]),
        (b"    -67     +123    1,000  \r", [-67, 123, 1000]),
        (b"  0,067  - 0,123  - 15000  \r", [67, -123, -15000]),
    ],
)
def test_below_a_thousand_counts_blanks_stand_for_digits_and_comma(frame: bytes, counts: list[int]) -> None:
    np.testing.assert_allclose(reading("ascii", [frame, frame]), [counts] * 2)


@pytest.mark.parametrize("bad", [b"     6 7  -   123      999  \r", b"    67  -   123      999  \r",
                                 b"     67  -   123      99   \r", b"     67  -   1 3      999  \r",
                                 b"         -   123      999  \r", b"     67  - - 123      999  \r"])  # fmt: skip
def test_a_frame_whose_columns_do_not_fit_is_no_value(bad: bytes) -> None:
    assert len(reading("ascii", [bad])) == 0


def test_its_words_may_have_blanks_where_the_data_sheet_prints_lines() -> None:
    wire = [
        (said, reply.replace(b"_", b" ") if isinstance(reply, bytes) else reply) for said, reply in started("binary")
    ]
    with scripted(Hmr2300, [*wire, (b"*00C\r", None)], format="binary") as sensor:
        sensor.start()


@pytest.mark.parametrize("count", [0, 7, -67, 999, 1000, -1234, 15000, -30000])
def test_what_the_emulated_one_sends_is_read_as_it_was(count: int) -> None:
    frame = "  ".join(column(k) for k in (count, -count, 1)).encode() + b"  \r"
    assert len(frame) == 28
    assert TextFrames().feed([(0.0, frame)])[0][1] == [count, -count, 1]


def test_binary_of_the_datasheet_with_a_carriage_return_inside() -> None:
    frames = bytes.fromhex("3A98 C568 1D4C 0D 0D0D E2B4 000D 0D" + PLAIN)
    np.testing.assert_allclose(reading("binary", [frames]), [[15000, -15000, 7500], [0x0D0D, -7500, 13]])


def test_a_frame_waits_for_the_next_one_to_say_that_it_is_in_step() -> None:
    assert len(reading("binary", [bytes.fromhex("3A98 C568 1D4C 0D")])) == 0


@pytest.mark.parametrize("reply", ["00010002000D 0D0D", "0D 000100020D03 0D", "000100020003 04"])
def test_a_binary_reply_of_another_length_or_without_its_end_is_no_value(reply: str) -> None:
    wire = [*started("binary"), (b"*00P\r", bytes.fromhex(reply))]
    with scripted(Hmr2300, wire, format="binary", mode="polled", invalid=0) as sensor:
        sensor.start()
        blocks = sensor.read_until(sensor._clock.now())
        assert [b.values for b in blocks] == []
        assert [e.data["fault"] for e in sensor.events()] == ["bad frame"]


def test_noise_between_ascii_frames_costs_a_frame_and_no_wrong_value() -> None:
    good = b"  1,234  - 1,234   15,000  \r"
    np.testing.assert_allclose(reading("ascii", [b"\xff 1,2" + good + b"Re-enter\r" + good]), [[1234, -1234, 15000]])


def test_full_scale_is_a_fault_and_not_a_value() -> None:
    with pytest.raises(InstrumentError) as caught:
        reading("binary", [bytes.fromhex("7530 0000 0000 0D" + PLAIN)])
    assert caught.value.fault == "overloaded"


def test_without_write_enable_the_setting_fails() -> None:
    wire = [ESC, (b"*00WE\r", b"OK\r"), (b"*00A\r", b"WE_OFF\r")]
    with scripted(Hmr2300, wire) as sensor, pytest.raises(InstrumentError, match="WE_OFF"):
        sensor.start()


def test_the_first_three_readings_after_the_pulse_of_the_start_are_dropped() -> None:
    frames = b"".join(bytes.fromhex(f"0001 000{k} 0003 0D") for k in range(6))
    with scripted(Hmr2300, [*started("binary"), (b"*00C\r", [frames[:10], frames[10:]])], format="binary") as sensor:
        sensor.start()
        blocks = sensor.read_until(sensor._clock.now() + 1.0)
    np.testing.assert_allclose(blocks[0].values[:, 1] / NT_PER_COUNT, [3, 4])


@pytest.mark.parametrize(
    ("fmt", "baud", "rate"), [("ascii", 9600, 40), ("ascii", 19200, 60), ("binary", 9600, 123), ("ascii", 9600, 21)]
)
def test_a_rate_that_the_line_cannot_carry_is_refused(fmt: str, baud: int, rate: int) -> None:
    with pytest.raises(ValueError, match="rate"):
        Settings(format=fmt, baud=baud, rate=rate)


def test_polled_asks_for_every_sample() -> None:
    frame = b"  0,001    0,002  - 0,003  \r"
    wire = [*started(), (b"*00P\r", frame), (b"*00P\r", frame)]
    with scripted(Hmr2300, wire, mode="polled", invalid=0) as sensor:
        sensor.start()
        blocks = sensor.read_until(sensor._clock.now() + 0.06)
    np.testing.assert_allclose(blocks[0].values / NT_PER_COUNT, [[1, 2, -3]] * 2)


@given(st.binary(max_size=200))
def test_no_bytes_crash_the_parser(data: bytes) -> None:
    with suppress(InstrumentError):  # overloaded
        assert np.abs(reading("ascii", [data])).max(initial=0) < 30_000
    frames = BinaryFrames()
    assert len(frames.feed([(0.0, data)])) + len(frames.bad) <= len(data) // 7
