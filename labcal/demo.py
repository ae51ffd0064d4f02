"""The whole line on the simulated bench, headless: record, fit, close the loop, sign, verify, report.

The simulated DUT suffers an effect that its seed picked and that nobody downstream of the wire is told.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.resources import files
from pathlib import Path

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.certificate import Verification, sign_simulated
from labcal.certificate.signing import signature_files
from labcal.errors import InputError
from labcal.loop import ClosedLoop
from labcal.record.stream import Item, Measurement
from labcal.runner import Outcome
from labcal.store import Store, save_bundle

START = datetime(2026, 1, 5, 8, 0, tzinfo=UTC)
RUN, CALIBRATION, TRUST, REPORT = "run.zip", "calibration.json", "allowed_signers", "report.html"
STORE = "labcal-demo.sqlite"
STAGES = ("preflight", "close the loop", "sign and verify")
Progress = Callable[[str], None]


@dataclass(frozen=True, slots=True)
class Demo:
    """What the demo did, and where it lies."""

    folder: Path
    run_id: str
    rows: int
    limits_missed: tuple[Measurement, ...]
    closed: ClosedLoop
    verification: Verification


def demo(folder: Path, seed: int = 0, *, stage: Progress = lambda name: None, tell: Callable[[Item], None]) -> Demo:
    """Run the line into `folder`. `run.zip` and `calibration.json` repeat byte for byte from `seed`.

    `stage` hears the names in STAGES as they begin, `tell` every item of the run. Raises InstrumentError where an
    emulated instrument fails.
    """
    _make_room(folder)
    stage(STAGES[0])
    outcome = _record(folder, seed, tell)
    stage(STAGES[1])
    closed = session.close_loop(str(folder / RUN), folder / CALIBRATION, report=folder / REPORT)
    stage(STAGES[2])
    sign_simulated(folder / CALIBRATION, folder / TRUST)
    verification = session.verify(folder / CALIBRATION, folder / TRUST, str(folder / RUN))
    rows = len(session.load_run(str(folder / RUN)))
    return Demo(folder, outcome.run_id, rows, outcome.failed, closed, verification)


def _record(folder: Path, seed: int, tell: Callable[[Item], None]) -> Outcome:
    """The preflight, in a store of its own, its clock beginning at a fixed date; the bundle goes to `run.zip`."""
    outcome = session.run(
        "preflight", simulated_bench(), operator="demo", clock=VirtualClock(START), seed=seed, run_id=f"demo-{seed}",
        store=folder / STORE, tell=tell,
    )  # fmt: skip
    if outcome.fault is not None:
        raise outcome.fault
    with Store.open(folder / STORE) as store:
        save_bundle(store.bundle(outcome.run_id), folder / RUN)
    return outcome


def simulated_bench() -> Path:
    """The bench file of the simulated lab: in the installed package, or in the checkout's examples."""
    for place in (files("labcal") / "simulated.toml", files("labcal") / ".." / "examples" / "simulated.toml"):
        if place.is_file():
            return Path(str(place)).resolve()
    raise InputError("this installation lacks the simulated bench, simulated.toml: install labcal again")


def _make_room(folder: Path) -> None:
    """Make the folder; what an earlier demo left there goes, and nothing else."""
    folder.mkdir(parents=True, exist_ok=True)
    ours = [RUN, CALIBRATION, TRUST, REPORT, *(STORE + end for end in ("", "-wal", "-shm"))]
    for old in [*(folder / name for name in ours), *signature_files(folder / CALIBRATION)]:
        old.unlink(missing_ok=True)
