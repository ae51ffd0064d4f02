"""How session and guardian speak: JSON lines over a socket that only this user can reach."""

from __future__ import annotations

import hashlib
import json
import os
import secrets
import socket
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from labcal.bench.at_zero import AtZero
from labcal.bench.links.ports import runtime_folder
from labcal.errors import InstrumentError, LimitError

Message = dict[str, Any]
Card = dict[str, Any]  # pid, address, token: how a guardian is reached
OTHER_BENCH = "another bench"  # a guardian that has read another file makes room as soon as it may


def listen() -> tuple[socket.socket, Card]:
    """A socket for sessions and the card that says how to reach it: Unix with mode 0600, or loopback with a token."""
    card: Card = {"pid": os.getpid(), "token": secrets.token_hex(16)}
    if sys.platform == "win32":
        listener = socket.create_server(("127.0.0.1", 0))
        return listener, card | {"address": listener.getsockname()[1]}
    path = runtime_folder() / f"guardian-{os.getpid()}.sock"
    path.unlink(missing_ok=True)
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    listener.bind(str(path))
    path.chmod(0o600)
    listener.listen(64)
    return listener, card | {"address": str(path)}


def connect(card: Card, timeout_s: float) -> socket.socket:
    """A connection to the guardian of this card. Raises OSError where it is gone."""
    if isinstance(card["address"], int):
        return socket.create_connection(("127.0.0.1", card["address"]), timeout_s)
    if sys.platform == "win32":
        raise OSError("no Unix sockets here")
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    connection.settimeout(timeout_s)
    try:
        connection.connect(card["address"])
    except OSError:
        connection.close()
        raise
    return connection


def unlisten(listener: socket.socket, card: Card) -> None:
    """Close the socket and take its name away."""
    with suppress(OSError):
        listener.shutdown(socket.SHUT_RDWR)  # whoever waits in accept() is told
    listener.close()
    if isinstance(card["address"], str):
        with suppress(OSError):
            Path(card["address"]).unlink()


def packed(message: Mapping[str, Any]) -> bytes:
    """One message as a line."""
    return json.dumps(message).encode() + b"\n"


def fingerprint(bench: Path) -> str:
    """SHA-256 of a bench file: guardian and session must have read the same."""
    return hashlib.sha256(bench.read_bytes()).hexdigest()


def fault_message(fault: InstrumentError) -> Message:
    """An error as it goes over the socket."""
    kind = "limit" if isinstance(fault, LimitError) else "instrument"
    return {"kind": kind, "what": fault.what, "fault": fault.fault, "remedy": fault.remedy}


def fault_of(message: Message) -> InstrumentError:
    """The error that came over the socket."""
    kind = LimitError if message["kind"] == "limit" else InstrumentError
    return kind(message["what"], fault=message["fault"], remedy=message["remedy"])


def zero_message(end: AtZero) -> Message:
    """How an axis ended, as it goes over the socket."""
    fault = None if end.fault is None else fault_message(end.fault)
    return {"axis": end.axis, "current_A": end.current_A, "opened": end.opened, "fault": fault}


def zero_of(message: Message) -> AtZero:
    """How an axis ended, as it came over the socket."""
    fault = None if message["fault"] is None else fault_of(message["fault"])
    return AtZero(message["axis"], message["current_A"], message["opened"], fault)
