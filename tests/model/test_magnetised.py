"""A core's magnetisation against its differential equation, and what it remembers of its beginning."""

from __future__ import annotations

import math

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from labcal.model.effects import Scene, Shape, Term
from labcal.model.effects.hysteresis import kernel
from labcal.model.effects.magnetised import langevin, magnetised
from labcal.model.effects.regressors import per_axis

A_nT, K_nT, FAR_nT, RATE = 15e3, 6e3, 40e3, 1.0


def by_the_equation(t: np.ndarray) -> np.ndarray:
    """dM/dt of Jiles and Atherton along s = FAR sin t, solved in small steps from the curve."""

    def slope(t: float, M: np.ndarray) -> float:
        s, ds = FAR_nT * np.sin(t), FAR_nT * np.cos(t)
        lacking = 1 / np.tanh(s / A_nT) - A_nT / s - float(M[0]) if abs(s) > 1.0 else -float(M[0])
        return abs(ds) * lacking / K_nT if lacking * ds > 0 else 0.0

    found = solve_ivp(slope, (t[0], t[-1]), [0.0], t_eval=t, max_step=2e-3, rtol=1e-6)
    return np.asarray(found.y[0])


def test_a_core_follows_the_equation_of_jiles_and_atherton() -> None:
    t = np.linspace(0.0, 9.0, 400)
    M, _ = magnetised(FAR_nT * np.sin(t)[:, None], A_nT, K_nT, np.array([0]))
    assert np.abs(M[:, 0] - by_the_equation(t)).max() < 2e-3


def test_a_pinned_core_stays_where_it_is_while_its_curve_comes_to_it() -> None:
    drive = np.array([[0.0], [60e3], [59e3], [58e3]])
    M, _ = magnetised(drive, A_nT, 2e4, np.array([0]))
    assert M[1, 0] == M[2, 0] == M[3, 0] > 0


def test_what_a_core_was_is_forgotten_by_a_part_in_e_over_its_pinning_field() -> None:
    drive = np.linspace(0.0, 20e3, 201)[:, None]
    (here, left), (there, _) = (magnetised(drive, A_nT, 5e3, np.array([0]), off=off) for off in (0.0, -1e-3))
    assert np.isclose(left[50, 0], np.exp(-1))
    assert np.allclose(here - there, 1e-3 * left)


def row_by_row(drive: np.ndarray, starts: list[int], before: tuple[float, float], off: float) -> tuple[list, list]:
    """One column's state, each row from the one before it, and what is left of its beginning."""
    curve, (last, state) = langevin(drive / A_nT), before
    was, remains, states, left = float(langevin(np.array([last / A_nT]))[0]), 1.0, [], []
    for row, (field, there) in enumerate(zip(drive.tolist(), curve.tolist(), strict=True)):
        rise, way = there - was, abs(field - last) / K_nT
        if row in starts:
            state, remains = there + off, 1.0
        elif rise and (state - there) / rise < 0:
            part = min((there - state) / rise, 1.0)
            start = state if part < 1.0 else was
            keep = math.exp(-way * part)
            state = there + (state - start) * keep - (there - start) * (1 - keep) / (way * part)
            remains *= keep
        last, was = field, there
        states.append(state)
        left.append(remains)
    return states, left


@pytest.mark.parametrize("walk", ["sine", "noise", "steps", "at rest", "a sine with noise"])
def test_all_rows_at_once_are_what_they_are_one_after_the_other(walk: str) -> None:
    rng, t = np.random.default_rng(5), np.arange(3000)
    drive = {
        "sine": FAR_nT * np.sin(t / 40.0),
        "noise": rng.normal(0, FAR_nT, 3000),
        "steps": rng.choice([-5e4, -2e4, -1e3, 0.0, 1e4, 5e4], 3000 // 20).repeat(20),
        "at rest": np.full(3000, 2e4),
        "a sine with noise": FAR_nT * np.sin(t / 40.0) + rng.normal(0, 50.0, 3000),
    }[walk]
    for starts, before, off in (([0, 700, 701], (0.0, 0.0), 0.02), ([900], (-3e4, 0.4), 0.0)):
        M, left = magnetised(
            drive[:, None], A_nT, K_nT, np.array(starts), (np.array(before[:1]), np.array(before[1:])), off
        )
        states, remains = row_by_row(drive, starts, before, off)
        assert np.allclose(M[:, 0], states, rtol=0, atol=1e-11)
        assert np.allclose(left[:, 0], remains, rtol=0, atol=1e-11)


def test_a_core_goes_on_from_a_piece_as_if_it_had_not_been_cut() -> None:
    drive = FAR_nT * np.sin(np.linspace(0.0, 9.0, 300))[:, None] * [1.0, -0.3]
    whole, _ = magnetised(drive, A_nT, K_nT, np.array([0, 200]))
    head, _ = magnetised(drive[:120], A_nT, K_nT, np.array([0]))
    tail, _ = magnetised(drive[120:], A_nT, K_nT, np.array([80]), before=(drive[119], head[-1]))
    assert np.allclose(np.vstack([head, tail]), whole, rtol=0, atol=1e-12)


def test_how_a_segment_began_is_a_column_of_the_fit_alone() -> None:
    t = np.arange(80.0)
    field = FAR_nT * np.sin(t / 7.0)[:, None] * [1.0, 0.5, 0.2]
    shape = (Shape("a_nT", A_nT, "nT"), Shape("pinning_nT", K_nT, "nT"))
    term = Term(
        kernel, (*per_axis("c", "nT"), *per_axis("t1", "nT"), *per_axis("m1", "nT")), shape=shape, of_beginnings=3
    )
    fit, other = (
        term.columns(Scene(t, np.repeat([0, 1], 40), field, of_the_fit=own))[:, :, 6:] for own in (True, False)
    )
    assert not other.any()
    assert not fit[:40].any()
    assert np.array_equal(fit[40], np.eye(3))
