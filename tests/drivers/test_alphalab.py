"""AlphaLab: lists in chunks, readings byte by byte, zeroed meters, cut and shifted frames, silence, unplugging."""

from __future__ import annotations

from datetime import UTC, datetime

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from drivers.alphalab import AlphaLab, Settings
from drivers.emulators.alphalab import AlphaLabEmulator
from drivers.framing import alphalab
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import Exchange, scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InstrumentError
from labcal.twin import open_twin


def ask(code: int) -> bytes:
    return bytes([code]) + bytes(5)


# 123.45, -200.0, 1.5 and their magnitude 235.0: places 2, 1 and negative, 1, 1
READING = bytes.fromhex("10 00 0000 04D2  10 02 0000 3039  10 09 0000 07D0  10 01 0000 000F  10 01 0000 092E  08")
STOP: Exchange = (ask(0xFF), None)
ABOUT: Exchange = (ask(0x01), b"MODEL=MR3:SERIAL=42\x07")
FINE: Exchange = (ask(0x02), b"RELATIVE=0:ZERO=OFF\x07")


def test_the_block_is_32_bits_with_sign_and_places() -> None:
    assert alphalab.block(bytes.fromhex("10 09 0001 0001")) == -6553.7  # not only the last two bytes
    assert alphalab.block(bytes.fromhex("00 01 0000 0001")) is None
    assert alphalab.block(bytes.fromhex("50 01 0000 0001")) is None


def test_lists_come_in_chunks_and_each_is_acknowledged() -> None:
    about: list[Exchange] = [(ask(0x01), b"MODEL=MR3:SERIAL=42\x08"), (ask(0x08), [b"345:FIRM", b"WARE=1.6:\x07"])]
    wire = [STOP, *about, FINE]
    with scripted(AlphaLab, wire) as meter:
        who = meter.identify()
    assert (who.manufacturer, who.model, who.serial, who.firmware) == ("AlphaLab", "MR3", "42345", "1.6")


@pytest.mark.parametrize("zeroed", [b"RELATIVE=1:ZERO=OFF\x07", b"RATE=20:ZERO=ON:\x07", b"TARE=12.5\x07"])
def test_a_meter_that_shows_differences_is_refused(zeroed: bytes) -> None:
    with scripted(AlphaLab, [STOP, ABOUT, (ask(0x02), zeroed)]) as meter, pytest.raises(InstrumentError) as caught:
        meter.identify()
    assert caught.value.fault == "wrong mode"


@pytest.mark.parametrize(
    ("about", "settings", "nT"),
    [
        (b"MODEL=MR3:\x07", b"ZERO=0:\x07", 100.0),
        (b"MODEL=VGM:\x07", b"ZERO=0:\x07", 1e5),
        (b"MODEL=VGM:UNITS=MILLIGAUSS:\x07", b"ZERO=0:\x07", 100.0),
        (b"MODEL=MR3:UNITS=mG:\x07", b"UNIT=Gauss:\x07", 1e5),
    ],
)
def test_the_unit_is_what_it_says_or_its_models(about: bytes, settings: bytes, nT: float) -> None:
    field = bytes.fromhex("10 00 0000 04D2  10 04 0000 0141  10 00 0000 0000  10 00 0000 0000  10 04 0000 0141  08")
    wire: list[Exchange] = [STOP, (ask(0x01), about), *[(ask(0x02), settings)] * 2, (ask(0x03), field)]
    with scripted(AlphaLab, wire) as meter:
        meter.identify()
        meter.start()
        values = meter.read_until(meter._clock.now())[0].values
    np.testing.assert_allclose(values, [[0.0321 * nT, 0.0, 0.0]])


@pytest.mark.parametrize(("unit", "stated"), [(b"GAUSS", 100.0), (b"OERSTED", 0.0)])
def test_a_unit_that_is_another_or_not_known_is_refused(unit: bytes, stated: float) -> None:
    wire: list[Exchange] = [STOP, (ask(0x01), b"UNITS=" + unit + b":\x07")]
    with scripted(AlphaLab, wire, nT_per_unit=stated) as meter, pytest.raises(InstrumentError) as caught:
        meter.identify()
    assert caught.value.fault == "wrong set-up"


