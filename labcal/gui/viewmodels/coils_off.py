"""COILS OFF: ordered whatever goes on, done by force where a run does not get there, and what is said of it after."""

from __future__ import annotations

import time
from dataclasses import replace
from typing import Protocol

from PySide6.QtCore import QObject, QTimer, SignalInstance

from labcal.bench.coils import state
from labcal.bench.named_links import named_links
from labcal.bench.stage_off import NOT_YET
from labcal.gui.ipc.answers import Bench, Doubt, Identified, SwitchedOff
from labcal.gui.ipc.client import Client
from labcal.gui.ipc.lab_messages import ReadLab
from labcal.gui.ipc.messages import CheckZero, Identify, SwitchOff
from labcal.gui.ipc.wire import Fault
from labcal.gui.translations.sentences import in_words
from labcal.gui.translations.translate import translated
from labcal.gui.viewmodels.answers_again import LIFTED
from labcal.gui.viewmodels.being_asked import being_asked
from labcal.gui.viewmodels.beside_off import read_beside_off
from labcal.gui.viewmodels.by_hand import by_hand_words
from labcal.gui.viewmodels.earlier_supplies import EarlierSupplies
from labcal.gui.viewmodels.known_lab import KnownLab, supplies
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_heard import looked_at, named_before, wrong
from labcal.gui.viewmodels.lab_now import LabNow, mark_of, off_words, platform_mark, platform_said
from labcal.gui.viewmodels.lab_off import coils_ended, switched_off
from labcal.gui.viewmodels.lab_watch import LabWatch
from labcal.gui.viewmodels.left_without_end import LeftWithoutEnd
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.stood_before import StoodBefore

OFF_WAITS_MS = 4000  # a run has this long to bring the coils to zero itself
STANDS_S = 30.0  # and where they are there this long to end: a large platform comes to rest, the reference is asked
STOPS_S = 8.0  # a platform that no run has is seen to stand by then, where it can be reached
READ_AFTER = ("coil-", "reference", "platform", "polarity")  # roles that tell, after a zero, whether hands may go in
OF_SIMULATED = ("coil-", "platform")  # the same of a simulated bench


class KnowsLab(Protocol):
    """What is known of the lab, and who may be asked to do something to it."""

    bench: str
    facts: Bench | None
    lab: LabViewModel
    run: RunViewModel
    kept: KnownLab
    watch: LabWatch
    left: LeftWithoutEnd
    bench_worker: Client
    off_worker: Client

    @property
    def fault(self) -> SignalInstance:
        """Of anything that has no card of its own."""

    @property
    def fault_over(self) -> SignalInstance:
        """What such a card said is so no longer."""

    @property
    def known(self) -> state.LabState | None:
        """As a worker sent it last."""

    def now_s(self) -> float:
        """On the clock of what was read."""

    def by_hand(self) -> tuple[str, ...]:
        """The supplies that a person has to switch off."""

    def take_lab(self, known: state.LabState, *, lifted: bool = False) -> None:
        """From here on this is how the lab is."""

    def take_identified(self, said: Identified) -> None:
        """Who answered."""

    def grow_old(self) -> None:
        """Show the lab as it is known now."""


