"""From foreign streams and a mapping to a `Run`: each group at its own stamps, then brought to the readings'."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from hashlib import file_digest
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from labcal.errors import InputError
from labcal.importers import attitude
from labcal.importers.doubts import ImportFinding, StampStatistics, doubts, findings
from labcal.importers.mapping import ColumnSource, Mapping, SegmentPart
from labcal.importers.readers import read_recording
from labcal.importers.recording import ForeignRecording, ReadRequest, Stream, WantedColumns
from labcal.importers.run_of import FileRows, run_of
from labcal.importers.stamps import Stamps, clock_of, is_date, stamps_of, utc
from labcal.importers.units import nT_OF
from labcal.importers.units_in_names import units_in_names
from labcal.record import Run, period_s
from labcal.record.assemble import interpolated
from labcal.store.limits import listed

Array = NDArray[np.float64]
Change = Callable[[Array], Array]


@dataclass(frozen=True, slots=True, eq=False)
class Imported:
    """A recording as a run, and what was noticed in it."""

    run: Run
    remarks: tuple[str, ...]  # to be known before anything is fitted


def take_in(path: Path, format_: str, mapping: Mapping) -> Imported:
    """The run that a recording holds. Raises InputError at its first fault, and for a doubt that nobody accepted.

    `path` is the recording, or the folder of the files that the mapping names.
    """
    opened = _Opened(path, format_, mapping)
    rows = [_rows(opened, part) for part in _own_files(mapping) or (None,)]
    whole = _together(rows)
    origin = float(whole.t_s[0]) if is_date(float(whole.t_s[0])) else 0.0
    started, whole = opened.started(float(whole.t_s[0])), whole.since(origin)
    run = run_of(mapping, whole, started, opened.note(), path.stem or path.name)
    used = np.isin(whole.t_s, run.t_s) if len(run) < len(whole.t_s) else slice(None)
    seen = doubts(run, whole.clocks, None if whole.attitude is None else whole.attitude[used])
    seen += [*units_in_names(mapping), *findings(run, whole.clocks), *_left_out(mapping, len(whole.t_s), run)]
    _refuse(seen, mapping, path)
    return Imported(run, tuple(finding.text for finding in seen))


def files_of(path: Path, mapping: Mapping) -> list[Path]:
    """The files that `take_in` reads."""
    named = [part.file for part in mapping.segments if part.file] + [g.file for g in mapping.groups() if g.file]
    own = [] if path.is_dir() and named else [path]
    return [*own, *(_beside(path, name) for name in named)]


def _own_files(mapping: Mapping) -> list[SegmentPart]:
    return [part for part in mapping.segments if part.file is not None]


def _beside(path: Path, name: str) -> Path:
    """A file that the mapping names: in the folder, or beside the recording."""
    if Path(name).is_absolute() or ".." in Path(name).parts:
        raise InputError(f"the mapping names {name!r}: files lie in the recording's own folder", file=path)
    return (path if path.is_dir() else path.parent) / name


def _left_out(mapping: Mapping, n: int, run: Run) -> Iterator[ImportFinding]:
    """Readings that lie in no segment, and segments in which none lies."""
    if len(run) < n:
        yield ImportFinding(f"{n - len(run)} of {n} readings lie in none of the segments, and are left out")
    there = {segment.id for segment in run.segments}
    if empty := [part.id for part in mapping.segments if part.id not in there]:
        yield ImportFinding(f"no reading lies in segment {listed(empty)}: is its time that of the run's clock?")


def _refuse(seen: Sequence[ImportFinding], mapping: Mapping, path: Path) -> None:
    """Raise InputError for the first doubt that the mapping does not accept."""
    for finding in seen:
        if finding.doubt is not None and finding.doubt not in mapping.accept:
            what = f'{finding.text}; where that is as it should be, accept = ["{finding.doubt}"] in the mapping says so'
            raise InputError(what, file=path)


@dataclass(slots=True)
class _Opened:
    """The files that were read, each once with all the columns that the mapping wants of it."""

    path: Path
    format: str
    mapping: Mapping
    read: dict[Path, ForeignRecording] = field(default_factory=dict)

    def stream(self, group: ColumnSource, part: SegmentPart | None) -> Stream:
        file = self._file(group, part)
        if file not in self.read:
            same = [g for g in self.mapping.groups() if self._file(g, part) == file]
            request = ReadRequest(_wanted(same, self.mapping), self.mapping.csv.form())
            self.read[file] = read_recording(file, group.format or self.format, request)
        return self.read[file].stream(group.stream)

    def started(self, first_s: float) -> str:
        """When the run began. Raises InputError where nobody says."""
        if self.mapping.started_utc is not None:
            return self.mapping.started_utc
        if is_date(first_s):
            return utc(first_s)
        for recording in self.read.values():
            if recording.started_utc is not None:
                return recording.started_utc
        raise InputError("does not say when it was recorded: state started_utc in the mapping", file=self.path)

    def note(self) -> str:
        """Where the run is from, for its record."""
        sources = [f"{file.name} (SHA-256 {_sha256(file)})" for file in self.read if file.is_file()]
        sources += dict.fromkeys(note for recording in self.read.values() for note in recording.notes)
        accepted = f"; accepted: {', '.join(self.mapping.accept)}" if self.mapping.accept else ""
        return f"imported from {'; '.join(sources) or self.path.name}{accepted}"[:9_000]

    def _file(self, group: ColumnSource, part: SegmentPart | None) -> Path:
        name = group.file or (part.file if part is not None else None)
        return self.path if name is None else _beside(self.path, name)


def _sha256(file: Path) -> str:
    with file.open("rb") as source:
        return file_digest(source, "sha256").hexdigest()


def _wanted(groups: Sequence[ColumnSource], mapping: Mapping) -> dict[str, WantedColumns]:
    """The columns of each stream of one file."""
    found: dict[str, WantedColumns] = {}
    for group in groups:
        column, unit = clock_of(group, mapping.time) or ("", "")
        is_text, clock = unit == "iso", frozenset([column] if column else [])
        stated = [getattr(group, name, None) for name in ("columns", "column")]
        numbers = frozenset(n for s in stated if s is not None for n in ((s,) if isinstance(s, str) else s))
        texts = clock if is_text else frozenset[str]()
        if group is mapping.reading:
            texts |= frozenset(name for name in (mapping.segment_column, mapping.mode_column) if name)
        one = WantedColumns(numbers | (frozenset() if is_text else clock), texts)
        found[group.stream] = found.get(group.stream, WantedColumns()) | one
    return found


def _rows(opened: _Opened, part: SegmentPart | None) -> FileRows:
    """The rows of one file, at the readings' stamps."""
    mapping, own = opened.mapping, _Readings(opened, part)
    return FileRows(
        t_s=own.at.t_s,
        reading=attitude.turned(own.values, mapping.reading.axes) * nT_OF[mapping.reading.unit],
        reference=_reference(mapping, own),
        attitude=_attitudes(mapping, own),
        angle_deg=_angle(mapping, own),
        channels=_channels(mapping, own),
        labels=_labels(own.stream, own.at, mapping.segment_column),
        modes=_labels(own.stream, own.at, mapping.mode_column),
        part=part,
        clocks=own.clocks,
    )


