"""An effect of another package with a nonlinear parameter: found, proven, shipped, applied, drawn, told from rivals."""

from __future__ import annotations

import csv
import json
import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.cli import execute
from labcal.errors import InputError
from labcal.gui.ipc import study_commands
from labcal.gui.ipc.messages import CloseLoop, TryCause
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.model.effects import DELAY, SECANT, Family, Scene, Shape, Term
from labcal.model.effects.guard import guarded

KNEE_A, SIZE_nT = 0.23, np.array([400.0, -300.0, 200.0])
Making = ModuleType
Installed = Callable[[str, str, str], None]


def _shown() -> str:
    """The file that CONTRIBUTING.md shows."""
    page = (Path(__file__).parents[2] / "CONTRIBUTING.md").read_text(encoding="utf-8")
    (source,) = (code for code in re.findall("```python\n(.*?)```", page, re.DOTALL) if "FAMILY = " in code)
    return source


@pytest.fixture
def iron_core(installed: Installed) -> None:
    """The package that CONTRIBUTING.md shows."""
    installed("iron-core", "FAMILY", _shown())


def _saturating(making: Making, seed: int = 5, part: float = 1.0) -> tuple[dict[str, np.ndarray], list[dict[str, Any]]]:
    """A run whose current goes slowly to and fro and leaves an offset that saturates."""
    rows, segments = making.recorded(seed=seed)
    rows["i_load"] = 0.5 * np.sin(rows["t_s"] / 31.0) + 0.1 * np.sin(rows["t_s"] / 5.3)
    rows["dut"] += part * 1.05 * np.tanh(rows["i_load"] / KNEE_A)[:, None] * SIZE_nT
    return rows, segments


def test_it_is_found_proven_shipped_reported_and_applied(making: Making, tmp_path: Path, iron_core: None) -> None:
    bundle = making.written(tmp_path / "run", *_saturating(making))
    made = ["--json", str(tmp_path / "result.json"), "--out", str(tmp_path / "cal.json")]
    assert execute(["close-loop", str(bundle), *made, "--report", str(tmp_path / "report.html")]) == 0
    result, cal = (json.loads((tmp_path / name).read_text()) for name in ("result.json", "cal.json"))
    assert (result["verdict"], [e["effect"] for e in result["accepted"]]) == ("explained", ["iron-core"])
    (proven,), (shipped,) = result["accepted"], cal["effects"]
    assert proven["improvement_ci95_nT"][0] > 0
    assert shipped["parameters"] == proven["parameters"]
    found = {p["name"]: p for p in shipped["parameters"]}
    for name, true in (("knee_A", KNEE_A), *zip(("c_x", "c_y", "c_z"), SIZE_nT, strict=True)):
        assert abs(found[name]["value"] - true) < 4 * found[name]["u"]
    assert 0.0005 < found["knee_A"]["u"] < 0.01
    report = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "iron-core · i_load" in report
    assert "knee_A (scale)" in report
    assert "A part that a current magnetises until it is saturated." in report
    _apply_to_another_recording(making, tmp_path)


def _apply_to_another_recording(making: Making, closed: Path) -> None:
    rows, _ = _saturating(making, seed=6)
    names = ["t_s", "dut_x", "dut_y", "dut_z", "i_load"]
    table = np.column_stack([rows["t_s"], rows["dut"], rows["i_load"]])
    with (closed / "in.csv").open("w", newline="") as file:
        csv.writer(file).writerows([names, *table.tolist()])
    assert execute(["apply", str(closed / "cal.json"), str(closed / "in.csv"), "--out", str(closed / "out.csv")]) == 0
    done = list(csv.DictReader((closed / "out.csv").read_text().splitlines()))
    field = np.array([[float(row[f"b_{a}"]) for a in "xyz"] for row in done])
    clean, _ = making.recorded(seed=6)
    true = (clean["dut"] - 800) / 1.05
    assert np.sqrt(np.mean((field - true) ** 2)) < 5.0  # of an offset of 300


