"""Write docs/api.md from the docstrings of the public face.

python tools/api_reference.py docs/api.md
"""

from __future__ import annotations

import argparse
import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import labcal
from labcal.files.atomic import write_text

HEAD = """# The public face

`import labcal` gives what a notebook or a script needs. It is light: the rooms behind a name are loaded when it is
first asked for. Everything else in the package is a room that may change; [labcal/session](../labcal/session/) is
where to read on. [examples/notebook.py](../examples/notebook.py) uses all of it.

Runs are named as on the command line, by a run id of the local store or the path of a bundle, or given as the run
itself. What is wrong with a request or an input is a `labcal.InputError`, an instrument that failed a
`labcal.InstrumentError`; both messages are sentences for people. The examples below run in the project's folder.

While `fit`, `close_loop`, `verify` and `run` are at work, the linear algebra of NumPy and SciPy has one thread in the
whole process: the matrices are small, and on a busy computer more threads wait for each other many times as long.
Afterwards it has as many as before. Where `OPENBLAS_NUM_THREADS` is set, that counts.

This page is made from the docstrings: `python tools/api_reference.py docs/api.md`.
"""
ORDER = ("run", "load_run", "fit", "close_loop", "load_calibration", "Calibration.apply", "verify")
SECTION = re.compile(r"^(\w+)\n-+\n", re.MULTILINE)
ENTRY = re.compile(r"^(\S.*?) : (.+)$")


def page() -> str:
    """The whole page."""
    return "\n".join([HEAD, *map(chapter, ORDER)])


def chapter(name: str) -> str:
    """One name: how it is called, then its docstring."""
    found: Any = labcal
    for part in name.split("."):
        found = getattr(found, part)
    before, *sections = SECTION.split(inspect.getdoc(found) or "")
    page = [f"## {name}", "", "```python", *called(name, inspect.signature(found)), "```", "", before.strip(), ""]
    for title, body in zip(sections[::2], sections[1::2], strict=True):
        page += [f"**{title}**", "", *section(title, body), ""]
    return "\n".join(page)


def called(name: str, signature: inspect.Signature) -> Iterator[str]:
    """The call, a parameter a line."""
    yield f"labcal.{name}(" if "." not in name else f"{name.lower()}("
    kinds = [p.kind for p in signature.parameters.values()]
    for place, parameter in enumerate(signature.parameters.values()):
        if parameter.kind is parameter.KEYWORD_ONLY and parameter.KEYWORD_ONLY not in kinds[:place]:
            yield "    *,"
        if parameter.name != "self":
            yield f"    {shown(parameter)},"
    yield f") -> {signature.return_annotation}"


def shown(parameter: inspect.Parameter) -> str:
    """A parameter without what only a program wants to know."""
    default = "..." if callable(parameter.default) else repr(parameter.default)
    stated = f"{parameter.name}: {parameter.annotation}"
    return stated if parameter.default is parameter.empty else f"{stated} = {default}"


def section(title: str, body: str) -> list[str]:
    """Entries as a list with their words beside them; examples as they are typed."""
    if title == "Examples":
        return ["```pycon", body.strip(), "```"]
    lines: list[str] = []
    for line in body.strip().splitlines():
        if line.startswith(" "):
            lines[-1] += f" {line.strip()}"
        elif found := ENTRY.match(line):
            lines.append(f"- `{found[1]}` ({found[2]}):")
        else:
            lines.append(f"- `{line}`:")
    return lines


if __name__ == "__main__":
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("out", type=Path)
    write_text(asked.parse_args().out, page())
