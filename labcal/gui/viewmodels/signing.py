"""How a calibration comes to be signed and handed out: its steps, each with its state in words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import CalibrationFile, Standing
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.cause_words import in_plain_words
from labcal.gui.viewmodels.loop_words import verdict_word
from labcal.model.records import EffectRecord
from labcal.record.person import perhaps_one_person

NO_LONGER = ("expired", "superseded")
WORDS = {
    "unsigned": QT_TRANSLATE_NOOP("Words", "○ draft"),
    "invalid": QT_TRANSLATE_NOOP("Words", "✕ not valid"),
    "provisional": QT_TRANSLATE_NOOP("Words", "▲ provisional"),
    "expired": QT_TRANSLATE_NOOP("Words", "▲ expired"),
    "superseded": QT_TRANSLATE_NOOP("Words", "▲ superseded"),
    "released": QT_TRANSLATE_NOOP("Words", "✓ released"),
}
MARKS = {  # of a step: its shape, its word and its colour
    "done": ("✓", QT_TRANSLATE_NOOP("Words", "done"), "good"),
    "now": ("●", QT_TRANSLATE_NOOP("Words", "to do now"), "now"),
    "later": ("○", QT_TRANSLATE_NOOP("Words", "later"), ""),
    "never": ("–", QT_TRANSLATE_NOOP("Words", "not any more"), ""),
}
NO_MORE = QT_TRANSLATE_NOOP(
    "Words", "Do not use it any more: measure anew, or take the calibration that came after it."
)

UNTIL = QT_TRANSLATE_NOOP("Words", "Good until {0}.")
NO_END = QT_TRANSLATE_NOOP("Words", "No last day of use is stated: it never expires by itself.")
WHO_STATES = QT_TRANSLATE_NOOP(
    "Words", "That day is stated by who approves (2), by the interval of your lab; labcal works none out here."
)
AS_IT_WAS = QT_TRANSLATE_NOOP("Words", "So it was stated when it was approved.")
NONE_WAS = QT_TRANSLATE_NOOP("Words", "None was when it was approved, and none can be added any more.")
AMBIGUOUS = QT_TRANSLATE_NOOP("Words", "AMBIGUOUS, the cause is not certain: {0}. It may be another: {1}.")
ANOTHER = QT_TRANSLATE_NOOP("Words", "another one")
NEXT_DUT = QT_TRANSLATE_NOOP("Words", "Handed out. Next: another DUT.")
UNEXPLAINED = QT_TRANSLATE_NOOP(
    "Words", "UNEXPLAINED: what is left of held-out rows has no known cause, and U takes it for random."
)
HELD = QT_TRANSLATE_NOOP("Words", "Its run did not measure {0}: they were held as they stand.")
NOT_WHOLE = QT_TRANSLATE_NOOP("Words", "Nobody can approve it: turn about the other body axes as well.")
ALONE = QT_TRANSLATE_NOOP("Words", "Signed it stays PROVISIONAL, for its run did not measure it whole.")
AS_SUCH = QT_TRANSLATE_NOOP("Words", "Handed out as {0}. Next: another DUT.")
PROVISIONAL = QT_TRANSLATE_NOOP("Words", "PROVISIONAL")
HANDED_OUT = QT_TRANSLATE_NOOP("Words", "handed out")
AS_DOUBTED = QT_TRANSLATE_NOOP("Words", "As {0}: why is said above.")


def standing_word(one: Standing) -> str:
    """How a file stands, in a word with its shape."""
    return translated(str(WORDS[one.status])) if one.status else ""


def state_of(one: Standing) -> str:
    """The colour of a file that somebody has signed: good where it is released."""
    if not one.valid:
        return "bad"
    return "warning" if one.provisional or one.status in NO_LONGER else "good"


def doubts(one: CalibrationFile) -> str:
    """Why who signs has to think: what else may be the cause, what has none, what was not measured; "" else."""
    words = translated(str(AMBIGUOUS))
    said = [words.format(in_plain_words(d, one.phrases), _others(d, one)) for d in _provisional(one)]
    said += [translated(str(UNEXPLAINED))] if one.unexplained else []
    said += [translated(str(HELD)).format(", ".join(one.not_measured))] if one.not_measured else []
    return " ".join(said)


def _provisional(one: CalibrationFile) -> list[EffectRecord]:
    return [effect for effect in (*one.effects, *one.findings) if effect.provisional]


def _others(doubted: EffectRecord, one: CalibrationFile) -> str:
    named = ", ".join(in_plain_words(rival, one.phrases) for rival in doubted.rivals)
    return named or translated(str(ANOTHER))


def file_word(one: CalibrationFile) -> str:
    """How a file stands, and that its cause is not certain: a signature does not make it so."""
    word = standing_word(one.standing)
    if not doubt_word(one):
        return word
    shape, _, said = word.partition(" ")
    return f"{'▲' if shape == '✓' else shape} {' · '.join(filter(None, (said, doubt_word(one))))}".strip()


def handed_out_word(one: CalibrationFile) -> str:
    """That a file left the lab; where it is less than released without a doubt, as what."""
    shape, _, said = file_word(one).partition(" ")
    word = translated(str(HANDED_OUT))
    return f"✓ {word}" if shape == "✓" else f"{shape} {word} · {said}"


def doubtful(text: str) -> bool:
    """Whether what is said of a verdict, or of a calibration, has a shape of doubt."""
    return not {"▲", "?"}.isdisjoint(text)


def handed_out_as(one: CalibrationFile) -> str:
    """PROVISIONAL, and what the loop says of it: as what it goes; "" where it goes without a doubt."""
    return ", ".join(filter(None, (translated(str(PROVISIONAL)) if one.standing.provisional else "", doubt_word(one))))


def doubt_word(one: CalibrationFile) -> str:
    """AMBIGUOUS or UNEXPLAINED, without its shape; "" where it is neither."""
    verdict = "unexplained" if one.unexplained else "ambiguous" if _provisional(one) else ""
    return verdict_word(verdict).partition(" ")[2] if verdict else ""


def file_state(one: CalibrationFile) -> str:
    """Its colour: a draft has none, what is in doubt is never good."""
    signed = state_of(one.standing) if one.standing.signatures else ""
    return "warning" if signed in ("", "good") and doubts(one) else signed


def until_words(one: CalibrationFile, typed: str) -> str:
    """Until when it is, or will be, good; `typed`: the day, while it may be stated still."""
    day = typed or one.until
    return translated(str(UNTIL)).format(day) if day else translated(str(NO_END))


def valid_words(one: CalibrationFile, typed: str) -> str:
    """The same, and where that comes from."""
    says = until_words(one, typed)
    if one.standing.signatures:
        return says
    approved = AS_IT_WAS if one.until else NONE_WAS
    return f"{says} {translated(str(approved if one.approvers else WHO_STATES))}"


def awaited(one: CalibrationFile) -> list[str]:
    """Who approved it and has not signed it yet."""
    return [name for name in one.approvers if name not in one.standing.signers]


@dataclass(frozen=True, slots=True)
class SigningStep:
    """A step from draft to file: `mark` is one of `MARKS`; `words` say how it stands, and why."""

    mark: str
    words: str


def steps(
    one: CalibrationFile, keys: Sequence[str], operator: str, *, handed_out: bool = False
) -> tuple[SigningStep, SigningStep, SigningStep, SigningStep]:
    """Key, approve, sign, hand out: how each stands for this file, where `keys` are who has a key here."""
    who = one.operator or operator
    others = [name for name in keys if not perhaps_one_person(name, who)]
    return (
        _key_step(one, keys, others, who or translated("the operator")),
        _approve_step(one, others, who or translated("the operator")),
        _sign_step(one, keys),
        _hand_out_step(one, handed_out),
    )


def _key_step(one: CalibrationFile, keys: Sequence[str], others: Sequence[str], who: str) -> SigningStep:
    if one.standing.signatures or one.approvers or others:
        here = translated("With a key here: {0}.").format(", ".join(keys)) if keys else ""
        return SigningStep("done", here or translated("Whoever signed has a key elsewhere."))
    if not keys:
        return SigningStep("now", translated("Nobody has a key here. Make one for the person who approves."))
    words = translated("Only {0} has a key here. Make one for who approves: another person than {1}.")
    return SigningStep("now", words.format(", ".join(keys), who))


def _approve_step(one: CalibrationFile, others: Sequence[str], who: str) -> SigningStep:
    if one.approvers:
        return SigningStep("done", translated("Approved by {0}.").format(", ".join(one.approvers)))
    if one.standing.signatures:
        return SigningStep("never", translated("Signed without an approval: nobody can be added any more."))
    if one.not_measured:
        return SigningStep("never", translated(str(NOT_WHOLE)))
    if others:
        return SigningStep(
            "now", translated("Another person than {0} looks at the figures below, and approves.").format(who)
        )
    return SigningStep("later", translated("First a key of another person than {0} (1).").format(who))


def _sign_step(one: CalibrationFile, keys: Sequence[str]) -> SigningStep:
    standing, waiting = one.standing, awaited(one)
    if standing.signatures and not standing.valid:
        return SigningStep("never", translated("Do not use it: make a new draft on the Fit page."))
    if waiting:
        words = translated("{0} has to sign. The operator may sign as well.")
        if standing.signatures:
            words = translated("Good to use as PROVISIONAL; {0} has still to sign.")
        elsewhere = "" if set(waiting) & set(keys) else translated("Their key is not on this computer.")
        return SigningStep("now", f"{words.format(', '.join(waiting))} {elsewhere}".strip())
    if standing.signatures:
        return SigningStep("done", translated("Signed by {0}.").format(", ".join(standing.signers)))
    if not keys:
        return SigningStep("later", translated("First a key (1)."))
    if one.not_measured:
        return SigningStep("later", translated(str(ALONE)))
    return SigningStep(
        "later", translated("After the approval (2). Nobody there? Sign alone: it is valid, and PROVISIONAL.")
    )


def _hand_out_step(one: CalibrationFile, handed_out: bool) -> SigningStep:
    standing = one.standing
    if not standing.signatures:
        return SigningStep("later", translated("Once it is signed (3)."))
    if not standing.valid:
        return SigningStep("never", translated("Do not use it: make a new draft on the Fit page."))
    if standing.status in NO_LONGER:
        return SigningStep("never", translated(str(NO_MORE)))
    if waiting := awaited(one):
        return SigningStep(
            "later", translated("Once {0} has signed; before that as PROVISIONAL.").format(", ".join(waiting))
        )
    if handed_out:
        as_what = handed_out_as(one)
        done = translated(str(AS_SUCH)) if as_what else translated(str(NEXT_DUT))
        return SigningStep("done", done.format(as_what))
    if not one.approvers:
        return SigningStep("now", translated("As PROVISIONAL: nobody approved it before it was signed."))
    as_what = handed_out_as(one)
    return SigningStep("now", translated(str(AS_DOUBTED)).format(as_what) if as_what else "")
