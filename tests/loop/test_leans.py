"""Axes that lean by degrees: what a lean misses of second order is a lean's as well, and no gradient's."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotation, rotation_vector, shortest_rotation
from labcal.loop import close_loop

UP = np.array([0.0, 0.0, 1.0])
LEANS_deg = {"x": (-2.6, 2.0, 0.0), "y": (1.7, 1.3, 0.0), "z": (1.0, -2.4, 0.0)}  # of each way of mounting, in the cage


@pytest.mark.parametrize("size", [1.0, 0.1])
def test_each_mounting_with_its_own_lean_is_a_tilt_alone_and_the_map_is_right(
    making: ModuleType, tmp_path: Path, size: float
) -> None:
    rows, segments = making.recorded(seconds=60.0)
    draw, seen = np.random.default_rng(8), np.zeros_like(rows["dut"])
    for segment in segments:
        mount, here = shortest_rotation(UP, segment["axis_body"]), rows["segment"] == segment["id"]
        segment |= {"axis_cage": UP.tolist(), "body_from_cage": mount.tolist()}
        leans = rotation_vector(-np.radians(LEANS_deg[segment["id"][0]]) * size)
        turned = rotation(np.array(segment["axis_body"]), -rows["angle"][here]) @ mount @ leans
        seen[here] = np.einsum("nij,nj->ni", turned, rows["ref"][here])
    rows["dut"] = 1.05 * seen + 800 + draw.normal(0, making.NOISE_nT, seen.shape)
    closed = close_loop(session.load_run(str(making.written(tmp_path, rows, segments))))
    assert [(one.effect, one.rivals) for one in closed.accepted] == [("axis-tilt", ())]
    assert closed.verdict == "explained"
    off = 50_000 * (closed.affine.K - np.eye(3) / 1.05)
    u = 50_000 * np.sqrt(np.diag(closed.fit().covariance)[:9].reshape(3, 3))
    assert (np.abs(off) < 4 * u).all()