class _Readings:
    """The readings of one file and their clock, to which every other group is brought."""

    def __init__(self, opened: _Opened, part: SegmentPart | None) -> None:
        self._opened, self._part, self._mapping = opened, part, opened.mapping
        self.clocks: dict[str, StampStatistics] = {}
        self.stream, at, values = self.sampled(self._mapping.reading, "reading", self._mapping.reading.columns)
        self.at = Stamps(at.t_s[:: self._mapping.reading.every], at.rows[:: self._mapping.reading.every])
        self.values = values[self.at.rows]

    def sampled(self, group: ColumnSource, name: str, columns: Sequence[str]) -> tuple[Stream, Stamps, Array]:
        """A group's stream, its stamps, and its columns (n, k) of all rows."""
        stream = self._opened.stream(group, self._part)
        at = stamps_of(stream, group, self._mapping.time, columns[0])
        values = stream.together([*columns, *_clock_columns(group, self._mapping)])[:, : len(columns)]
        self.clocks[name] = _clock(at, values)
        return stream, at, values

    def bring(self, group: ColumnSource, name: str, columns: Sequence[str], change: Change = lambda v: v) -> Array:
        """A group's columns (n, k), through `change`, at the readings' stamps."""
        stream, at, values = self.sampled(group, name, columns)
        if stream is self.stream and _same_clock(group, self._mapping):
            return change(values)[self.at.rows]
        return interpolated(self.at.t_s, at.t_s, change(values[at.rows]))


