"""What a segment offers, and the reference carried into the body by the contract's formula, written out again."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from labcal.record import Dut, Reference, Run, Segment, carry

AXIS_BODY = np.array([2.0, -1.0, 2.0]) / 3
AXIS_CAGE = np.array([0.0, 0.6, 0.8])
FIELD_nT = np.array([21_000.0, -8_000.0, 35_000.0])


def attitude(start_deg: float) -> np.ndarray:
    """A rotation that carries the axis in the cage onto that in the body."""
    (found, _) = Rotation.align_vectors([AXIS_BODY], [AXIS_CAGE])
    return Rotation.from_rotvec(np.radians(start_deg) * AXIS_BODY).as_matrix() @ found.as_matrix()


def run_of(segment: Segment, angle_deg: list[float]) -> Run:
    n = len(angle_deg)
    return Run(
        run_id="r",
        started_utc="2026-01-01",
        simulated=True,
        operator="",
        dut=Dut("SN1"),
        reference=Reference("vector"),
        segments=(segment,),
        t_s=np.arange(n, dtype=float),
        segment_index=np.zeros(n, dtype=np.intp),
        reading=np.zeros((n, 3)),
        reference_vector=np.tile(FIELD_nT, (n, 1)),
        angle_deg=np.array(angle_deg),
    )


def three(v: np.ndarray) -> tuple[float, float, float]:
    x, y, z = v.tolist()
    return x, y, z


def stated(kind: Literal["rotation", "static"]) -> Segment:
    a, b, c = (three(row) for row in attitude(40.0))
    return Segment("a", kind, axis_body=three(AXIS_BODY), axis_cage=three(AXIS_CAGE), body_from_cage=(a, b, c))


@pytest.mark.parametrize("kind", ["rotation", "static"])
def test_the_attitude_holds_at_angle_zero(kind: Literal["rotation", "static"]) -> None:
    seen = carry(run_of(stated(kind), [0.0, 75.0, 75.0, -200.0]))
    assert set(seen.observation) == {"vector"}
    for row, angle in enumerate([0.0, 75.0, 75.0, -200.0]):
        turned = Rotation.from_rotvec(-np.radians(angle) * AXIS_BODY).as_matrix()
        np.testing.assert_allclose(seen.vector[row], turned @ attitude(40.0) @ FIELD_nT, atol=1e-6)


@pytest.mark.parametrize("angles", [[np.nan, np.nan], [75.0, 75.0]], ids=["no angle", "no axis to turn about"])
def test_at_rest_the_attitude_stands_where_no_angle_turns_it(angles: list[float]) -> None:
    segment = stated("static")
    if np.isfinite(angles[0]):
        segment = replace(segment, axis_body=None, axis_cage=None)
    seen = carry(run_of(segment, angles))
    np.testing.assert_allclose(seen.vector, np.tile(attitude(40.0) @ FIELD_nT, (2, 1)), atol=1e-6)
