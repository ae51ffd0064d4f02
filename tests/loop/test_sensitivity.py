"""The tool behind `make sensitivity`: a number that knows where it would be if a judgement were moved."""

from __future__ import annotations

import importlib
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

BLIND = Path(__file__).parents[1] / "blind"


@pytest.fixture
def tool(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    monkeypatch.syspath_prepend(BLIND)
    return importlib.import_module("sensitivity")


@pytest.fixture
def noted() -> list[Any]:
    return []


@pytest.fixture
def probe(tool: ModuleType, noted: list[Any]) -> Any:
    return tool.Probe.of(10.0, {("a", 0.7): 7.0, ("a", 1.3): 13.0}, noted.append)


@pytest.mark.parametrize(("other", "moves"), [(5.0, []), (8.0, [0.7]), (12.0, [1.3]), (20.0, [])])
def test_a_comparison_notes_the_move_that_would_turn_it(
    probe: Any, noted: list[Any], other: float, moves: list[float]
) -> None:
    assert (other < probe) == (other < 10.0)
    assert [factor for _, factor in noted] == moves


def test_what_is_computed_from_it_is_followed(probe: Any, noted: list[Any]) -> None:
    assert max(2 * probe**2 - 1, 3.0) == 199.0
    assert noted == []
    assert np.float64(100.0) < 2 * probe**2 - 1
    assert noted == [("a", 0.7)]


def test_of_an_array_it_notes_what_changes(probe: Any, noted: list[Any]) -> None:
    assert (np.array([1.0, 50.0]) > probe).tolist() == [False, True]
    assert np.maximum(np.array([20.0, 50.0]), probe).tolist() == [20.0, 50.0]
    assert noted == []
    assert (np.array([1.0, 8.0]) > probe).tolist() == [False, False]
    assert noted == [("a", 0.7)]


def test_a_ratio_is_moved_from_one_and_a_count_by_one(tool: ModuleType) -> None:
    assert tool.moved("floor_ratio", 1.3) == pytest.approx(1.195)
    assert tool.moved("material_share", 0.7) == pytest.approx(0.021)
    assert tool.moved("max_equivalents", 0.7) == 2


def test_a_run_whose_line_was_cut_short_is_answered_again(tool: ModuleType, tmp_path: Path) -> None:
    kept = tmp_path / "answers.jsonl"
    kept.write_text('{"run": "b0000"}\n{"run": "b00')
    assert tool.finished(kept) == [{"run": "b0000"}]
    with kept.open("a") as file:
        file.write('{"run": "b0001"}\n')
    assert tool.finished(kept) == [{"run": "b0000"}, {"run": "b0001"}]


def test_a_policy_that_was_moved_is_made_of_plain_numbers(tool: ModuleType) -> None:
    watch = tool.Watch()
    assert watch.floor_ratio > 1.11
    assert watch.read == {"floor_ratio"}
    watch.move_to(("floor_ratio", 1.3))
    assert [type(watch.floor_ratio), type(watch.min_white_level)] == [float, float]
    assert watch.floor_ratio == pytest.approx(1.195)
    assert watch.min_white_level == pytest.approx(1 / 1.195)
    assert watch.mattering == {("floor_ratio", 0.7)}
