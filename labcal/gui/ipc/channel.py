"""The worker's end of the channel to the window: requests in at any moment, messages out from any thread."""

from __future__ import annotations

import os
import queue
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import TextIO

from labcal.bench.coils.state import LabState
from labcal.errors import InputError
from labcal.gui.ipc.backlog import PastMessages
from labcal.gui.ipc.keeps_step import KeepsStep
from labcal.gui.ipc.lines import number_in, read_request, write_line
from labcal.gui.ipc.messages import (
    Abort,
    Answer,
    Beat,
    Done,
    Event,
    Failed,
    GoesOn,
    GoOn,
    HangUp,
    LinesTaken,
    Note,
    Pause,
    Recorded,
    Rejoin,
    Request,
    ResumeRun,
    RunProcedure,
    StateRead,
    Stop,
    Word,
)
from labcal.gui.ipc.wire import fault_of
from labcal.record.stream import Block, Item, Prompt
from labcal.runner import Control
from labcal.runner.control import LATER, STOOD_STILL
from labcal.system.run_door import Caller, Door

BATCH_S = 0.04  # samples go out at most 25 times a second
POLL_S = 0.05
FROZEN_S = 4.0  # so long a window may stand still while real coils are on: nobody could say off there
WAITS_S = 1.0  # so long before the run begins no further step, as after Pause, until the window moves again
LATE_S = 0.2  # a process that runs freely wakes no later
ALONE_S = 20.0  # so long a run goes on while a window that broke off is started again
UNANSWERED_S = 1.0  # of that, with coils on at a question: it cannot go on, and nobody is there


