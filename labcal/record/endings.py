"""How a run ended, in the words a person reads: "stopped" by somebody, or "broken off" by a fault or a crash.

The names of its states (`finished`, `stopped`, `interrupted`, `failed: why`) stay in the record and in every file: they
say what can be done with it, and one that somebody stopped in the window is `interrupted` there, to be gone on with.
"""

from __future__ import annotations

STOPPED, BROKEN_OFF = "stopped", "broken off"
STOPPED_BY = "stopped_by"  # in the data of the last read-back: that a person ended the run
BY_ABORT = "operator, by abort"  # there, where it was by COILS OFF in the window
BY_OFF = "stopped by COILS OFF"
BY_OPERATOR = "stopped by the operator"
NO_END = ("interrupted", "failed")  # states, or what begins them
BY_A_PERSON = (f": {BY_OPERATOR}", ": aborted by the operator")


def ended_words(status: str, *, stopped: bool = False) -> str:
    """A state with its reason, or the sentence that begins with it; `stopped`: the record says that a person did it.

    "interrupted by its store: why" becomes "broken off by its store: why".
    """
    for name in NO_END:
        rest = status.removeprefix(name)
        if rest == status or not (rest == "" or rest.startswith((":", " by "))):
            continue
        if rest.startswith(BY_A_PERSON):
            return BY_OPERATOR + rest.removeprefix(next(one for one in BY_A_PERSON if rest.startswith(one)))
        return STOPPED if stopped and not rest else f"{BROKEN_OFF}{rest}"
    return status


def ended_word(status: str, *, stopped: bool = False, by_off: bool = False) -> str:
    """The one word for it; `by_off`: the record says that it was by COILS OFF, which is said."""
    words = ended_words(status, stopped=stopped)
    if by_off and words.startswith(STOPPED):
        return BY_OFF
    return next((word for word in (STOPPED, BROKEN_OFF) if words.startswith(word)), status.partition(":")[0])
