"""Tables of text, and what becomes of their rows: units, axes, attitudes, clocks, segments."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from foreign_files import Made, csv, mapping, table, tumble

from labcal.errors import InputError
from labcal.importers import Imported, read_mapping, take_in
from labcal.record import carry


def imported(folder: Path, made: Made, *changes: tuple[str, str], more: str = "", **columns: np.ndarray) -> Imported:
    source = csv(folder / "log.csv", table(made, **columns))
    return take_in(source, "csv", read_mapping(mapping(folder, *changes, more=more)))


def told_of(folder: Path, text: str, *changes: tuple[str, str], more: str = "") -> InputError:
    (folder / "log.csv").write_text(text)
    with pytest.raises(InputError) as caught:
        take_in(folder / "log.csv", "csv", read_mapping(mapping(folder, *changes, more=more)))
    return caught.value


def test_a_table_is_the_run_that_it_says(tmp_path: Path) -> None:
    made = tumble()
    found = imported(tmp_path, made, more='[channels.temp_dut]\ncolumn = "temp"\nunit = "degC"\n')
    assert found.remarks == ()
    assert np.array_equal(found.run.reading, made.reading)
    assert np.array_equal(found.run.channel("temp_dut").values, made.temperature_C)
    assert found.run.segments[0].reference_frame == "body"
    assert found.run.run_id == "log"


@pytest.mark.parametrize(("unit", "nT"), [("uT", 1e3), ("mG", 100.0), ("G", 1e5), ("T", 1e9), ("mT", 1e6)])
def test_every_unit_of_field_comes_to_nanotesla(unit: str, nT: float, tmp_path: Path) -> None:
    made = tumble(60)
    scaled = Made(made.t_s, made.reading / nT, made.reference, made.temperature_C)
    run = imported(tmp_path, scaled, ('unit = "nT"\n\n[ref', f'unit = "{unit}"\n\n[ref')).run
    assert np.allclose(run.reading, made.reading, rtol=1e-12)


def test_axes_are_turned_as_stated(tmp_path: Path) -> None:
    made = tumble()
    mounted = Made(made.t_s, made.reading[:, [1, 0, 2]] * [1, 1, -1], made.reference, made.temperature_C)
    axes = ('unit = "nT"\n\n[ref', 'unit = "nT"\naxes = ["y", "x", "-z"]\n\n[ref')
    assert np.array_equal(imported(tmp_path, mounted, axes).run.reading, made.reading)


@pytest.mark.parametrize("form", ["semicolons and commas", "tabs", "blanks", "no header", "comments and empty lines"])
def test_tables_as_loggers_write_them(form: str, tmp_path: Path) -> None:
    made = tumble(50)
    columns, changes, more = table(made), [], ""
    path = tmp_path / "log.csv"
    if form == "semicolons and commas":
        csv(path, columns, ";")
        path.write_text(path.read_text().replace(".", ","))
        more = '[csv]\ndecimal = ","\n'
    elif form == "no header":
        csv(path, columns, header=False)
        names = {"t": "1", "mx": "2", "my": "3", "mz": "4", "rx": "5", "ry": "6", "rz": "7"}
        changes = [(f'"{old}"', f'"{new}"') for old, new in names.items()]
    elif form == "comments and empty lines":
        csv(path, columns)
        path.write_text("a logger's own first line\n# made by hand\n\n" + path.read_text().replace("\n", "\n\n"))
        more = "[csv]\nskip_lines = 1\n"
    else:
        csv(path, columns, "\t" if form == "tabs" else " ")
    run = take_in(path, "csv", read_mapping(mapping(tmp_path, *changes, more=more))).run
    assert np.array_equal(run.reading, made.reading)


def test_dates_are_the_start_and_count_from_there(tmp_path: Path) -> None:
    made = tumble(40)
    rows = [f"2026-03-02T08:15:{t:09.6f}Z,{','.join(map(str, [*m, *r]))}"
            for t, m, r in zip(made.t_s, made.reading, made.reference, strict=True)]  # fmt: skip
    (tmp_path / "log.csv").write_text("t,mx,my,mz,rx,ry,rz\n" + "\n".join(rows) + "\n")
    changes = (('started_utc = "2026-03-02T08:15:00Z"\n', ""), ('unit = "s"', 'unit = "iso"'))
    run = take_in(tmp_path / "log.csv", "csv", read_mapping(mapping(tmp_path, *changes))).run
    assert run.started_utc == "2026-03-02T08:15:00Z"
    assert np.allclose(run.t_s, made.t_s, atol=1e-6)


@pytest.mark.parametrize("maps", ["cage-to-body", "body-to-cage"])
@pytest.mark.parametrize("order", ["wxyz", "xyzw"])
def test_a_quaternion_carries_the_cage_s_field_into_the_body(maps: str, order: str, tmp_path: Path) -> None:
    """A turn about z by θ: what stands in the cage is seen turning the other way, b_x = cos θ B_x + sin θ B_y."""
    t = np.arange(200) * 0.1
    theta = 0.4 * t
    field = np.array([20e3, 0.0, -40e3])
    body = np.column_stack([np.cos(theta) * field[0], -np.sin(theta) * field[0], np.full(200, field[2])])
    noise = np.random.default_rng(1).normal(0, 3, body.shape)
    made = Made(t, body + [100, 200, 300] + noise, np.tile(field, (200, 1)), np.zeros(200))
    half = theta / 2 if maps == "body-to-cage" else -theta / 2
    q = {"qw": np.cos(half), "qx": 0 * t, "qy": 0 * t, "qz": np.sin(half)}
    q = {name: np.where(t > 5, -value, value) for name, value in q.items()}  # -q is the same attitude
    names = ", ".join(f'"q{letter}"' for letter in order)
    more = f'[attitude]\ncolumns = [{names}]\norder = "{order}"\nmaps = "{maps}"\n'
    run = imported(tmp_path, made, ('frame = "body"', 'frame = "cage"'), more=more, **q).run
    assert run.segments[0].reference_frame == "body"
    assert np.allclose(carry(run).vector, body, atol=1e-6)


def test_an_attitude_that_stands_is_the_segment_s_own(tmp_path: Path) -> None:
    made = tumble(60)
    still = Made(made.t_s, made.reference[:, [1, 2, 0]] + 50, made.reference, made.temperature_C)
    q = dict(zip(("qw", "qx", "qy", "qz"), (0.5, -0.5, -0.5, -0.5), strict=True))  # x to z, y to x, z to y
    more = '[attitude]\ncolumns = ["qw", "qx", "qy", "qz"]\norder = "wxyz"\nmaps = "cage-to-body"\n'
    columns = {name: np.full(60, value) for name, value in q.items()}
    run = imported(tmp_path, still, ('frame = "body"', 'frame = "cage"'), more=more, **columns).run
    assert run.segments[0].kind == "static"
    assert np.allclose(run.segments[0].body_from_cage, [[0, 1, 0], [0, 0, 1], [1, 0, 0]])
    assert np.allclose(carry(run).vector, made.reference[:, [1, 2, 0]])


def test_a_reference_in_a_file_of_its_own_with_a_clock_of_its_own(tmp_path: Path) -> None:
    made = tumble()
    theirs = table(made)
    csv(tmp_path / "log.csv", {name: theirs[name] for name in ("t", "mx", "my", "mz")})
    reference = {"ms": (made.t_s[::2] - 14_400) * 1e3, **{n: theirs[n][::2] for n in ("rx", "ry", "rz")}}
    csv(tmp_path / "ref.csv", reference)
    clock = 'file = "ref.csv"\ntime = "ms"\ntime_unit = "ms"\nclock_offset_s = 14400.0\n'
    stated = mapping(tmp_path, ('kind = "vector"\n', f'kind = "vector"\n{clock}'))
    run = take_in(tmp_path / "log.csv", "csv", read_mapping(stated)).run
    assert run.reference_vector is not None
    assert np.array_equal(run.reference_vector[::2], made.reference[::2])
    between = (made.reference[0] + made.reference[2]) / 2
    assert np.allclose(run.reference_vector[1], between)


def test_segments_by_time_and_by_a_column(tmp_path: Path) -> None:
    made = tumble(100)
    more = '[[segments]]\nid = "a"\nend_s = 5.0\n[[segments]]\nid = "b"\nstart_s = 10.0\nend_s = 20.0\nmode = "on"\n'
    run = imported(tmp_path, made, more=more).run
    assert [s.id for s in run.segments] == ["a", "b"]
    assert len(run.rows(0)) == 20
    assert len(run.rows(1)) == 40
    phase = np.repeat([1.0, 2.0, 1.0], [30, 30, 40])
    column = ("[dut]", 'segment_column = "phase"\n[dut]')
    run = imported(tmp_path, made, column, phase=phase).run
    assert [s.id for s in run.segments] == ["1.0", "2.0", "1.0-2"]


def test_a_segment_without_an_end_lasts_until_the_next_begins(tmp_path: Path) -> None:
    named = zip("cab", (15.0, 0.0, 5.0), strict=True)
    more = "".join(f'[[segments]]\nid = "{name}"\nstart_s = {start}\n' for name, start in named)
    run = imported(tmp_path, tumble(100), more=more).run  # 25 s
    assert {segment.id: len(run.rows(i)) for i, segment in enumerate(run.segments)} == {"a": 20, "b": 40, "c": 40}


def test_what_lies_in_no_segment_is_said(tmp_path: Path) -> None:
    more = '[[segments]]\nid = "a"\nend_s = 5.0\n[[segments]]\nid = "b"\nstart_s = 900.0\n'
    remarks = imported(tmp_path, tumble(100), more=more).remarks
    assert [one for one in remarks if "80 of 100 readings lie in none" in one]
    assert [one for one in remarks if "no reading lies in segment b" in one]


def test_a_missing_angle_is_one_missing_angle(tmp_path: Path) -> None:
    angle = np.mod(np.linspace(300.0, 420.0, 100), 360.0)
    angle[40] = np.nan
    run = imported(tmp_path, tumble(100), more='[angle]\ncolumn = "turn"\nunit = "deg"\n', turn=angle).run
    assert run.angle_deg is not None
    assert np.flatnonzero(np.isnan(run.angle_deg)).tolist() == [40]
    assert run.angle_deg[-1] == pytest.approx(420.0)


WRONG = {
    "a row too short": ("t,mx,my,mz,rx,ry,rz\n0,1,2,3,4,5,6\n1,1,2,3\n", 3, "expected 7 cells"),
    "a word for a number": ("t,mx,my,mz,rx,ry,rz\n0,1,2,3,4,5,6\n1,1,two,3,4,5,6\n", 3, "expected a number"),
    "infinity": ("t,mx,my,mz,rx,ry,rz\n0,1,2,inf,4,5,6\n", 2, "expected a number"),
    "no column": ("t,mx,my,mz,rx,ry\n0,1,2,3,4,5\n", None, "no such column"),
    "a name twice": ("t,mx,mx,mz,rx,ry,rz\n0,1,2,3,4,5,6\n", 1, "twice"),
    "no time": ("t,mx,my,mz,rx,ry,rz\n0,1,2,3,4,5,6\n,1,2,3,4,5,6\n", 3, "expected a time"),
    "backward": ("t,mx,my,mz,rx,ry,rz\n0,1,2,3,4,5,6\n2,1,2,3,4,5,6\n1,1,2,3,4,5,6\n", 4, "backward = \"drop\""),
    "the same time": ("t,mx,my,mz,rx,ry,rz\n0,1,2,3,4,5,6\n0,1,2,3,4,5,6\n", 3, "duplicates = \"drop\""),
    "a header alone": ("t,mx,my,mz,rx,ry,rz\n", None, "found none"),
    "nothing": ("", None, "empty"),
    "bytes": ("\x01\x02\x03", None, "found none"),
    "two bytes a letter": ("t,mx,my,mz\n0,1,2,3\n".encode("utf-16-le").decode(), None, "byte order mark"),
    "lines of CR alone": ("t,mx,my,mz,rx,ry,rz\r0,1,2,3,4,5,6\r", 1, "CR alone"),
    "columns without end": (",".join(map(str, range(5000))) + "\n", None, "more than 4096"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_a_table_that_is_wrong_is_told_with_its_line(case: str, tmp_path: Path) -> None:
    text, line, word = WRONG[case]
    error = told_of(tmp_path, text)
    assert error.line == line
    assert word in str(error)


def test_stamps_that_do_not_grow_are_left_out_where_the_mapping_says_so(tmp_path: Path) -> None:
    made = tumble(50)
    t = made.t_s.copy()
    t[[10, 20]] = [t[9], t[5]]
    jumpy = Made(t, made.reading, made.reference, made.temperature_C)
    drop = ('unit = "s"', 'unit = "s"\nduplicates = "drop"\nbackward = "drop"')
    run = imported(tmp_path, jumpy, drop).run
    assert len(run) == 48
    assert np.array_equal(run.reading, np.delete(made.reading, [10, 20], axis=0))


def test_a_file_outside_the_recording_s_folder_is_refused(tmp_path: Path) -> None:
    for name in ("../ref.csv", "/etc/passwd"):
        with pytest.raises(InputError, match="own folder"):
            imported(tmp_path, tumble(20), ('kind = "vector"\n', f'kind = "vector"\nfile = "{name}"\n'))


def test_columns_of_a_matlab_file_that_are_not_of_one_length(tmp_path: Path) -> None:
    from scipy.io import savemat

    made = tumble(50)
    values = table(made)
    savemat(tmp_path / "log.mat", values | {"my": made.reading[:-1, 1]})
    with pytest.raises(InputError, match="has 49 values, mx has 50"):
        take_in(tmp_path / "log.mat", "mat", read_mapping(mapping(tmp_path)))


def test_a_matlab_file_that_grows_beyond_reason_is_not_unpacked(tmp_path: Path) -> None:
    from scipy.io import savemat

    savemat(tmp_path / "log.mat", {"t": np.zeros(2_500_000)}, do_compression=True)
    assert (tmp_path / "log.mat").stat().st_size < 200_000
    with pytest.raises(InputError, match="would grow"):
        take_in(tmp_path / "log.mat", "mat", read_mapping(mapping(tmp_path)))


def test_rows_without_stamps_have_a_rate(tmp_path: Path) -> None:
    from scipy.io import savemat

    made, rate = tumble(50), ('column = "t"\nunit = "s"', "rate_Hz = 4.0")
    columns = {name: values for name, values in table(made).items() if name != "t"}
    savemat(tmp_path / "log.mat", columns | {"rate": 4.0, "longer": np.zeros(70)})
    found = take_in(tmp_path / "log.mat", "mat", read_mapping(mapping(tmp_path, rate))).run
    assert found.t_s == pytest.approx(made.t_s)
    assert np.array_equal(found.reading, made.reading)


def test_one_row_of_several_is_taken_as_it_is_with_all_that_belongs_to_it(tmp_path: Path) -> None:
    made = tumble(50)
    found = imported(
        tmp_path,
        made,
        ('unit = "nT"\n\n[ref', 'unit = "nT"\nevery = 7\n\n[ref'),
        more='[channels.temp_dut]\ncolumn = "temp"\nunit = "degC"\n',
    ).run
    assert found.t_s == pytest.approx(made.t_s[::7])
    assert np.array_equal(found.reading, made.reading[::7])
    assert np.array_equal(found.reference_vector, made.reference[::7])
    assert np.array_equal(found.channel("temp_dut").values, made.temperature_C[::7])
