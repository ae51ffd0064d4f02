"""`labcal effect new`: a package begun from an empirical term, whose columns agree with the formula of its own test."""

from __future__ import annotations

import importlib
import json
from pathlib import Path
from runpy import run_path
from typing import Any

import numpy as np
import pytest

from labcal.cli import execute
from labcal.loop.empirical.splines import functions_of_length, splines_of, table
from labcal.model.effects import Scene
from labcal.model.smooth import convex_hull


def _result(folder: Path, x: np.ndarray, f: np.ndarray, inputs: list[str]) -> Path:
    """A result that proposes the function f (n,) of x (n, k) on the x axis."""
    plain = splines_of(x)
    functions = functions_of_length(x.shape[1], 0.2 if x.shape[1] == 1 else 0.35)
    phi = plain.at(list(x.T)) @ functions
    size = np.zeros((functions.shape[1], 3))
    size[:, 0] = np.linalg.lstsq(phi, f, rcond=1e-9)[0]
    r = len(size)
    basis = {
        "kind": plain.kind, "knots": plain.knots, "degree": 3, "functions": table(functions),
        "projection": np.zeros((12, 3 * r)).tolist(), "prior_nT": 100.0, "coefficients": size.tolist(),
        "covariance": np.eye(3 * r).tolist(),
    }  # fmt: skip
    hull = [[float(x.min())], [float(x.max())]] if x.shape[1] == 1 else convex_hull(x).tolist()
    term = {"effect": "empirical", "inputs": inputs, "basis": basis, "domain": [{"inputs": inputs, "hull": hull}]}
    (folder / "result.json").write_text(json.dumps({"accepted": [], "proposed": [term]}))
    return folder / "result.json"


def _made(folder: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> tuple[Any, dict[str, Any]]:
    monkeypatch.syspath_prepend(folder)
    importlib.invalidate_caches()
    package = name.replace("-", "_")
    return importlib.import_module(f"{package}.effect"), run_path(str(folder / "tests" / "test_effect.py"))


@pytest.mark.parametrize(("kind", "at"), [("resonant", 12.4), ("wavy", None)])
def test_the_packages_columns_are_those_of_the_shape(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str, at: float | None
) -> None:
    x = np.linspace(11, 13, 300)
    f = {"resonant": 200 / (1 + ((x - 12.4) / 0.3) ** 2), "wavy": 200 * np.sin(8 * x)}[kind]
    result = _result(tmp_path, x[:, None], f, ["channel:v_bus"])
    name = f"bus-{kind}"
    assert execute(["effect", "new", "--from", str(result), "--name", name, "--out", str(tmp_path / "pack")]) == 0
    effect, own = _made(tmp_path / "pack", monkeypatch, name)
    assert f"it is {kind}" in effect.__doc__
    assert at is None or effect.ZERO[0] == pytest.approx(at, abs=0.03)
    t = np.arange(50.0)
    channels = {channel.name: channel.values for channel in own["recorded"](t)}
    run = type("Run", (), {"channels": own["recorded"](t)})
    (term,) = effect.FAMILY.candidates(run)
    scene = Scene(t, np.zeros(50, dtype=np.intp), np.ones((50, 3)), channels)
    truth = {**own["SIZES"], **{shape.name: shape.value for shape in effect.FAMILY.shapes}}
    counted = {n: v - term.reference_value[n] for n, v in channels.items()}
    wanted = own["formula"](Scene(t, scene.segment, scene.field_nT, counted), truth)
    assert np.allclose(term.columns(scene) @ [truth[n] for n, _ in term.parameters], wanted)


def test_a_result_without_such_a_term_a_broken_one_and_a_bad_name_are_refused(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    x = np.linspace(0, 1, 60)[:, None]
    good = _result(tmp_path, x, x[:, 0] ** 2, ["channel:a"])
    broken = json.loads(good.read_text())
    broken["proposed"][0]["basis"]["functions"] = [[1.0]]
    cases = {"empty.json": '{"accepted": []}', "list.json": "[1]", "broken.json": json.dumps(broken), "not.json": "{"}
    for file, text in cases.items():
        (tmp_path / file).write_text(text)
        command = ["effect", "new", "--from", str(tmp_path / file), "--name", "pump", "--out", str(tmp_path / "p")]
        assert execute(command) == 2
        assert file in capsys.readouterr().err
    for name in ("Pump", "lag", "a--b", "../x", "class"):
        assert execute(["effect", "new", "--from", str(good), "--name", name, "--out", str(tmp_path / "p")]) == 2
    assert not (tmp_path / "p").exists()
