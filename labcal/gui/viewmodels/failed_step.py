"""A step that failed, asked about: who is wrong in the largest letters; below it what is known, and what to do."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.named_links import named_links
from labcal.bench.steps import ANEW, QUESTION
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.punctuation import with_head
from labcal.gui.translations.sentences import in_words, of_this_bench
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.raw_reply import plainly
from labcal.record.stream import FAULT, Event, Prompt

WHAT, REMEDY, NO_ANSWER = "what", "remedy", "no_answer"  # in a prompt's drawing: what happened, what to do, who is lost
BY_SYSTEM = re.compile(r" \([^()]*\)(?=[.;])")  # what the computer says of a line: for who mends it
LINK = re.compile(r" \([a-z-]+://[^()]*\)")  # where an instrument is plugged in, after its name
NO_SAMPLE = re.compile(r"no sample for [\d.]+ s")  # how long it was then, beside a list that says how long it is now
UNHEARD = "no answer"
FAILED = "failed-"  # before the name of a step, in the key of its question
AGAIN = "try again"
SHOWN = QT_TRANSLATE_NOOP("Words", "✕ No answer from {0}")
MANY = QT_TRANSLATE_NOOP("Words", "✕ No answer from {0} instruments")
NAMED = 3  # of those who are lost, in the largest letters; of more how many, for the list names them
HERE = QT_TRANSLATE_NOOP("Words", "Here that is “{0}”.")
BY_OFF = QT_TRANSLATE_NOOP("Words", "The run did not end by itself within seconds, so its process was ended.")
THEN = QT_TRANSLATE_NOOP("Words", "Then “{0}”.")


def asked_text(prompt: Prompt) -> str:
    """The words of a question; where an instrument failed what it was, for step and coils stand beside it."""
    return without_age(str(prompt.drawing.get(FAULT, prompt.text)))


def headline(prompt: Prompt, lost: Sequence[str] = ()) -> str:
    """The question in one glance; of a step that failed who does not answer, else what happened.

    `lost`: everybody who is by now, where that is known. A run hears first of whom it asks most often.
    """
    if QUESTION in prompt.drawing:
        return in_words(str(prompt.drawing[QUESTION]))
    if first := prompt.drawing.get(NO_ANSWER):
        return no_answer_from(lost or [str(first)])
    return in_words(_plain(str(prompt.drawing[WHAT])) if WHAT in prompt.drawing else asked_text(prompt))


def no_answer_from(lost: Sequence[str]) -> str:
    """Who does not answer, by name; of many how many."""
    if len(lost) > NAMED:
        return translated(str(MANY)).format(len(lost))
    return translated(str(SHOWN)).format(", ".join(lost))


def below(prompt: Prompt, again: str, *, lost: bool = True, first: str = "") -> str:
    """What is known and what to do about it, before `again`, the button that begins the step anew; else "".

    `first`: what comes before that. Where nobody is `lost` any more nothing is left to do but that.
    """
    if WHAT not in prompt.drawing:
        return ""
    anew = in_words(str(prompt.drawing.get(ANEW, "")))
    if not lost:
        return f"{translated(str(THEN)).format(again)} {anew}".strip()
    what, remedy = _plain(str(prompt.drawing[WHAT])), str(prompt.drawing.get(REMEDY, ""))
    known = in_words(what) if NO_ANSWER in prompt.drawing and UNHEARD not in what else ""  # the headline says that
    button = translated(str(HERE if AGAIN in remedy.lower() else THEN)).format(again)
    return " ".join(part for part in (known, first, of_this_bench(in_words(remedy)), button, anew) if part)


def in_short(fault: Fault) -> str:
    """What happened, to be read from afar: no links, and not what the computer says of them.

    What to do is said by the card that came before this one, and by that alone.
    """
    return in_words(LINK.sub("", _plain(fault.text)))


def ended_by_off(fault: Fault) -> Fault:
    """What a person's own COILS OFF did is called by its name, also where the run's process had to be ended for it."""
    return replace(fault, kind="off", text=translated(str(BY_OFF))) if fault.kind == "ended" else fault


def said_of(event: Event, links: Mapping[str, str]) -> str:
    """What has happened, in one line; what to do about it comes with the question, once coils and platform rest."""
    said = without_age(named_links(event.text, links))
    if event.data.get("fault") == "link lost":  # what the system calls it stands in the record
        return with_head(said.partition(" (")[0].partition(": ")[0].rstrip(), in_words("link lost"))
    return said.partition(". ")[0] if event.kind == FAULT else said


def without_age(what: str) -> str:
    """Since when nobody hears an instrument is said of it in one place, by one clock: in the list of all of them."""
    return NO_SAMPLE.sub(UNHEARD, plainly(what))


def _plain(what: str) -> str:
    return without_age(BY_SYSTEM.sub("", what))
