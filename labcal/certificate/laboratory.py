"""Who issues a certificate and for whom, where the run does not say it.

The laboratory is in `laboratory.toml` in labcal's folder; the customer is in a file beside the calibration, else there
too.
"""

from __future__ import annotations

import json
from dataclasses import asdict, replace
from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from labcal.errors import InputError
from labcal.files.atomic import write_text
from labcal.files.toml_file import read_toml
from labcal.record import Administrative
from labcal.record.administrative import Address, Laboratory

FILE = "laboratory.toml"
CUSTOMER = ".customer"  # ends the name of the file beside a calibration that says for whom it is
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


def write_laboratory(path: Path, laboratory: Laboratory) -> None:
    """Write who issues certificates, once: a file that is there is people's own. Raises InputError."""
    if path.exists():
        raise InputError("the laboratory is stated already", file=path)
    stated = {name: value for name, value in asdict(laboratory).items() if value is not None}
    lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}\n" for name, value in stated.items()]
    write_text(path, "".join(lines))


def customer_beside(calibration: Path) -> Address | None:
    """For whom it is by the file beside it; None where there is none. Raises InputError."""
    file = calibration.with_suffix(CUSTOMER)
    if not file.exists():
        return None
    try:
        return _ADDRESS.validate_json(file.read_bytes())
    except ValidationError as error:
        raise InputError(f"no customer: {error.errors()[0]['msg']}", file=file) from None


def write_customer(calibration: Path, customer: Address) -> None:
    """Say beside a calibration for whom it is."""
    said = {name: value for name, value in asdict(customer).items() if value is not None}
    write_text(calibration.with_suffix(CUSTOMER), json.dumps(said, ensure_ascii=False) + "\n")


def administrative_of(run: Administrative | None, path: Path, calibration: Path | None = None) -> Administrative:
    """What the run states; laboratory and customer that it leaves open, from beside `calibration`, else from `path`."""
    stated = run or Administrative()
    if stated.customer is None and calibration is not None:
        stated = replace(stated, customer=customer_beside(calibration))
    if None not in (stated.laboratory, stated.customer) or not path.exists():
        return stated
    own = read_laboratory(path)
    laboratory, customer = stated.laboratory or own.laboratory, stated.customer or own.customer
    return replace(stated, laboratory=laboratory, customer=customer)
