"""Iron that the cage's field magnetises, and a motor's magnets: one name, and the device's own map beside it."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from labcal import session
from labcal.geometry import rotate, rotation, rotation_vector, shortest_rotation
from labcal.loop.candidates.angle_zeros import Search, angle_zeros
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.loop.selection.equivalents import equally_likely
from labcal.loop.selection.joint_fit import joint_fit
from labcal.loop.selection.stepwise import stepwise_forward
from labcal.model.effects import family
from labcal.model.effects.iron import table_axes
from labcal.model.effects.scene import Rig

Rows = dict[str, np.ndarray]
UP = np.array([0.0, 0.0, 1.0])
ANSWER = 1e-3 * np.array([[4.0, -2.5, 1.0], [3.0, -1.5, 5.0], [-2.0, 3.5, 6.0]])  # of iron to the field about it
REMANENT_nT = np.array([180.0, -260.0, 120.0])
ZEROS = (0.4, -1.9, 2.2, 1.1, -0.7, 2.9)  # rad, of the platform's angle in each mounting


class Table:
    """Six mountings on a platform that stands upright, each in a field of another direction."""

    def __init__(self, making: ModuleType) -> None:
        self.making = making
        self.rows, self.segments = making.recorded(seconds=60.0)
        draw = np.random.default_rng(3)
        self.number = np.zeros(len(self.rows["t_s"]), dtype=int)
        for k, segment in enumerate(self.segments):
            mount = shortest_rotation(UP, segment["axis_body"])
            segment |= {"axis_cage": UP.tolist(), "body_from_cage": mount.tolist()}
            here = self.rows["segment"] == segment["id"]
            self.number[here] = k
            self.rows["ref"][here] = 45000 * (v := draw.normal(size=3)) / np.linalg.norm(v)
        self.mounts = np.array([segment["body_from_cage"] for segment in self.segments])[self.number]
        self.to_table = rotation(UP, -self.rows["angle"])
        self.on = (np.mod(self.rows["t_s"], 21.0) < 9.0).astype(float)

    def problem(self, folder: Path, in_table_nT: np.ndarray, zero: str = "stated") -> LinearProblem:
        """The base fitted to what the device reads with a field on it that is given along the table's axes.

        The attitude at the platform's zero is `stated`, or unknown beside `one` zero, or another for `each` mounting.
        """
        seen = np.einsum("nij,njk,nk->ni", self.mounts, self.to_table, self.rows["ref"])
        seen = seen + np.einsum("nij,nj->ni", self.mounts, in_table_nT)
        noise = np.random.default_rng(4).normal(0, self.making.NOISE_nT, seen.shape)
        rows, segments = dict(self.rows, dut=1.05 * seen + 800 + noise, motor_on=self.on), self.segments
        if zero == "each":
            rows["angle"] = rows["angle"] + np.array(ZEROS)[self.number]
        if zero != "stated":
            segments = [{k: v for k, v in s.items() if k != "body_from_cage"} for s in segments]
        channels = self.making.CHANNELS | {"motor_on": {"unit": "1", "quantity": "other", "role": "platform"}}
        return prepare(session.load_run(str(self.making.written(folder, rows, segments, channels))))[0]

    def cage(self, name: str) -> np.ndarray:
        """What stands in the cage or turns there, along the table's axes (n, 3)."""
        if name == "beside":
            in_cage = self.rows["ref"] @ ANSWER.T + REMANENT_nT
        elif name == "motor":
            poles = rotate(UP, 3 * self.rows["angle"], np.tile([90.0, -40.0, 70.0], (len(self.on), 1)))
            in_cage = poles + self.on[:, None] * (poles + [120.0, 60.0, -150.0])
        else:
            return np.asarray(np.einsum("nij,nj->ni", self.to_table, self.rows["ref"]) @ ANSWER.T + REMANENT_nT)
        return np.asarray(np.einsum("nij,nj->ni", self.to_table, in_cage))


