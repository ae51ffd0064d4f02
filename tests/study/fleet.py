"""A small fleet: sensors in a field of every direction, each with its bundle and a calibration of before."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from labcal import session
from labcal.files.atomic import write_text
from labcal.fit import fit
from labcal.record import Dut, Reference, Run, Segment
from labcal.store import write_bundle

ROWS = 400


def build(folder: Path, number: int, *, calibrated: int | None = None) -> Path:
    """`number` bundles below `folder`, and calibrations of the first `calibrated`; a study file that names them."""
    folder.mkdir()
    for i in range(number):
        place = folder / f"run-{i:03d}"
        write_bundle(sensor(i), place)
        if i < (number if calibrated is None else calibrated):
            run = session.load_run(place)
            session.draft(place, fit(run, holdout=False), folder / f"cal-{i:03d}.json")
    write_text(folder / "study.toml", 'format = "labcal-study/1"\nkind = "fleet"\nruns = "."\n')
    return folder / "study.toml"


def sensor(seed: int) -> Run:
    draw = np.random.default_rng([seed, 21])
    ways = draw.normal(size=(ROWS, 3))
    field = 40e3 * ways / np.linalg.norm(ways, axis=1)[:, None]
    reading = (1 + 0.01 * seed) * field + 100 * seed + draw.normal(0, 25, field.shape)
    return Run(
        run_id=f"fleet-{seed}",
        started_utc="2026-03-02T08:15:00Z",
        simulated=True,
        operator="",
        dut=Dut(f"SN{seed}", "model", "nT", 1.0, 25.0),
        reference=Reference("vector", noise_nT=3.0),
        segments=(Segment("all", "free", reference_frame="body"),),
        t_s=np.arange(float(ROWS)),
        segment_index=np.zeros(ROWS, dtype=np.intp),
        reading=reading,
        reference_vector=field,
        reference_magnitude=None,
        angle_deg=None,
        row_mode=None,
        channels=(),
    )


def bytes_of(out: Path) -> dict[str, bytes]:
    """Every file of a study's folder."""
    return {file.relative_to(out).as_posix(): file.read_bytes() for file in out.rglob("*") if file.is_file()}