class CoilsOff(QObject):
    """Of a `window`. `unconfirmed`: the card that says that the coils are not known to be at zero; `turning`: that the
    platform may turn still.
    """

    def __init__(self, window: KnowsLab) -> None:
        super().__init__()
        self._window, self.earlier = window, EarlierSupplies(window)
        self.unconfirmed: Fault | None = None
        self.turning: Fault | None = None
        self._in_run: Fault | None = None  # `unconfirmed`, where a run that goes on lost a supply
        self.pressed = ""  # by the clock on the wall; "" once each coil was read back at zero since
        self.warned = ""  # what the line below says of it
        self._ordered_s, self._looked = 0.0, False
        self._stop_due_s = 0.0  # a platform that is read to turn after that is told again to stop
        self._stood = StoodBefore()
        self._report: tuple[str, str, str] | None = None  # coils, time and all of it, where the platform is to come
        self._off_s: float | None = None  # when it was said last; None once the platform was seen to stand
        window.watch.beside_off = self._beside
        self.force_timer = QTimer(self, interval=OFF_WAITS_MS, singleShot=True)
        self.force_timer.timeout.connect(self._by_force)

    def order(self) -> None:
        """Every coil to zero now. A run that does not get there itself is ended, and switched off."""
        window, self._ordered_s, self._looked = self._window, time.monotonic(), False
        self._off_s = self._ordered_s
        self.pressed = time.strftime("%H:%M:%S") if window.bench else ""
        window.watch.stop()
        window.kept.order(window.now_s())
        if window.run.alive:
            window.run.abort()
            self.force_timer.start()
        elif window.bench:
            self.switch_off()
        else:
            window.kept.answered()
            window.lab.update(message=self.tr("Coils off: no bench is open, this window drives no coil."))

    def _by_force(self) -> None:
        """A run that has brought the coils to zero is left to its end: it stops the platform, asks the reference."""
        if not self._window.run.alive:
            return None
        if self._window.kept.reached_zero() and time.monotonic() - self._ordered_s < STANDS_S:
            return self.force_timer.start()
        self._stood.run_over(time.monotonic())
        self._window.bench_worker.kill()
        return self.switch_off()

    def switch_off(self, *, read_back: bool = False) -> None:
        """By another worker. `read_back`: by a run that has ended in order, what was at zero then is not missed."""
        window, self._off_s = self._window, time.monotonic()
        self._stop_due_s, self._report = self._off_s + STOPS_S, None
        platform, now = None if window.known is None else window.known.platform, window.lab.state.now
        turned = window.run.alive or now.driven_elsewhere or now.platform_lost
        self._stood.ordered(platform, self._off_s, may_be_turned=turned)
        window.kept.order(window.now_s(), asked=True, read_back=read_back)
        window.lab.update(message=self.tr("Coils off: reading them back …"))
        window.grow_old()
        window.off_worker.request(SwitchOff(window.bench), self._known, self._failed)

    def _known(self, said: SwitchedOff) -> None:
        window = self._window
        names = window.run.links
        words = coils_ended((one.axis, named_links(one.words, names, brief=True)) for one in said.coils)
        zero = all(axis.ok for axis in said.coils)
        window.kept.answered()
        self.earlier.take(said.earlier)
        before = window.known or state.LabState(())
        window.take_lab(switched_off(before, said, window.facts, stood=self._stood.holds))
        if said.doubt or not zero:
            self.warn(Fault("coils", words))
        else:
            old = platform_mark(window.lab.state.now.platform_words)[1] == "old"  # of before it was told to stop
            later = old or (said.platform is not None and said.platform.fault == NOT_YET)  # it is looked at again
            at = time.strftime("%H:%M:%S")
            stands = (
                "" if later and self._stood.holds else window.lab.state.now.platform_words
            )  # nobody has looked since
            report = off_words(words, stands, at, later=later and not self._stood.holds)
            self._report = (words, at, report) if later else None
            window.lab.update(message=report)
            window.grow_old()  # what the line says holds for hands at the same moment
        if said.doubt and zero:
            self.look_again()
        elif zero:
            self.read_again()

    def read_again(self) -> None:
        """What tells whether hands may go in, now that the supplies are at zero: the reference is asked as well."""
        self._window.watch.read_again(self.tellers())

    def _beside(self) -> ReadLab | None:
        """What is read while this is not answered; a run that goes on has its lines."""
        window = self._window
        ordered_s = None if window.run.alive else window.kept.ordered_s
        return read_beside_off(window.bench, window.facts, ordered_s, window.now_s())

    def tellers(self) -> tuple[str, ...]:
        """Who tells how coils and platform are; the reference of another simulated lab tells nothing of a coil."""
        facts = self._window.facts
        roles = OF_SIMULATED if facts is not None and facts.virtual_time else READ_AFTER
        instruments = {} if facts is None else facts.instruments
        return tuple(name for name, one in instruments.items() if one.role.startswith(roles))

    def seen_in(self, now: LabNow) -> LabNow:
        """The lab, with a platform that was told to stop and was not seen to stand since: the line below says so; and
        with who is being asked.
        """
        run, lab = self._window.run, self._window.lab.state
        to_be_seen = (
            self._report is not None and not self._stood.holds and platform_mark(now.platform_words)[1] != "good"
        )
        asked = being_asked(now) if lab.reading or lab.asking or run.state == "starting" else now
        return replace(self.earlier.seen_in(asked), stop_unseen=to_be_seen and not run.alive)

    def says(self, fault: Fault | None) -> bool:
        """Whether this card is about coils that are not known to be at zero, or a platform that may turn still."""
        return fault is not None and fault in (self.unconfirmed, self.turning)

    @property
    def warns(self) -> bool:
        """Whether a card says that the coils are not known to be at zero, or that the platform may turn still."""
        return self.unconfirmed is not None or self.turning is not None

    @property
    def told(self) -> bool:
        """Whether COILS OFF was pressed just now: nobody is sent to press it who has."""
        return bool(self.pressed) or (self._off_s is not None and time.monotonic() - self._off_s <= STOPS_S)

    def to_be_read(self) -> tuple[str, ...]:
        """Who is wrong; and once the coils were read at all, who tells how the lab is: hands go in after a run."""
        window = self._window
        coils = () if window.known is None else window.known.coils
        heard = bool(set(supplies(window.facts).values()) & window.kept.heard)  # all of them may be silent by now
        read = window.left.unconfirmed.left or heard or any(coil.read_s is not None for coil in coils)
        tell = self.tellers() if read and not window.left.objection() else ()  # another process drives it
        return tuple(dict.fromkeys((*wrong(window.known, window.facts), *tell)))

    def look_after(self, before: state.LabState | None) -> None:
        """The lab was read, and was known so `before`: a doubt may be one no more."""
        doubted, known = before is not None and before.reference.verdict == "disagrees", self._window.known
        seen = doubted and known is not None and known.reference.verdict == "agrees"
        if seen or self.unconfirmed is not None:
            self.look_again(seen=seen)

    def look_again(self, *, seen: bool = False) -> None:
        """A doubt that is older than the zero that was read back by now: the reference is asked anew, once.

        `seen`: by what was read just now it is one no more; who keeps the doubt is told by measuring it.
        """
        window = self._window
        known = window.known
        if known is None or not all(coil.zero for coil in known.coils):
            return
        if known.reference.verdict != "disagrees" and not seen:
            return
        if (seen or not self._looked) and not window.off_worker.busy:
            self._looked = True
            window.off_worker.request(Identify(window.bench), self._looked_again, window.fault.emit)

    def _looked_again(self, said: Identified) -> None:
        self._window.take_identified(said)
        if said.doubt is not None and said.doubt.lifted:
            self._window.lab.update(message=translated(str(LIFTED)))

    def zero_in_doubt(self) -> bool:
        """Whether the reference did not see the zero that every supply says: that can be measured again."""
        known = self._window.known
        return known is not None and known.reference.verdict == "disagrees" and all(coil.zero for coil in known.coils)

    def check_zero(self) -> None:
        """Measure now whether it is one; a person asked."""
        window = self._window
        if not window.run.alive and not window.off_worker.busy:
            window.watch.stop()
            window.lab.update(message=self.tr("Checking the zero: coils to zero, then what the reference sees …"))
            window.off_worker.request(CheckZero(window.bench), self._zero_checked, window.fault.emit)

    def _zero_checked(self, said: Doubt) -> None:
        window = self._window
        window.take_lab(looked_at(window.known, said), lifted=said.lifted)
        if said.lifted:
            window.lab.update(message=translated(str(LIFTED)))
        else:
            self.warn(Fault("coils", said.words, details=said.before))

    def _look_at_coils(self) -> None:
        """A supply that answered before and is silent now, in a run or at rest, is the card at once; at a question the
        question says it.
        """
        window, known = self._window, self._window.lab.state.now
        real = window.facts is not None and not window.facts.virtual_time
        lost = known.coil_words.startswith(state.NOT_CONFIRMED) and set(window.by_hand()) & window.kept.heard
        free = self.unconfirmed is None and window.kept.ordered_s is None and window.run.state != "asking"
        if real and lost and free:
            self.warn(Fault("coils", in_words(known.coil_words)))
            self._in_run = self.unconfirmed if window.run.alive else None
        back = window.run.alive and not known.coils_lost and mark_of(known.coil_words)[1] != "bad"
        if self._in_run is not None and self.unconfirmed is self._in_run and back:  # it answers, and the run goes on
            over, self.unconfirmed, self._in_run = self._in_run, None, None
            window.fault_over.emit(over)

    def look_at_platform(self) -> None:
        """One that nobody has seen to stand since it was stopped is a card of its own, until somebody has."""
        if self._window.kept.ordered_s is None and self._window.lab.state.now.coils_at_zero:
            self.pressed = ""
        self._look_at_coils()
        known, facts = self._window.known, self._window.facts
        mark = platform_mark(self._window.lab.state.now.platform_words)[1]
        turns = mark in ("bad", "warning") and facts is not None and not facts.virtual_time  # emulated: it is no more
        if self._window.kept.ordered_s is None and (mark == "good" or self._window.run.alive):
            self._off_s = None
            self._report_whole()
        if self.turning is not None and (not turns or self._window.run.alive or self.unconfirmed is not None):
            over, self.turning = self.turning, None  # a card about the coils says it as well
            self._window.fault_over.emit(over)
        late = self._off_s is not None and time.monotonic() - self._off_s > STOPS_S
        if turns and late and not self._window.run.alive and self.turning is None and self.unconfirmed is None:
            why = "" if known is None or known.platform is None else known.platform.fault.replace(NOT_YET, "")
            unseen = self.tr("Nobody has seen it stand yet: its line may be silent, or kept by another program.")
            remedy = self.tr("Press COILS OFF (F12): it stops the platform as well. Hands off until you see it stand.")
            if self._window.lab.state.now.platform_lost:
                remedy = self.tr(
                    "COILS OFF does not reach it: stop it at its controller. Hands off until you see it stand."
                )
            self.turning = Fault("platform", in_words(why) or unseen, remedy)
            self._window.fault.emit(self.turning)
        self._stop_what_turns()

    def run_ended(self) -> None:
        """A run whose platform nobody has seen to stand since: it is told to stop as soon as its line answers."""
        run, known, facts = self._window.run, self._window.known, self._window.facts
        self._stood.run_over(time.monotonic())
        fault = named_before(run.fault, self._window.kept.heard)
        if fault is not run.fault:
            run.fault = fault
            run.changed.emit()
        platform = None if known is None or facts is None or facts.virtual_time else known.platform
        if platform is not None and platform.moving is not False:
            self._off_s = self._stop_due_s = time.monotonic()

    def _stop_what_turns(self) -> None:
        """What the way out of a run, or COILS OFF, could not reach is read to turn: its line answers now."""
        window = self._window
        platform = None if window.known is None else window.known.platform
        read_s = 0.0 if platform is None else platform.read_s or 0.0
        free = window.kept.ordered_s is None and not window.off_worker.busy and not window.run.alive
        if free and self._off_s is not None and window.lab.state.now.left_turning and read_s > self._stop_due_s:
            window.watch.stop()
            self.switch_off()
            window.lab.update(message=self.tr("The platform kept turning: COILS OFF is given anew, and stops it …"))

    def _report_whole(self) -> None:
        """What became of the platform after COILS OFF, where the line below still says that it is not known."""
        report, self._report = self._report, None
        state = self._window.lab.state
        if report is not None and state.message == report[2]:  # the same sentence, now with its end
            said = off_words(report[0], state.now.platform_words, report[1])
            self._window.lab.update(message=said, said_at=state.said_at)

    def forget(self) -> None:
        """Of another bench nothing was said."""
        self.unconfirmed = self.turning = self._off_s = self._report = None
        self.pressed = ""
        self.earlier.take(())

    def _failed(self, fault: Fault) -> None:
        """Who was to switch them off did not: how they are is not known."""
        known = self._window.kept.missed()
        self._window.kept.answered()
        self._window.take_lab(known)
        self.warn(fault)

    def say_what_is_missed(self) -> None:
        """An answer that is due, and has not come."""
        missed = ", ".join(self._window.by_hand())
        self.warn(Fault("coils", self.tr("No answer yet from: {0}").format(missed)))

    def not_read(self) -> tuple[str, ...]:
        """The supplies that are not to be switched off, as nobody has asked them yet."""
        return self._window.kept.not_read(self._window.facts, self._window.now_s())

    def warn(self, fault: Fault) -> None:
        """Say that the coils may be on, whatever page is open: what to do first, the figures are on the card."""
        remedy = self.tr("By hand: at its panel, or at its mains switch.")
        self.unconfirmed = replace(fault, kind="coils", remedy=remedy)
        self._window.fault.emit(self.unconfirmed)
        self.warned = self._warning(self.unconfirmed)
        self._window.lab.update(message=self.warned)

    def _warning(self, fault: Fault) -> str:
        """For the line below: who is to be switched off now, and whether the platform stands; no age, it would stay."""
        platform = self._window.lab.state.now.platform_words.partition(", read ")[0]
        by_hand = by_hand_words(self._window.by_hand(), pressed=bool(self.pressed))
        return "; ".join(filter(None, (by_hand or fault.text, platform_said(platform, told=self.told))))

    def warn_anew(self) -> None:
        """The line below speaks of now, as the card does, as long as it says that."""
        lab, before = self._window.lab, self.warned
        if self.unconfirmed is not None and before and lab.state.message == before:
            self.warned = self._warning(self.unconfirmed)
            lab.update(message=self.warned, said_at=lab.state.said_at)
