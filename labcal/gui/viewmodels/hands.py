"""Hands in the lab: which question brings them there, and which answer says that they are off. No widgets."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.translations.translate import spoken, translated
from labcal.gui.viewmodels.failed_step import NO_ANSWER, WHAT
from labcal.record.stream import Prompt

READY, DONE = "ready", "done"  # the question whether all hands are off, and the answer that says so
FAILED, RETRY = "failed-", "retry"  # about a step that failed, and "Hands off: try again"
STOP = "stop"  # the answer that ends the run
NEXT_IS = QT_TRANSLATE_NOOP("Words", "Next: {0}")
STILL_LOST = "Still lost"  # so it begins where it is asked again, because somebody does not answer


def coming(prompt: Prompt, words: str) -> str:
    """The `words` of a question as what is to come: before its answer neither a field nor a turn is there yet."""
    states = prompt.text.removesuffix("Hands off?").rstrip().endswith(".") and not prompt.text.startswith("Next ")
    ahead = prompt.key == READY and states
    return translated(str(NEXT_IS)).format(_after_colon(words)) if ahead else words


def _after_colon(words: str) -> str:
    """A sentence goes on with a small letter there, but in German and where a name stands first."""
    small = spoken() != "de" and (words[1:2].islower() or words[1:2].isspace())
    return words[:1].lower() + words[1:] if small else words


def says_hands_off(key: str, answer: object) -> bool:
    """Whether whoever answers the question `key` so stands back, until anything else is asked."""
    return (key == READY and answer == DONE) or (key.startswith(FAILED) and answer == RETRY)


def reached_into(prompt: Prompt, *, lost: bool) -> bool:
    """Whether what is asked brings hands to the lab: to mount or switch, or to the plug of what does not answer.

    `lost`: somebody does not, whatever is asked.
    """
    mends = bool({NO_ANSWER, WHAT} & set(prompt.drawing)) or prompt.text.startswith(STILL_LOST)
    return mends or (lost if prompt.key == READY else prompt.acts)
