"""The grid of a study: every list in it is one dimension, and every combination of their values is tried."""

from __future__ import annotations

import itertools
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from labcal.study.job import Cell

ROOTS = ("lab", "settings")  # the tables of a study that a dimension may change
PROCEDURE = "procedure"  # and what is run


@dataclass(frozen=True, slots=True)
class GridPoint:
    """One combination: its labels for the table, and what it changes in the study's tables."""

    labels: Mapping[str, Cell]
    changes: Mapping[str, Any]


def points(grid: Mapping[str, Any]) -> list[GridPoint]:
    """All combinations, the last dimension running fastest. Raises ValueError where a dimension says nothing."""
    dimensions = list(_dimensions(grid))
    found = []
    for combination in itertools.product(*(options for _, options in dimensions)):
        labels, changes = dict[str, Cell](), dict[str, Any]()
        for (name, _), (label, change) in zip(dimensions, combination, strict=True):
            labels[name], changes = label, merged(changes, change)
        found.append(GridPoint(labels, changes))
    return found


def merged(table: Mapping[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """`table` with what `over` states, table by table; lists and values are replaced whole."""
    out = dict(table)
    for key, value in over.items():
        inner = out.get(key)
        out[key] = merged(inner, value) if isinstance(inner, Mapping) and isinstance(value, Mapping) else value
    return out


Option = tuple[Cell, Mapping[str, Any]]


def _dimensions(grid: Mapping[str, Any], path: tuple[str, ...] = ()) -> Iterator[tuple[str, list[Option]]]:
    for key, value in grid.items():
        here = (*path, key)
        if isinstance(value, Mapping):
            yield from _dimensions(value, here)
        elif not isinstance(value, list) or not value:
            raise ValueError(f"{'.'.join(here)}: a dimension is a list of the values to try")
        else:
            yield ".".join(here), _distinct(here, [_option(here, one) for one in value])


def _option(path: tuple[str, ...], value: Any) -> Option:
    """One value of a dimension: of a place in the study's tables, or a table with a name that changes several."""
    if path[0] in ROOTS and len(path) > 1:
        change = value
        for key in reversed(path):
            change = {key: change}
        return _label(value), change
    if path == (PROCEDURE,) and isinstance(value, str):
        return value, {PROCEDURE: value}
    if path[0] in ROOTS or len(path) > 1:
        raise ValueError(f"{'.'.join(path)}: a dimension lies in {' or '.join(ROOTS)}, or is a name with tables")
    known = {"name", PROCEDURE, *ROOTS}
    if not isinstance(value, Mapping) or not isinstance(value.get("name"), str) or {*value} - known:
        raise ValueError(f"{path[0]}: each of its values is a table with name, and procedure, lab or settings")
    if not isinstance(value.get(PROCEDURE, ""), str):
        raise ValueError(f"{path[0]}: procedure is the name of one")
    if not all(isinstance(value.get(root, {}), Mapping) for root in ROOTS):
        raise ValueError(f"{path[0]}: lab and settings are tables")
    return value["name"], {root: value[root] for root in (PROCEDURE, *ROOTS) if root in value}


def _label(value: Any) -> Cell:
    return value if isinstance(value, str | int | float | bool) else json.dumps(value, default=str)


def _distinct(path: tuple[str, ...], options: list[Option]) -> list[Option]:
    seen = [json.dumps(label) for label, _ in options]
    if twice := next((one for one in seen if seen.count(one) > 1), None):
        raise ValueError(f"{'.'.join(path)}: {twice} stands there twice")
    return options
