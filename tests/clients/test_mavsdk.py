"""MAVSDK, whose decoder is its own in C++, at the emulated vehicle: its bytes come in and go out by hand."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
import serial
from mavsdk.component_type import ComponentType
from mavsdk.mavsdk import Configuration, Mavsdk
from mavsdk.plugins.param.param import Param
from mavsdk.plugins.telemetry.telemetry import Telemetry
from served_benches import Line
from waiting import until

from drivers.mavlink import Mavlink
from drivers.mavlink import Settings as MavlinkSettings

READINGS, PX4, NT_PER_GAUSS = 20, 1, 1e5


@contextmanager
def ground_station(line: Line) -> Iterator[tuple[Any, bytearray]]:
    """A ground station on the line, and all that it has heard."""
    heard, ended = bytearray(), threading.Event()
    station = Mavsdk(Configuration.create_with_component_type(ComponentType.GROUND_STATION))
    with serial.Serial(line.path, line.baud, timeout=0.05) as port:

        def listen() -> None:
            while not ended.is_set():
                if came := port.read(4096):
                    heard.extend(came)
                    station.pass_received_raw_bytes(came)

        station.add_any_connection("raw://")
        station.subscribe_raw_bytes_to_be_sent(port.write)
        ear = threading.Thread(target=listen)
        ear.start()
        try:
            yield station, heard
        finally:
            ended.set()
            ear.join()
            station.destroy()


@pytest.mark.met(
    "mavlink",
    "MAVSDK",
    "it finds the vehicle; 20 readings: its gauss in our driver's nanotesla; CAL_MAG0_XSCALE, battery",
)
def test_a_vehicle(line: Line) -> None:
    with ground_station(line) as (station, heard):
        until(lambda: bool(station.get_systems()))
        (vehicle,) = station.get_systems()
        until(lambda: int(vehicle.autopilot_type()) == PX4)  # its next heartbeat says it
        assert vehicle.get_system_id() == 1
        told, rows = Telemetry(vehicle), list[Any]()
        told.subscribe_imu(lambda imu, _: rows.append(imu.magnetic_field_frd))
        until(lambda: len(rows) >= READINGS)
        assert told.battery().voltage_v == pytest.approx(12.0)
        assert Param(vehicle).get_param_float("CAL_MAG0_XSCALE") == 1.0
        theirs = NT_PER_GAUSS * np.array([(b.forward_gauss, b.right_gauss, b.down_gauss) for b in rows])
        ours = Mavlink.parse_again(MavlinkSettings(), bytes(heard))
    places = [k for k in range(len(ours)) if np.allclose(ours[k], theirs[0], rtol=1e-6)]
    assert any(np.allclose(ours[k : k + READINGS], theirs[:READINGS], rtol=1e-6) for k in places)
    assert (np.linalg.norm(theirs, axis=1) > 2_000.0).all()
