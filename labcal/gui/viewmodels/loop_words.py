"""The loop's verdict for whoever stands at the cage: what it means, and what is to be done. Figures stand elsewhere."""

from __future__ import annotations

import re

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import Loop
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.cause_words import ids_beside, in_plain_words
from labcal.gui.viewmodels.number_format import format_number

VERDICTS = {  # with its colour
    "clean": ("✓ CLEAN", "good"),
    "explained": ("✓ EXPLAINED", "good"),
    "partly-explained": ("▲ PARTLY EXPLAINED", "warning"),
    "ambiguous": ("? AMBIGUOUS", "warning"),
    "unexplained": ("✕ UNEXPLAINED", "bad"),
}
MEANS = {
    "clean": QT_TRANSLATE_NOOP("Words", "Nothing is left over but noise. The calibration may be signed."),
    "explained": QT_TRANSLATE_NOOP("Words", "The error has a cause: {0}. It is in the draft, which may be signed."),
    "partly-explained": QT_TRANSLATE_NOOP(
        "Words",
        "A part of the error has a cause: {0}. It is in the draft; something else is left over: see 4 before you sign.",
    ),
    "ambiguous": QT_TRANSLATE_NOOP(
        "Words", "This may be the cause: {0}. Another one does as well: measure what tells them apart (4), then sign."
    ),
    "unexplained": QT_TRANSLATE_NOOP("Words", "Something is wrong that nothing known explains. Do not sign: see 4."),
}
OPEN_MAP = "the run does not determine the whole map"  # as the loop says why it asks for more
NOT_DETERMINED = (
    QT_TRANSLATE_NOOP("Words", "▲ NOT ENOUGH FOR A WHOLE MAP"),
    QT_TRANSLATE_NOOP(
        "Words",
        "This run does not determine the whole map: too few axes or fields were measured, so no cause was searched "
        "for. That says nothing against the DUT. What to measure stands at 4.",
    ),
)
OF_WHICH = QT_TRANSLATE_NOOP("Words", "rms of the vector, with declared errors; noise alone {0} nT rms")
OF_WHICH_WHOLE = QT_TRANSLATE_NOOP(
    "Words",
    "before → after: held-out rms of the vector, with the errors in it that the run declares of reference and "
    "mounting; noise alone, of one such row: {0} nT, {1}; the figure on the Fit page is of |b| alone, without "
    "direction",
)
AS_MUCH = QT_TRANSLATE_NOOP("Words", "explains nothing beyond what is named already")
TOO_LITTLE = QT_TRANSLATE_NOOP("Words", "explains too little to be worth its parameters")
EVIDENCE = re.compile(r"(; evidence over a slow wander without a name)?:( evidence)? −?[\d.]+ nats, \d+ needed")
NOT_NAMED = {
    re.compile(r"takes .* in sample, but other forms of what is accepted take as much"): str(AS_MUCH),
    re.compile(r"takes .* off the residual: not worth its parameters"): str(TOO_LITTLE),
}
FALLS = re.compile(r"the held-out rms falls from ([\d.]+) to ([\d.]+) nT")
CALLED = QT_TRANSLATE_NOOP("Words", "in files and commands: {0}")
TEXTS = (
    QT_TRANSLATE_NOOP("Words", "{0} and {1}"),
    QT_TRANSLATE_NOOP("Words", "rows that were set aside"),
    *MEANS.values(),
)


def verdict_word(verdict: str) -> str:
    """A loop's verdict with its shape, as the Loop page writes it; "" where there is none."""
    return translated(VERDICTS[verdict][0]) if verdict in VERDICTS else verdict


def without_evidence(why: str) -> str:
    """The reason of a cause without its evidence in nats, which says nothing at the cage."""
    return EVIDENCE.sub("", why)


def plain_reason(why: str) -> str:
    """The reason why a cause is not named, for who stands at the cage; its figures where the mouse rests on it."""
    why = without_evidence(why)
    return next((translated(plain) for form, plain in NOT_NAMED.items() if form.fullmatch(why)), why)


def as_a_drop(why: str) -> str:
    """The reason of a named cause by what it takes off, and of which error: not the one at the top of the page."""

    def drop(found: re.Match[str]) -> str:
        before, after = map(float, found.groups())
        return f"it alone takes {before - after:.1f} nT off the held-out rms beside declared errors"

    return FALLS.sub(drop, why)


def of_which_error(loop: Loop) -> tuple[str, str]:
    """Of which error the two figures at the top are, and the noise beside them, in short and whole.

    It is of a row of the vector, not of |b|.
    """
    floor = format_number(loop.noise_floor_nT, signed=False)
    whole = translated(str(OF_WHICH_WHOLE)).format(floor, translated(loop.noise_floor_source))
    return translated(str(OF_WHICH)).format(floor), whole


def not_determined(loop: Loop) -> bool:
    """Whether the run is only too short for a whole map: nothing is known to be wrong by that."""
    return loop.next_experiment is not None and loop.next_experiment.why == OPEN_MAP


def headline(loop: Loop) -> tuple[str, str]:
    """The verdict in the largest letters, and its colour."""
    words, state = (str(NOT_DETERMINED[0]), "warning") if not_determined(loop) else VERDICTS[loop.verdict]
    return translated(words), state


def said_plainly(loop: Loop) -> str:
    """One sentence or two for the technician, without a figure."""
    if not_determined(loop):
        return translated(str(NOT_DETERMINED[1]))
    names = [in_plain_words(effect, loop.phrases) for effect in loop.accepted]
    named = names[0] if len(names) == 1 else translated("rows that were set aside")
    if len(names) > 1:
        named = translated("{0} and {1}").format(", ".join(names[:-1]), names[-1])
    return translated(str(MEANS[loop.verdict])).format(named)


def called(loop: Loop) -> str:
    """What files and commands call the causes that it names in plain words; "" where there are none."""
    ids = ids_beside(loop.accepted, loop.phrases)
    return translated(str(CALLED)).format(ids) if ids else ""
