"""Drives a procedure: writes what it yields, answers what it asks, and brings the bench to rest however it ends."""

from __future__ import annotations

import queue
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass, field, replace
from itertools import chain
from typing import Any

from labcal.bench.bench import Bench
from labcal.bench.clock import VirtualClock
from labcal.bench.coils.state import NOT_CONFIRMED, LabState
from labcal.bench.named_serials import other_serials
from labcal.bench.steps import Procedure, read_back
from labcal.errors import InputError, InstrumentError, Stopped
from labcal.record.stream import FAULT, NOT_KEPT, Block, Event, Item, ModeChanged, Prompt, SegmentOpened, Step
from labcal.runner.another_dut import AnotherDut
from labcal.runner.awaited import Awaited
from labcal.runner.control import Aborted, Control, Left, NotKept, stopped_by
from labcal.runner.meanwhile import Meanwhile
from labcal.runner.prompts import Answer, checked
from labcal.runner.read_twice import read_twice
from labcal.runner.said_of_faults import in_a_sentence, what_else
from labcal.runner.shifted import shifted

LISTEN_S = 0.2  # while a person thinks, the streams are still written down
SHOWN_S = 0.5  # while something takes long: how the lab is, as far as that was read
PROMPT_S = 1.0  # what is reported later than this says so
UNDONE_S = 0.3  # that a procedure is given, once it was asked to end, before its coils are taken to zero
BUSY = ("store slow", "store locked")  # faults of a store that may go away by themselves, with nothing lost
CLOCK_BACK = "clock set back"
CLOCK_BACK_S = 1.0  # the wall clock may be slewed by this much against the bench's own
OnItem = Callable[[Item], None]
Show = Callable[[LabState], None]


@dataclass(frozen=True, slots=True)
class Ending:
    """How a run ended. `status` is the contract's word; `fault` what went wrong, None where nothing did.

    `by_store`: what went wrong is that the record was not kept.
    """

    status: str
    fault: BaseException | None = None
    by_store: bool = False


