"""Hours and months in one window: does anything grow that should not?

    QT_QPA_PLATFORM=offscreen python benchmarks/soak.py --preflights 30 --minutes 60 --runs 10000

A store with so many runs; then preflights on the virtual clock, one after the other, as a month has days; then 1 kHz at
true pace, which the simulated DUT sends in the preflights too. The window is open on its Run page all the while;
between two preflights the History page is opened and `labcal runs` is asked. Read are this process and the worker that
it starts and that records. It prints what was seen, leaves every reading in --out (soak.csv) as it comes, and draws a
picture where --picture names it; Ctrl-C ends it early with both. Exit 1 where memory, handles or threads of either
process grew.
"""

from __future__ import annotations

import argparse
import csv
import os
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np

BENCH = Path(__file__).parents[1] / "examples" / "simulated.toml"
SERIAL, RATE_HZ, EVERY_S = "SIM-0001", 1000.0, 2.0
MB = 1e6
MOST_GROWTH_MB, MOST_MORE = 25.0, 3  # from the second third of a phase to its last: memory; handles and threads
DAY = {"axes": "x,y,z", "magnitudes_nT": "20000", "reverse": "no", "modes": "nominal", "rate_deg_per_s": "20"}


@dataclass(frozen=True)
class Reading:
    """What stood there at one moment. A latency is NaN where it was not looked at."""

    phase: str
    at_s: float  # since the script began
    window_MB: float
    worker_MB: float
    window_handles: int
    worker_handles: int
    window_threads: int
    worker_threads: int
    store_MB: float
    runs_s: float = float("nan")  # `labcal runs`, its processor time
    history_s: float = float(
        "nan"
    )  # the History page, from the click until its table stands: the window's processor time


def work() -> None:
    """Be the window's worker, with a simulated DUT that sends a thousand lines a second."""
    from drivers.emulators.csv_line import CsvLineEmulator
    from drivers.emulators.streaming import SampleClock
    from labcal.gui.ipc.channel import stdio_channel
    from labcal.gui.ipc.worker import serve

    made = CsvLineEmulator.__init__

    def faster(emulator: Any, *given: Any) -> None:
        made(emulator, *given)
        emulator._beat = SampleClock(RATE_HZ)

    CsvLineEmulator.__init__ = faster  # type: ignore[method-assign]
    serve(stdio_channel())


class Soak:
    """The window, what is done in it, and what was read."""

    def __init__(self, application: Any, window: Any, out: Path) -> None:
        self.application, self.window = application, window
        out.mkdir(parents=True, exist_ok=True)
        self.file = (out / "soak.csv").open("w", newline="", buffering=1)
        self.writer = csv.DictWriter(self.file, [field.name for field in fields(Reading)])
        self.writer.writeheader()
        self.state, self.run = window.app_state, window.app_state.run
        self.began, self.readings = time.monotonic(), list[Reading]()

    def until(self, so: Callable[[], bool], each: Callable[[], object] = lambda: None) -> float:
        """Let the window work until something is so; processor time of this process meanwhile."""
        begun, last = time.process_time(), time.monotonic()
        while not so():
            if self.run.prompt is not None:
                self.run.answer(self.run.prompt.choices[0])
            self.application.processEvents()
            time.sleep(0.002)
            if time.monotonic() - last > EVERY_S:
                last = time.monotonic()
                each()
        return time.process_time() - begun

    def record(self, phase: str, order: Any) -> None:
        """A run from its order to its end."""
        self.window.open_page("Run")
        self.run.start(order)
        self.until(lambda: not self.run.alive, lambda: self.look(phase))
        if self.run.status != "finished":
            sys.exit(f"{order.procedure} ended as {self.run.status}: {self.run.fault or self.run.message}")

    def look(self, phase: str, **latencies: float) -> None:
        """Read this process and the bench's worker."""
        worker = self.state.bench_worker._process
        mine, its = standing(os.getpid()), standing(int(worker.processId()) if worker else os.getpid())
        home = Path(os.environ["LABCAL_HOME"])
        store = sum(path.stat().st_size for path in home.glob("store.sqlite*") if path.is_file()) / MB
        pairs = (value for pair in zip(mine, its, strict=True) for value in pair)
        self.readings.append(Reading(phase, time.monotonic() - self.began, *pairs, store_MB=store, **latencies))
        self.writer.writerow(asdict(self.readings[-1]))

    def latencies(self, phase: str) -> None:
        """What a person waits for who looks for a run."""
        from labcal.store import list_runs

        begun = time.process_time()
        there = len(list_runs())
        runs_s, history = time.process_time() - begun, self.window.page("History")
        history.runs = ()
        history_s = self.until(lambda: True)
        self.window.open_page("History")
        history_s += self.until(lambda: len(history.runs) == there and not self.state.quick_worker.busy)
        self.look(phase, runs_s=runs_s, history_s=history_s)


def standing(process: int) -> tuple[float, int, int]:
    """Memory [MB], open handles and threads of a process."""
    status = Path(f"/proc/{process}/status").read_text()
    found = {
        line.split(":")[0]: line.split()[1] for line in status.splitlines() if line.startswith(("VmRSS", "Threads"))
    }
    handles = len(os.listdir(f"/proc/{process}/fd"))
    return int(found["VmRSS"]) * 1024 / MB, handles, int(found["Threads"])


