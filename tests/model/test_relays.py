"""Preisach's relays of all widths, against relays that switch one by one."""

from __future__ import annotations

import numpy as np
import pytest

from labcal.model.effects import Scene, Shape, Term
from labcal.model.effects.hysteresis import kernel
from labcal.model.effects.regressors import per_axis

R_nT, SPREAD, MIDDLES_nT, FAR_nT, COUNT = 5e3, 0.6, 12e3, 45e3, 20_000
SHAPE = (Shape("r_nT", R_nT, "nT"), Shape("middles_nT", MIDDLES_nT, "nT"), Shape("sd_ln", SPREAD, "1"))


def switched_one_by_one(drive: np.ndarray, up: np.ndarray | None = None) -> np.ndarray:
    """The mean of relays along a drive (n,); each begins up or down (`up`), else by the side of its middle."""
    draw = np.random.default_rng(1)
    half = R_nT * np.exp(SPREAD * draw.normal(size=COUNT))
    middle = draw.logistic(0.0, MIDDLES_nT / 2, COUNT)  # whose distribution function is a tanh
    state = np.where(drive[0] > middle, 1.0, -1.0) if up is None else up
    out = np.empty(len(drive))
    for k, s in enumerate(drive):
        state = np.where(s > middle + half, 1.0, np.where(s < middle - half, -1.0, state))
        out[k] = state.mean()
    return out


def relays(drive: np.ndarray, segment: np.ndarray | None = None, *, begun: int = 0) -> tuple[np.ndarray, np.ndarray]:
    """The mean (n,) along the first axis by the effect's columns, and its columns of the beginnings (n, begun)."""
    n = len(drive)
    names = tuple(p for k in range(begun) for p in per_axis(f"m{k}", "nT"))
    parameters = (*per_axis("c", "nT"), *per_axis("t1", "nT"), *names)
    term = Term(kernel, parameters, shape=SHAPE, of_beginnings=len(names))
    field = drive[:, None] * [1.0, 0.5, 0.0]
    where = np.zeros(n, dtype=np.intp) if segment is None else segment
    columns = term.columns(Scene(np.arange(float(n)), where, field, of_the_fit=True))[:, 0]
    return columns[:, 0] + np.tanh(drive / MIDDLES_nT), columns[:, 6::3]


def swept(to_nT: float, rows: int = 240) -> np.ndarray:
    return to_nT * np.sin(np.linspace(0.3, 11.0, rows))


@pytest.mark.parametrize("to_nT", [8e3, FAR_nT])
def test_the_mean_of_all_relays_is_that_of_relays_one_by_one(to_nT: float) -> None:
    drive = swept(to_nT)
    loop = np.ptp(relays(drive)[0] - np.tanh(drive / MIDDLES_nT))
    assert loop > 0.1
    assert np.abs(relays(drive)[0] - switched_one_by_one(drive)).max() < 0.1 * loop


def test_a_segment_that_begins_with_all_relays_down_differs_by_its_column() -> None:
    drive = swept(20e3)
    rest, (left,) = (relays(drive, begun=1)[0], relays(drive, begun=1)[1].T)
    down = switched_one_by_one(drive, np.full(COUNT, -1.0)) - rest
    part = float(left @ down / (left @ left))
    assert part < -0.5
    assert np.sum((down - part * left) ** 2) < 0.2 * np.sum(down**2)  # no segment can begin farther off


def test_each_segment_has_a_beginning_of_its_own_and_soon_forgets_it() -> None:
    drive, segment = np.tile(swept(FAR_nT, 120), 2), np.repeat([0, 1], 120)
    left = relays(drive, segment, begun=2)[1]
    assert not left[:120, 1].any()
    assert not left[120:, 0].any()
    assert np.allclose(left[:120, 0], left[120:, 1])
    assert np.abs(left[60:120, 0]).max() < 0.05 * left[0, 0]
