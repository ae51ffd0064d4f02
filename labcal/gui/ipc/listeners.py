"""Answers for a page that is gone: the window was made anew in another language while they were under way."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, TypeVar

from PySide6.QtCore import QObject
from shiboken6 import isValid

R = TypeVar("R")


def while_there(listener: Callable[[R], object]) -> Callable[[R], object]:
    """`listener`, which hears nothing any more once Qt has deleted whom it speaks for."""

    def hear(said: R) -> object:
        return listener(said) if all(map(isValid, speaks_for(listener))) else None

    return hear


def speaks_for(listener: Any) -> Iterator[QObject]:
    """The objects of Qt that a method, a partial or a function within a method was made for."""
    if isinstance(listener, partial):
        yield from (one for one in listener.args if isinstance(one, QObject))
        yield from speaks_for(listener.func)
    elif isinstance(owner := getattr(listener, "__self__", None), QObject):
        yield owner
    for cell in getattr(listener, "__closure__", None) or ():
        held = cell.cell_contents
        if isinstance(held, QObject):
            yield held
        elif callable(held) and held is not listener:
            yield from speaks_for(held)
