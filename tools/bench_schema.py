"""The JSON schema of bench.toml, for editors: `bench_schema.py [FILE]`, from what labcal itself checks a file by."""

from __future__ import annotations

import argparse
import inspect
import json
from collections.abc import Sequence
from dataclasses import fields, is_dataclass
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, get_args, get_type_hints

from pydantic import BaseModel, TypeAdapter

from labcal.bench import config
from labcal.bench.config import BenchConfig, InstrumentConfig
from labcal.record import administrative
from labcal.session.bench_settings import comments, unit_of

ONE = {"type": "number", "exclusiveMinimum": 0}
PAGE = Path(__file__).parents[1] / "docs" / "bench.schema.json"


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
        "description": "\n\n".join(inspect.cleandoc(one.__doc__ or "") for one in kind.__mro__ if is_dataclass(one)),
        "properties": {key: own["properties"][key] for key in stated},
        "additionalProperties": False,
    }
    then = {"properties": {"settings": {"$ref": f"#/$defs/{name} settings"}}}
    return {"if": {"properties": {"driver": {"const": name}}, "required": ["driver"]}, "then": then}


def main(argv: Sequence[str] | None = None) -> None:
    """Write it."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "file", nargs="?", type=Path, default=PAGE, metavar="FILE", help=f"{PAGE.name} of docs/ if none"
    )
    parser.parse_args(argv).file.write_text(text(), encoding="utf-8")


if __name__ == "__main__":
    main()
