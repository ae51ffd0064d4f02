"""Sentences that come as data in another language: questions to the person, what is said of the coils, what failed,
what the loop finds.

Procedures, the bench and the loop write them in English, and the record keeps them so; what is shown is found by its
form. A sentence that has none of these forms is shown as it came.
"""

from __future__ import annotations

import re
from functools import cache, lru_cache

from PySide6.QtCore import QT_TRANSLATE_NOOP, QCoreApplication, QLocale

from labcal.bench.coils.state import BY_SUPPLIES, BY_WORD
from labcal.gui.translations.causes import PHRASES
from labcal.gui.translations.experiments import EXPERIMENTS, NEXT
from labcal.gui.translations.faults import FAULTS
from labcal.gui.translations.fits import BUDGET, FITS
from labcal.gui.translations.lab_faults import LAB_FAULTS, OF_THE_WORK
from labcal.gui.translations.loop import FINDINGS, PROGRESS, REASONS, SHAPES
from labcal.gui.translations.procedures import EXPECTED, NAMES, NEEDS, SETTINGS, SHORTFALLS, TITLES
from labcal.gui.translations.punctuation import as_set, listed_apart
from labcal.gui.translations.steps import BENCH, EVENTS, MEASUREMENTS, PLAN, REFUSALS, STEPS