def _clock_columns(group: ColumnSource, mapping: Mapping) -> list[str]:
    """The column of the group's clock where it holds numbers: it has to be as long as the others."""
    clock = clock_of(group, mapping.time)
    return [] if clock is None or clock[1] == "iso" else [clock[0]]


def _same_clock(group: ColumnSource, mapping: Mapping) -> bool:
    names = ("time", "time_unit", "clock_offset_s", "clock_rate_ppm")
    return all(getattr(group, name) == getattr(mapping.reading, name) for name in names)


def _clock(at: Stamps, values: Array) -> StampStatistics:
    steps = np.diff(at.t_s)
    missing = int(np.isnan(values[at.rows]).any(axis=1).sum())
    return StampStatistics(float(at.t_s[0]), float(at.t_s[-1]), period_s(at.t_s), len(at.t_s), missing, steps)


def _reference(mapping: Mapping, own: _Readings) -> Array | None:
    part = mapping.reference
    factor = nT_OF[part.unit or "nT"]
    if part.columns is not None:
        return own.bring(part, "reference", part.columns, lambda v: attitude.turned(v, part.axes) * factor)
    if part.column is not None:
        return own.bring(part, "reference", (part.column,), lambda v: v * factor)
    return None


def _attitudes(mapping: Mapping, own: _Readings) -> Array | None:
    group = mapping.attitude
    if group is None:
        return None
    stream, at, values = own.sampled(group, "attitude", group.columns)
    try:
        return attitude.body_from_cage(own.at.t_s, at.t_s, values[at.rows], group)
    except ValueError as error:
        raise InputError(str(error), file=stream.file, column=group.columns[0]) from None


def _angle(mapping: Mapping, own: _Readings) -> Array | None:
    part = mapping.angle
    if part is None:
        return None
    factor = part.sign * (1.0 if part.unit == "deg" else 180 / np.pi)
    return own.bring(part, "angle", (part.column,), lambda v: _unwrapped(v[:, 0] * factor)[:, None])[:, 0]


def _unwrapped(angle_deg: Array) -> Array:
    """Angles (n,) [deg] that run on at the full turn, over those that are missing."""
    known = np.isfinite(angle_deg)
    out = np.array(angle_deg)
    out[known] = np.unwrap(out[known], period=360.0)
    return out


def _channels(mapping: Mapping, own: _Readings) -> dict[str, Array]:
    found = {}
    for name, part in mapping.channels.items():
        _, factor, offset = part.converted
        values = own.bring(part, f"channel {name}", (part.column,))
        found[name] = values[:, 0] * factor + offset
    return found


def _labels(stream: Stream, own: Stamps, column: str | None) -> list[str] | None:
    if column is None:
        return None
    cells = stream.text(column)
    return [cells[row] for row in own.rows]


def _together(parts: Sequence[FileRows]) -> FileRows:
    """The rows of all files, one after the other. Raises InputError where one begins before the one before it ends."""
    for before, after in pairwise(parts):
        if after.t_s[0] <= before.t_s[-1]:
            here = after.part.id if after.part else ""
            what = f"segment {here!r} begins at {after.t_s[0]:.9g} s, before the one before it ends"
            raise InputError(f"{what} ({before.t_s[-1]:.9g} s): time must grow through all files")
    return parts[0] if len(parts) == 1 else FileRows.joined(parts)
