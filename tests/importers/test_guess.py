"""A guessed mapping, checked by nobody, makes the run that the recording is; what is unsure is marked."""

from __future__ import annotations

from pathlib import Path

import foreign_files as foreign
import numpy as np
import pytest
from foreign_files import csv, table, tumble

from labcal.errors import InputError
from labcal.importers import read_mapping, take_in
from labcal.importers.guess import guess


def guessed(folder: Path, source: Path, format_: str) -> str:
    text = guess(source, format_)
    (folder / "map.toml").write_text(text)
    return text


@pytest.mark.parametrize(
    ("name", "suffix", "smallest_nT"),
    [
        ("ulog", "ulg", 0.01),
        ("dataflash", "bin", 51.0),
        ("rosbag", "d", 0.01),
        ("mat", "mat", 1e-6),
        ("iaga", "sec", 3.0),
    ],
)
def test_a_guess_finds_clock_columns_and_units(name: str, suffix: str, smallest_nT: float, tmp_path: Path) -> None:
    made = tumble()
    source = getattr(foreign, name)(tmp_path / f"made.{suffix}", made)
    text = guessed(tmp_path, source, name)
    assert "CHECK" in text
    run = take_in(source, name, read_mapping(tmp_path / "map.toml")).run
    assert np.nanmax(np.abs(run.reading - made.reading)) < smallest_nT
    assert run.reference.kind == {"ulog": "scalar", "dataflash": "none", "iaga": "scalar"}.get(name, "vector")


@pytest.mark.parametrize(("unit", "nT"), [("uT", 1e3), ("mG", 100.0), ("G", 1e5)])
@pytest.mark.parametrize(("clock", "per_s"), [("s", 1.0), ("ms", 1e3), ("us", 1e6)])
def test_units_by_the_earth_s_field_and_by_what_makes_a_usual_rate(
    unit: str, nT: float, clock: str, per_s: float, tmp_path: Path
) -> None:
    made = tumble()
    columns = {
        "tick": np.round(made.t_s * per_s, 3),
        **{f"mag_{a}": v / nT for a, v in zip("xyz", made.reading.T, strict=True)},
    }
    text = guessed(tmp_path, csv(tmp_path / "log.csv", columns), "csv")
    assert f'unit = "{clock}"' in text
    assert f'unit = "{unit}"' in text


@pytest.mark.parametrize("name", ["I (mA)", "I_EPS [mA]", "bus_current_mA"])
def test_a_channel_s_unit_is_the_one_that_its_header_states(name: str, tmp_path: Path) -> None:
    made = tumble()
    milliampere = 50.0 + 10 * np.sin(made.t_s)  # as ampere it would be as likely
    text = guessed(tmp_path, csv(tmp_path / "log.csv", table(made, **{name: milliampere})), "csv")
    assert f'column = "{name}"' in text
    [channel] = take_in(tmp_path / "log.csv", "csv", read_mapping(tmp_path / "map.toml")).run.channels[1:]
    assert np.nanmax(channel.values) == pytest.approx(0.06, rel=0.01)


def test_temperature_current_gravity_and_a_quaternion_are_seen(tmp_path: Path) -> None:
    made = tumble()
    n = len(made.t_s)
    half = 0.1 * made.t_s
    more = {
        "acc_x": np.full(n, 0.1), "acc_y": np.full(n, 9.7) + 0.01 * np.sin(half), "acc_z": np.full(n, 1.2),
        "qw": np.cos(half), "qx": 0 * half, "qy": 0 * half, "qz": np.sin(half),
        "i_heater_current": 0.4 + 0.1 * np.sin(half),
    }  # fmt: skip
    text = guessed(tmp_path, csv(tmp_path / "log.csv", table(made, **more)), "csv")
    assert '[channels.temp]\ncolumn = "temp"' in text
    assert "[channels.i_heater_current]" in text
    assert "# gravity, as it seems" in text
    assert "# [attitude]" in text
    run = take_in(tmp_path / "log.csv", "csv", read_mapping(tmp_path / "map.toml")).run
    assert np.array_equal(run.reading, made.reading)


def test_a_table_without_names_is_guessed_by_its_behaviour(tmp_path: Path) -> None:
    made = tumble()
    columns = table(made)
    order = ["t", "rx", "ry", "rz", "mx", "my", "mz", "temp"]
    kelvin = {**columns, "temp": columns["temp"] + 273.15, "t": columns["t"] + 1.6e9}
    text = guessed(tmp_path, csv(tmp_path / "log.csv", {name: kelvin[name] for name in order}, header=False), "csv")
    run = take_in(tmp_path / "log.csv", "csv", read_mapping(tmp_path / "map.toml")).run
    assert np.array_equal(run.reading, made.reading)
    assert run.reference_vector is not None
    assert np.array_equal(run.reference_vector, made.reference)
    assert 'unit = "K"' in text
    assert run.started_utc == "2020-09-13T12:26:40Z"


def test_where_nothing_looks_like_a_magnetometer_the_columns_are_told(tmp_path: Path) -> None:
    source = csv(tmp_path / "log.csv", {"t": np.arange(30.0), "price": np.arange(30.0) ** 2})
    with pytest.raises(InputError, match="by hand; it has t, price"):
        guess(source, "csv")


def test_a_clock_that_was_set_back_is_still_the_clock(tmp_path: Path) -> None:
    made = tumble()
    columns = table(made)
    set_back = np.where(np.arange(len(made.t_s)) < 30, made.t_s, made.t_s - 0.9)
    warming = np.round(22 + 0.01 * made.t_s, 4)  # grows from row to row as no clock here does
    source = csv(tmp_path / "log.csv", {**columns, "t": set_back, "temp": warming})
    guessed(tmp_path, source, "csv")
    with pytest.raises(InputError, match=r"column t: .*before"):
        take_in(source, "csv", read_mapping(tmp_path / "map.toml"))


def test_what_follows_the_reading_is_offered_as_its_reference_and_taken_once_it_is_stated(tmp_path: Path) -> None:
    made = tumble()
    names = {"t": "t_s", **{f"m{a}": f"m{a}_nT" for a in "xyz"}, **{f"r{a}": f"r{a}_nT" for a in "xyz"}}
    columns = {names.get(name, name): values for name, values in table(made).items()}
    swapped = {**columns, "mx_nT": columns["my_nT"], "my_nT": columns["mx_nT"]}
    source = csv(tmp_path / "log.csv", {**swapped, "angle_deg": 0 * made.t_s})
    text = guessed(tmp_path, source, "csv")
    assert "# not used: rx_nT" not in text
    assert "# not used: angle_deg" in text
    assert take_in(source, "csv", read_mapping(tmp_path / "map.toml")).run.reference.kind == "none"
    offered = text.split("in place of the kind above:\n")[1].split("\n\n")[0].replace("# ", "")
    before, _, after = text.partition('kind = "none"')
    (tmp_path / "map.toml").write_text(before + offered + "\n" + after.partition("\n\n")[2])
    with pytest.raises(InputError, match=r'with axes \["y", "x", "z"\]'):
        take_in(source, "csv", read_mapping(tmp_path / "map.toml"))
