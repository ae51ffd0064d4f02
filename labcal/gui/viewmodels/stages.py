"""From the approval to the file that was verified: where a calibration is on its way, on one line."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import CalibrationFile, Standing
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.signing import NO_LONGER, WORDS

STAGES = (
    QT_TRANSLATE_NOOP("Words", "Approve"),  # the words of the steps below, and of the button that verifies
    QT_TRANSLATE_NOOP("Words", "Sign"),
    QT_TRANSLATE_NOOP("Words", "Release"),
    QT_TRANSLATE_NOOP("Words", "Hand out"),
    QT_TRANSLATE_NOOP("Words", "Verify"),
)
SIGNED, RELEASED = 1, 2
TO_BE_DONE = (
    QT_TRANSLATE_NOOP("Words", "Make a key (1)"),
    QT_TRANSLATE_NOOP("Words", "Approve (2)"),
    QT_TRANSLATE_NOOP("Words", "Sign (3)"),
    QT_TRANSLATE_NOOP("Words", "Hand it out (4)"),
)


def stages(one: CalibrationFile, *, handed_out: bool, verified: bool) -> str:
    """Every stage with its shape: ✓ where it has come to, ● the next one, ○ those after it."""
    standing = one.standing
    signed = bool(standing.signatures)
    if signed and (not standing.valid or standing.status in NO_LONGER):
        return f"✓ {translated(str(STAGES[SIGNED]))}  →  {_stands(standing, 'invalid')}"
    released = signed and not standing.provisional
    reached = (bool(one.approvers) or released, signed, released, handed_out, verified)
    first = next((n for n, there in enumerate(reached) if not there and not (signed and n <= RELEASED)), -1)
    words = [f"{_shape(there, n == first)} {translated(str(STAGES[n]))}" for n, there in enumerate(reached)]
    if signed and not reached[0]:
        words[0] = f"– {translated(str(STAGES[0]))}"  # nobody can be added any more
    if signed and standing.provisional:
        words[RELEASED] = _stands(standing, "provisional")  # it may leave as that
    return "  →  ".join(words)


def _stands(standing: Standing, status: str) -> str:
    """How it stands in its word; in that of `status` where the file's own is not told."""
    return translated(str(WORDS[standing.status or status]))


def _shape(there: bool, now: bool) -> str:
    return "✓" if there else "●" if now else "○"


def to_be_done(marks: Sequence[str]) -> str:
    """The one thing to do now, by the marks of the four steps, to be translated; "" where there is none."""
    return next((str(words) for words, mark in zip(TO_BE_DONE, marks, strict=True) if mark == "now"), "")
