"""`ml` in time and memory against the number of samples: linear, and under 50 ms for a thousand vectors."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.fit.ml import ml
from labcal.record import Dut, Reference, Run, Segment

K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])


def run_of(rows: int, kind: str) -> Run:
    rng = np.random.default_rng(0)
    u = rng.normal(size=(rows, 3))
    field = rng.uniform(20e3, 50e3, (rows, 1)) * u / np.linalg.norm(u, axis=1, keepdims=True)
    reading = (field + [2e3, -3e3, 1e3]) @ np.linalg.inv(K).T + 25 * rng.normal(size=(rows, 3))
    vector = kind == "vector"
    return Run(
        run_id=kind,
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="",
        dut=Dut("s", noise_nT=25.0),
        reference=Reference("vector" if vector else "scalar"),
        segments=(Segment("free", "free", reference_frame="body"),),
        t_s=np.arange(float(rows)),
        segment_index=np.zeros(rows, dtype=np.intp),
        reading=reading,
        reference_vector=field if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(field, axis=1),
    )


@pytest.mark.parametrize("kind", ["vector", "scalar"])
@pytest.mark.parametrize("rows", [1_000, 10_000, 100_000, 1_000_000])
def test_ml(benchmark, rows: int, kind: str) -> None:
    found = benchmark.pedantic(ml, (run_of(rows, kind),), rounds=3 if rows < 1_000_000 else 1, warmup_rounds=1)
    assert found.ok
