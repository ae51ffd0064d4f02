"""A real file of each format becomes the bundle that its recording is."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import foreign_files as foreign
import numpy as np
import pytest
from foreign_files import Made

from labcal import session
from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.record import Run
from labcal.store import read_bundle

HEAD = """format = "labcal-mapping/1"
[dut]
serial = "SN1"
"""
MAPPINGS = {
    "ulog": """[time]
column = "timestamp"
unit = "us"
[reading]
stream = "vehicle_magnetometer"
columns = ["magnetometer_ga[0]", "magnetometer_ga[1]", "magnetometer_ga[2]"]
unit = "G"
[reference]
kind = "igrf"
latitude_deg = 48.7678
longitude_deg = 11.3369
[channels.i_battery]
stream = "battery_status"
column = "current_a"
unit = "A"
""",
    "dataflash": """[time]
column = "TimeUS"
unit = "us"
[reading]
stream = "MAG:0"
columns = ["MagX", "MagY", "MagZ"]
unit = "mG"
[reference]
kind = "site"
value_nT = 48000.0
""",
    "rosbag": """[time]
column = "header.stamp"
unit = "s"
[reading]
stream = "/imu/mag"
columns = ["magnetic_field.x", "magnetic_field.y", "magnetic_field.z"]
unit = "T"
[reference]
kind = "vector"
stream = "/ref/mag"
columns = ["magnetic_field.x", "magnetic_field.y", "magnetic_field.z"]
unit = "T"
frame = "body"
""",
    "mat": """[time]
column = "log.t"
unit = "s"
[reading]
columns = ["log.mag[0]", "log.mag[1]", "log.mag[2]"]
unit = "uT"
[reference]
kind = "vector"
columns = ["log.ref[0]", "log.ref[1]", "log.ref[2]"]
unit = "uT"
frame = "body"
[channels.temp]
column = "log.T"
unit = "K"
""",
    "iaga": """[time]
column = "time"
unit = "s"
[reading]
columns = ["X", "Y", "Z"]
unit = "nT"
[reference]
kind = "scalar"
column = "F"
unit = "nT"
""",
    "imagcdf": """[time]
column = "time"
unit = "s"
[reading]
columns = ["X", "Y", "Z"]
unit = "nT"
[reference]
kind = "scalar"
stream = "GeomagneticScalarTimes"
column = "S"
unit = "nT"
""",
}
MAKERS: dict[str, Callable[[Path, Made], Path]] = {name: getattr(foreign, name) for name in MAPPINGS}
SUFFIX = {"ulog": "ulg", "dataflash": "bin", "rosbag": "ros2", "mat": "mat", "iaga": "sec", "imagcdf": "cdf"}
SMALLEST = {
    "ulog": 0.01,
    "dataflash": 50.5,
    "rosbag": 0.01,
    "mat": 1e-6,
    "iaga": 3.0,
    "imagcdf": 1e-6,
}  # what a file cuts off [nT]


def made_file(folder: Path, name: str, made: Made) -> Path:
    return MAKERS[name](folder / f"made.{SUFFIX[name]}", made)


def imported(folder: Path, name: str, made: Made) -> Run:
    source = made_file(folder, name, made)
    mapping = folder / "map.toml"
    head = HEAD if name not in ("mat", "dataflash") else f'started_utc = "2026-03-02T08:15:00Z"\n{HEAD}'
    mapping.write_text(head + MAPPINGS[name])
    out = folder / "bundle"
    assert labcal(["import", str(source), "--from", name, "--map", str(mapping), "--out", str(out)]) == 0
    return read_bundle(out)


@pytest.mark.parametrize("name", MAPPINGS)
def test_readings_and_times_are_those_of_the_file(name: str, tmp_path: Path) -> None:
    made = foreign.tumble()
    run = imported(tmp_path, name, made)
    missing = ~np.isfinite(run.reading).all(axis=1)
    assert len(run) == len(made.t_s)
    assert missing.sum() == (1 if name in ("iaga", "imagcdf") else 0)
    assert np.abs(run.reading - made.reading)[~missing].max() < SMALLEST[name]
    if name != "iaga":  # whose files have one row a second
        assert np.allclose(np.diff(run.t_s), 0.25, atol=1e-6)


def test_a_ulog_s_channel_start_and_on_board_calibration(tmp_path: Path) -> None:
    run = imported(tmp_path, "ulog", foreign.tumble())
    assert np.allclose(run.channel("i_battery").values, 2 + np.sin(run.t_s - 1), atol=1e-5)
    assert run.started_utc == "2023-06-21T06:42:52Z"
    assert "CAL_MAG0_XOFF 0.25" in run.segments[0].note
    assert "SHA-256" in run.segments[0].note


def test_an_imagcdf_s_times_are_utc_and_its_head_is_kept(tmp_path: Path) -> None:
    made = foreign.tumble()
    run = imported(tmp_path, "imagcdf", made)
    assert run.started_utc == "2024-05-10T00:00:00Z"
    assert "IagaCode: NWH" in run.segments[0].note
    known = np.isfinite(run.reference_magnitude)
    assert known.sum() > 0.9 * len(run)
    assert np.abs(run.reference_magnitude - np.linalg.norm(made.reference, axis=1))[known].max() < 1.0


def test_an_ardupilot_log_tells_what_is_applied_on_board(tmp_path: Path) -> None:
    assert "COMPASS_OFS_X 12.5" in imported(tmp_path, "dataflash", foreign.tumble()).segments[0].note


def test_a_bag_s_start_and_reference(tmp_path: Path) -> None:
    made = foreign.tumble()
    run = imported(tmp_path, "rosbag", made)
    assert run.started_utc == "2023-11-14T22:13:20Z"
    assert run.t_s[0] == 0
    assert run.reference_vector is not None
    assert np.abs(run.reference_vector - made.reference).max() < 0.01


def test_a_mat_file_s_kelvins_are_degrees_and_its_matrix_lies_either_way(tmp_path: Path) -> None:
    made = foreign.tumble()
    run = imported(tmp_path, "mat", made)
    assert np.allclose(run.channel("temp").values, made.temperature_C)
    assert run.channels[0].unit == "degC"
    assert run.reference_vector is not None
    assert np.allclose(run.reference_vector, made.reference)


def test_an_observatory_s_d_is_in_minutes_and_f_is_the_reference(tmp_path: Path) -> None:
    made = foreign.tumble()
    run = imported(tmp_path, "iaga", made)
    assert run.reference.kind == "scalar"
    assert run.started_utc == "2024-05-10T00:00:00Z"
    assert abs(run.magnitude_nT[0] - np.linalg.norm(made.reference[0])) < 0.01
    assert "Nowhere" in run.segments[0].note


def test_the_igrf_at_a_place_and_date_is_the_reference(tmp_path: Path) -> None:
    """The British Geological Survey's IGRF-14 at this place and day: 48.8 µT."""
    run = imported(tmp_path, "ulog", foreign.tumble())
    assert run.reference.kind == "scalar"
    assert run.reference.place == "computed"
    assert abs(run.magnitude_nT[0] - 48_828) < 30


