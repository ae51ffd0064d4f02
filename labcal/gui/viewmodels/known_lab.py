"""The lab as it was heard of last, and as it may be shown now: what was read before COILS OFF is past, and soon missed.

Times are by the computer's monotonic clock.
"""

from __future__ import annotations

import math
from dataclasses import replace

from labcal.bench.coils import state
from labcal.bench.coils.agreement import BEFORE_HANDS, MOVED, NO_AMBIENT
from labcal.bench.coils.at_zero import FREE_S
from labcal.gui.ipc.bench_facts import Bench
from labcal.gui.ipc.lab_messages import InstrumentRead
from labcal.gui.viewmodels.by_hand import last_read
from labcal.gui.viewmodels.field_witness import Off, SaidLast, more_than_off, off_as_measured
from labcal.gui.viewmodels.in_common import in_common
from labcal.gui.viewmodels.lab_now import LOOK_S, WATCHED_S, LabNow, lab_now, platform_mark
from labcal.gui.viewmodels.last_current import LastCurrents
from labcal.gui.viewmodels.last_heard import LastHeard
from labcal.gui.viewmodels.reference_again import ambient_of, measured_at_s, mounted_anew, seconded
from labcal.gui.viewmodels.who_is_there import with_guardian

UNANSWERED = "no answer yet"  # of a coil: to the order of zero; nothing is known against its supply
LOST_FIRST_S = 8.0  # so long after the order a supply that is known to be lost is named alone, the others not known yet
AMBIENT_S = 120.0  # so long what a reference saw is compared with what it sees
ANSWERS_S = 2.0  # so long after its ramp a supply has to be read back at zero; then it is said that it was not


