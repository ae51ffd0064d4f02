"""What a certificate states beside the measurement (ISO/IEC 17025:2017, 7.8.2): who, for whom, on what, by what."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields
from datetime import date
from typing import Any, ClassVar

LONGEST = 500
_WHOLLY_KNOWN = {"extra": "forbid"}  # for what pydantic reads


@dataclass(frozen=True, slots=True)
class _Stated:
    """Every text is one printable line; a country has two letters, a day is ISO 8601. Raises ValueError."""

    __pydantic_config__: ClassVar[dict[str, Any]] = _WHOLLY_KNOWN

    def __post_init__(self) -> None:
        for name, value in _texts(self):
            if not value.strip() or len(value) > LONGEST or not value.isprintable():
                raise ValueError(f"{name} must be one printable line of at most {LONGEST} letters")
            if name == "country" and not re.fullmatch("[A-Z]{2}", value):
                raise ValueError(f"country must be two capital letters as DE (ISO 3166-1), not {value!r}")
            if name in ("date", "due", "received") and not _is_day(value):
                raise ValueError(f"{name} must be a date such as 2026-03-02")


def _texts(part: Any) -> Iterator[tuple[str, str]]:
    return ((f.name, value) for f in fields(part) if isinstance(value := getattr(part, f.name), str))


def _is_day(text: str) -> bool:
    try:
        return date.fromisoformat(text).isoformat() == text
    except ValueError:
        return False


@dataclass(frozen=True, slots=True)
class Address(_Stated):
    """A person or company, and where."""

    name: str
    city: str
    country: str
    street: str | None = None
    postcode: str | None = None
    email: str | None = None
    phone: str | None = None

    def lines(self) -> list[str]:
        """As on an envelope, and how to reach them."""
        city = f"{self.country}-{self.postcode} {self.city}" if self.postcode else f"{self.city} ({self.country})"
        return [part for part in (self.name, self.street, city, self.email, self.phone) if part]


@dataclass(frozen=True, slots=True)
class Laboratory(Address):
    """Who issues the certificate; `code` begins its numbers, `accreditation` is the body and the number it gave.

    `place` is where the measurement was made, if not at this address; `timestamp_url` whom to ask for RFC 3161 tokens.
    """

    code: str = "LAB"
    accreditation: str | None = None
    place: str | None = None
    timestamp_url: str | None = None

    def __post_init__(self) -> None:
        _Stated.__post_init__(self)
        if self.timestamp_url is not None and not re.fullmatch(r"https?://[^\s/@]+(/\S*)?", self.timestamp_url):
            raise ValueError("timestamp_url must be as http://HOST/PATH, without blanks or a password")
        if not re.fullmatch("[A-Z0-9]{1,12}", self.code):
            raise ValueError(f"code must be 1 to 12 capital letters and digits, not {self.code!r}")


@dataclass(frozen=True, slots=True)
class Certified(_Stated):
    """The certificate of an instrument; `U` as it states its uncertainty, in words, with k."""

    number: str | None = None
    issuer: str | None = None
    date: str | None = None
    due: str | None = None
    U: str | None = None

    def objection_on(self, day: str) -> str:
        """Why it shows no traceability of what was measured on `day` (ISO 8601); empty where it does."""
        if self.number is None or self.issuer is None or self.date is None:
            return "has no number, issuer or date here"
        if day < self.date:
            return "was not yet issued on the day of the measurement"
        return "was overdue on the day of the measurement" if self.due is not None and self.due < day else ""

    def in_words(self) -> str:
        """All of it on one line; empty where nothing is stated."""
        said = [self.number and f"No. {self.number}", self.issuer, self.date and f"of {self.date}"]
        said += [self.due and f"due {self.due}", self.U and f"U = {self.U}"]
        return ", ".join(filter(None, said))


@dataclass(frozen=True, slots=True)
class Equipment(_Stated):
    """Something beside the reference that the measurement rests on: a thermometer, a standard, a clock."""

    name: str
    manufacturer: str | None = None
    model: str | None = None
    serial: str | None = None
    certificate: Certified | None = None


@dataclass(frozen=True, slots=True)
class Item(_Stated):
    """The device under test as it came in, beside serial and model."""

    manufacturer: str | None = None
    condition: str | None = None
    received: str | None = None


@dataclass(frozen=True, slots=True)
class Administrative:
    """All of it; what is not stated is None or empty, and the certificate says so."""

    laboratory: Laboratory | None = None
    customer: Address | None = None
    item: Item | None = None
    equipment: tuple[Equipment, ...] = ()
    __pydantic_config__: ClassVar[dict[str, Any]] = _WHOLLY_KNOWN


def without_nothing(stated: Any) -> Any:
    """`stated`, of dicts and lists, without what is None or empty in it."""
    if isinstance(stated, Mapping):
        kept = {name: without_nothing(value) for name, value in stated.items()}
        return {name: value for name, value in kept.items() if value not in (None, {}, [])}
    return [without_nothing(one) for one in stated] if isinstance(stated, list | tuple) else stated


def certified(stated: Mapping[str, Any] | None) -> Certified:
    """The certificate of a reference as its record states it, which may hold more than a certificate's own words."""
    own = {f.name for f in fields(Certified)}
    return Certified(**{name: str(value) for name, value in (stated or {}).items() if name in own})
