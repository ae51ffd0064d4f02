"""The two letters of a country (ISO 3166-1), also of one that was written out. No widgets."""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QLocale


def country_code(typed: str) -> str:
    """DE of "de", "Germany" or "Deutschland"; "" of what is no country."""
    return _codes().get(typed.strip().casefold(), "")


@cache
def _codes() -> dict[str, str]:
    """By code, by English name, and by the name in a language that is spoken there."""
    found = dict[str, str]()
    for one in QLocale.matchingLocales(
        QLocale.Language.AnyLanguage, QLocale.Script.AnyScript, QLocale.Country.AnyCountry
    ):
        code = QLocale.territoryToCode(one.territory())
        if len(code) == len("DE") and code.isalpha():
            for name in (code, QLocale.territoryToString(one.territory()), one.nativeTerritoryName()):
                found.setdefault(name.casefold(), code)
    return found