class Channel:
    """Hears what the window says while work goes on. When it dies, or stands still while real instruments are driven,
    the coils go to zero and the run is interrupted.

    Where the window is `watched`, a run goes on for `ALONE_S` without it: it is started again meanwhile, and comes back
    by the run's door. At a question it waits only with the coils at zero. A window that hangs up on purpose says so.
    """

    def __init__(
        self, requests: TextIO, messages: TextIO, *, watched: bool = False, let_go: Callable[[], object] = lambda: None
    ) -> None:
        self.control, self._asked_for = Control(), False  # whether it is that of a run which has not begun yet
        self._input, self._lock = requests, threading.RLock()
        self._output: TextIO | None = messages  # None while no window listens
        self._requests: queue.Queue[Request | None] = queue.Queue()
        self._answers: queue.Queue[tuple[str, str]] = queue.Queue()
        self._batch: list[Item] = []
        self._sent_s, self._on_bench = 0.0, False
        self._in_step, self._keeps_step = KeepsStep(), False  # a simulated run does; real ones wait for no window
        self._heartbeat_s: float | None = None  # when the window was heard last; None of one that does not beat
        self._paused_here = False  # for a window that stands still
        self._watched, self._hung_up, self._let_go = watched, False, let_go
        self._back_by_s = 0.0  # until then a window that broke off is being started, or has just been
        self._door: Door | None = None
        self._past: PastMessages | None = None
        self._state: LabState | None = None  # of the lab, as the run that goes on read it last
        self._comes: Caller | None = None  # let in, and not informed yet how far the run is
        self._working_on, self._other_numbers = 0, dict[int, int]()  # requests of a window before as of this

    def requests(self) -> Iterator[Request]:
        """What is asked for, one after another, until the window hangs up."""
        threading.Thread(target=self._read_requests, daemon=True, name="window").start()
        while (request := self._requests.get()) is not None:
            self._working_on = request.number
            yield request
        self.close_door()

    def send(self, event: Event) -> None:
        """Send one message; it is kept for a window that comes back."""
        with self._lock:
            if isinstance(event, Done | Failed):
                event = replace(event, number=self._other_numbers.pop(event.number, event.number))
            if self._past is not None:
                self._past.keep(event)
            self._write(event)

    def _write(self, event: Event) -> None:
        if self._output is None:
            return
        try:
            self._output.write(write_line(event) + "\n")
            self._output.flush()
            self._in_step.sent()
        except ConnectionError:  # nobody is there to read it
            self._nobody_reads()

    def run_begins(self, simulated: bool, going: GoesOn | None = None) -> None:
        """From here on a hang-up means abort, not exit; where somebody watches the window, that it may come back."""
        if not self._asked_for:
            self.control = Control(to_be_resumed=True)
        self._on_bench, self._asked_for, self._state, self._paused_here = True, False, None, False
        self._keeps_step = simulated
        self._answers = queue.Queue()
        if self._watched and going is not None:
            self._past = PastMessages(going)
            with suppress(OSError):  # no place for its card: then none comes back, and the run ends with its window
                self._door = self._door or Door()
        if not simulated:
            threading.Thread(target=self._watch_heartbeat, args=(self.control,), daemon=True, name="still").start()

    def run_ends(self) -> None:
        """The run has ended and the links are closed."""
        self.flush()
        self._on_bench = self._keeps_step = False
        self.control.stop()  # whoever still waits for an answer in it would take one of the next run's

    @contextmanager
    def on_the_way_to_zero(self) -> Iterator[None]:
        """A window that hangs up meanwhile is obeyed when the coils are down: nobody else might bring them there."""
        self._on_bench = True
        try:
            yield
        finally:
            self._on_bench = False

    def send_item(self, item: Item) -> None:
        """Hand an item on: samples in batches, everything else at once."""
        self._batch.append(item)
        if not isinstance(item, Block) or time.monotonic() - self._sent_s > BATCH_S:
            self.flush()
        self._keep_step()

    def send_state(self, state: LabState) -> None:
        """How the lab is now, by the clock that all processes of this computer share."""
        self._state = state
        self.send(StateRead(state))
        self._keep_step()

    def _keep_step(self) -> None:
        if self._keeps_step:
            self._in_step.wait(lambda: self._output is None or self.control.ends())

    def flush(self) -> None:
        """Send what is waiting."""
        batch, self._batch, self._sent_s = self._batch, [], time.monotonic()
        if batch:
            self.send(Recorded(tuple(batch)))

    def answer(self, prompt: Prompt) -> str:
        """Wait for the person's answer to `prompt`. Raises Stopped where that is wanted instead."""
        control, answers, attended_s = self.control, self._answers, time.monotonic()  # of this run
        while True:
            control.check()
            if self._output is not None or self._at_zero():
                attended_s = time.monotonic()
            elif time.monotonic() - attended_s > UNANSWERED_S:
                control.leave()
            try:
                key, text = answers.get(timeout=POLL_S)
            except queue.Empty:
                continue
            if key == prompt.key:
                return text

    def _read_requests(self) -> None:
        self._hear(self._input)
        while (came := self._without_window()) is not None:
            self._comes = came
            self._hear(came.says)
            came.close()
        self.control.leave()
        self._requests.put(None)
        if not self._on_bench:
            self.close_door()
            os._exit(0)

    def _hear(self, window: TextIO) -> None:
        """Whatever it says until it hangs up or is gone."""
        with suppress(ConnectionError):
            for line in window:
                try:
                    self._dispatch(read_request(line))
                except InputError as error:
                    self.send(Failed(number_in(line), fault_of(error)))

    def _without_window(self) -> Caller | None:
        """The window that comes back to a run; None where none is to come, or none did in time."""
        if self._door is None or not self._on_bench or self._hung_up:
            return None
        self._nobody_reads()
        return self._door.wait(ALONE_S)

    def _nobody_reads(self) -> None:
        """The window is gone. Where it may come back, the run goes on for a while; else it ends now."""
        with self._lock:
            gone, self._output, self._comes, self._heartbeat_s = self._output, None, None, None
        if self._door is None:
            return self.control.leave()
        if gone is not None:
            self._let_go()
            self._back_by_s = time.monotonic() + ALONE_S
            too_long = threading.Timer(ALONE_S, self._leave_if_alone, [self.control])
            too_long.daemon = True
            too_long.start()
        return None

    def _leave_if_alone(self, control: Control) -> None:
        if self._output is None:
            control.leave()

    def _come_back(self, number: int) -> None:
        """Tell the window that has come how far the run is; from here on it hears all the rest."""
        with self._lock:
            if self._comes is None or self._past is None:
                return
            self._output, self._comes, self._heartbeat_s = self._comes.hears, None, time.monotonic()
            self._other_numbers[self._working_on] = number
            self._in_step.begin()
            for event in self._past.events():
                self._write(replace(event, number=number) if isinstance(event, Done | Failed) else event)

    def _at_zero(self) -> bool:
        return self._state is not None and self._state.at_zero(time.monotonic()) is True

    def close_door(self) -> None:
        """No window comes in any more."""
        if self._door is not None:
            self._door.close()

    def _watch_heartbeat(self, control: Control) -> None:
        """See that the window still moves while the coils are on, or not known to be at zero.

        Who wakes late itself was kept from listening, and judges nobody for it. On a busy computer a window is late for
        a second and is back: the run waits for it where its next step begins, with its coils at zero.
        """
        while self._on_bench and self.control is control:
            begun = time.monotonic()
            time.sleep(POLL_S)
            now, heard_s = time.monotonic(), self._heartbeat_s
            if heard_s is not None and now - begun > POLL_S + LATE_S:
                self._heartbeat_s = now
                continue
            stands_still_s = 0.0 if heard_s is None or now <= self._back_by_s else now - heard_s
            self._wait_for_the_window(control, stands_still_s > WAITS_S and not self._at_zero())
            if stands_still_s > FROZEN_S and not self._at_zero():
                control.leave(STOOD_STILL)
                return

    def _wait_for_the_window(self, control: Control, stands_still: bool) -> None:
        """What is paused here goes on here, once the window moves; a pause that a person asked for stays."""
        if stands_still and not self._paused_here and not control.paused():
            control.pause()
            self._paused_here = True
        elif self._paused_here and self._moves():
            self._paused_here = False
            control.resume()

    def _moves(self) -> bool:
        return self._heartbeat_s is not None and time.monotonic() - self._heartbeat_s < WAITS_S

    def _dispatch(self, said: Request | Word) -> None:
        if self._heartbeat_s is not None or isinstance(said, Beat):
            self._heartbeat_s = time.monotonic()
        match said:
            case Request(number, Rejoin()) if self._comes is not None:
                self._come_back(number)
            case HangUp():
                self._hung_up = True
            case Request(_, RunProcedure() | ResumeRun()) if not self._on_bench:
                self.control, self._asked_for = Control(to_be_resumed=True), True  # a Stop before it begins is its own
                self._requests.put(said)
            case Request():
                self._requests.put(said)
            case Answer(key, text):
                self._answers.put((key, text))
            case Pause():
                self._paused_here = False
                self.control.pause()
            case GoOn():
                self.control.resume()
            case Stop(later):
                self.control.leave(LATER) if later else self.control.stop()
            case Abort():
                self.control.abort()
            case Note(text, data):
                self.control.note(text, **data)
            case LinesTaken(lines):
                self._in_step.taken(lines)
            case Beat():
                pass
            case _:
                raise AssertionError(f"nobody hears {said}")


def stdio_channel(*, watched: bool = False) -> Channel:
    """The channel over stdin and stdout; whatever else prints goes to stderr."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return Channel(open(os.dup(0), encoding="utf-8", closefd=True), out, watched=watched, let_go=_mute)


def _mute() -> None:
    """Whoever read what else is printed is gone: printing is to break nothing."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    for printed in (1, 2):
        os.dup2(nowhere, printed)
    os.close(nowhere)
