"""A run as the window sees it: states, steps, prompt, measurements, and samples in rings. No widgets."""

from __future__ import annotations

import time
from collections.abc import Collection, Iterable
from typing import Literal

from PySide6.QtCore import QObject, Signal

from labcal.bench.coils.state import LabState
from labcal.gui.ipc.answers import Ended
from labcal.gui.ipc.client import Worker
from labcal.gui.ipc.messages import (
    Abort,
    Answer,
    Command,
    GoOn,
    Note,
    Pause,
    Rejoin,
    ResumeRun,
    RunProcedure,
    Stop,
    Word,
)
from labcal.gui.ipc.wire import BROKEN, MENDED_FIRST, Fault, with_instrument_names
from labcal.gui.viewmodels import began
from labcal.gui.viewmodels.axis_checks import WORST, axis_checks
from labcal.gui.viewmodels.covered import Covered, seen_about
from labcal.gui.viewmodels.drawn import Drawn
from labcal.gui.viewmodels.failed_step import FAILED, asked_text, ended_by_off, said_of
from labcal.gui.viewmodels.hands import STOP, says_hands_off
from labcal.gui.viewmodels.last_readings import LastReadings
from labcal.gui.viewmodels.last_words import last_words
from labcal.gui.viewmodels.moved import Moved
from labcal.gui.viewmodels.number_format import step_title
from labcal.gui.viewmodels.ring_buffer import RingBuffer
from labcal.gui.viewmodels.run_steps import Mark, axis_of, in_turn, left_out, marks_of, name_a_turn, to_come, uses_none
from labcal.gui.viewmodels.run_time import RunTime
from labcal.record.delays import delays_open
from labcal.record.stream import (
    COVERAGE,
    FAULT,
    NOT_USED,
    OTHER_SERIAL,
    Block,
    Event,
    Item,
    Measurement,
    Prompt,
    SegmentClosed,
    SegmentOpened,
    Step,
)

State = Literal["idle", "starting", "running", "asking", "paused", "stopping", "ended"]
ALIVE = ("starting", "running", "asking", "paused", "stopping")
SERIAL = "serial"  # in a prompt's drawing: the one that is to be scanned
STILL_SHOWN = ("step", "names", "skipped", "measurements", "covered", "time", "_turned")  # where it is gone on with
SAID_ELSEWHERE = ("answer", "set-point", "read-back", OTHER_SERIAL)  # by whoever answered, and by the lab's state