@pytest.mark.parametrize(
    ("where", "channels", "zero"),
    [
        ("beside", (), "stated"),
        ("on the table", (), "one"),
        ("motor", ("motor_on",), "one"),
        pytest.param("beside", (), "each", marks=pytest.mark.slow),
        *(pytest.param("on the table", (), zero, marks=pytest.mark.slow) for zero in ("stated", "each")),
        *(pytest.param("motor", ("motor_on",), zero, marks=pytest.mark.slow) for zero in ("stated", "each")),
    ],
)
def test_iron_and_a_motor_are_one_field_of_the_cage_down_to_the_noise(
    making: ModuleType, tmp_path: Path, where: str, channels: tuple[str, ...], zero: str
) -> None:
    table = Table(making)
    pool = CandidateSet.of(table.problem(tmp_path, table.cage(where), zero), 0.85)
    assert np.sqrt(np.mean(pool.residual(()) ** 2)) > 2
    accepted, _ = stepwise_forward(pool)
    assert [c.cause for c in accepted] == [("cage-field", channels)]
    assert np.sqrt(np.mean(pool.residual(accepted) ** 2)) < 1.1


@pytest.mark.parametrize(("where", "turns"), [("on the table", 1), ("motor", 3)])
def test_where_the_angle_begins_in_each_mounting_is_found(
    making: ModuleType, tmp_path: Path, where: str, turns: int
) -> None:
    """A motor of three pole pairs looks alike three times a turn."""
    table = Table(making)
    pool = CandidateSet.of(table.problem(tmp_path, table.cage(where), "each"), 0.85)
    (found,) = stepwise_forward(pool)[0]
    off = np.array([s.value for s in found.term.shape]) - (np.array(ZEROS[1:]) - ZEROS[0])
    assert np.abs(np.sin(turns * off / 2)).max() < 0.1
    assert found.size == len(found.term.parameters) + len(ZEROS) - 1


def test_columns_from_any_zeros_come_from_those_at_seven(making: ModuleType, tmp_path: Path) -> None:
    """What least squares leaves with them is what it leaves with the columns themselves."""
    table = Table(making)
    pool = CandidateSet.of(table.problem(tmp_path, table.cage("on the table"), "each"), 0.85)
    (term,) = (t for t in family("cage-field").candidates(pool.problem.run) if t.parameters[0][0] == "t_u" and t.shape)
    zeros = np.array([0.3, -2.0, 1.2, 3.0, -0.4])
    at = term.with_values(**{s.name: float(v) for s, v in zip(term.shape, zeros, strict=True)})
    A = np.concatenate([pool.problem.T, pool.problem.all_columns(at)], axis=2).reshape(pool.problem.y.size, -1)
    y = pool.problem.y.ravel()
    A /= np.linalg.norm(A, axis=0)
    left = y - A @ np.linalg.lstsq(A, y, rcond=1e-9)[0]
    search = Search.of(pool, (), term)
    outside = float(np.sum(pool.residual(()) ** 2) - np.sum(search.z**2))
    assert outside + np.sum(search.left(zeros) ** 2) == pytest.approx(float(np.sum(left**2)), rel=1e-3)

    def square(at: np.ndarray) -> float:
        return float(np.sum(search.left(at) ** 2))

    steps = 1e-5 * np.eye(len(zeros))
    differences = [(square(zeros + step) - square(zeros - step)) / 2e-5 for step in steps]
    slopes = 2 * search.left(zeros) @ search.slopes(zeros)
    assert slopes == pytest.approx(differences, rel=1e-4, abs=1e-4 * np.abs(differences).max())


def test_a_mounting_of_which_no_row_is_left_has_no_zero_and_the_others_have(making: ModuleType, tmp_path: Path) -> None:
    table = Table(making)
    pool = CandidateSet.of(table.problem(tmp_path, table.cage("on the table"), "each"), 0.85)
    fewer = pool.on(table.number != 2)
    found = {c.term.parameters[0][0]: c.term for c in angle_zeros(fewer, ())}["t_u"]
    off = np.array([s.value for s in found.shape]) - (np.array(ZEROS[1:]) - ZEROS[0])
    assert np.abs(np.sin(np.delete(off, 1) / 2)).max() < 0.05