@dataclass
class Drive:
    """One procedure on one bench into one record. `offset_s` shifts the bench's time onto the run's.

    `kept` raises as `write` does where what was written does not reach the disk; neither ever waits for it.
    """

    bench: Bench
    write: Callable[[Item], None]
    answer: Answer
    control: Control = field(default_factory=Control)
    on_item: OnItem = lambda item: None
    show: Show = lambda state: None  # how the lab is, by the computer's monotonic clock
    offset_s: float = 0.0
    kept: Callable[[], None] = lambda: None
    _reply: str | None = field(default=None, init=False)
    state: LabState | None = field(default=None, init=False)  # of the lab, as the run left it, on the bench's clock
    read_at_s: float = field(default=0.0, init=False)
    _at_zero: bool = field(default=False, init=False)
    _said: str = field(default="", init=False)
    _rows_wait: bool = field(default=False, init=False)
    _end_requested_s: float | None = field(default=None, init=False)
    _shown_s: float = field(default=0.0, init=False)  # when the lab was shown last, by the computer's monotonic clock
    _announced: str = field(default="", init=False)  # which takes long
    _another: AnotherDut = field(default_factory=AnotherDut, init=False)
    _meanwhile: Meanwhile = field(default_factory=Meanwhile, init=False)
    _fault_kept: str = field(default="", init=False)  # the words of the last fault in the record

    def run(self, procedure: Procedure) -> Ending:
        """Drive `procedure` to its end, whatever that is, and the bench to rest."""
        try:
            return self._at_rest(self._to_its_end(procedure))
        finally:
            self.bench.cage.over = None

    def _to_its_end(self, procedure: Procedure) -> Ending:
        started = self.bench.clock.utc(), self.bench.clock.now()
        try:
            with closing(procedure):
                self.bench.start()
                self.bench.look = self._look
                self.bench.clock.while_waiting(self._say_what_takes_long)
                for item in chain(other_serials(self.bench), self._items(procedure)):
                    self._refuse_mode(item)
                    self._keep(item)
                    if isinstance(item, Prompt):
                        self._reply = self._ask(item)
                    if isinstance(item, Step):
                        self._refuse_a_clock_set_back(*started)
                        self._pause_if_wanted()
            if self.bench.cage.over is not None:  # which the procedure has caught
                raise self.bench.cage.over
            return Ending("finished")
        except Left as fault:
            return Ending("interrupted", fault)
        except NotKept as fault:
            return Ending("interrupted", fault.fault, by_store=True)
        except Aborted as fault:
            return Ending(f"failed: {fault}", fault)
        except (Stopped, KeyboardInterrupt) as fault:
            return Ending("stopped", fault)
        except BaseException as fault:
            return Ending(f"failed: {in_a_sentence(fault)}", fault)

    def _items(self, procedure: Procedure) -> Iterator[Item]:
        """What the procedure yields, while it is given the answers to what it asks."""
        while True:
            self._check()
            reply, self._reply = self._reply, None
            try:
                item: object = procedure.send(reply)
                while not isinstance(item, Item):  # reported at the line that yields it
                    item = procedure.throw(TypeError(f"a procedure yields items of a run, and {item!r} is none"))
            except StopIteration:
                return
            if (another := self._another.question(self.bench, item)) is not None:
                yield another
                self._another.take(self._reply)
            yield item

    def _refuse_mode(self, item: Item) -> None:
        """Whatever a procedure is written like, it brings the DUT into no power mode that it may not be in."""
        limits = self.bench.config.dut.limits
        if isinstance(item, ModeChanged):
            limits.refuse_mode(item.mode)
        elif isinstance(item, SegmentOpened) and item.segment.mode is not None:
            limits.refuse_mode(item.segment.mode)
        elif isinstance(item, Prompt) and "mode" in item.drawing:
            limits.refuse_mode(str(item.drawing["mode"]))

    def _keep(self, item: Item) -> None:
        self._keep_news()
        self._keep_one(item)
        for text, data in self.control.notes():
            self._keep(self._event("note", text, **data))
        for event in self.bench.events():
            self._keep_one(event)

    def _keep_news(self) -> None:
        """What was lost or is back, before anything that came later; reported late, it says how long ago that was."""
        now = self.bench.clock.now()
        for event in self.bench.news():
            self._keep_one(event, now - event.t_s)

    def _keep_one(self, item: Item, age_s: float = 0.0) -> None:
        self._meanwhile.see(item, self.bench)
        item = shifted(item, self.offset_s) if self.offset_s else item
        with self.zero_unless_kept():
            self.write(item)
        if isinstance(item, Event) and item.kind == FAULT:
            self._fault_kept = item.text
        if isinstance(item, Event) and age_s > PROMPT_S:
            item = replace(item, text=f"{age_s:.1f} s ago: {item.text}")
        if isinstance(item, Event) or (isinstance(item, Block) and item.source == "cage"):
            self._show()  # first: whoever hears that the run pauses knows how the coils are
        self.on_item(item)

    def _show(self, not_within_s: float = 0.0) -> None:
        now = time.monotonic()
        if now - self._shown_s >= not_within_s:
            self._shown_s = now
            self.show(self.bench.state().shifted(now - self.bench.clock.now()))

    def _ask(self, prompt: Prompt) -> str:
        self.bench.handled(prompt)
        given = checked(prompt, self._answer_while_listening(prompt))
        self._say_what_moved(answered=True)
        operator = self.bench.simulated_operator
        if operator is not None and given in (prompt.choices[:1] or (given,)):  # else nothing was done
            operator.do(prompt)
        self.bench.handled(prompt)
        self._keep(self._event("answer", given, key=prompt.key))
        return given

    def _answer_while_listening(self, prompt: Prompt) -> str:
        answers: queue.Queue[str | BaseException] = queue.Queue()
        asking = threading.Thread(target=_put_answer, args=(self.answer, prompt, answers), daemon=True)
        asking.start()
        with self._person_awaited():
            self._listen_while(answers.empty, asking.join)
        given = answers.get()
        if isinstance(given, BaseException):
            raise given
        return given

    def _pause_if_wanted(self) -> None:
        if not self.control.paused():
            return
        self.bench.field_taken |= self.bench.cage.on
        self.bench.cage.zero()
        currents = self.bench.cage.currents_A().tolist()
        self._keep(read_back(self.bench, "pause", "paused, ", current_A=currents))
        self.bench.hands_near = True
        with self._person_awaited():
            self._listen_while(self.control.paused, self.control.wait_for_resume)
        self._keep(self._event("pause", "goes on"))

    def _listen_while(self, awaited: Callable[[], bool], wait: Callable[[float], object]) -> None:
        """Streams are written down and shown; of simulated time a little passes now and then, so that they send."""
        stands = Awaited(self.bench) if isinstance(self.bench.clock, VirtualClock) else None
        while awaited():
            self._check()
            self._say_what_moved()
            if stands is None or stands.lets_pass():
                self._listen()
            else:
                wait(LISTEN_S)
                self.show(stands.state())

    def _say_what_moved(self, *, answered: bool = False) -> None:
        """While somebody was silent: to whoever has had hands at a plug."""
        if (moved := self._meanwhile.over(self.bench, answered=answered)) is not None:
            self._keep(moved)

    @property
    def _rests(self) -> bool:
        return self.bench.asking and not self.bench.cage.on

    @contextmanager
    def _person_awaited(self) -> Iterator[None]:
        """With the coils at zero a cable may be out meanwhile, as one is while a device is mounted."""
        self.bench.asking = True
        try:
            yield
        finally:
            self.bench.asking = False

    def _check(self) -> None:
        """Raise where the operator wants the end; an abort zeroes the coils before the procedure hears of it."""
        try:
            self.control.check()
        except Stopped as end:
            self.bench.cage.over = end
            if isinstance(end, Aborted):
                self._zero_at_once()
            raise

    def _zero_at_once(self) -> None:
        with suppress(Exception):  # tried again, and reported, on the way to rest
            self.bench.zero_and_stop()

    def _look(self) -> None:
        """While anybody waits. Who wants the end does not wait for the end of a ramp: it stops where it is.

        Told once: what the procedure then undoes is not broken off. Nothing breaks off the way to zero. Where the coils
        are still on a moment later, because it undoes other things first or goes on all the same, they are taken there.
        """
        with self.zero_unless_kept():
            self.kept()
        self._keep_news()
        self._show(SHOWN_S)  # on a ramp as well, of which nothing is kept before its end
        if not self.bench.cage.on:
            return
        now = self.bench.clock.now()
        if self._end_requested_s is None:
            try:
                self._check()
            except Stopped:
                self._end_requested_s = now
                raise
        elif self.control.aborting() or now - self._end_requested_s > UNDONE_S:
            self._zero_at_once()

    @contextmanager
    def zero_unless_kept(self) -> Iterator[None]:
        """Where the record is not kept the coils go to zero before anybody hears of it; from then on rows only wait."""
        try:
            yield
        except (InputError, InstrumentError) as fault:
            if self._rows_wait or (self._rests and getattr(fault, "fault", "") in BUSY):
                return  # a run that rests at a question waits for a disk as for a person
            self._rows_wait, self.bench.cage.over = True, (end := NotKept(fault))
            self._zero_at_once()
            self._report_not_kept(fault)
            raise end from None

    def _say_what_takes_long(self) -> None:
        """Of a way to zero, once, to whoever watches: a slow line may keep the last word for seconds.

        Who is known to be lost is shown meanwhile.
        """
        with suppress(Exception):  # the way to zero goes on whoever watches
            self._show(SHOWN_S)
        if self.bench.cage.on:
            self._announced = ""
        words = self.bench.slow_zero()
        if words in ("", self._announced):
            return
        self._announced = words
        with suppress(Exception):  # the way to zero goes on whoever watches
            self.on_item(shifted(self._event("slow-zero", words), self.offset_s))

    def _report_not_kept(self, fault: InputError | InstrumentError) -> None:
        """At once, for the last rows may be waited for; it is in the record where that can be mended."""
        said = shifted(self._event(NOT_KEPT, f"the run ends: {fault.what}"), self.offset_s)
        with suppress(InputError, InstrumentError):
            self.write(said)
        self.on_item(said)

    def _listen(self) -> None:
        self._check()
        for block in self.bench.stream_until(self.bench.clock.now() + LISTEN_S):
            self._keep(block)

    def _refuse_a_clock_set_back(self, utc: Any, now: float) -> None:
        behind = (self.bench.clock.now() - now) - (self.bench.clock.utc() - utc).total_seconds()
        if behind > CLOCK_BACK_S:
            raise InstrumentError(
                f"the computer's clock was set back by {behind:.1f} s.",
                fault=CLOCK_BACK,
                remedy="Set the clock right and start the run again.",
            )

    def _at_rest(self, ending: Ending) -> Ending:
        """Coils to zero, every instrument to rest, and what was read back into the record."""
        bench = self.bench
        self._rows_wait = True  # whoever writes the last one tells where that cannot be
        faults = _failed(bench.zero_and_stop)
        faults += _failed(bench.make_safe if faults else bench.rest_instruments)  # zero again only where that failed
        faults += _failed(bench.stop)
        lost = list[Exception]()
        try:
            for axis in sorted(bench.cage.abrupt):
                self._keep(self._event("abrupt-zero", f"coil {axis} came to zero without a ramp", axis=axis))
            if not ending.by_store:
                self._keep_fault(ending.fault or next(iter(faults), None))
            read_back = self._read_back(faults, lost, ending.fault)
            self._show()  # the coils, before a large platform has come to rest
            if stands := bench.stop_platform():  # it was sent a stop before that; a large one takes seconds to stand
                self._keep(self._event("standstill", stands))
            self._keep_news()
            for event in bench.events():  # what a stream lost on the way: the read-back is the last word
                self._keep(event)
            self._keep(read_back)
        except Exception as fault:
            return ending if ending.fault else Ending(f"failed: {in_a_sentence(fault)}", fault)
        first = next(iter(faults + lost), None)
        if not self._at_zero:
            return Ending(f"failed: {self._said}{what_else(first, self._said)}", first)
        return Ending(f"failed: {in_a_sentence(lost[0])}", lost[0]) if lost and ending.fault is None else ending

    def _keep_fault(self, fault: BaseException | None) -> None:
        """Which instrument ended the run, unless the procedure has said so itself: `interrupted` does not."""
        if isinstance(fault, InstrumentError) and (said := self.bench.named(str(fault))) != self._fault_kept:
            self._keep(self._event(FAULT, said, fault=fault.fault))

    def _read_back(self, faults: list[Exception], lost: list[Exception], ended: BaseException | None) -> Event:
        """The currents as read back, an axis that does not answer as None, and what went wrong on the way.

        `lost` takes what the supplies still had to say: a coil that the guardian took to zero says so before it
        measures again.
        """
        currents = [read_twice(self.bench.cage, axis, lost) for axis in self.bench.cage.supplies]
        if None in currents:
            self.bench.wait_for_ends()
            currents = [read_twice(self.bench.cage, axis, []) for axis in self.bench.cage.supplies]
        self.state, self.read_at_s = self.bench.state(), self.bench.clock.now()
        if None in currents:  # what its guardian alone could read
            self.state = self.bench.state_with_ends()
            currents = [coil.current_A for coil in self.state.coils]
        now = self.read_at_s
        zero = all(coil.zero for coil in self.state.coils)  # however long a slow line took to read the three
        self._at_zero = zero and self.state.reference.verdict != "disagrees"
        self._said = NOT_CONFIRMED if None in currents else self.state.sentence(now)
        sentences = [in_a_sentence(fault) for fault in faults + lost]
        data: dict[str, Any] = {"current_A": currents, "faults": sentences, **stopped_by(ended)}
        return read_back(self.bench, "read-back", state=self.state, **data)

    def _event(self, kind: str, text: str, **data: Any) -> Event:
        return Event(self.bench.clock.now(), kind, text, data)


def _failed(act: Callable[[], None]) -> list[Exception]:
    try:
        act()
    except Exception as fault:
        return [fault]
    return []


def _put_answer(answer: Answer, prompt: Prompt, answers: queue.Queue[str | BaseException]) -> None:
    try:
        answers.put(answer(prompt))
    except BaseException as fault:
        answers.put(fault)
