"""A number of an instrument as a declaration: how it is asked for and set, in which unit, within which limits."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, Protocol, Self, overload

from labcal.bench.links.quoting import quoted
from labcal.errors import InstrumentError, LimitError

DECIMAL = re.compile(r"[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?", re.ASCII)
NO_NUMBER = 9.9e37  # how SCPI writes infinity; 9.91E37 is its "not a number"


def decimal(reply: str) -> float:
    """The number that `reply` is. Raises ValueError for all else: nan, inf, 1_000, a number that means neither."""
    if not DECIMAL.fullmatch(reply) or not abs(value := float(reply)) < NO_NUMBER:
        raise ValueError(reply)
    return value


class Speaks(Protocol):
    """What a declared quantity needs of its instrument.

    Where it has `refuse_earlier(question, reply)`, that is called with a reply that is no answer to the question: it
    raises InstrumentError (out of step) where it knows it for the answer to an earlier one.
    """

    name: str
    settings: Any

    def query(self, text: str) -> str:
        """Ask and return the reply, without line ends."""
        ...

    def command(self, text: str) -> None:
        """Tell, and raise InstrumentError where the instrument did not accept it."""
        ...

    def write(self, text: str) -> None:
        """Put it on the line and wait for nothing. Only what is used on the way to zero needs it."""
        ...


class quantity:
    """A number in `unit`. In `get` and `set`, {s.…} are the instrument's settings, {value} is the number
    and {on} is ON or OFF.

    Setting beyond `limits` (a function of the settings) raises LimitError and sends nothing; after every set the
    instrument is asked what it holds, and another value than that within `tolerance` raises InstrumentError.
    """

    def __init__(
        self,
        get: str,
        set: str = "",
        *,
        unit: str,
        doc: str,
        limits: Callable[[Any], tuple[float, float]] | None = None,
        tolerance: float = 0.0,
        read: Callable[[str], float] = decimal,
    ) -> None:
        self.get, self.set, self.unit, self.limits = get, set, unit, limits
        self.tolerance, self.read, self.__doc__, self.label = tolerance, read, doc, ""

    def __set_name__(self, owner: type, name: str) -> None:
        self.label = name.replace("_", " ")

    @overload
    def __get__(self, device: None, owner: type | None = None) -> Self: ...
    @overload
    def __get__(self, device: object, owner: type | None = None) -> float: ...
    def __get__(self, device: Any, owner: type | None = None) -> Self | float:
        return self if device is None else self._ask(device)

    def __set__(self, device: Any, value: float) -> None:
        self._refuse_beyond_limits(device, value)
        self._command(device, value)
        held = self._ask(device)
        if not self._agrees(device, value, held):
            raise InstrumentError(
                f"{device.name}: {self.label} was set to {self._amount(value)} and reads back {self._amount(held)}.",
                fault="read-back",
                remedy="Look at the instrument's panel.",
            )

    def _amount(self, value: float) -> str:
        return f"{value:g}" if self.unit == "1" else f"{value:g} {self.unit}"

    def write(self, device: Any, value: float) -> None:
        """Send the value and ask nothing: whether it was heard is seen when it is read back. Raises LimitError."""
        self._refuse_beyond_limits(device, value)
        self._send(device, value)

    def _ask(self, device: Speaks) -> float:
        reply = device.query(question := self.get.format(s=device.settings))
        try:
            return self.read(reply)
        except (ValueError, LookupError) as error:
            getattr(device, "refuse_earlier", _let_pass)(question, reply)
            raise InstrumentError(
                f"{device.name}: {self.label} came back as {quoted(reply)}.", fault="wrong reply"
            ) from error

    def _command(self, device: Speaks, value: float) -> None:
        device.command(self._message(device, value))

    def _send(self, device: Speaks, value: float) -> None:
        device.write(self._message(device, value))

    def _message(self, device: Speaks, value: float) -> str:
        return self.set.format(s=device.settings, value=value, on="ON" if value else "OFF")

    def _agrees(self, device: Speaks, value: float, held: float) -> bool:
        return abs(held - value) <= self.tolerance

    def _refuse_beyond_limits(self, device: Speaks, value: float) -> None:
        low, high = self.limits(device.settings) if self.limits else (float("-inf"), float("inf"))
        if not low <= value <= high:
            end = high if value > high else low
            raise LimitError(
                f"{device.name}: {self.label} {self._amount(value)} is beyond its limit of {self._amount(end)}; "
                "nothing was sent."
            )


def _let_pass(question: str, reply: str) -> None:
    """Of an instrument that does not know its earlier answers."""


def after(prefix: str, ends: str = "") -> Callable[[str], float]:
    """A reader of replies such as `I1 0.5000` or `0.499A`: drops the echoed word and the unit."""

    def read(reply: str) -> float:
        if not reply.startswith(prefix):
            raise ValueError(reply)
        if not reply.endswith(ends):
            raise ValueError(reply)
        return decimal(reply.removeprefix(prefix).removesuffix(ends).strip(" "))

    return read
