"""Entry points, read from the files of packages: `importlib.metadata` takes longer to load than a supply to be asked.

Only what lies in folders of `sys.path` is seen: where a name is not found here, `importlib.metadata` knows better.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from typing import Any

FILE = "entry_points.txt"
LINE = re.compile(r"([^\s=#;][^=]*?)\s*=\s*([\w.]+)\s*:\s*([\w.]+)")


@dataclass(frozen=True, slots=True)
class FileEntry:
    """As an `importlib.metadata.EntryPoint`: what `value` (module:attribute) names."""

    name: str
    value: str
    group: str

    def load(self) -> Any:
        """Import it."""
        module, _, attribute = self.value.partition(":")
        found = import_module(module)
        for part in attribute.split("."):
            found = getattr(found, part)
        return found


@cache
def entries(group: str) -> dict[str, FileEntry]:
    """Those of one group, by name."""
    found = dict[str, FileEntry]()
    for text in _texts():
        if f"[{group}]" in text:
            found |= {entry.name: entry for entry in _of_group(text, group)}
    return found


def _of_group(text: str, group: str) -> Iterator[FileEntry]:
    inside = False
    for line in map(str.strip, text.splitlines()):
        if line.startswith("["):
            inside = line == f"[{group}]"
        elif inside and (parts := LINE.match(line)):
            yield FileEntry(parts[1], f"{parts[2]}:{parts[3]}", group)


@cache
def _texts() -> list[str]:
    """The entry points of each installed package; of one that is there twice, those that Python finds first."""
    packages = dict[str, str]()
    for folder in sys.path:
        with suppress(OSError):
            for name in os.listdir(folder or "."):
                if name.endswith((".dist-info", ".egg-info")):
                    package = name.partition("-")[0].removesuffix(".egg-info").lower()
                    packages.setdefault(package, os.path.join(folder, name, FILE))
    return [text for path in packages.values() if (text := _text(path))]


def _text(path: str) -> str:
    with suppress(OSError, ValueError), open(path, encoding="utf-8") as file:
        return file.read()
    return ""
