"""The door of a run that has lost its window: a window comes back by it, or whoever watched sends the run to its end.

A socket on loopback; how it is reached stands in a card in labcal's folder that only its user may read.
"""

from __future__ import annotations

import hmac
import json
import os
import secrets
import socket
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

from labcal.files.atomic import write_bytes
from labcal.files.home import FILE, home, own_folder

FOLDER = "runs-going-on"
SAYS_S = 2.0  # who came has so long to say who it is
LINE = 4096  # characters, at most, of what it says first


@dataclass(frozen=True, slots=True)
class Caller:
    """A window that came back: what it says, and where it is answered."""

    says: TextIO
    hears: TextIO

    def close(self) -> None:
        """It is gone."""
        for line in (self.says, self.hears):
            with suppress(OSError):  # what it no longer hears
                line.close()


class Door:
    """Listens from when it is made until `close`; nobody is let in before `wait` is called."""

    def __init__(self) -> None:
        self._token = secrets.token_hex(16)
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._card = _card(os.getpid())
        own_folder(own_folder(home()) / FOLDER)
        invitation = {"port": self._listener.getsockname()[1], "token": self._token}
        write_bytes(self._card, json.dumps(invitation).encode(), FILE)

    def wait(self, seconds: float) -> Caller | None:
        """The next window that comes; None where none does, or where the run is sent to its end."""
        until = time.monotonic() + seconds
        while (left_s := until - time.monotonic()) > 0:
            try:
                self._listener.settimeout(left_s)
                connection, _ = self._listener.accept()
            except OSError:
                return None
            with connection, suppress(OSError, ValueError, KeyError, TypeError):  # the caller's files keep it open
                caller, goes_on = self._heard(connection)
                if not goes_on:
                    caller.close()
                return caller if goes_on else None
        return None

    def _heard(self, connection: socket.socket) -> tuple[Caller, bool]:
        """Who came, and whether the run is to go on. Raises where it does not know the token."""
        connection.settimeout(SAYS_S)
        caller = Caller(connection.makefile("r", encoding="utf-8"), connection.makefile("w", encoding="utf-8"))
        try:
            first = json.loads(caller.says.readline(LINE))
            if not hmac.compare_digest(str(first["token"]).encode(), self._token.encode()):
                raise ValueError("another token")
            goes_on = first["goes_on"] is True
        except BaseException:
            caller.close()
            raise
        connection.settimeout(None)
        return caller, goes_on

    def close(self) -> None:
        """Nobody comes any more."""
        self._listener.close()
        self._card.unlink(missing_ok=True)


def knock(worker: int, *, goes_on: bool = True) -> socket.socket:
    """A connection to the run of the process `worker`. Raises OSError where none goes on there."""
    card = _read(worker)
    connection = socket.create_connection(("127.0.0.1", card["port"]), SAYS_S)
    connection.sendall((json.dumps({"token": card["token"], "goes_on": goes_on}) + "\n").encode())
    connection.settimeout(None)
    return connection


def goes_on_at(worker: int) -> bool:
    """Whether a run may be come back to there."""
    with suppress(OSError):
        return bool(_read(worker))
    return False


def send_to_its_end(worker: int) -> None:
    """No window comes any more: the coils go to zero at once, and the run may be gone on with later."""
    with suppress(OSError):
        knock(worker, goes_on=False).close()


def _card(worker: int) -> Path:
    return home() / FOLDER / f"{worker}.json"


def _read(worker: int) -> dict[str, Any]:
    """The card. Raises OSError where there is none that can be read."""
    try:
        said = json.loads(_card(worker).read_text(encoding="utf-8"))
        return {"port": int(said["port"]), "token": str(said["token"])}
    except (ValueError, KeyError, TypeError) as error:
        raise FileNotFoundError("no card of a run") from error
