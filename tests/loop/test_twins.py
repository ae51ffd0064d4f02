"""Causes that no run of a kind can tell apart, and the run that can."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest


@pytest.mark.parametrize("backwards", [False, True])
def test_a_lag_at_one_rate_is_the_phases_and_turning_backwards_tells_it(
    making: ModuleType, tmp_path: Path, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]], backwards: bool
) -> None:
    rows, segments = making.recorded()
    rate = np.full(len(rows["t_s"]), np.radians(making.RATE_DEG_PER_S))
    for segment in segments[3:] if backwards else []:
        there = np.flatnonzero(rows["segment"] == segment["id"])
        rate[there] *= -1
        for name in ("dut", "angle"):
            rows[name][there] = rows[name][there[::-1]]
    rows["angle"] += rate * 0.1  # what is read was the field a tenth of a second ago
    for segment in segments:  # one unknown phase for each mounting
        del segment["body_from_cage"]
        segment["mounting"] = segment["id"][0]
    _, result, _ = closed_loop(making.written(tmp_path, rows, segments))
    assert [effect["effect"] for effect in result["accepted"]] == (["lag"] if backwards else [])
    assert result["verdict"] == ("explained" if backwards else "clean")
