"""The hazard table of docs/safety.md: every row names kinds of the campaign, and every kind has a row."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("the campaign needs ptys and signals, which Windows lacks", allow_module_level=True)

from kinds import WHO, kinds

SAFETY = Path(__file__).parents[2] / "docs" / "safety.md"
OF_GUARDIANS = re.compile(r"(hung up on|interrupted twice|told to end)$")  # of two at once: as of each alone


def rows() -> list[list[str]]:
    """The cells of each hazard."""
    table = SAFETY.read_text(encoding="utf-8").split("## Hazards")[1].split("## ")[0]
    lines = [line for line in table.splitlines() if line.startswith("| ") and not line.startswith("| hazard")]
    return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


def named(row: list[str]) -> list[str]:
    return re.findall(r"`([^`]+)`", row[-1])


def test_every_hazard_says_what_stops_it_and_names_kinds_that_exist() -> None:
    assert len(rows()) > 20
    for row in rows():
        assert len(row) == 5
        assert all(row), row
        assert named(row), row
        assert set(named(row)) <= set(kinds()), set(named(row)) - set(kinds())


def test_every_kind_of_fault_belongs_to_a_hazard() -> None:
    shown = {name for row in rows() for name in named(row)}
    several = [f"{who} " for who in WHO if who not in ("session", "all of them")]
    left = {k for k in kinds() if not (OF_GUARDIANS.search(k) and k.startswith(tuple(several)))}
    assert left <= shown, left - shown
