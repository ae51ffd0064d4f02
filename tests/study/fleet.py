"""A small fleet: sensors in a field of every direction, each with its bundle and a calibration of before."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from labcal import session
from labcal.files.atomic import write_text
from labcal.fit import fit
from labcal.record import Channel, Dut, Reference, Run, Segment
from labcal.store import write_bundle

ROWS = 400
WARMED_K, CYCLES = 8.0, 4


def build(folder: Path, number: int, *, calibrated: int | None = None, nT_per_K: Sequence[float] = ()) -> Path:
    """`number` bundles below `folder`, and calibrations of the first `calibrated`; a study file that names them.

    `nT_per_K` is what the offset along x of each follows its temperature with; nobody looked for it so far.
    """
    folder.mkdir(parents=True)
    for i in range(number):
        place = folder / f"run-{i:03d}"
        write_bundle(sensor(i, nT_per_K[i]) if nT_per_K else sensor(i), place)
        if i < (number if calibrated is None else calibrated):
            run = session.load_run(place)
            session.draft(place, fit(run, holdout=False), folder / f"cal-{i:03d}.json")
    write_text(folder / "study.toml", 'format = "labcal-study/1"\nkind = "fleet"\nruns = "."\n')
    return folder / "study.toml"


def sensor(seed: int, nT_per_K: float | None = None) -> Run:
    """It warms by 8 K, again and again, and has a thermometer where `nT_per_K` is stated."""
    draw = np.random.default_rng([seed, 21])
    ways = draw.normal(size=(ROWS, 3))
    field = 40e3 * ways / np.linalg.norm(ways, axis=1)[:, None]
    reading = (1 + 0.01 * seed) * field + 100 * seed + draw.normal(0, 25, field.shape)
    t_s = np.arange(float(ROWS))
    channels: tuple[Channel, ...] = ()
    if nT_per_K is not None:
        warm_C = 20.0 + WARMED_K * (CYCLES * t_s / ROWS % 1) ** 3
        reading[:, 0] += nT_per_K * (warm_C - 20.0)
        channels = (Channel("temp_dut", "degC", "temperature", warm_C),)
    return Run(
        run_id=f"fleet-{seed}",
        started_utc="2026-03-02T08:15:00Z",
        simulated=True,
        operator="carol",
        dut=Dut(f"SN{seed}", "model", "nT", 1.0, 25.0),
        reference=Reference("vector", noise_nT=3.0),
        segments=(Segment("all", "free", reference_frame="body"),),
        t_s=t_s,
        segment_index=np.zeros(ROWS, dtype=np.intp),
        reading=reading,
        reference_vector=field,
        reference_magnitude=None,
        angle_deg=None,
        row_mode=None,
        channels=channels,
    )


def bytes_of(out: Path) -> dict[str, bytes]:
    """Every file of a study's folder."""
    return {file.relative_to(out).as_posix(): file.read_bytes() for file in out.rglob("*") if file.is_file()}
