"""The table of a campaign: rows of what was tried, and rows of trials that were counted at different times."""

from __future__ import annotations

from typing import Any

import pytest
from reliability import table

KIND = "Ctrl-C"


def trial(seed: int, at_zero_s: float | None = 0.5, machine_late_s: float = 0.0) -> dict[str, Any]:
    return {
        "kind": KIND, "seed": seed, "load": 1.0, "of": "abc", "machine_late_s": machine_late_s, "limit_s": 2.0,
        "at_zero_s": at_zero_s, "heard_s": at_zero_s, "rose": {}, "false_zero": [], "rows_lost": 3 * (seed == 7),
        "left_A": {}, "words": [], "traceback": False, "code": 0,
    }  # fmt: skip


def cells(text: str) -> list[str]:
    (row,) = (line for line in text.splitlines() if line.startswith(f"| {KIND} |"))
    return [cell.strip() for cell in row.strip("|").split("|")]


def test_trials_of_other_seeds_are_counted_with_those_that_stand_there() -> None:
    before = table([trial(0), trial(1, 0.7), trial(2, 2.5)], {(KIND, 0): True})
    assert cells(before) == [KIND, "3", "2 of 3", "2.50", "2 of 3", "2.50", "0", "0", "0", "0", "1 of 1"]
    more = [trial(7, 1.1), trial(8, 3.0, machine_late_s=0.5)]
    both = table(more, {(KIND, 7): False}, before, more=True)
    assert cells(both) == [KIND, "5", "3 of 4", "3.00", "3 of 4", "3.00", "0", "3", "0", "0", "1 of 2"]
    assert cells(table(more, {}, before)) == cells(table(more, {}))
    with pytest.raises(ValueError, match="counted there already"):
        table(more, {(KIND, 7): False}, both, more=True)


def test_of_a_kind_that_was_never_at_zero_once_the_worst_is_never() -> None:
    before = table([trial(0)], {})
    assert cells(before)[-1] == "none read"
    both = cells(table([trial(1, None) | {"load": 2.0}], {(KIND, 1): True}, before, more=True))
    assert both[:6] == [KIND, "2", "1 of 2", "never", "1 of 2", "never"]
    assert both[-1] == "1 of 1"
