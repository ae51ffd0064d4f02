"""The kinds of messages between the window and its workers: `messages` holds every one of them."""

from __future__ import annotations

from typing import Generic, TypeVar

R = TypeVar("R")


class Command(Generic[R]):
    """Something asked of a worker; R is what it answers."""

    __slots__ = ()


class Word:
    """A word into a run that goes on; nothing answers it."""

    __slots__ = ()


class Event:
    """What a worker says."""

    __slots__ = ()
