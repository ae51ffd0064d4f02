"""Whether a fit is good, in words: what it leaves over beside the noise that the run states, and its map beside the
specification.

Not beside the noise of the method, which makes it of what is left over.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import Fitted
from labcal.gui.translations.punctuation import listed_apart, with_head
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.conformity import RESULTS, verdict
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.gui.viewmodels.number_format import decimals_for, format_number, short_number
from labcal.uncertainty.conformity import Judged

STATES = ("", "good", "warning", "bad")
NO_FIT = (  # what it means, why, and what is next: where other methods are left, and where none is
    QT_TRANSLATE_NOOP("Words", "✕ No calibration from this run by {0}"),
    QT_TRANSLATE_NOOP("Words", "✕ No calibration from this run"),
    QT_TRANSLATE_NOOP(
        "Words",
        "Offset and gains did not come out of these rows, so nothing can be traced or signed of this run. "
        "The DUT may still be good.",
    ),
    QT_TRANSLATE_NOOP("Words", "Why: {0}."),
    QT_TRANSLATE_NOOP("Words", "Next: the other methods. Some of them need less of a run."),
    QT_TRANSLATE_NOOP(
        "Words",
        "Next: measure again, with turns about x, y and z and in more than one magnitude, as preflight does it. "
        "Look first at the pictures below: a turn that stands apart from the others is the one that went wrong.",
    ),
)
SET_ASIDE = (
    QT_TRANSLATE_NOOP("Words", "Without a result: {0}. What is said above is of {1}, and does not rest on them."),
    QT_TRANSLATE_NOOP("Words", "Without a result: {0}."),
)
LISTED = 2  # lines of the specification that are not within their limits; the others are counted
EXPLAINED = "explained"
REACHED = 1.15  # of the noise: as the loop calls a run clean
GOOD = QT_TRANSLATE_NOOP(
    "Words",
    "✓ The calibration is good in size: {0} nT rms of |b| are left over, no more than its noise, {1} nT rms. "
    "The loop judges the direction.",
)
DOUBT = QT_TRANSLATE_NOOP(
    "Words", "▲ The map alone is not enough: {0} nT rms of |b| are left over, its noise is {1} nT rms."
)
OF_WHICH = QT_TRANSLATE_NOOP(
    "Words",
    "What is left over is the rms of |b| in held-out rows; its noise is what is stated of |b| in one reading. "
    "The figure on the Loop page is of the whole vector in such rows, its direction too.",
)
TRACE = QT_TRANSLATE_NOOP("Words", "Trace the residual.")
TRACED = QT_TRANSLATE_NOOP("Words", "The residual was traced: {0}. The Loop page says what was found.")
IN_THE_DRAFT = QT_TRANSLATE_NOOP("Words", "The residual was traced: {0}. The loop's draft holds its cause.")
LEFT_OPEN = QT_TRANSLATE_NOOP(
    "Words",
    "▲ This run does not determine the whole map, however little is left over: {0}. It is good for a check, and for no "
    "calibration.",
)
NO_NOISE = QT_TRANSLATE_NOOP("Words", "{0} nT rms of |b| are left over; no noise is stated to compare it with.")
NO_LIMITS = QT_TRANSLATE_NOOP("Words", "No specification is stated.")


def no_fit_words(fits: Mapping[str, Fitted], *, others: bool) -> tuple[str, str, str, str]:
    """Heading, what it means, why, and what is next of a run of which no method that was tried made a calibration."""
    by, alone, means, why, to_others, again = (translated(str(words)) for words in NO_FIT)
    heading = by.format(", ".join(fits)) if others else alone
    reasons = " ".join(why.format(reason) for reason in reasons_of(fits))
    return heading, means, reasons, to_others if others else again


def reasons_of(fits: Mapping[str, Fitted], most: int = 2) -> list[str]:
    """Why methods gave no calibration, each reason once."""
    said = (in_words(one.fit.why_not or "").removesuffix(".") for one in fits.values() if not one.fit.ok)
    return [why for why in dict.fromkeys(said) if why][:most]


def set_aside_words(fits: Mapping[str, Fitted], method: str) -> str:
    """Which methods have no part in what is said of `method`; "" where all came to a result."""
    without = ", ".join(name for name, one in fits.items() if not one.fit.ok)
    known, alone = (translated(str(words)) for words in SET_ASIDE)
    return (known if method else alone).format(without, method) if without else ""


def said_of(method: str, fitted: Fitted | None, traced: str = "") -> tuple[str, str]:
    """What there is to say of the fit by `method`, and the worst of its states; "" where nothing is known.

    `traced`: the loop's verdict on this run; "" where there is none yet.
    """
    left = None if fitted is None else fitted.fit.holdout_rms_scalar_nT
    if fitted is None or (left is None and not fitted.left_open):
        return "", ""
    said = (_by_what_is_left(fitted, traced), _by_the_specification(fitted.specification))
    between = "\n" if fitted.specification else " "
    words = with_head(method, between.join(words for words, _ in said))
    return words, max((state for _, state in said), key=STATES.index)


def _by_what_is_left(fitted: Fitted, traced: str) -> tuple[str, str]:
    """Nothing that is left over is small enough where the map itself is open."""
    if fitted.left_open:
        return translated(str(LEFT_OPEN)).format(in_words(fitted.left_open)), "warning"
    return _by_the_noise(fitted.fit.holdout_rms_scalar_nT or 0.0, fitted.stated_nT, traced)


def _by_the_noise(left_nT: float, stated_nT: float | None, traced: str) -> tuple[str, str]:
    shown = format_number(left_nT, signed=False)
    if stated_nT is None:
        return translated(str(NO_NOISE)).format(shown), ""
    good = left_nT <= REACHED * stated_nT
    words = translated(str(GOOD if good else DOUBT)).format(shown, format_number(stated_nT, signed=False))
    return (words, "good") if good else (f"{words} {_what_is_next(traced)}", "warning")


def _what_is_next(traced: str) -> str:
    """Of what the map leaves over: nobody is sent to do again what was done."""
    if not traced:
        return translated(str(TRACE))
    return translated(str(IN_THE_DRAFT if traced == EXPLAINED else TRACED)).format(verdict_word(traced))


def _by_the_specification(lines: Sequence[Judged]) -> tuple[str, str]:
    """The worst line's result for all of them, and which lines are not within their limits."""
    if not lines:
        return translated(str(NO_LIMITS)), ""
    worst = max((line.result for line in lines), key=list(RESULTS).index)
    beyond = [one for one in lines if one.result != "pass"]
    more = f" (+ {len(beyond) - LISTED})" if len(beyond) > LISTED else ""
    words = listed_apart([*map(_line, beyond[:LISTED])]) + more
    said = verdict(lines)
    return with_head(said, words) if words else f"{said}.", RESULTS[worst][2]


def _line(line: Judged) -> str:
    decimals = decimals_for(line.U, line.value)
    value, U = format_number(line.value, decimals), format_number(line.U, decimals, signed=False)
    return f"{in_words(line.quantity)} {value} ± {U} {line.unit} (± {short_number(line.limit)})"
