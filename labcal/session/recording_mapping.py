"""A recording of others and its mapping as a person looks at them: each line with its first rows, and a picture."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from labcal import importers
from labcal.errors import InputError
from labcal.files.toml_edit import Keys, edited, place_of, stated
from labcal.importers.doubts import GAP
from labcal.importers.kinds import kind_of
from labcal.importers.mapping import NEEDED
from labcal.importers.readers import read_recording
from labcal.importers.recording import CsvForm, ForeignRecording, ReadRequest, Stream
from labcal.importers.stamps import is_date, stamps_of
from labcal.importers.units import nT_OF
from labcal.session.importing import ImportRequest, ImportResult, import_foreign

Array = NDArray[np.float64]
ACCEPT: Keys = ("accept",)
ANY: Keys = ()  # of a line that states nothing yet: a person says its keys too
COLUMNS = ("column", "columns", "time")  # keys whose values name columns
FIRST, LOOKED_AT, DRAWN = 3, 2000, 1500  # rows


@dataclass(frozen=True, slots=True)
class MappingLine:
    """One line of a mapping: its keys, its value as it is written, the comment behind it, and the first rows of the
    columns that it names.
    """

    keys: Keys
    value: str
    remark: str = ""
    first: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, eq=False)
class MappedRecording:
    """A recording as its mapping has it. `rows` (n, 4): time [s] and x, y, z [µT], for a picture.

    `objection`: why it is not imported so ("": it is); `remarks`: what was noticed in it.
    """

    kind: str
    text: str
    lines: tuple[MappingLine, ...]
    rows: Array
    remarks: tuple[str, ...]
    objection: str


def look(path: Path, text: str = "", changes: Sequence[tuple[Keys, str]] = ()) -> MappedRecording:
    """What `changes` (keys, a value as it is written) make of the mapping `text`, or of a guess where it is "".

    Raises InputError where nothing can be guessed, and for a change that is no value.
    """
    kind = kind_of(path)
    if not text:
        from labcal.importers.guess import guess

        text = guess(path, kind)
    for keys, value in changes:
        if not all(keys) or not keys:
            raise InputError(f"say which line of the mapping states {value}: its key, such as angle.column")
        text = edited(text, keys, value)
    said: dict[str, Any] = tomllib.loads(text)
    found = _first_rows(path, kind, said)
    lines = tuple(_lines(text, said, found))
    mapping: importers.Mapping | None = None
    try:
        mapping = _mapping(text)
        whole = importers.take_in(path, kind, mapping)
    except InputError as error:
        return MappedRecording(kind, text, lines, _raw(mapping, said, found), (), _sentence(error))
    t, field = whole.run.t_s, whole.run.reading_nT / 1e3
    return MappedRecording(kind, text, lines, _drawn(t, field), whole.remarks, "")


def take(path: Path, text: str) -> ImportResult:
    """Import the recording by the mapping `text` into the store. Raises InputError."""
    with TemporaryDirectory() as folder:
        (file := Path(folder) / "mapping.toml").write_text(text, encoding="utf-8")
        return import_foreign(ImportRequest(path, kind_of(path), map=file))


def _mapping(text: str) -> importers.Mapping:
    with TemporaryDirectory() as folder:
        (file := Path(folder) / "mapping.toml").write_text(text, encoding="utf-8")
        return importers.read_mapping(file)


def _sentence(error: InputError) -> str:
    """Without the file, which the person knows, and the mapping's own, which lasts no longer than this."""
    where = f" ({error.column})" if error.column else ""
    return f"{error.what}{where}"


def _first_rows(path: Path, kind: str, said: Mapping[str, Any]) -> ForeignRecording | None:
    form = CsvForm(decimal="," if said.get("csv", {}).get("decimal") == "," else ".")
    try:
        return read_recording(path, kind, ReadRequest(None, form, most_rows=LOOKED_AT))
    except InputError:
        return None  # the objection says why


