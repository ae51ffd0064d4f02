"""The worker's end of the channel to the window: requests in at any moment, messages out from any thread."""

from __future__ import annotations

import os
import queue
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TextIO

from labcal.bench.coils.state import LabState
from labcal.errors import InputError
from labcal.gui.ipc.lines import number_in, read_request, write_line
from labcal.gui.ipc.messages import (
    Abort,
    Answer,
    Beat,
    Event,
    Failed,
    GoOn,
    Note,
    Pause,
    Recorded,
    Request,
    StateRead,
    Stop,
    Word,
)
from labcal.gui.ipc.wire import fault_of
from labcal.record.stream import Block, Item, Prompt
from labcal.runner import Control

BATCH_S = 0.04  # samples go out at most 25 times a second
POLL_S = 0.05
FROZEN_S = 1.0  # so long a window may stand still while real coils are on: nobody could say off there
LATE_S = 0.2  # a process that runs freely wakes no later


class Channel:
    """Hears what the window says while work goes on. When it dies, or stands still while real instruments are driven,
    the coils go to zero and the run is interrupted.
    """

    def __init__(self, requests: TextIO, messages: TextIO) -> None:
        self.control = Control()
        self._input, self._output, self._lock = requests, messages, threading.Lock()
        self._requests: queue.Queue[Request | None] = queue.Queue()
        self._answers: queue.Queue[tuple[str, str]] = queue.Queue()
        self._batch: list[Item] = []
        self._sent_s, self._on_bench = 0.0, False
        self._heartbeat_s: float | None = None  # when the window was heard last; None of one that does not beat

    def requests(self) -> Iterator[Request]:
        """What is asked for, one after another, until the window hangs up."""
        threading.Thread(target=self._read_requests, daemon=True, name="window").start()
        while (request := self._requests.get()) is not None:
            yield request

    def send(self, event: Event) -> None:
        """Send one message."""
        line = write_line(event)
        try:
            with self._lock:
                self._output.write(line + "\n")
                self._output.flush()
        except BrokenPipeError:  # nobody is there to read it
            self.control.leave()

    def run_begins(self, simulated: bool) -> None:
        """From here on a hang-up means abort, not exit."""
        self._on_bench, self.control = True, Control()
        if not simulated:
            threading.Thread(target=self._watch_heartbeat, args=(self.control,), daemon=True, name="still").start()

    def run_ends(self) -> None:
        """The run has ended and the links are closed."""
        self.flush()
        self._on_bench = False

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

    def send_state(self, state: LabState) -> None:
        """How the lab is now, by the clock that all processes of this computer share."""
        self.send(StateRead(state))

    def flush(self) -> None:
        """Send what is waiting."""
        batch, self._batch, self._sent_s = self._batch, [], time.monotonic()
        if batch:
            self.send(Recorded(tuple(batch)))

    def answer(self, prompt: Prompt) -> str:
        """Wait for the person's answer to `prompt`. Raises Stopped where that is wanted instead."""
        while True:
            self.control.check()
            try:
                key, text = self._answers.get(timeout=POLL_S)
            except queue.Empty:
                continue
            if key == prompt.key:
                return text

    def _read_requests(self) -> None:
        for line in self._input:
            try:
                self._dispatch(read_request(line))
            except InputError as error:
                self.send(Failed(number_in(line), fault_of(error)))
        self.control.leave()
        self._requests.put(None)
        if not self._on_bench:
            os._exit(0)

    def _watch_heartbeat(self, control: Control) -> None:
        """See that the window still moves. Who wakes late itself was kept from listening, and judges nobody for it."""
        while self._on_bench and self.control is control:
            begun = time.monotonic()
            time.sleep(POLL_S)
            now = time.monotonic()
            if self._heartbeat_s is not None and now - begun > POLL_S + LATE_S:
                self._heartbeat_s = now
            elif self._heartbeat_s is not None and now - self._heartbeat_s > FROZEN_S:
                control.leave()
                return

    def _dispatch(self, said: Request | Word) -> None:
        if self._heartbeat_s is not None or isinstance(said, Beat):
            self._heartbeat_s = time.monotonic()
        match said:
            case Request():
                self._requests.put(said)
            case Answer(key, text):
                self._answers.put((key, text))
            case Pause():
                self.control.pause()
            case GoOn():
                self.control.resume()
            case Stop():
                self.control.stop()
            case Abort():
                self.control.abort()
            case Note(text, data):
                self.control.note(text, **data)
            case Beat():
                pass
            case _:
                raise AssertionError(f"nobody hears {said}")


def stdio_channel() -> Channel:
    """The channel over stdin and stdout; whatever else prints goes to stderr."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return Channel(open(os.dup(0), encoding="utf-8", closefd=True), out)
