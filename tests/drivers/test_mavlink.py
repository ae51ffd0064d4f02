"""MAVLink: a vehicle made with pymavlink's own encoder; two vehicles, damaged frames, what is calibrated on board."""

from __future__ import annotations

import struct
import sys
from datetime import UTC, datetime
from typing import Any

import numpy as np
import pytest
from listening import cut, heard, listening
from pymavlink.dialects.v20 import ardupilotmega as mav

from drivers.emulators.mavlink import MavlinkEmulator
from drivers.mavlink import Mavlink, Settings
from labcal.bench.clock import VirtualClock
from labcal.bench.driver_kit.testing import scripted
from labcal.bench.links import EmulatedLink
from labcal.errors import InputError, InstrumentError
from labcal.twin import open_twin


class Vehicle:
    """Encodes what a vehicle sends, counting its messages."""

    def __init__(self, system: int = 1, component: int = 1, mavlink1: bool = False) -> None:
        self._out, self._mavlink1 = mav.MAVLink(None, system, component), mavlink1

    def says(self, message: Any) -> bytes:
        frame = bytes(message.pack(self._out, force_mavlink1=self._mavlink1))
        self._out.seq = (self._out.seq + 1) % 256
        return frame

    def highres(self, x: float, t_s: float = 1.0, updated: int = 0x1FFF, instance: int = 0) -> bytes:
        values = (x, -0.25, 0.5, 1013.0, 0.0, 0.0, 24.5, updated, instance)
        return self.says(mav.MAVLink_highres_imu_message(round(t_s * 1e6), *(0.0,) * 6, *values))

    def heartbeat(self, autopilot: int = 12) -> bytes:
        return self.says(mav.MAVLink_heartbeat_message(2, autopilot, 0, 0, 3, 3))


def test_the_frame_byte_for_byte() -> None:
    by_hand = bytes.fromhex("fd16 0000 00 01 01 740000 e8030000 000000000000 000000000000 e803 18fc 2c01")  # id 116
    frame = Vehicle().says(mav.MAVLink_scaled_imu2_message(1000, *(0,) * 6, 1000, -1000, 300))
    assert frame[:-2] == by_hand
    blocks, lost = heard(Mavlink, [(3.0, frame)], message="SCALED_IMU2")
    np.testing.assert_array_equal(blocks[0].values, [[100_000, -100_000, 30_000]])  # milligauss
    assert blocks[0].raw == frame
    assert lost == {}


@pytest.mark.parametrize("mavlink1", [True, False])
def test_readings_in_any_cutting_of_both_versions(mavlink1: bool) -> None:
    vehicle = Vehicle(mavlink1=mavlink1)
    data = b"".join(vehicle.highres(0.125 * k) for k in range(40))
    for sizes in ([1], [7], [1000], [3, 29]):
        blocks, lost = heard(Mavlink, cut(data, sizes))
        read = np.vstack([b.values for b in blocks])
        np.testing.assert_array_equal(read, [[12_500 * k, -25_000, 50_000] for k in range(40)])
        assert lost == {}


def test_a_frame_is_stamped_when_it_begins() -> None:
    frame = Vehicle().highres(0.1)
    blocks, _ = heard(Mavlink, [(5.0, frame[:10]), (5.1, frame[10:60]), (5.2, frame[60:])], delay_s=0.5)
    assert blocks[0].t_s.tolist() == [4.5]


def test_its_own_time_becomes_the_benchs() -> None:
    vehicle = Vehicle()
    pieces = [(10 + 0.1 * k + late, vehicle.highres(0.1, 500 + 0.1 * k)) for k, late in enumerate([0.03, 0.0, 0.05])]
    blocks, _ = heard(Mavlink, pieces, stamp="device")
    np.testing.assert_allclose(np.concatenate([b.t_s for b in blocks]), [10.03, 10.13, 10.23], atol=0.04)


