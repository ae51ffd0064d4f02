"""Tables as strangers bring them, through `--guess` and the import of what it wrote, with nothing corrected."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import foreign_files as foreign
import numpy as np
import pytest
from foreign_files import Made

from labcal.cli import execute as labcal
from labcal.errors import InputError
from labcal.importers import read_mapping, take_in
from labcal.record import Run
from labcal.store import read_bundle


def spreadsheet(made: Made) -> str:
    """A German one: semicolons, decimal commas, units in brackets."""
    head = "Zeit [s];Bx [µT];By [µT];Bz [µT];Ref X [nT];Ref Y [nT];Ref Z [nT];Temp. [°C]"
    values = np.column_stack([made.t_s, made.reading / 1000, made.reference, made.temperature_C])
    return "\r\n".join([head, *(";".join(f"{v:.5f}" for v in row).replace(".", ",") for row in values), ""])


def data_frame(made: Made) -> str:
    """Of a library that writes the number of each row first, under no name."""
    lines = [",timestamp,mag_x_uT,mag_y_uT,mag_z_uT,fluxgate_x_nT,fluxgate_y_nT,fluxgate_z_nT"]
    for k, t in enumerate(made.t_s):
        numbers = ",".join(f"{v:.5f}" for v in (*made.reading[k] / 1000, *made.reference[k]))
        lines.append(f"{k},2026-03-02 08:{15 + int(t) // 60:02d}:{t % 60:09.6f}+00:00,{numbers}")
    return "\n".join([*lines, ""])


def guessed(folder: Path, content: bytes) -> Run:
    """Imported as it was guessed."""
    table, mapping, out = folder / "table.csv", folder / "map.toml", folder / "bundle"
    table.write_bytes(content)
    assert labcal(["import", str(table), "--from", "csv", "--guess", "--map", str(mapping)]) == 0
    assert labcal(["import", str(table), "--from", "csv", "--map", str(mapping), "--out", str(out)]) == 0
    return read_bundle(out)


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1252", "utf-16"])
def test_a_spreadsheet_with_decimal_commas_in_any_of_its_encodings(tmp_path: Path, encoding: str) -> None:
    made = foreign.tumble()
    run = guessed(tmp_path, spreadsheet(made).encode(encoding))
    assert np.abs(run.reading - made.reading).max() < 0.1
    assert run.reference_vector is not None
    assert np.abs(run.reference_vector - made.reference).max() < 0.1
    assert np.allclose(run.t_s, made.t_s)
    assert np.allclose(run.channel("temp_c").values, made.temperature_C, atol=1e-4)


def test_a_data_frame_s_dates_are_its_clock_and_not_its_count_of_rows(tmp_path: Path) -> None:
    made = foreign.tumble()
    run = guessed(tmp_path, data_frame(made).encode())
    assert run.started_utc == "2026-03-02T08:15:00Z"
    assert np.allclose(run.t_s, made.t_s)
    assert run.reference_vector is not None
    assert np.abs(run.reference_vector - made.reference).max() < 0.1


def two_columns_of_time(made: Made) -> str:
    """Of an instrument's own program: a row of units below the names, day and time of day apart, tabs."""
    rows = ["Date\tTime\tBx\tBy\tBz\tTemp", "\t\t(nT)\t(nT)\t(nT)\tdegC"]
    for t, reading, temperature in zip(made.t_s, made.reading, made.temperature_C, strict=True):
        clock = f"08:{15 + int(t) // 60:02d}:{t % 60:09.6f}"
        rows.append("\t".join(["2026-03-02", clock, *(f"{v:.3f}" for v in (*reading, temperature))]))
    return "\n".join([*rows, ""])


def day_first(made: Made) -> str:
    """A German logger's: the day before the month, a decimal comma in the seconds too."""
    rows = ["Datum/Uhrzeit;X in nT;Y in nT;Z in nT;Temp"]
    for t, reading, temperature in zip(made.t_s, made.reading, made.temperature_C, strict=True):
        numbers = ";".join(f"{v:.3f}" for v in (*reading, temperature))
        rows.append(
            f"02.03.2026 08:{15 + int(t) // 60:02d}:{t % 60:09.6f};{numbers}".replace(".", ",").replace(",", ".", 2)
        )
    return "\r\n".join([*rows, ""])


