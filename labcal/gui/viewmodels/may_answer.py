"""What of a question may be answered now: one rule for its buttons, their keys, what is typed or scanned, and Next."""

from __future__ import annotations

from labcal.gui.viewmodels.hands import RETRY, STOP, says_hands_off
from labcal.record.stream import Prompt

REMOUNT = "remount"


def acting(prompt: Prompt, choice: str) -> bool:
    """Whether this answer mounts, energises, moves or switches something, or sends somebody to do so."""
    return prompt.acts or choice == RETRY


def moves_by_itself(prompt: Prompt, choice: str) -> bool:
    """Whether the lab energises or turns something once this is answered: held, by mouse as well."""
    return choice == RETRY or says_hands_off(prompt.key, choice)


def wanted(prompt: Prompt) -> str:
    """The answer that goes on; where something failed a script stops, as the first choice says. "": it is in words."""
    instead = prompt.choices[0] if prompt.choices else ""
    return next((one for one in prompt.choices if one in (RETRY, REMOUNT)), instead)


def may_answer(prompt: Prompt, choice: str, *, lost: bool, waits: bool) -> bool:
    """Nothing is energised or turned while an instrument is `lost`, and nothing was done while hands are kept out.

    `waits`: they are, as `kept_out` says. The end of the run may be wanted at any moment.
    """
    return choice == STOP or not (waits or (lost and moves_by_itself(prompt, choice)))