def test_raw_counts_stay_as_they_are() -> None:
    frame = Vehicle().says(mav.MAVLink_raw_imu_message(5_000_000, *(0,) * 6, 301, -302, 303))
    blocks, _ = heard(Mavlink, [(0.0, frame)], message="RAW_IMU", scale=0.5)
    np.testing.assert_array_equal(blocks[0].values, [[150.5, -151, 151.5]])


def test_what_is_not_a_new_reading_of_this_sensor_gives_none() -> None:
    vehicle = Vehicle()
    said = [vehicle.highres(0.1, updated=0x3F), vehicle.highres(0.2, instance=1), vehicle.highres(float("nan"))]
    blocks, lost = heard(Mavlink, [(0.0, b"".join(said)), (0.1, vehicle.highres(0.4))])
    np.testing.assert_array_equal(blocks[-1].values, np.float32([[0.4, -0.25, 0.5]]).astype(float) * 1e5)
    assert lost == {"bad frame": 1}


def test_a_wrong_checksum_and_a_lost_message_give_no_value_and_are_counted() -> None:
    vehicle = Vehicle()
    frames = [vehicle.highres(0.1 * k) for k in range(6)]
    broken = frames[2][:40] + bytes([frames[2][40] ^ 1]) + frames[2][41:]
    blocks, lost = heard(Mavlink, [(0.0, frames[0] + broken + frames[4]), (0.1, b"noise" + frames[5] + bytes(8))])
    assert sum(len(b) for b in blocks) == 3
    assert lost == {"gap": 3}


TELEMETRY: dict[str, tuple[Any, dict[str, float]]] = {
    "SYS_STATUS": (
        mav.MAVLink_sys_status_message(0, 0, 0, 0, 11_900, 1234, 80, *(0,) * 6),
        {"i_battery": 12.34, "v_battery": 11.9},
    ),
    "SYS_STATUS of one who does not know": (mav.MAVLink_sys_status_message(0, 0, 0, 0, 65535, -1, 80, *(0,) * 6), {}),
    "BATTERY_STATUS": (
        mav.MAVLink_battery_status_message(0, 0, 0, 3150, [4000] * 10, 900, 0, 0, 50),
        {"temp_battery": 31.5},
    ),
    "BATTERY_STATUS of the second": (
        mav.MAVLink_battery_status_message(1, 0, 0, 32767, [4000] * 10, 900, 0, 0, 50),
        {"i_battery_2": 9.0},
    ),
    "ESC_TELEMETRY": (
        mav.MAVLink_esc_telemetry_5_to_8_message(*([n] * 4 for n in (25, 1200)), [150, 250, 350, 450], *[[7] * 4] * 3),
        {"i_motor_5": 1.5, "i_motor_6": 2.5, "i_motor_7": 3.5, "i_motor_8": 4.5, "rpm_5": 7.0},
    ),
    "SERVO_OUTPUT_RAW": (mav.MAVLink_servo_output_raw_message(0, 0, 1100, *(0,) * 7), {"pwm_1": 1100.0}),
}
ASKED = (
    "i_battery",
    "v_battery",
    "temp_battery",
    "i_battery_2",
    *(f"i_motor_{n}" for n in range(1, 9)),
    "rpm_5",
    "pwm_1",
)


@pytest.mark.parametrize("what", TELEMETRY)
def test_telemetry_becomes_channels_in_si_units(what: str) -> None:
    message, values = TELEMETRY[what]
    vehicle = Vehicle()
    pieces = [(0.0, vehicle.heartbeat() + vehicle.highres(0.1)), (1.0, vehicle.says(message))]
    blocks, _ = heard(Mavlink, pieces, channels=ASKED)
    found = {n: float(v) for b in blocks if b.stream == "channel" for n, v in zip(b.columns, b.values[0], strict=True)}
    assert found == pytest.approx(values)


