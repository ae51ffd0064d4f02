"""What a window asks and says of whom a certificate names, and what of it is handed out."""

from __future__ import annotations

from dataclasses import dataclass

from labcal.gui.ipc.kinds import Command


@dataclass(frozen=True, slots=True)
class Party:
    """The laboratory or the customer as a person states them: name, city, and the two letters of a country."""

    name: str
    city: str
    country: str


@dataclass(frozen=True, slots=True)
class Named:
    """Whom a certificate names, each on one line; "" for whom nobody has stated."""

    laboratory: str
    customer: str


@dataclass(frozen=True, slots=True)
class WhoIsNamed(Command[Named]):
    """Whom the certificate of the calibration at `path` names."""

    path: str


@dataclass(frozen=True, slots=True)
class StateNames(Command[Named]):
    """Name whom nobody has stated yet on the certificate of `path`; the laboratory on all certificates from here."""

    path: str
    laboratory: Party | None
    customer: Party | None


@dataclass(frozen=True, slots=True)
class HandOut(Command[str]):
    """Everything that goes to the customer, into one folder; answers it."""

    path: str
    folder: str
