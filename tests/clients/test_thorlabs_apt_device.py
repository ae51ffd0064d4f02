"""thorlabs-apt-device at the emulated K10CR1, by the status that the stage sends by itself."""

from __future__ import annotations

from contextlib import closing
from typing import Any

import pytest
from served_benches import Line
from thorlabs_apt_device.devices.aptdevice_motor import APTDevice_Motor
from thorlabs_apt_device.enums import EndPoint
from waiting import until

COUNTS_PER_DEG = 409_600 / 3  # of a K10CR1, by its maker
PER_S = 53.68 * COUNTS_PER_DEG  # its velocities in counts of time, likewise


@pytest.mark.met("thorlabs-apt", "thorlabs-apt-device", "velocities, homing, a move, a stop, by status updates")
def test_k10cr1(line: Line) -> None:
    opened = APTDevice_Motor(
        line.path, home=False, controller=EndPoint.USB, bays=(EndPoint.USB,), status_updates="auto"
    )
    with closing(opened) as stage:

        def state() -> dict[str, Any]:
            return dict(stage.status_[0][0])

        until(lambda: stage.velparams_[0][0]["max_velocity"] > 0)
        stage.set_enabled(True)
        until(lambda: state()["channel_enabled"])
        stage.home()
        until(lambda: state()["homed"] and not state()["homing"])
        stage.move_absolute(round(5 * COUNTS_PER_DEG))
        until(lambda: state()["moving_forward"])
        until(lambda: abs(state()["position"] - 5 * COUNTS_PER_DEG) <= 1 and not state()["moving_forward"])
        stage.move_absolute(round(300 * COUNTS_PER_DEG))
        until(lambda: state()["moving_forward"])
        stage.stop()
        until(lambda: not state()["moving_forward"])
        assert 5 * COUNTS_PER_DEG < state()["position"] < 299 * COUNTS_PER_DEG
