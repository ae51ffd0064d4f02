"""Items of the timeline as rows of the database, and back. Samples are little-endian float64, row by row."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict
from functools import cache
from typing import Any, NamedTuple, get_args

import numpy as np
from pydantic import TypeAdapter, ValidationError

from labcal.errors import InputError
from labcal.record import RunHeader
from labcal.record.stream import (
    Block,
    Item,
)

SAMPLES = np.dtype("<f8")
SPAN_S, MOST_BLOCKS = 10.0, 1000  # of the bench's time, and so many blocks, are at most in one row of each stream


def _kind(of: type) -> str:
    return re.sub(r"(?<!^)(?=[A-Z])", "-", of.__name__).lower()


KINDS: dict[str, type] = {_kind(of): of for of in get_args(Item)}


class ItemRow(NamedTuple):
    """What the table `item` holds of one item; the last three only of a block."""

    kind: str  # "block", "segment-opened", "step" …
    t_s: float
    content: str  # JSON
    stamps: bytes | None = None  # (n,) float64
    samples: bytes | None = None  # (n, k) float64
    raw: bytes | None = None


def to_row(item: Item) -> ItemRow:
    """The row that stands for `item`. Raises ValueError for a block whose stamps, columns and values disagree."""
    if isinstance(item, Block):
        shape = (len(item.t_s), len(item.columns))
        if item.values.shape != shape:
            raise ValueError(f"{item.source}: a block of shape {item.values.shape} where {shape} is stated")
        content = _block_content(item.stream, item.source, item.columns)
        stamps, samples = (np.ascontiguousarray(part, SAMPLES).tobytes() for part in (item.t_s, item.values))
        return ItemRow("block", float(item.t_s[0]) + 0.0 if len(item) else 0.0, content, stamps, samples, item.raw)
    return ItemRow(_kind(type(item)), float(item.t_s) + 0.0, to_json(asdict(item)))


def merged(rows: Iterable[ItemRow]) -> Iterator[ItemRow]:
    """The same timeline in fewer rows: blocks of one stream between two other items become one block, or a few."""
    for group in _groups(rows):
        blocks: dict[str, list[ItemRow]] = {}
        for row in group:
            blocks.setdefault(row.content, []).append(row)
        yield from map(_joined, blocks.values()) if group[0].kind == "block" else group


def whole(rows: Sequence[ItemRow]) -> int:
    """How many of the first `rows` will be merged as they are now, whatever comes after them."""
    *_, last = [[], *_groups(rows)]
    return len(rows) - (len(last) if last and last[0].kind == "block" else 0)


def _groups(rows: Iterable[ItemRow]) -> Iterator[list[ItemRow]]:
    """Rows that are merged with each other: where one ends depends on no row behind the next one."""
    group: list[ItemRow] = []
    for row in rows:
        if group and (row.kind != "block" or row.t_s - group[0].t_s >= SPAN_S or len(group) >= MOST_BLOCKS):
            yield group
            group = []
        group.append(row)
        if row.kind != "block":
            yield group
            group = []
    if group:
        yield group


def _joined(rows: Sequence[ItemRow]) -> ItemRow:
    stamps, samples, raw = (b"".join(part or b"" for part in parts) for parts in list(zip(*rows, strict=True))[3:])
    return ItemRow("block", rows[0].t_s, rows[0].content, stamps, samples, raw)


def from_row(row: ItemRow) -> Item:
    """The item that `row` stands for."""
    if row.kind == "block":
        content = json.loads(row.content)
        columns = tuple(content["columns"])
        stamps = np.frombuffer(row.stamps or b"", SAMPLES)
        samples = np.frombuffer(row.samples or b"", SAMPLES).reshape(len(stamps), len(columns))
        return Block(content["stream"], content["source"], columns, stamps, samples, row.raw or b"")
    item: Item = _written(KINDS[row.kind], row.content)
    return item


def header_from_json(text: str) -> RunHeader:
    """The header that was written as `text`."""
    header: RunHeader = _written(RunHeader, text)
    return header


def _written(of: type, text: str) -> Any:
    """What `text` says of an `of`. Raises InputError where no labcal wrote it so."""
    try:
        return _adapter(of).validate_json(text)
    except ValidationError as error:
        fault = error.errors(include_url=False)[0]
        place = ".".join(map(str, fault["loc"]))
        raise InputError(
            f"the store is damaged: a {_kind(of)} whose {place or 'text'} is wrong ({fault['msg']})"
        ) from None


def prepare() -> None:
    """Have ready what reads each kind of item: made when the first one comes, it takes tens of milliseconds."""
    for of in KINDS.values():
        if of is not Block:
            _adapter(of)


def to_json(value: Any) -> str:
    """JSON on one line; numpy's numbers and arrays as plain ones, what is no JSON as its text."""
    return json.dumps(value, default=_plain, ensure_ascii=False)


def _plain(value: Any) -> Any:
    return value.tolist() if isinstance(value, np.generic | np.ndarray) else str(value)


@cache
def _block_content(stream: str, source: str, columns: tuple[str, ...]) -> str:
    return to_json({"stream": stream, "source": source, "columns": columns})


@cache
def _adapter(of: type) -> TypeAdapter[Any]:
    return TypeAdapter(of)
