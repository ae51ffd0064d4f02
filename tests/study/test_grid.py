from __future__ import annotations

import pytest

from labcal.study.grid import merged, points


def test_every_combination_is_a_point_the_last_dimension_fastest() -> None:
    found = points({"settings": {"turns": [1, 2]}, "lab": {"twin": {"dut": {"noise_nT": [5.0, 15.0]}}}})
    assert [tuple(p.labels.values()) for p in found] == [(1, 5.0), (1, 15.0), (2, 5.0), (2, 15.0)]
    assert found[1].changes == {"settings": {"turns": 1}, "lab": {"twin": {"dut": {"noise_nT": 15.0}}}}


def test_without_a_grid_there_is_one_point_that_changes_nothing() -> None:
    [point] = points({})
    assert (point.labels, point.changes) == ({}, {})


def test_a_named_dimension_changes_several_places_at_once() -> None:
    loud = {"name": "loud", "lab": {"dut": {"noise_nT": 45.1}, "twin": {"dut": {"noise_nT": 45.0}}}}
    [point] = points({"noise": [loud]})
    assert point.labels == {"noise": "loud"}
    assert point.changes == {"lab": loud["lab"]}


def test_the_procedure_is_a_dimension_by_its_name_or_with_its_own_settings() -> None:
    turned = {"name": "two", "procedure": "preflight", "settings": {"magnitudes_nT": [2e4, 5e4]}}
    plain, named = points({"procedure": ["field-sphere", turned]})
    assert (plain.labels, plain.changes) == ({"procedure": "field-sphere"}, {"procedure": "field-sphere"})
    assert named.labels == {"procedure": "two"}
    assert named.changes == {"procedure": "preflight", "settings": turned["settings"]}


def test_tables_are_merged_and_lists_replaced() -> None:
    base = {"a": {"b": 1, "c": [1, 2]}, "d": 3}
    assert merged(base, {"a": {"c": [9]}}) == {"a": {"b": 1, "c": [9]}, "d": 3}
    assert base["a"] == {"b": 1, "c": [1, 2]}


@pytest.mark.parametrize(
    ("grid", "said"),
    [
        ({"settings": {"turns": 3}}, "settings.turns: a dimension is a list"),
        ({"settings": {"turns": []}}, "settings.turns: a dimension is a list"),
        ({"settings": {"turns": [2, 2]}}, "settings.turns: 2 stands there twice"),
        ({"noise": [5.0]}, "noise: each of its values is a table with name"),
        ({"noise": [{"name": "a", "twin": {}}]}, "noise: each of its values is a table with name"),
        ({"noise": [{"name": "a", "procedure": 3}]}, "noise: procedure is the name of one"),
        ({"noise": [{"name": "a", "lab": 3}]}, "noise: lab and settings are tables"),
        ({"twin": {"noise": [1]}}, "twin.noise: a dimension lies in lab or settings"),
        ({"settings": [1]}, "settings: a dimension lies in lab or settings"),
    ],
)
def test_a_dimension_that_says_nothing_is_refused(grid: dict[str, object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        points(grid)
