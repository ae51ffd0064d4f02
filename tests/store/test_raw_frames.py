"""Raw frames that were recorded are parsed again by the driver that read them, and held against the samples."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from labcal.cli import execute
from labcal.record import Dut, Reference, RunHeader
from labcal.record.stream import Block
from labcal.store import Store

BENCH = (Path(__file__).parents[2] / "examples" / "simulated.toml").read_text(encoding="utf-8")
READINGS = np.array([[100.0, -200.0, 300.0], [101.0, -201.0, 301.0], [102.0, -202.0, 302.0]])
LINES = b"".join(b"%.1f,%d,%d,%d,20.1,20.2,0.5,0.1,0.2,5.0\n" % (k, *row) for k, row in enumerate(READINGS))


def recorded(readings: np.ndarray, raw: bytes, bench: str = BENCH) -> None:
    """A run of two such blocks, which the store joins to one row."""
    header = RunHeader("r1", "2026-03-02T08:15:00Z", True, "", Dut("SN1"), Reference("vector"), bench=bench)
    with Store.open() as store, store.begin(header) as writer:
        for start in (1.0, 4.0):
            t_s = start + np.arange(len(readings))
            writer.write(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), t_s, readings, raw))


def test_frames_that_say_what_was_kept_are_counted(capsys: pytest.CaptureFixture[str]) -> None:
    recorded(READINGS, LINES)
    assert execute(["check-store"]) == 0
    assert "the raw frames of 1 parsed again" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("raw", "says"),
    [
        (LINES.replace(b",-201,", b",-211,"), "that at 2.000000 s is not what its raw frame says"),
        (LINES[: LINES.index(b"\n") + 1], "their raw frames give 2"),
        (b"\0" * 40, "their raw frames"),
    ],
)
def test_samples_that_are_not_what_their_frames_say_are_told(
    raw: bytes, says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    recorded(READINGS, raw)
    assert execute(["check-store", "r1"]) == 1
    assert f"NOT SOUND: run r1: 6 samples of dut from 1 s on: {says}" in capsys.readouterr().out


TURNED = "offset_nT = [5.0, 6.0, 7.0]\ncage_from_sensor = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]\n"


@pytest.mark.parametrize(("place", "parsed"), [("dut", True), ("remote", False)])
def test_a_reference_is_compared_in_the_cage_s_axes_and_where_it_stands_elsewhere_it_is_not(
    place: str, parsed: bool, capsys: pytest.CaptureFixture[str]
) -> None:
    bench = BENCH.replace('place = "dut"', f'place = "{place}"\n{TURNED}').replace('"hmr2300"', '"text-line"')
    bench = bench.replace("settings = { rate = 20 }", "")
    assert bench.count("text-line") == 1
    header = RunHeader("r1", "2026-03-02T08:15:00Z", True, "", Dut("SN1"), Reference("vector"), bench=bench)
    off = READINGS - [5.0, 6.0, 7.0]
    kept = np.column_stack([off[:, 1], -off[:, 0], off[:, 2]])
    raw = b"".join(b"%d,%d,%d\n" % tuple(row) for row in READINGS)
    with Store.open() as store, store.begin(header) as writer:
        writer.write(Block("reference", "reference", ("ref_x", "ref_y", "ref_z"), np.arange(3.0), kept, raw))
    assert execute(["check-store"]) == 0
    assert ("parsed again" in capsys.readouterr().out) == parsed


@pytest.mark.parametrize("bench", ["", "= no toml", "name = 'no bench'", BENCH.replace('"csv-line"', '"of-others"')])
def test_an_instrument_whose_driver_is_not_here_is_left_out(bench: str, capsys: pytest.CaptureFixture[str]) -> None:
    recorded(READINGS, b"what it sent", bench)
    assert execute(["check-store"]) == 0
    assert "parsed again" not in capsys.readouterr().out
