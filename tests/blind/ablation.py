"""What each special rule of the loop is for: `ablation.py TRIAL OUT [--each N]`, after `trial.py TRIAL …`.

The first N runs of each program with two causes, or with physics that has no name, are answered as they are and with
each rule out, and what changes is counted. Answers go to OUT as they come; a second call goes on where the first ended.
A run where a rule said what it says when it is out, is not answered again.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import pkgutil
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import numpy as np
from counted import right, wrong
from trial import answered

import labcal.loop

Rule = Callable[..., Any]
WORSE = 1.05  # times the error on fresh rows that counts as another one
OUT: dict[str, Rule] = {  # by where it stands: what is said in its place
    "candidates.folded_lines.unfolded_line": lambda *_: None,
    "selection.stepwise._material_pair": lambda *_: [],
    "selection.stepwise.best_beside_likely_forms": lambda *_: None,
    "selection.sets.best_set": lambda *_: None,
    "selection.select.likeliest_own_forms": lambda pool, accepted: accepted,
    "selection.select.likelier_forms": lambda pool, accepted, refused: accepted,
    "selection.select.prefer_computable": lambda pool, blocks, accepted, refused: accepted,
    "selection.heldout_rules.is_sure_first": lambda *_: True,
    "selection.heldout_rules._another_leaves_less": lambda *_: False,
    "selection.discrepancy.stands_beside_discrepancy": lambda *_: False,
    "selection.equivalents.merely_contains": lambda *_: False,
    "selection.equivalents.gives_another_map": lambda *_: False,
    "selection.equivalents.nearly_done_by_readings": lambda *_: [],
    "selection.equivalents.is_the_same_here": lambda *_: False,
    "selection.unseen_switching.switched_unseen": lambda pool, found: np.zeros(len(pool.valid), dtype=bool),
    "selection.missed_pulses.missed_pulses": lambda pool, accepted: np.zeros(len(pool.valid), dtype=bool),
    "selection.proof.relinearised": lambda pool, *_: pool,
    "selection.second_order.in_full": lambda problem, found, fitted: (found, fitted),
    "selection.taken_apart.taken_apart": lambda found, fitted: (found, fitted),
}


def rooms() -> list[ModuleType]:
    """Every module of the loop."""
    names = [one.name for one in pkgutil.walk_packages(labcal.loop.__path__, "labcal.loop.")]
    return [importlib.import_module(name) for name in names]


@contextmanager
def instead(rule: str, made: Callable[[Rule], Rule]) -> Iterator[None]:
    """The rule as `made` of it, in every room that has it by name."""
    room, _, name = rule.rpartition(".")
    usual = getattr(importlib.import_module(f"labcal.loop.{room}"), name)
    other = made(usual)
    there = [(module, key) for module in rooms() for key, value in vars(module).items() if value is usual]
    for module, key in there:
        setattr(module, key, other)
    try:
        yield
    finally:
        for module, key in there:
            setattr(module, key, usual)


def heard(rule: str, said: set[str]) -> Callable[[Rule], Rule]:
    """The rule, which notes in `said` that it said what it does not say when it is out."""

    def made(usual: Rule) -> Rule:
        def listened(*given: Any) -> Any:
            result, neutral = usual(*given), OUT[rule](*given)
            if not alike(result, neutral):
                said.add(rule)
            return result

        return listened

    return made


def alike(one: Any, other: Any) -> bool:
    """Whether two answers of a rule are the same: arrays by value, all else by identity or as short values."""
    if isinstance(one, np.ndarray):
        return bool(np.array_equal(one, other))
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)):
        return len(one) == len(other) and all(a is b for a, b in zip(one, other, strict=True))
    return one is other


def answers(folder: Path) -> dict[str, Any]:
    """The row of a run as it is, and of each rule that said anything, without it."""
    said = set[str]()
    with ExitStack() as stack:
        for rule in OUT:
            stack.enter_context(instead(rule, heard(rule, said)))
        usual = answered(folder)
    without = {rule: answered_without(rule, folder) for rule in OUT if rule in said}
    return {"run": f"{folder.parent.name}/{folder.name}", "usual": usual, "without": without}


def answered_without(rule: str, folder: Path) -> dict[str, Any]:
    """The row of a run with a rule out."""
    with instead(rule, lambda _: OUT[rule]):
        return answered(folder)


def chosen(trial: Path, each: int) -> list[Path]:
    """The first runs of each program with two causes, or with physics that no id names."""
    out = []
    for rows in sorted(trial.glob("*.jsonl")):
        truths = [json.loads(line) for line in rows.read_text().splitlines()]
        hard = [one["run"] for one in truths if len(one["truth"]["cause"]) > 1 or one["truth"].get("unnamed")]
        out += [rows.with_suffix("") / run for run in hard[:each]]
    return out


def table(rows: list[dict[str, Any]]) -> str:
    """What changes without each rule, in Markdown."""
    heads = ["rule", "said something in", "right → missed", "missed → right"]
    heads += ["wrong names more, fewer", "fresh error larger, smaller"]
    lines = [f"| {' | '.join(heads)} |", "|---|---|---|---|---|---|"]
    for rule in OUT:
        pairs = [(one["usual"], one["without"][rule]) for one in rows if rule in one["without"]]
        lost, won = (sum(right(a) is before and right(b) is not before for a, b in pairs) for before in (True, False))
        more, fewer = (sum((len(wrong(b)) - len(wrong(a))) * s > 0 for a, b in pairs) for s in (1, -1))
        larger = sum(b["fresh"] > WORSE * a["fresh"] for a, b in pairs)
        smaller = sum(a["fresh"] > WORSE * b["fresh"] for a, b in pairs)
        name = rule.removeprefix("selection.").replace("._", ".").replace("_", " ")
        lines.append(f"| {name} | {len(pairs)} | {lost} | {won} | {more}, {fewer} | {larger}, {smaller} |")
    return "\n".join([*lines, "", f"{len(rows)} runs."])


def main(trial: Path, out: Path, each: int) -> None:
    """Answer what is missing, then print the table."""
    rows = [json.loads(line) for line in out.read_text().splitlines()] if out.exists() else []
    done = {one["run"] for one in rows}
    for folder in chosen(trial, each):
        if f"{folder.parent.name}/{folder.name}" not in done:
            rows.append(answers(folder))
            with out.open("a") as file:
                file.write(json.dumps(rows[-1]) + "\n")
            print(f"{len(rows)}: {rows[-1]['run']}", file=sys.stderr)
    print(table(rows))


if __name__ == "__main__":
    asked = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    asked.add_argument("trial", type=Path)
    asked.add_argument("out", type=Path)
    asked.add_argument("--each", type=int, default=6)
    main(**vars(asked.parse_args()))
