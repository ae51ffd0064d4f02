"""pylablib at two stages: its own reading of the protocols of a Standa 8SMC and of a Trinamic TMCM."""

from __future__ import annotations

import struct
from contextlib import closing

import pytest
from pylablib.core.devio import comm_backend
from pylablib.devices.Standa import Standa8SMC
from pylablib.devices.Trinamic import TMCM1110
from served_benches import Line
from waiting import LONG_S, until

BY = "pylablib"


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits for a reply as long as a busy machine may need: a second is its own patience."""
    line = comm_backend.SerialDeviceBackend
    told = line.set_timeout
    monkeypatch.setattr(line, "set_timeout", lambda self, s: told(self, LONG_S if s else s))


@pytest.mark.met(
    "standa-8smc5", BY, "on its line of two stop bits: engine, microsteps, speeds, state; moves, a stop, homing, power"
)
def test_8smc5(line: Line) -> None:
    with closing(Standa8SMC((line.path, line.baud))) as stage:
        assert stage.get_engine_type() == ("step", "integr")
        assert stage.get_stepper_motor_calibration() == (200, 256)
        assert stage.get_status().spwr == "norm"
        stage.setup_move(speed=2_000 * 256)
        assert stage.get_move_parameters().speed == 2_000 * 256
        stage.home()
        begun = stage.get_position()
        stage.move_to(begun + 100_001)
        stage.wait_move(LONG_S)
        assert stage.get_position() == begun + 100_001
        stage.move_by(-300_002)
        stage.wait_move(LONG_S)
        assert stage.get_position() == begun - 200_001
        assert stage.get_status().scmd == ("movr", "success")
        stage.move_by(10**8)
        until(lambda: stage.get_position() > begun)
        stage.stop()
        until(lambda: not stage.is_moving())
        assert begun < stage.get_position() < begun + 10**8


@pytest.mark.met(
    "trinamic-tmcl", BY, "currents, microsteps, reference search and switches; moves, turning, a stop; no pulse divisor"
)
def test_tmcm(line: Line) -> None:
    with closing(TMCM1110((line.path, line.baud))) as module:
        module.set_axis_parameter(4, 2_000_000, addr=1)
        assert module.get_microstep_resolution(addr=1) == 256
        assert module.get_home_parameters(addr=1).mode == "lim_left"
        assert module.get_limit_switches_state(addr=1) == (False, False)
        with pytest.raises(TMCM1110.Error, match="Wrong type"):  # it counts microsteps a second
            module.get_axis_parameter(154, addr=1)
        begun = module.get_position(addr=1)
        module.move_to(begun + 100_000, addr=1)
        module.wait_move(addr=1)
        assert module.get_position(addr=1) == begun + 100_000
        module.move_by(-500, addr=1)
        module.wait_move(addr=1)
        assert module.get_position(addr=1) == begun + 99_500
        turns = struct.pack(">BBBBi", 1, 1, 0, 0, 200_000)  # ROR: until it is stopped
        module.instr.write(turns + bytes([sum(turns) % 256]))
        module.instr.read(9)
        until(lambda: module.get_position(addr=1) > begun + 100_000)
        module.stop(addr=1)
        until(lambda: not module.is_moving(addr=1))
