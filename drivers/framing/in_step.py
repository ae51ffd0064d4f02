"""Whether a line is in step: answers that look like those to an earlier question, and to "who are you?"."""

from __future__ import annotations

import re

from labcal.bench.clock import Clock
from labcal.bench.links import Link, quoted
from labcal.bench.links.line import wait_for_quiet
from labcal.errors import InstrumentError

QUIET_S = 0.1  # of a line that was out of step, before each question: what is late or said twice has come by then
SIGN = re.compile(r"(?:^|(?<=[\sEe,]))[+-]")
NUMBER = re.compile(r"[+-]?\d+(\.\d*)?")
MAKER = re.compile(r"[A-Za-z][^,]*,")


class InStep:
    """What the answers on one line look like: one that fits another question and not its own is an earlier one's.

    From then on every question is asked into quiet, as `settle` is called before it. Commands never wait.
    """

    def __init__(self, name: str, link: Link, clock: Clock) -> None:
        self._name, self._link, self._clock, self._out = name, link, clock, False
        self._looks = dict[str, str]()  # of the last answer to each question

    def settle(self) -> None:
        """Before a question: nothing, or some quiet where the line was out of step."""
        if self._out:
            wait_for_quiet(self._link, self._clock, QUIET_S)

    def heard(self, question: str, reply: str) -> str:
        """A question was answered so; returns `reply`."""
        self._looks.setdefault(question, _look(reply))
        return reply

    def refuse_earlier(self, question: str, reply: str) -> None:
        """Raise InstrumentError (out of step) where `reply`, which is no answer to `question`, looks like another's."""
        if any(_look(reply) == look for other, look in self._looks.items() if other != question):
            raise self._earlier(question, reply)

    def refuse_number(self, question: str, reply: str) -> None:
        """The same where a number answers `question`, which asks for a name."""
        if NUMBER.fullmatch(reply):
            raise self._earlier(question, reply)

    def _earlier(self, question: str, reply: str) -> InstrumentError:
        self._out = True
        what = f"an answer of an earlier question came to {question!r}: {quoted(reply)}; the line is out of step."
        return InstrumentError(f"{self._name}: {what}", fault="out of step")

    def ask_again(self, reply: str) -> bool:
        """Whether `reply` to "who are you?" names nobody: then it is to be asked once more, into quiet."""
        if MAKER.match(reply):
            return False
        self._out = True  # its next question waits for quiet
        return True


def _look(reply: str) -> str:
    """An answer with all its digits alike, whatever signs its numbers have; other bytes that came with it stay."""
    return re.sub(r"\d", "0", SIGN.sub("", reply.strip(" \t\r\n")))
