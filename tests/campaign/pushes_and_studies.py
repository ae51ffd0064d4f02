"""The campaign's other half: a push or a study is killed, or what it works with, at a moment that a seed says.

Afterwards the same is done again, and what is there must be what one that nobody disturbed leaves: the same rows,
bundles and audit log, the same bytes of a study. One line of JSON each; `make campaign`, or parts of it:

`PYTHONPATH=tests/archive:tests/study python tests/campaign/pushes_and_studies.py --out campaign-out [--kinds WORD…]`
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Mapping
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from dask_cluster import Cluster, cluster_of
from fleet import build, bytes_of
from made_lab import signed_calibrations, stored_runs
from postgres import Server, server

from labcal import audit
from labcal.errors import InputError
from labcal.session import archiving
from labcal.study.run import run_study

FORK = multiprocessing.get_context("fork")
RUNS, SAMPLES, SIGNED, JOBS = 12, 400, 4, 6
WITHIN_S = 1800  # for a push that hangs, not for a busy machine
COMPARED = ("run", "kept_head", "instrument", "calibration", "effect", "parameter", "document")
WHEN = {"pushed_utc"}  # differs by itself
Said = dict[str, Any]


@dataclass
class Place:
    """What all trials share: a server, a lab to be pushed, what comes of it undisturbed; a study, and its bytes."""

    folder: Path
    stack: ExitStack
    used: int = 0

    def new(self) -> Path:
        """An empty folder of a trial."""
        self.used += 1
        (made := self.folder / f"trial-{self.used}").mkdir()
        return made

    @cached_property
    def server(self) -> Server:
        return self.stack.enter_context(server(hasty=False))

    @cached_property
    def lab(self) -> Path:
        """A home with finished runs and signed calibrations."""
        home = self.folder / "lab"
        os.environ["LABCAL_HOME"] = str(home)
        stored_runs(range(RUNS), SAMPLES)
        signed_calibrations(SIGNED)
        return home

    @cached_property
    def pushed(self) -> Mapping[str, Any]:
        """What is there when nobody disturbs a push, and how long it takes."""
        url, home = self.begun()
        begun = time.monotonic()
        assert pushed_in_a_process(url).wait() == (0, "")
        return {"took_s": time.monotonic() - begun, **self.there(url, home)}

    @cached_property
    def study(self) -> Path:
        return build(self.folder / "fleet", JOBS)

    @cached_property
    def bytes(self) -> Mapping[str, bytes]:
        """What one process makes of the study."""
        run_study(self.study, out := self.new(), processes=1)
        return bytes_of(out)

    def begun(self) -> tuple[str, Path]:
        """An archive with nothing in it, and a copy of the lab, which is labcal's home from now on."""
        folder, lab = self.new(), self.lab
        shutil.copytree(lab, home := folder / "home")
        os.environ["LABCAL_HOME"] = str(home)
        url = f"{self.server.url(self.server.database())}&bundles={folder / 'bundles'}&site=here"
        archiving.init_archive(url, None)
        return url, home

    def there(self, url: str, home: Path) -> Mapping[str, Any]:
        """What an archive holds, but for the time of the push; whether its log is that of the lab."""
        import psycopg

        with psycopg.connect(url.partition("&")[0], row_factory=psycopg.rows.dict_row) as connection:
            asked = {
                name: connection.execute(f"SELECT * FROM labcal.{name}").fetchall() for name in (*COMPARED, "audit")
            }
        rows = {n: sorted(repr({k: v for k, v in r.items() if k not in WHEN}) for r in asked[n]) for n in COMPARED}
        log = sorted((row["number"], bytes(row["entry"])) for row in asked["audit"])
        bundles = sorted(path.name for path in home.parent.joinpath("bundles").rglob("*.zip"))
        whole = log == [(number, text) for number, text, _ in audit.stored(home)]
        return {"rows": rows, "bundles": bundles, "whole log": whole}


@dataclass(frozen=True)
class Pushing:
    """A push in a process of its own."""

    process: Any
    heard: Any

    def wait(self) -> tuple[int | None, str]:
        """How it ended, and what it said then."""
        self.process.join(WITHIN_S)
        with suppress(EOFError):  # it said nothing
            return self.process.exitcode, (self.heard.recv() if self.heard.poll() else "")
        return self.process.exitcode, ""


def pushed_in_a_process(url: str) -> Pushing:
    """Begin one: a copy of this process, which has all that it needs loaded."""
    heard, says = FORK.Pipe(duplex=False)
    process = FORK.Process(target=_push, args=(url, says))
    process.start()
    says.close()
    return Pushing(process, heard)


def _push(url: str, says: Any) -> None:
    try:
        refused = archiving.push(url).refused
    except InputError as fault:
        refused = (str(fault),)
    if refused:
        says.send(" | ".join(refused))
    os._exit(2 if refused else 0)


