"""The DUT's specification as bench.toml states it: a table of its own, or a file for a model of sensor."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from labcal.bench.config import BenchConfig, line_of, sentence
from labcal.errors import InputError
from labcal.files.toml_file import read_toml
from labcal.record.specification import Specification

KEY = ("dut", "specification")
UNKNOWN = "unexpected_keyword_argument"
_SPECIFICATION = TypeAdapter(Specification)


def specification_of(config: BenchConfig, path: Path) -> Specification | None:
    """The specification that the bench file `path` states or names; None where it does neither.

    Raises InputError with the file and the line; also where the file is for another model than the DUT's.
    """
    stated = config.dut.specification
    if stated is None:
        return None
    text = path.read_text(encoding="utf-8")
    if not isinstance(stated, str):
        return _checked(stated, path, text, KEY)
    if not (file := path.parent / stated).is_file():
        raise InputError(f"dut.specification: there is no file {file}", file=path, line=line_of(text, KEY))
    return read_specification(file, config.dut.model)


def read_specification(path: Path, model: str = "") -> Specification:
    """Read the specification file `path`; its `model`, where stated, has to be `model`. Raises InputError."""
    text, table = read_toml(path)
    meant = table.pop("model", "")
    if meant and model and meant != model:
        raise InputError(
            f"is for the model {meant!r}, the DUT is a {model!r}", file=path, line=line_of(text, ("model",))
        )
    return _checked({"title": str(meant or path.stem), **table}, path, text, ())


def _checked(table: dict[str, Any], path: Path, text: str, at: tuple[str, ...]) -> Specification:
    try:
        return _SPECIFICATION.validate_json(json.dumps(table, default=str))
    except ValidationError as error:
        faults = error.errors()
        # a misspelt key also leaves a key missing: name the misspelt one
        first = next((f for f in faults if f["type"] == UNKNOWN), faults[0])
        keys = (*at, *map(str, first["loc"]))
        what = "is not a key that is known here" if first["type"] == UNKNOWN else sentence(first)
        said = f"{'.'.join(keys)}: {what}".removeprefix(": ")
        raise InputError(said, file=path, line=line_of(text, keys)) from None
