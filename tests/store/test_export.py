"""Exports: what other programs read is what was recorded, and it repeats byte for byte."""

from __future__ import annotations

import io
import json
import time
from pathlib import Path

import h5py
import numpy as np
from scipy.io import loadmat

from labcal.store import export, read_bundle

GOLDEN = Path(__file__).parents[1] / "golden" / "bundle-1"


def test_hdf5_holds_every_column_with_its_unit() -> None:
    run = read_bundle(GOLDEN)
    with h5py.File(io.BytesIO(export.hdf5(run))) as file:
        samples = file["samples"]
        np.testing.assert_array_equal(samples["dut_x"][:], run.reading[:, 0])
        np.testing.assert_array_equal(samples["ref_y"][:], [1.5, np.nan, np.nan])
        assert samples["segment"].asstr()[2] == 'still, "90°"'
        assert (samples["dut_x"].attrs["unit"], samples["i_coil_x"].attrs["unit"]) == ("count", "A")
        assert json.loads(file.attrs["run_json"])["simulated"] is True


def test_mat_holds_every_column_with_its_unit() -> None:
    run = read_bundle(GOLDEN)
    content = loadmat(io.BytesIO(export.mat(run)), simplify_cells=True)
    np.testing.assert_array_equal(content["samples"]["dut_x"], run.reading[:, 0])
    np.testing.assert_array_equal(content["samples"]["angle_deg"], [0, 359.75, np.nan])
    assert list(content["samples"]["segment"]) == ["x-20uT", "x-20uT", 'still, "90°"']
    assert content["units"]["temp_dut"] == "degC"
    assert json.loads(content["run_json"])["operator"] == "Ana Müller"


def test_exports_repeat_byte_for_byte() -> None:
    run, ways = read_bundle(GOLDEN), (export.hdf5, export.mat)
    first = [write(run) for write in ways]
    time.sleep(1.1)  # formats that note the time do so in whole seconds
    for write, content in zip(ways, first, strict=True):
        assert write(run) == content, write.__name__