class KnownLab:
    """`state` as a worker sent it last; None where none did, or of another bench."""

    def __init__(self) -> None:
        self.state: state.LabState | None = None
        self._received_s = self._since_s = 0.0  # since when a coil is to be read back
        self._agreed: state.LabState | None = None  # as it was when a reference agreed last, of this mounting
        self._off: state.LabState | None = None  # the same, whatever was mounted since: it tells of a coil still
        self.asked = False  # another worker was asked to switch the coils off, and has not answered
        self.ordered_s: float | None = None  # when zero was ordered; None once it is known how the coils ended
        self.warned = False  # that this takes too long
        self._lost_s: float | None = None  # since when a supply gives no answer
        self._last, self._said, self._heard = LastCurrents(), SaidLast(), LastHeard()
        self._missed_s: float | None = None  # when those coils were read that were not read again in time
        self.heard = set[str]()  # instruments that have answered on this bench, whoever asked

    def take(self, known: state.LabState, now_s: float) -> None:
        """From here on this is how the lab is."""
        self.state, self._received_s = known, now_s
        self._last.keep(known.coils)
        self._heard.keep(known)
        self._lost_s = (self._lost_s or now_s) if _lost(known) else None
        self.heard |= {one.name for one in known.instruments if one.heard_s is not None}
        figures = known.reference.expected_nT is not None  # else nothing can be compared with it
        agrees = known.reference.verdict == "agrees" and all(coil.current_A is not None for coil in known.coils)
        agrees = agrees and figures
        if agrees or mounted_anew(known):  # beside a silent supply an agreement tells nothing: it is from before
            self._agreed = None if mounted_anew(known) else known
        if known.reference.why == MOVED:
            self._off = None
        elif agrees and (self._off is None or known.reference.why != BEFORE_HANDS):  # that is as old as it was
            self._off = known

    def of_run(self, known: state.LabState, facts: Bench | None, now_s: float) -> state.LabState:
        """As a run says that it is; while that has nothing to compare a zero with, by what was measured before it."""
        zero = all(coil.zero for coil in known.coils) and not known.field.changing
        if facts is None or facts.virtual_time or known.reference.why != NO_AMBIENT or not zero:
            return known
        before, field = self.state, known.field
        if field.seen_nT is None:
            rested = before is not None and bool(before.coils) and all(coil.zero for coil in before.coils)
            agreed = before is not None and before.reference.verdict == "agrees"
            return replace(known, reference=before.reference) if before is not None and rested and agreed else known
        said = InstrumentRead("", "reference", "", read_s=field.read_s, field_nT=field.seen_nT)
        found = seconded(known, (said,), None, self.off(facts, now_s))
        return found if found.reference.verdict == "agrees" else known

    def off(self, facts: Bench | None, now_s: float) -> Off | None:
        """What the reference saw with the coils off, however long ago."""
        measured_s = None if self._off is None else measured_at_s(self._off.reference)
        if self._off is None or facts is None or measured_s is None or (found := ambient_of(self._off, facts)) is None:
            return None
        return off_as_measured(found[0], facts, measured_s, now_s)

    def ambient_nT(self, facts: Bench | None, now_s: float) -> tuple[state.Vector, float] | None:
        """What the reference is to see with the coils at zero [nT, C], and how far off that may be; soon out of date.

        Hands may have brought or taken something since.
        """
        seen_s = None if self._agreed is None else self._agreed.reference.read_s
        if self._agreed is None or facts is None or seen_s is None or now_s - seen_s > AMBIENT_S:
            return None
        return ambient_of(self._agreed, facts)

    def order(self, now_s: float, *, asked: bool = False, read_back: bool = False) -> None:
        """Somebody says off; where that was said before and stands, its time counts.

        `read_back`: a run did so before it ended, and what it saw at zero stays there: nobody drives it any more.
        """
        if self.ordered_s is None:
            self.ordered_s, self.warned, self._since_s = now_s, False, 0.0 if read_back else now_s
        self.asked = self.asked or asked

    def reached_zero(self) -> bool:
        """Whether each coil was read back at zero since that was ordered, and no reference says otherwise."""
        known = self.state
        return known is not None and not self._silent() and known.reference.verdict != "disagrees"

    def answered(self) -> None:
        """How the coils ended is known, or nobody will say it any more."""
        self.asked, self.ordered_s = False, None

    def late(self, facts: Bench | None, now_s: float) -> bool:
        """Whether a supply that answers would have been read back at zero by now, and one was not."""
        unread = self.state is None or all(coil.read_s is None for coil in self.state.coils)
        answers_s = FREE_S if unread else ANSWERS_S  # of lines that nobody has opened yet
        if self.ordered_s is None or now_s - self.ordered_s <= answers_s + self._ramp_s(facts):
            return False
        return self.state is None or bool(self._silent())

    def missed(self) -> state.LabState:
        """The lab with what has not answered since zero was ordered: nobody knows what that carries."""
        known, silent = self.state or state.LabState(state.unread()), self._silent()
        coils = tuple(_unknown(coil) if self.state is None or coil in silent else coil for coil in known.coils)
        return replace(known, coils=coils)

    def as_now(self, facts: Bench | None, now_s: float) -> state.LabState | None:
        """What may be said to be known at `now_s`."""
        if self.late(facts, now_s):
            return self.missed()
        if not self.asked:
            return self.state
        known = self.state or state.LabState(())
        return replace(known, coils=state.unread(), field=replace(known.field, set_nT=None, changing=False))

    def now(
        self,
        facts: Bench | None,
        now_s: float,
        *,
        driven: bool,
        by_s: float = math.inf,
        others_by_s: float = WATCHED_S,
    ) -> LabNow:
        """What may be said at `now_s`; `driven`: by a run of this window.

        Else coils are read again by `by_s`, and who else lets hands in by `others_by_s`.
        """
        roles = {} if facts is None else {name: one.role for name, one in facts.instruments.items()}
        known = self.as_now(facts, now_s)
        by_run = driven or facts is None or facts.virtual_time  # a supply that is read at rest says nothing of contacts
        by_s = self._patience_s(known, now_s, by_s, driven=driven)
        now = lab_now(known, self._received_s, roles, now_s, driven=driven, contacts_heard=by_run, coils_by_s=by_s)
        now = replace(now, others_by_s=WATCHED_S if driven else others_by_s)
        now = replace(now, in_common=_in_common(known, facts), heard_at_s=self._heard.at_s(supplies(facts)))
        now = replace(now, lights=with_guardian(now.lights, facts))
        if not driven and facts is not None and facts.virtual_time:
            now = _not_read_on(now)
        if known is not None and (more := self._field_more(known, facts, now_s)) is not None:
            old = max(0, int(now_s - more[1]))
            before = more[1] < self._since_s
            now = replace(now, field_more_nT=more[0], field_more_old_s=old, field_more_before_off=before)
        if known is not None:
            now = replace(now, silent_with_current=self._last.words(known.coils))
        if known is not None and known.platform is not None and not by_run:  # emulated, it is gone with the run
            unseen = platform_mark(now.platform_words)[1] == "bad"
            now = replace(now, left_turning=known.platform.moving is True, left_unseen=unseen)
        if known is None and (driven or facts is not None):
            now = replace(now, coil_words=state.NOT_YET if driven else state.NOT_READ)
        return replace(now, coil_words=state.NOT_SINCE) if self.asked and not self.late(facts, now_s) else now

    def _patience_s(self, known: state.LabState | None, now_s: float, by_s: float, *, driven: bool) -> float:
        """`by_s`, and none for a reading that was missed once: it does not come back while the next is waited for."""
        read_s = None if known is None else min((c.read_s for c in known.coils if c.read_s is not None), default=None)
        if driven or read_s is None:
            self._missed_s = None
        elif now_s - read_s > by_s:
            self._missed_s = read_s
        return 0.0 if read_s is not None and read_s == self._missed_s else by_s

    def _field_more(
        self, known: state.LabState, facts: Bench | None, now_s: float
    ) -> tuple[state.Vector, float] | None:
        """What the reference sees [nT, C] more than with the coils off, and when that was read."""
        before = self.state if self.asked and not self.late(facts, now_s) else None  # not read since
        off, seen = self.off(facts, now_s), before or known
        more = more_than_off(seen, facts, off, with_current=bool(self._last.words(seen.coils)))
        return self._said.take(more, seen, moved=off is None)

    def by_hand(self, facts: Bench | None, now_s: float) -> tuple[str, ...]:
        """The supplies that a person switches off, by name: those that gave no answer, or are on; else all.

        Where the reference sees a field that the supplies do not own to, those that could make it.
        """
        named = supplies(facts)
        known = self.missed() if self.late(facts, now_s) else self.state
        if known is None:
            return tuple(named.values())
        on = {coil.axis for coil in known.coils if not coil.zero and (coil.fault or coil.current_A is not None)}
        on = on or {coil.axis for coil in known.coils if not coil.zero}
        if lost := _lost(known):
            going = {coil.axis for coil in known.coils if coil.axis not in lost and self._goes_to_zero(coil, now_s)}
            on -= going  # nothing says that they do not get there
        if known.reference.verdict == "disagrees":
            advised = {axis for axis, name in named.items() if name in known.reference.advice}
            on = on | advised or set(named)
        return tuple(name for axis, name in named.items() if axis in on)

    def not_read(self, facts: Bench | None, now_s: float) -> tuple[str, ...]:
        """The other supplies that nobody has read for so long that it says nothing of now, each with how long ago."""
        known, by_hand = self.state or state.LabState(()), self.by_hand(facts, now_s)
        old = {c.axis: c.read_s for c in known.coils if c.read_s is None or now_s - c.read_s > WATCHED_S}
        left = ((old[axis], name) for axis, name in supplies(facts).items() if axis in old and name not in by_hand)
        return tuple(name if read_s is None else last_read(name, int(now_s - read_s)) for read_s, name in left)

    def _goes_to_zero(self, coil: state.CoilReading, now_s: float) -> bool:
        """Whether it may be on its way still: since zero was ordered, or by the run that lost another supply."""
        driven_s = self._lost_s if coil.set_A else None  # at rest nobody knows what was set
        since_s = max((s for s in (self.ordered_s, driven_s) if s is not None), default=-math.inf)
        return now_s - since_s < LOST_FIRST_S

    def _silent(self) -> list[state.CoilReading]:
        coils = () if self.state is None else self.state.coils
        return [coil for coil in coils if not coil.zero or coil.read_s is None or coil.read_s < self._since_s]

    def _ramp_s(self, facts: Bench | None) -> float:
        """How long the way down takes from what flowed last, as the bench file has it."""
        rates = {} if facts is None else dict(zip("xyz", facts.cage.ramp_A_per_s, strict=False))
        coils = () if self.state is None else self.state.coils
        return max((abs(c.current_A or 0.0) / rates[c.axis] for c in coils if c.axis in rates), default=0.0)


