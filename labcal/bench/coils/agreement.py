"""Whether the reference beside the DUT sees the field that the supplies state: zero does not rest on their word.

Expected is b = M I + the ambient field, measured at zero since the DUT was mounted last. Allowed between the two: the
step that also tells the sign of a coil, what a place wanders since its ambient field was measured, and with current a
tenth of the coils' own field: coil constants are stated to a few per cent, and the reference stands beside the centre.
While hands mount, the ambient field of before them judges a zero alone, by what it still excludes (`before_hands`).
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from labcal.bench.coils.before_hands import DRIFT_NT_PER_H, BeforeHands, least_that_matters_nT
from labcal.bench.coils.sign import PROBE_NT
from labcal.bench.coils.state import Vector, Witness

Array = NDArray[np.float64]
LIMIT_NT = PROBE_NT
OF_FIELD = 0.1
PERSISTS_S = 2.5  # a lift that passes is gone by then or spoils the measurement, a current is still there
NO_SAMPLE_S = 2.0
CANDIDATE_S = 60.0
STUCK = 20  # readings, three axes each: noise and a converter's step leave no live sensor so still
NO_AMBIENT = "the reference has no ambient field to compare with yet"
BEFORE_HANDS = "the reference's ambient field is from before hands were at the DUT"
CHANGED = "the reference sees more change than a mounting makes"
MOVED = "the reference was moved since its ambient field was measured"
OF_BEFORE = (BEFORE_HANDS, CHANGED, MOVED)  # so it says why, whichever verdict goes with it: not for a later comparison
NOT_YET = "the reference has sent nothing since the currents settled"
NOT_STREAMING = "the reference is not streaming"
UNHEARD = {
    "overloaded": "the reference is at its full scale and cannot vouch for it",
    "link lost": "the link to the reference is lost",
}


class FieldCheck:
    """Compares what the reference sees with what it should. `blind`: why this bench has none that may; "" where it has.

    Nothing here waits or raises: `see` takes readings as they come, `witness` says what they show. `limit_A` (3,): of
    the coils' currents.
    """

    def __init__(self, matrix_nT_per_A: Array, limit_A: Array, blind: str = "") -> None:
        self._matrix, self._blind = matrix_nT_per_A, blind
        self._matters_nT = least_that_matters_nT(matrix_nT_per_A, limit_A, OF_FIELD)
        self._before: BeforeHands | None = None  # what was measured last, where only hands have been at the DUT since
        self._ambient: Array | None = None
        self._had_ambient = False  # and hands were at the DUT since
        self._ambient_s = 0.0
        self._candidate: tuple[Array, float] | None = None
        self._currents_A: Array | None = None
        self._since_s = self._settled_s = self._mounted_s = 0.0
        self._bad_s: float | None = None
        self._last: Array | None = None
        self._same = 0  # readings in a row
        self._unheard = ""  # why it sends no readings, as far as that is known
        self._elsewhere = False  # it was moved, and no ambient field was measured since
        self._moved = False  # the reference itself: what it sees of the coils is not known any more
        self.streaming = False
        self.witness = Witness(why=blind or NO_AMBIENT)

    def waits_for_more(self, settled_for_s: float) -> bool:
        """Whether a verdict is still to come, so long after all has settled [s]; one that sends nothing has none."""
        if self._blind or self._ambient is None or not self.streaming or self.witness.verdict != "not known":
            return False
        return settled_for_s < (NO_SAMPLE_S if self._bad_s is None else PERSISTS_S + NO_SAMPLE_S)

    @property
    def looks_until_s(self) -> float:
        """Up to when a zero that something is known to compare with may still be seen by what the reference sends."""
        known = self._ambient is not None or self._before is not None
        open_ = self.witness.verdict == "not known" and self.witness.read_s is None
        return self._settled_s + NO_SAMPLE_S if known and open_ and self.streaming and self.zero_expected else -math.inf

    @property
    def zero_expected(self) -> bool:
        """Whether the coils are said to be at zero."""
        return self._currents_A is not None and not self._currents_A.any()

    @property
    def ambient_nT(self) -> Array | None:
        """The ambient field (3,) it compares with; None where there is none since the mounting."""
        return self._ambient

    def take_ambient(self, field_nT: Array, now_s: float) -> None:
        """The field (3,) [nT, C] that the reference saw with the coils at zero."""
        self._ambient, self._ambient_s, self._before = np.asarray(field_nT, dtype=float), now_s, None
        self._elsewhere = False
        if self.witness.verdict == "not known":
            self.witness = Witness(why=self._why_not())

    def remember(self, before: BeforeHands) -> None:
        """What an earlier stretch of a run had measured, where nothing else is known: hands were at the DUT since."""
        if self._ambient is None and self._before is None:
            self._had_ambient, self._before = True, before
            if self.witness.verdict == "not known":
                self.witness = Witness(why=self._why_not())

    def outdated(self, now_s: float, *, reference_moved: bool = False, by_hands: bool = False) -> None:
        """The DUT is mounted anew, or its surroundings are not what they were: the ambient field is not known.

        `by_hands`: no more than a mounting changes has changed; what was measured before judges a zero still.
        """
        if self._ambient is not None:
            self._had_ambient, self._before = True, BeforeHands(self._ambient, self._ambient_s)
        if reference_moved or not by_hands:
            self._before = None
        self._ambient, self._candidate, self._mounted_s, self._bad_s = None, None, now_s, None
        self._moved, self._elsewhere = self._moved or reference_moved, self._elsewhere or reference_moved
        if self.witness.verdict != "disagrees":
            self.witness = Witness(why=self._why_not())

    def expect(self, currents_A: Array | None, since_s: float, settled_s: float) -> None:
        """From `since_s` on these currents (3,) ought to flow, settled at `settled_s`; None: they change."""
        if currents_A is None or (currents_A.any() and self._moved):
            self._currents_A = None
        else:
            self._currents_A = currents_A
        self._since_s, self._settled_s, self._bad_s = since_s, settled_s, None
        self.witness = Witness(why=self._why_not())

    def leaves_zero(self, now_s: float) -> None:
        """The coils are about to be energised: where nothing was measured since the mounting, what was seen last is."""
        if self._ambient is None and self._candidate is not None and now_s - self._candidate[1] < CANDIDATE_S:
            self.take_ambient(*self._candidate)

    def unheard(self, fault: str) -> None:
        """The reference cannot be read for this fault, by its name; "" where it can, or where that is not known."""
        why, self._unheard = self._unheard, UNHEARD.get(fault, "")
        if self.witness.verdict == "not known" and why != self._unheard:
            self.witness = Witness(why=self._why_not())

    def see(self, t_s: Array, field_nT: Array) -> None:
        """Take in readings (n, 3) [nT, C] at `t_s` (n,), in order."""
        self._count_the_same(field_nT)
        rows = t_s >= max(self._since_s, self._mounted_s)
        if self._blind or self._currents_A is None or not rows.any():
            return
        t, field = t_s[rows], field_nT[rows]
        settled = t >= self._settled_s
        seen = np.median(field[settled], axis=0) if settled.any() else field[-1]
        if self._same >= STUCK:
            self.witness = Witness(why="the reference repeats one reading")
        elif self._ambient is not None:
            self._judge(seen, float(t[settled][0]) if settled.any() else None, float(t[-1]))
        elif self.zero_expected and settled.any():
            self._candidate = seen, float(t[-1])
            self._judge_by_before(seen, float(t[-1]))

    def _why_not(self) -> str:
        if self._blind or self._ambient is None:
            before = MOVED if self._elsewhere else BEFORE_HANDS
            return self._blind or (before if self._had_ambient else NO_AMBIENT)
        if not self.streaming:
            return NOT_STREAMING
        return self._unheard or NOT_YET

    def _count_the_same(self, field_nT: Array) -> None:
        """A sensor that repeats one reading bit for bit sees nothing any more."""
        if len(field_nT):
            before = field_nT[:1] if self._last is None else self._last[None, :]
            moved = np.flatnonzero(np.any(np.diff(np.vstack([before, field_nT]), axis=0) != 0, axis=1))
            self._same = len(field_nT) - int(moved[-1]) if len(moved) else self._same + len(field_nT)
            self._last = field_nT[-1]

    def _judge_by_before(self, seen: Array, now_s: float) -> None:
        """A zero, while hands mount: an agreement where that excludes a current that matters, and never a doubt."""
        before = self._before
        if before is None or self.witness.verdict == "disagrees":
            return
        apart, limit = before.apart_nT(seen), before.limit_nT(LIMIT_NT, now_s)
        hidden = before.most_hidden_nT(LIMIT_NT, now_s)
        if apart <= limit and hidden < self._matters_nT:
            expected = _vector(before.field_nT)
            self.witness = Witness("agrees", BEFORE_HANDS, _vector(seen), expected, apart, limit, now_s)
        elif apart > hidden:
            expected = _vector(before.field_nT)
            self.witness = Witness("not known", CHANGED, _vector(seen), expected, apart, hidden, now_s)
        else:
            self.witness = Witness(why=BEFORE_HANDS)

    def _judge(self, seen: Array, bad_since_s: float | None, now_s: float) -> None:
        assert self._ambient is not None
        assert self._currents_A is not None
        coils = self._matrix @ self._currents_A
        expected = coils + self._ambient
        apart = float(np.linalg.norm(seen - expected))
        age_h = max(0.0, now_s - self._ambient_s) / 3600
        limit = LIMIT_NT + DRIFT_NT_PER_H * age_h + OF_FIELD * float(np.linalg.norm(coils))
        found = Witness("agrees", "", _vector(seen), _vector(expected), apart, limit, now_s)
        if apart <= limit:
            self._bad_s, self.witness = None, found
        elif bad_since_s is not None:  # before it has settled only an agreement counts
            self._bad_s = bad_since_s if self._bad_s is None else self._bad_s
            certain = now_s - self._bad_s >= PERSISTS_S or self.witness.verdict == "disagrees"
            in_doubt = Witness("not known", f"the reference is looked at again: {found.words}", read_s=now_s)
            self.witness = Witness("disagrees", "", *_known(found)) if certain else in_doubt


def _known(found: Witness) -> tuple[Vector | None, Vector | None, float, float, float | None]:
    return found.seen_nT, found.expected_nT, found.difference_nT, found.limit_nT, found.read_s


def _vector(values: Array) -> Vector:
    x, y, z = (float(v) for v in values)
    return x, y, z
