"""As what a run may be exported, by the words of a file dialog."""

from __future__ import annotations

from typing import Literal

Format = Literal["bundle", "csv", "hdf5", "mat"]
FORMATS: dict[str, Format] = {
    "Bundle (*.zip)": "bundle",
    "CSV (*.csv)": "csv",
    "HDF5 (*.h5)": "hdf5",
    "MATLAB (*.mat)": "mat",
}
