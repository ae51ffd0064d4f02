"""Frozen dataclasses to JSON and back, by their declared types: one place for whatever crosses to a worker.

A value that is not what its field declares is refused with a sentence that names the field. Arrays go as base64, items
of the timeline as the store writes them.
"""

from __future__ import annotations

import types
from collections.abc import Callable, Mapping
from dataclasses import MISSING, fields, is_dataclass
from functools import cache
from pathlib import Path
from typing import Any, Literal, Union, get_args, get_origin, get_type_hints

import numpy as np

from labcal.errors import InputError
from labcal.gui.ipc.wire import item_from_json, item_to_json, pack, unpack
from labcal.record.stream import Item

Decode = Callable[[Any, str], Any]
PLAIN: dict[Any, tuple[type, ...]] = {
    str: (str,),
    bool: (bool,),
    int: (int,),
    float: (float, int),
    type(None): (type(None),),
}
ITEMS = get_args(Item)


def encode(value: Any) -> Any:
    """`value` as what JSON has: dataclasses as objects, tuples as lists, arrays packed."""
    if isinstance(value, ITEMS):
        return item_to_json(value)
    if is_dataclass(value):
        return {field.name: encode(getattr(value, field.name)) for field in fields(value)}
    if isinstance(value, Mapping):
        return {str(key): encode(one) for key, one in value.items()}
    if isinstance(value, Path):
        return str(value)
    if isinstance(value, tuple | list):
        return [encode(one) for one in value]
    if isinstance(value, np.ndarray):
        return pack(value)
    if isinstance(value, np.generic):
        return value.item()
    if value is not None and not isinstance(value, str | bool | int | float):
        raise TypeError(f"a {type(value).__name__} cannot cross to another process")
    return value


def decode(hint: Any, said: Any, where: str) -> Any:
    """The value of type `hint` that `encode` wrote. Raises InputError that names the place, beginning with `where`."""
    return _decoder(hint)(said, where)


def refused(where: str, expected: str, said: Any) -> InputError:
    """The sentence about a value that does not belong there; of a long one its beginning."""
    shown = repr(said)
    return InputError(f"{where} is not {expected} but {shown if len(shown) <= 40 else shown[:40] + '…'}")


@cache
def _decoder(hint: Any) -> Decode:
    """What reads values of one type; made once, because lists of runs are long."""
    origin, args = get_origin(hint), get_args(hint)
    if hint is Any:
        return lambda said, where: said
    if hint in PLAIN:
        return _plain(hint)
    if hint == Item or hint in ITEMS:
        return _item
    if origin is np.ndarray:
        return _array
    if origin is Literal:
        return _literal(args)
    if origin in (Union, types.UnionType):
        return _union(tuple(_decoder(one) for one in args), hint)
    if origin is tuple:
        return _many(args[0]) if args[-1] is ... else _each(args)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        return _mapping(args[1])
    if is_dataclass(hint):
        return _object(hint)
    raise TypeError(f"{hint} cannot cross to a worker")


def _plain(kind: type) -> Decode:
    allowed = PLAIN[kind]

    def read(said: Any, where: str) -> Any:
        if type(said) not in allowed:
            raise refused(where, "null" if said is None else f"of type {kind.__name__}", said)
        return float(said) if kind is float else said

    return read


def _item(said: Any, where: str) -> Any:
    try:
        return item_from_json(said)
    except (InputError, ValueError, TypeError, KeyError, IndexError, AttributeError):
        raise refused(where, "an item of the timeline", said) from None


def _array(said: Any, where: str) -> Any:
    try:
        return unpack(said)
    except (ValueError, TypeError, KeyError):
        raise refused(where, "an array", said) from None


def _literal(words: tuple[Any, ...]) -> Decode:
    def read(said: Any, where: str) -> Any:
        if said not in words:
            raise refused(where, f"one of {', '.join(map(str, words))}", said)
        return said

    return read


def _union(ways: tuple[Decode, ...], hint: Any) -> Decode:
    def read(said: Any, where: str) -> Any:
        complaint: InputError | None = None
        for way in ways:
            try:
                return way(said, where)
            except InputError as error:
                complaint = complaint or error  # of null or something, what is wrong with something
        raise complaint or refused(where, str(hint), said)

    return read


def _many(kind: Any) -> Decode:
    one = _decoder(kind)

    def read(said: Any, where: str) -> Any:
        if not isinstance(said, list):
            raise refused(where, "a list", said)
        return tuple(one(value, where) for value in said)

    return read


def _each(kinds: tuple[Any, ...]) -> Decode:
    ways = tuple(_decoder(kind) for kind in kinds)

    def read(said: Any, where: str) -> Any:
        if not isinstance(said, list) or len(said) != len(ways):
            raise refused(where, f"a list of {len(ways)}", said)
        return tuple(way(value, where) for way, value in zip(ways, said, strict=True))

    return read


def _mapping(kind: Any) -> Decode:
    one = _decoder(kind)

    def read(said: Any, where: str) -> Any:
        if not isinstance(said, dict):
            raise refused(where, "an object", said)
        return {name: one(value, f"{where}.{name}") for name, value in said.items()}

    return read


def _object(kind: Any) -> Decode:
    hints = get_type_hints(kind)
    ways = {field.name: _decoder(hints[field.name]) for field in fields(kind)}
    needed = {field.name for field in fields(kind) if field.default is MISSING and field.default_factory is MISSING}

    def read(said: Any, where: str) -> Any:
        if not isinstance(said, dict):
            raise refused(where, "an object", said)
        if unknown := [name for name in said if name not in ways]:
            raise InputError(f"{where} has no field {unknown[0]!r}")
        if missing := sorted(needed - said.keys()):
            raise InputError(f"{where} has no {missing[0]!r}, which it needs")
        return kind(**{name: ways[name](value, f"{where}.{name}") for name, value in said.items()})

    return read
