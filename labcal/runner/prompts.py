"""Who answers a prompt: a person, or `--yes` as far as that may."""

from __future__ import annotations

from collections.abc import Callable

from labcal.errors import InputError
from labcal.record.stream import Prompt

Answer = Callable[[Prompt], str]


def first_choice(prompt: Prompt) -> str:
    """The answer of a bench where nothing can be hurt: the first choice; of a serial, the one that is wanted."""
    return prompt.choices[0] if prompt.choices else str(prompt.drawing.get("serial", ""))


def information_only(prompt: Prompt) -> str:
    """The first choice where nothing is done by it. Raises InputError where only a person may answer."""
    if prompt.acts:
        why = "--yes cannot answer for a person on a real bench or a served one; leave it out and answer at a terminal"
        raise InputError(f"{why}: {prompt.text}")
    return first_choice(prompt)


def yes_to_all(simulated: bool) -> Answer:
    """What `--yes` answers with: everything where all links are emulated, else information only."""
    return first_choice if simulated else information_only


def checked(prompt: Prompt, answer: str) -> str:
    """`answer` itself. Raises InputError where it is none of the choices."""
    if prompt.choices and answer not in prompt.choices:
        raise InputError(f"{answer!r} is no answer to {prompt.key!r}: expected {' or '.join(prompt.choices)}")
    return answer
