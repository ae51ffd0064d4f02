"""Units as the D-SI writes them."""

from __future__ import annotations

import re

SI_NAMES = {
    "1": r"\one",
    "nT": r"\nano\tesla",
    "A": r"\ampere",
    "degC": r"\degreecelsius",
    "°C": r"\degreecelsius",
    "K": r"\kelvin",
    "deg": r"\degree",
    "s": r"\second",
    "h": r"\hour",
    "V": r"\volt",
    "W": r"\watt",
    "m": r"\metre",
    "rad": r"\radian",
    "%": r"\percent",
    "ppm": r"\ppm",
    "pT": r"\pico\tesla",
    "uT": r"\micro\tesla",
    "µT": r"\micro\tesla",
    "arcmin": r"\arcminute",
    "arcsec": r"\arcsecond",
    "mrad": r"\milli\radian",
    "hPa": r"\hecto\pascal",
    "": r"\one",
}


def si_unit(unit: str) -> str:
    r"""The D-SI name of a unit: nT/degC is \nano\tesla\per\degreecelsius. What SI has no name for follows a bar."""
    above, _, below = unit.partition("/")
    parts = [_power(above), _power(below) if below else ""]
    if None in parts:
        return "|" + "".join(unit.split())
    if not below:
        return str(parts[0])
    return ("" if above == "1" else str(parts[0])) + rf"\per{parts[1]}"


def product(one: str, other: str) -> str:
    """The D-SI name of the product of two units, as a covariance has it."""
    named = [si_unit(one), si_unit(other)]
    if any(name.startswith("|") for name in named):
        return "|" + "·".join("".join(unit.split()) or "1" for unit in (one, other))
    return "".join(name for name in named if name != r"\one") or r"\one"


def _power(unit: str) -> str | None:
    """A unit with its whole power, as nT^2; None where SI has no name for it."""
    match = re.fullmatch(r"([^\^]*?)(?:\^(\d)|([²³]))?", unit.strip())
    if match is None or match[1] not in SI_NAMES:
        return None
    power = match[2] or {"²": "2", "³": "3"}.get(match[3] or "", "")
    return SI_NAMES[match[1]] + (rf"\tothe{{{power}}}" if power else "")