def test_the_wmm_is_a_reference_with_its_error_model(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for folder in ("igrf", "wmm"):
        (tmp_path / folder).mkdir()
    igrf = imported(tmp_path / "igrf", "ulog", foreign.tumble())
    monkeypatch.setitem(MAPPINGS, "ulog", MAPPINGS["ulog"].replace('kind = "igrf"', 'kind = "wmm"'))
    run = imported(tmp_path / "wmm", "ulog", foreign.tumble())
    assert run.reference.serial.startswith("WMM20")
    assert 0 < abs(run.magnitude_nT[0] - igrf.magnitude_nT[0]) < 60
    assert igrf.reference.u_offset_nT is None
    assert 100 < run.reference.u_offset_nT < 150


@pytest.mark.parametrize("name", MAPPINGS)
def test_a_file_that_is_cut_or_damaged_is_one_sentence(
    name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    source = made_file(tmp_path, name, foreign.tumble(40))
    victim = next(source.rglob("*.db3"), None) if source.is_dir() else source
    assert victim is not None
    whole = victim.read_bytes()
    mapping = tmp_path / "map.toml"
    mapping.write_text(f'started_utc = "2026-03-02T08:15:00Z"\n{HEAD}{MAPPINGS[name]}')
    told: list[str] = []
    for number, content in enumerate(damaged(whole)):
        victim.write_bytes(content)
        for guess in (False, True):
            out = None if guess else tmp_path / f"out-{number}"
            try:
                session.import_foreign(session.ImportRequest(source, name, None if guess else mapping, guess, out))
            except InputError as error:  # and nothing else
                told.append(str(error))
        assert capfd.readouterr().err == ""  # nor does a parser print
    assert len(told) > 5
    assert all(len(one.splitlines()) == 1 and str(tmp_path) in one for one in told)


def damaged(whole: bytes) -> Iterator[bytes]:
    """The file cut at eighths, other bytes in its place, and forty wrong ones."""
    draw = np.random.default_rng(1)
    yield from (whole[: len(whole) * cut // 8] for cut in range(8))
    yield from (b"\xff" * 300, b"\0" * 4096)
    for _ in range(5):
        broken = np.frombuffer(whole, dtype=np.uint8).copy()
        broken[draw.integers(0, len(whole), 40)] = draw.integers(0, 256, 40)
        yield broken.tobytes()


@pytest.mark.parametrize(("name", "library"), [("ulog", "pyulog"), ("dataflash", "pymavlink"), ("rosbag", "rosbags")])
def test_a_library_that_is_not_there_is_named_with_what_installs_it(
    name: str, library: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    source = made_file(tmp_path, name, foreign.tumble(20))
    monkeypatch.setattr("labcal.importers.readers.find_spec", lambda _: None)
    assert labcal(["import", str(source), "--from", name, "--guess"]) == 2
    told = capsys.readouterr().err
    assert library in told
    assert "pip install 'labcal[imports]'" in told
