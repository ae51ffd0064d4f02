"""Messages as lines of JSON, one a line: {"is": its class, "with": its fields, "id": the number of a request}."""

from __future__ import annotations

import json
from collections.abc import Mapping
from functools import cache
from typing import Any, TypeVar, get_args

from labcal.errors import InputError
from labcal.gui.ipc import messages
from labcal.gui.ipc.codec import decode, encode
from labcal.gui.ipc.messages import Command, Event, Request, StateRead, Word

R = TypeVar("R")
STATE = f'{{"is": "{StateRead.__name__}"'.encode()  # so begins the line of one


def answer_type(command: type[Command[R]]) -> Any:
    """What a command is answered with, as its class declares it."""
    return get_args(command.__orig_bases__[0])[0]  # type: ignore[attr-defined]  # Generic's own record


def read_answer(command: Command[R], said: Any) -> R:
    """The answer to `command`. Raises InputError where it is none."""
    answer: R = decode(answer_type(type(command)), said, f"the answer to {type(command).__name__}")
    return answer


def write_line(message: Request | Word | Event) -> str:
    """A message as one line of JSON, without its end."""
    if isinstance(message, Request):
        return json.dumps({"id": message.number} | _written(message.command))
    return json.dumps(_written(message))


def _written(message: object) -> dict[str, Any]:
    return {"is": type(message).__name__, "with": encode(message)}


def read_request(line: str) -> Request | Word:
    """What the window says in one line. Raises InputError where it is nothing that a worker knows."""
    said = _object(line)
    words = kinds(Word)
    if said["is"] in words:
        word: Word = decode(words[said["is"]], said.get("with", {}), said["is"])
        return word
    commands = kinds(Command)
    if said["is"] not in commands:
        raise InputError(f"no worker knows the message {said['is'][:40]!r}")
    if type(said.get("id")) is not int:
        raise InputError(f"the message {said['is']} bears no number that an answer could go to")
    return Request(said["id"], decode(commands[said["is"]], said.get("with", {}), said["is"]))


def read_event(line: bytes | str) -> Event:
    """What a worker says in one line. Raises InputError where it is nothing that the window knows."""
    said = _object(line)
    events = kinds(Event)
    if said["is"] not in events:
        raise InputError(f"the window knows no message {said['is'][:40]!r}")
    event: Event = decode(events[said["is"]], said.get("with", {}), said["is"])
    return event


def tells_state(line: bytes) -> bool:
    """Whether a worker says in it how the lab is, without reading it."""
    return line.startswith(STATE)


def number_in(line: str) -> int:
    """The number of a request that could not be read, where it bears one; else 0."""
    try:
        said = json.loads(line)
    except (ValueError, RecursionError):
        return 0
    number = said.get("id") if isinstance(said, dict) else None
    return number if type(number) is int else 0


@cache
def kinds(base: type) -> Mapping[str, type[Any]]:
    """Every command, word or event there is, by name."""
    there = ((name, one) for name, one in vars(messages).items() if isinstance(one, type))
    return {name: one for name, one in there if issubclass(one, base) and one is not base}


def _object(line: bytes | str) -> dict[str, Any]:
    try:
        said = json.loads(line)
    except (ValueError, RecursionError):
        raise InputError(f"a line between window and worker is not JSON: {line[:40]!r}") from None
    if not isinstance(said, dict) or not isinstance(said.get("is"), str):
        raise InputError(f"a line between window and worker is no message: {line[:40]!r}")
    return said
