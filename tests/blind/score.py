"""Put blind runs through the loop and score them: `python score.py RUNS [--json FILE]`."""

from __future__ import annotations

import csv
import json
import os
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small; two processes share the cores

import numpy as np

from labcal.certificate import apply_file
from labcal.fit import draft_calibration
from labcal.loop import close_loop
from labcal.store import load_bundle

STRANGE = ("random-walk", "telegraph", "bursts", "rate-squared")
Row = dict[str, Any]


def put_through(folder: Path) -> Row:
    """Verdict, causes and fresh error of one run."""
    bundle = load_bundle(folder / "bundle")
    run = bundle.run()
    start = time.process_time()
    closed = close_loop(run)
    seconds = time.process_time() - start
    with tempfile.TemporaryDirectory() as scratch:
        made = draft_calibration(run, closed.fit(), bundle.sha256)
        apply_file(made, folder / "fresh.csv", Path(scratch) / "out.csv")
        with (Path(scratch) / "out.csv").open() as file:
            rows = list(csv.DictReader(file))
        field = np.array([[float(row[name]) for name in ("b_x", "b_y", "b_z")] for row in rows])
        stated, flagged = np.array([float(row["u_nT"]) for row in rows]), np.array([bool(row["flag"]) for row in rows])
    truth = np.loadtxt(folder / "truth_fresh.csv", delimiter=",")
    wrong = np.linalg.norm(field - truth, axis=1)
    if closed.residual_kind == "scalar":
        wrong = np.linalg.norm(field, axis=1) - np.linalg.norm(truth, axis=1)
    components = 1 if closed.residual_kind == "scalar" else 3
    truth_json = json.loads((folder.parent / "truth" / f"{folder.name}.json").read_text())
    knew = truth_json["knowing_magnitude_rms_nT" if closed.residual_kind == "scalar" else "knowing_rms_nT"]
    return {
        "run": folder.name,
        "truth": truth_json,
        "verdict": closed.verdict,
        "named": [e.effect for e in closed.accepted],
        "channels": [list(e.channels) for e in closed.accepted],
        "rivals": [[r.effect for r in e.rivals] for e in closed.accepted],
        "floor": closed.noise_floor_nT,
        "before": closed.before.holdout_rms_nT,
        "after": closed.after.holdout_rms_nT,
        "fresh": _rms(wrong),
        "fresh_within": _rms(wrong[~flagged]),  # of rows without a flag
        "knew": knew,
        "flagged": float(flagged.mean()),
        "over_stated": _rms(wrong[~flagged]) / _rms(np.sqrt(components) * stated[~flagged]),  # of rows without a flag
        "seconds": seconds,
    }


def _rms(values: np.ndarray) -> float:
    return float(np.sqrt(np.nanmean(values**2))) if len(values) else float("nan")


def attempted(folder: Path) -> Row | None:
    """The row, or None and a word on stderr where the run ended in an error."""
    try:
        return put_through(folder)
    except Exception as error:
        print(f"{folder.name}: {type(error).__name__}: {error}", file=sys.stderr)
        return None


def right(row: Row) -> bool:
    """Every cause named, or held in a stated set of at most three rivals."""
    held = [{name, *rivals} for name, rivals in zip(row["named"], row["rivals"], strict=True)]
    return all(any(cause in group and len(group) <= 3 for group in held) for cause in row["truth"]["cause"])


def wrong(row: Row) -> list[str]:
    """What was named and is not at work, nor the provisional one of a set that holds a cause."""
    causes = set(row["truth"]["cause"])
    pairs = zip(row["named"], row["rivals"], strict=True)
    return [name for name, rivals in pairs if not causes & {name, *rivals}]


def rate(rows: Sequence[Row], test: Callable[[Row], bool]) -> str:
    """A rate with its 95 % interval (Clopper & Pearson 1934)."""
    from scipy.stats import beta

    n, k = len(rows), sum(map(test, rows))
    if n == 0:
        return "none"
    low = beta.ppf(0.025, k, n - k + 1) if k else 0.0
    high = beta.ppf(0.975, k + 1, n - k) if k < n else 1.0
    return f"{k} of {n}: {100 * k / n:.1f} % ({100 * low:.1f} to {100 * high:.1f})"


def summary(rows: Sequence[Row]) -> str:
    """The rates and the confusion matrix, in Markdown."""
    known = [r for r in rows if r["truth"]["cause"] and not set(r["truth"]["cause"]) & set(STRANGE)]
    strong = [r for r in known if r["truth"]["strength"] >= 2]
    single = [r for r in strong if len(r["truth"]["cause"]) == 1]
    nothing = [r for r in rows if not r["truth"]["cause"]]
    strange = [r for r in rows if set(r["truth"]["cause"]) & set(STRANGE)]
    fresh = [r["fresh"] / r["knew"] for r in strong]
    claim = [r["after"] / r["fresh"] for r in strong if r["verdict"] == "explained"]
    lines = [
        "| what | rate (95 % interval) |",
        "|---|---|",
        f"| right cause, strength 2 and 10 | {rate(strong, right)} |",
        f"| of these, one cause alone | {rate(single, right)} |",
        f"| right cause, strength 0.5 | {rate([r for r in known if r['truth']['strength'] < 1], right)} |",
        f"| a wrong cause accepted (runs with an effect we know) | {rate(known, lambda r: bool(wrong(r)))} |",
        f"| something added to a run with nothing wrong | {rate(nothing, lambda r: bool(r['named']))} |",
        f"| one cause, ended `ambiguous` | {rate(single, lambda r: r['verdict'] == 'ambiguous')} |",
        f"| strange ones not given a known name | {rate(strange, lambda r: not r['named'])} |",
        f"| fresh error over that of a fit that knew, median | {np.median(fresh):.3f} |",
        f"| claimed held-out error over fresh error, median (10 to 90 %) | {np.median(claim):.3f} "
        f"({np.percentile(claim, 10):.3f} to {np.percentile(claim, 90):.3f}) |",
        f"| seconds of processor a run, median (largest) | {np.median([r['seconds'] for r in rows]):.1f} "
        f"({max(r['seconds'] for r in rows):.1f}) |",
        "",
        *matrix(rows),
    ]
    return "\n".join(lines)


def matrix(rows: Sequence[Row]) -> list[str]:
    """At work against named."""
    counts: dict[str, Counter[str]] = {}
    for row in rows:
        cause = " + ".join(row["truth"]["cause"]) or "nothing"
        named = " + ".join(sorted(row["named"])) or f"nothing ({row['verdict']})"
        counts.setdefault(cause, Counter())[named + (" ?" if row["verdict"] == "ambiguous" else "")] += 1
    lines = ["| at work | named (? with rivals) |", "|---|---|"]
    for cause in sorted(counts):
        lines.append(f"| {cause} | {', '.join(f'{name} × {n}' for name, n in counts[cause].most_common())} |")
    return lines


def main(folder: Path, keep: Path | None) -> None:
    """Score every run under `folder`, in two processes."""
    from concurrent.futures import ProcessPoolExecutor

    runs = sorted(p for p in folder.iterdir() if (p / "bundle").is_dir())
    with ProcessPoolExecutor(2) as pool:
        rows = [row for row in pool.map(attempted, runs, chunksize=4) if row is not None]
    if keep is not None:
        keep.write_text(json.dumps(rows))
    print(summary(rows))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[3]) if len(sys.argv) > 3 else None)