COILS = (  # of several that fit the first counts; what stands for {0}, {1} … is itself such a sentence, or stays
    QT_TRANSLATE_NOOP("Data", "coils at zero"),
    QT_TRANSLATE_NOOP("Data", "coils NOT confirmed at zero; {0}"),
    QT_TRANSLATE_NOOP("Data", "coils NOT confirmed at zero: {0}"),
    QT_TRANSLATE_NOOP("Data", "coils NOT confirmed at zero"),
    QT_TRANSLATE_NOOP("Data", "NOT at zero by the reference: {0}. {1}"),
    QT_TRANSLATE_NOOP("Data", "NOT at zero by the reference"),
    QT_TRANSLATE_NOOP("Data", "coils read back at zero by their supplies"),
    QT_TRANSLATE_NOOP("Data", "coils not read back in this session"),
    QT_TRANSLATE_NOOP("Data", "coils may be on: a run goes on, and nothing was read yet"),
    QT_TRANSLATE_NOOP("Data", "coils may be on"),
    QT_TRANSLATE_NOOP("Data", "coils not read back since they were ordered off"),
    QT_TRANSLATE_NOOP("Data", "coils on: {0}, read back {1}"),
    QT_TRANSLATE_NOOP("Data", "coils on: {0}"),
    QT_TRANSLATE_NOOP("Data", "coils on"),
    QT_TRANSLATE_NOOP("Data", "platform NOT confirmed at a standstill"),
    QT_TRANSLATE_NOOP("Data", "platform turns"),
    QT_TRANSLATE_NOOP("Data", "platform turns, at {0}°"),
    QT_TRANSLATE_NOOP("Data", "platform turns, at {0}°, read {1}"),
    QT_TRANSLATE_NOOP("Data", "platform NOT confirmed at a standstill: at {0}° it turned"),
    QT_TRANSLATE_NOOP("Data", "platform NOT confirmed at a standstill: at {0}° it turned, {1}"),
    QT_TRANSLATE_NOOP("Data", "platform stands at {0}°"),
    QT_TRANSLATE_NOOP("Data", "platform stands at {0}°, read {1}"),
    QT_TRANSLATE_NOOP("Data", "coils confirmed at zero {0}; not watched since"),
    QT_TRANSLATE_NOOP("Data", "coils read back at zero by the supply's word {0}; not watched since"),
    QT_TRANSLATE_NOOP("Data", "coils confirmed at zero {0}, silent since"),
    QT_TRANSLATE_NOOP("Data", "coils read back at zero by the supply's word {0}, silent since"),
    QT_TRANSLATE_NOOP("Data", "coils confirmed at zero {0}"),
    QT_TRANSLATE_NOOP("Data", "coils read back at zero by the supply's word {0}"),
    QT_TRANSLATE_NOOP("Data", "taking the coils to zero: ordered, not read back yet …"),
    QT_TRANSLATE_NOOP("Data", "waiting for a guardian that takes the order of zero …"),
    QT_TRANSLATE_NOOP("Data", "no reference has confirmed it"),
    QT_TRANSLATE_NOOP("Data", "of a simulated lab the reference is not read at rest"),
    QT_TRANSLATE_NOOP("Data", "the reference does not answer"),
    QT_TRANSLATE_NOOP("Data", "the reference has no ambient field to compare with yet"),
    QT_TRANSLATE_NOOP("Data", "the reference's ambient field is from before hands were at the DUT"),
    QT_TRANSLATE_NOOP("Data", "the reference was moved since its ambient field was measured"),
    QT_TRANSLATE_NOOP("Data", "coils at zero, by their supplies and by the field"),
    QT_TRANSLATE_NOOP("Data", "the reference sees more change than a mounting makes"),
    QT_TRANSLATE_NOOP("Data", "the reference has sent nothing since the currents settled"),
    QT_TRANSLATE_NOOP("Data", "the reference is not streaming"),
    QT_TRANSLATE_NOOP("Data", "the reference is at its full scale and cannot vouch for it"),
    QT_TRANSLATE_NOOP("Data", "the link to the reference is lost"),
    QT_TRANSLATE_NOOP("Data", "the reference repeats one reading"),
    QT_TRANSLATE_NOOP("Data", "the reference is looked at again: {0}, {1} s ago"),
    QT_TRANSLATE_NOOP("Data", "the reference is looked at again: {0}"),
    QT_TRANSLATE_NOOP("Data", "the reference agreed when it was last looked at, {0}"),
    QT_TRANSLATE_NOOP("Data", "it sees {0} nT, {1} nT expected: {2} µT apart, {3} µT allowed"),
    QT_TRANSLATE_NOOP("Data", "{0} UTC, {1}"),
    QT_TRANSLATE_NOOP(
        "Data",
        "It is as if {0} A flowed in coil {1}: open the output of {2} at its panel, or switch it off at its mains",
    ),
    QT_TRANSLATE_NOOP(
        "Data", "It is as if {0} A flowed in coil {1}: switch off {2} at its mains (no command opens its output)"
    ),
    QT_TRANSLATE_NOOP("Data", "{0} s ago"),
    QT_TRANSLATE_NOOP("Data", "{0} min ago"),
    QT_TRANSLATE_NOOP("Data", "{0} h ago"),
    QT_TRANSLATE_NOOP("Data", "at {0} ({1})"),
    QT_TRANSLATE_NOOP("Data", "Open the outputs that can open, or switch the supplies off at their mains"),
)
QUESTIONS = (
    QT_TRANSLATE_NOOP(
        "Data",
        "Mount the DUT with body {0} up along the platform axis, body {1} towards the cage's {2}, at platform angle 0.",
    ),
    QT_TRANSLATE_NOOP("Data", "Scan the serial of the DUT as it is mounted now: this run is of {0}."),
    QT_TRANSLATE_NOOP("Data", "{0}: that is not the DUT of this run. Mount {1}, then scan its serial again."),
    QT_TRANSLATE_NOOP("Data", "nothing"),
    QT_TRANSLATE_NOOP("Data", "Mount the DUT with body Z up, body X towards the cage's X; then {0}."),
    QT_TRANSLATE_NOOP("Data", "as it stands"),
    QT_TRANSLATE_NOOP("Data", "as it always stands"),
    QT_TRANSLATE_NOOP("Data", "turned by 180° about its own {0}"),
    QT_TRANSLATE_NOOP("Data", "turned by 180° about its {0}"),
    QT_TRANSLATE_NOOP("Data", "Is the DUT still mounted with body {0} up, exactly as it was before the interruption?"),
    QT_TRANSLATE_NOOP("Data", "Why is axis {0} redone? What was measured stays in the record, marked as not used."),
    QT_TRANSLATE_NOOP("Data", "Why is {0} skipped?"),
    QT_TRANSLATE_NOOP("Data", "the disk is slow: rows wait {0} s in memory"),
    QT_TRANSLATE_NOOP("Data", "the disk takes what is recorded again"),
    QT_TRANSLATE_NOOP("Data", "{0}: body {1} is up, not {2}. Mount it again: this turn says nothing of {2}."),
    QT_TRANSLATE_NOOP("Data", "Still lost: {0}. Put that right first: a step begun now fails again."),
    QT_TRANSLATE_NOOP("Data", "Switch the DUT to power mode {0}."),
    QT_TRANSLATE_NOOP("Data", "Switch the load {0} on."),
    QT_TRANSLATE_NOOP("Data", "Switch the load {0} off."),
    QT_TRANSLATE_NOOP("Data", "Switch the platform's motor off at its plug."),
    QT_TRANSLATE_NOOP("Data", "Switch the platform's motor on again."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort). No faster "
        "than {1} deg/s.",
    ),
    QT_TRANSLATE_NOOP(
        "Data", "Turn the platform to {0}° on its dial, take your hands off, and enter what it reads (or: abort)."
    ),
    QT_TRANSLATE_NOOP("Data", "Warm the DUT within its limits, then let it cool."),
    QT_TRANSLATE_NOOP(
        "Data", "Take the DUT off the platform, some metres away. Leave the reference and all else as it is."
    ),
    QT_TRANSLATE_NOOP("Data", "Take the DUT away and put the reference at its place, on a stand that does not turn."),
    QT_TRANSLATE_NOOP("Data", "Put the reference at the {0}'s place: {1} mm from the DUT's place, in C."),
    QT_TRANSLATE_NOOP("Data", "Put the reference at {0} mm from the DUT's place, in C, turned as it always stands."),
    QT_TRANSLATE_NOOP("Data", "Put the reference {0} mm above the DUT's place, on the platform axis."),
    QT_TRANSLATE_NOOP("Data", "Put the reference {0}."),
    QT_TRANSLATE_NOOP("Data", "Put the scalar sensor into the cage's centre, its dead zones away from the fields."),
    QT_TRANSLATE_NOOP(
        "Data",
        "Swap the two leads of the half of coil {0} that stands towards +{1}. They must come back before anything else "
        "is measured, also if this run is stopped.",
    ),
    QT_TRANSLATE_NOOP("Data", "Put the two leads of the half of coil {0} that stands towards +{1} back as they were."),
    QT_TRANSLATE_NOOP("Data", "Are all covers of the DUT as they will fly, and the others off?"),
    QT_TRANSLATE_NOOP("Data", "Are the batteries those that will fly, and connected?"),
    QT_TRANSLATE_NOOP("Data", "Are all tools out of the cage?"),
    QT_TRANSLATE_NOOP("Data", "Are phones, keys and watches out of the room?"),
    QT_TRANSLATE_NOOP("Data", "Do chairs and trolleys stand at their marks?"),
    QT_TRANSLATE_NOOP("Data", "There is no file {0}. File of the photograph ({1}), or empty:"),
    QT_TRANSLATE_NOOP("Data", "File of the photograph ({0}), or empty:"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT as the DUT warms and cools. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT in all directions. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT in six directions. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT, and the platform may turn. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils go to {0} µT. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils go to {0} µT, and the platform may turn. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The platform turns to {0}°. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Next the platform looks for its zero and turns to {0}°. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT."),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT, and the platform may turn."),
    QT_TRANSLATE_NOOP("Data", "The coils go to {0} µT."),
    QT_TRANSLATE_NOOP("Data", "The coils go to {0} µT, and the platform may turn."),
    QT_TRANSLATE_NOOP("Data", "The platform turns to {0}°."),
    QT_TRANSLATE_NOOP("Data", "Next the platform looks for its zero and turns to {0}°."),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT, the platform turns. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT and stays. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field goes to {0} µT, later with the DUT turning in it. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The field steps up to {0} µT. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils go to {0} µT and the platform turns. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils go up to {0} µT and the platform turns. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils step by {0} µT and the platform turns. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "A square wave of {0} µT follows. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Each coil goes to {0} µT in turn. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "The coils go up to {0} µT, then the field rotates. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Each coil goes to {0} µT. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Each coil alternates from {0} µT downwards. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Coil {0} makes a gradient now, with the current of {1} µT. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Fields up to {0} µT are played. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Fields up to {0} µT are played as {1} wants them. Hands off?"),
    QT_TRANSLATE_NOOP("Data", "Every load is switched in turn, the others stay off. Hands off?"),
)
CHANGES = (  # from one calibration to the next
    QT_TRANSLATE_NOOP(
        "Data", "{0} of {1} figures changed by more than their uncertainty; the largest is E_n = {2} ({3})."
    ),
    QT_TRANSLATE_NOOP("Data", "No figure changed by more than its uncertainty; the largest is E_n = {0} ({1})."),
    QT_TRANSLATE_NOOP("Data", "Whether the sensor changed cannot be said: a calibration states no uncertainty."),
    QT_TRANSLATE_NOOP("Data", "Offsets are not of the same state: as found {0}, as left {1}."),
    QT_TRANSLATE_NOOP("Data", "Offsets are those at {0}."),
    QT_TRANSLATE_NOOP("Data", "at any state"),
    QT_TRANSLATE_NOOP("Data", "One of the two is simulated."),
    QT_TRANSLATE_NOOP("Data", "Only the earlier corrects {0}."),
    QT_TRANSLATE_NOOP("Data", "Only the later corrects {0}."),
)
MEASURED = re.compile(r"(?<![\w.:])-?\d+\.\d+(?= (?:A|nT|µT|mm|s|deg|V)\b)")
BELOW_ZERO = re.compile(r"(?<= )-(?=\d)")  # the sign of a number that has no unit of its own, as in a row of them
FIGURE = re.compile(r"(offset|scale|non-orthogonality|gain) ([xyz](?:-[xyz])?)")  # of a sensor, as results name it
OF_PROCEDURES = *EXPECTED, *TITLES, *NEEDS, *SHORTFALLS, *NAMES, *SETTINGS, *PLAN, *EVENTS, *REFUSALS, *BENCH
OF_RUNS = *PROGRESS, *REASONS, *SHAPES, *FINDINGS, *NEXT, *EXPERIMENTS, *PHRASES, *FITS
OF_LAB = *LAB_FAULTS, *OF_THE_WORK
FORMS = tuple(map(str, (*COILS, *CHANGES, *QUESTIONS, *FAULTS, *OF_PROCEDURES, *OF_RUNS, *OF_LAB)))
NAME_FORMS = tuple(map(str, (*BUDGET, *MEASUREMENTS, *STEPS)))
LISTS: dict[str, str] = {
    " and ": str(QT_TRANSLATE_NOOP("Words", "{0} and {1}")),
    ", or ": str(QT_TRANSLATE_NOOP("Words", "{0}, or {1}")),
    " or ": str(QT_TRANSLATE_NOOP("Words", "{0} or {1}")),
    " at ": str(QT_TRANSLATE_NOOP("Words", "{0} at {1}")),
    ", ": "{0}, {1}",
}
BREAKS = (re.compile(r"(?<=[.?!]) "), re.compile(r"(?<=;) "))  # between sentences, then within one
BLANK, IN_ONE_SENTENCE, IN_ONE_PART = (  # an initial ends no sentence
    rf"((?:{unlike}.)+?)" for unlike in ("", r"(?!(?<![A-Z])[.?!] [A-Z])", r"(?!(?<![A-Z])[.?!] [A-Z]|; )")
)
BLANKS = dict.fromkeys(OF_RUNS, IN_ONE_SENTENCE) | dict.fromkeys(SHAPES, IN_ONE_PART)
PLACE = re.compile(r"\{\d\}")
NUMBER = re.compile(r"[+−-]?\d+\.\d+")

