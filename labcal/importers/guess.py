"""A first mapping for a recording, from its names and how its columns behave: for a person to check, line by line."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from labcal.errors import InputError
from labcal.importers import resemblance
from labcal.importers.csv_table import has_decimal_commas
from labcal.importers.mapping import FORMAT
from labcal.importers.readers import read_recording
from labcal.importers.recording import CsvForm, ForeignRecording, ReadRequest, Stream
from labcal.importers.resemblance import Resemblance
from labcal.store.limits import listed

LOOKED_AT = 20_000  # rows of each stream
PREFERRED = ("vehicle_magnetometer", "MAG", "sensor_mag")  # streams that are a magnetometer's, the best first
LATITUDE, LONGITUDE = (
    re.compile(r"^(.*\.)?lat(itude)?$", re.IGNORECASE),
    re.compile(r"^(.*\.)?(lon|lng)(gitude)?$", re.IGNORECASE),
)
MOST_CHANNELS = 12
OWN_UNIT = {
    "ulog": "G",
    "dataflash": "mG",
    "rosbag": "T",
    "iaga": "nT",
    "imagcdf": "nT",
}  # what these formats write a field in
SURE = 2  # of what looks like a magnetometer: its size is the Earth's field in the unit that it states
CALLED_DUT = re.compile(r"dut|test|raw", re.IGNORECASE)


@dataclass(frozen=True, slots=True)
class _Sensor:
    stream: Stream
    clock: Resemblance
    match: Resemblance


def guess(path: Path, format_: str) -> str:
    """The text of a mapping. Raises InputError where nothing looks like a magnetometer with a clock."""
    commas = format_ == "csv" and path.is_file() and has_decimal_commas(path)
    form = CsvForm(decimal="," if commas else ".")
    recording = read_recording(path, format_, ReadRequest(None, form, most_rows=LOOKED_AT))
    streams = _once(recording)
    sensors = sorted(_sensors(streams, OWN_UNIT.get(format_)), key=_preference)
    if not sensors:
        columns = [f"{s.name}/{c}".lstrip("/") for s in streams for c in (*s.numbers, *s.texts)]
        raise InputError(f"{_missing(streams)}: write the mapping by hand; it has {listed(columns)}", file=path)
    reading, reference = _chosen(sensors)
    name = _plain(path.name)
    head = (
        f"# Guessed from {name}: check every line, then",
        f"#   labcal import {name} --from {format_} --map THIS.toml",
    )
    lines = list(_lines(recording, streams, reading, reference))
    end = ("", "[csv]", 'decimal = ","') if commas else ()
    return "\n".join([*head, *lines, *_unused(reading, lines), *end]) + "\n"


def _missing(streams: Sequence[Stream]) -> str:
    """What a magnetometer with a clock lacks here."""
    found = [looked for stream in streams for looked in resemblance.magnetometers(stream)]
    if not found:
        return "no three columns beside a clock look like a magnetometer"
    return (
        f"{listed(list(found[0].columns))} look like a magnetometer, and no column like its clock (numbers that grow, "
        "or dates such as 2026-03-02T08:15:00; rows that come evenly need none, but rate_Hz under [time])"
    )


def _once(recording: ForeignRecording) -> list[Stream]:
    """Each stream once, whatever names it goes by."""
    return list({id(stream): stream for stream in recording.streams.values()}.values())


def _sensors(streams: Sequence[Stream], own_unit: str | None) -> Iterator[_Sensor]:
    for stream in streams:
        clock = resemblance.clock(stream)
        if clock is not None and _one_length(stream, clock):
            yield from (_Sensor(stream, clock, found) for found in resemblance.magnetometers(stream, own_unit))


def _one_length(stream: Stream, clock: Resemblance) -> bool:
    return clock.unit == "iso" or len({len(v) for v in stream.numbers.values()}) == 1 or stream.name == ""


def _preference(sensor: _Sensor) -> tuple[int, int, int]:
    place = [number for number, name in enumerate(PREFERRED) if sensor.stream.name.startswith(name)]
    is_called = bool(CALLED_DUT.search(sensor.match.columns[0]))
    return (place[0] if place else len(PREFERRED), -sensor.match.sure, -is_called)


def _chosen(sensors: Sequence[_Sensor]) -> tuple[_Sensor, _Sensor | None]:
    """The reading and, where there is one, the reference: called so, or beside the reading in the same table."""
    called = [s for s in sensors if resemblance.REFERENCE.search(f"{s.stream.name}/{s.match.columns[0]}")]
    others = [s for s in sensors if s not in called] or list(sensors)
    reading = others[0]
    if called and called[0] is not reading:
        return reading, called[0]
    if reading.match.sure >= SURE and (unsure := _in_a_wrong_unit(reading, others)) is not None:
        return unsure, reading
    values = reading.stream.together(reading.match.columns)
    for other in others[1:]:
        same_table = other.stream is reading.stream and other.match.columns[0].isdigit()
        if same_table and resemblance.together(values, other.stream.together(other.match.columns)):
            return other, reading  # who merges two tables puts the reference first as often as not: to be checked
    return reading, None


def _in_a_wrong_unit(sure: _Sensor, others: Sequence[_Sensor]) -> _Sensor | None:
    """One of the same table that follows `sure` axis by axis, and is no field in the unit that its name states."""
    values = sure.stream.together(sure.match.columns)
    for other in others:
        if other is sure or other.stream is not sure.stream or other.match.sure >= SURE:
            continue
        if resemblance.together(values, other.stream.together(other.match.columns)):
            return other
    return None


def _lines(
    recording: ForeignRecording, streams: Sequence[Stream], reading: _Sensor, reference: _Sensor | None
) -> Iterator[str]:
    yield f'format = "{FORMAT}"'
    if recording.started_utc is None and reading.clock.unit != "iso" and not _is_date(reading):
        yield 'started_utc = "1970-01-01T00:00:00Z"  # CHECK: the recording does not say when it began'
    yield from ("", "[dut]", 'serial = "unknown"  # CHECK')
    yield from ("", "[time]", f"column = {_quoted(reading.clock.columns[0])}  # {reading.clock.why}")
    yield f'unit = "{reading.clock.unit}"  # CHECK'
    yield from ("", "[reading]", *_stream(reading), f"columns = {_list(reading.match.columns)}  # {reading.match.why}")
    yield f'unit = "{reading.match.unit}"'
    yield 'axes = ["x", "y", "z"]  # CHECK: where the body\'s x, y and z come from; ["y", "x", "-z"] turns them'
    yield from ("", "[reference]", *_reference(reading, reference, streams))
    yield from _attitude(streams)
    yield from _gravity(streams)
    yield from _channels(streams, reading, reference)


def _is_date(sensor: _Sensor) -> bool:
    first = float(sensor.stream.number(sensor.clock.columns[0])[0])
    return any(least <= first < 4 * least for least, _ in resemblance.DATES)


def _stream(sensor: _Sensor) -> Iterator[str]:
    if sensor.stream.name:
        yield f"stream = {_quoted(sensor.stream.name)}"


def _reference(reading: _Sensor, reference: _Sensor | None, streams: Sequence[Stream]) -> Iterator[str]:
    if reference is not None:
        yield from (
            'kind = "vector"',
            *_stream(reference),
            f"columns = {_list(reference.match.columns)}  # {reference.match.why}",
        )
        yield f'unit = "{reference.match.unit}"'
        yield 'frame = "body"  # CHECK: "body" where it turns with the device, "cage" where it stands'
        if reference.clock.columns != reading.clock.columns:
            yield f"time = {_quoted(reference.clock.columns[0])}"
        return
    f = next((n for n in reading.stream.numbers if n.lower() in ("f", "ref_f", "total")), None)
    place = _place(streams)
    if f is not None:
        yield from (
            'kind = "scalar"',
            *_stream(reading),
            f"column = {_quoted(f)}",
            f'unit = "{reading.match.unit}"  # CHECK',
        )
    elif place is not None:
        yield from ('kind = "igrf"  # the Earth\'s field at the place where the recording was made', *place)
    else:
        yield 'kind = "none"  # CHECK: kind = "site" and value_nT, the field\'s magnitude, or "igrf" and the place'
        yield from _follower(reading)


def _follower(reading: _Sensor) -> Iterator[str]:
    """As a comment: who follows the reading may be its reference, or another magnetometer that turns with it."""
    own, stream = reading.match.columns, reading.stream
    for other in resemblance.magnetometers(stream):
        if other.columns != own and resemblance.together(stream.together(own), stream.together(other.columns)):
            yield "# these follow the reading; if they are its reference, in place of the kind above:"
            yield from ('# kind = "vector"', f"# columns = {_list(other.columns)}", f'# unit = "{other.unit}"')
            yield '# frame = "body"'
            return


def _unused(reading: _Sensor, lines: Sequence[str]) -> Iterator[str]:
    """As a comment: columns beside the reading that no line names; an angle may be among them."""
    said, clock = "\n".join(lines), reading.clock.columns[0].split(" ")  # a day and a time of day are one by both names
    names = (*reading.stream.numbers, *reading.stream.texts)
    rest = [name for name in names if _quoted(name) not in said and name not in clock]
    if rest:
        yield from ("", f"# not used: {_plain(listed(rest))}; docs/import.md has what else a mapping may state")


def _place(streams: Sequence[Stream]) -> list[str] | None:
    """Where a receiver says it was, in degrees; some write ten-millionths."""
    for stream in streams:
        found = [next((n for n in stream.numbers if pattern.match(n)), None) for pattern in (LATITUDE, LONGITUDE)]
        if found[0] is None or found[1] is None:
            continue
        latitude, longitude = (float(np.nanmedian(stream.numbers[name])) for name in found if name)
        scale = 1e-7 if max(abs(latitude), abs(longitude)) > 360 else 1.0
        if 0 < abs(latitude * scale) <= 90 and abs(longitude * scale) <= 360:
            return [f"latitude_deg = {latitude * scale:.4f}", f"longitude_deg = {longitude * scale:.4f}"]
    return None


def _attitude(streams: Sequence[Stream]) -> Iterator[str]:
    """As a comment: what a quaternion means is nowhere in the file, and an autopilot's rests on its magnetometer."""
    named = sorted(streams, key=lambda s: (not s.name.startswith("vehicle_attitude"), "attitude" not in s.name))
    for stream in named:
        found = resemblance.quaternion(stream)
        if found is not None:
            yield from ("", "# [attitude]  # an autopilot's rests on the magnetometer itself: no reference for it")
            yield from (f"# {line}" for line in ([f"stream = {_quoted(stream.name)}"] if stream.name else []))
            yield f"# columns = {_list(found.columns)}  # {found.why}"
            yield from (f'# order = "{found.unit}"  # CHECK', '# maps = "body-to-cage"  # CHECK')
            return


