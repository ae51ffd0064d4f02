"""A simulated bench for procedures: the example's, without the DUT's hidden effect; and what a run measured."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
import pytest
from bench_files import bench_files_in

from labcal import session
from labcal.record.stream import Event, Item, Measurement
from labcal.store import Store
from labcal.twin.config import TwinTruth
from labcal.twin.sensor import response


@pytest.fixture
def bench_file(tmp_path: Path) -> Callable[..., Path]:
    """Write a bench file like the example: `bench_files`."""
    return bench_files_in(tmp_path)


class Ran:
    """A procedure that was run on the twin, and what it said."""

    def __init__(self, procedure: str, bench: Path, given: dict[str, str], seed: int) -> None:
        self.outcome = session.run(procedure, bench, given, seed=seed)
        with Store.open() as store:
            self.items: list[Item] = list(store.items(self.outcome.run_id))
        self.measured = {i.name: i for i in self.items if isinstance(i, Measurement)}

    def value(self, name: str) -> float:
        return self.measured[name].value

    def event(self, kind: str) -> Event:
        return next(i for i in self.items if isinstance(i, Event) and i.kind == kind)


@pytest.fixture
def ran(bench_file: Callable[..., Path]) -> Callable[..., Ran]:
    """Run a procedure with settings on a bench with the table [twin] `twin` and `edits` of its text; it must finish."""

    def run(
        procedure: str, twin: str = "", seed: int = 11, edits: Sequence[tuple[str, str]] = (), **given: object
    ) -> Ran:
        found = Ran(procedure, bench_file(twin, *edits), {key: str(value) for key, value in given.items()}, seed)
        assert found.outcome.status == "finished", found.outcome.fault
        return found

    return run


@pytest.fixture
def dut_response() -> np.ndarray:
    """The twin's DUT: reading · 4 nT = R (field + effects) + bias."""
    truth = TwinTruth().dut
    return response(*(np.array(v) for v in (truth.scale, truth.nonorthogonality_deg, truth.misalignment_deg)))
