"""What chance alone would name: runs with nothing but correlated noise, beside twenty channels that say nothing."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal.loop.policy import POLICY
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.loop.selection.surrogates import null_distribution

NOISE_nT, MEMORY_S, STEP_S = 25.0, 8.0, 0.5
QUANTITIES = ("current", "temperature", "voltage", "power")


def _wander(draw: np.random.Generator, n: int, memory: float, columns: int) -> np.ndarray:
    """Exponentially correlated noise (n, columns) of unit size, its memory in rows."""
    keep = np.exp(-1 / memory)
    out = draw.normal(0, 1, (n, columns))
    for row in range(1, n):
        out[row] = keep * out[row - 1] + np.sqrt(1 - keep**2) * out[row]
    return out


@pytest.mark.parametrize("seeds", [range(1), pytest.param(range(10, 220), marks=pytest.mark.slow)], ids=["one", "many"])
def test_correlated_noise_is_given_no_name_beside_twenty_smooth_channels(
    making: ModuleType, searching: Any, seeds: range
) -> None:
    """Of 210 runs at most two in a hundred; the price alone holds this, without a p-value."""
    n, named = len(making.recorded()[0]["t_s"]), 0
    for seed in seeds:
        draw = np.random.default_rng(9000 + seed)
        smooth = [_wander(draw, n, memory, 1)[:, 0].cumsum() for memory in draw.uniform(10, 200, 20)]
        channels = {f"c{k}": values / np.std(values) for k, values in enumerate(smooth)}
        noise = NOISE_nT * _wander(draw, n, MEMORY_S / STEP_S, 3)
        quantities = {name: QUANTITIES[k % 4] for k, name in enumerate(channels)}
        pool = searching(channels, quantities, noise, seed=seed)
        named += bool(stepwise_forward(pool)[0])
    assert null_distribution(pool, ()).max() < POLICY.min_evidence
    assert named <= 0.02 * len(seeds)