def _gravity(streams: Sequence[Stream]) -> Iterator[str]:
    for stream in streams:
        found = resemblance.gravity(stream)
        if found is not None:
            where = f"{stream.name} " if stream.name else ""
            yield from (
                "",
                f"# gravity, as it seems: {where}{_list(found.columns)} ({found.unit}, {found.why}); not used",
            )
            return


def _channels(streams: Sequence[Stream], reading: _Sensor, reference: _Sensor | None) -> Iterator[str]:
    taken = {c for s in (reading, reference) if s is not None for c in (*s.match.columns, *s.clock.columns)}
    names: set[str] = set()
    for stream in sorted(streams, key=lambda s: s is not reading.stream):
        clock = resemblance.clock(stream)
        for found in resemblance.channels(stream, taken) if clock is not None else ():
            name = _channel_name(stream, found, names)
            if name in names or len(names) == MOST_CHANNELS:
                continue
            names.add(name)
            yield from ("", f"[channels.{name}]")
            if stream.name:
                yield f"stream = {_quoted(stream.name)}"
            yield from (f"column = {_quoted(found.columns[0])}  # {found.why}", f'unit = "{found.unit}"')
            if clock is not None and clock.columns != reading.clock.columns:
                yield from (f"time = {_quoted(clock.columns[0])}", f'time_unit = "{clock.unit}"')


def _channel_name(stream: Stream, found: Resemblance, names: set[str]) -> str:
    column = f"channel_{found.columns[0]}" if found.columns[0].isdigit() else found.columns[0]
    short = re.sub(r"\W+", "_", column).strip("_").lower()
    return short if short not in names else re.sub(r"\W+", "_", f"{stream.name}_{short}").strip("_").lower()


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=not text.isprintable())  # of TOML's basic strings, too


def _list(names: Sequence[str]) -> str:
    return "[" + ", ".join(map(_quoted, names)) + "]"


def _plain(text: str) -> str:
    return "".join(letter if letter.isprintable() else "?" for letter in text)