@pytest.mark.parametrize("table", [two_columns_of_time, day_first])
def test_a_clock_as_people_write_it(tmp_path: Path, table: Callable[[Made], str]) -> None:
    made = foreign.tumble()
    run = guessed(tmp_path, table(made).encode())
    assert run.started_utc == "2026-03-02T08:15:00Z"
    assert np.allclose(run.t_s, made.t_s, atol=1e-5)
    assert run.dut.unit == "nT"
    assert np.abs(run.reading - made.reading).max() < 0.001
    assert np.allclose([c.values for c in run.channels], [made.temperature_C], atol=1e-3)


@pytest.mark.parametrize("cell", ["31.02.2026 08:15:00", "2.13.2026 08:15:00", "02/03/2026 08:15:00"])
def test_a_day_that_is_none_or_could_be_two_is_refused_with_its_line(tmp_path: Path, cell: str) -> None:
    made = foreign.tumble()
    lines = day_first(made).split("\r\n")
    table, mapping = tmp_path / "table.csv", tmp_path / "map.toml"
    table.write_text("\r\n".join(lines))
    assert labcal(["import", str(table), "--from", "csv", "--guess", "--map", str(mapping)]) == 0
    lines[3] = cell + lines[3][lines[3].index(";") :]
    table.write_text("\r\n".join(lines))
    with pytest.raises(InputError, match=r"expected a date and time in ISO 8601, or 31\.12\.2026") as caught:
        take_in(table, "csv", read_mapping(mapping))
    assert caught.value.line == 4


def refused(folder: Path, content: str, capsys: pytest.CaptureFixture[str], *, first: bool) -> str:
    """What is said where the guess (`first`), or the import of it, is refused."""
    table, mapping = folder / "table.csv", folder / "map.toml"
    table.write_text(content)
    assert labcal(["import", str(table), "--from", "csv", "--guess", "--map", str(mapping)]) == (2 if first else 0)
    if not first:
        assert labcal(["import", str(table), "--from", "csv", "--map", str(mapping)]) == 2
    return capsys.readouterr().err


def rows(made: Made, head: str, reading: np.ndarray) -> list[str]:
    values = np.column_stack([made.t_s, reading, made.reference])
    return [head, *(",".join(f"{v:.5f}" for v in row) for row in values)]


def test_a_unit_that_the_header_states_wrongly_is_named_with_the_factor(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    made = foreign.tumble()
    table = rows(made, "t_s,bx_nT,by_nT,bz_nT,rx_nT,ry_nT,rz_nT", made.reading / 1000)
    told = refused(tmp_path, "\n".join(table) + "\n", capsys, first=False)
    assert (found := re.search(r"is the unit of one of them wrong, by a factor of (\d+)", told))
    assert float(found[1]) == pytest.approx(1000, rel=0.05)


def test_axes_that_are_swapped_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = foreign.tumble()
    table = rows(made, "t,mx,my,mz,ref_x,ref_y,ref_z", made.reading[:, [1, 0, 2]] * [1, 1, -1])
    assert 'axes ["y", "x", "-z"]' in refused(tmp_path, "\n".join(table) + "\n", capsys, first=False)


def test_a_header_that_comes_again_is_named_with_its_line(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = foreign.tumble()
    table = rows(made, "t,mx,my,mz,ref_x,ref_y,ref_z", made.reading)
    told = refused(tmp_path, "\n".join([*table[:200], table[0], *table[200:], ""]), capsys, first=True)
    assert "line 201, column t: expected a number, found 't'" in told


def test_where_only_the_clock_is_missing_that_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    made = foreign.tumble()
    lines = ["Date,Time,Mag X (mG),Mag Y (mG),Mag Z (mG)"]
    for t, b in zip(made.t_s, made.reading / 100, strict=True):
        lines.append(f"03/02/2026,08:15:{t % 60:06.3f}," + ",".join(f"{v:.3f}" for v in b))
    told = refused(tmp_path, "\n".join([*lines, ""]), capsys, first=True)
    assert "Mag X (mG), Mag Y (mG), Mag Z (mG) look like a magnetometer, and no column like its clock" in told
    assert "rate_Hz" in told


def test_decimal_commas_that_the_mapping_does_not_state_are_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    table, mapping = tmp_path / "table.csv", tmp_path / "map.toml"
    table.write_text(spreadsheet(foreign.tumble()))
    assert labcal(["import", str(table), "--from", "csv", "--guess", "--map", str(mapping)]) == 0
    mapping.write_text(mapping.read_text().replace('decimal = ","', 'decimal = "."'))
    assert labcal(["import", str(table), "--from", "csv", "--map", str(mapping)]) == 2
    assert 'decimal = "," under [csv]' in capsys.readouterr().err
