"""A short blind trial: one run of each class, written by a program that shares nothing with labcal, and counted."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from labcal.loop import close_loop
from labcal.store import load_bundle

BLIND = Path(__file__).parents[1] / "blind"
SEED = 2027


@pytest.fixture(scope="module")
def score() -> ModuleType:
    spec = importlib.util.spec_from_file_location("blind_score", BLIND / "score.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("answered", "of_known", "of_others"),
    [((1, 3, 5), 2, 1), pytest.param((0, 1, 2, 3, 4, 5), 4, 2, marks=pytest.mark.slow)],
    ids=["short", "all"],
)
def test_one_blind_run_of_each_class(
    score: ModuleType, tmp_path: Path, answered: tuple[int, ...], of_known: int, of_others: int
) -> None:
    """In short: a fault of the rig, an effect on magnitudes alone, and a cause that has no name."""
    runs, hidden = tmp_path / "runs", tmp_path / "hidden"
    subprocess.run([sys.executable, BLIND / "simulate.py", runs, "short", str(SEED)], check=True)
    (runs / "truth").rename(hidden)
    folders = sorted(runs.iterdir())
    closed = {f.name: close_loop(load_bundle(f / "bundle").run()) for f in (folders[n] for n in answered)}
    rows = [
        {
            "truth": json.loads((hidden / f"{name}.json").read_text()),
            "named": [e.effect for e in result.accepted],
            "rivals": [[r.effect for r in e.rivals] for e in result.accepted],
        }
        for name, result in closed.items()
    ]
    known = [r for r in rows if r["truth"]["cause"] and not set(r["truth"]["cause"]) & set(score.STRANGE)]
    others = [r for r in rows if r not in known]
    assert [len(known), len(others)] == [of_known, of_others]
    assert [r["named"] for r in known if not score.right(r)] == []
    assert [r["named"] for r in known if score.wrong(r)] == []
    assert [r["named"] for r in others if r["named"]] == []