def fill(runs: int) -> None:
    """So many short runs in the store, of a hundred sensors, in one transaction."""
    from labcal.record import Dut, Reference, RunHeader
    from labcal.record.stream import Block
    from labcal.store import Store, chain
    from labcal.store.items import to_json, to_row

    block = to_row(Block("dut", "dut", ("dut_x", "dut_y", "dut_z"), np.arange(20.0), np.full((20, 3), 2e4)))
    header = RunHeader("", "", True, "J. Doe", Dut(""), Reference("vector"), procedure="preflight")
    with Store.open() as store, store._written():
        for number in range(runs):
            day, dut = (
                f"{2016 + number // 1000}-{1 + number // 28 % 12:02}-{1 + number % 28:02}",
                f"EM-{number % 100:03}",
            )
            named = replace(header, run_id=f"past-{number}", started_utc=f"{day}T08:00:00Z", dut=Dut(dut))
            text = to_json({**asdict(named), "chain": chain.FORMAT})
            row = chain.begin(store._connection, named.run_id, text)
            chain.append(store._connection, row, "status", ("running", named.started_utc))
            chain.append(store._connection, row, "item", block)
            chain.append(store._connection, row, "status", ("finished", named.started_utc))


def main() -> int:
    """Do it all."""
    given = arguments()
    os.environ["LABCAL_HOME"] = tempfile.mkdtemp(prefix="labcal-soak-")
    fill(given.runs)
    from PySide6.QtCore import QSettings
    from PySide6.QtWidgets import QApplication

    from labcal.gui.ipc.client import Client
    from labcal.gui.theming.theme import LIGHT
    from labcal.gui.viewmodels.app_state import AppState
    from labcal.gui.viewmodels.run import RunViewModel
    from labcal.gui.window import Window

    application = QApplication([])
    settings = QSettings(str(Path(os.environ["LABCAL_HOME"]) / "w.ini"), QSettings.Format.IniFormat)
    app_state = AppState(settings)
    app_state.bench_worker = Client(app_state, (__file__, "work"))
    app_state.run = RunViewModel(app_state.bench_worker)
    window = Window(app_state, LIGHT)
    window.show()
    soak = Soak(application, window, given.out)
    try:
        live_through(soak, given.preflights, given.minutes)
    except KeyboardInterrupt:
        print("ended early")
    window.close()
    soak.file.close()
    if given.picture:
        draw(soak.readings, given.picture)
    return summarise(soak.readings)


def live_through(soak: Soak, preflights: int, minutes: float) -> None:
    """The month, then the hour; either may be left out."""
    from labcal.gui.ipc.messages import RunProcedure

    for _ in range(preflights):
        soak.record("month", RunProcedure("preflight", str(BENCH), DAY, SERIAL, "J. Doe", seed=1))
        soak.latencies("month")
    if minutes:
        listening = {"duration_s": f"{60 * minutes:g}", "mains_s": "5"}
        soak.record("1 kHz", RunProcedure("ambient", str(BENCH), listening, SERIAL, "J. Doe", pace="true", seed=1))
        soak.latencies("1 kHz")


def arguments() -> argparse.Namespace:
    """What is asked on the command line."""
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("--preflights", type=int, default=30)
    asked.add_argument("--minutes", type=float, default=60.0)
    asked.add_argument("--runs", type=int, default=10_000)
    asked.add_argument("--out", type=Path, default=Path("soak-out"))
    asked.add_argument("--picture", type=Path)
    return asked.parse_args()


def summarise(readings: list[Reading]) -> int:
    """Say for each phase how it began and how it ended; 1 where something grew."""
    grew = False
    for phase in dict.fromkeys(one.phase for one in readings):
        these = [one for one in readings if one.phase == phase]
        third = len(these) // 3
        for name in [field.name for field in fields(Reading)][2:]:
            values = np.array([getattr(one, name) for one in these])
            early, late = (np.nanmedian(part) if np.isfinite(part).any() else np.nan
                           for part in (values[third : 2 * third], values[-third:]))  # fmt: skip
            most = MOST_GROWTH_MB if name in ("window_MB", "worker_MB") else MOST_MORE
            more = name.startswith(("window", "worker")) and late - early > most
            grew |= bool(more)
            print(f"{phase:6} {name:16} {early:9.3g} → {late:9.3g}{'  GREW' if more else ''}")
    return int(grew)


def draw(readings: list[Reading], path: Path) -> None:
    """The curves, over the script's own clock."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 9), layout="constrained")
    panels = figure.subplots(4, 1, sharex=True)
    at_min = np.array([one.at_s for one in readings]) / 60
    shown = {
        "memory [MB]": ("window_MB", "worker_MB"),
        "handles, threads": ("window_handles", "worker_handles", "window_threads", "worker_threads"),
        "store [MB]": ("store_MB",),
        "processor time [s]": ("runs_s", "history_s"),
    }
    for panel, (title, names) in zip(panels, shown.items(), strict=True):
        for name in names:
            values = np.array([getattr(one, name) for one in readings], dtype=float)
            there = np.isfinite(values)
            panel.plot(at_min[there], values[there], ".-" if name.endswith("_s") else "-", label=name.replace("_", " "))
        panel.set_ylabel(title)
        panel.set_ylim(bottom=0)
        panel.legend(loc="center right", fontsize=8)
        for phase in dict.fromkeys(one.phase for one in readings):
            panel.axvline(min(one.at_s for one in readings if one.phase == phase) / 60, color="grey", lw=0.7)
    panels[-1].set_xlabel("time of the script [min]; grey: preflights begin, 1 kHz begins")
    figure.savefig(path, dpi=110)


if __name__ == "__main__":
    sys.exit(work() if "work" in sys.argv[1:] else main())