BENCH_FILE = "bench.toml"  # so labcal's own sentences call whichever bench file is in use
ALONE = re.compile(rf"(?<![\w./\\-]){re.escape(BENCH_FILE)}\b")  # and not at the end of somebody's path

Found = tuple[str, tuple[str, ...]]


class BenchFile:
    """What the bench file in use is called."""

    name = BENCH_FILE


def of_this_bench(advice: str) -> str:
    """What is to be done, with the bench file's own name where it speaks of it."""
    return ALONE.sub(lambda _: BenchFile.name, advice)


def in_words(sentence: str) -> str:
    """`sentence` in the window's language, where it, or one of several in it, has one of these forms; else as it is."""
    if figure := FIGURE.fullmatch(sentence):
        words = figure[1].replace("offset", "zero reading")  # as in the budget: k, which is no reading, is the offset
        return f"{QCoreApplication.translate('Words', words)} {figure[2]}"
    if sentence.startswith(f"{BY_WORD}: "):  # the record's words for it: here what it is, as hands are told it
        return listed_apart([*map(in_words, (BY_SUPPLIES, sentence.partition(": ")[2]))])
    if found := form_of(sentence):
        return _filled_in(*found)
    for between in BREAKS:
        if len(parts := between.split(sentence, maxsplit=1)) == 2:
            return " ".join(map(in_words, parts))
    if sentence.endswith((".", ";")):
        return f"{in_words(sentence[:-1])}{as_set(sentence[-1])}"
    if found := form_of(f"{sentence}."):  # a whole sentence within another one has lost its end
        return _filled_in(*found).removesuffix(".")
    return sentence


