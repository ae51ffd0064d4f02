"""What columns look like by names and behaviour: a clock, a magnetometer, gravity, a quaternion, a temperature."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from labcal.importers.recording import Stream
from labcal.importers.units import nT_OF

Array = NDArray[np.float64]

EARTH_nT = (20_000.0, 70_000.0)  # of the Earth's field anywhere on its surface
FIELD_UNITS = ("nT", "uT", "mT", "T", "mG", "G")
GRAVITY = ((9.0, 10.6, "m/s2"), (0.9, 1.08, "g"), (900.0, 1080.0, "mg"))
DATES = ((1e9, "s"), (1e12, "ms"), (1e15, "us"), (1e18, "ns"))  # seconds since 1970 in each, from 2001
ENDS = (
    ("_ns", "ns"),
    ("_us", "us"),
    ("timeus", "us"),
    ("timestamp", "us"),
    ("_ms", "ms"),
    ("millis", "ms"),
    ("_s", "s"),
)
CLOCK = re.compile(r"time|stamp|^t$|^t[_ (\[]|sec|millis|received|utc|date", re.IGNORECASE)
MAGNETIC = re.compile(r"mag|field|^b[_.]?[xyz]|hmc|compass|dut|flux|^[xyz]$", re.IGNORECASE)
OTHER = re.compile(r"acc|gyr|vel|pos|rate|grav|bias|off|ofs|cov|torque|mo[xyz]$", re.IGNORECASE)
AXIS = re.compile(r"(^|[_. ])[xyz]([_. ]|$)", re.IGNORECASE)  # a letter that stands alone
IN_NAME = (
    (r"(^|[_\[(])g(a(uss)?)?($|[_\[\])])", "G"),
    (r"(^|[_\[( ])nt($|[_\[\])])", "nT"),
    (r"(^|[_\[( ])[uµμ]t($|[_\[\])])", "uT"),
    (r"(^|[_\[( ])mg($|[_\[\])])", "mG"),
)
REFERENCE = re.compile(r"ref|truth|true|igrf|wmm|model|fluxgate|overhauser|normal[_ .]", re.IGNORECASE)
DATE = re.compile(r"(\d{4}-\d\d-\d\d[T ]|\d{1,2}\.\d{1,2}\.\d{4} +)\d\d:")
OF_THREE = (("x", "y", "z"), ("0", "1", "2"), ("1", "2", "3"))
LEAST = 8  # rows, to say anything
SELDOM = 0.01  # of the steps of a column that is called a clock may go back: the import names them


@dataclass(frozen=True, slots=True)
class Resemblance:
    """Columns that look like something, in `unit`; `why` is for the person who checks, `sure` ranks what competes."""

    columns: tuple[str, ...]
    unit: str
    why: str
    sure: int = 0


def clock(stream: Stream) -> Resemblance | None:
    """The column whose values grow and that is called so, else any that grow; a text column of dates where none do."""
    growing = [name for name, values in stream.numbers.items() if _grows(values)]
    named = [name for name in growing if CLOCK.search(name)]
    dated = [name for name, cells in stream.texts.items() if cells and DATE.match(cells[0])]
    if dated and not named:  # a count of rows grows, too
        return Resemblance((dated[0],), "iso", "dates")
    called = [name for name, values in stream.numbers.items() if CLOCK.search(name) and _grows(values, SELDOM)]
    for name in [*named, *called, *growing]:
        return Resemblance(
            (name,), _time_unit(name, stream.numbers[name]), f"grows from row to row, {_step(stream, name)}"
        )
    return None


def _grows(values: Array, but: float = 0.0) -> bool:
    """Whether no step goes back, or no more than that part of them."""
    if len(values) < LEAST or not np.isfinite(values).all():
        return False
    steps = np.diff(values)
    return bool((steps < 0).mean() <= but and (steps > 0).mean() > 0.5)


def _step(stream: Stream, name: str) -> str:
    return f"by {np.median(np.diff(stream.numbers[name])):.4g} in the median"


def _time_unit(name: str, values: Array) -> str:
    """By size where it is a date, else by name, else by what makes a usual rate of the median step."""
    dated = [unit for least, unit in DATES if least <= values[0] < 4 * least]
    if dated:
        return dated[0]
    called = next((unit for end, unit in ENDS if name.lower().endswith(end)), None)
    if called:
        return called
    step = float(np.median(np.diff(values)))
    if step < 10 and not (step >= 1 and np.all(values == np.round(values))):
        return "s"
    return "ms" if step < 2000 else "us"


def triples(stream: Stream) -> Iterator[tuple[str, str, str]]:
    """Three columns whose names differ by x, y, z or by 0, 1, 2; of a table without names, three in a row."""
    names = list(stream.numbers)
    if all(name.isdigit() for name in names):
        yield from ((a, b, c) for a, b, c in zip(names[1::3], names[2::3], names[3::3], strict=False))
        return
    for name in names:
        for letters in OF_THREE:
            for place in (m.start() for m in re.finditer(re.escape(letters[0]), name, re.IGNORECASE)):
                found = [_with(name, place, letter) for letter in letters]
                if found[0] == name and all(one in stream.numbers for one in found):
                    yield (found[0], found[1], found[2])


def _with(name: str, place: int, letter: str) -> str:
    return name[:place] + (letter.upper() if name[place].isupper() else letter) + name[place + 1 :]


def magnetometers(stream: Stream, own_unit: str | None = None) -> list[Resemblance]:
    """Threes of columns whose magnitude is the Earth's field in some unit, or that are called so; the surest first.

    `own_unit` is what the format itself writes such columns in.
    """
    found: dict[tuple[str, ...], Resemblance] = {}
    for names in triples(stream):
        size, called = _size(stream, names), f"{stream.name}/{names[0]}"
        if np.isfinite(size) and size > 0 and not OTHER.search(called) and names not in found:
            looks = _magnetometer(names, size, called, own_unit)
            found |= {names: looks} if looks is not None else {}
    return sorted(found.values(), key=lambda looks: -looks.sure)


def _magnetometer(names: tuple[str, ...], size: float, called: str, own_unit: str | None) -> Resemblance | None:
    by_size = [unit for unit in FIELD_UNITS if EARTH_nT[0] <= size * nT_OF[unit] <= EARTH_nT[1]]
    by_name = next((unit for pattern, unit in IN_NAME if re.search(pattern, names[0].lower())), own_unit)
    is_named = bool(MAGNETIC.search(called))
    if not (by_size or is_named or names[0].isdigit() or AXIS.search(names[0])):
        return None
    unit = by_name or (by_size[0] if by_size else "uT")
    is_sure = unit in by_size
    why = f"{size:.4g} in the median, {size * nT_OF[unit] / 1e3:.4g} µT in this unit"
    return Resemblance(names, unit, why if is_sure else f"{why}: CHECK the unit", 2 * is_sure + is_named)


def _size(stream: Stream, names: Sequence[str]) -> float:
    values = np.linalg.norm(stream.together(names), axis=1)
    known = values[np.isfinite(values)]
    return float(np.median(known)) if len(known) >= LEAST else float("nan")


def gravity(stream: Stream) -> Resemblance | None:
    """Three columns that are as long as gravity, nearly always."""
    for names in triples(stream):
        values = np.linalg.norm(stream.together(names), axis=1)
        for least, most, unit in GRAVITY:
            is_called = unit == "m/s2" or "acc" in f"{stream.name}/{names[0]}".lower()
            within = len(values) >= LEAST and np.mean((values > least) & (values < most)) > 0.8
            if within and is_called and not names[0].isdigit():
                return Resemblance(names, unit, f"{np.nanmedian(values):.4g} in the median")
    return None


def quaternion(stream: Stream) -> Resemblance | None:
    """Four columns in a row whose length is one in every row and that are no constant."""
    names = list(stream.numbers)
    for four in zip(names, names[1:], names[2:], names[3:], strict=False):
        values = np.stack([stream.numbers[n] for n in four], axis=1) if _same_length(stream, four) else np.empty((0, 4))
        if len(values) < LEAST or not np.isfinite(values).all() or np.ptp(values, axis=0).max() == 0:
            continue
        if np.all(np.abs(np.linalg.norm(values, axis=1) - 1) < 0.01):
            order = "xyzw" if four[3].lower().endswith("w") else "wxyz"
            return Resemblance(four, order, "of length one in every row")
    return None


def _same_length(stream: Stream, names: Sequence[str]) -> bool:
    return len({len(stream.numbers[name]) for name in names}) == 1


CHANNELS: Mapping[str, tuple[tuple[str, float, float], ...]] = {  # by name; unit where the median lies between
    r"temp": (("K", 200.0, 400.0), ("degC", -60.0, 150.0)),
    r"curr|_amps?\b|^i_|_ma$|[\[(]m?A[\])]$": (("A", -1e3, 1e3), ("mA", -1e6, 1e6)),
    r"volt|^u_|_mv$": (("V", -1e3, 1e3), ("mV", -1e6, 1e6)),
}


def channels(stream: Stream, taken: set[str]) -> Iterator[Resemblance]:
    """Temperatures, currents and voltages by name; of a table without names, what is as warm as a room."""
    for name, values in stream.numbers.items():
        known = values[np.isfinite(values)]
        if name in taken or len(known) < LEAST or np.ptp(known) == 0:
            continue
        middle = float(np.median(known))
        for pattern, units in CHANNELS.items():
            fits = [unit for unit, least, most in units if least <= middle <= most]
            if re.search(pattern, name, re.IGNORECASE) and fits:
                stated = (unit for unit in fits if re.search(rf"[^A-Za-z]{unit}[\])]?$", name))
                yield Resemblance((name,), next(stated, fits[0]), f"{middle:.4g} in the median")
                break
        else:
            if name.isdigit() and 250 < middle < 350 and np.ptp(known) < 120:
                yield Resemblance((name,), "K", f"{middle:.4g} in the median")


def together(one: Array, other: Array) -> bool:
    """Whether two threes of columns (n, 3) follow each other, axis by axis in some order."""
    if one.shape != other.shape:
        return False
    known = np.isfinite(one).all(axis=1) & np.isfinite(other).all(axis=1)
    if known.sum() < LEAST or (np.ptp(one[known], axis=0) == 0).any() or (np.ptp(other[known], axis=0) == 0).any():
        return False
    related = np.abs(np.corrcoef(one[known].T, other[known].T)[:3, 3:])
    return bool((related.max(axis=1) > 0.8).all())