@pytest.mark.slow
def test_the_window_draws_it_against_what_it_says(making: Making, tmp_path: Path, iron_core: None) -> None:
    bundle = str(making.written(tmp_path / "run", *_saturating(making)))
    said = study_commands.loop(_Quiet(), CloseLoop(bundle))  # type: ignore[arg-type]  # a channel nobody hears
    assert said.accepted[0].effect == "iron-core"
    assert (said.drawn_against["iron-core"], said.drawn_against["lag"]) == ("time", "angle")
    alone = study_commands.cause(_Quiet(), TryCause(bundle, "iron-core", ("i_load",)))  # type: ignore[arg-type]  # likewise
    assert np.std(alone.after) < 0.5 * np.std(alone.before)


class _Quiet:
    def send(self, *_: Any, **__: Any) -> None:
        """Nobody listens."""


@pytest.mark.slow
def test_an_experiment_tells_it_from_a_rival(
    making: Making, tmp_path: Path, iron_core: None, closed_loop: Callable[[Path], tuple[int, dict[str, Any], str]]
) -> None:
    rows, segments = _saturating(making, part=0.3)
    rows["temp"] = 20 + 3 * np.tanh(rows["i_load"] / KNEE_A)  # the load warms the room: either could be the cause
    code, result, _ = closed_loop(making.written(tmp_path / "alike", rows, segments))
    assert (code, result["verdict"]) == (1, "ambiguous")
    (named,) = result["accepted"]
    assert {named["effect"], *(r["effect"] for r in named["rivals"])} >= {"iron-core", "offset-temperature"}
    assert "current-coupling" in {r["procedure"] for r in result["next_experiment"]["ranking"]}


IN_C = """

from dataclasses import replace

from labcal.model.effects.c_form import CForm, Input, identifier


def in_c(term):
    (name,) = term.channels
    bent = f"(labcal_real)tanh((now->input[0] - {term.reference_value[name]!r}) / shape[0])"
    given = Input(identifier(name), "A", "the current", lambda scene: scene.channels[name], name)
    return CForm("e = c tanh(i / knee)", "".join(f"e[{k}][{k}] = {bent};\\n" for k in range(3)), (given,))


FAMILY = replace(FAMILY, in_c=in_c)
"""
CC = shutil.which("cc") or shutil.which("gcc")


@pytest.mark.skipif(CC is None, reason="needs a C compiler")
def test_it_flies(making: Making, tmp_path: Path, installed: Installed) -> None:
    installed("iron-core", "FAMILY", _shown() + IN_C)
    bundle, cal, out = making.written(tmp_path / "run", *_saturating(making)), tmp_path / "cal.json", tmp_path / "c"
    assert execute(["close-loop", str(bundle), "--out", str(cal)]) == 0
    assert execute(["export", str(cal), "--format", "c", "--out", str(out)]) == 0
    strict = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-o", "flies")
    subprocess.run([str(CC), *strict, "labcal_calibration.c", "main.c", "-lm"], cwd=out, check=True)
    said = subprocess.run([out / "flies"], cwd=out, capture_output=True, text=True, check=False)
    assert (said.returncode, said.stdout[:5]) == (0, "good:"), said


SCANNED = """
import numpy as np
from labcal.loop.candidates.available import all_candidates
from labcal.loop.candidates.refine import refined
from labcal.loop.candidates.scorer import CandidateSet
from labcal.model.effects import DELAY, FREQUENCY, MOMENT, Family, Shape, Term
from labcal.model.effects.regressors import delayed, moving, on_each_axis, per_axis

AT, OF = Shape("at", 0.0, "s", kind=MOMENT), Shape("of", 0.0, "Hz", kind=FREQUENCY)
BY = Shape("by", 1.0, "s", (1.0, 2.0, 3.0, 4.0), DELAY)


def jump(term, scene):
    return (scene.along_axes_nT * (scene.t_s >= term.at("at"))[:, None])[:, None, :] * scene.axes


def echo(term, scene):
    return on_each_axis(delayed(scene.t_s, scene.segment, term.drive(scene), term.at("by")))


def hum(term, scene):
    angle = 2 * np.pi * term.at("of") * scene.t_s
    return np.concatenate([on_each_axis(np.cos(angle)), on_each_axis(np.sin(angle))], axis=2)


def echoes(run):
    return [Term(echo, per_axis("c", "nT/V"), (c.name,), {c.name: 0.0}, (BY,)) for c in moving(run, ("voltage",))]


def hums(run):
    return [Term(hum, (*per_axis("a", "nT"), *per_axis("b", "nT")), shape=(OF,))]


JUMP = Family("gain-jump", "sensor", jump, lambda run: [Term(jump, per_axis("g", "1"), shape=(AT,))], shapes=(AT,))
ECHO = Family("echo", "sensor", echo, echoes, shapes=(BY,))
HUM = Family("hum", "sensor", hum, hums, shapes=(OF,))
"""


