"""Iron beside the cage whose tensor is more of a turn than iron can be: a lean of the platform is in it."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotate, rotation_vector, shortest_rotation
from labcal.loop import close_loop
from labcal.loop.result import ClosedLoop
from labcal.loop.selection import taken_apart
from labcal.model.effects import iron
from labcal.model.effects.iron import BESIDE, SYMMETRIC, without_lean

UP = np.array([0.0, 0.0, 1.0])
LEAN_deg = np.array([0.9, -0.6, 0.0])
ALL_A_TURN = np.array([[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 0.0]]).ravel()


def dipole_tensor(r: np.ndarray) -> np.ndarray:
    """Of the field at r (3,) of a dipole, which has no trace."""
    n = r / np.linalg.norm(r)
    return np.asarray((3 * np.outer(n, n) - np.eye(3)) / np.linalg.norm(r) ** 3)


def polarisability(draw: np.random.Generator) -> np.ndarray:
    """Of a body unlike in its directions by up to a thousand times."""
    turned = rotation_vector(draw.normal(size=3))
    return np.asarray(turned @ np.diag(10 ** draw.uniform(-3, 0, 3)) @ turned.T)


def test_no_body_answers_by_more_of_a_turn_than_of_all_else() -> None:
    draw, nothing = np.random.default_rng(1), np.zeros((9, 9))
    for _ in range(3000):
        T = dipole_tensor(draw.normal(size=3)) @ polarisability(draw)
        assert without_lean(BESIDE, T.T.ravel(), nothing) == ()


def test_a_lean_is_more_of_a_turn_unless_noise_may_have_made_it() -> None:
    turn = np.array([[0.0, 0.01, 0.02], [-0.01, 0.0, -0.01], [-0.02, 0.01, 0.0]])
    names = (("c_x", "nT"), *BESIDE)
    for u, sure in ((1e-4, True), (0.02, False)):
        found = without_lean(names, np.r_[5.0, turn.ravel()], u**2 * np.eye(10))
        assert found[:1] == (((("c_x", "nT"), *SYMMETRIC),) if sure else ())
    assert without_lean((("c_x", "nT"),), np.ones(1), np.eye(1)) == ()


def answered(making: ModuleType, folder: Path, answers: np.ndarray, lean_deg: np.ndarray) -> ClosedLoop:
    """What the loop says of six mountings on a platform that leans beside iron with a tensor (3, 3)."""
    rows, segments = making.recorded(seconds=60.0)
    draw, seen = np.random.default_rng(3), np.zeros_like(rows["dut"])
    for segment in segments:
        mount, here = shortest_rotation(UP, segment["axis_body"]), rows["segment"] == segment["id"]
        segment |= {"axis_cage": UP.tolist(), "body_from_cage": mount.tolist()}
        rows["ref"][here] = 45000 * (v := draw.normal(size=3)) / np.linalg.norm(v)
        there = rows["ref"][here] @ (np.eye(3) + answers).T @ rotation_vector(-np.radians(lean_deg)).T
        seen[here] = rotate(UP, -rows["angle"][here], there) @ mount.T
    rows["dut"] = 1.05 * seen + 800 + draw.normal(0, making.NOISE_nT, seen.shape)
    return close_loop(session.load_run(str(making.written(folder, rows, segments))))


@pytest.mark.parametrize(
    ("size", "lean_deg", "named"),
    [
        (1e-3, LEAN_deg, ["axis-tilt", "cage-field"]),
        (1e-2, 0.1 * LEAN_deg, ["cage-field"]),  # nobody can tell
        pytest.param(1e-2, 0 * LEAN_deg, ["cage-field"], marks=pytest.mark.slow),
        (0.0, LEAN_deg, ["axis-tilt"]),
    ],
)
def test_a_lean_that_iron_could_not_do_is_named_beside_it(
    making: ModuleType, tmp_path: Path, size: float, lean_deg: np.ndarray, named: list[str]
) -> None:
    answers = size * dipole_tensor(np.array([0.5, 0.8, -0.4])) @ np.diag([1.0, 0.3, 0.5])
    closed = answered(making, tmp_path, answers, lean_deg)
    assert [one.effect for one in closed.accepted] == named
    assert closed.verdict == "explained"
    if len(named) == 2:
        found = {p.name: p for one in closed.accepted for p in one.parameters}
        off = [found[f"cage_{a}"].value - lean_deg["xyz".index(a)] for a in "xy"]
        assert np.abs(off).max() < 0.1
    assert np.abs(closed.affine.K @ (1.05 * np.eye(3)) - np.eye(3)).max() < max(0.5 * size, 3e-4)


def test_where_iron_alone_does_as_well_no_lean_is_named(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A tensor with more freedom than the run fixes may seem to turn: all fits are held to be as good here."""
    forms = without_lean(BESIDE, ALL_A_TURN, np.zeros((9, 9)))
    monkeypatch.setattr(iron, "without_lean", lambda names, *_: forms if set(BESIDE) <= set(names) else ())
    monkeypatch.setattr(taken_apart, "information", lambda fitted: 0.0)
    answers = 1e-2 * dipole_tensor(np.array([0.5, 0.8, -0.4])) @ np.diag([1.0, 0.3, 0.5])
    closed = answered(making, tmp_path, answers, 0 * LEAN_deg)
    assert [one.effect for one in closed.accepted] == ["cage-field"]
    assert [p.name for p in closed.accepted[0].parameters] == [name for name, _ in SYMMETRIC]


def test_a_lean_that_was_given_up_is_not_put_there_again(
    making: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """There is none, and each fit is held to be as good: the loop would go round for ever."""
    whole = (*((f"c_{axis}", "nT") for axis in "xyz"), *BESIDE)
    forms = (whole, SYMMETRIC)  # with a lean the second is smaller than the first alone
    monkeypatch.setattr(iron, "without_lean", lambda names, *_: forms if set(BESIDE) <= set(names) else ())
    monkeypatch.setattr(taken_apart, "information", lambda fitted: 0.0)
    answers = 1e-2 * dipole_tensor(np.array([0.5, 0.8, -0.4])) @ np.diag([1.0, 0.3, 0.5])
    closed = answered(making, tmp_path, answers, 0 * LEAN_deg)
    assert [one.effect for one in closed.accepted] == ["cage-field"]
