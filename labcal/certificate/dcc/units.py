"""Units as the D-SI writes them."""

from __future__ import annotations

import re

SI_NAMES = {
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
}


Powers = dict[str, int]


def si_unit(unit: str) -> str:
    r"""The D-SI name of a unit: nT/degC is \nano\tesla\per\degreecelsius. What SI has no name for follows a bar."""
    return _named(_powers(unit))


def product(one: str, other: str) -> str:
    r"""The D-SI name of the product of two units, as a covariance has it.

    D-SI knows one \per in a unit, and all that follows it is below the line.
    """
    powers = _powers(one)
    for name, power in _powers(other).items():
        powers[name] = powers.get(name, 0) + power
    return _named(powers)


def _powers(unit: str) -> Powers:
    """The power of each unit in a fraction, as nT/degC or nT/A^2; what cannot be read counts as one name."""
    powers: Powers = {}
    above, _, below = "".join(unit.split()).partition("/")
    for part, sign in ((above, 1), (below, -1)):
        match = re.fullmatch(r"([^\^²³]*)(?:\^(\d)|([²³]))?", part)
        name, power = (part, 1) if match is None else (match[1], int(match[2] or {"²": 2, "³": 3}.get(match[3], 1)))
        if name not in ("", "1"):
            powers[name] = powers.get(name, 0) + sign * power
    return powers


def _named(powers: Powers) -> str:
    above = {name: power for name, power in powers.items() if power > 0}
    below = {name: -power for name, power in powers.items() if power < 0}
    if {*above, *below} <= set(SI_NAMES):
        per = r"\per" if below else ""
        return _factors(above) + per + _factors(below) or r"\one"
    line = "/" if below else ""
    below_text = _plain(below) if len(below) < 2 else f"({_plain(below)})"
    return f"|{_plain(above) or '1'}{line}{below_text}"


def _factors(powers: Powers) -> str:
    return "".join(SI_NAMES[name] + (rf"\tothe{{{power}}}" if power > 1 else "") for name, power in powers.items())


def _plain(powers: Powers) -> str:
    return "·".join(name + (f"^{power}" if power > 1 else "") for name, power in powers.items())
