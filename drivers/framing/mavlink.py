"""MAVLink by pymavlink: whose message it is, and what of it is a reading or telemetry in SI units."""

from __future__ import annotations

import re
import struct
from dataclasses import dataclass
from typing import Any

from labcal.errors import InputError
from labcal.record.run import Quantity

HOW = "mavlink needs pymavlink; install it: pip install 'labcal[mavlink]'"
NT = {"RAW_IMU": 1.0, "SCALED_IMU": 100.0, "SCALED_IMU2": 100.0, "SCALED_IMU3": 100.0, "HIGHRES_IMU": 1e5}
SENSOR = {"RAW_IMU": 0, "SCALED_IMU": 0, "SCALED_IMU2": 1, "SCALED_IMU3": 2}  # of HIGHRES_IMU its own field says
MAG_UPDATED = 0x1C0  # of HIGHRES_IMU.fields_updated: x, y, z of the magnetometer
PX4, ARDUPILOT, NO_AUTOPILOT = 12, 3, 8  # MAV_AUTOPILOT
MAKERS = {PX4: "PX4", ARDUPILOT: "ArduPilot"}
INT32 = 6  # MAV_PARAM_TYPE
CHANNEL = re.compile(r"(i|v|temp)_battery|i_battery_[2-9]|temp_dut|(i_motor|rpm|pwm)_[1-8]")
UNITS: dict[str, tuple[Quantity, str]] = {"rpm": ("other", "rpm"), "pwm": ("other", "us")}


def dialect() -> Any:
    """ArduPilot's dialect, which has the common messages. Raises InputError where pymavlink is not installed."""
    try:
        from pymavlink.dialects.v20 import ardupilotmega
    except ImportError:
        raise InputError(HOW) from None
    return ardupilotmega


@dataclass(frozen=True, slots=True)
class Vehicle:
    """Who sends: its system id and MAV_AUTOPILOT, -1 where no heartbeat has told it yet."""

    system: int
    autopilot: int = -1

    @property
    def maker(self) -> str:
        """The firmware's name."""
        return MAKERS.get(self.autopilot, "")


def reading(message: Any, instance: int) -> tuple[float, float, float, float] | None:
    """Its own time [s] and magnetometer x, y, z in the message's unit; None where that is not a new one."""
    if message.get_type() == "HIGHRES_IMU" and (message.id != instance or not message.fields_updated & MAG_UPDATED):
        return None
    t_s = message.time_boot_ms / 1e3 if hasattr(message, "time_boot_ms") else message.time_usec / 1e6
    return t_s, float(message.xmag), float(message.ymag), float(message.zmag)


def telemetry(message: Any) -> dict[str, float]:
    """What a message says of currents, voltages, temperatures and motors; what it calls unknown is left out."""
    kind = message.get_type()
    if kind == "SYS_STATUS":
        fields = {"i_battery": (message.current_battery, -1, 100), "v_battery": (message.voltage_battery, 0xFFFF, 1000)}
    elif kind == "BATTERY_STATUS" and message.id == 0:
        fields = {"temp_battery": (message.temperature, 0x7FFF, 100)}
    elif kind == "BATTERY_STATUS":
        fields = {f"i_battery_{message.id + 1}": (message.current_battery, -1, 100)}
    elif kind == "SERVO_OUTPUT_RAW" and message.port == 0:
        fields = {f"pwm_{n}": (getattr(message, f"servo{n}_raw"), 0, 1) for n in range(1, 9)}
    elif kind in ("ESC_TELEMETRY_1_TO_4", "ESC_TELEMETRY_5_TO_8"):
        fields = _motors(1 if "1_TO" in kind else 5, message.current, message.rpm)
    elif kind == "HIGHRES_IMU":
        fields = {"temp_dut": (message.temperature, 0, 1)}
    else:
        fields = {"temp_dut": (message.temperature, 0, 100)} if hasattr(message, "xmag") else {}
    return {name: value / scale for name, (value, unknown, scale) in fields.items() if value != unknown}


def _motors(first: int, current: Any, rpm: Any) -> dict[str, tuple[float, Any, int]]:
    fields: dict[str, tuple[float, Any, int]] = {f"i_motor_{first + k}": (i, None, 100) for k, i in enumerate(current)}
    return fields | {f"rpm_{first + k}": (turns, None, 1) for k, turns in enumerate(rpm)}


def calibration_names(vehicle: Vehicle, sensor: int) -> tuple[str, ...]:
    """The parameters that hold the calibration of magnetometer `sensor` (from 0) on board; none of another firmware."""
    if vehicle.autopilot == PX4:
        ends = ("ID", "ROT", *(f"{axis}{what}" for what in ("OFF", "SCALE", "ODIAG", "COMP") for axis in "XYZ"))
        return tuple(f"CAL_MAG{sensor}_{end}" for end in ends)
    if vehicle.autopilot == ARDUPILOT:
        n = "" if sensor == 0 else str(sensor + 1)
        names = [f"COMPASS_{what}{n}_{axis}" for what in ("OFS", "DIA", "ODI", "MOT") for axis in "XYZ"]
        return (f"COMPASS_DEV_ID{n}", *names)
    return ()


def parameter(message: Any, vehicle: Vehicle) -> tuple[str, float]:
    """Name and value of a PARAM_VALUE: PX4 puts the bytes of whole numbers into the float, others their value."""
    name = str(message.param_id).rstrip("\0")
    if vehicle.autopilot == PX4 and message.param_type == INT32:
        return name, float(struct.unpack("<i", struct.pack("<f", message.param_value))[0])
    return name, float(message.param_value)
