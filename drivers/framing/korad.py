"""How a Korad is spoken to: nothing ends a message, it is deaf while it is busy, and it never says that it was."""

from __future__ import annotations

from dataclasses import dataclass, field

from drivers.framing.in_step import InStep
from labcal.bench.clock import Clock
from labcal.bench.links import Link
from labcal.bench.links.line import LONGEST, babbles
from labcal.errors import InstrumentError

QUIET_S = 0.05  # a reply of unknown length has ended when nothing more came for so long
OWED_S = 0.3  # after its question an answer that was given up is not waited for any longer
LONG_AGO = -1e9


@dataclass
class Conversation:
    """`gap_s`: the least pause between two messages. A question that nothing answers is put once more."""

    name: str
    link: Link
    clock: Clock
    terminator: str
    gap_s: float
    timeout_s: float
    _free_s: float = field(default=0.0, init=False)
    _owed_until_s: float = field(default=LONG_AGO, init=False)

    def __post_init__(self) -> None:
        self.in_step = InStep(self.name, self.link, self.clock)

    def command(self, text: str) -> None:
        """Tell, once it is ready to hear; what was left on the line is dropped."""
        self.clock.wait_until(self._free_s)
        self.link.flush()
        self.link.send((text + self.terminator).encode())
        self._free_s = self.clock.now() + self.gap_s

    def answer(self, question: str, length: int) -> str:
        """So many characters of its answer, whatever strays in after them."""
        reply = self._first(question)
        if length > 1:
            reply += self.link.ask(b"", end=length - 1, timeout_s=self.timeout_s)
        self._owed_until_s = LONG_AGO
        return self.in_step.heard(question, reply.decode("latin-1"))

    def words(self, question: str) -> str:
        """Its answer until the line is quiet. Raises InstrumentError (babbles) where that has no end."""
        reply = self._first(question)
        while pieces := self.link.receive(self.clock.now() + QUIET_S):
            reply += b"".join(piece for _, piece in pieces)
            if len(reply) > LONGEST:
                raise babbles(self.link.url, reply)
        self._owed_until_s = LONG_AGO
        return _once(reply.decode("latin-1").strip("\0\r\n "))

    def _first(self, question: str) -> bytes:
        """The first byte of its answer. Raises InstrumentError (silent) where it was asked twice and nothing came."""
        try:
            return self._asked(question)
        except InstrumentError as error:
            if error.fault != "silent":
                raise
        return self._asked(question)

    def _asked(self, question: str) -> bytes:
        self._drop_owed()
        self.in_step.settle()
        self.command(question)
        self._owed_until_s = self.clock.now() + OWED_S
        return self.link.ask(b"", end=1, timeout_s=self.timeout_s)

    def _drop_owed(self) -> None:
        """Drop the answer to the question before, if that was given up and it comes yet."""
        came = False
        while (left_s := self._owed_until_s - self.clock.now()) > 0:
            pieces = self.link.receive(self.clock.now() + min(left_s, QUIET_S))
            if came and not pieces:
                return
            came = bool(pieces)


def _once(words: str) -> str:
    """An answer that came twice is one: no name is its own first half again."""
    half = words[: len(words) // 2]
    return half if words == 2 * half else words