def name_in_words(name: str) -> str:
    """The name of a step, a measurement or a line of a budget in the window's language; one of yours as it is."""
    if FIGURE.fullmatch(name) or (found := form_of(name, NAME_FORMS)) is None:
        return in_words(name)
    return _filled_in(*found)


def _filled_in(form: str, blanks: tuple[str, ...]) -> str:
    said = QCoreApplication.translate("Data", form)
    if BENCH_FILE in form:
        said = said.replace(BENCH_FILE, BenchFile.name.replace("{", "{{").replace("}", "}}"))
    return _by_locale(said.format(*map(_part, blanks)))


def _part(text: str) -> str:
    """What fills a blank: a number, a sentence, a name, a list of either, or data."""
    if NUMBER.fullmatch(text):
        return _as_in_tables(text)
    if (said := in_words(text)) != text or (said := name_in_words(text)) != text:
        return said
    for mark, joined in LISTS.items():
        if len(parts := text.split(mark, maxsplit=1)) == 2:
            return QCoreApplication.translate("Words", joined).format(*map(_part, parts))
    return text


def _by_locale(sentence: str) -> str:
    """Numbers that have a unit as tables have them, with the language's decimal mark; what is none stays."""
    return BELOW_ZERO.sub("−", MEASURED.sub(lambda found: _as_in_tables(found[0]), sentence))


def _as_in_tables(number: str) -> str:
    return number.replace("-", "−").replace(".", QLocale().decimalPoint())


@lru_cache(4000)
def form_of(sentence: str, forms: tuple[str, ...] = FORMS) -> Found | None:
    """The first of `forms` that a sentence has, and what stands in its blanks; None where it has none of these."""
    for form, longest, pattern in _patterns(forms):
        if longest in sentence and (match := pattern.fullmatch(sentence)):
            return form, match.groups()
    return None


@cache
def _patterns(forms: tuple[str, ...]) -> tuple[tuple[str, str, re.Pattern[str]], ...]:
    """Each form, the longest of its own pieces, which tells quickly that a sentence has it not, and its pattern."""
    return tuple((form, max(PLACE.split(form), key=len), _pattern(form)) for form in forms)


def _pattern(form: str) -> re.Pattern[str]:
    return re.compile(BLANKS.get(form, BLANK).join(map(re.escape, PLACE.split(form))), re.DOTALL)
