"""What the pages share: the workers, the choices made, the lab's state, the run that goes on."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from traceback import format_exception
from types import TracebackType
from typing import TypeVar

from PySide6.QtCore import QObject, QSettings, QTimer, Signal

from labcal.bench import serials
from labcal.bench.coils import state
from labcal.files.atomic import absolute
from labcal.gui.ipc.answers import Bench, Identified, InstrumentAnswer
from labcal.gui.ipc.client import WATCHED, Client
from labcal.gui.ipc.lab_messages import InstrumentRead
from labcal.gui.ipc.messages import Command, GoesOn, ListCalibrations, ReadBench, RunProcedure
from labcal.gui.ipc.record_messages import TellTurned
from labcal.gui.ipc.wire import BROKEN, Fault, fault_of
from labcal.gui.translations.sentences import BenchFile, in_words
from labcal.gui.viewmodels import lab_heard
from labcal.gui.viewmodels.archived import ArchivedViewModel
from labcal.gui.viewmodels.begun_on import another_bench
from labcal.gui.viewmodels.bench_of_run import links_of, stands_on
from labcal.gui.viewmodels.coils_off import CoilsOff
from labcal.gui.viewmodels.handed_out import HandedOut
from labcal.gui.viewmodels.hands_now import dated
from labcal.gui.viewmodels.known_lab import KnownLab, supplies
from labcal.gui.viewmodels.lab import LabViewModel
from labcal.gui.viewmodels.lab_now import OFF, reference_U
from labcal.gui.viewmodels.lab_watch import LabWatch
from labcal.gui.viewmodels.last_readings import LastReadings
from labcal.gui.viewmodels.left_without_end import LeftWithoutEnd
from labcal.gui.viewmodels.login import LoginViewModel
from labcal.gui.viewmodels.named_serials import NamedSerials
from labcal.gui.viewmodels.one_dut import OneDut
from labcal.gui.viewmodels.operator_name import name_objection
from labcal.gui.viewmodels.path import Next, PathViewModel, Wanted
from labcal.gui.viewmodels.platform_there import platform_there
from labcal.gui.viewmodels.reference_again import seconded
from labcal.gui.viewmodels.refused_bench import RefusedBench
from labcal.gui.viewmodels.run import RunViewModel
from labcal.gui.viewmodels.run_order import run_order
from labcal.gui.viewmodels.said_for_now import SaidAtTheEnd, SaidForNow
from labcal.gui.viewmodels.said_no_more import SaidNoMore
from labcal.gui.viewmodels.scan import ScanViewModel
from labcal.gui.viewmodels.study import StudyViewModel
from labcal.gui.viewmodels.watched import as_watched
from labcal.gui.viewmodels.what_happens import at_hands, hands_at
from labcal.gui.viewmodels.window_settings import window_settings

R = TypeVar("R")
AGES_MS = 250  # what was read grows old


class AppState(QObject):
    """Workers: `quick` for what is short, `bench` for the run, `fit` for fits and the loop, `off` for Coils off."""

    fault = Signal(object)  # of anything that has no card of its own
    fault_over = Signal(object)  # what such a card said is so no longer
    bench_changed = Signal()
    page_requested = Signal(str)  # a page is asked for, by name
    next_requested = Signal()
    procedure_requested = Signal()  # `wanted` is to be chosen on the Run page
    store_changed = Signal()
    calibrations_changed = Signal(str)  # the path of the one that is new
    report_requested = Signal(object)  # a Fault, for a problem report

    def __init__(self, settings: QSettings | None = None, *, watched: bool = False) -> None:
        super().__init__()
        self.settings = settings or window_settings()
        self.quick_worker, self.bench_worker = Client(self), Client(self, WATCHED) if watched else Client(self)
        self.fit_worker, self.second_fit_worker, self.off_worker, self.watch_worker = (Client(self) for _ in range(4))
        self.lab, self.run = LabViewModel(), RunViewModel(self.bench_worker)
        self.scan_vm, self.study_vm = ScanViewModel(self.lab), StudyViewModel(self.fit_worker, self.second_fit_worker)
        self.login = LoginViewModel(self.lab, self.run)
        self.path = PathViewModel(self.lab, self.run, self.study_vm, HandedOut(self.settings))
        self.archived = ArchivedViewModel(Client(self))
        to_be_read, coils = lambda: self.off.to_be_read(), lambda: supplies(self.facts).values()
        self.watch = LabWatch(self.watch_worker, self.lab, self._may_be_read, to_be_read, self._take_read, coils)
        self.one_dut = OneDut(self.settings, self.lab, self.run, (self.study_vm, self.path, self.scan_vm))
        self.study_vm.drafted.connect(self.calibrations_changed)
        self.study_vm.added.connect(self.store_changed)
        self.study_vm.drafted.connect(lambda _: self.request(ListCalibrations(), self.path.take_calibrations))
        self.facts: Bench | None = None
        self.named_serials = NamedSerials(self.lab, self.run, lambda: self.facts)
        self.answered: dict[str, InstrumentAnswer] = {}  # by instrument, when they were last asked
        self.path.another_bench = lambda one: another_bench(one, self.facts, self.answered)
        self.bench = ""
        self.wanted: Wanted | None = None
        self.said_for_now, self._said_no_more = SaidForNow(self.lab), SaidNoMore(self.lab, self.run)
        self.said_at_the_end = SaidAtTheEnd(self.lab, self.run, self.said_for_now)
        self.kept = KnownLab()
        self._taken: state.LabState | None = None  # from the run
        self.warning_shown = False  # the card that says so
        self.age_timer = QTimer(self, interval=AGES_MS)
        self.age_timer.timeout.connect(self.grow_old)
        self.age_timer.start()
        self.off: CoilsOff = CoilsOff(self)
        self.left = LeftWithoutEnd(self)
        self.refused = RefusedBench(self.lab, self.fault.emit, self.fault_over.emit)
        self.left.changed.connect(lambda: self.grow_old())
        self.run.changed.connect(self._update_run)
        self.run.changed.connect(lambda: self.watch.prepare(self.bench if self.run.lab and self.run.alive else ""))
        self.run.ended.connect(self._ended)
        name = str(self.settings.value("operator", ""))
        self.lab.update(operator=name, operator_objection=name_objection(name))

    def request(self, command: Command[R], then: Callable[[R], object]) -> None:
        """Ask the quick worker; a fault comes up as a card."""
        self.quick_worker.request(command, then, self.fault.emit)

    def open_bench(self, bench: str) -> None:
        """Take `bench` as the bench from here on, unless a run goes on or it cannot be read."""
        if self.run.alive:
            return self.fault.emit(Fault("input", self.tr("A run goes on; open another bench after it.")))
        path = str(absolute(Path(bench)))
        self.bench = self.bench or path  # what Coils off asks for even where it cannot be read
        self.lab.update(message=self.tr("Opening {0} …").format(Path(path).name), opening=True)
        self.left.look_early()
        return self.quick_worker.request(ReadBench(path), partial(self.bench_known, path), self.refused.say)

    def bench_known(self, path: str, facts: Bench) -> None:
        """Take what the file at `path` says."""
        if path != self.bench:
            self.forget()
        elif self.facts is not None and links_of(facts) != self.run.links:
            self._forget_readings()
        self.refused.put_away()
        self.lab.update(message="", opening=False)
        self.bench, self.facts, self.answered = path, facts, {}
        self.settings.setValue("bench", path)
        BenchFile.name = Path(path).name
        stands_on(self.run, facts)
        self.lab.update(bench=facts.name, simulated=facts.simulated, platform_anew=False)
        self.propose_dut()
        self.grow_old()
        self.left.look()
        self.off_worker.request(ReadBench(path), lambda _: None, lambda _: None)  # loaded before it is needed
        self.bench_changed.emit()

    def propose_dut(self) -> None:
        """Once, until somebody says which: the DUT of the run to be gone on with, else the one of the bench file."""
        if self.facts is None:
            return
        serial = self.one_dut.propose(self.path.broken_off(self.facts.simulated) or self.facts.dut.serial)
        self.lab.update(dut_serial=serial, dut_objection=self.serial_objection(serial))

    def come_back(self, worker: int) -> None:
        """Take up the run that the process `worker` went on with while there was no window."""
        self.bench = str(self.settings.value("bench", "") or "")  # what Coils off asks for should it not answer
        self.bench_worker.came_back.connect(self._came_back)
        self.bench_worker.come_back(worker)
        self.run.come_back()

    def _came_back(self, to: GoesOn) -> None:
        self.run.order, self.run.began = to.order, to.began
        self.bench_known(to.order.bench, to.bench)
        self.set_identity(dut=to.order.dut or None, operator=to.order.operator or None)

    def forget(self) -> None:
        """Know nothing of the lab: what was read on another bench says nothing of this."""
        self._forget_readings()
        for one in (self.off, self.left, self.named_serials, self.watch, self._said_no_more.back):
            one.forget()
        self.one_dut.proposed = False

    def _forget_readings(self) -> None:
        """They came over the links of one bench; the lab of the run that ended there is not taken once more."""
        self._taken, self.kept, self.run.last = self.run.lab, KnownLab(), LastReadings()

    def take_identified(self, said: Identified) -> None:
        """Who answered, and who did not."""
        self.answered = lab_heard.plug_or_power({one.name: one for one in said.instruments}, self.kept.heard)
        self.named_serials.take(self.answered)
        known, lifted = lab_heard.identified(self.known, said)
        self.take_lab(known, lifted=lifted)

    def _take_read(self, said: tuple[InstrumentRead, ...]) -> None:
        self.answered |= lab_heard.plug_or_power(lab_heard.answers(said), self.kept.heard)
        self.named_serials.take(self.answered)
        before, known = self.known, lab_heard.read(self.known, said)
        simulated = self.facts is None or self.facts.virtual_time  # each reading of one is of another lab
        ambient, off = self.kept.ambient_nT(self.facts, self.now_s()), self.kept.off(self.facts, self.now_s())
        if simulated and lab_heard.began_anew(before, known):
            self.lab.update(platform_anew=True)
        self.take_lab(known if simulated else seconded(known, said, ambient, off))
        self.off.look_after(before)

    def _may_be_read(self) -> str:
        """The bench, where nobody but this window has to do with it now; "" else."""
        return "" if self.facts is None or self.run.alive or self.kept.ordered_s else self.bench

    def open_procedure(self, names: str, wanted: Wanted | None = None) -> None:
        """Show the form of the first procedure there is of `names`, apart by |; as it is `wanted`, with its plan."""
        self.wanted = wanted or Wanted(names)
        self.page_requested.emit("Run")
        self.procedure_requested.emit()

    def take_wanted(self) -> Wanted | None:
        """The procedure that is to be shown; it is shown once."""
        wanted, self.wanted = self.wanted, None
        return wanted

    def open_study(self, run: str) -> None:
        """Show `run` on the Fit page; the DUT at the top stays."""
        self.page_requested.emit("Fit")
        self.one_dut.open(run)

    def go(self, to: Next) -> None:
        """Open the page of what is next, with its run, and begin it; Calibrate shows the preflight."""
        if (broken := to.resumes) is not None:
            return self.resume(broken.run_id, broken.procedure, broken.dut_serial)
        if to.run:
            self.one_dut.open(to.run)
            self.study_vm.begin("" if to.waits else to.page)
        if to.page == "Run" and not self.run.alive:
            self.open_procedure("preflight")
        if to.closes:
            self.path.close(to.closes)
            self.set_identity(dut="")
            self.lab.update(message="")
        return self.page_requested.emit(to.page)

    def set_identity(self, *, dut: str | None = None, operator: str | None = None) -> None:
        """Take the DUT's serial or the operator's name."""
        if dut is not None:
            self.one_dut.stated = True
            self.lab.update(dut_serial=dut.strip(), dut_objection=self.serial_objection(dut.strip()))
        if operator is not None:
            name = operator.strip()
            self.lab.update(operator=name, operator_objection=name_objection(name))
            self.settings.setValue("operator", name)
        self.said_for_now.put_away()

    def scan(self, serial: str) -> None:
        """A scanner read this where no field waited for it: is it the DUT's serial? A run may ask for it."""
        self.said_for_now.put_away()
        if self.run.asks_serial and self.path.may_answer():
            self.run.answer(serial)
        elif self.run.alive:
            words = self.tr("Scanned {0}; a run goes on, its DUT stays.")
            kept_out = self.tr("Scanned {0}; hands off: scan again once hands may go in.")
            self.lab.update(message=(kept_out if self.run.asks_serial else words).format(serial))
        elif said := self.serial_objection(serial):
            self.said_for_now.say(self.tr("✕ Scanned, and not taken: {0}").format(said))
        elif serial == self.lab.state.dut_serial:
            self.said_for_now.say(self.tr("Scanned {0}: it is the DUT at the top.").format(serial))
        else:
            self.scan_vm.ask(serial)

    def serial_objection(self, serial: str) -> str:
        """Why this is no serial on this bench; "" where it is one."""
        return in_words(serials.objection(serial, serials.USUAL if self.facts is None else self.facts.serial_pattern))

    def objection(self) -> str:
        """What is missing before a run may start; "" where nothing is."""
        state = self.lab.state
        if not self.facts and state.opening:
            return self.tr("The bench is being opened …")
        if not self.facts:
            return self.tr("Open a bench first: yours, or the simulated lab.")
        if said := self.left.objection():
            return said
        if not state.dut_serial:
            return self.tr("Scan or type the DUT's serial at the top.")
        if said := self.serial_objection(state.dut_serial) or self.login.objection():
            return said
        if not state.operator:
            return self.tr("Type the operator's name at the top.")
        if self.scan_vm.asks:
            return self.tr("Answer first whether {0} is the DUT.").format(self.scan_vm.serial)
        return state.operator_objection

    def start(self, procedure: str, given: dict[str, str]) -> None:
        """Run a procedure for the DUT and the operator above."""
        study, self.one_dut.stated = self.study_vm, True
        after = study.run if procedure == study.wanted else ""
        self.run.start(replace(self._order(procedure, given), after=after))

    def resume(self, run_id: str, procedure: str, dut: str) -> None:
        """Go on with an interrupted run of `dut`; you are asked whether it still stands there."""
        if said := self.login.objection() or self.left.objection():
            return self.fault.emit(Fault("input", said))
        self.set_identity(dut=dut)
        elsewhere = run_id != self.run.run_id  # by another window, or long ago
        self.run.resume(run_id, self._order(procedure, {}))
        if not (drawn := self.run.drawn).earlier and elsewhere:
            self.quick_worker.request(TellTurned(run_id), drawn.take_earlier, lambda fault: None)
        return self.page_requested.emit("Run")

    def _order(self, procedure: str, given: dict[str, str]) -> RunProcedure:
        return run_order(procedure, given, self.bench, self.lab.state, self.settings)

    def _ended(self, run_id: str, status: str) -> None:
        """Where the worker died, or no coil was read back at zero: to zero with them. What was wanted is added."""
        self.off.force_timer.stop()  # the next run is not to pay for this one
        if self.facts is None and self.bench:  # of a run that could not be come back to
            self.open_bench(self.bench)
        order = self.run.order
        if status == "finished" and order is not None and self.study_vm.add(order.procedure, run_id, order.after):
            self.page_requested.emit("Loop")
        self.off.run_ended()
        self.left.look()
        fault = self.run.fault
        if fault is not None and (blamed := lab_heard.blamed(self.known, fault, self.facts)) is not None:
            self.take_lab(blamed)
        if fault is not None and (fault.kind in BROKEN or self.run.coils_at_zero is False):
            return self.off.switch_off(read_back=fault.kind not in BROKEN)
        self.kept.answered()
        return self.watch.look()  # what the run read last is not to grow old meanwhile

    def still_live(self) -> bool:
        """Whether a supply fell silent with a current, or a platform may turn that was to stand: that card stays."""
        return bool(self.lab.state.now.silent_with_current) or self.off.turning is not None

    def now_s(self) -> float:
        """On the computer's monotonic clock."""
        return time.monotonic()

    def by_hand(self) -> tuple[str, ...]:
        """The supplies that a person has to switch off, by name."""
        return self.kept.by_hand(self.facts, time.monotonic())

    def coil_words(self) -> str:
        """What may be said of the coils now."""
        return as_watched(self.lab.state.now).coil_words or state.NOT_READ

    def platform_words(self) -> str:
        """What may be said of the platform now."""
        return platform_there(self.lab.state.now, self.facts)

    def hands(self) -> tuple[str, str]:
        """Whether hands may go near now, in words, and the state that goes with it."""
        return dated(*hands_at(self.run, self.lab.state.now), self.lab.state.now)

    @property
    def known(self) -> state.LabState | None:
        """The lab as a worker sent it last, by the computer's monotonic clock."""
        return self.kept.state

    def take_lab(self, known: state.LabState, *, lifted: bool = False) -> None:
        """From here on this is how the lab is; `lifted`: a doubt about zero was, however long ago it was read."""
        self.kept.take(known, time.monotonic())
        self.grow_old(lifted)

    def grow_old(self, lifted: bool = False) -> None:
        """Show the lab as it is known now. Who said that the coils are not at zero says so no longer once they are."""
        known = self.kept.now(self.facts, time.monotonic(), driven=self.run.alive, **self.watch.patience())
        now = self.off.seen_in(self.watch.seen_in(self.left.seen_in(known)))
        hands = at_hands(self.run, now, self.facts)  # with it, not after it: no instant contradicts itself
        self.lab.update(now=now, field_U_nT=reference_U(self.facts, now.field_measured_nT), **hands)
        if self.kept.late(self.facts, time.monotonic()) and not self.kept.warned:
            self.kept.warned = True
            self.off.say_what_is_missed()
        if self.off.unconfirmed is not None and (lifted or now.coils_at_zero):
            over, self.off.unconfirmed = self.off.unconfirmed, None
            self.fault_over.emit(over)
            if not lifted:  # the supplies say so, and the reference has not been asked since
                self.off.read_again()
        self.off.look_at_platform()
        self.off.warn_anew()
        self._said_no_more.look("" if self.off.unconfirmed else self.off.warned)

    def _update_run(self) -> None:
        """What the run knows, for the frame."""
        if (run := self.run).state == "idle":
            return
        if run.lab is not None and run.lab is not self._taken:
            self._taken, self.kept.asked = run.lab, False
            self.take_lab(self.kept.of_run(run.lab, self.facts, self.now_s()))
        elif self.lab.state.now.driven is not run.alive:  # what it asks at once is not shown beside the lab of before
            self.grow_old()
        measuring = self.tr("hands off, measuring") if run.segment is not None else ""
        off = OFF if measuring and run.state == "running" else ""
        waits = {"asking": self.tr("your turn"), "paused": self.tr("paused"), "running": measuring}.get(run.state, "")
        hands = at_hands(run, self.lab.state.now, self.facts)
        self.lab.update(message=self.said_at_the_end.line(), waiting=waits, waiting_state=off, **hands)

    def handle_exception(self, kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
        """What broke in the window itself is a card as well; the window goes on."""
        details = "".join(format_exception(kind, error, trace))
        print(details, file=sys.stderr)
        self.fault.emit(fault_of(error, details))

    def close(self) -> None:
        """Hang up everywhere: a run aborts, its coils go to zero. Nothing is begun after that."""
        for ends in (self.off.force_timer.stop, self.age_timer.stop, self.watch.timer.stop, self.left.close):
            ends()
        self.bench_worker.close(8000)
        self.watch.stop()
        fits = self.fit_worker, self.second_fit_worker
        for worker in (self.quick_worker, *fits, self.off_worker, self.watch_worker, self.archived):
            worker.close(500)