def test_delays_moments_and_lines_of_other_packages_are_found_whatever_they_are_called(
    making: Making, installed: Installed, searching: Callable[..., CandidateSet]
) -> None:
    for effect, name in (("gain-jump", "JUMP"), ("echo", "ECHO"), ("hum", "HUM")):
        installed(effect, name, SCANNED)
    rows, _ = making.recorded()
    t = rows["t_s"]
    v = np.mod(t, 29.0) < 11.0
    jump, hum = 2e-3 * rows["dut"] * (t >= 190.3)[:, None], 50 * np.cos(2 * np.pi * 0.31 * t)[:, None] * np.ones(3)
    late = 90.0 * np.interp(t - 3.0, t, v.astype(float))[:, None] * np.array([1.0, -1.0, 0.5])
    for added, effect, true in ((jump, "gain-jump", 190.3), (hum, "hum", 0.31), (late, "echo", 3.0)):
        pool = searching({"v": v.astype(float)}, {"v": "voltage"}, added)
        found = [c for c in all_candidates(pool, ()) if c.family.id == effect]
        best = refined(pool, pool.rank(found)[0].candidate, ())
        assert best.term.shape[0].value == pytest.approx(true, rel=0.03)


BARE = (Shape("knee_A", 1.0, "A", (1.0, 2.0)),)


@pytest.mark.parametrize(
    ("shapes", "stated", "words"),
    [
        (BARE, (), "does not state its parameter knee_A"),
        ((replace(BARE[0], kind=DELAY),), BARE, "does not state its parameter knee_A and that one's kind"),
        ((replace(BARE[0], kind=DELAY),), None, "has to delay a channel"),
        ((replace(BARE[0], kind=SECANT),), None, "has to belong to the one linear parameter"),
    ],
)
def test_a_parameter_that_could_not_be_searched_is_refused_with_its_name(
    making: Making, tmp_path: Path, shapes: tuple[Shape, ...], stated: tuple[Shape, ...] | None, words: str
) -> None:
    family = _guarded(shapes, shapes if stated is None else stated)
    run = session.load_run(str(making.written(tmp_path, *making.recorded())))
    with pytest.raises(InputError, match=words):
        family.candidates(run)


def test_a_family_that_names_its_parameters_alone_is_refused() -> None:
    with pytest.raises(InputError, match="something else than a Shape"):
        _guarded(BARE, ("knee_A",))  # type: ignore[arg-type]  # wrong on purpose


def test_its_terms_are_known_as_its_own(making: Making, tmp_path: Path) -> None:
    run = session.load_run(str(making.written(tmp_path, *making.recorded())))
    (term,) = (family := _guarded(BARE, BARE)).candidates(run)
    assert term.kernel is family.kernel  # so the joint fit knows whose it is


def _guarded(shapes: tuple[Shape, ...], stated: tuple[Shape, ...]) -> Family:
    def kernel(term: Term, scene: Scene) -> np.ndarray:
        return np.zeros((len(scene), 3, 2))

    term = Term(kernel, (("c", "nT"), ("d", "nT")), shape=shapes)
    return guarded(Family("iron-core", "sensor", kernel, lambda run: [term], shapes=stated), "iron_core:FAMILY")
