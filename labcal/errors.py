"""What can go wrong, by whose turn it is: the person's (exit 2), the instrument's (3), the operator's (130)."""

from __future__ import annotations

WHAT_TO_DO = {  # as a rule; who raises knows better where it says so
    "another instrument": "Is this the instrument that bench.toml names, and is its link the right one?",
    "link lost": "Plug it in, see that nobody else has opened it, then try again.",
    "out of step": "Is it slower than its timeout_s, does another program talk on its line? Try again.",
    "wrong reply": "Is this the instrument that bench.toml names? Look at its cable, then try again.",
    "refused": "Look at its panel, then try again.",
    "read-back": "Look at its panel, then try again.",
    "not arrived": "Look for what holds it, home it and try again.",
    "stage fault": "Look at the stage, home it and try again.",
}


class InputError(ValueError):
    """The request or the input is wrong; the message is one clear sentence for the person who sent it.

    `file`, `line` (from 1) and `column` (a name, or a number from 1) say where, so far as there is a where.
    """

    def __init__(
        self, what: str, *, file: object = None, line: int | None = None, column: str | int | None = None
    ) -> None:
        self.what, self.file, self.line, self.column = what, file, line, column
        place = [str(file)] if file is not None else []
        place += [f"line {line}"] if line is not None else []
        place += [f"column {column}"] if column is not None else []
        super().__init__(f"{', '.join(place)}: {what}" if place else what)


class OutOfControl(InputError):
    """The check standard keeps a run from beginning: `words` say why, `how` what to type to answer for it."""

    remedy = "No procedure begins on this bench: measure the check standard again, or let a person answer for it."

    def __init__(self, words: str, how: str, *, file: object = None) -> None:
        self.words = words
        super().__init__(f"{words}. {how}", file=file)


class InstrumentError(RuntimeError):
    """An instrument failed: what happened and what to do. How the coils are, whoever shows it says from a reading.

    `fault` is the named fault state ("silent", "overloaded", "stuck", "wrong mode", "tripped", "link lost" …); where no
    `remedy` is stated, it has that of its fault in `WHAT_TO_DO`. `mends`: what only who mends labcal can do about it.
    """

    def __init__(self, what: str, *, fault: str = "failed", remedy: str = "", mends: str = "") -> None:
        self.what, self.fault, self.remedy = what, fault, remedy or WHAT_TO_DO.get(fault, "")
        self.mends = mends
        super().__init__(" ".join(filter(None, (what, self.remedy, mends))))


class LimitError(InstrumentError):
    """A set-point beyond a limit was refused; nothing was sent. The message carries both numbers.

    No instrument failed: what was asked for is wrong (exit 2).
    """


class LimitNotMet(Exception):
    """Work that ended with a negative result: the message names the measurement, its value and its limit (exit 1)."""


class Stopped(Exception):
    """The operator stopped the work."""


def words_of_system(error: OSError) -> str:
    """What the system says of a call that failed, after the file that it was about where it names one."""
    said = error.strerror or str(error)
    return f"{error.filename}: {said}" if error.filename else f"a call of the system failed: {said}"
