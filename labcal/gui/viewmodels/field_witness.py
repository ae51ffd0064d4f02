"""The reference as a witness that a coil is on, where its supply is silent or says zero. No widgets."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from PySide6.QtCore import QT_TRANSLATE_NOOP

from labcal.bench.coils import state
from labcal.bench.coils.agreement import CHANGED, LIMIT_NT, OF_FIELD
from labcal.bench.coils.before_hands import BeforeHands, least_that_matters_nT
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.lab_now import LabNow, age_words, alarm_of, platform_mark, reference_U

SEES_MORE = QT_TRANSLATE_NOOP("Words", "the reference sees {0} µT along {1} more than with the coils off")
STILL_ON = QT_TRANSLATE_NOOP("Words", "the field says: still on ({1}, {0} µT more than with the coils off, {2})")
ON_BY_FIELD = QT_TRANSLATE_NOOP("Words", "a coil is still on by the field")
CARD = QT_TRANSLATE_NOOP("Words", "✕ HANDS OFF: a coil is still on, the field says so")


@dataclass(frozen=True, slots=True)
class Off:
    """What the reference sees [nT, C] with the coils off, and the least change of it that tells of a coil.

    `limit_nT`: so far off a zero is seen all the same, whoever mounted meanwhile; None where a coil could hide in that.
    `beside_silent_nT`: the least change that tells of a supply that fell silent with its current.
    """

    field_nT: state.Vector
    least_nT: float
    limit_nT: float | None = None
    beside_silent_nT: float | None = None


def off_as_measured(field_nT: state.Vector, facts: Bench, measured_s: float, now_s: float) -> Off:
    """By the rule of `BeforeHands`, for what was measured at `measured_s`."""
    before = BeforeHands(np.array(field_nT), measured_s)
    hides = before.most_hidden_nT(LIMIT_NT, now_s) >= _matters_nT(facts)
    limit_nT = None if hides else before.limit_nT(LIMIT_NT, now_s)
    return Off(field_nT, least_seen_nT(facts, measured_s, now_s), limit_nT, _beside_silent_nT(facts, before, now_s))


def _beside_silent_nT(facts: Bench, before: BeforeHands, now_s: float) -> float:
    """What the reference may be off (k = 2) and a place wanders, and what a person who went to the plug has on them."""
    own_nT = reference_U(facts, tuple(before.field_nT.tolist()))
    return before.most_hidden_nT(LIMIT_NT if own_nT is None else own_nT, now_s)


def least_seen_nT(facts: Bench, measured_s: float, now_s: float) -> float:
    """A change of more than that since `measured_s` is a coil's: no mounting makes it, a tenth of a limit does."""
    return max(_matters_nT(facts), BeforeHands(np.zeros(3), measured_s).most_hidden_nT(LIMIT_NT, now_s))


def _matters_nT(facts: Bench) -> float:
    cage = facts.cage
    return least_that_matters_nT(np.array(cage.matrix), np.array(cage.limit_A, dtype=float), OF_FIELD)


def more_than_off(
    known: state.LabState, facts: Bench | None, off: Off | None, *, with_current: bool = False
) -> tuple[state.Vector, float] | None:
    """What the reference sees [nT, C] beyond the ambient field, and when, where a coil is on that nobody owns to.

    `with_current`: a supply fell silent with one, which explains a change that would else be laid to what is magnetic.
    """
    if facts is None:
        return None
    if off is not None and with_current and off.beside_silent_nT is not None:
        off = replace(off, least_nT=min(off.least_nT, off.beside_silent_nT))
    return _judged(known, facts) or (None if off is None else _beside_the_silent(known, facts, off))


def _judged(known: state.LabState, facts: Bench) -> tuple[state.Vector, float] | None:
    """By whoever compared it last: it sees no zero, or more change than a mounting makes."""
    seen, on = known.reference, any(coil.current_A is not None and not coil.zero for coil in known.coils)
    if on or seen.seen_nT is None or seen.expected_nT is None or seen.read_s is None:
        return None
    if seen.verdict != "disagrees" and seen.why != CHANGED:
        return None
    if (known.field.read_s or seen.read_s) > seen.read_s and silent(known):  # what it saw since is newer
        return None
    return _beyond(seen.seen_nT, seen.expected_nT, least_seen_nT(facts, seen.read_s, seen.read_s), seen.read_s)


