"""Who issues a certificate and for whom, where the run does not say it: `laboratory.toml` in labcal's folder."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from labcal.errors import InputError
from labcal.files.toml_file import read_toml
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory

FILE = "laboratory.toml"
WANTED = 'name = "…", city = "…", country = "DE", and under [customer] the same three'
_LABORATORY, _ADDRESS = TypeAdapter(Laboratory), TypeAdapter(Address)


def read_laboratory(path: Path) -> Administrative:
    """Read `laboratory.toml`: the laboratory, and its customer under [customer]. Raises InputError."""
    if not path.exists():
        raise InputError(f"a certificate names its laboratory: write this file with {WANTED}", file=path)
    try:
        table = read_toml(path)[1]
        customer = table.pop("customer", None)
        laboratory = _LABORATORY.validate_json(json.dumps(table, default=str))
        stated = None if customer is None else _ADDRESS.validate_json(json.dumps(customer, default=str))
    except ValidationError as error:
        first = error.errors()[0]
        at, said = ".".join(map(str, first["loc"])), str(first["msg"]).removeprefix("Value error, ")
        raise InputError(f"{at and f'{at}: '}{said}; expected {WANTED}", file=path) from None
    except InputError as error:
        text = f"{error.what}: expected {WANTED}"
        raise InputError(text, file=path, line=error.line, column=error.column) from None
    return Administrative(laboratory, stated)


def administrative_of(run: Administrative | None, path: Path) -> Administrative:
    """What the run states, and of laboratory and customer what it leaves open from the file `path`, where that is."""
    stated = run or Administrative()
    if None not in (stated.laboratory, stated.customer) or not path.exists():
        return stated
    own = read_laboratory(path)
    laboratory, customer = stated.laboratory or own.laboratory, stated.customer or own.customer
    return replace(stated, laboratory=laboratory, customer=customer)
