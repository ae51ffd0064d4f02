"""The campaign: seeded faults on served benches, one line of JSON each; `make campaign`, or parts of it.

`PYTHONPATH=tests/runner python tests/campaign/campaign.py --out campaign-out --number 20 --benches 2
[--kinds WORD…] [--minutes M]`. What is in the results already is not done again.
"""

from __future__ import annotations

import argparse
import json
import random
import re
import shutil
import signal
import subprocess
import threading
import time
import traceback
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from queue import Empty, SimpleQueue
from typing import Any

import lateness
from benches import Bench
from kinds import Kind, kinds
from trial import NotBegun, try_out
from verdict import faults

Task = tuple[Kind, int]
ATTEMPTS = 3  # a session that did not come to energise anything is begun again


def bench_of(kind: Kind, seed: int) -> str:
    """Which bench this trial is done on."""
    return kind.benches[seed % len(kind.benches)]


def results(path: Path) -> list[dict[str, Any]]:
    """What has been found so far; a last line that was cut is left out."""
    found = list[dict[str, Any]]()
    for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else ():
        try:
            found.append(json.loads(line))
        except ValueError:
            continue
    return found


def tasks(words: list[str], number: int, done: set[tuple[str, int]], first: int = 0) -> list[Task]:
    """What is left to do, a round over all kinds for each seed, mixed: whoever stops early has some of each."""
    wanted = [kind for name, kind in kinds().items() if not words or any(re.search(word, name) for word in words)]
    able = [kind for kind in wanted if not kind.needs or shutil.which(kind.needs)]
    in_turn = sorted(able, key=lambda kind: random.Random(kind.name).random())
    return [(kind, seed) for seed in range(first, first + number) for kind in in_turn if (kind.name, seed) not in done]


class Campaign:
    """Works tasks off on several benches at once; each bench is kept as long as it is healthy."""

    def __init__(self, path: Path, left: list[Task], seconds: float) -> None:
        self._path, self._until = path, time.monotonic() + seconds
        self._queues = dict[str, SimpleQueue[Task]]()
        for kind, seed in left:
            self._queues.setdefault(bench_of(kind, seed), SimpleQueue()).put((kind, seed))
        self._writing = threading.Lock()
        self._taken = threading.Lock()
        self._busy = dict[str, int]()
        self._of = code()

    def stop(self) -> None:
        """Do no more than the trials that are going on."""
        self._until = 0.0

    def run(self, benches: int) -> None:
        """Until all is done, or the time is up."""
        lateness.begin()
        workers = [threading.Thread(target=self._work) for _ in range(benches)]
        for worker in workers:
            worker.start()
        for worker in workers:
            worker.join()

    def _work(self) -> None:
        while (kind := self._next_bench()) is not None:
            bench = Bench(kind)
            try:
                for task in self._tasks(kind):
                    if not self._tried(task, bench):
                        break
            finally:
                bench.close()
                self._busy[kind] -= 1

    def _next_bench(self) -> str | None:
        """The kind of bench with most to do for those who are at it."""
        with self._taken:
            left = {kind: queue.qsize() for kind, queue in self._queues.items() if queue.qsize()}
            if not left or time.monotonic() > self._until:
                return None
            chosen = max(left, key=lambda kind: left[kind] / (1 + self._busy.get(kind, 0)))
            self._busy[chosen] = self._busy.get(chosen, 0) + 1
            return chosen

    def _tasks(self, bench: str) -> Iterator[Task]:
        while time.monotonic() < self._until:
            try:
                yield self._queues[bench].get_nowait()
            except Empty:
                return

    def _tried(self, task: Task, bench: Bench) -> bool:
        """One trial and its line; whether the bench is healthy after it."""
        kind, seed = task
        begun = time.monotonic()
        try:
            record = attempted(kind, seed, bench)
        except Exception:
            record = {"kind": kind.name, "seed": seed, "bench": bench.kind, "not_tried": traceback.format_exc()}
        record |= {"of": self._of, "took_s": round(time.monotonic() - begun, 1)}
        with self._writing, self._path.open("a", encoding="utf-8") as file:
            file.write(json.dumps(record) + "\n")
        print(in_short(record), flush=True)
        return "not_tried" not in record and bench.at_rest()


def code() -> str:
    """Which labcal is tried: the commit of this folder, where git knows."""
    asked = ["git", "-C", str(Path(__file__).parent), "describe", "--always", "--dirty"]
    with suppress(OSError):
        return subprocess.run(asked, capture_output=True, text=True, check=False).stdout.strip()
    return ""


def attempted(kind: Kind, seed: int, bench: Bench) -> dict[str, Any]:
    """One trial, begun again where its session did not come to energise anything."""
    for attempt in range(ATTEMPTS):
        try:
            return try_out(kind, seed, bench)
        except NotBegun:
            if attempt == ATTEMPTS - 1:
                raise
    raise AssertionError


def in_short(record: dict[str, Any]) -> str:
    """One line for whoever looks on."""
    if "not_tried" in record:
        return f"{record['kind']} {record['seed']} {record['bench']}: NOT TRIED {record['not_tried'][-300:]}"
    wrong = ", ".join(faults(record)) or "well"
    times = f"at zero {record['at_zero_s']} s, heard {record['heard_s']} s, exit {record['code']}"
    return f"{record['kind']} {record['seed']} {record['bench']}: {times}: {wrong} (load {record['load']})"


def main() -> None:
    """See above."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("campaign-out"))
    parser.add_argument("--number", type=int, default=20, help="of each kind")
    parser.add_argument("--first", type=int, default=0, help="seed, where others were tried elsewhere")
    parser.add_argument("--benches", type=int, default=2, help="at once")
    parser.add_argument("--kinds", nargs="*", default=[], help="patterns of their names")
    parser.add_argument("--minutes", type=float, default=1e6)
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    path = given.out / "results.jsonl"
    done = {(record["kind"], record["seed"]) for record in results(path) if "not_tried" not in record}
    left = tasks(given.kinds, given.number, done, given.first)
    print(f"{len(done)} done, {len(left)} to do")
    campaign = Campaign(path, left, 60 * given.minutes)
    for name in (signal.SIGINT, signal.SIGTERM):
        signal.signal(name, lambda *_: campaign.stop())
    campaign.run(given.benches)


if __name__ == "__main__":
    main()
