"""What other packages bring by entry points; whatever goes wrong as it is loaded is one sentence with its place."""

from __future__ import annotations

import importlib
import traceback
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from labcal.errors import InputError
from labcal.files.text_safety import one_line

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

KINDS = {  # entry-point groups, and what one of them is called
    "labcal.drivers": "driver",
    "labcal.emulators": "emulator",
    "labcal.twins": "twin",
    "labcal.procedures": "procedure",
    "labcal.effects": "effect",
    "labcal.estimators": "estimator",
    "labcal.pages": "page",
}
OURS = (str(Path(__file__).parent), str(Path(importlib.__file__).parent), "<frozen ")


class AnyEntry(Protocol):
    """An entry point, however it was found."""

    @property
    def name(self) -> str:
        """What it is called."""
        ...

    @property
    def value(self) -> str:
        """module:attribute."""
        ...

    @property
    def group(self) -> str:
        """One of KINDS."""
        ...

    def load(self) -> Any:
        """Import it."""
        ...


@dataclass(frozen=True, slots=True)
class Part:
    """What another package brings: its kind, its name, the package, where it is, and why it does not load."""

    kind: str
    name: str
    package: str
    value: str
    fault: str | None = None


def parts() -> list[Part]:
    """What packages other than labcal bring, by kind and name; each is loaded once, to see that it can be."""
    from importlib.metadata import entry_points  # slow to load, and who only switches coils off does not need it

    found = [e for group in KINDS for e in sorted(entry_points(group=group), key=lambda e: e.name)]
    return [_part(entry, found) for entry in found if entry.dist is None or entry.dist.name != "labcal"]


def _part(entry: EntryPoint, found: Sequence[EntryPoint]) -> Part:
    package, fault = f"{entry.dist.name} {entry.dist.version}" if entry.dist else "", None
    alike = [other for other in found if (other.group, other.name) == (entry.group, entry.name)]
    try:
        load(entry)
        if len(alike) > 1:
            names = " and ".join(sorted(other.dist.name if other.dist else other.value for other in alike))
            what = f"two packages bring the {KINDS[entry.group]} {entry.name!r}"
            fault = f"{what}: {names}; one of them needs another name"
    except InputError as error:
        fault = str(error)
    return Part(KINDS[entry.group], entry.name, package, entry.value, fault)


def load(entry: AnyEntry) -> Any:
    """What `entry` names. Raises InputError with the file and line of the fault, an exit too."""
    with blamed(named(entry), "as it is loaded"):
        return entry.load()


def named(entry: AnyEntry) -> str:
    """How an entry point is spoken of."""
    return f"entry point {entry.name!r} of {entry.group} ({entry.value})"


@contextmanager
def blamed(who: str, doing: str) -> Iterator[None]:
    """Turn any fault of another's code into an InputError that begins with `who`; only Ctrl-C passes."""
    try:
        yield
    except (InputError, KeyboardInterrupt):
        raise
    except BaseException as error:
        file, line = where(error)
        message = f"{who} fails {doing}: {said(error)}"
        raise InputError(message, file=file, line=line) from error


def said(error: BaseException) -> str:
    """An error's kind and words on one line, whatever its own text does."""
    try:
        words = str(error)
    except BaseException:
        words = ""
    return one_line(f"{type(error).__name__}: {words}" if words else type(error).__name__)


def where(error: BaseException) -> tuple[str | None, int | None]:
    """File and line where the fault came out of another's code; None where there is no such place."""
    if isinstance(error, SyntaxError):
        return error.filename, error.lineno
    frames = traceback.extract_tb(error.__traceback__)
    theirs = [frame for frame in frames if not frame.filename.startswith(OURS)]
    return (theirs[0].filename, theirs[0].lineno) if theirs else (None, None)


def line_in(error: BaseException, file: Path) -> int | None:
    """The line of `file` where the fault came from."""
    frames = traceback.extract_tb(error.__traceback__)
    lines = [frame.lineno for frame in frames if Path(frame.filename).resolve() == file.resolve()]
    return lines[-1] if lines else None