@pytest.mark.parametrize("gauss", [False, True])
def test_the_emulated_meter_is_read_in_either_unit(gauss: bool) -> None:
    clock, lab = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), open_twin({}, 1)
    lab.coils["x"].drive(clock.now(), 0.5, 30.0, True)
    emulator = AlphaLabEmulator(lab, {}, Settings())
    emulator.gauss = gauss
    if gauss:
        emulator.lists[0x01] = b"MODEL=VGM:SERIAL=7:FIRMWARE=1.6:"
    meter = AlphaLab("ref", EmulatedLink("emulated://x", emulator, clock), clock, Settings())
    meter.identify()
    meter.start()
    seen = meter.read_until(clock.now() + 1.0)[-1].values[-1]
    true = lab.reference_nT(np.array([clock.now()]))[0] * lab.reference_nT_per_unit
    assert np.linalg.norm(true) > 10_000
    np.testing.assert_allclose(seen, true, atol=60.0)


def polled(*replies: object) -> tuple[np.ndarray, dict[str, int]]:
    with scripted(AlphaLab, [FINE, *((ask(0x03), reply) for reply in replies)], rate=8.0) as meter:
        meter.start()
        blocks = meter.read_until(meter._clock.now() + 0.125 * (len(replies) - 1) + 0.1)
        lost = {e.data["fault"]: e.data["lost"] for e in meter.events()}
        return np.vstack([b.values for b in blocks]) if blocks else np.empty((0, 3)), lost


def test_a_reading_in_pieces_in_nanotesla() -> None:
    values, lost = polled([READING[:7], READING[7:]], READING)
    np.testing.assert_allclose(values, [[12345.0, -20000.0, 150.0]] * 2)
    assert lost == {}


@pytest.mark.parametrize(
    "bad",
    [
        READING[:30] + b"\x07",
        READING[:6] + b"\x00" + READING[7:],  # x has no data
        READING[:8] + b"\x01" + READING[9:],  # a bit of x turned over: the magnitude does not fit
        READING[1:] + b"\x08",  # slipped by a byte
        b"\xff" * 31,
    ],
)
def test_a_bad_reading_costs_itself_and_gives_no_value(bad: bytes) -> None:
    values, lost = polled(bad, READING)
    np.testing.assert_allclose(values, [[12345.0, -20000.0, 150.0]])
    assert lost == {"bad frame": 1}


def test_full_scale_is_a_fault() -> None:
    full = bytes.fromhex("10 00 0000 0000  10 01 0000 4E1F  10 01 0000 0000  10 01 0000 0000  10 01 0000 4E1F  08")
    with pytest.raises(InstrumentError) as caught:
        polled(full)
    assert caught.value.fault == "overloaded"


def test_a_list_without_end_ends() -> None:
    wire: list[Exchange] = [STOP, (ask(0x01), b"A=1:\x08"), *[(ask(0x08), b"A=1:\x08")] * 100]
    with scripted(AlphaLab, wire) as meter, pytest.raises(InstrumentError, match="no end"):
        meter.identify()


@pytest.mark.parametrize("said", [b"12.5,48000.0,-3.1\r\n" * 8, b"\xfd\x20\x00\x07", b"\x07", b"$PMAG,1,2,3*4F\x07"])
def test_another_s_stream_is_no_list_of_its_own(said: bytes) -> None:
    with scripted(AlphaLab, [STOP, (ask(0x01), said)]) as meter, pytest.raises(InstrumentError) as caught:
        meter.identify()
    assert caught.value.fault == "another instrument"


@given(st.binary(min_size=31, max_size=31))
def test_any_31_bytes_give_a_consistent_reading_or_none(frame: bytes) -> None:
    xyz = alphalab.axes(frame, 1.0, 0.01)
    assert xyz is None or (np.isfinite(xyz).all() and frame[30] == 8)
