"""The worker's end of the channel to the window: requests in at any moment, messages out from any thread."""

from __future__ import annotations

import json
import os
import queue
import threading
import time
from collections.abc import Iterator
from typing import Any, TextIO

from labcal.bench.coils.state import LabState
from labcal.gui.ipc.wire import item_to_json
from labcal.record.stream import Block, Event, Item, Prompt
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
        self._requests: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self._answers: queue.Queue[tuple[str, str]] = queue.Queue()
        self._batch: list[list[Any]] = []
        self._sent_s, self._on_bench = 0.0, False
        self.hold_when_paused = False
        self._heartbeat_s: float | None = None  # when the window was heard last; None of one that does not beat

    def requests(self) -> Iterator[dict[str, Any]]:
        """What is asked for, one after another, until the window hangs up."""
        threading.Thread(target=self._read_requests, daemon=True, name="window").start()
        while (request := self._requests.get()) is not None:
            yield request

    def send(self, said: str, **what: Any) -> None:
        """Send one message."""
        line = json.dumps({"said": said, **what}, default=str)
        try:
            with self._lock:
                self._output.write(line + "\n")
                self._output.flush()
        except BrokenPipeError:  # nobody is there to read it
            self.control.leave()

    def run_begins(self, simulated: bool) -> None:
        """From here on a hang-up means abort, not exit. A paused simulation stands still."""
        self._on_bench, self.hold_when_paused, self.control = True, simulated, Control()
        if not simulated:
            threading.Thread(target=self._watch_heartbeat, args=(self.control,), daemon=True, name="still").start()

    def run_ends(self) -> None:
        """The run has ended and the links are closed."""
        self.flush()
        self._on_bench = False

    def send_item(self, item: Item) -> None:
        """Hand an item on: samples in batches, everything else at once."""
        self._batch.append(item_to_json(item))
        if not isinstance(item, Block) or time.monotonic() - self._sent_s > BATCH_S:
            self.flush()
        if self.hold_when_paused and isinstance(item, Event) and item.kind == "pause":
            self._wait_while_paused()

    def send_state(self, state: LabState) -> None:
        """How the lab is now, by the clock that all processes of this computer share."""
        self.send("state", state=state.as_json(0.0))

    def flush(self) -> None:
        """Send what is waiting."""
        batch, self._batch, self._sent_s = self._batch, [], time.monotonic()
        if batch:
            self.send("items", items=batch)

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

    def _wait_while_paused(self) -> None:
        while self.control.paused():
            self.control.check()
            time.sleep(POLL_S)

    def _read_requests(self) -> None:
        for line in self._input:
            self._dispatch(json.loads(line))
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

    def _dispatch(self, said: dict[str, Any]) -> None:
        if self._heartbeat_s is not None or said["do"] == "beat":
            self._heartbeat_s = time.monotonic()
        match said["do"]:
            case "beat":
                pass
            case "answer":
                self._answers.put((said["key"], said["text"]))
            case "pause":
                self.control.pause()
            case "go on":
                self.control.resume()
            case "stop":
                self.control.stop()
            case "abort":
                self.control.abort()
            case "note":
                self.control.note(said["text"], **said.get("data", {}))
            case _:
                self._requests.put(said)


def stdio_channel() -> Channel:
    """The channel over stdin and stdout; whatever else prints goes to stderr."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return Channel(open(os.dup(0), encoding="utf-8", closefd=True), out)
