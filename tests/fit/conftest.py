"""A bench of our own for the estimators' tests: it shares no formula with the estimators but the contract's."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from labcal.model import AffineMap
from labcal.record import Dut, Reference, Run, Segment

Array = NDArray[np.float64]
TRUE_K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])
TRUE_k = np.array([2100.0, -3400.0, 1500.0])
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
Bench = Callable[..., tuple[Run, AffineMap, Array]]


def body_field(axis: Array, angle_rad: Array, phase: float, cage: Array) -> Array:
    """The cage's field (3,) seen from a body turned right-handed about `axis`, which lies along the cage's z."""
    about = Rotation.align_vectors([axis], [[0.0, 0.0, 1.0]])[0]
    turned = [Rotation.from_rotvec(-(a + phase) * axis) * about for a in angle_rad]
    return np.array([r.apply(cage) for r in turned])


def make(
    *,
    offers: str = "vector",
    axes: Sequence[str] = "xyz",
    fields_nT: Sequence[Sequence[float]] = ((12e3, -9e3, 10e3), (30e3, 20e3, 25e3)),
    rows: int = 100,
    noise_nT: float = 25.0,
    declared: bool = True,
    seed: int = 0,
    K: Array = TRUE_K,
    k: Array = TRUE_k,
    unit_nT: float = 1.0,
    reference: Sequence[float] | None = None,
) -> tuple[Run, AffineMap, Array]:
    """A run of one full turn per axis and field, its true map, and the true field (n, 3) in B."""
    rng = np.random.default_rng(seed)
    segments, fields, cages, angles, index = [], [], [], [], []
    for cage in fields_nT:
        for name in axes:
            angle, axis = np.linspace(0, 2 * np.pi, rows, endpoint=False), np.array(AXES[name])
            fields.append(body_field(axis, angle, rng.uniform(-np.pi, np.pi), np.array(cage)))
            cages.append(np.tile(cage, (rows, 1)))
            angles.append(np.degrees(angle) % 360)
            index += [len(segments)] * rows
            stated = {} if offers == "scalar" else {"axis_body": AXES[name], "axis_cage": (0.0, 0.0, 1.0)}
            kind = "free" if offers == "scalar" else "rotation"
            segments.append(Segment(f"{name}{len(segments)}", kind, **stated))
    b, ref = np.concatenate(fields), np.concatenate(cages)
    reading = (b + k) @ np.linalg.inv(K).T + rng.normal(0, noise_nT, b.shape) / unit_nT
    vector = offers != "scalar"
    run = Run(
        run_id="simulated",
        started_utc="2026-01-01T00:00:00Z",
        simulated=True,
        operator="test",
        dut=Dut(serial="S1", nominal_nT_per_unit=unit_nT, noise_nT=noise_nT if declared and noise_nT else None),
        reference=Reference(kind="vector" if vector else "scalar"),
        segments=tuple(segments),
        t_s=np.arange(len(b)) * 0.5,
        segment_index=np.array(index, dtype=np.intp),
        reading=reading,
        reference_vector=ref if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(ref, axis=1),
        angle_deg=np.concatenate(angles) if offers == "vector" else None,
    )
    return run, AffineMap(K, k), b


@pytest.fixture(scope="session")
def bench() -> Bench:
    """The function that makes simulated runs."""
    return make