def _lines(text: str, said: Mapping[str, Any], found: ForeignRecording | None) -> Iterator[MappingLine]:
    """Each value that a line of its own states, and behind it those that may be stated; what is accepted goes last."""
    leaves = dict(_leaves(said))
    for keys, value in leaves.items():
        if keys not in (ACCEPT, ("format",)) and (place := place_of(text.splitlines(), keys)) is not None:
            yield MappingLine(keys, place.value, place.after.strip(" #"), _cells(said, keys, value, found))
    yield from (MappingLine(keys, "", why) for keys, why in _offered(said) if keys not in leaves)
    yield MappingLine(ACCEPT, stated(text, ACCEPT) or "")
    yield MappingLine(ANY, "", "any other line of a mapping: its key, such as angle.column, and its value")


def _offered(said: Mapping[str, Any]) -> Iterator[tuple[Keys, str]]:
    """What a remark or an objection may ask for, and most recordings do not need."""
    reference = said.get("reference", {})
    kind = reference.get("kind", "none")
    yield from ((("reference", key), f"a reference of kind {kind} needs it") for key in NEEDED.get(kind, ()))
    if said.get("reading", {}).get("unit") == "count":
        yield ("dut", "nominal_nT_per_count"), "readings in counts need it"
    if kind in ("vector", "scalar"):
        yield ("reference", "clock_offset_s"), "added to its stamps, to be on the reading's clock"
        yield ("reference", "clock_rate_ppm"), "by which its clock is too slow"
    yield ("time", "duplicates"), '"drop" leaves rows out that have the time of the row before'
    yield ("time", "backward"), '"drop" leaves rows out that are earlier than the row before'
    yield ("run_id",), "else the file's name"


def _leaves(table: Mapping[str, Any], before: Keys = ()) -> Iterator[tuple[Keys, Any]]:
    for key, value in table.items():
        if isinstance(value, dict):
            yield from _leaves(value, (*before, key))
        else:
            yield (*before, key), value


def _cells(said: Mapping[str, Any], keys: Keys, value: Any, found: ForeignRecording | None) -> tuple[str, ...]:
    """What the first rows hold in the columns that this line names."""
    if keys[-1] not in COLUMNS or (stream := _stream(said, keys[:-1], found)) is None:
        return ()
    names = value if isinstance(value, list) else [value]
    columns = [_first(stream, str(name)) for name in names]
    return tuple(" / ".join(row) for row in zip(*columns, strict=True)) if all(columns) else ()


def _first(stream: Stream, name: str) -> list[str]:
    if name in stream.texts:
        return [str(cell) for cell in stream.texts[name][:FIRST]]
    first = stream.numbers.get(name, np.empty(0))[:FIRST].tolist()
    short = [f"{value:.5g}" for value in first]
    is_told_apart = len(set(short)) == len(set(first))  # stamps that count from 1970 are not
    return short if is_told_apart else [f"{value:.15g}" for value in first]


def _stream(said: Mapping[str, Any], table: Keys, found: ForeignRecording | None) -> Stream | None:
    """The stream that a table of the mapping is about: its own, or the reading's."""
    here: Any = said
    for key in table:
        here = here.get(key, {})
    named = here.get("stream", said.get("reading", {}).get("stream", ""))
    return None if found is None else found.streams.get(named) or found.streams.get("")


def _raw(mapping: importers.Mapping | None, said: Mapping[str, Any], found: ForeignRecording | None) -> Array:
    """The first readings in µT where they cannot be imported: in the file's own axes, at its own stamps."""
    stream = _stream(said, ("reading",), found)
    if mapping is None or stream is None:
        return np.empty((0, 4))
    names = mapping.reading.columns
    try:
        stamps = stamps_of(stream, mapping.reading, mapping.time, names[0])
        field = stream.together(names)[stamps.rows] * nT_OF[mapping.reading.unit] / 1e3
    except (InputError, KeyError):
        return np.empty((0, 4))
    t = stamps.t_s - stamps.t_s[0] if is_date(float(stamps.t_s[0])) else stamps.t_s
    return _drawn(t, field)


def _drawn(t: Array, field: Array) -> Array:
    """As many rows as a picture shows; a row of NaN at each gap, so that no line is drawn over it."""
    rows = np.column_stack([t, field])[:: max(1, -(-len(t) // DRAWN))]
    steps = np.diff(rows[:, 0])
    if not len(steps):
        return rows
    return np.insert(rows, np.flatnonzero(steps > GAP * np.median(steps)) + 1, np.nan, axis=0)