def cut_push(place: Place, draw: random.Random, cut: Callable[[Place, Pushing], None]) -> Said:
    """A push is cut, looked at, and done again."""
    expected = place.pushed
    url, home = place.begun()
    pushing = pushed_in_a_process(url)
    time.sleep(after_s := draw.uniform(0, 1.05) * expected["took_s"])
    cut(place, pushing)
    code, words = pushing.wait()
    half = archiving.check_archive(url, None)
    rows = {name: len(found) for name, found in place.there(url, home)["rows"].items()}
    again = pushed_in_a_process(url).wait()
    found = place.there(url, home)
    faults = [f"half there: {one}" for one in half]
    faults += [f"again: {again}"] * (again != (0, ""))
    faults += [f"other {name}" for name in found if found[name] != expected[name]]
    faults += [f"said {words!r}"] * (code == 2 and "cannot be reached" not in words)
    return {"after_s": round(after_s, 3), "code": code, "said": words, "runs_there": rows["run"], "faults": faults}


def kill_server(place: Place, pushing: Pushing) -> None:
    place.server.kill()
    pushing.process.join(1.0)  # some notice at once, some when it is back
    place.server.start()


def kill_push(place: Place, pushing: Pushing) -> None:
    pushing.process.kill()


def cut_study(place: Place, draw: random.Random, kill: Callable[[Any], None], cluster: Cluster | None) -> Said:
    """Something dies while a study is at work, which goes on, or is begun again."""
    expected, out = place.bytes, place.new()
    at, later_s, words = draw.randrange(JOBS), draw.uniform(0, 0.5), ""

    def progress(done: int, of: int) -> None:
        if done == at:
            threading.Timer(later_s, kill, [draw]).start()

    how = {"processes": 2} if cluster is None else {"scheduler": cluster.address}
    try:
        run_study(place.study, out, progress=progress, **how)
    except InputError as fault:
        words = str(fault)
        run_study(place.study, out, processes=1)
    time.sleep(later_s)
    faults = ["other bytes"] * (bytes_of(out) != expected)
    faults += [f"said {words!r}"] * (bool(words) and "is gone" not in words)
    return {"after_jobs": at, "later_s": round(later_s, 3), "said": words, "faults": faults}


def kill_a_worker(draw: random.Random) -> None:
    """As soon as there is one."""
    while not (workers := [one.pid for one in multiprocessing.active_children() if one.pid]):
        time.sleep(0.02)
    with suppress(ProcessLookupError):
        os.kill(draw.choice(workers), signal.SIGKILL)


def on_dask(place: Place, draw: random.Random, whom: str) -> Said:
    with cluster_of(2, place.new()) as cluster:
        dies = cluster.scheduler if whom == "scheduler" else draw.choice(cluster.workers)
        return cut_study(place, draw, lambda _: dies.kill(), cluster)


def whole_killed(place: Place, draw: random.Random) -> Said:
    """The study's own process is killed with its workers at work, and begun again."""
    expected, out = place.bytes, place.new()
    command = [sys.executable, "-m", "labcal", "study", str(place.study), "--out", str(out), "--processes", "2"]
    process, at, later_s = subprocess.Popen(command, stdout=-3, stderr=-3), draw.randrange(JOBS), draw.uniform(0, 0.5)
    while len(list(out.glob("jobs/*.json"))) < at and process.poll() is None:
        time.sleep(0.02)
    time.sleep(later_s)
    process.kill()
    process.wait()
    kept = run_study(place.study, out, processes=2, force=True).kept_before
    faults = ["other bytes"] * (bytes_of(out) != expected) + ["began anew"] * (kept < at)
    return {"after_jobs": at, "later_s": round(later_s, 3), "kept": kept, "said": "", "faults": faults}


KINDS: Mapping[str, Callable[[Place, random.Random], Said]] = {
    "server killed in a push": lambda place, draw: cut_push(place, draw, kill_server),
    "push killed": lambda place, draw: cut_push(place, draw, kill_push),
    "worker killed in a study": lambda place, draw: cut_study(place, draw, kill_a_worker, None),
    "study killed": whole_killed,
    "worker of Dask killed in a study": lambda place, draw: on_dask(place, draw, "worker"),
    "scheduler of Dask killed in a study": lambda place, draw: on_dask(place, draw, "scheduler"),
}


def tried(place: Place, kind: str, seed: int) -> Said:
    """One trial, as it stands in the results."""
    return {"kind": kind, "seed": seed, **KINDS[kind](place, random.Random(f"{kind} {seed}"))}


def main() -> int:
    """See above; 1 where a trial found a fault."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--out", type=Path, default=Path("campaign-out"))
    asked.add_argument("--number", type=int, default=20, help="of each kind")
    asked.add_argument("--kinds", nargs="*", default=list(KINDS), help="words of their names")
    given = asked.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    path, wrong = given.out / "pushes_and_studies.jsonl", False
    lines = path.read_text().splitlines() if path.exists() else []
    done = {(one["kind"], one["seed"]) for one in map(json.loads, lines)}
    with ExitStack() as stack, tempfile.TemporaryDirectory(prefix="labcal-campaign-") as name:
        place = Place(Path(name), stack)
        for seed in range(given.number):
            for kind in (one for one in KINDS if any(word in one for word in given.kinds) and (one, seed) not in done):
                record = tried(place, kind, seed)
                with path.open("a") as file:
                    file.write(json.dumps(record) + "\n")
                wrong = wrong or bool(record["faults"])
                print(f"{kind} {seed}: {'; '.join(record['faults']) or 'well'} {record}", flush=True)
    return int(wrong)


if __name__ == "__main__":
    sys.exit(main())
