"""Every cause that the loop looked at, with its standing and why. No widgets."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from math import inf
from typing import NamedTuple

from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.gui.ipc.answers import Loop
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.cause_words import Cause, id_beside, in_plain_words
from labcal.gui.viewmodels.loop_words import as_a_drop, plain_reason
from labcal.gui.viewmodels.number_format import format_number
from labcal.model.records import EffectRecord, Rival

HEADINGS = (
    QT_TRANSLATE_NOOP("Words", "cause"),
    QT_TRANSLATE_NOOP("Words", "takes off  nT"),
    QT_TRANSLATE_NOOP("Words", "evidence"),
    QT_TRANSLATE_NOOP("Words", "verdict"),
    QT_TRANSLATE_NOOP("Words", "reason"),
    QT_TRANSLATE_NOOP("Words", "in files"),
)
CAUSE, TAKES_OFF, EVIDENCE, VERDICT, REASON, ID = range(len(HEADINGS))
STANDINGS: dict[str, tuple[object, str]] = {  # how it stands, and in which colour of the theme; the first stand first
    "accepted": (QT_TRANSLATE_NOOP("Words", "✓ named"), "good"),
    "rival": (QT_TRANSLATE_NOOP("Words", "? rival"), "warning"),
    "rejected": (QT_TRANSLATE_NOOP("Words", "– not named"), "text"),
}
NATS = re.compile(r"(−?[\d.]+) nats, (\d+) needed")
ENOUGH = QT_TRANSLATE_NOOP("Words", "enough")
TOO_LITTLE = QT_TRANSLATE_NOOP("Words", "too little")
AS_WELL = QT_TRANSLATE_NOOP("Words", "does about as well as “{0}”")
NONE = QT_TRANSLATE_NOOP("Words", "no evidence")


class CauseRow(NamedTuple):
    """A cause as it stands in the table; figures are None where the loop has none of it."""

    standing: str
    cause: Cause
    words: str  # what happens, plainly
    id: str  # beside these; "" where it stands in their place
    why: str  # whole, with its figures
    reason: str  # for who stands at the cage
    takes_off_nT: float | None  # of the held-out rms, beside declared errors
    nats: tuple[float, float] | None  # of evidence, and how many are needed

    @property
    def cells(self) -> tuple[str, ...]:
        """In the order of the headings."""
        off = "–" if self.takes_off_nT is None else format_number(self.takes_off_nT, signed=False)
        standing = translated(str(STANDINGS[self.standing][0]))
        return self.words, off, self.evidence, standing, self.reason, self.id

    @property
    def evidence(self) -> str:
        """In a word: whether it is as much as a name needs."""
        if self.nats is None:
            return "–"
        found, needed = self.nats
        return translated(str(ENOUGH if found >= needed else TOO_LITTLE if found > 0 else NONE))

    def key(self, column: int) -> tuple[float, str]:
        """By what it is sorted: by a figure where the column has one."""
        figures = {
            TAKES_OFF: -inf if self.takes_off_nT is None else self.takes_off_nT,
            EVIDENCE: -inf if self.nats is None else self.nats[0],
            VERDICT: [*STANDINGS].index(self.standing),
        }
        return figures.get(column, 0.0), "" if column in figures else self.cells[column]


def candidates(loop: Loop, said: Callable[[str], str] = str) -> list[tuple[str, Cause, str]]:
    """Every cause there was: its standing, itself, and why, as it is `said`; the named ones first."""
    found: list[tuple[str, Cause, str]] = [
        ("accepted", effect, in_words(as_a_drop(said(effect.why)))) for effect in loop.accepted
    ]
    for effect in loop.accepted:
        as_well = translated(str(AS_WELL)).format(in_plain_words(effect, loop.phrases))
        found += [("rival", rival, as_well) for rival in effect.rivals]
    return found + [("rejected", effect, in_words(said(effect.why))) for effect in loop.rejected]


def cause_rows(loop: Loop) -> list[CauseRow]:
    """A row for each of the candidates, in their order."""
    return [
        CauseRow(
            standing,
            effect,
            in_plain_words(effect, loop.phrases),
            id_beside(effect, loop.phrases),
            why,
            reason,
            _takes_off(loop, effect),
            _nats(effect),
        )
        for (standing, effect, why), (*_, reason) in zip(candidates(loop), candidates(loop, plain_reason), strict=True)
    ]


def in_order(rows: Iterable[CauseRow], column: int, *, falling: bool) -> list[CauseRow]:
    """`rows` by a column; what is alike stays as it was."""
    return sorted(rows, key=lambda row: row.key(column), reverse=falling)


def _takes_off(loop: Loop, effect: Cause) -> float | None:
    """By the held-out rms before and after it; before a rival it is that of the cause that it would replace."""
    before = effect.holdout_rms_before_nT if isinstance(effect, EffectRecord) else None
    if isinstance(effect, Rival):
        before = next((one.holdout_rms_before_nT for one in loop.accepted if effect in one.rivals), None)
    after = effect.holdout_rms_after_nT
    return None if before is None or after is None else before - after


def _nats(effect: Cause) -> tuple[float, float] | None:
    found = NATS.search(effect.why) if isinstance(effect, EffectRecord) else None
    return None if found is None else (float(found[1].replace("−", "-")), float(found[2]))