def _beside_the_silent(known: state.LabState, facts: Bench, off: Off) -> tuple[state.Vector, float] | None:
    """By what it saw last, while a supply gives no answer; the others, on their way to zero, explain what they can."""
    seen = known.field
    if not silent(known) or seen.seen_nT is None or seen.read_s is None:
        return None
    flowing = np.array([abs(coil.current_A or 0.0) for coil in known.coils if coil.axis in tuple("xyz")])
    columns = ["xyz".index(coil.axis) for coil in known.coils if coil.axis in tuple("xyz")]
    of_others_nT = float(flowing @ np.linalg.norm(np.array(facts.cage.matrix), axis=0)[columns])
    return _beyond(seen.seen_nT, off.field_nT, off.least_nT + of_others_nT, seen.read_s)


def _beyond(
    seen_nT: state.Vector, off_nT: state.Vector, least_nT: float, read_s: float
) -> tuple[state.Vector, float] | None:
    x, y, z = np.subtract(seen_nT, off_nT).tolist()
    return ((x, y, z), read_s) if np.hypot(np.hypot(x, y), z) > least_nT else None


class SaidLast:
    """What the reference was seen to see more than with the coils off: it stands until that is read again."""

    def __init__(self) -> None:
        self._more: tuple[state.Vector, float] | None = None

    def take(
        self, more: tuple[state.Vector, float] | None, known: state.LabState, *, moved: bool
    ) -> tuple[state.Vector, float] | None:
        """`more`, as it is seen now; or what was, while a coil is silent and a reference not `moved` is not read."""
        before = self._more
        if more is None and before is not None and silent(known) and not moved:
            reads = (known.field.read_s if known.field.seen_nT is not None else None, known.reference.read_s)
            more = before if all(read_s is None or read_s < before[1] for read_s in reads) else None
        self._more = more
        return more


def silent(known: state.LabState) -> bool:
    """Whether a coil could not be read."""
    return any(coil.current_A is None and coil.fault for coil in known.coils)


def field_says(now: LabNow) -> str:
    """In words, along the axis on which it is most, with its age where no supply tells; "" where it tells of nothing.

    That a coil is on is said where one is not confirmed at zero; else it may be something very magnetic.
    """
    if (more := now.field_more_nT) is None:
        return ""
    most = max(range(3), key=[abs(one) for one in more].__getitem__)
    more_nT = more[most]
    said = f"{more_nT / 1000:+.{0 if abs(more_nT) >= 1e4 else 1}f}".replace("-", "−")
    words = STILL_ON if still_on(now) else SEES_MORE
    return translated(str(words)).format(said, "xyz"[most], age_words(now.field_more_old_s))


def still_on(now: LabNow) -> bool:
    """Whether the field says so of a coil that is not confirmed at zero: that is more than that it may be."""
    return now.field_more_nT is not None and now.coil_words.startswith((state.NOT_CONFIRMED, state.NOT_SINCE))


def card_words(now: LabNow) -> str:
    """The heading of the card over every page in place of "may be on", where that is known since COILS OFF; "" else."""
    return translated(str(CARD)) if still_on(now) and not now.field_more_before_off else ""


def still_live(now: LabNow) -> str:
    """By what was read last: coils that are on, or not confirmed, a platform that turns or may; "" else."""
    turns = {"warning": "platform turning", "bad": "platform may turn"}.get(platform_mark(now.platform_words)[1], "")
    on = in_words(state.ON) if now.coil_words.startswith(state.ON) else alarm_of(now.coil_words).removeprefix("✕ ")
    on = translated(str(ON_BY_FIELD)) if still_on(now) else on
    return ", ".join(filter(None, (on, translated(turns) if turns else "")))
