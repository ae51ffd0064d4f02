"""The connection to the server: short patience, and faults as one sentence without a password."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

from sqlalchemy import Connection, Engine, create_engine
from sqlalchemy.engine import URL
from sqlalchemy.exc import DBAPIError, OperationalError, SQLAlchemyError

from labcal.archive.address import ServerAddress
from labcal.errors import InputError

CONNECT_S, STATEMENT_S, SILENT_S = 5, 60, 20
NO_RIGHT, UNKNOWN = ("42501",), ("3F000", "42P01")  # SQLSTATE: insufficient privilege; no such schema, no such table
NOT_SET_UP = "there is no archive here that this role can see: its owner makes it by `labcal archive init`"
LATER = "nothing is lost: what is not there yet goes there with the next push"
RIGHTS = "rights are given by the archive's owner: `labcal archive grant` (docs/archive.md)"


class AwayError(InputError):
    """The server cannot be reached, or went away: what was begun is not there, and asking again later goes on."""


@dataclass(frozen=True, slots=True)
class Archive:
    """An archive's server. Every use of it is one transaction: whole, or not there."""

    address: ServerAddress
    engine: Engine

    @contextmanager
    def transaction(self) -> Iterator[Connection]:
        """A transaction, committed at its end. Raises AwayError, InputError."""
        with _named_faults(self.address), self.engine.begin() as connection:
            yield connection


@contextmanager
def opened(address: ServerAddress) -> Iterator[Archive]:
    """The archive at `address`; nothing is asked of the server yet."""
    keep = {"connect_timeout": CONNECT_S, "tcp_user_timeout": SILENT_S * 1000, "application_name": "labcal"}
    keep["options"] = f"-c statement_timeout={STATEMENT_S}s -c TimeZone=UTC"
    url = URL.create("postgresql+psycopg", address.user, address.password, address.host, address.port, address.database)
    engine = create_engine(url, connect_args=keep | dict(address.settings), pool_pre_ping=True, hide_parameters=True)
    try:
        yield Archive(address, engine)
    finally:
        engine.dispose()


@contextmanager
def _named_faults(address: ServerAddress) -> Iterator[None]:
    try:
        yield
    except DBAPIError as error:
        raise _fault(error, address) from None
    except SQLAlchemyError as error:
        message = address.without_secrets(str(error).splitlines()[0])
        raise InputError(f"{address.shown}: {message}") from None


def _fault(error: DBAPIError, address: ServerAddress) -> InputError:
    state = getattr(error.orig, "sqlstate", None)
    message = " ".join(address.without_secrets(str(error.orig)).split())
    if state in NO_RIGHT:
        return InputError(f"{address.shown}: {message}; {RIGHTS}")
    if state in UNKNOWN:
        return InputError(f"{address.shown}: {NOT_SET_UP}")
    if isinstance(error, OperationalError) or error.connection_invalidated:
        return AwayError(f"{address.shown}: the archive cannot be reached: {message}; {LATER}")
    return InputError(f"{address.shown}: the archive refused it: {message}")
