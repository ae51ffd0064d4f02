"""The trial by four: `trial.py OUT NUMBER SEED [--only SIMULATOR]… [--processes N]`.

Each of four programs that share nothing writes NUMBER runs, the loop answers, and the answers are counted for each
program on its own. What was answered is kept in OUT/SIMULATOR.jsonl; a second call goes on where the first one ended.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded: threads would only wait for each other

from counted import table
from score import put_through

HERE = Path(__file__).parent
SIMULATORS = {
    "textbook": "simulate.py",
    "magnets": "magnets.py",
    "sensor-laws": "sensor_laws.py",
    "spacecraft": "spacecraft.py",
}
DRIVEN_BY = {
    "offset-current": "load", "offset-current-squared": "levels", "offset-temperature": "temperature",
    "gain-temperature": "temperature", "offset-channel": "voltage",
}  # fmt: skip
STRANGE = ("random-walk", "telegraph", "bursts", "rate-squared")


def answered(folder: Path) -> dict[str, Any]:
    """The row of one run; one with `error` where the run ended in one."""
    try:
        row = put_through(folder)
    except Exception as error:
        truth = json.loads((folder.parent / "truth" / f"{folder.name}.json").read_text())
        row = {"run": folder.name, "truth": truth, "error": f"{type(error).__name__}: {error}"}
    row["truth"] = as_the_others(row["truth"])
    return row


def as_the_others(truth: dict[str, Any]) -> dict[str, Any]:
    """What the first program tells of its runs, in the words of the other three."""
    if "kinds" in truth:
        return truth
    kinds, channels = truth["cause"], truth["channels"]
    known = [k for k in kinds if k not in STRANGE]
    driving = {DRIVEN_BY[k] for k in kinds if k in DRIVEN_BY}
    return {
        **truth, "kinds": kinds, "cause": known, "unnamed": [k for k in kinds if k in STRANGE], "not_wrong": [],
        "rms_over_noise": dict.fromkeys(known, truth["strength"]),
        "decoys": [name for what, name in channels.items() if what not in driving],
    }  # fmt: skip


def trial_of(name: str, out: Path, number: int, seed: int, processes: int) -> list[dict[str, Any]]:
    """The rows of one program's runs, those that were there before among them."""
    runs, kept = out / name, out / f"{name}.jsonl"
    if len(list(runs.glob("b*"))) < number:
        subprocess.run([sys.executable, HERE / SIMULATORS[name], runs, str(number), str(seed)], check=True)
    rows = [json.loads(line) for line in kept.read_text().splitlines()] if kept.exists() else []
    done = {row["run"] for row in rows}
    left = [f for f in sorted(runs.glob("b*"))[:number] if f.name not in done]
    with ProcessPoolExecutor(processes) as pool, kept.open("a") as file:
        for row in pool.map(answered, left):
            rows.append(row)
            file.write(json.dumps(row) + "\n")
            file.flush()
    return rows


def main() -> None:
    """Run the trial and print a table for each program."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("out", type=Path)
    asked.add_argument("number", type=int, help="runs of each program")
    asked.add_argument("seed", type=int)
    asked.add_argument("--only", action="append", choices=list(SIMULATORS))
    asked.add_argument("--processes", type=int, default=1)
    words = asked.parse_args()
    words.out.mkdir(parents=True, exist_ok=True)
    each = {n: trial_of(n, words.out, words.number, words.seed, words.processes) for n in words.only or SIMULATORS}
    print(table(each))


if __name__ == "__main__":
    main()
