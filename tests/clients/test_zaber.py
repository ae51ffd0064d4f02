"""Zaber's own two libraries at the emulated stage: zaber-motion, and the older zaber.serial."""

from __future__ import annotations

from contextlib import closing

import pytest
from served_benches import Line
from waiting import until
from zaber.serial import AsciiDevice, AsciiSerial
from zaber_motion import CommandFailedException
from zaber_motion.ascii import Connection, WarningFlags

TURN = 1_536_000  # microsteps


@pytest.mark.met("zaber", "zaber-motion", "axis count, homing, moves, velocity, stop, warnings, a refused move")
def test_zaber_motion(line: Line) -> None:
    with Connection.open_serial_port(line.path, line.baud) as connection:
        connection.default_request_timeout = 15_000
        device = connection.get_device(1)
        axis = device.get_axis(1)
        assert device.settings.get("system.axiscount") == 1
        axis.home()
        assert axis.is_homed()
        assert axis.get_position() == 0
        axis.move_absolute(TURN // 48)
        assert axis.get_position() == TURN // 48
        axis.move_velocity(50_000)
        assert axis.is_busy()
        axis.stop()
        assert not axis.is_busy()
        assert WarningFlags.NO_REFERENCE_POSITION not in axis.warnings.get_flags()
        with pytest.raises(CommandFailedException):
            device.generic_command("move abs nowhere", axis=1)


@pytest.mark.met("zaber", "zaber.serial", "renumbered replies, a setting, homing, a move waited for, a refused word")
def test_zaber_serial(line: Line) -> None:
    with closing(AsciiSerial(line.path, line.baud, timeout=15)) as port:
        stage = AsciiDevice(port, 1)
        assert stage.send("get limit.cycle.dist").data == str(TURN)
        assert stage.home().reply_flag == "OK"
        assert stage.move_abs(TURN // 90).reply_flag == "OK"
        stage.poll_until_idle()
        assert stage.get_position() == TURN // 90
        assert stage.send("nonsense").reply_flag == "RJ"
        until(lambda: stage.get_status() == "IDLE")
