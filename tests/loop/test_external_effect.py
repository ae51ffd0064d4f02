"""An effect in one file outside the project: picked up by its entry point, it cures a run nothing else explains."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from importlib.metadata import EntryPoint
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.cli import execute
from labcal.errors import InputError
from labcal.model.effects import Family, Scene, Shape, Term, families
from labcal.model.effects.guard import guarded
from labcal.model.effects.regressors import on_each_axis, per_axis

PERIOD_S = 37.0  # of the pump


def _write_run(folder: Path) -> None:
    """Rotations about three axes in two fields, with the pump's offset in the readings."""
    draw = np.random.default_rng(5)
    rows, segments = [], []
    for number in range(6):
        axis, size = np.eye(3)[number % 3], (20000.0, 50000.0)[number // 3]
        segments.append(
            {"id": f"r{number}", "kind": "rotation", "axis_body": axis.tolist(), "axis_cage": axis.tolist()}
        )
        for t in 100.0 * number + np.arange(0, 90, 0.5):
            angle = np.radians(4 * (t - 100 * number))
            ref = size * np.array([0.5, 0.6, 0.62])
            along = (axis @ ref) * axis
            seen = along + np.cos(angle) * (ref - along) - np.sin(angle) * np.cross(axis, ref)
            reading = 1.05 * seen + 800 + draw.normal(0, 20, 3)
            reading += np.array([300, -200, 150]) * (np.mod(t, PERIOD_S) < 0.2 * PERIOD_S)
            cells = [f"{t:.2f}", f"r{number}", *(f"{v:.2f}" for v in (*reading, *ref)), f"{np.degrees(angle):.3f}"]
            rows.append(",".join(cells))
    header = "t_s,segment,dut_x,dut_y,dut_z,ref_x,ref_y,ref_z,angle_deg"
    (folder / "samples.csv").write_text("\n".join([header, *rows]) + "\n")
    dut = {"serial": "P1", "model": "M", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": 20.0}
    head = {"format": "labcal-run/1", "run_id": "pump", "started_utc": "2026-05-01T00:00:00Z", "simulated": True,
            "operator": "", "dut": dut,
            "reference": {"kind": "vector", "serial": "R"}, "segments": segments, "channels": {}}  # fmt: skip
    (folder / "run.json").write_text(json.dumps(head))


@pytest.fixture
def pump_installed(installed: Callable[[str, str, str], None]) -> None:
    """The package that docs/closed-loop.md shows."""
    page = (Path(__file__).parents[2] / "docs" / "closed-loop.md").read_text(encoding="utf-8")
    source, declared = (re.findall(f"```{kind}\n(.*?)```", page, re.DOTALL)[0] for kind in ("python", "toml"))
    point = re.search(r'(\w+) = "pump\.effect:(\w+)"', declared)
    assert point is not None
    installed(point[1], point[2], source)


def test_a_copy_that_is_not_installed_says_so_and_names_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("labcal.model.effects.registry.entry_points", lambda group: ())
    families.cache_clear()
    with pytest.raises(InputError, match="no effect is installed"):
        families()


@pytest.mark.slow
def test_without_the_effect_the_run_is_unexplained(tmp_path: Path) -> None:
    _write_run(tmp_path)
    closed = session.close_loop(str(tmp_path))
    assert closed.verdict in ("unexplained", "partly-explained")


def test_with_the_effect_it_is_explained(tmp_path: Path, pump_installed: None) -> None:
    _write_run(tmp_path)
    closed = session.close_loop(str(tmp_path))
    assert (closed.verdict, [e.effect for e in closed.accepted]) == ("explained", ["pump"])
    found = {p.name: p for p in closed.accepted[0].parameters}
    for name, true in (("c_x", 300 / 1.05), ("c_y", -200 / 1.05), ("c_z", 150 / 1.05)):
        assert abs(found[name].value - true) < 4 * found[name].u + 1
        assert 0.3 < found[name].u < 3.0  # 20 nT over 1080 rows, a fifth of them with the pump on


@pytest.mark.parametrize(
    ("formula", "words"),
    [
        ("raise ValueError('pump broke')", "fails in its formula: ValueError: pump broke"),
        ("return np.ones((len(scene), 2))", "columns of shape (8, 2), not"),
        ("return on_each_axis(np.full(len(scene), np.nan))", "not finite"),
    ],
)
def test_a_formula_that_fails_is_said_with_its_name(formula: str, words: str) -> None:
    space: dict[str, Any] = {"np": np, "on_each_axis": on_each_axis}
    exec(f"def kernel(form, scene):\n    {formula}", space)
    kernel = space["kernel"]
    family = guarded(Family("pump", "sensor", kernel, lambda run: [Term(kernel, per_axis("c", "nT"))]), "pump:PUMP")
    (term,) = family.candidates(SimpleNamespace(run_id="any"))
    scene = Scene(np.arange(8.0), np.zeros(8, dtype=np.intp), np.ones((8, 3)))
    with pytest.raises(InputError) as fault:
        term.columns(scene)
    assert "the effect pump of another package (pump:PUMP)" in str(fault.value)
    assert words in str(fault.value)


@pytest.mark.parametrize(
    ("family", "source", "words"),
    [
        ("PUMP", "from labcal.model.effects.lag import FAMILY as PUMP\n", "holds the Family 'lag': give both one name"),
        ("kernel", "def kernel(term, scene): ...\n", "is a function and no Family"),
    ],
)
def test_an_entry_that_holds_something_else_is_said_by_plugins_too(
    family: str, source: str, words: str, installed: Callable[[str, str, str], None], capsys: pytest.CaptureFixture[str]
) -> None:
    installed("pump", family, source)
    assert execute(["plugins"]) == 1
    assert words in capsys.readouterr().err
    with pytest.raises(InputError, match=words):
        families()


@pytest.mark.parametrize(
    ("stated", "words"),
    [
        ({"shapes": Shape("tau_s", 1.0, "s")}, r"something else than a Shape of each nonlinear parameter: \(TAU,\)"),
        ({"belongs_to": "device"}, "belongs to 'device'; expected one of sensor, rig, data"),
        ({"responds": {"warm": 1.0}}, "responds to 'warm'; expected any of load, heat"),
    ],
)
def test_a_family_that_says_what_nobody_asks_for_is_refused(stated: dict[str, Any], words: str) -> None:
    said: dict[str, Any] = {"belongs_to": "sensor"} | stated
    with pytest.raises(InputError, match=f"the effect pump of another package .pump:PUMP.*{words}"):
        guarded(
            Family(id="pump", kernel=lambda term, scene: scene.field_nT, candidates=lambda run: [], **said), "pump:PUMP"
        )


def test_two_packages_with_one_effect_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    point = EntryPoint("lag", "labcal.model.effects.lag:FAMILY", "labcal.effects")
    monkeypatch.setattr("labcal.model.effects.registry.entry_points", lambda group: (point, point))
    families.cache_clear()
    with pytest.raises(InputError, match="there twice"):
        families()
    families.cache_clear()


def test_a_module_that_does_not_load_is_said_with_its_entry_point(monkeypatch: pytest.MonkeyPatch) -> None:
    point = EntryPoint("pump", "no_such_pump.effect:PUMP", "labcal.effects")
    monkeypatch.setattr("labcal.model.effects.registry.entry_points", lambda group: (point,))
    families.cache_clear()
    with pytest.raises(InputError, match="fails as it is loaded: ModuleNotFoundError"):
        families()
    families.cache_clear()
