"""Which function of a worker carries out which command: pairs that the type checker has seen."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.messages import Command

C = TypeVar("C", bound=Command[Any])
Handler = Callable[[Channel, Any], object]


def handles(command: type[C], do: Callable[[Channel, C], object]) -> tuple[type[Command[Any]], Handler]:
    """`do` carries out every `command`, and nothing else does."""
    return command, do