def test_two_vehicles_are_refused_or_told_apart() -> None:
    one, two = Vehicle(1), Vehicle(2)
    both = [(0.1 * k, one.highres(0.1) + two.highres(0.2)) for k in range(5)]
    with pytest.raises(InstrumentError, match="two vehicles are heard, of system ids 1 and 2") as caught:
        heard(Mavlink, both)
    assert caught.value.fault == "another instrument"
    blocks, lost = heard(Mavlink, both, system_id=2)
    np.testing.assert_allclose(np.vstack([b.values[:, 0] for b in blocks]), 20_000, rtol=1e-6)
    assert lost == {}


def test_a_ground_station_and_a_gimbal_are_no_second_vehicle() -> None:
    vehicle = Vehicle(1)
    others = (
        Vehicle(255, 190).heartbeat(autopilot=8)
        + Vehicle(1, 154).highres(9.0)
        + Vehicle(7).says(TELEMETRY["SYS_STATUS"][0])
    )
    blocks, lost = heard(Mavlink, [(0.0, vehicle.highres(0.1) + others + vehicle.highres(0.1))])
    assert [b.stream for b in blocks] == ["dut"]
    assert lost == {}


def identified(**edits: float) -> tuple[Any, MavlinkEmulator, list[bytes]]:
    """A driver that has identified the emulator, and what it sent."""
    clock, settings = VirtualClock(datetime(2026, 1, 1, tzinfo=UTC)), Settings()
    emulator, sent = MavlinkEmulator(open_twin({}, 1), {"dut": {}}, settings), list[bytes]()
    emulator.parameters.update(edits)
    link = EmulatedLink("emulated://rig", emulator, clock)
    link.never.add(Mavlink.never)
    send = link.send
    link.send = lambda data: (sent.append(data), send(data))[1]
    driver = Mavlink("dut", link, clock, settings)
    assert driver.identify().manufacturer == "PX4"
    return driver, emulator, sent


def test_the_calibration_on_board_is_read_and_recorded() -> None:
    driver, _, sent = identified(CAL_MAG0_XOFF=0.0125, CAL_MAG0_ID=396_825)
    driver.start()
    (event,) = driver.events()
    assert event.kind == "on-board-calibration"
    assert event.data["CAL_MAG0_XOFF"] == pytest.approx(0.0125)
    assert event.data["CAL_MAG0_ID"] == 396_825  # whose bytes stand in a float
    assert event.data["CAL_MAG0_YSCALE"] == 1.0
    assert "CAL_MAG0_XOFF 0.0125" in event.text
    assert driver.events() == []
    assert {frame[5] for frame in sent} == {20}  # nothing but PARAM_REQUEST_READ
    assert sent[0][6:12] == struct.pack("<hBB", -1, 1, 1) + b"CA"


def test_a_one_way_stream_is_read_and_says_that_it_tells_nothing() -> None:
    vehicle = Vehicle()
    pieces = [(0.1 * k, vehicle.heartbeat() + vehicle.highres(0.1)) for k in range(100)]
    driver = listening(Mavlink, pieces)
    driver._link._emulator.take = lambda t_s, data: None
    assert driver.identify().model == "HIGHRES_IMU of system 1"
    driver.start()
    assert "not stated" in driver.events()[0].text


@pytest.mark.parametrize("noise", [b"", b"\xfd\xff\x00\xc0\n" * 50, bytes(range(256))])
def test_nothing_or_noise_is_silent(noise: bytes) -> None:
    with scripted(Mavlink, []) as driver:
        driver._link.give_back(0.0, noise)
        with pytest.raises(InstrumentError) as caught:
            driver.identify()
    assert caught.value.fault == "silent"


@pytest.mark.parametrize(
    ("settings", "says"),
    [
        ({"system_id": 256}, "system_id"),
        ({"channels": ("i_motor_9",)}, "i_motor_9"),
        ({"component_id": -1}, "likewise"),
    ],
)
def test_settings_that_make_no_sense_are_refused(settings: dict[str, Any], says: str) -> None:
    with pytest.raises(ValueError, match=says):
        Settings(**settings)


def test_without_pymavlink_the_refusal_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pymavlink.dialects.v20", None)
    with pytest.raises(InputError, match=r"pip install 'labcal\[mavlink\]'"):
        listening(Mavlink, [])
