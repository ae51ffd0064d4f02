"""How a calibration comes to be signed: what is to be done next, in words."""

from __future__ import annotations

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import CalibrationFile, Standing
from labcal.gui.translations.translate import translated

NO_LONGER = ("expired", "superseded")
WORDS = {
    "unsigned": QT_TRANSLATE_NOOP("Words", "○ draft"),
    "invalid": QT_TRANSLATE_NOOP("Words", "✕ not valid"),
    "provisional": QT_TRANSLATE_NOOP("Words", "▲ provisional"),
    "expired": QT_TRANSLATE_NOOP("Words", "▲ expired"),
    "superseded": QT_TRANSLATE_NOOP("Words", "▲ superseded"),
    "released": QT_TRANSLATE_NOOP("Words", "✓ released"),
}
NO_MORE = QT_TRANSLATE_NOOP(
    "Words", "Do not use it any more: measure anew, or take the calibration that came after it."
)


def standing_word(one: Standing) -> str:
    """How a file stands, in a word with its shape."""
    return translated(str(WORDS[one.status])) if one.status else ""


def state_of(one: Standing) -> str:
    """The colour of a file that somebody has signed: good where it is released."""
    if not one.valid:
        return "bad"
    return "warning" if one.provisional or one.status in NO_LONGER else "good"


def awaited(one: CalibrationFile) -> list[str]:
    """Who approved it and has not signed it yet."""
    return [name for name in one.approvers if name not in one.standing.signers]


def next_step(one: CalibrationFile, operator: str) -> str:
    """What is to be done with a calibration now, in one sentence."""
    signatures = one.standing.signatures
    if signatures and not one.standing.valid:
        return translated("Do not use it: make a new draft on the Fit page.")
    if not signatures and not one.approvers:
        return translated(
            "Another person than {0} approves, and signs; without a key, New key below makes one. "
            "Nobody there? Sign alone: it is PROVISIONAL."
        ).format(one.operator or operator or translated("the operator"))
    waiting = awaited(one)
    if not signatures:
        approved = translated("Approved by {0}, who has to sign now. The operator may sign as well.")
        return approved.format(", ".join(one.approvers))
    if waiting:
        return translated("Good to use as PROVISIONAL; {0} has still to sign.").format(", ".join(waiting))
    if one.standing.status in NO_LONGER:
        return translated(str(NO_MORE))
    if not one.approvers:
        return translated("Good to use as PROVISIONAL: nobody approved it before it was signed.")
    return translated("Done: hand it out.")
