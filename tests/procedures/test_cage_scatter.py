"""The cage's stated uncertainty held to account from both sides, over simulated labs that differ in all they can."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from labcal import session
from labcal.record.stream import Event, Item
from labcal.twin.coils import square_coils
from labcal.twin.config import TwinTruth


@pytest.mark.slow
def test_the_stated_uncertainty_of_the_matrix_is_the_scatter_over_two_hundred_labs(
    bench_file: Callable[..., Path], tmp_path: Path
) -> None:
    """Every lab has its own noise, drift and largest field: what the read-back rounds differs from lab to lab."""
    bench = bench_file(DUT_ONLY[0], *DUT_ONLY[1:])
    truth = TwinTruth().coils
    true = square_coils(truth.side_m, truth.turns, np.array(truth.tilt_deg)).at(np.eye(3), np.zeros(3)).T
    found, stated = list[np.ndarray](), list[np.ndarray]()
    for seed in range(200):
        event = calibrated(bench, 36_000.0 + 8_000.0 * np.random.default_rng(seed).random(), seed, tmp_path / "store")
        found.append(np.array(event.data["DUT"]["matrix_nT_per_A"]))
        stated.append(np.diag(event.data["DUT"]["covariance"])[:9].reshape(3, 3))
    u = np.sqrt(np.mean(stated, axis=0))
    print("scatter / stated:", (np.std(found, axis=0, ddof=1) / u).round(2).tolist())
    print("bias / stated:", ((np.mean(found, axis=0) - true) / u).round(2).tolist())
    assert np.std(found, axis=0, ddof=1) / u == pytest.approx(np.ones((3, 3)), abs=0.2)
    within = np.abs(np.array(found) - true) < 2 * np.sqrt(stated)
    assert within.mean() > 0.9


NOTHING_DECLARED = ("u_scale_ppm = 50.0\nu_offset_nT = 3.0\n", "")  # every lab here has the same reference
DUT_ONLY = ("", ('place = "dut"\nposition_m = [0.0, 0.0, 0.15]\n', 'place = "dut"\n'), NOTHING_DECLARED)


def calibrated(bench: Path, field_nT: float, seed: int, store: Path) -> Event:
    """What one lab's cage-calibration found, in short steps."""
    items: list[Item] = []
    given = {"field_nT": str(field_nT), "steps": "2", "dwell_s": "1"}
    session.run("cage-calibration", bench, given, seed=seed, store=store, on_item=items.append).raise_fault()
    return next(i for i in items if isinstance(i, Event) and i.kind == "cage-calibration")
