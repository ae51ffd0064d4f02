"""Tests go through public names: no private function is imported, called or replaced but those listed."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from pathlib import Path

TESTS = Path(__file__).parent
KNOWN = {  # file and name: why; the list only shrinks
    (
        "bench/served_lab.py",
        "_pump",
    ): "loses replies between the served emulators and their ports",
    ("bench/test_serve.py", "_pump"): "one round of it without a server that never ends",
    ("runner/test_outside.py", "_installed"): "forgets which packages are installed, as only a new process would",
    ("campaign/faulty_supply.py", "_hear"): "a supply that hears late, from within the served emulator",
    ("gui/test_off_hung_up.py", "_exit"): "Python's own, which would end this process",
    ("campaign/pushes_and_studies.py", "_exit"): "Python's own: a copy of this process pushes, and ends at once",
    ("campaign/faulty_lab.py", "_twin"): "the campaign's own lab is served from within",
}


def private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__") and name != "_"


def used(nodes: Iterable[ast.AST]) -> Iterator[str]:
    """Names that are imported, called as what something has, or replaced by `monkeypatch.setattr`."""
    for node in nodes:
        match node:
            case ast.ImportFrom(names=names):
                yield from (alias.name for alias in names)
            case ast.Call(func=ast.Attribute(attr="setattr"), args=[*stated]):
                texts = (arg.value for arg in stated if isinstance(arg, ast.Constant))
                yield from (text.rpartition(".")[2] for text in texts if isinstance(text, str))
            case ast.Call(func=ast.Attribute(attr=name)):
                yield name


def own(nodes: Iterable[ast.AST]) -> set[str]:
    """Names that functions, classes and assigned attributes of the file have."""
    named = {node.name for node in nodes if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    stored = (node for node in nodes if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store))
    return named | {node.attr for node in stored}


def strangers(tree: ast.AST) -> set[str]:
    """Private names that are used, and that are not the file's own."""
    nodes = list(ast.walk(tree))
    foreign = {name for name in used(nodes) if private(name)}
    return foreign - own(nodes) if foreign else foreign


def test_no_private_function_is_used_but_those_that_are_listed() -> None:
    found = {
        (path.relative_to(TESTS).as_posix(), name)
        for path in TESTS.rglob("*.py")
        for name in strangers(ast.parse(path.read_text(encoding="utf-8")))
    }
    assert found == {*KNOWN}


def test_what_is_private_and_whose_is_told_apart() -> None:
    taken = "from labcal.cli import _run\nstore._add(1)\npatch.setattr(x, 'a._b', 1)\n"
    kept = "class C:\n    def _own(self): self._own(), open('_name')\n"
    assert strangers(ast.parse(taken + kept)) == {"_run", "_add", "_b"}
