"""What looks wrong is named before anything is fitted: refused where it would spoil every fit, else told."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from foreign_files import Made, csv, mapping, table, tumble

from labcal.errors import InputError
from labcal.importers import Imported, read_mapping, take_in

CAGE = ('frame = "body"', 'frame = "cage"')


def imported(folder: Path, columns: Mapping[str, np.ndarray], *changes: tuple[str, str], more: str = "") -> Imported:
    source = csv(folder / "log.csv", dict(columns))
    return take_in(source, "csv", read_mapping(mapping(folder, *changes, more=more)))


def refused(
    folder: Path, columns: Mapping[str, np.ndarray], doubt: str, *changes: tuple[str, str], more: str = ""
) -> str:
    """What the import says; once the mapping accepts the doubt it goes through."""
    with pytest.raises(InputError) as caught:
        imported(folder, columns, *changes, more=more)
    told = str(caught.value)
    assert f'accept = ["{doubt}"]' in told
    assert imported(folder, columns, *changes, ("[dut]", f'accept = ["{doubt}"]\n[dut]'), more=more).run
    return told


@pytest.mark.parametrize(("stated", "factor"), [("uT", 1e3), ("mG", 100.0), ("G", 1e5)])
def test_a_wrong_unit_is_named(stated: str, factor: float, tmp_path: Path) -> None:
    told = refused(tmp_path, table(tumble()), "units", ('unit = "nT"\n\n[ref', f'unit = "{stated}"\n\n[ref'))
    assert "unit of one of them wrong" in told
    assert f"{factor:.0e}"[0] in told


def test_a_reading_with_a_large_offset_is_told_and_taken(tmp_path: Path) -> None:
    made = tumble()
    found = imported(tmp_path, table(replace(made, reading=made.reading + [300e3, 0, 0])))
    assert any("a large offset" in one for one in found.remarks)


@pytest.mark.parametrize("axes", [["y", "x", "-z"], ["x", "-y", "-z"], ["z", "x", "y"], ["-x", "y", "z"]])
def test_swapped_axes_are_named_as_the_mapping_would_state_them(axes: list[str], tmp_path: Path) -> None:
    made = tumble()
    matrix = np.array([[(-1 if a[0] == "-" else 1) * (a[-1] == b) for b in "xyz"] for a in axes], dtype=float)
    other = replace(made, reference=made.reference @ matrix)  # so that axes turn it back into the body's
    told = refused(tmp_path, table(other), "axes")
    stated = "[" + ", ".join(f'"{axis}"' for axis in axes) + "]"
    assert stated in told
    assert imported(tmp_path, table(other), (CAGE[0], f"axes = {stated}\n{CAGE[0]}")).remarks == ()


def test_an_attitude_the_other_way_round_is_named(tmp_path: Path) -> None:
    t = np.arange(300) * 0.2
    angle = 0.5 * t
    field = np.array([20e3, 3e3, -40e3])
    c, s = np.cos(angle), np.sin(angle)
    body = np.column_stack([c * field[0] + s * field[1], -s * field[0] + c * field[1], np.full(300, field[2])])
    noise = np.random.default_rng(2).normal(0, 5, body.shape)
    made = Made(t, body + noise, np.tile(field, (300, 1)), 0 * t)
    q = {"qw": np.cos(angle / 2), "qx": 0 * t, "qy": 0 * t, "qz": np.sin(angle / 2)}
    more = '[attitude]\ncolumns = ["qw", "qx", "qy", "qz"]\norder = "wxyz"\nmaps = "{}"\n'
    assert imported(tmp_path, table(made, **q), CAGE, more=more.format("body-to-cage")).remarks == ()
    told = refused(tmp_path, table(made, **q), "attitude", CAGE, more=more.format("cage-to-body"))
    assert "`maps` inverted" in told


def test_two_clocks_that_share_no_time_are_named_with_the_offset(tmp_path: Path) -> None:
    made = tumble()
    csv(tmp_path / "ref.csv", {"t": made.t_s - 14_390, **{n: v for n, v in table(made).items() if n[0] == "r"}})
    own = ('kind = "vector"\n', 'kind = "vector"\nfile = "ref.csv"\n')
    told = refused(tmp_path, table(made), "clocks", own)
    assert "two clocks" in told
    assert "clock_offset_s = 14390" in told


@pytest.mark.parametrize(
    ("offset_s", "rate_ppm"), [(1.0, 0.0), (-1.25, 0.0), (13.0, 0.0), (-7.5, 0.0), (0.0, 20_000.0)]
)
def test_a_delay_and_a_drift_between_two_streams_are_told(offset_s: float, rate_ppm: float, tmp_path: Path) -> None:
    made = tumble(500)
    theirs = made.t_s * (1 - rate_ppm * 1e-6) - offset_s
    csv(tmp_path / "ref.csv", {"t": theirs, **{n: v for n, v in table(made).items() if n[0] == "r"}})
    own = 'kind = "vector"\nfile = "ref.csv"\n'
    told = imported(tmp_path, table(made), ('kind = "vector"\n', own)).remarks
    clock = next(one for one in told if "two clocks" in one)
    assert ("clock_rate_ppm" in clock) == (rate_ppm != 0)
    if not rate_ppm:
        assert f"{offset_s:.3g} s more" in clock
    mended = f"clock_offset_s = {offset_s}\nclock_rate_ppm = {rate_ppm * (1 + rate_ppm * 1e-6)}\n"
    again = imported(tmp_path, table(made), ('kind = "vector"\n', f"{own}{mended}"))
    assert not [one for one in again.remarks if "two clocks" in one]


def test_a_constant_reading_is_refused_and_a_constant_channel_told(tmp_path: Path) -> None:
    made = tumble()
    stuck = made.reading.copy()
    stuck[:, 2] = 7.0
    assert "z is 7" in refused(tmp_path, table(replace(made, reading=stuck)), "constant")
    more = '[channels.i]\ncolumn = "i"\nunit = "mA"\n'
    told = imported(tmp_path, table(made, i=np.full(400, 5.0)), more=more).remarks
    assert told == ("channel i is 0.005 A throughout: it can explain nothing",)


def test_gaps_and_missing_values_are_counted(tmp_path: Path) -> None:
    made = tumble()
    late = replace(
        made, t_s=made.t_s + np.where(np.arange(400) >= 100, 30.0, 0) + np.where(np.arange(400) >= 300, 9, 0)
    )
    columns = table(late)
    columns["my"] = np.where(np.arange(400) % 50 == 0, np.nan, columns["my"])
    told = imported(tmp_path, columns).remarks
    assert "reading: 2 gaps, the longest 30.25 s" in told
    assert "reading: 8 of 400 rows have no value (NaN or empty)" in told


def test_a_unit_of_time_that_cannot_be_is_named(tmp_path: Path) -> None:
    columns = table(tumble())
    told = refused(tmp_path, {**columns, "t": columns["t"] * 1e6}, "time")
    assert "2.5e+05 s apart" in told


def test_milliseconds_since_1970_stated_as_seconds_are_named(tmp_path: Path) -> None:
    columns = table(tumble())
    columns["t"] = (1.77e9 + columns["t"]) * 1e3  # a sample in 250 "seconds"
    assert "no clock has counted so far" in refused(tmp_path, columns, "time")
    assert imported(tmp_path, columns, ('unit = "s"', 'unit = "ms"')).run.t_s[-1] == pytest.approx(99.75)


def test_a_good_recording_is_taken_without_a_word(tmp_path: Path) -> None:
    assert imported(tmp_path, table(tumble())).remarks == ()


def test_beside_one_magnitude_no_clock_is_blamed_for_a_disturbance(tmp_path: Path) -> None:
    from labcal.loop.close import prepare
    from labcal.loop.data.checks import check_data

    made = tumble()
    made.reading[made.t_s > 70.0] += 5000 * np.sin(made.t_s[made.t_s > 70.0])[:, None]
    site = (
        'kind = "vector"\ncolumns = ["rx", "ry", "rz"]\nunit = "nT"\nframe = "body"\n',
        'kind = "site"\nvalue_nT = 48000.0\n',
    )
    source = csv(tmp_path / "log.csv", table(made))
    problem, level, _ = prepare(take_in(source, "csv", read_mapping(mapping(tmp_path, site))).run)
    finding = check_data(problem, level)
    assert finding is None or finding.kind != "clock"


TEMPERATURE = """
[channels.temp_dut]
column = "temp_C"
unit = "K"
"""


@pytest.mark.parametrize(
    ("renamed", "stated", "says"),
    [
        ({"t": "t_s"}, ('column = "t"\nunit = "s"', 'column = "t_s"\nunit = "ms"'), "its name says s, the mapping ms"),
        ({"mx": "mx [µT]"}, ('"mx"', '"mx [µT]"'), "its name says uT, the mapping nT"),
        ({"rx": "coil_mG_x"}, ('"rx"', '"coil_mG_x"'), "its name says mG, the mapping nT"),
        ({"temp": "temp_C"}, ("[dut]", "[dut]"), "its name says degC, the mapping K"),
    ],
)
def test_a_unit_that_a_name_states_otherwise_is_told(
    renamed: dict[str, str], stated: tuple[str, str], says: str, tmp_path: Path
) -> None:
    columns = {renamed.get(name, name): values for name, values in table(tumble()).items()}
    remarks = imported(tmp_path, columns, stated, more=TEMPERATURE if "temp" in renamed else "").remarks
    [column] = renamed.values()
    assert f"column {column}: {says}: which is right?" in remarks


def test_a_unit_that_a_name_states_as_the_mapping_does_is_no_remark(tmp_path: Path) -> None:
    renamed = {"t": "t_s", "mx": "mx (nT)", "temp": "temp_C"}
    columns = {renamed.get(name, name): values for name, values in table(tumble()).items()}
    changes = (('column = "t"', 'column = "t_s"'), ('"mx"', '"mx (nT)"'))
    more = TEMPERATURE.replace('"K"', '"degC"')
    assert imported(tmp_path, columns, *changes, more=more).remarks == ()
