"""What the coils need of bench.toml to come to zero, and no more: read in a moment, whatever else in the file is wrong.

Who says off has no second to load what checks the rest, and is not refused for a word that misspells the DUT.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from labcal.errors import InputError
from labcal.files.toml_file import add_missing, read_toml, readable_parts

AXES = ("x", "y", "z")
OWNED = ("coil-", "polarity", "interlock")  # roles of what can hurt, or keep from it
EMULATED = "emulated://"


@dataclass(frozen=True, slots=True)
class StatedInstrument:
    """One instrument: as in `InstrumentConfig`."""

    driver: str
    link: str
    role: str
    settings: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class StatedLimits:
    """Of the coils [A, A/s]; inf where the file states none that can be read: the supply's own ramp stays."""

    current_A: tuple[float, float, float] = (math.inf,) * 3
    ramp_A_per_s: tuple[float, float, float] = (math.inf,) * 3


@dataclass(frozen=True, slots=True)
class StatedCage:
    """As in `CageConfig`."""

    limits: StatedLimits


@dataclass(frozen=True, slots=True)
class StatedSafety:
    """As in `SafetyConfig`."""

    group: str | None = None
    runtime: str | None = None


@dataclass(frozen=True, slots=True)
class Essentials:
    """As much of `BenchConfig` as the way to zero asks for. A coil that the file does not name is not there."""

    instruments: Mapping[str, StatedInstrument]
    cage: StatedCage
    safety: StatedSafety

    @property
    def guarded(self) -> list[str]:
        """The instruments that can hurt, or keep from it, by name."""
        return [name for name, entry in self.instruments.items() if entry.role.startswith(OWNED)]

    @property
    def guarded_links(self) -> list[str]:
        """Their links."""
        return [self.instruments[name].link for name in self.guarded]

    @property
    def axes(self) -> list[str]:
        """The coils whose supplies it names."""
        roles = [entry.role for entry in self.instruments.values()]
        return [axis for axis in AXES if f"coil-{axis}" in roles]


def essentials(path: Path) -> Essentials | None:
    """What the file says of the coils; None where only all of it can tell (emulated; a coil named twice).

    Raises InputError where it is no TOML or names no coil's supply at all, OSError where it cannot be read.
    """
    table = read_toml(path)[1]
    if not any(_names_a_coil(said) for said in _table(table, "instruments").values()):
        raise InputError("it names no supply of a coil", file=path)
    return of_table(table)


def legible(path: Path) -> list[Essentials]:
    """What can be read of a file that is refused as a whole; several where it names a coil twice: each has it once.

    Empty where it names no coil's supply, or one that is emulated. Raises OSError where it cannot be read.
    """
    parts, benches, rest = readable_parts(path), list[dict[str, Any]](), dict[str, Any]()
    for part in parts:
        add_missing(rest, {key: value for key, value in part.items() if key in ("cage", "safety")})
    for name, said in _entries(parts):
        room = (bench for bench in benches if name not in bench and said["role"] not in _roles(bench))
        if (bench := next(room, None)) is None:
            benches.append(bench := {})
        bench[name] = said
    found = (of_table(rest | {"instruments": bench}) for bench in benches)
    return [bench for bench in found if bench is not None]


def _entries(parts: Iterable[Mapping[str, Any]]) -> list[tuple[str, dict[str, Any]]]:
    """The instruments by name as they follow one another; a table of settings belongs to the last one of its name."""
    entries = list[tuple[str, dict[str, Any]]]()
    for name, said in ((name, said) for part in parts for name, said in _table(part, "instruments").items()):
        before = next((one for known, one in reversed(entries) if known == name), None)
        if before is not None and isinstance(said, dict) and "role" not in said:
            add_missing(before, said)
        elif isinstance(said, dict):
            entries.append((name, said))
    return [(name, said) for name, said in entries if _entry(said)]


def _roles(bench: Mapping[str, Any]) -> list[str]:
    return [said["role"] for said in bench.values()]


def _names_a_coil(said: Any) -> bool:
    return isinstance(said, dict) and str(said.get("role")).startswith("coil-")


def as_table(bench: Any) -> dict[str, Any]:
    """What `of_table` reads, of a bench or its essentials: as JSON can carry it."""
    owned = ((name, bench.instruments[name]) for name in bench.guarded)
    limits = bench.cage.limits
    return {
        "instruments": {
            name: {"driver": one.driver, "link": one.link, "role": one.role, "settings": dict(one.settings)}
            for name, one in owned
        },
        "cage": {"limits": {"current_A": [*limits.current_A], "ramp_A_per_s": [*limits.ramp_A_per_s]}},
        "safety": {"group": bench.safety.group, "runtime": bench.safety.runtime},
    }


def of_table(table: Mapping[str, Any]) -> Essentials | None:
    """The essentials of a bench file's table; None as above."""
    entries = {name: entry for name, said in _table(table, "instruments").items() if (entry := _entry(said))}
    limits, safety = _table(_table(table, "cage"), "limits"), _table(table, "safety")
    roles = [entry.role for entry in entries.values() if entry.role.startswith(OWNED)]
    found = Essentials(
        entries,
        StatedCage(StatedLimits(_each_axis(limits.get("current_A")), _each_axis(limits.get("ramp_A_per_s")))),
        StatedSafety(*(value if isinstance(value := safety.get(key), str) else None for key in ("group", "runtime"))),
    )
    alone = len(roles) == len({*roles}) and not any(link.startswith(EMULATED) for link in found.guarded_links)
    return found if alone and found.axes else None


def _table(table: Mapping[str, Any], key: str) -> dict[str, Any]:
    value = table.get(key)
    return value if isinstance(value, dict) else {}


def _entry(said: Any) -> StatedInstrument | None:
    if not isinstance(said, dict):
        return None
    driver, link, role, settings = (said.get(key) for key in ("driver", "link", "role", "settings"))
    if not (isinstance(driver, str) and isinstance(link, str) and isinstance(role, str) and "://" in link):
        return None
    if role.startswith("coil-") and role.removeprefix("coil-") not in AXES:  # misspelt: it names no coil
        return None
    return StatedInstrument(driver, link, role, settings if isinstance(settings, dict) else {})


def _each_axis(value: Any) -> tuple[float, float, float]:
    """One number, or one an axis; inf for whatever is none that a limit can be."""
    values = value if isinstance(value, list) and len(value) == len(AXES) else [value] * len(AXES)
    x, y, z = (_limit(one) for one in values)
    return x, y, z


def _limit(value: Any) -> float:
    real = isinstance(value, (int, float)) and not isinstance(value, bool)
    return float(value) if real and value > 0 else math.inf
