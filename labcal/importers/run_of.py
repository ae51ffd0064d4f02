"""Rows at one clock, with what the mapping states, as a `Run`: its segments, their frames, and its reference."""

from __future__ import annotations

import re
from collections.abc import Mapping as Mapped
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from labcal.earth.igrf import igrf_nT
from labcal.earth.wmm import wmm
from labcal.errors import InputError
from labcal.importers.attitude import one_attitude
from labcal.importers.doubts import StampStatistics
from labcal.importers.mapping import Mapping, SegmentPart
from labcal.importers.model_field import day_of
from labcal.record import Channel, Dut, Reference, Run, Segment
from labcal.record.run_id import as_file_name

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class FileRows:
    """What one file gave, at the readings' stamps; `part` is the segment whose file it is."""

    t_s: Array  # (n,)
    reading: Array  # (n, 3) nT or counts, body axes
    reference: Array | None  # (n, 3) or (n, 1) nT; None where it is computed or there is none
    attitude: Array | None  # (n, 3, 3) body_from_cage
    angle_deg: Array | None  # (n,)
    channels: Mapped[str, Array]
    labels: Sequence[str] | None
    modes: Sequence[str] | None
    part: SegmentPart | None
    clocks: Mapped[str, StampStatistics]
    lengths: tuple[int, ...] = ()  # rows of each file, where several were joined

    def since(self, origin_s: float) -> FileRows:
        """The same with times that count from `origin_s`, to the nanosecond."""
        return replace(self, t_s=np.round(self.t_s - origin_s, 9)) if origin_s else self

    @classmethod
    def joined(cls, parts: Sequence[FileRows]) -> FileRows:
        """One after the other."""
        first = parts[0]

        def both(name: str) -> Array | None:
            return None if getattr(first, name) is None else np.concatenate([getattr(p, name) for p in parts])

        def texts(name: str) -> list[str] | None:
            return None if getattr(first, name) is None else [cell for p in parts for cell in getattr(p, name)]

        return cls(
            t_s=np.concatenate([p.t_s for p in parts]),
            reading=np.concatenate([p.reading for p in parts]),
            reference=both("reference"), attitude=both("attitude"), angle_deg=both("angle_deg"),
            channels={name: np.concatenate([p.channels[name] for p in parts]) for name in first.channels},
            labels=texts("labels"), modes=texts("modes"), part=None,
            clocks={f"{name} of {p.part.id}" if p.part else name: c for p in parts for name, c in p.clocks.items()},
            lengths=tuple(len(p.t_s) for p in parts),
        )  # fmt: skip


def run_of(mapping: Mapping, rows: FileRows, started_utc: str, note: str, name: str) -> Run:
    """The run. Raises InputError where segments leave no row, or the field of the place cannot be computed."""
    segments, index = _segments(mapping, rows)
    used = index >= 0
    if not used.any():
        raise InputError("no row lies in any of the segments that the mapping states")
    reference, vector, magnitude = _reference(mapping, rows, segments, started_utc)
    segments, vector = _in_the_body(mapping, rows, segments, index, vector)
    segments = (replace(segments[0], note="; ".join(filter(None, (segments[0].note, note)))), *segments[1:])
    count = mapping.dut.nominal_nT_per_count
    run = Run(
        run_id=mapping.run_id or _run_id(name),
        started_utc=started_utc,
        simulated=False,
        operator=mapping.operator,
        dut=Dut(mapping.dut.serial, mapping.dut.model, "count" if count else "nT", count or 1.0, mapping.dut.noise_nT),
        reference=reference,
        segments=segments,
        t_s=rows.t_s,
        segment_index=index,
        reading=rows.reading,
        reference_vector=vector,
        reference_magnitude=magnitude,
        angle_deg=rows.angle_deg,
        row_mode=None if rows.modes is None else np.array(rows.modes, dtype=np.str_),
        channels=tuple(
            Channel(key, part.converted[0], part.of_quantity, rows.channels[key], part.role)
            for key, part in mapping.channels.items()
        ),
    )
    return run if used.all() else run.select(used)


def _run_id(name: str) -> str:
    """A run id made of the recording's name."""
    word = re.sub(r"[^A-Za-z0-9._+-]+", "-", as_file_name(name)).strip("-.+_")
    return word[:100] or "imported"