def test_a_tilted_axis_alone_has_no_rival_in_iron_that_can_turn_the_field_too(
    making: ModuleType, tmp_path: Path
) -> None:
    table = Table(making)
    leaning = rotation_vector(np.radians([1.1, -0.5, 0.0])) - np.eye(3)
    turned = np.einsum("nij,nj->ni", table.to_table, table.rows["ref"] @ leaning.T)
    pool = CandidateSet.of(table.problem(tmp_path, turned, "each"), 0.85)
    chosen = next(c for c in pool.candidates if c.family.id == "axis-tilt" and len(c.term.parameters) == 2)
    iron = next(c for c in pool.candidates if c.term.parameters[-1][0] == "bz_z")
    assert pool.score(iron, pool.null_model()).evidence > 100
    assert [w.candidate.family.id for w in equally_likely(pool, [chosen], chosen)] == ["axis-tilt"]


@pytest.mark.slow
def test_nothing_is_added_where_there_is_no_iron(making: ModuleType, tmp_path: Path) -> None:
    table = Table(making)
    for zero in ("stated", "one", "each"):
        problem = table.problem(tmp_path / zero, np.zeros((len(table.on), 3)), zero)
        assert stepwise_forward(CandidateSet.of(problem, 0.85))[0] == []


@pytest.mark.parametrize("axis", [UP, np.array([0.48, -0.6, 0.64])])
def test_the_tables_axes_turn_with_it(axis: np.ndarray) -> None:
    angle = np.array([0.0, 0.9, np.nan])
    to_body = np.stack([rotation(axis, -a) for a in np.nan_to_num(angle)])
    none, cage = np.zeros((3, 3)), np.tile(axis, (3, 1))
    axes = table_axes(Rig(none, none, to_body, cage, cage, angle, np.zeros(3, dtype=np.intp)))
    assert np.allclose(axes[0], axes[1])  # this body turns with the table
    assert np.allclose(axes[0].T @ axes[0], np.eye(3))
    assert np.allclose(axes[0][:, 2], axis)
    assert np.linalg.det(axes[0]) == pytest.approx(1.0)
    assert not axes[2].any()


def test_what_iron_on_the_table_answers_has_harmonics_up_to_the_second(making: ModuleType, tmp_path: Path) -> None:
    table = Table(making)
    problem = table.problem(tmp_path, np.zeros((len(table.on), 3)))
    (term,) = (t for t in family("cage-field").candidates(problem.run) if t.parameters[0][0] == "t_u")
    here = problem.scene
    assert here.rig is not None
    first = table.number == 0
    in_cage = np.einsum("nji,njp->nip", here.rig.to_body, term.columns(here))[first]
    angle = here.rig.angle_rad[first]
    waves = np.column_stack([np.ones(first.sum()), *(w(h * angle) for h in (1, 2) for w in (np.cos, np.sin))])
    flat = in_cage.reshape(len(angle), -1)
    left = flat - waves @ np.linalg.lstsq(waves, flat, rcond=None)[0]
    assert np.abs(left).max() < 1e-6 * np.abs(flat).max()


@pytest.mark.parametrize("kind", ["b", "t"], ids=["beside", "on the table"])
def test_the_gain_is_that_beside_which_the_iron_s_answer_has_no_trace(
    making: ModuleType, tmp_path: Path, kind: str
) -> None:
    """The field of a dipole has none, and a run does not tell an answer alike in all directions from a gain."""
    table, away = Table(making), np.array([0.8, 0.36, -0.48])
    answer = 6e-3 * (3 * np.outer(away, away) - np.eye(3))
    driven = table.rows["ref"] if kind == "b" else np.einsum("nij,nj->ni", table.to_table, table.rows["ref"])
    made = driven @ answer.T + REMANENT_nT
    in_table = np.einsum("nij,nj->ni", table.to_table, made) if kind == "b" else made
    problem = table.problem(tmp_path, in_table)
    diagonal = [f"{kind}{a}_{a}" for a in ("xyz" if kind == "b" else "uvw")]
    forms = [t for t in family("cage-field").candidates(problem.run) if {*diagonal} <= {n for n, _ in t.parameters}]
    found = joint_fit(problem, forms[:1])
    assert np.abs(np.diag(found.problem.affine.K) * 1.05 - 1).max() < 2e-4
    names = [name for name, _ in forms[0].parameters]
    assert abs(sum(found.beta[0][names.index(name)] for name in diagonal)) < 1e-9
