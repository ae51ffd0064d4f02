"""A LEMI-025 that stands away from the coils follows the ambient field, and is written as the field at the DUT.

Its records come seconds after what they say: by then the coils may make another field.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from cage_files import MATRIX, a_calibration, with_the_file
from served_lab import Served

from labcal.bench import open_bench
from labcal.bench.clock import Clock, VirtualClock
from labcal.bench.coils.cage_file import write_cage
from labcal.bench.coils.current_history import KEPT, CurrentHistory
from labcal.record.stream import Block, SegmentClosed, SegmentOpened
from labcal.runner import find, run_procedure, yes_to_all
from labcal.store import Store

EDITS = (
    ('place = "dut"\nposition_m = [0.0, 0.0, 0.15]', 'place = "remote"\nposition_m = [0.0, 0.0, 0.3]'),
    ('driver = "hmr2300"', 'driver = "lemi-025"'),
    ("settings = { rate = 20 }", "settings = { sent_after_s = 2.0 }"),
)
TWIN = "ambient = { drift_nT = 300.0, mains_nT = 0.0 }"
SPHERE = {"n_directions": "8", "magnitudes_nT": "50000", "verify": "1", "dwell_s": "4"}
READ_nT = 150.0  # what the last digit of three read-backs hides, and noise


@pytest.fixture
def bench(bench_file: Callable[..., Path], tmp_path: Path) -> Path:
    """A bench whose approved cage calibration says that its reference sees nothing of the coils."""
    write_cage(a_calibration(np.array(MATRIX), np.zeros(3)), tmp_path / "cage.json")
    return with_the_file(bench_file(TWIN, *EDITS))


def away_from_the_coils(lab: Any) -> None:
    """The lab's reference stands where the coils make no field."""
    of_coils, place = lab._of_coils, lab._reference_place
    lab._of_coils = lambda t_s, i_A, at_m: of_coils(t_s, i_A, at_m) * (at_m is not place)


def recorded(bench: Path, clock: Clock, lab_of: Callable[[Any], Any]) -> tuple[list[Any], Any]:
    """The items of a field-sphere, and the lab that it was recorded in."""
    with closing(open_bench(bench, clock=clock, seed=2)) as opened, Store.open() as store:
        away_from_the_coils(lab := lab_of(opened))
        outcome = run_procedure(opened, find("field-sphere"), SPHERE, store=store, answer=yes_to_all(True))
        assert outcome.status == "finished", outcome.fault
        return list(store.items(outcome.run_id)), lab


def errors_nT(items: list[Any], lab: Any, late_s: float = 0.0) -> np.ndarray:
    """How far the recorded reference is from the field at the DUT, within the segments (n,)."""
    blocks = [i for i in items if isinstance(i, Block) and i.stream == "reference"]
    t = np.concatenate([b.t_s for b in blocks])
    seen = np.vstack([b.values for b in blocks])
    begun = [i.t_s for i in items if isinstance(i, SegmentOpened)]
    ended = [i.t_s for i in items if isinstance(i, SegmentClosed)]
    assert len(begun) == len(ended) > 8
    inside = np.any([(t >= a) & (t <= b) for a, b in zip(begun, ended, strict=True)], axis=0)
    assert inside.sum() > 10 * len(begun)
    t, seen = t[inside], seen[inside]
    t = t + late_s
    currents = np.column_stack([lab.coils[axis].at(t) for axis in "xyz"])
    true = lab.ambient.slow(t) + lab._of_coils(t, currents, np.zeros(3))
    return np.linalg.norm(seen - true, axis=1)


def test_what_came_late_is_carried_with_the_currents_of_its_own_time(bench: Path) -> None:
    clock = VirtualClock(datetime(2026, 11, 21, tzinfo=UTC))
    items, lab = recorded(bench, clock, lambda opened: opened.simulated_operator._lab)
    assert errors_nT(items, lab).max() < READ_nT
    drift = lab.ambient.slow(np.array([0.0, clock.now()]))
    assert np.linalg.norm(drift[1] - drift[0]) > 0.3 * READ_nT, "the ambient field moved, and was followed"


def test_currents_are_those_read_last_until_then_and_only_so_many_are_kept() -> None:
    flown = CurrentHistory()
    for second in range(KEPT + 5):
        flown.see(float(second), np.full(3, second))
    assert flown.at([7.5, KEPT + 3.2, KEPT + 99.0])[:, 0].tolist() == [7, KEPT + 3, KEPT + 4]
    assert flown.at([-1.0])[0, 0] == 5  # of the oldest that is known
    assert CurrentHistory().at([1.0, 2.0]).tolist() == np.zeros((2, 3)).tolist()
    assert flown.last_A[0] == KEPT + 4


@contextmanager
def served(bench: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    """The bench on ports and ptys of this computer."""
    lab = Served(bench.parent, monkeypatch, bench.read_text(encoding="utf-8"))
    try:
        yield lab
    finally:
        lab.close()


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo terminals, which Windows does not have")
def test_a_session_on_real_lines_follows_the_ambient_field_by_the_stream_of_a_lemi(
    bench: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """All in true time, the guardian at the supplies; the stamps are off by what its first records were on the way."""
    with served(bench, monkeypatch) as real:
        items, lab = recorded(real.file, real.clock, lambda opened: real.twin)
        offsets = np.linspace(-0.1, 0.1, 5)
        errors = [np.quantile(errors_nT(items, lab, late), 0.99) for late in offsets]
    print(f"\n99 % of the readings are within {min(errors):.0f} nT of the field at the DUT")
    assert min(errors) < READ_nT
