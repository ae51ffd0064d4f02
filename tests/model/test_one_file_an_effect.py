"""An effect is one file: nothing outside `labcal.model.effects` decides by an effect's id or a parameter's name.

`python tests/model/test_one_file_an_effect.py [FOLDER]` lists every place of a working copy that does.
"""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from functools import cache
from importlib.metadata import entry_points
from pathlib import Path

import pytest

from labcal.model.effects import families

ROOT = Path(__file__).parents[2]
OURS = [p for p in entry_points(group="labcal.effects") if p.value.startswith("labcal.")]
IDS = {point.name for point in OURS}
ROOM = "labcal.model.effects"
COMMON = ("c_form", "c_smooth", "inputs", "past", "protocol", "regressors", "registry", "scene", "shape", "term")
FILES = {f"{ROOM}.{p.stem}" for p in (ROOT / "labcal/model/effects").glob("[a-z]*.py") if p.stem not in COMMON}
NAMES = {shape.name for f in families() if f.id in IDS for shape in f.shapes} | {"lag_s"}
CUTS = ("startswith", "endswith", "removeprefix", "removesuffix", "match", "fullmatch", "search")
ENDS = [(name.split("_")[0] + "_", "_" + name.split("_")[-1]) for name in NAMES]
PARTS = {part for ends in ENDS for part in ends} | {"offset-", "gain-"}
BLIND = ("bench", "runner", "store", "twin")  # rooms that no import leads from to an effect; drivers are another
ALLOWED = {
    "labcal/fit/scalar/telemetry.py": "estimates the slopes of currents, so it states that effect",
    "labcal/model/plausibility.py": "finds saturated rows, so it states and reads that finding",
    "labcal/loop/close.py": "finds the rows to set aside, so it counts them by their ids",
    "labcal/certificate/flight/foreign.py": "states that nobody asked for that term (contract: made_by)",
    "labcal/certificate/dcc/basis.py": "writes down how that term's functions are made, in the units of its file",
    "labcal/loop/empirical/build.py": "builds that effect, which no search finds",
    "labcal/session/working_out.py": "keeps whether a person asked for that term (contract: made_by)",
    "labcal/gui/translations/loop.py": "a word of the loop's sentences for other languages, and no id",
    "labcal/loop/assemble.py": "the verdict weighs the rows that are set aside",
}
STATED = ("SEPARATES", "CAUSE")  # what a procedure says of itself, and the self-test of the lab that it simulates


def places(root: Path) -> Iterator[tuple[str, int, str]]:
    """File, line and word of each place that knows an effect, in labcal and procedures below `root`."""
    for file in sorted(file for room in ("labcal", "procedures") for file in (root / room).rglob("*.py")):
        name = file.relative_to(root).as_posix()
        if not name.startswith(("labcal/model/effects/", *(f"labcal/{room}/" for room in BLIND))):
            for line, word in known_in(ast.parse(file.read_text(encoding="utf-8"))):
                yield name, line, word


def known_in(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """The effects' ids, their files, their parameters' names, and parts of such names that a string is asked for."""
    stated = {id(n) for a in tree.body if isinstance(a, ast.Assign) and _is_statement(a) for n in ast.walk(a)}
    for node in (node for node in ast.walk(tree) if id(node) not in stated):
        match node:
            case ast.Constant(value=str(word)) if word in IDS | NAMES:
                yield node.lineno, word
            case ast.keyword(arg=str(word)) if word in NAMES:
                yield node.value.lineno, word
            case ast.ImportFrom(module=str(module)) if module in FILES:
                yield node.lineno, module
            case ast.ImportFrom(module=module, names=names) if module == ROOM:
                yield from ((node.lineno, n.name) for n in names if f"{ROOM}.{n.name}" in FILES)
            case ast.Import(names=names):
                yield from ((node.lineno, n.name) for n in names if n.name in FILES)
            case ast.Compare(left=left, comparators=others):
                words = [n.value for n in (left, *others) if isinstance(n, ast.Constant)]
                yield from ((node.lineno, f"compared with {word}") for word in words if word in PARTS)
            case ast.Call(func=ast.Attribute(attr=attr), args=args) if attr in CUTS:
                words = [n.value for a in args for n in ast.walk(a) if isinstance(n, ast.Constant)]
                yield from ((node.lineno, f"{attr} {word}") for word in words if word in PARTS)


def _is_statement(node: ast.Assign) -> bool:
    return any(isinstance(target, ast.Name) and target.id in STATED for target in node.targets)


@cache
def found_here() -> tuple[tuple[str, int, str], ...]:
    return tuple(places(ROOT))


def test_nothing_outside_the_effects_knows_one() -> None:
    found = [f"{file}:{line} {word}" for file, line, word in found_here() if file not in ALLOWED]
    assert not found


def test_each_exception_is_needed() -> None:
    assert {file for file, _, _ in found_here()} == set(ALLOWED)


@pytest.mark.parametrize(
    "line",
    [
        "if effect.id == 'lag': pass",
        "term.with_values(tau_s=3.0)",
        "name.endswith('_deg')",
        "name.startswith('delay_')",
        "from labcal.model.effects.lag import kernel",
        "from labcal.model.effects import lag",
        "import labcal.model.effects.encoder_error as angle",
        "from labcal.model.effects.magnetised import langevin",
        "if effect.id in {'gain-channel', 'encoder-error'}: pass",
        "match effect.id:\n    case 'hysteresis': pass",
        "steps = {'pinning_nT': 2000.0}",
        "if 'begins_on' in stated: pass",
        "if name[-2:] == '_s': pass",
        "if '_deg' in name: pass",
    ],
)
def test_the_scan_sees_it(line: str) -> None:
    assert list(known_in(ast.parse(line)))


if __name__ == "__main__":
    for file, line, word in places(Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT):
        print(f"{file}:{line}  {word}")
