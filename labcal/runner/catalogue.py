"""Where procedures are found: by name in the entry-point group `labcal.procedures`, or as a file of one's own."""

from __future__ import annotations

import hashlib
import importlib.util
import inspect
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path
from types import ModuleType
from typing import Any

from labcal import plugin_loading
from labcal.bench.parameters import ParameterSpec, parameters_of, settings
from labcal.bench.steps import Procedure
from labcal.errors import InputError

GROUP = "labcal.procedures"


@dataclass(frozen=True, slots=True)
class FoundProcedure:
    """A procedure as found: what it is called, its parameters, and the text it was read from."""

    name: str
    function: Callable[..., Procedure]
    parameters: tuple[ParameterSpec, ...]
    source: Path
    own: bool = False  # a file of one's own, not an installed procedure

    @property
    def title(self) -> str:
        """The first line of its docstring."""
        return (inspect.getdoc(self.function) or self.name).splitlines()[0]

    @property
    def sha256(self) -> str:
        """SHA-256 of its source file."""
        return hashlib.sha256(self.source.read_bytes()).hexdigest()

    @property
    def resumable(self) -> bool:
        """Whether it can go on after its last finished step."""
        return self.takes("resume")

    def takes(self, keyword: str) -> bool:
        """Whether it declares `keyword`."""
        return keyword in inspect.signature(self.function).parameters

    def shortfalls(self, given: Mapping[str, str]) -> list[str]:
        """What does not come of a run with these settings, a sentence each. Raises InputError for a wrong setting."""
        values = settings(self.parameters, given)
        return [said for spec in self.parameters if (said := spec.shortfall(values[spec.name]))]

    @property
    def needs(self) -> str:
        """What has to be there, in words: `NEEDS` of its module."""
        return str(getattr(inspect.getmodule(self.function), "NEEDS", ""))

    @property
    def lasts_min(self) -> float | None:
        """Lab time in minutes with its own settings, without what a person takes: `LASTS_MIN` of its module."""
        return getattr(inspect.getmodule(self.function), "LASTS_MIN", None)

    @property
    def separates(self) -> tuple[tuple[str, str], ...]:
        """Pairs of effect ids that its run tells apart: `SEPARATES` of its module."""
        return tuple(getattr(inspect.getmodule(self.function), "SEPARATES", ()))


def procedures() -> dict[str, FoundProcedure]:
    """All installed procedures that load, by name, alphabetically."""
    return catalogue()[0]


def catalogue() -> tuple[dict[str, FoundProcedure], dict[str, InputError]]:
    """All installed procedures by name, alphabetically: those that load, and why the others do not."""
    found: dict[str, FoundProcedure] = {}
    broken: dict[str, InputError] = {}
    for entry in sorted(entry_points(group=GROUP), key=lambda e: e.name):
        try:
            found[entry.name] = _installed(entry)
        except InputError as error:
            broken[entry.name] = error
    return found, broken


def find(procedure: str) -> FoundProcedure:
    """The procedure of that name, or in that file. Raises InputError where there is none."""
    if procedure.endswith(".py") or "/" in procedure or "\\" in procedure:
        return _from_file(Path(procedure))
    entries = {entry.name: entry for entry in entry_points(group=GROUP)}
    if procedure not in entries:
        known = ", ".join(sorted(entries))
        raise InputError(f"there is no procedure {procedure!r}; there are {known}, or a file ./my_test.py")
    return _installed(entries[procedure])


def _installed(entry: EntryPoint) -> FoundProcedure:
    function = plugin_loading.load(entry)
    with plugin_loading.blamed(plugin_loading.named(entry), "as it is looked at"):
        source = Path(inspect.getsourcefile(function) or "")
        found = FoundProcedure(entry.name, function, parameters_of(function), source)
        _ = found.title, found.needs, float(found.lasts_min or 0.0), found.separates  # as a list of them asks for
        return found


def _from_file(path: Path) -> FoundProcedure:
    if not path.is_file():
        raise InputError("there is no such file", file=path)
    function = _function_in(_imported(path), path)
    return FoundProcedure(path.stem.replace("_", "-"), function, parameters_of(function), path.resolve(), own=True)


def _imported(path: Path) -> ModuleType:
    spec = importlib.util.spec_from_file_location(f"labcal_procedure_{path.stem}", path)
    if spec is None or spec.loader is None:
        raise InputError("is not a Python file", file=path)
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    try:
        spec.loader.exec_module(module)
    except SyntaxError as error:
        raise InputError(f"is not Python: {error.msg}", file=path, line=error.lineno) from error
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # it may even exit
        text = f"cannot be loaded: {plugin_loading.said(error)}"
        raise InputError(text, file=path, line=plugin_loading.line_in(error, path)) from error
    return module


def _function_in(module: ModuleType, path: Path) -> Callable[..., Procedure]:
    """The generator function that is named like the file, or the only one there is."""
    own: dict[str, Any] = {
        name: value
        for name, value in vars(module).items()
        if inspect.isgeneratorfunction(value) and value.__module__ == module.__name__ and not name.startswith("_")
    }
    chosen = own.get(path.stem) or (next(iter(own.values())) if len(own) == 1 else None)
    if chosen is None:
        raise InputError(
            f"holds {len(own) or 'no'} procedures; name one generator function {path.stem}(bench, *, …)", file=path
        )
    return chosen  # type: ignore[no-any-return]
