"""One procedure on the simulated bench, in a folder that is gone afterwards, and what its twin truly was."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np

from labcal import session
from labcal.bench.clock import VirtualClock
from labcal.bench.serve import toml
from labcal.files.atomic import write_text
from labcal.model import AffineMap
from labcal.record import Run
from labcal.record.stream import Item, Step
from labcal.store import Store
from labcal.twin.config import TwinTruth
from labcal.twin.sensor import response

START = datetime(2026, 1, 5, 8, 0, tzinfo=UTC)


@dataclass(frozen=True, slots=True, eq=False)
class SimulatedRun:
    """A simulated run: lab time [s], the names of the limits that it missed, and each step with its lab time [s]."""

    run: Run
    lab_s: float
    missed: tuple[str, ...]
    steps: tuple[tuple[str, float], ...]


def record(settings: Mapping[str, Any]) -> SimulatedRun:
    """Run `settings["procedure"]` on the bench `settings["bench"]` (a table) with `given` (texts) and `seed`.

    Raises as `session.run` does, and what an emulated instrument failed by.
    """
    clock, steps = VirtualClock(START), list[tuple[str, float]]()

    def on_item(item: Item) -> None:
        if isinstance(item, Step):
            steps.append((item.name, item.t_s))

    with tempfile.TemporaryDirectory(prefix="labcal-study-") as folder:
        bench, store = Path(folder) / "bench.toml", Path(folder) / "study.sqlite"
        write_text(bench, toml(dict(settings["bench"])))
        outcome = session.run(
            settings["procedure"], bench, settings["given"], operator="study", clock=clock, seed=settings["seed"],
            run_id="study", store=store, on_item=on_item,
        )  # fmt: skip
        if outcome.fault is not None:
            raise outcome.fault
        with Store.open(store) as kept:
            run = kept.run(outcome.run_id)
    ends = [t for _, t in steps[1:]] + [clock.now()]
    lasted = tuple((name, end - begun) for (name, begun), end in zip(steps, ends, strict=True))
    return SimulatedRun(run, clock.now(), tuple(m.name for m in outcome.failed), lasted)


def truth(bench: Mapping[str, Any]) -> AffineMap:
    """The map of the twin's DUT without what else it suffers: b = K m − k with K = response⁻¹ · nT per unit."""
    dut = TwinTruth.model_validate(bench.get("twin", {})).dut
    inverse = np.linalg.inv(response(*map(np.asarray, (dut.scale, dut.nonorthogonality_deg, dut.misalignment_deg))))
    K = np.asarray(inverse * dut.nT_per_unit, dtype=np.float64)
    return AffineMap(K, np.asarray(inverse @ np.asarray(dut.bias_nT), dtype=np.float64))
