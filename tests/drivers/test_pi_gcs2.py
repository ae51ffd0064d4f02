"""PI GCS 2: words and answers of the manual, errors by number, reference and target; at rest is not arrived."""

from __future__ import annotations

from typing import Any

import pytest

from drivers.pi_gcs2 import PiStage
from labcal.bench.driver_kit.testing import SILENT, Exchange, scripted
from labcal.errors import InstrumentError
from labcal.testing.drivers import installed
from labcal.testing.drivers.rig import DriverRig

FINE: Exchange = (b"ERR?\n", b"0\n")
WHO: Exchange = (
    b"*IDN?\n",
    b"(c)2015 Physik Instrumente (PI) GmbH & Co. KG, C-863.11, 0115500620, 1.2.1.0\n",
)
MOVE: list[Exchange] = [
    (b"VEL 1 6.00000\n", SILENT), FINE, (b"VEL? 1\n", b"1=6.000000\n"), (b"MOV 1 30.50000\n", SILENT), FINE,
]  # fmt: skip
RESTS: Exchange = (b"\x05", b"0\n")


def stage(wire: list[Exchange], **stated: Any) -> Any:
    return scripted(PiStage, wire, **stated)


def test_controller_and_unit_say_who_they_are() -> None:
    with stage([WHO, FINE, (b"SPA? 1 0x7000601\n", b"1 0x7000601=DEG\n"), FINE]) as motor:
        who = motor.identify()
    assert (who.model, who.serial, who.firmware) == ("C-863.11", "0115500620", "1.2.1.0")


def test_another_maker_and_an_axis_of_millimetres_are_refused() -> None:
    with stage([(b"*IDN?\n", b"ACME,1,2,3\n")]) as motor, pytest.raises(InstrumentError, match="no controller of PI"):
        motor.identify()
    wire = [WHO, FINE, (b"SPA? 1 0x7000601\n", b"1 0x7000601=MM\n"), FINE]
    with stage(wire) as motor, pytest.raises(InstrumentError, match="not in degrees") as caught:
        motor.identify()
    assert caught.value.fault == "wrong set-up"


def test_a_controller_that_cannot_be_asked_for_its_unit_is_taken_at_the_settings_word() -> None:
    with stage([WHO, FINE], degrees=False) as motor:
        assert motor.identify().model == "C-863.11"


def test_it_references_where_it_does_not_know_its_place_no_faster_than_allowed() -> None:
    wire = [
        (b"FRF? 1\n", b"1=0\n"), (b"SPA? 1 0x50\n", b"1 0x50=10.000000\n"), (b"SPA 1 0x50 4.00000\n", SILENT), FINE,
        (b"SPA? 1 0x50\n", b"1 0x50=4.000000\n"), (b"SVO 1 1\n", SILENT), FINE, (b"FRF 1\n", SILENT), FINE,
    ]  # fmt: skip
    with stage(wire) as motor:
        motor.home(4.0)
    with stage([(b"FRF? 1\n", b"1=1\n")]) as motor:
        motor.home(4.0)


def test_it_settles_before_it_has_arrived() -> None:
    wire = [*MOVE, (b"\x05", b"1\n"), RESTS, FINE, (b"ONT? 1\n", b"1=0\n"), RESTS, FINE, (b"ONT? 1\n", b"1=1\n"),
            (b"POS? 1\n", b"1=30.499800\n")]  # fmt: skip
    with stage(wire) as motor:
        motor.move_to(30.5, 6.0)
        assert motor.moving()
        assert motor.moving()
        assert not motor.moving()


def test_at_rest_off_the_target_is_not_arrived() -> None:
    wire = [*MOVE, RESTS, FINE, (b"ONT? 1\n", b"1=0\n"), (b"POS? 1\n", b"1=30.4\n")]
    with stage(wire, settle_s=0.0) as motor:
        motor.move_to(30.5, 6.0)
        with pytest.raises(InstrumentError, match=r"-0\.100°") as caught:
            motor.moving()
    assert caught.value.fault == "not arrived"


