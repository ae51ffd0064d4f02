"""Runs of a made-up sensor in a made-up cage: they share no formula with what is tried on them but the contract's."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from labcal.model import AffineMap
from labcal.record import Channel, Dut, Reference, Run, Segment

Array = NDArray[np.float64]
Offers = Literal["vector", "axis", "scalar"]
TRUE_K = np.array([[1.06, 0.04, -0.03], [-0.02, 0.94, 0.05], [0.03, -0.06, 1.02]])
TRUE_k = np.array([2100.0, -3400.0, 1500.0])
TWO_FIELDS = ((12e3, -9e3, 10e3), (30e3, 20e3, 25e3))
AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
PERIOD_S = 0.5  # of the samples


@dataclass(frozen=True)
class MadeUp:
    """A run, the map that its readings were made with, and the field (n, 3) that the sensor truly saw [nT, B]."""

    run: Run
    true: AffineMap
    field_nT: Array

    def with_effect(self, effect_nT: Array) -> Run:
        """The run of a sensor that reads `effect_nT` (n, 3) [nT of B] too high."""
        return replace(self.run, reading=self.run.reading + effect_nT @ np.linalg.inv(self.true.K).T)


def made_up_run(
    *,
    offers: Offers = "vector",
    axes: Sequence[str] = "xyz",
    fields_nT: Sequence[Sequence[float]] = TWO_FIELDS,
    rows: int = 100,
    noise_nT: float = 25.0,
    declared: bool = True,
    seed: int = 0,
    K: Array = TRUE_K,
    k: Array = TRUE_k,
    unit_nT: float = 1.0,
    channels: Sequence[Channel] = (),
) -> MadeUp:
    """One full turn of `rows` samples, 0.5 s apart, per axis and field; `channels` as long as all of them.

    `offers`: what a row may be compared with, a field vector, its component along the axis, or its magnitude.
    `declared`: whether the run states its noise. Readings are in units of `unit_nT`.
    """
    rng = np.random.default_rng(seed)
    segments, index = list[Segment](), list[int]()
    fields, cages, angles = list[Array](), list[Array](), list[Array]()
    for cage in fields_nT:
        for name in axes:
            angle, axis = np.linspace(0, 2 * np.pi, rows, endpoint=False), np.array(AXES[name])
            fields.append(body_field(axis, angle, rng.uniform(-np.pi, np.pi), np.array(cage)))
            cages.append(np.tile(cage, (rows, 1)))
            angles.append(np.degrees(angle) % 360)
            index += [len(segments)] * rows
            segments.append(_segment(name, len(segments), offers))
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
        t_s=np.asarray(np.arange(len(b)) * PERIOD_S, dtype=np.float64),
        segment_index=np.array(index, dtype=np.intp),
        reading=reading,
        reference_vector=ref if vector else None,
        reference_magnitude=None if vector else np.linalg.norm(ref, axis=1),
        angle_deg=np.concatenate(angles) if offers == "vector" else None,
        channels=tuple(channels),
    )
    return MadeUp(run, AffineMap(K, k), b)


def _segment(axis: str, number: int, offers: Offers) -> Segment:
    stated: dict[str, Any] = {} if offers == "scalar" else {"axis_body": AXES[axis], "axis_cage": (0.0, 0.0, 1.0)}
    return Segment(f"{axis}{number}", "free" if offers == "scalar" else "rotation", **stated)


def body_field(axis: Array, angle_rad: Array, phase: float, cage: Array) -> Array:
    """The cage's field (3,) seen from a body turned right-handed about `axis`, which lies along the cage's z."""
    about = Rotation.align_vectors([axis], [[0.0, 0.0, 1.0]])[0]
    turned = [Rotation.from_rotvec(-(a + phase) * axis) * about for a in angle_rad]
    return np.array([r.apply(cage) for r in turned])
