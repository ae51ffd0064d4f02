"""What stands on the button of an answer to a question, in the window's language."""

from __future__ import annotations

import re

from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.hands import READY
from labcal.record.stream import Prompt

MOUNTING = "body_from_cage"  # in a prompt's drawing: how the DUT is to stand
ASKED = {  # by what the question draws or, where it draws nothing, by its key: what has been done by who answers
    MOUNTING: "Mounted",
    "reference_m": "Placed",
    "reference_turned": "Placed",
    "dut_away": "Taken away",
    "half": "Leads swapped",
    "mode": "Switched",
    "load": "Switched",
    "motor-off": "Switched off",
    "motor-on": "Switched on",
    "warm": "Warmed",
    READY: "Hands off: begin",
}
WORDS = {
    "done": "Done",
    "yes": "Yes",
    "no": "No",
    "stop": "Stop the run",
    "retry": "Hands off: try again",
    "remount": "Mount it again",
    "skip": "Skip this step",
    "send": "Send",
}


def unbroken(text: str) -> str:
    """`text` with each number on the line of its unit."""
    return re.sub(r"(?<=\d) (?=[µnm]?[TAKms°]\b|°)", "\N{NO-BREAK SPACE}", text)


def answer_label(prompt: Prompt, choice: str) -> str:
    """What stands on the button of an answer: what it says has been done, or is to be done."""
    redo, _, axis = choice.partition(" ")
    if redo == "redo":
        return translated("Redo axis {0}").format(axis.upper())
    if choice == "done":
        if prompt.drawing.get("reversed") is False:  # the leads of a half
            return translated("Leads put back")
        return translated(next((ASKED[one] for one in (*prompt.drawing, prompt.key) if one in ASKED), WORDS["done"]))
    return translated(WORDS.get(choice, choice))
