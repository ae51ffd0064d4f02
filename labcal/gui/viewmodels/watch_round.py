"""In which order the lab is read at rest: the coils every second, everybody else one by one between them. No widgets.

Who is slow, or silent, so keeps nobody waiting but for one answer: the coils tell whether hands may be there. A supply
that is silent is asked like everybody else until it answers, by itself, and just after a look at the other coils: what
was read of those is not old before the next one. Where a look at the coils takes longer than to the next one, the
others have as long after it.
"""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Collection, Sequence

from labcal.gui.viewmodels.lab_now import HOMES_S, LOOK_S, WATCHED_S

COILS_S = 1.0  # from one look at the coils to the next
LATE_S = 1.25  # one answer may be late by so much, and nobody is alarmed
LAST = 5  # looks at the coils, by which it is told how long one takes on this bench
Names = tuple[str, ...]


class WatchRound:
    """`is_coil`: whether an instrument of this name is a coil's supply."""

    def __init__(self, is_coil: Callable[[str], bool]) -> None:
        self._is_coil = is_coil
        self._due: list[Names] = []
        self._read_s: dict[str, float] = {}  # others, when they were asked last
        self._left_s = 0.0  # which the others have before the coils are looked at again
        self._took_s = deque[float](maxlen=LAST)
        self._silent = set[str]()  # supplies of coils
        self._looks = self._just_looked = False  # at coils that answer: then is the time for one that does not
        self._others_s: dict[str, float] = {}  # what the last look at each of them took: coils wait for one of these
        self._apart_s: dict[str, float] = {}  # by other, how long before the last answer it gave the one before that
        self._answered_s: dict[str, float] = {}

    @property
    def by_s(self) -> float:
        """A reading of the coils that is older lets nobody in: the next look at them has not been answered.

        Before the first of these looks nothing is missed: a run has ended, and their line is opened anew.
        """
        if not self._took_s:
            return math.inf
        usual_s = max(self._took_s)  # a computer that is loaded makes each of them late now and then
        waits_s = max(LATE_S, *self._others_s.values(), 0.0)
        return min(WATCHED_S, max(COILS_S, usual_s) + waits_s + usual_s)

    @property
    def others_by_s(self) -> float:
        """A reading of the others that is older lets nobody in; longer where their round is, as long as they answer.

        Whoever has not been asked is not missed.
        """
        return min(
            float(HOMES_S), max(float(WATCHED_S), *(apart_s + LATE_S for apart_s in self._apart_s.values()), 0.0)
        )

    def begin(self, names: Sequence[str], now_s: float, *, at_once: bool = False) -> None:
        """Of `names` the coils that answer are due now, and the others that were not read for as long as a look takes.

        `at_once`: whenever they were.
        """
        coils = tuple(name for name in names if self._in_looks(name))
        waits = [due for due in self._due if due[0] in names and not self._in_looks(due[0])]
        rested = [(name,) for name in names if not self._in_looks(name)
                  and (at_once or now_s - self._read_s.get(name, -LOOK_S) > LOOK_S - COILS_S / 2)]  # fmt: skip
        self._due, self._looks = [coils, *waits] if coils else waits, bool(coils)
        self._due += [due for due in rested if due not in waits]

    def next(self, now_s: float) -> Names:
        """Who is to be asked now, in one question; none where this round is over."""
        if not self._due:
            return ()
        may = [due for due in self._due if due[0] not in self._silent or self._just_looked or not self._looks]
        others = [due for due in may if not self._in_looks(due[0])]
        if not may:
            return ()
        names = others[0] if others and self._left_s > 0 else may[0]
        self._due.remove(names)
        self._just_looked = self._in_looks(names[0])
        self._read_s |= {name: now_s for name in names if not self._in_looks(name)}
        return names

    def took(
        self, names: Sequence[str], seconds: float, *, silent: Collection[str] = (), now_s: float | None = None
    ) -> None:
        """So long it took until these were read, or, the `silent` ones, known to give no answer, at `now_s`."""
        look = bool(names) and all(map(self._in_looks, names))
        slow = seconds > COILS_S and not silent  # one that fell silent waits no more; the others may have fallen too
        self._left_s = seconds * slow if look else self._left_s - seconds
        if look and not silent:
            self._took_s.append(seconds)
        elif not look:
            self._others_s |= {name: seconds for name in names if not self._is_coil(name)}
        if now_s is not None:
            self._note_apart(names, silent, now_s)
        self._silent = (self._silent - set(names)) | set(filter(self._is_coil, silent))

    def _note_apart(self, names: Sequence[str], silent: Collection[str], now_s: float) -> None:
        for name in (one for one in names if not self._is_coil(one)):
            before_s = None if name in silent else self._answered_s.get(name)
            self._apart_s.pop(name, None)
            if before_s is not None:
                self._apart_s[name] = now_s - before_s
            self._answered_s[name] = now_s

    def _in_looks(self, name: str) -> bool:
        """Whether it is looked at with the coils: those that answer are read at one moment."""
        return self._is_coil(name) and name not in self._silent

    def forget(self) -> None:
        """Nobody is due: somebody else wants the lines."""
        self._due, self._left_s = [], 0.0
        self._read_s, self._silent = {}, set()
        self._took_s.clear()
        self._others_s, self._apart_s, self._answered_s = {}, {}, {}