@pytest.mark.parametrize(("code", "says"), [(b"7", "beyond its limits"), (b"-1024", "servo went off"), (b"99", "99")])
def test_an_error_is_said_in_words_and_the_move_not_repeated(code: bytes, says: str) -> None:
    with (
        stage([*MOVE[:-1], (b"ERR?\n", code + b"\n")]) as motor,
        pytest.raises(InstrumentError, match=says) as caught,
    ):
        motor.move_to(30.5, 6.0)
    assert caught.value.fault == "stage fault"


def test_a_velocity_that_reads_back_otherwise_moves_nothing() -> None:
    wire = [*MOVE[:2], (b"VEL? 1\n", b"1=10.000000\n")]
    with stage(wire) as motor, pytest.raises(InstrumentError) as caught:
        motor.move_to(30.5, 6.0)
    assert caught.value.fault == "read-back"


def test_a_stop_is_no_error_and_another_error_with_it_is() -> None:
    with stage([(b"HLT 1\n", SILENT), (b"ERR?\n", b"10\n")]) as motor:
        motor.make_safe()
    with stage([(b"HLT 1\n", SILENT), (b"ERR?\n", b"-1024\n")]) as motor, pytest.raises(InstrumentError):
        motor.make_safe()


@pytest.mark.parametrize("driver", ["pi-gcs2", "thorlabs-apt"])
def test_homing_that_somebody_stopped_is_none(driver: str) -> None:
    rig: DriverRig = installed(driver, forbidden=[]).rig()
    rig.driver.identify()
    rig.lab.platform.move(rig.clock.now(), 40.0, 40.0)
    rig.wait(10.0)
    rig.driver.home()
    rig.wait(1.0)
    rig.driver.make_safe()
    rig.wait(3.0)
    with pytest.raises(InstrumentError, match="does not know where"):
        rig.driver.moving()


def test_pis_own_library_drives_the_emulator() -> None:
    pipython = pytest.importorskip("pipython", reason="needs pipython, which is not installed")
    gateway = pytest.importorskip("pipython.pidevice.interfaces.pigateway").PIGateway
    rig: DriverRig = installed("pi-gcs2", forbidden=[]).rig()

    class Gateway(gateway):  # type: ignore[misc,valid-type]
        timeout, connected, connectionid = 500, True, 0

        def __str__(self) -> str:
            return "rig"

        def settimeout(self, value: int) -> None: ...
        def flush(self) -> None: ...
        def close(self) -> None: ...
        def unload(self) -> None: ...

        def send(self, msg: str) -> None:
            rig.emulator.take(rig.clock.now(), msg.encode("cp1252"))

        def read(self) -> str:
            rig.wait(0.01)
            return b"".join(data for _, data in rig.emulator.emit(rig.clock.now())).decode("cp1252")

    device = pipython.GCSDevice(gateway=Gateway())
    assert "C-863.11" in device.qIDN()
    assert device.axes == ["1"]
    device.SVO("1", True)
    with pytest.raises(pipython.GCSError, match=r"(?i)unreferenced"):
        device.MOV("1", 5.0)
    device.FRF("1")
    rig.wait(1.0)
    assert device.qFRF("1") == {"1": True}
    device.VEL("1", 8.0)
    assert device.qVEL("1") == {"1": 8.0}
    device.MOV("1", 30.5)
    rig.wait(1.0)
    assert device.IsMoving("1") == {"1": True}
    rig.wait(20.0)
    assert device.qONT("1") == {"1": True}
    assert device.qPOS("1")["1"] == pytest.approx(30.5)
    with pytest.raises(pipython.GCSError, match=r"(?i)limit"):
        device.MOV("1", 1e6)
    device.MOV("1", 90.0)
    rig.wait(1.0)
    with pytest.raises(pipython.GCSError, match=r"(?i)stop"):
        device.STP()
    rig.wait(5.0)
    assert 30.5 < device.qPOS("1")["1"] < 90.0
