"""The worker's end of the line to the window: words in at any moment, messages out from any thread."""

from __future__ import annotations

import json
import os
import queue
import threading
import time
from collections.abc import Iterator
from typing import Any, TextIO

from labcal.bench.state import LabState
from labcal.gui.wire import item_to_json
from labcal.record.stream import Block, Event, Item, Prompt
from labcal.runner import Control

BATCH_S = 0.04  # samples go out at most 25 times a second
LOOK_S = 0.05
STILL_S = 1.0  # so long a window may stand still while real coils are on: nobody could say off there
LATE_S = 0.2  # a process that runs freely wakes no later


class Talk:
    """Hears what the window says while work goes on. When it dies, or stands still while real instruments are driven,
    the coils go to zero and the run is interrupted.
    """

    def __init__(self, heard: TextIO, said: TextIO) -> None:
        self.control = Control()
        self._heard, self._said, self._lock = heard, said, threading.Lock()
        self._asks: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self._answers: queue.Queue[tuple[str, str]] = queue.Queue()
        self._batch: list[list[Any]] = []
        self._sent_s, self._on_bench = 0.0, False
        self.hold_when_paused = False
        self._beat_s: float | None = None  # when the window was heard last; None of one that does not beat

    def asks(self) -> Iterator[dict[str, Any]]:
        """What is asked for, one after another, until the window hangs up."""
        threading.Thread(target=self._listen, daemon=True, name="window").start()
        while (ask := self._asks.get()) is not None:
            yield ask

    def say(self, said: str, **what: Any) -> None:
        """Send one message."""
        line = json.dumps({"said": said, **what}, default=str)
        try:
            with self._lock:
                self._said.write(line + "\n")
                self._said.flush()
        except BrokenPipeError:  # nobody is there to hear it
            self.control.leave()

    def on_bench(self, simulated: bool) -> None:
        """From here on a hang-up means abort, not exit. A paused simulation stands still."""
        self._on_bench, self.hold_when_paused, self.control = True, simulated, Control()
        if not simulated:
            threading.Thread(target=self._watch, args=(self.control,), daemon=True, name="still").start()

    def off_bench(self) -> None:
        """The run has ended and the links are closed."""
        self.flush()
        self._on_bench = False

    def tell(self, item: Item) -> None:
        """Hand an item on: samples in batches, everything else at once."""
        self._batch.append(item_to_json(item))
        if not isinstance(item, Block) or time.monotonic() - self._sent_s > BATCH_S:
            self.flush()
        if self.hold_when_paused and isinstance(item, Event) and item.kind == "pause":
            self._hold()

    def show(self, state: LabState) -> None:
        """How the lab is now, by the clock that all processes of this computer share."""
        self.say("state", state=state.as_json(0.0))

    def flush(self) -> None:
        """Send what is waiting."""
        batch, self._batch, self._sent_s = self._batch, [], time.monotonic()
        if batch:
            self.say("items", items=batch)

    def answer(self, prompt: Prompt) -> str:
        """Wait for the person's answer to `prompt`. Raises Stopped where that is wanted instead."""
        while True:
            self.control.check()
            try:
                key, text = self._answers.get(timeout=LOOK_S)
            except queue.Empty:
                continue
            if key == prompt.key:
                return text

    def _hold(self) -> None:
        while self.control.paused():
            self.control.check()
            time.sleep(LOOK_S)

    def _listen(self) -> None:
        for line in self._heard:
            self._take(json.loads(line))
        self.control.leave()
        self._asks.put(None)
        if not self._on_bench:
            os._exit(0)

    def _watch(self, control: Control) -> None:
        """See that the window still moves. Who wakes late itself was kept from listening, and judges nobody for it."""
        while self._on_bench and self.control is control:
            begun = time.monotonic()
            time.sleep(LOOK_S)
            now = time.monotonic()
            if self._beat_s is not None and now - begun > LOOK_S + LATE_S:
                self._beat_s = now
            elif self._beat_s is not None and now - self._beat_s > STILL_S:
                control.leave()
                return

    def _take(self, said: dict[str, Any]) -> None:
        if self._beat_s is not None or said["do"] == "beat":
            self._beat_s = time.monotonic()
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
                self._asks.put(said)


def over_standard_streams() -> Talk:
    """The line over stdin and stdout; whatever else prints goes to stderr."""
    out = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return Talk(open(os.dup(0), encoding="utf-8", closefd=True), out)
