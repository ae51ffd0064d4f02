"""Reference lines and RM3100 counts: units, decimal comma, own clock, fractions refused; and replayed files."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest
from listening import heard, listening

from drivers.replay import Replay
from drivers.replay import Settings as ReplaySettings
from drivers.rm3100 import Rm3100
from drivers.rm3100 import Settings as Rm3100Settings
from drivers.text_line import TextLine
from labcal.errors import InputError, InstrumentError
from labcal.twin import open_twin


def test_milligauss_with_a_decimal_comma() -> None:
    blocks, lost = heard(TextLine, [(1, b"cut;\n1,5;-200,25;0,001\r\n")], unit="mG", decimal=",", delimiter=";")
    np.testing.assert_allclose(blocks[0].values, [[150, -20025, 0.1]])
    assert blocks[0].columns == ("ref_x", "ref_y", "ref_z")
    assert lost == {}


def test_a_decimal_comma_that_is_not_stated_gives_no_value() -> None:
    for delimiter in (";", ","):
        blocks, lost = heard(TextLine, [(1, b"\n1,5;-200,25;0,001\n")], delimiter=delimiter)
        assert (blocks, lost) == ([], {"bad frame": 1})


def test_a_magnitude_alone_with_its_own_clock() -> None:
    pieces = [(0.5, b"\n"), (2.0, b"2026-01-01T00:00:05,48000.5\n"), (3.2, b"2026-01-01T00:00:06,48001\n")]
    blocks, _ = heard(TextLine, pieces, columns=("t", "f"), t_unit="iso", stamp="device", delay_s=0.1)
    np.testing.assert_allclose(blocks[0].values, [[48000.5], [48001]])
    np.testing.assert_allclose(blocks[0].t_s, [1.9, 2.9])
    assert blocks[0].columns == ("ref_f",)


@pytest.mark.parametrize(
    "settings",
    [{"columns": ("x", "y")}, {"columns": ("f", "f")}, {"columns": ("x", "y", "z", "f")}, {"stamp": "device"},
     {"delimiter": "."}, {"delimiter": ""}],
)  # fmt: skip
def test_a_map_that_makes_no_sense_is_refused(settings: dict[str, object]) -> None:
    with pytest.raises(ValueError, match=r"columns|delimiter"):
        listening(TextLine, [], **settings)


def test_rm3100_counts_become_nanotesla_by_the_cycle_count() -> None:
    blocks, _ = heard(Rm3100, [(1, b"\n7492,-7492,0\r\n")])
    np.testing.assert_allclose(blocks[0].values, [[1e5, -1e5, 0]])  # 0.3671 * 200 + 1.5 = 74.92 counts a µT
    np.testing.assert_allclose(heard(Rm3100, [(1, b"\n7500,0,0\n")], counts_per_uT=75.0)[0][0].values, [[1e5, 0, 0]])
    assert Rm3100Settings(cycle_count=50).nT_per_count == pytest.approx(1000 / 19.855)
    assert "cycle count 200" in listening(Rm3100, [(1.0, b"\n1,2,3\n")]).identify().firmware


def test_a_bridge_that_applies_a_calibration_is_refused() -> None:
    with pytest.raises(InstrumentError) as caught:
        heard(Rm3100, [(1, b"\n12.5,-3.25,40.0\n")])
    assert caught.value.fault == "wrong mode"


def test_full_scale_is_a_fault() -> None:
    for driver, line in ((Rm3100, b"\n8388607,0,0\n"), (TextLine, b"\n1000000,0,0\n")):
        with pytest.raises(InstrumentError) as caught:
            heard(driver, [(1, line)])
        assert caught.value.fault == "overloaded"


# replay


def replayed(tmp_path: Path, text: str, **settings: object) -> list[tuple[float, bytes]]:
    from drivers.emulators.replay import ReplayEmulator

    (tmp_path / "run.csv").write_text(text)
    return ReplayEmulator(open_twin({}, 1), {}, ReplaySettings(file=str(tmp_path / "run.csv"), **settings)).emit(100.0)


def test_a_file_comes_back_with_its_own_spacing(tmp_path: Path) -> None:
    pieces = replayed(tmp_path, "t_s,segment,dut_x,dut_y,dut_z\n9,a,1,2,3\n9.5,a,4,5,6\n11,a,7,8,9\n")
    assert pieces == [(0.0, b"9,1,2,3\n"), (0.5, b"9.5,4,5,6\n"), (2.0, b"11,7,8,9\n")]
    blocks, _ = heard(Replay, [(0.0, b"\n"), *pieces], file=str(tmp_path / "run.csv"))
    np.testing.assert_array_equal(blocks[0].values, [[1, 2, 3], [4, 5, 6], [7, 8, 9]])
    np.testing.assert_allclose(blocks[0].t_s, [0, 0.5, 2])


def test_only_a_file_of_a_recording_s_size_is_replayed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from drivers.emulators.replay import ReplayEmulator

    os.mkfifo(tmp_path / "pipe")
    for file in ("/dev/zero", str(tmp_path / "pipe"), str(tmp_path), str(tmp_path / "not there")):
        with pytest.raises(InputError, match="no table of samples is there"):
            heard(Replay, [], file=file)
        with pytest.raises(InputError, match="no table of samples is there"):
            ReplayEmulator(open_twin({}, 1), {}, ReplaySettings(file=file))
    monkeypatch.setattr("drivers.replay.LARGEST_BYTES", 10)
    with pytest.raises(InputError, match="is larger than"):
        replayed(tmp_path, "t,x,y,z\n1,2,3,4\n")


@pytest.mark.parametrize(
    ("text", "where"),
    [("t_s,dut_x\n1,2\n", "column y"), ("t,x,y,z\n1,2,3,4\n?,2,3,4\n", "line 3"), ("t,x,y,z\n1,2,3\n", "line 2"),
     ("", "no table")],
)  # fmt: skip
def test_a_broken_file_is_refused_with_its_line(tmp_path: Path, text: str, where: str) -> None:
    with pytest.raises(InputError, match=where):
        replayed(tmp_path, text)
