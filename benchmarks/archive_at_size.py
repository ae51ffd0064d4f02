"""A lab's years pushed into a PostgreSQL that waits for the disk: runs and signed calibrations, made directly.

`python benchmarks/archive_at_size.py --runs 5000 --samples 20000` is 500 sensors of ten years: 10^8 samples, some 25 GB
of disk while it works. It prints the figures of docs/performance.md, as it goes.
"""

from __future__ import annotations

import argparse
import os
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT / "tests" / "archive"))

from made_lab import signed_calibrations, stored_runs  # noqa: E402
from made_up import Years, fill  # noqa: E402
from postgres import Server, server  # noqa: E402
from test_queries import ASKED, processor_s  # noqa: E402

from labcal.archive import ready  # noqa: E402
from labcal.archive.run_to_push import of_store  # noqa: E402
from labcal.files.atomic import write_bytes  # noqa: E402
from labcal.session import archiving  # noqa: E402

AT_ONCE = 250  # runs between two pushes: does the pace fall as store, log and archive grow?
IN_TURN, TURNS = 250, 2  # what a push does once, some 0.1 s, is no pace
YEARS = Years(500, 10)


def main() -> None:
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--runs", type=int, default=500)
    asked.add_argument("--samples", type=int, default=20_000)
    asked.add_argument("--calibrations", type=int, default=500)
    given = asked.parse_args()
    with TemporaryDirectory(prefix="labcal-size-") as folder, server(hasty=False) as running:
        os.environ["LABCAL_HOME"] = f"{folder}/home"
        bundles = Path(folder, "bundles")
        url = f"{running.url(database := running.database())}&bundles={bundles}"
        archiving.init_archive(url, None)
        fill(running, database, YEARS)
        push_runs(running, url, bundles, given.runs, given.samples)
        push_made_ready(running, url, bundles, given.runs, given.samples)
        push_calibrations(running, url, given.calibrations)
        for question, (wanted, _) in ASKED.items():
            begun = time.perf_counter()
            archiving.archived_calibrations(url, **wanted)
            wall = time.perf_counter() - begun
            print(f"{question}: {processor_s(running, url, question):.2f} s of processor, {wall:.2f} s by the clock")


def push_runs(running: Server, url: str, bundles: Path, runs: int, samples: int) -> None:
    for first in range(0, runs, AT_ONCE):
        batch = range(first, min(first + AT_ONCE, runs))
        stored_runs(batch, samples)
        with timed(running) as took:
            assert archiving.push(url).runs == len(batch)
        busy, served, wall = took()
        size, n = sum(path.stat().st_size for path in bundles.rglob("*.zip")), len(batch) * samples
        each, one = size / (batch[-1] + 1) / samples, size // (batch[-1] + 1)
        disk, by_file = disk_pace(bundles.parent, 2**28), disk_pace(bundles.parent, one, 2**27 // one)
        print(
            f"runs {batch[0]}–{batch[-1]} of {samples} samples: {1e3 * busy / len(batch):.1f} ms a run, "
            f"{n / busy:.0f} samples/s of a processor; server {1e3 * served / len(batch):.1f} ms a run; "
            f"{n / wall:.0f} samples/s by the clock; {each:.0f} bytes a sample: {n * each / busy / 1e6:.1f} MB/s of a "
            f"processor, {n * each / wall / 1e6:.1f} by the clock, the disk {disk / 1e6:.0f} at one go, "
            f"{by_file / 1e6:.0f} in files of this size",
            flush=True,
        )
    again(running, url)


def push_made_ready(running: Server, url: str, bundles: Path, first: int, samples: int) -> None:
    """In turns: runs as they lie in the store, as many that were made ready before, and a plain copy of their zips."""
    rows = {name: [0.0] * 3 for name in ("as they lie in the store", "made ready before", "a plain copy")}
    made_s, size, there = 0.0, 0, set(bundles.rglob("*.zip"))
    for turn in range(TURNS):
        for way, begin in zip(list(rows)[:2], (first, first + IN_TURN), strict=True):
            stored_runs(batch := range(begin + 2 * turn * IN_TURN, begin + 2 * turn * IN_TURN + IN_TURN), samples)
            before = own_s()
            for number in batch if way == "made ready before" else ():
                ready.keep(of_store(f"size-{number}"))
            made_s += own_s() - before
            there = set(bundles.rglob("*.zip"))
            with timed(running) as took:
                assert archiving.push(url).runs == IN_TURN
            rows[way] = [sum(pair) for pair in zip(rows[way], took(), strict=True)]
        with timed(running) as took:
            size += plain_copy(set(bundles.rglob("*.zip")) - there, bundles.parent / "copied")
        rows["a plain copy"] = [sum(pair) for pair in zip(rows["a plain copy"], took(), strict=True)]
    number = TURNS * IN_TURN
    for way, (busy, served, wall) in rows.items():
        print(
            f"{way}: {1e3 * busy / number:.1f} ms a run, server {1e3 * served / number:.1f}, by the clock "
            f"{1e3 * wall / number:.1f}: {size / busy / 1e6:.0f} MB/s of a processor, "
            f"{size / wall / 1e6:.0f} by the clock"
        )
    print(f"to make one ready: {1e3 * made_s / number:.1f} ms", flush=True)


def plain_copy(paths: Iterable[Path], folder: Path) -> int:
    """As a bundle is put: each flushed, then renamed. Returns how many bytes."""
    folder.mkdir(exist_ok=True)
    for path in paths:
        write_bytes(folder / path.name, path.read_bytes())
    return sum(path.stat().st_size for path in paths)


def push_calibrations(running: Server, url: str, number: int) -> None:
    """All at once: the first push of a lab that has signed for years, each signature with its entry in the log."""
    signed_calibrations(number)
    with timed(running) as took:
        assert archiving.push(url).calibrations == number
    busy, served, _ = took()
    print(
        f"{number} calibrations: {1e3 * busy / number:.1f} ms each, server {1e3 * served / number:.1f} ms", flush=True
    )
    again(running, url)


def again(running: Server, url: str) -> None:
    with timed(running) as took:
        found = archiving.push(url)
        assert (found.runs, found.calibrations) == (0, 0)
    print(f"the same again: {took()[0]:.2f} s of a processor", flush=True)


@contextmanager
def timed(running: Server) -> Iterator[Callable[[], tuple[float, float, float]]]:
    """Processor time of this process with those that it began, and of the server, and wall time, in seconds."""
    taken = [0.0, 0.0, 0.0]
    begun = [own_s(), running.busy_s(), time.perf_counter()]
    yield lambda: (taken[0], taken[1], taken[2])
    busy, wall = own_s(), time.perf_counter()
    taken[:] = [busy - begun[0], running.busy_s() - begun[1], wall - begun[2]]


def own_s() -> float:
    """Of this process, and of those that it began and that have ended."""
    return sum(os.times()[:4])


def disk_pace(folder: Path, size: int, files: int = 1) -> float:
    """Bytes a second, in files of this size, each written at one go and flushed."""
    content, path = os.urandom(2**20), folder / "pace"
    begun = time.perf_counter()
    for _ in range(files):
        with path.open("wb") as file:
            for at in range(0, size, len(content)):
                file.write(content[: size - at])
            file.flush()
            os.fsync(file.fileno())
    pace = files * size / (time.perf_counter() - begun)
    path.unlink()
    return pace


if __name__ == "__main__":
    main()
