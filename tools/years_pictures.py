"""The pictures of docs/years.md, each by the command that docs name, of made-up data.

    python tools/years_pictures.py [--out docs/images]

`labcal charts CS-01 --repeats 3 --baseline 20 --out …`, `labcal rr --table study.csv --out …` of the worked example of
the AIAG manual, and `labcal fleet FOLDER --out …`.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from dataclasses import asdict, replace
from importlib import import_module
from pathlib import Path

import numpy as np
from matplotlib.image import imread, imsave

from labcal import session
from labcal.certificate import calibration_bytes, read_calibration
from labcal.cli import execute as labcal
from labcal.model import AffineMap
from labcal.session.figures import SensorFigure, place_of

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests" / "years"), str(ROOT / "tests" / "quality")]
three_batches = import_module("calibrations_of_years").three_batches
AIAG = import_module("test_gage_rr").AIAG
DAYS, MOVED_AFTER, MOVED_SIGMA = 45, 25, 1.1
GOLDEN = ROOT / "tests" / "golden"


def main() -> None:
    """Draw all of them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "images")
    out = parser.parse_args().out.resolve()
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        os.environ["LABCAL_HOME"] = str(folder / "home")
        check_standard(folder)
        first_of(6, draw("charts", "CS-01", "--repeats", "3", "--baseline", "20", out=out))
        draw("rr", "--table", str(worked_example(folder)), out=out)
        draw("fleet", str(a_fleet(folder / "fleet")), out=out)


def draw(command: str, *words: str, out: Path) -> Path:
    """Call `command`, its figures written as a picture."""
    picture = out / f"years-{'gage' if command == 'rr' else command}.png"
    labcal([command, *words, "--out", str(picture), "--force"])
    print(picture)
    return picture


def first_of(quantities: int, picture: Path) -> None:
    """Keep the chart of the first quantity alone: the others look like it."""
    whole = imread(picture)
    imsave(picture, whole[: len(whole) // quantities])


def check_standard(folder: Path) -> None:
    """Three runs a day in the store, whose figures are known: they move by 1.1 sigma after 25 days."""
    draws, header = np.random.default_rng(2), json.loads((GOLDEN / "bundle-small.json").read_text())
    for day in range(DAYS):
        for repeat in range(3):
            run = folder / f"cs-{day:03}-{repeat}"
            run.mkdir()
            header["run_id"], header["dut"]["serial"] = run.name, "CS-01"
            header["started_utc"] = f"2026-{1 + day // 28:02}-{1 + day % 28:02}T{8 + repeat:02}:00:00Z"
            (run / "run.json").write_text(json.dumps(header))
            (run / "samples.csv").write_bytes((GOLDEN / "bundle-small.csv").read_bytes())
            keep_figures(session.import_bundle(run), draws.normal(MOVED_SIGMA * (day >= MOVED_AFTER), 1.0, 6))


def keep_figures(run: str, drawn: np.ndarray[tuple[int], np.dtype[np.float64]]) -> None:
    """What was worked out of this run: offsets about 10 nT, scales about 100 ppm."""
    names = [f"{kind} {axis}" for kind in ("offset", "scale") for axis in "xyz"]
    usual = [(10.0, 2.0, "nT")] * 3 + [(100.0, 20.0, "ppm")] * 3
    found = [SensorFigure(name, centre + sigma * float(one), sigma, unit)
             for name, (centre, sigma, unit), one in zip(names, usual, drawn, strict=True)]  # fmt: skip
    place = place_of(run)
    place.parent.mkdir(parents=True, exist_ok=True)
    place.write_text(json.dumps([asdict(one) for one in found]))


def a_fleet(folder: Path) -> Path:
    """Three batches, one of which follows the temperature, with scales and angles that scatter too."""
    draws = np.random.default_rng(3)
    for file in sorted(three_batches(folder).glob("*.json")):
        one = read_calibration(file)
        K = np.eye(3) + draws.normal(0, 5e-4, (3, 3))
        file.write_bytes(calibration_bytes(replace(one, affine=AffineMap(K, one.affine.k_nT))))
    return folder


def worked_example(folder: Path) -> Path:
    """Ten parts, three appraisers, three trials."""
    rows = [f"P{part},{'ABC'[who]},1,{AIAG[part, who, trial]}" for part, who, trial in np.ndindex(AIAG.shape)]
    table = folder / "study.csv"
    table.write_text("\n".join(("dut,operator,mounting,value", *rows)) + "\n")
    return table


if __name__ == "__main__":
    main()
