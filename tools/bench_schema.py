"""The JSON schema of bench.toml, for editors: `bench_schema.py [FILE]`, from what labcal itself checks a file by."""

from __future__ import annotations

import ast
import inspect
import json
import re
import sys
from dataclasses import fields
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, get_args, get_type_hints

from pydantic import BaseModel, TypeAdapter

from labcal.bench import config
from labcal.bench.config import BenchConfig, InstrumentConfig
from labcal.record import administrative

ONE = {"type": "number", "exclusiveMinimum": 0}
PAGE = Path(__file__).parents[1] / "docs" / "bench.schema.json"
UNITS = {
    "nT": "nT", "nT_per_A": "nT/A", "nT_per_unit": "nT a unit of the reading", "nT_per_K": "nT/K",
    "nT_per_year": "nT a year", "nT_per_m": "nT/m", "ppm": "ppm", "ppm_per_K": "ppm/K", "ppm_per_m": "ppm/m", "A": "A",
    "A_per_s": "A/s", "V": "V", "s": "s", "ms": "ms", "m": "m", "deg": "deg", "deg_per_s": "deg/s", "C": "degC",
    "Hz": "Hz", "uT_per_V": "µT/V", "nT_per_count": "nT a count",
}  # fmt: skip


def schema() -> dict[str, Any]:
    """The whole schema, each driver's own settings included."""
    whole = BenchConfig.model_json_schema()
    for name, part in [("BenchConfig", whole), *whole["$defs"].items()]:
        _explain(part, next(getattr(room, name) for room in (config, administrative) if hasattr(room, name)))
    instrument = whole["$defs"][InstrumentConfig.__name__]
    drivers = {e.name: e.load() for e in entry_points(group="labcal.drivers") if e.value.startswith("drivers.")}
    instrument["properties"]["driver"]["examples"] = sorted(drivers)
    instrument["allOf"] = [_settings(name, drivers[name], whole["$defs"]) for name in sorted(drivers)]
    about = "Which instruments stand on a bench of labcal, on which lines, within which limits (docs/bench.md)."
    head = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "bench.toml", "description": about}
    return head | {key: value for key, value in whole.items() if key not in head}


def text() -> str:
    """As it stands in docs: a line for each definition."""
    whole = schema()
    lines = [f'"{name}": {_line(part)}' for name, part in sorted(whole.pop("$defs").items())]
    rest = _line(whole).removesuffix("}")
    return f'{rest}, "$defs": {{\n' + ",\n".join(lines) + "\n}}\n"


def _line(part: Any) -> str:
    return json.dumps(part, ensure_ascii=False, sort_keys=True)


def _explain(part: dict[str, Any], model: type[BaseModel]) -> None:
    """Give each key its comment and unit; one number is allowed where there may be one for each axis."""
    said, hints = comments(model), get_type_hints(model, include_extras=True)
    for name, key in part.get("properties", {}).items():
        key.pop("title", None)
        _describe(key, name, said.get(name, ""))
        if _one_for_each_axis(hints[name]):
            part["properties"][name] = {"description": key.pop("description", ""), "anyOf": [ONE, key]}


def _one_for_each_axis(hint: Any) -> bool:
    """Whether a type takes one number for three."""
    metadata = getattr(hint, "__metadata__", ())
    return any(getattr(one, "func", None) is config._each_axis for one in metadata) or any(
        map(_one_for_each_axis, get_args(hint))
    )


def _describe(key: dict[str, Any], name: str, said: str) -> None:
    words = ". ".join(filter(None, (said[:1].upper() + said[1:], unit_of(name) and f"Unit: {unit_of(name)}")))
    if words:
        key["description"] = words


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


def _settings(name: str, driver: Any, shared: dict[str, Any]) -> dict[str, Any]:
    """Where `driver` is this one, its settings are these."""
    kind = get_type_hints(driver.__init__)["settings"]
    own = TypeAdapter(kind).json_schema(ref_template=f"#/$defs/{name}.{{model}}")
    shared.update({f"{name}.{inner}": part for inner, part in own.pop("$defs", {}).items()})
    stated = [f.name for f in fields(kind)]
    for key, part in own["properties"].items():
        part.pop("title", None)
        _describe(part, key, "")
    shared[f"{name} settings"] = own | {
        "title": f"settings of {name}",
        "description": inspect.getdoc(kind) or "",
        "properties": {key: own["properties"][key] for key in stated},
        "additionalProperties": False,
    }
    then = {"properties": {"settings": {"$ref": f"#/$defs/{name} settings"}}}
    return {"if": {"properties": {"driver": {"const": name}}, "required": ["driver"]}, "then": then}


if __name__ == "__main__":
    Path(sys.argv[1] if len(sys.argv) > 1 else PAGE).write_text(text(), encoding="utf-8")
