"""QMI (QuTech) at two stages: its drivers of an SMC100CC and of a K10CR1, which labs run."""

from __future__ import annotations

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest
from served_benches import Line
from waiting import LONG_S, until

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # its VXI-11, which nothing here asks for, loads xdrlib
    from qmi.core.context import QMI_Context
    from qmi.core.exceptions import QMI_InstrumentException, QMI_TimeoutException
    from qmi.instruments.newport.actuators import LinearActuator
    from qmi.instruments.newport.smc_100cc import Newport_SMC100CC
    from qmi.instruments.thorlabs.k10cr1 import Thorlabs_K10CR1

BY = "QMI"
TABLE = LinearActuator(-170, 170, 20, 1e-6, 1e-4, 1, 1e-3)  # a rotary one, in degrees


def rests(stage: Any) -> bool:
    """Whether a K10CR1 rests; a word that it says by itself may come where QMI waits for its status alone."""
    try:
        stage.wait_move_complete(LONG_S)
    except QMI_TimeoutException:
        return False
    return True


@contextmanager
def opened(instrument: Any) -> Iterator[Any]:
    """Open it, and close it at the end."""
    instrument.open()
    try:
        yield instrument
    finally:
        instrument.close()


@pytest.mark.met(
    "newport-smc100",
    BY,
    "version, speed, limits and time of a move; homing; moves, a stop; each word asked for its error",
)
def test_smc100(line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Newport_SMC100CC, "COMMAND_EXEC_TIME", 0.06)  # half a second after each word is long
    monkeypatch.setattr(Newport_SMC100CC, "DEFAULT_RESPONSE_TIMEOUT", LONG_S)
    stated = (f"serial:{line.path}", "42", {1: TABLE})
    with opened(Newport_SMC100CC(QMI_Context("smc100"), "stage", *stated)) as stage:

        def state() -> str:
            return str(stage.get_positioner_error_and_state()[1])

        assert stage.get_idn().model == "SMC_CC"
        if state().startswith("NOT REFERENCED"):
            with pytest.raises(QMI_InstrumentException, match="NOT REFERENCED"):
                stage.move_absolute(5.0)
            stage.home_search()
        until(lambda: state().startswith("READY"))
        assert not stage.is_in_configuration_state()
        stage.set_velocity(10.0)
        assert (stage.get_velocity(), stage.get_acceleration()) == (10.0, 80.0)
        assert stage.get_negative_software_limit() < 0 < stage.get_positive_software_limit()
        assert stage.get_motion_time(5.0) == pytest.approx(0.5 + 10.0 / 80.0)
        stage.move_absolute(5.0)
        until(lambda: state() == "READY from MOVING.")
        assert stage.get_position() == pytest.approx(5.0, abs=1e-3)
        stage.move_relative(100.0)
        stage.stop_motion()
        until(lambda: state() == "READY from MOVING.")
        assert 5.0 < stage.get_position() < 105.0


@pytest.mark.met(
    "thorlabs-apt",
    BY,
    "identity, status, velocity, homing parameters, backlash; homing, moves, a stop, each with its end",
)
def test_k10cr1(line: Line) -> None:
    with opened(Thorlabs_K10CR1(QMI_Context("k10cr1"), "stage", f"serial:{line.path}")) as stage:
        assert stage.get_idn().model == "K10CR1"
        stage.set_chan_enable_state(True)
        assert stage.get_chan_enable_state()
        assert stage.get_motor_status().channel_enabled
        stage.set_velocity(5.0)
        assert stage.get_velocity() == pytest.approx(5.0, abs=1e-6)
        assert stage.get_home_params().home_velocity == pytest.approx(10.0, abs=1e-6)
        assert stage.get_backlash_distance() == 0.0
        stage.move_home()
        until(lambda: rests(stage))
        assert (stage.get_absolute_position(), stage.get_motor_status().homed) == (0.0, True)
        for way, there in ((stage.move_absolute, 7.0), (stage.move_relative, 4.0)):
            way(7.0 if there == 7.0 else -3.0)
            until(lambda: rests(stage))
            assert stage.get_absolute_position() == pytest.approx(there, abs=1e-4)
        stage.move_relative(100.0)
        until(lambda: stage.get_absolute_position() > 5.0)
        stage.move_stop()
        until(lambda: rests(stage))
        assert 5.0 < stage.get_absolute_position() < 103.0