def _not_read_on(now: LabNow) -> LabNow:
    """At rest the reference of a simulated lab is another lab's: how long ago it agreed would grow for ever.

    As soon as a look at it would be due it is said so: with an age first, hands would read three sentences in 5 s.
    """
    if not now.reference_agreed or (now.reference_old_s or 0) <= LOOK_S:
        return now
    alone = now.coil_words.startswith(state.BY_WORD)
    return replace(
        now, alone=state.NOT_READ_ON, coil_words=f"{state.BY_WORD}: {state.NOT_READ_ON}" if alone else now.coil_words
    )


def _lost(known: state.LabState) -> set[str]:
    """The coils of which a supply gave no answer; what was not asked yet is not lost."""
    return {coil.axis for coil in known.coils if coil.fault and coil.fault != UNANSWERED}


def _unknown(coil: state.CoilReading) -> state.CoilReading:
    return replace(coil, current_A=None, zero=False, fault=coil.fault or UNANSWERED)


def _in_common(known: state.LabState | None, facts: Bench | None) -> str:
    """Of those that do not answer."""
    if known is None or facts is None:
        return ""
    by_axis = supplies(facts)
    silent = {one.name for one in known.instruments if one.fault}
    silent |= {by_axis[c.axis] for c in known.coils if c.fault not in ("", UNANSWERED) and c.axis in by_axis}
    asked = {n: one for n, one in facts.instruments.items() if one.role != "polarity" or n in silent}  # not by itself
    return in_common(silent, {name: one.link for name, one in asked.items()})


def supplies(facts: Bench | None) -> dict[str, str]:
    """The coils' supplies by axis; none where no bench is open."""
    instruments = {} if facts is None else facts.instruments
    return {one.role[-1]: name for name, one in instruments.items() if one.role.startswith("coil-")}
