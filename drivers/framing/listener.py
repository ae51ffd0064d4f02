"""An instrument that talks by itself and is only listened to."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, ClassVar, Protocol

import numpy as np
from numpy.typing import NDArray

from drivers.framing.mishaps import Mishaps
from labcal.bench.clock import Clock
from labcal.bench.driver_kit.roles import Identity
from labcal.bench.links import Link
from labcal.errors import InstrumentError
from labcal.record.stream import Block, Event

FIRST_S = 3.0
LOOKED_AT, SHOWN = 400, 60  # bytes of what came, where none of it is good
Pieces = Sequence[tuple[float, bytes]]
Array = NDArray[np.float64]


class Parser(Protocol):
    """Bytes in any cutting, into blocks of what is good in them; the rest is noted in its mishaps."""

    def feed(self, pieces: Pieces) -> list[Block]:
        """The blocks that these pieces complete."""
        ...


class BeginsParser(Protocol):
    """The class of a parser: one is made for each stream that begins."""

    def __call__(self, source: str, settings: Any, mishaps: Mishaps, /) -> Parser:
        """A parser of what `source` sends, as its settings say; what is no good is noted in `mishaps`."""
        ...


def values_again(parser: Parser, pieces: Pieces) -> Array:
    """The samples (n, k) that a parser which begins anew finds in the frames of a record; housekeeping is left out."""
    found = [block.values for block in parser.feed(pieces) if block.raw]
    return np.vstack(found) if found else np.zeros((0, 0))


class Listener:
    """The methods of a magnetometer that needs no command. `begin` makes a parser for a stream that begins now.

    It has no name of its own: `who` is what bench.toml states, answered once a first sample has come.
    """

    never = (rb".",)  # nothing is ever sent
    first_s = FIRST_S  # within which one good sample comes

    def __init__(self, name: str, link: Link, clock: Clock, who: Identity, begin: Callable[[Mishaps], Parser]) -> None:
        self.name, self._link, self._clock, self._who, self._begin = name, link, clock, who, begin
        self._mishaps = Mishaps(name)
        self._parser = begin(self._mishaps)

    def identify(self) -> Identity:
        """Wait for one good sample. Raises InstrumentError (silent) with the last that came."""
        parser, last = self._begin(Mishaps(self.name)), b""
        deadline = self._clock.now() + self.first_s
        while self._clock.now() < deadline:
            pieces = self._link.receive(self._clock.now() + 0.05)
            last = (last + b"".join(data for _, data in pieces))[-LOOKED_AT:]
            if parser.feed(pieces):
                return self._who
        raise InstrumentError(
            f"{self.name}: no good sample in {self.first_s:g} s; what came ends with {last[-SHOWN:]!r}.{self.why(last)}"
            if last
            else f"{self.name}: nothing came in {self.first_s:g} s.",
            fault="silent",
            remedy="Is it powered and sending? Do the settings in bench.toml fit what it sends?",
        )

    def why(self, came: bytes) -> str:
        """What the last bytes that came say of why none was good, a sentence after a blank; "" where nothing."""
        return ""

    def start(self) -> None:
        """Begin: what arrived before is dropped."""
        self._link.flush()
        self._mishaps = Mishaps(self.name)
        self._parser = self._begin(self._mishaps)

    @property
    def spoilt(self) -> int:
        """How many messages came since `start` that were no good."""
        return self._mishaps.total.total()

    def read_until(self, t_s: float) -> list[Block]:
        """What arrived up to `t_s`."""
        return self._parser.feed(self._link.receive(t_s))

    def events(self) -> list[Event]:
        """What was lost or no good since this was asked last."""
        return self._mishaps.events()

    def stop(self) -> None:
        """Stop listening; the instrument goes on."""

    def make_safe(self) -> None:
        """A listener has nothing to make safe."""

    def close(self) -> None:
        """Let go of the link."""
        self._link.close()


class ParsedListener(Listener):
    """A listener whose bytes the class `parser` reads, now and again from a record.

    `before` is put before what is read again: a parser of lines drops the first, which may have been cut.
    """

    parser: ClassVar[BeginsParser]
    before: ClassVar[bytes] = b"\n"

    def __init__(self, name: str, link: Link, clock: Clock, settings: Any, who: Identity) -> None:
        self.settings = settings
        super().__init__(name, link, clock, who, lambda mishaps: self.parser(name, settings, mishaps))

    @classmethod
    def parse_again(cls, settings: Any, raw: bytes) -> Array:
        """The samples (n, k) of frames as a record keeps them, by the parser that read them."""
        return values_again(cls.parser("", settings, Mishaps("")), [(0.0, cls.before + raw)])
