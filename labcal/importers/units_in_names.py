"""Where a column's own name states another unit than the mapping: `t_s` in ms, `mag_x [uT]` in nT."""

from __future__ import annotations

import re
from collections.abc import Iterator

from labcal.importers.doubts import ImportFinding
from labcal.importers.mapping import Mapping

KINDS = (
    ("s", "ms", "us", "ns", "min"), ("nT", "uT", "mT", "mG"), ("deg", "rad"), ("degC", "K", "degF"),
    ("A", "mA", "uA"), ("V", "mV"), ("W", "mW"), ("Pa", "hPa"),
)  # fmt: skip
WRITTEN = {"us": "us|µs|μs", "uT": "uT|µT|μT", "deg": "deg|°", "degC": "degC|°C|C", "uA": "uA|µA|μA"}


def units_in_names(mapping: Mapping) -> Iterator[ImportFinding]:
    """One finding a column; the mapping may well be right, so that nothing is refused for it."""
    for column, stated in dict.fromkeys(_columns(mapping)):
        said = _in_name(column, stated)
        if said is not None and not re.fullmatch(WRITTEN.get(said, said), stated):
            yield ImportFinding(f"column {column}: its name says {said}, the mapping {stated}: which is right?")


def _columns(mapping: Mapping) -> Iterator[tuple[str, str]]:
    """Every column that has a unit, of three the first, and that unit."""
    reading, reference = mapping.reading, mapping.reference
    found: list[tuple[str | None, str | None]] = [(mapping.time.column, mapping.time.unit)]
    found += [(group.time, group.time_unit or mapping.time.unit) for group in mapping.groups()]
    found += [(reading.columns[0], reading.unit), ((reference.columns or (reference.column,))[0], reference.unit)]
    found += [(part.column, part.unit) for part in (mapping.angle, *mapping.channels.values()) if part is not None]
    yield from ((column, unit) for column, unit in found if column is not None and unit is not None)


def _in_name(name: str, stated: str) -> str | None:
    """A unit of the same kind that stands in brackets, or behind a line or a blank at the end or before the axis."""
    kind = next((kind for kind in KINDS if any(re.fullmatch(WRITTEN.get(u, u), stated) for u in kind)), ())
    for unit in kind:
        word = f"({WRITTEN.get(unit, unit)})"
        if re.search(rf"[\[(] *{word} *[\])]|[_ .]{word}([_ .][xyzXYZ])?$", name):
            return unit
    return None
