"""A run written as a bundle, plain and small: rotations about three axes in two fields, with what a test puts in."""

from __future__ import annotations

import csv
import io
import json
import os
import sys
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from labcal import session
from labcal.loop import parallel
from labcal.loop.candidates.scorer import CandidateSet
from labcal.loop.close import prepare
from labcal.loop.data.linear_problem import LinearProblem
from labcal.model.effects import families
from labcal.session import working_out

Rows = dict[str, np.ndarray]
Writer = Callable[..., Path]
NOISE_nT, RATE_DEG_PER_S = 20.0, 6.0
UNITS = {"current": "A", "temperature": "degC", "voltage": "V", "power": "W"}


def recorded(axes: str = "xyz", seconds: float = 45.0, seed: int = 5) -> tuple[Rows, list[dict[str, Any]]]:
    """Columns of samples.csv and the segments; reading = 1.05 b + 800 nT with noise, channels `temp` and `i_load`."""
    draw = np.random.default_rng(seed)
    segments, parts = [], []
    for number, (axis_name, size) in enumerate((a, s) for s in (20000.0, 50000.0) for a in axes):
        axis = np.eye(3)["xyz".index(axis_name)]
        name = f"{axis_name}-{size / 1000:g}"
        segments.append({"id": name, "kind": "rotation", "axis_body": axis.tolist(), "axis_cage": axis.tolist(),
                         "body_from_cage": np.eye(3).tolist()})  # fmt: skip
        start = (seconds + 40.0) * number
        t = start + np.arange(0, seconds, 0.5)
        angle = np.radians(RATE_DEG_PER_S * (t - start))[:, None]
        ref = size * np.array([0.5, 0.6, 0.62]) + np.zeros((len(t), 3))
        along = (ref @ axis)[:, None] * axis
        seen = along + np.cos(angle) * (ref - along) - np.sin(angle) * np.cross(axis, ref)
        parts.append({"t_s": t, "segment": np.full(len(t), name), "dut": seen, "ref": ref, "angle": angle[:, 0]})
    rows: Rows = {key: np.concatenate([part[key] for part in parts]) for key in parts[0]}
    rows["dut"] = 1.05 * rows["dut"] + 800 + draw.normal(0, NOISE_nT, rows["dut"].shape)
    t = rows["t_s"]
    rows["temp"] = 20 + 3 * np.sin(t / 90.0) + draw.normal(0, 0.05, len(t))
    rows["i_load"] = (np.mod(t, 47.0) < 19.0) * 0.8 + draw.normal(0, 0.01, len(t))
    return rows, segments


CHANNELS = {"temp": {"unit": "degC", "quantity": "temperature"}, "i_load": {"unit": "A", "quantity": "current"}}


def written(
    folder: Path,
    rows: Rows,
    segments: list[dict[str, Any]],
    channels: Mapping[str, Mapping[str, str]] = CHANNELS,
    noise_nT: float | None = NOISE_nT,
) -> Path:
    """The bundle of these rows in `folder`."""
    folder.mkdir(parents=True, exist_ok=True)
    names = ["t_s", "segment", *(f"{k}_{a}" for k in ("dut", "ref") for a in "xyz"), "angle_deg", *channels]
    columns = [rows["t_s"], rows["segment"], *rows["dut"].T, *rows["ref"].T, np.degrees(rows["angle"])]
    columns += [rows[name] for name in channels]
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(names)
    for row in zip(*columns, strict=True):
        table.writerow([v if isinstance(v, str) else "" if np.isnan(v) else f"{v:.4f}" for v in row])
    (folder / "samples.csv").write_text(text.getvalue())
    head = {
        "format": "labcal-run/1", "run_id": "made", "started_utc": "2026-05-01T00:00:00Z", "simulated": True,
        "operator": "", "segments": segments, "channels": dict(channels),
        "dut": {"serial": "P1", "model": "M", "unit": "nT", "nominal_nT_per_unit": 1.0, "noise_nT": noise_nT},
        "reference": {"kind": "vector", "serial": "R"},
    }  # fmt: skip
    (folder / "run.json").write_text(json.dumps(head))
    return folder


@pytest.fixture(autouse=True)
def one_core_each(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where several processes share the tests, each works on one core: threads beside them only wait for each other."""
    if "PYTEST_XDIST_WORKER" in os.environ:
        monkeypatch.setattr(parallel, "CORES", 1)


@pytest.fixture
def making() -> ModuleType:
    """This module: `recorded`, `written` and CHANNELS."""
    return sys.modules[__name__]


@pytest.fixture
def closed_loop(capsys: pytest.CaptureFixture[str]) -> Callable[[Path], tuple[int, dict[str, Any], str]]:
    """`labcal close-loop` on a bundle: exit code, JSON result ({} where there is none), stderr."""
    from labcal import cli

    def run(bundle: Path) -> tuple[int, dict[str, Any], str]:
        code = cli.execute(["close-loop", str(bundle), "--json", "-"])
        said = capsys.readouterr()
        return code, json.loads(said.out) if said.out else {}, said.err

    return run


def looked_at_anew() -> None:
    """What is installed: effects, and the names of packages that stand in what is kept."""
    families.cache_clear()
    working_out._packages.cache_clear()


@pytest.fixture
def installed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str, str, str], None]]:
    """Installs a package with one effect, as an installer leaves it: its module and its entry point."""
    site = tmp_path / "site"

    def install(effect: str, family: str, source: str) -> None:
        package = effect.replace("-", "_")
        left = {
            f"{package}/__init__.py": "",
            f"{package}/effect.py": source,
            f"{package}-1.0.dist-info/METADATA": f"Metadata-Version: 2.1\nName: {package}\nVersion: 1.0\n",
            f"{package}-1.0.dist-info/entry_points.txt": f"[labcal.effects]\n{effect} = {package}.effect:{family}\n",
        }
        for name, text in left.items():
            (site / name).parent.mkdir(parents=True, exist_ok=True)
            (site / name).write_text(text, encoding="utf-8")
        monkeypatch.syspath_prepend(site)
        for module in (package, f"{package}.effect"):
            monkeypatch.delitem(sys.modules, module, raising=False)  # another test's file of this name
        looked_at_anew()

    yield install
    monkeypatch.undo()
    looked_at_anew()


@pytest.fixture
def started(making: ModuleType, tmp_path: Path) -> Callable[..., LinearProblem]:
    """The base fitted to a plain run with something added to its readings."""

    def make(added: Callable[[Rows], np.ndarray] = lambda rows: np.zeros(3), seconds: float = 45.0) -> LinearProblem:
        rows, segments = making.recorded(seconds=seconds)
        rows["dut"] = rows["dut"] + added(rows)
        return prepare(session.load_run(str(making.written(tmp_path, rows, segments))))[0]

    return make


@pytest.fixture
def searching(making: ModuleType, tmp_path: Path) -> Callable[..., CandidateSet]:
    """The search on a run with these channels, of these quantities, and something added to its readings."""

    def make(channels: Rows, quantities: dict[str, str], added: Any = 0.0, seed: int = 5) -> CandidateSet:
        rows, segments = making.recorded(seed=seed)
        rows["dut"] = rows["dut"] + added
        stated = {name: {"unit": UNITS[q], "quantity": q} for name, q in quantities.items()}
        folder = making.written(tmp_path / str(seed), rows | channels, segments, stated)
        return CandidateSet.of(prepare(session.load_run(str(folder)))[0], 0.85)

    return make
