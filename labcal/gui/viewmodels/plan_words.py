"""What the Run page says of a procedure before it is begun: what it needs, and each line of its plan."""

from __future__ import annotations

import re

from labcal.gui.ipc.answers import Procedure
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.number_format import step_title

ASKED = re.compile(r"– (?P<text>.*?)(?: \((?P<times>\d+)×(?:: (?P<steps>.*))?\))?")  # a line of a plan


def needs_text(one: Procedure, *, plannable: bool = True) -> str:
    """What a procedure needs, and how long it takes: as many lines whatever is known, so that no field moves.

    Where a plan cannot be asked for, nothing points to it.
    """
    needs = translated("Needs: {0}").format(in_words(one.needs)) if one.needs else ""
    lasts = translated("The plan says how long this takes") if plannable else "\u00a0"
    if one.lasts_min:
        lasts = translated("About {0:g} min of measuring, and your own time beside it").format(one.lasts_min)
    return "\n".join(part for part in (needs, lasts) if part)


def plan_line(line: str) -> str:
    """A line of the plan, a question with its dash before it, in the window's language."""
    asked = ASKED.fullmatch(line)
    if asked is None:
        return in_words(line)
    steps = ", ".join(map(step_title, asked["steps"].split(", "))) if asked["steps"] else ""
    often = f" ({asked['times']}×{f': {steps}' if steps else ''})" if asked["times"] else ""
    return f"– {in_words(asked['text'])}{often}"