class RunViewModel(QObject):
    """Drives one worker. `changed`: anything but samples; `item`: each item that is not samples, as it comes."""

    changed = Signal()
    item = Signal(object)
    ended = Signal(str, str)  # run id, status

    def __init__(self, worker: Worker, nominal_nT_per_unit: float = 1.0) -> None:
        super().__init__()
        self._worker = worker
        worker.items.connect(self._take)
        worker.states.connect(self._take_state)
        self.nominal_nT_per_unit = nominal_nT_per_unit
        self.virtual_time = False  # of the bench: it passes at the pace of the order
        self.links: dict[str, str] = {}  # by instrument: a fault names it, not its link alone
        self.order: RunProcedure | None = None
        self.began = ""  # the time on the wall when it was ordered; once it has an id, what that says
        self.dut, self.reference = RingBuffer(3), RingBuffer(3)
        self.forget()

    def forget(self) -> None:
        """Be as before the first run."""
        self.state: State = "idle"
        self.prompt: Prompt | None = None
        self.fault: Fault | None = None
        self.run_id, self.status, self.message, self.ending = "", "", "", ""
        self.step: Step | None = None
        self.names: tuple[str, ...] = ()
        self.skipped: set[str] = set()
        self.measurements: dict[str, Measurement] = {}
        self.drawn, self.covered = Drawn(), Covered()
        self.segment: str | None = None
        self._turned = self._measures = self._unbegun = False  # in any segment; in this step; ended at its question
        self.goes_on = self._begins = self.by_off = False  # an interrupted run; one of which nothing has come yet
        self.anew = False  # a simulated bench began anew, and nothing was answered since
        self.time = RunTime()
        self._dut_s: float | None = None  # stamp of its last reading
        self.hands_off = self.unread = False  # a person said so, and was asked for nothing since; coils, since it began
        self.lab: LabState | None = None  # by the computer's monotonic clock
        self.unheard = self.pausing = False  # it has not told a window that came back how the lab is; a pause was asked
        self.coils_at_zero: bool | None = None  # when that was read
        self.last, self.moved = LastReadings(), Moved()
        self.dut.clear()
        self.reference.clear()

    @property
    def alive(self) -> bool:
        """Whether a run goes on."""
        return self.state in ALIVE

    @property
    def asks_serial(self) -> bool:
        """Whether the open question is which DUT stands on the platform."""
        return self.prompt is not None and SERIAL in self.prompt.drawing

    def start(self, order: RunProcedure, command: RunProcedure | None = None) -> None:
        """Begin, by `command` where it says more than is kept. One run at a time."""
        self._begin(order, command or order)
        self._begins = True

    def resume(self, run_id: str, order: RunProcedure) -> None:
        """Go on with an interrupted run."""
        kept = {name: getattr(self, name) for name in STILL_SHOWN} | {"drawn": self.drawn.gone_on_with()}
        command = ResumeRun(run_id, order.bench, order.dut, order.pace, order.seed, order.procedure, order.operator)
        used = run_id == self.run_id and not uses_none(self.steps())
        self._begin(order, command, run_id, kept.items() if used else ())
        self.goes_on, self.anew = True, self.virtual_time

    def come_back(self) -> None:
        """Show the run that went on while there was no window; its order comes with it."""
        self.forget()
        self.order, self.state, self.message = None, "starting", self.tr("Coming back to the run that goes on …")
        self.unheard = self.hands_off = True  # as far as this window knows
        self._worker.request(Rejoin(), self._done, self._failed)
        self.changed.emit()

    def _begin(
        self, order: RunProcedure, command: Command[Ended], run_id: str = "", shown: Iterable[tuple[str, object]] = ()
    ) -> None:
        if self.alive:
            raise RuntimeError("a run goes on")
        self.forget()
        vars(self).update(shown)
        self.order, self.state, self.message = order, "starting", self.tr("Asking every instrument who it is …")
        self.run_id, self.began, self.unread = run_id, began.began_at(run_id) or began.now(), True
        self._worker.request(command, self._done, self._failed)
        self.changed.emit()

    def answer(self, text: str) -> None:
        """Answer the prompt that is open."""
        if self.prompt is None:
            return
        self._worker.send(Answer(self.prompt.key, text))
        self.hands_off = says_hands_off(self.prompt.key, text)
        goes_on = self.tr("Hands off: it goes on.") if self.hands_off else self.tr("It goes on.")
        self.anew, self.prompt, self.message = False, None, self.tr("Stopping …") if text == STOP else goes_on
        self._be("running")  # whatever was answered: it may ask something else on its way out

    def pause(self) -> None:
        """Wait where the next step begins, coils at zero."""
        self._worker.send(Pause())
        self.message, self.pausing = self.tr("Pauses where the next step begins."), True
        self.changed.emit()

    def go_on(self) -> None:
        """Go on after a pause."""
        self._worker.send(GoOn())
        self.unread = True
        self._be(self.state)

    def stop(self, *, later: bool = False) -> None:
        """End in order: the procedure undoes what it did, the coils go to zero; `later`: to be gone on with."""
        self._end(Stop(later), self.tr("Stopping …"))

    def abort(self) -> None:
        """Coils to zero before anything else; the run ends."""
        self.by_off = True
        self._end(Abort(), self.tr("Coils off: the run ends …"))

    def _end(self, word: Word, message: str) -> None:
        if self.alive:
            self._worker.send(word)
            self._unbegun, self.prompt, self.message = self.prompt is not None and not self._measures, None, message
            self._be("stopping")

    def note(self, text: str, **data: str) -> None:
        """A remark into the record; `data` goes with it."""
        if self.alive and text.strip():
            self._worker.send(Note(text.strip(), data))

    def left_s(self) -> float | None:
        """Lab time that is left of the run."""
        return None if self.step is None else self._of_it_left(self.step.left_s)

    def step_left_s(self) -> float | None:
        """Lab time that is left of this step."""
        return None if self.step is None or self.step.step_s is None else self._of_it_left(self.step.step_s)

    def needed_s(self) -> float | None:
        """Lab time until the next step that begins with a question; None where none is to come."""
        return None if self.step is None or self.step.needed_s is None else self._of_it_left(self.step.needed_s)

    def wall_s(self, lab_s: float | None) -> float | None:
        """How long that takes by the clock on the wall; None where that cannot be said."""
        speed = self.time.pace.of(self.order, virtual_time=self.virtual_time)
        return lab_s / speed if lab_s is not None and speed and self.state == "running" else None

    def promised_s(self, what: str, lab_s: float | None) -> float | None:
        """As `wall_s`, of `what` is to come: once it was said it stands, but for what a person takes."""
        more_s = self.time.longer_s(to_come(self.names, self.step, what))
        wall_s = self.wall_s(lab_s and lab_s + more_s)
        return self.time.promised_s(what, wall_s) if wall_s else wall_s

    def _of_it_left(self, seconds: float) -> float | None:
        return self.time.left_s(seconds) if self.alive and self.state != "starting" else None

    def share(self) -> float:
        """What is over of the whole, 0 to 1: by lab time, or where no plan states that by steps."""
        if self.step is None or self.status == "finished":
            return float(self.status == "finished")
        by_time = self.time.share()
        return self.steps_done() / self.step.total if by_time is None else by_time

    def steps(self) -> list[tuple[str, Mark]]:
        """All steps known, with their marks."""
        if self.step is None:
            return []
        at = self.names.index(self.step.name) if self.step.name in self.names else len(self.names)
        over = self.state in ("ended", "starting")  # it broke off there, and nothing of it goes on yet
        broken: Mark = "done" if self.status == "finished" else "next" if self._unbegun else "broken"
        left = over and self.status.startswith("interrupted")
        marks = marks_of(self.names, at, broken if over else "now", self.measurements, self.skipped, broken_off=left)
        return list(zip(self.names, marks, strict=True))

    def steps_done(self) -> int:
        """How many steps are over: done, kept from before an interruption, or left out."""
        return sum(mark in ("done", "skipped") for _, mark in self.steps())

    def left_out(self) -> list[str]:
        """Steps that were skipped, or broken off and not repeated, in their order; and delays that no turns told."""
        return [*left_out(self.names, self.measurements, self.skipped), *delays_open(self.names, self.measurements)]

    def axis_light(self, axis: str) -> str:
        """The worst verdict of what was measured about one body axis; "" where nothing was yet."""
        return max(self.axis_checks(axis).values(), key=WORST.index)

    def axis_checks(self, axis: str) -> dict[str, str]:
        """The worst verdict of each of `AXIS_CHECKS` that this run makes about one body axis; "" where none is yet."""
        return axis_checks(axis, self.measurements, closes=not self.names or f"closure-{axis}" in self.names)

    def looks_at_axes(self) -> bool:
        """Whether turns about body axes are looked at, or are to be; what stands still at many angles has no light."""
        return name_a_turn((*self.names, *self.drawn.now)) or any(map(self.axis_light, "xyz"))

    def turns(self) -> bool:
        """Whether a turn was recorded, or is to come: else circle and axes have nothing to say."""
        return self._turned or name_a_turn(self.names)

    @property
    def axis(self) -> str:
        """The body axis that is mounted and turned about now; "" where no step says so."""
        return axis_of(self.segment or (self.step.name if self.step else ""))

    def coverage(self) -> float:
        """The part of the circle, 0 to 1, that this turn has seen; in other steps, what those about its axis have."""
        seen = self.covered.part()
        return seen if in_turn(self.segment, self.step) else max(seen, seen_about(self.axis, self.measurements))

    def _take_state(self, lab: LabState) -> None:
        self.lab, self.unheard = lab, False
        self.unread = self.unread and (self.state == "paused" or any(coil.read_s is None for coil in lab.coils))
        self.coils_at_zero = lab.at_zero(time.monotonic())
        self.changed.emit()

    def _take(self, items: tuple[Item, ...]) -> None:
        if self._begins:  # here its record does; until now it was asked who answers
            self._begins, self.began = False, began.now()
        for item in items:
            self._one(item)
        if not all(isinstance(item, Block) for item in items):
            self.changed.emit()

    def _one(self, item: Item) -> None:
        if isinstance(item, Block):
            return self._samples(item)
        self.time.see(item.t_s)
        self.moved.see(item)
        match item:
            case Step():
                self.step, self.names = item, item.names or self.names
                self._measures = self._unbegun = False
                self.time.begin(item)
                self.covered.begin()
                self._running(step_title(item.name))
            case Measurement():
                self.measurements[item.name] = item
            case Prompt():
                if item.key.startswith(FAILED):  # what was seen of this turn counts no more
                    self.covered.begin()
                    self._forget((item.key.removeprefix(FAILED),))
                self.time.waits(item.t_s)
                if self.state != "stopping":  # whoever wants the end is asked nothing any more
                    self.prompt, self.state, self.message = item, "asking", asked_text(item)
            case SegmentOpened():
                self.segment, self._measures = item.segment.id, True
                self.covered.begin()
                self._forget((item.segment.id,))  # as it was before, where it is begun again
                self.drawn.begin(item.segment.id)
                self._turned = self._turned or item.segment.kind == "rotation"
                self._running(self.tr("{0} begun").format(step_title(item.segment.id)))
            case SegmentClosed():
                self.segment = None
            case Event():
                self._event(item)
        return self.item.emit(item)

    def _running(self, message: str) -> None:
        if self.state != "stopping":  # else it was on its way before the end was ordered
            self.message = message
        if self.state in ("starting", "asking", "paused"):
            self.state = "running"

    def _event(self, event: Event) -> None:
        if event.kind == "answer":
            self.time.waits_no_more(event.t_s)
            self.hands_off = says_hands_off(key := str(event.data.get("key")), event.text)  # also before it came back
            if key.startswith(FAILED) and event.text == "retry":
                self.time.again(event.t_s)
        if event.kind == "pause":
            self.unread = not (paused := event.text != "goes on") and self.unread  # a pause reads them
            self.pausing = self.hands_off = False
            self.time.waits(event.t_s) if paused else self.time.waits_no_more(event.t_s)
            if self.state != "stopping":
                self.state, self.message = ("paused", self.tr("Paused")) if paused else ("running", self.tr("Goes on"))
        elif event.kind == "skip":
            self.skipped.add(str(event.data.get("step", "")))
        elif event.kind == COVERAGE:
            self.covered.missed(event)
            self._running(said_of(event, self.links))
        elif event.kind == NOT_USED:
            gone = list(event.data["segments"])  # their axis is redone
            looks = (f"{look} {axis}" for look in ("delay", "closure") for axis in {name[:1] for name in gone})
            self._forget(gone, looks)
        elif event.kind not in SAID_ELSEWHERE:
            if event.kind == FAULT and "step" in event.data:
                self.time.fails(event.t_s)
            self.message = said_of(event, self.links)

    def _forget(self, segments: Collection[str], looks: Iterable[str] = ()) -> None:
        """Nothing that was seen or measured of these counts any more."""
        self.drawn.forget(segments)
        self.covered.forget(segments)
        gone = (*(f"{segment}:" for segment in segments), *looks)
        self.measurements = {n: m for n, m in self.measurements.items() if not n.startswith(gone)}

    def _samples(self, block: Block) -> None:
        if len(block) == 0:
            return
        self.time.see(float(block.t_s[-1]))
        self.last.take(block, self.time.seen_s)
        if block.stream == "dut":
            values = block.values * self.nominal_nT_per_unit
            self.dut.push(block.t_s, values)
            self._dut_s = float(block.t_s[-1])
            if self.segment is not None:
                self.drawn.now[self.segment].push(block.t_s, values)
        elif block.stream == "reference" and block.values.shape[1] == 3:
            self.reference.push(block.t_s, block.values)
        elif block.stream == "angle" and self.segment is not None:
            self.covered.turned(block.t_s, block.values[:, 0], self._dut_s)

    def _be(self, state: State) -> None:
        self.state = state
        self.changed.emit()

    def _done(self, result: Ended) -> None:
        self.run_id, self.status, self.ending = result.run_id, result.status, result.ending
        self.began = began.began_at(self.run_id) or self.began
        self.fault = with_instrument_names(result.fault, self.links) if result.fault else None
        self._over()

    def _failed(self, fault: Fault) -> None:
        self.fault = with_instrument_names(ended_by_off(fault) if self.by_off else fault, self.links)
        left = fault.kind in BROKEN or (self.goes_on and fault.kind in MENDED_FIRST)  # its record says so, or said it
        self.status = "interrupted" if left else f"failed: {self.fault.text}"
        self._over()

    def say_how_it_ended(self) -> None:
        """In the language that the window speaks."""
        by_off = self.by_off and self.status != "finished"
        self.message = last_words(self.order, self.began, self.ending or self.status, self.links, by_off=by_off)

    def _over(self) -> None:
        self.unheard, self.pausing, self.prompt, self.segment = False, False, None, None
        self.say_how_it_ended()
        self._be("ended")
        self.ended.emit(self.run_id, self.status)
