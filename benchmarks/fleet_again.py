"""What a new effect would do to every certificate of a fleet: the tables of docs/study.md.

    python benchmarks/fleet_again.py [--sensors 12]

Made-up sensors of two batches: one whose offset along x follows its temperature, and one whose offset does not. They
were calibrated without looking for it; then the effect is added to each, and the loop looks for causes in each.
"""

from __future__ import annotations

import argparse
import csv
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "study"))
from fleet import build

from labcal.study.run import run_study

ADDED = 'effect = { id = "offset-temperature", channels = ["temp_dut"] }'
LOOPED = 'by = "close-loop"'


def main() -> None:
    """Build the fleet and print both tables."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--sensors", type=int, default=12)
    number = parser.parse_args().sensors
    slopes = np.where(np.arange(number) < number // 2, np.random.default_rng(7).normal(10, 3, number), 0.0)
    with tempfile.TemporaryDirectory() as place:
        folder = build(Path(place) / "fleet", number, nT_per_K=slopes.round(1).tolist()).parent
        for how in (ADDED, LOOPED):
            show(how, studied(folder, how), slopes)


def studied(folder: Path, how: str) -> list[Mapping[str, str]]:
    """The table of a study of the fleet."""
    file = folder / "again.toml"
    file.write_text(f'format = "labcal-study/1"\nkind = "fleet"\nruns = "."\n{how}\n')
    out = folder / ("added" if how == ADDED else "looped")
    print(run_study(file, out).summary.answer)
    with (out / "table.csv").open(newline="") as table:
        return list(csv.DictReader(table))


def show(how: str, rows: list[Mapping[str, str]], slopes: np.ndarray[tuple[int], np.dtype[np.float64]]) -> None:
    """A line for each sensor."""
    print(how)
    print("| sensor | truly, nT/K | effects now | offset x moves, nT | in U | worst figure | in U |")
    print("|---|---|---|---|---|---|---|")
    for row, slope in zip(rows, slopes, strict=True):
        moved, in_U = (float(row[f"offset x change ({unit})"]) for unit in ("nT", "U"))
        worst = f"{row['worst']} | {float(row['worst_change_U']):+.1f}"
        print(f"| {row['serial']} | {slope:.1f} | {row['effects'] or 'none'} | {moved:+.1f} | {in_U:+.1f} | {worst} |")


if __name__ == "__main__":
    main()
