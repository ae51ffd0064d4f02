"""How session and guardian speak: JSON lines over a socket that only this user, or its group, can reach."""

from __future__ import annotations

import hashlib
import json
import os
import socket
import struct
import sys
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from labcal.bench.coils.at_zero import AtZero
from labcal.bench.links.places import belongs, runtime_folder, user
from labcal.errors import InstrumentError, LimitError
from labcal.files.atomic import absolute

Message = dict[str, Any]
Card = dict[str, Any]  # pid, address, token: how a guardian is reached
TRIED_AGAIN = "It is tried again and again; no run begins before it answers."
ACKNOWLEDGES = "acknowledges"  # in the card of one that says at once that it has heard an order, where it is asked to
OTHER_BENCH = "another bench"  # a guardian that has read another file makes room as soon as it may


def listen() -> tuple[socket.socket, Card]:
    """A socket for sessions and the card that says how to reach it: Unix, or loopback with a token.

    A Unix socket has the mode 0600, in the folder of a group 0660.
    """
    card: Card = {"pid": os.getpid(), "token": os.urandom(16).hex(), ACKNOWLEDGES: True}
    if sys.platform == "win32":
        listener = socket.create_server(("127.0.0.1", 0))
        return listener, card | {"address": listener.getsockname()[1]}
    path = runtime_folder() / f"guardian-{os.getpid()}-{os.urandom(4).hex()}.sock"  # a dead one's may lie there yet
    _sweep(path.parent)
    listener = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    unheard = path.with_suffix(".new")  # until somebody listens it is not found, nor swept away
    listener.bind(str(unheard))
    belongs(unheard)
    listener.listen(64)
    unheard.rename(path)
    return listener, card | {"address": str(path)}


def connect(card: Card, timeout_s: float) -> socket.socket:
    """A connection to the guardian of this card. Raises OSError where it is gone, or the card is none."""
    if sys.platform == "win32":
        return socket.create_connection(("127.0.0.1", card["address"]), timeout_s)
    if not isinstance(card["address"], str) or "\0" in card["address"]:  # a group's folder holds what anybody wrote
        raise FileNotFoundError("no socket of a guardian")
    connection = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    connection.settimeout(timeout_s)
    try:
        connection.connect(card["address"])
    except OSError:
        connection.close()
        raise
    return connection


def peer(connection: socket.socket) -> int | None:
    """The number of the user at the other end, by the kernel's word; None where it tells none."""
    return _credentials(connection)[1]


def peer_process(connection: socket.socket) -> int | None:
    """The process that listens at the other end, by the kernel's word; None where it tells none."""
    return _credentials(connection)[0]


def _credentials(connection: socket.socket) -> tuple[int | None, int | None]:
    if sys.platform != "linux" or connection.family != socket.AF_UNIX:
        return None, None
    said = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, struct.calcsize("3i"))
    pid, uid, _ = struct.unpack("3i", said)
    return int(pid), int(uid)


def another_user(uid: int | None) -> bool:
    """Whether this is somebody else than the user of this process."""
    return uid is not None and uid != user()


def _sweep(folder: Path) -> None:
    """Take away the sockets on which nobody listens any more; whoever was killed left his."""
    for path in folder.glob("guardian-*.sock"):
        try:
            connect({"address": str(path)}, 0.1).close()
        except ConnectionRefusedError:
            with suppress(OSError):
                path.unlink()
        except OSError:
            pass


def unlisten(listener: socket.socket, card: Card) -> None:
    """Close the socket and take its name away."""
    with suppress(OSError):
        listener.shutdown(socket.SHUT_RDWR)  # whoever waits in accept() hears it
    listener.close()
    if isinstance(card["address"], str):
        with suppress(OSError):
            Path(card["address"]).unlink()


def still_there(card: Card) -> bool:
    """Whether the socket of this card can be found by its name."""
    return not isinstance(card["address"], str) or os.path.exists(card["address"])


def packed(message: Mapping[str, Any]) -> bytes:
    """One message as a line."""
    return json.dumps(message).encode() + b"\n"


def fingerprint(bench: Path) -> str:
    """SHA-256 of a bench file: guardian and session must have read the same."""
    return hashlib.sha256(bench.read_bytes()).hexdigest()


def fault_message(fault: InstrumentError) -> Message:
    """An error as it goes over the socket."""
    kind = "limit" if isinstance(fault, LimitError) else "instrument"
    return {"kind": kind, "what": fault.what, "fault": fault.fault, "remedy": fault.remedy, "mends": fault.mends}


def fault_of(message: Message) -> InstrumentError:
    """The error that came over the socket."""
    kind = LimitError if message["kind"] == "limit" else InstrumentError
    return kind(message["what"], fault=message["fault"], remedy=message["remedy"], mends=message.get("mends", ""))


def zero_message(end: AtZero) -> Message:
    """How an axis ended, as it goes over the socket."""
    fault = None if end.fault is None else fault_message(end.fault)
    said = {"axis": end.axis, "current_A": end.current_A, "opened": end.opened, "fault": fault}
    times = {"read_s": end.read_s, "asked_s": end.asked_s}  # the monotonic clock is one for all processes of a computer
    return said | times | {"from_A": end.from_A}


def is_of(bench: Path, card: Card) -> bool:
    """Whether that is the card of a guardian of this bench file."""
    return bool({str(absolute(bench)), os.path.abspath(bench)} & {card.get("bench"), card.get("named")})


def zero_of(message: Message) -> AtZero:
    """How an axis ended, as it came over the socket."""
    fault = None if message["fault"] is None else fault_of(message["fault"])
    times = message.get("read_s"), message.get("from_A", 0.0), message.get("asked_s")
    return AtZero(message["axis"], message["current_A"], message["opened"], fault, *times)
