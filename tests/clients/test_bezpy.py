"""bezpy's reader of IAGA-2002 at what our emulated observatory writes."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from bezpy.mag import read_iaga

from drivers.emulators.iaga_2002 import IagaEmulator
from drivers.framing.mishaps import Mishaps
from drivers.iaga_2002 import Parser, Settings

READINGS = 20
FIELD = SimpleNamespace(  # it turns and grows, so that no two readings are one
    reference_nT=lambda t: np.column_stack([21e3 * np.cos(0.02 * t), -900 - 7.3 * t, 43e3 + 1.7 * t]),
    reference_nT_per_unit=1.0,
)
FORMS = [
    Settings(station="LAB", stamp="utc"),
    Settings(station="LAB", stamp="utc", elements="HDZF", reads="HDZ"),
]


@pytest.mark.met("iaga-2002", "bezpy", "head, and 20 rows: times, north, east and down as our driver has them")
@pytest.mark.parametrize("settings", FORMS, ids=["XYZF", "HDZF"])
@pytest.mark.filterwarnings("ignore::FutureWarning")  # of pandas, at the other's calls
def test_an_observatory(settings: Settings, tmp_path: Path) -> None:
    said = IagaEmulator(FIELD, {}, settings).emit(READINGS + 0.5)
    file = tmp_path / "lab20260101vsec.sec"
    file.write_bytes(b"".join(data for _, data in said))
    theirs, head = read_iaga(file, return_header=True)
    assert (head["iaga code"], head["reported"]) == ("LAB", settings.elements)
    ours = Parser("observatory", settings, Mishaps("observatory")).feed(said)
    values, utc_s = np.vstack([block.values for block in ours]), np.concatenate([block.t_s for block in ours])
    assert utc_s.tolist() == [moment.timestamp() for moment in theirs.index.tz_localize("UTC")]
    assert len(values) == len(theirs) >= READINGS
    assert values == pytest.approx(theirs[["X", "Y", "Z"]].to_numpy(), abs=1e-6)
    assert np.ptp(values, axis=0).min() > 0.0
