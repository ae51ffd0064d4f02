"""The lab is looked at on while no run goes on, until the coils are read back at zero and everybody answers.

Nothing is set by it. It has a worker of its own, which whoever wants the coils off ends at once; while that is not
answered, the reference is read beside it. Where nobody has been
at the window for `ALONE_S` and hands may go in, nobody reads on: supplies are not asked all night for nobody.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Sequence
from dataclasses import replace
from datetime import datetime
from math import isfinite

from PySide6.QtCore import QObject, QTimer, Signal

from labcal.gui.ipc.client import Worker
from labcal.gui.ipc.lab_messages import InstrumentRead, PrepareToRead, ReadLab
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.guardian import GUARDIAN
from labcal.gui.viewmodels.hands_now import MAY
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import LOOK_S, WATCHED_S, LabNow
from labcal.gui.viewmodels.watch_round import COILS_S, WatchRound

LOOK_MS = int(1000 * COILS_S)
ALONE_S = 15 * 60.0  # since the last key, mouse, order or run
Readings = tuple[InstrumentRead, ...]


class LabWatch(QObject):
    """`bench`: the file of the bench that may be read now, "" where none may. `wrong`: whom to look at again.

    `coils`: the supplies of the coils, by name, which are looked at most often.
    """

    was_read = Signal()

    def __init__(
        self,
        worker: Worker,
        lab: LabViewModel,
        bench: Callable[[], str],
        wrong: Callable[[], tuple[str, ...]],
        take: Callable[[Readings], object],
        coils: Callable[[], Collection[str]],
    ) -> None:
        super().__init__()
        self._worker, self._lab, self._bench, self._wrong, self._take = worker, lab, bench, wrong, take
        self.beside_off: Callable[[], ReadLab | None] = lambda: None  # what is read while COILS OFF is not answered
        self._touched_s = time.monotonic()
        self.alone_since = ""  # by the clock on the wall, since when nobody reads; "" while somebody does
        self.round = WatchRound(lambda name: name in coils())
        self._asked: ReadLab | None = None
        self._asked_s = self._idle_since_s = self._unasked_s = 0.0
        self._ready_for = ""  # the bench whose drivers the worker has loaded, while a run has their lines
        self._kept = set[str]()  # what a guardian that is still at work has not let go of
        self.timer = QTimer(self, interval=LOOK_MS)
        self.timer.timeout.connect(self.look)
        self.timer.start()

    def look(self) -> None:
        """Read again what is wrong, if anything is, and nobody else has the lab."""
        if not self._bench():  # a run goes on, or another one has the lab: that is somebody
            self._touched_s, self.alone_since = time.monotonic(), ""
        elif not self.alone_since and time.monotonic() - self._touched_s > ALONE_S and self._confirmed:
            self.alone_since = f"{datetime.now():%H:%M}"
        if not self.alone_since and self._bench() and (names := self._wrong()):
            self.round.begin(names, time.monotonic())
            self._go_on()
        if self._asked is None and (beside := self.beside_off()) is not None:
            self._ask(beside)

    def coils_by_s(self) -> float:
        """A reading of the coils that is older is missed: they were asked, and have not answered.

        For as long as nobody was asked, though it was time, the window is late, and not the lab; `WATCHED_S` holds.
        """
        by_s = self.round.by_s
        if not isfinite(by_s):
            return by_s
        return float(WATCHED_S) if self._asked is None else min(float(WATCHED_S), by_s + self._unasked_s)

    def patience(self) -> dict[str, float]:
        """As `KnownLab.now` takes it."""
        return {"by_s": self.coils_by_s(), "others_by_s": self.round.others_by_s}

    def prepare(self, bench: str) -> None:
        """A run goes on, on this bench ("": none does): whoever looks after it has nothing to load first."""
        before, self._ready_for = self._ready_for, bench
        if bench and bench != before:
            self._worker.request(PrepareToRead(bench), lambda _: None, lambda _: None)

    def _go_on(self) -> None:
        """Ask whoever is due in this round of looks, one question after another."""
        bench = self._bench()
        if self._asked is None and bench and (names := self.round.next(time.monotonic())):
            self._ask(ReadLab(bench, names))

    @property
    def _confirmed(self) -> bool:
        """Whether hands may go in by what was read last: as long as they may not, it is read on."""
        return self._lab.state.hands[1] in MAY

    def touched(self) -> None:
        """Somebody is at the window: it is read on, at once."""
        self._touched_s, alone, self.alone_since = time.monotonic(), self.alone_since, ""
        if alone:
            self.look()

    def seen_in(self, now: LabNow) -> LabNow:
        """The lab, with since when nobody reads it, and whose lines a guardian has kept."""
        if self._kept and not now.driven:
            of = dict.fromkeys(self._kept, self.tr("the guardian of the last session has it"))
            of[GUARDIAN] = self.tr("still at work")
            lights = (
                (name, light, of.get(name, said) if light == "absent" else said) for name, light, said in now.lights
            )
            now = replace(now, lights=tuple(lights))
        return replace(now, unread_since=self.alone_since) if self.alone_since else now

    def read_all(self) -> None:
        """Everybody, whatever is known of them; a person asked. In a run they are told who reads, and when."""
        if self._lab.state.now.driven:
            words = self.tr("A run goes on and reads the instruments itself; the DUT is read again in its next step.")
            self._lab.update(message=words)
            return
        if not self._lab.state.reading and (bench := self._bench()):
            self._lab.update(reading=True, message=self.tr("Reading every instrument; nothing is set …"))
            self._ask(ReadLab(bench))

    def read_again(self, names: Sequence[str]) -> None:
        """These now, and not only those that are wrong, where nobody else has the lab: coils first, by themselves."""
        if self._bench() and names:
            self.round.begin(names, time.monotonic(), at_once=True)
            self._go_on()

    def forget(self) -> None:
        """Of another bench no guardian is known to be at work."""
        self._kept = set()

    def stop(self) -> None:
        """Let go of every line at once: somebody wants them."""
        self.round.forget()
        if self._asked is not None:
            self._over()
            self._worker.kill()

    def _ask(self, asked: ReadLab) -> None:
        self._asked, self._asked_s = asked, time.monotonic()
        self._unasked_s = max(0.0, self._asked_s - self._idle_since_s - COILS_S)
        self._worker.request(asked, lambda said: self._read(asked, said), lambda fault: self._failed(asked, fault))

    def _read(self, asked: ReadLab, said: Readings) -> None:
        """What came too late, for a run has begun or another bench is open, says nothing of now."""
        if asked is not self._asked:
            return
        for_a_person, took_s = not asked.names, time.monotonic() - self._asked_s
        self._over()
        beside = self.beside_off()
        if asked.bench not in (self._bench(), "" if beside is None else beside.bench):
            return
        self._kept = (self._kept - {one.name for one in said}) | {one.name for one in said if one.held and one.until}
        self._take(said)
        if for_a_person:
            self._lab.update(message=self._words(said))
        self.was_read.emit()
        self.round.took(asked.names, took_s, silent=[one.name for one in said if one.fault], now_s=time.monotonic())
        if for_a_person and took_s > LOOK_S:  # somebody was slow: what the others said is that old by now
            self.look()
        self._go_on()

    def _words(self, said: Readings) -> str:
        silent = [one.name for one in said if one.fault is not None]
        kept = [one.name for one in said if one.until]
        held = [one.name for one in said if one.held and not one.until]
        read = [one for one in said if one.fault is None and not one.held and not self._past(one)]
        words = self.tr("{0} of {1} instruments were read").format(len(read), len(said))
        words += f": ✕ {', '.join(silent)}" if silent else ""
        if kept:
            until = ", ".join(next(one.until for one in said if one.until))
            has = self.tr("; the guardian of the last session has {0} until {1} is read back at zero")
            words += has.format(", ".join(kept), until)
        return words + (self.tr("; another process has {0}").format(", ".join(held)) if held else "")

    def _past(self, one: InstrumentRead) -> bool:
        """Whether it is a guardian's last word, from before it was asked."""
        return one.read_s is not None and one.read_s < self._asked_s - LOOK_S

    def _failed(self, asked: ReadLab, fault: Fault) -> None:
        if asked is self._asked:
            self._over()
            if not asked.names:
                self._lab.update(message=fault.text)

    def _over(self) -> None:
        asked, self._asked = self._asked, None
        self._idle_since_s = time.monotonic()
        if asked is not None and not asked.names:
            self._lab.update(reading=False)
