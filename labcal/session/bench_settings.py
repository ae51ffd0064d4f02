"""A bench file as a list of settings, each with unit and meaning; changed ones as a text, compared line by line."""

from __future__ import annotations

import ast
import inspect
import json
import re
import tempfile
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from difflib import unified_diff
from pathlib import Path
from types import UnionType
from typing import Any, get_args

from pydantic import BaseModel
from pydantic_core import PydanticUndefined

from labcal.bench.config import BenchConfig, InstrumentConfig, read_config
from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.outputs import claim
from labcal.files.toml_edit import edited, stated
from labcal.files.toml_file import read_toml

UNITS = {
    "nT": "nT", "nT_per_A": "nT/A", "nT_per_unit": "nT a unit of the reading", "nT_per_K": "nT/K",
    "nT_per_year": "nT a year", "nT_per_m": "nT/m", "ppm": "ppm", "ppm_per_K": "ppm/K", "ppm_per_m": "ppm/m", "A": "A",
    "A_per_s": "A/s", "V": "V", "s": "s", "ms": "ms", "m": "m", "deg": "deg", "deg_per_s": "deg/s", "C": "degC",
    "Hz": "Hz", "uT_per_V": "µT/V", "nT_per_count": "nT a count",
}  # fmt: skip
LIMITS = (("cage", "limits"), ("dut", "limits"))  # first: what nothing may go beyond
OTHERS = (
    ("cage",), ("cage", "geometry"), ("platform",), ("reference",), ("reference", "certificate"), ("dut",),
    ("environment",), ("safety",), (),
)  # fmt: skip
Keys = tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Setting:
    """One setting. `value` as the file writes it, "" where it states none; `usual`: what holds then.

    `here`: whether it can be changed from here. It cannot where it is written over several lines.
    """

    keys: Keys
    value: str
    usual: str
    unit: str
    meaning: str
    here: bool = True


@dataclass(frozen=True, slots=True)
class Edited:
    """A bench file as it would be: `difference` line by line, and what is wrong with it ("": it is a bench)."""

    text: str
    difference: str
    objection: str


def settings(bench: Path) -> tuple[str, tuple[Setting, ...]]:
    """The text of a bench file and its settings, limits first. Raises InputError where it is no TOML."""
    text, table = read_toml(bench)
    found = [one for keys in LIMITS for one in _of_table(text, table, keys)]
    found += _of_instruments(text, table)
    found += [one for keys in OTHERS for one in _of_table(text, table, keys)]
    return text, tuple(found)


def with_changes(bench: Path, text: str, changes: Sequence[tuple[Keys, str]]) -> Edited:
    """What `text`, of the file `bench`, would be with these `changes`. Raises InputError where one is no value."""
    new = text
    for keys, value in changes:
        new = edited(new, keys, value)
    lines = unified_diff(text.splitlines(), new.splitlines(), bench.name, bench.name, lineterm="", n=1)
    return Edited(new, "\n".join(lines), objection(bench, new))


def save(bench: Path, before: str, changes: Sequence[tuple[Keys, str]]) -> Edited:
    """Write the changes into `bench`. Raises InputError where it is another text than `before` by now, or spoilt.

    What is a bench stays one; a draft that is none yet may be kept before it is whole.
    """
    if read_toml(bench)[0] != before:
        raise InputError("has been changed by somebody else since it was read here; read it again", file=bench)
    made = with_changes(bench, before, changes)
    if made.objection and not objection(bench, before):
        raise InputError(f"nothing was written: {made.objection}", file=bench)
    [output] = claim("bench edit", bench, force=True)  # the person has seen the difference
    with output.writing() as path:
        write_text(path, made.text)
    return made


def objection(bench: Path, text: str) -> str:
    """Why `text` in the place of `bench` is no bench file; "" where it is one."""
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder) / bench.name
        copy.write_text(text, encoding="utf-8")
        try:
            read_config(copy)
        except InputError as error:
            return f"line {error.line}: {error.what}" if error.line else error.what
    return ""


def _of_table(text: str, table: dict[str, Any], keys: Keys) -> Iterator[Setting]:
    model = _model(keys)
    said = comments(model)
    for name, field in model.model_fields.items():
        if _table_of(field.annotation) is None and name not in ("instruments", "twin", "equipment", "served"):
            usual = "" if field.default is PydanticUndefined else _in_words(field.default)
            yield _setting(text, table, (*keys, name), usual, said.get(name, ""))


def _of_instruments(text: str, table: dict[str, Any]) -> Iterator[Setting]:
    instruments = table.get("instruments", {})
    for name, one in instruments.items() if isinstance(instruments, dict) else ():
        for key in InstrumentConfig.model_fields:
            inner = one.get(key) if isinstance(one, dict) else None
            keys: Keys = ("instruments", name, key)
            if isinstance(inner, dict) and stated(text, keys) is None:
                yield from (_setting(text, table, (*keys, each), "", "") for each in inner)
            else:
                yield _setting(text, table, keys, "", "")


def _setting(text: str, table: dict[str, Any], keys: Keys, usual: str, meaning: str) -> Setting:
    value, there = stated(text, keys), _get(table, keys) is not None
    shown = value if value is not None else _in_words(_get(table, keys)) if there else ""
    return Setting(keys, shown, usual, unit_of(keys[-1]), meaning, here=value is not None or not there)


def _get(table: Any, keys: Keys) -> Any:
    for key in keys:
        table = table.get(key) if isinstance(table, dict) else None
    return table


def _model(keys: Keys) -> type[BaseModel]:
    model: type[BaseModel] = BenchConfig
    for key in keys:
        inner = _table_of(model.model_fields[key].annotation)
        assert inner is not None
        model = inner
    return model


def _table_of(annotation: Any) -> type[BaseModel] | None:
    """The table that a field holds, if it holds one."""
    kinds = get_args(annotation) if isinstance(annotation, UnionType) else (annotation,)
    return next((one for one in kinds if isinstance(one, type) and issubclass(one, BaseModel)), None)


def _in_words(value: Any) -> str:
    return "" if value is None else json.dumps(value, ensure_ascii=False, default=str)


def unit_of(name: str) -> str:
    """The unit that a key's name ends with; "" where it has none."""
    ends = sorted((end for end in UNITS if name.endswith(f"_{end}")), key=len)
    return UNITS[ends[-1]] if ends else ""


def comments(model: type) -> dict[str, str]:
    """What stands behind each field in its own class's source."""
    source = inspect.getsource(model)
    lines = source.splitlines()
    (body,) = (node.body for node in ast.parse(source).body if isinstance(node, ast.ClassDef))
    found: dict[str, str] = {}
    for node in body:
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            comment = re.search(r"  # (.*)$", lines[node.lineno - 1])
            found[node.target.id] = comment[1] if comment and not comment[1].startswith("type:") else ""
    return found