def _segments(mapping: Mapping, rows: FileRows) -> tuple[tuple[Segment, ...], NDArray[np.intp]]:
    """The segments, and which one each row is of; -1 where of none."""
    if rows.labels is not None:
        return _by_label(rows.labels)
    if rows.lengths or rows.part is not None:
        parts = [part.segment() for part in mapping.segments]
        return tuple(parts), np.repeat(np.arange(len(parts)), rows.lengths or (len(rows.t_s),))
    if not mapping.segments:
        return (Segment("all", "free"),), np.zeros(len(rows.t_s), dtype=np.intp)
    index = np.full(len(rows.t_s), -1, dtype=np.intp)
    begins = [-np.inf if part.start_s is None else part.start_s for part in mapping.segments]
    # the latest to begin has a row that several could have: one without an end lasts until the next begins
    for number in sorted(range(len(begins)), key=lambda n: -begins[n]):
        end = mapping.segments[number].end_s
        after = rows.t_s >= begins[number]
        index[after & (rows.t_s < (np.inf if end is None else end)) & (index < 0)] = number
    there = [n for n in range(len(mapping.segments)) if (index == n).any()]
    place = np.full(len(mapping.segments) + 1, -1, dtype=np.intp)
    place[there] = np.arange(len(there))
    return tuple(mapping.segments[n].segment() for n in there), place[index]


def _by_label(labels: Sequence[str]) -> tuple[tuple[Segment, ...], NDArray[np.intp]]:
    """A segment for each stretch of equal labels; a label that comes again has a number behind it."""
    cells = np.array(labels, dtype=np.str_)
    begins = np.concatenate([[True], cells[1:] != cells[:-1]])
    names: list[str] = []
    for label in cells[begins]:
        word, number = str(label) or "none", 1
        while (word if number == 1 else f"{word}-{number}") in names:
            number += 1
        names.append(word if number == 1 else f"{word}-{number}")
    return tuple(Segment(name, "free") for name in names), np.cumsum(begins) - 1


def _reference(
    mapping: Mapping, rows: FileRows, segments: Sequence[Segment], started_utc: str
) -> tuple[Reference, Array | None, Array | None]:
    """The reference with its field (n, 3) in C or its magnitude (n,); a computed vector needs something that turns."""
    part, n = mapping.reference, len(rows.t_s)
    stated = {
        key: getattr(part, key)
        for key in ("serial", "noise_nT", "place", "u_scale_ppm", "u_offset_nT", "u_align_deg", "u_time_s")
    }
    if part.kind == "none":
        return Reference("none", part.serial), None, None
    if rows.reference is not None:
        if rows.reference.shape[1] == 1:
            return Reference("scalar", **stated), None, rows.reference[:, 0]
        return Reference("vector", **stated), rows.reference, None
    stated["place"] = part.place or "computed"
    value = np.atleast_1d(np.asarray(part.value_nT if part.kind == "site" else _model(mapping, started_utc, stated)))
    turns = rows.attitude is not None or any(s.axis_body or s.body_from_cage for s in segments) or part.frame == "body"
    if len(value) == 3 and turns:
        return Reference("vector", **stated), np.tile(value, (n, 1)), None
    return Reference("scalar", **stated), None, np.full(n, float(np.linalg.norm(value)))


def _model(mapping: Mapping, started_utc: str, stated: dict[str, object]) -> Array:
    """The field of the model; its name as the reference's serial, and its error model where nothing else is stated."""
    part, when = mapping.reference, day_of(mapping.reference.date, started_utc)
    assert part.latitude_deg is not None
    assert part.longitude_deg is not None
    place = f"{part.latitude_deg:g} deg N, {part.longitude_deg:g} deg E, {part.height_m:g} m"
    at = f"at {place}, {when.isoformat()}, {part.cage.upper()}"
    if part.kind == "igrf":
        stated["serial"] = part.serial or f"IGRF {at}"
        return igrf_nT(part.latitude_deg, part.longitude_deg, part.height_m, when, part.cage)
    expected = wmm(part.latitude_deg, part.longitude_deg, part.height_m, when, part.cage)
    stated["serial"] = part.serial or f"{expected.model} {at}"
    if part.u_offset_nT is None:
        stated["u_offset_nT"] = float(np.sqrt(np.mean(expected.u_nT**2)))
    return expected.field_nT


def _in_the_body(
    mapping: Mapping, rows: FileRows, segments: tuple[Segment, ...], index: NDArray[np.intp], vector: Array | None
) -> tuple[tuple[Segment, ...], Array | None]:
    """The frame of each segment's reference; one whose attitude moves has its reference turned into the body's."""
    if vector is None:
        return segments, vector
    if mapping.reference.frame == "body":
        return tuple(replace(s, reference_frame="body") for s in segments), vector
    if rows.attitude is None:
        return segments, vector
    found, turned = [], np.array(vector)
    for number, segment in enumerate(segments):
        here = index == number
        still = one_attitude(rows.attitude[here])
        if still is not None and segment.kind != "rotation":
            a, b, c = still.tolist()
            found.append(replace(segment, kind="static", body_from_cage=(tuple(a), tuple(b), tuple(c))))
            continue
        turned[here] = np.einsum("nij,nj->ni", rows.attitude[here], vector[here])
        found.append(replace(segment, reference_frame="body"))
    return tuple(found), turned
