"""The whole line on the simulated bench, headless: cage check, record, fit, close the loop, sign, verify, report.

The simulated DUT suffers an effect that its seed picked and that nobody downstream of the wire knows.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from importlib.resources import files
from pathlib import Path

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.certificate import Verification, sign_simulated
from labcal.demo.folder import CALIBRATION, REPORT, RUN, STORE, TRUST
from labcal.errors import InputError
from labcal.loop import ClosedLoop
from labcal.record.stream import Item, Measurement
from labcal.runner import Outcome
from labcal.store import Store, save_bundle

START = datetime(2026, 1, 5, 8, 0, tzinfo=UTC)
STAGES = ("cage check", "preflight", "close the loop", "sign and verify")
CAGE_CHECK = {"steps": "2", "dwell_s": "0.5"}  # the short form of cage-calibration
PREFLIGHT: dict[str, str] = {}  # nothing is other than as it stands; a test shortens it
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


def demo(folder: Path, seed: int = 0, *, stage: Progress = lambda name: None, on_item: Callable[[Item], None]) -> Demo:
    """Run the line into `folder`, where `demo_folder.make_room` has been. Two files repeat byte for byte from `seed`.

    These are `run.zip` and `calibration.json`. `stage` hears the names in STAGES as they begin and what the loop is at,
    `on_item` every item of the run. Raises InstrumentError where an emulated instrument fails.
    """
    stage(STAGES[0])
    cage = _record(
        "cage-calibration", folder, seed, on_item, CAGE_CHECK, f"demo-{seed}-cage", START - timedelta(hours=1)
    )
    stage(STAGES[1])
    outcome = _record("preflight", folder, seed, on_item, PREFLIGHT, f"demo-{seed}", START)
    with Store.open(folder / STORE) as store:
        save_bundle(store.bundle(outcome.run_id, with_chain=True), folder / RUN)
    stage(STAGES[2])
    closed = session.close_loop(str(folder / RUN), folder / CALIBRATION, stage, report=folder / REPORT)
    stage(STAGES[3])
    sign_simulated(folder / CALIBRATION, folder / TRUST)
    verification = session.verify(folder / CALIBRATION, folder / TRUST, str(folder / RUN))
    rows = len(session.load_run(str(folder / RUN)))
    return Demo(folder, outcome.run_id, rows, (*cage.failed, *outcome.failed), closed, verification)


def _record(
    procedure: str,
    folder: Path,
    seed: int,
    on_item: Callable[[Item], None],
    given: Mapping[str, str],
    run_id: str,
    begins: datetime,
) -> Outcome:
    """Run a procedure on the simulated bench into the demo's own store; its clock begins at a fixed date."""
    outcome = session.run(
        procedure, simulated_bench(), given, operator="demo", clock=VirtualClock(begins), seed=seed, run_id=run_id,
        store=folder / STORE, on_item=on_item,
    )  # fmt: skip
    if outcome.fault is not None:
        raise outcome.fault
    return outcome


def simulated_bench() -> Path:
    """The bench file of the simulated lab: in the installed package, or in the checkout's examples."""
    for place in (files("labcal") / "simulated.toml", files("labcal") / ".." / "examples" / "simulated.toml"):
        if place.is_file():
            return Path(str(place)).resolve()
    raise InputError("this installation lacks the simulated bench, simulated.toml: install labcal again")
