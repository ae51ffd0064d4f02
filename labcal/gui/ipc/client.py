"""The window's end of the channel to a worker process. Nothing here waits: answers come as callbacks."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections import deque
from collections.abc import Callable
from contextlib import suppress
from typing import Any, Protocol, TypeVar

from PySide6.QtCore import QObject, QProcess, QTimer, Signal

from labcal.errors import InputError
from labcal.gui.ipc.environment import child_environment
from labcal.gui.ipc.lines import read_answer, read_event, tells_state, write_line
from labcal.gui.ipc.listeners import while_there
from labcal.gui.ipc.messages import (
    Beat,
    Command,
    Done,
    Event,
    Failed,
    GoesOn,
    HangUp,
    LinesTaken,
    Progress,
    Recorded,
    Request,
    StateRead,
    Word,
)
from labcal.gui.ipc.wire import OWN_MISTAKE, Fault

R = TypeVar("R")
OnFault = Callable[[Fault], object]
COMMAND = ("-P", "-m", "labcal.gui.ipc.worker")  # nothing is loaded from the current folder
WATCHED = (*COMMAND, "--watched")  # whose run goes on until a window that broke off is back
REJOIN = ("-P", "-m", "labcal.gui.ipc.rejoin")
TIME_SLICE_S = 0.01  # of one turn of the event loop for what the worker said
STDERR_TAIL = 6000  # of stderr, for the details of a crash
KILLED_MS = 30_000  # by then a process that was killed is gone on the slowest computer
HEARTBEAT_MS = 200  # so often the worker hears that this window is not standing still


class Worker(Protocol):
    """What view-models need of a worker."""

    items: Any  # Signal(tuple) of items
    states: Any  # Signal(LabState)
    progress: Any  # Signal(str)

    def request(self, command: Command[R], then: Callable[[R], object], failed: OnFault) -> None:
        """Ask for `command`; `then` gets its answer, `failed` what went wrong."""
        ...

    def send(self, word: Word) -> None:
        """A word into a run that goes on: answer, pause, stop and so on."""
        ...

    def kill(self) -> None:
        """End the process at once."""
        ...


class Client(QObject):
    """One worker process, started at the first request, and started again after it died."""

    items = Signal(tuple)  # of the timeline, in order
    states = Signal(object)  # LabState, by the computer's monotonic clock
    progress = Signal(str)
    came_back = Signal(object)  # GoesOn: the run of a worker that was there before this window

    def __init__(self, parent: QObject | None = None, command: tuple[str, ...] = COMMAND) -> None:
        super().__init__(parent)
        self._command = command
        self._process: QProcess | None = None
        self._worker_before = 0  # the process that this window comes back to
        self._is_back = False  # and it has answered: it is that process
        self._pending: dict[int, tuple[Command[Any], Callable[[Any], object], OnFault]] = {}
        self._number = 0
        self._lines: deque[bytes] = deque()
        self._state: bytes | None = None  # the line of the newest that has come, and is not shown yet
        self._taken = self._said_taken = 0  # lines
        self._partial_line, self._stderr, self._ended_here = b"", "", ""
        self._heartbeat = QTimer(self, interval=HEARTBEAT_MS)
        self._heartbeat.timeout.connect(lambda: self.send(Beat()))

    def start(self) -> None:
        """Have the process ready before it is needed."""
        if self._process is None:
            self._start(self._command)

    def come_back(self, worker: int) -> None:
        """Speak to the process `worker`, whose run went on without a window."""
        self._worker_before, self._is_back = worker, False
        self._start((*REJOIN, str(worker)))

    def _start(self, command: tuple[str, ...]) -> None:
        process = QProcess(self)
        process.readyReadStandardOutput.connect(self._read_stdout)
        process.readyReadStandardError.connect(self._read_stderr)
        process.finished.connect(self._process_finished)
        process.errorOccurred.connect(self._process_error)
        process.setProcessEnvironment(child_environment())
        self._process, self._stderr, self._partial_line, self._ended_here = process, "", b"", ""
        self._state, self._taken, self._said_taken = None, 0, 0
        process.start(sys.executable, list(command))
        self._heartbeat.start()

    def request(self, command: Command[R], then: Callable[[R], object], failed: OnFault) -> None:
        """Ask for `command`; `then` gets its answer, `failed` what went wrong, where they are still there."""
        self.start()
        self._number += 1
        self._pending[self._number] = command, while_there(then), while_there(failed)
        self.send(Request(self._number, command))

    def send(self, message: Word | Request) -> None:
        """A word into a run that goes on, or a request's line."""
        if self._process is not None:
            self._process.write((write_line(message) + "\n").encode())

    @property
    def busy(self) -> bool:
        """Whether anything is asked and not answered."""
        return bool(self._pending)

    @property
    def pid(self) -> int:
        """Of the process that works; 0 where there is none."""
        return self._worker_before or (self._process.processId() if self._process is not None else 0)

    def kill(self) -> None:
        """End the process at once; whoever waits gets a failure."""
        self._kill(self.tr("The work was ended by this window."))

    def _kill(self, why: str) -> None:
        if self._process is not None:
            self._ended_here = self._ended_here or why
            if self._worker_before and self._is_back:
                _end(self._worker_before)
            self._process.kill()

    def close(self, wait_ms: int = 3000) -> None:
        """Close the line: a run aborts, its coils go to zero, the process ends."""
        process, self._process = self._process, None
        self._heartbeat.stop()
        self._pending.clear()
        self._worker_before = 0
        if process is None:
            return
        process.blockSignals(True)
        process.write((write_line(HangUp()) + "\n").encode())
        process.closeWriteChannel()
        if not process.waitForFinished(wait_ms):
            process.kill()
            process.waitForFinished(KILLED_MS)

    def _read_stdout(self) -> None:
        if self._process is None:
            return
        *lines, self._partial_line = (self._partial_line + self._process.readAllStandardOutput().data()).split(b"\n")
        idle = not self._lines
        for line in lines:
            self._came(line)
        if idle:
            self._drain()

    def _came(self, line: bytes) -> None:
        """How the lab is waits behind nothing, and of several that wait the newest alone is shown.

        In a run that a window comes back to it waits until that is known.
        """
        if not tells_state(line) or (self._worker_before and not self._is_back):
            return self._lines.append(line)
        self._taken += self._state is not None
        self._state = line
        return None

    def _drain(self) -> None:
        """What has come, as far as one turn of the event loop may take; the rest in the next."""
        until = time.monotonic() + TIME_SLICE_S
        try:
            self._show_state()
            while self._lines and time.monotonic() < until:
                self._take(self._lines.popleft())
        finally:  # whoever breaks over an answer keeps nobody else waiting for theirs
            self._say_taken()
            if self._lines:
                QTimer.singleShot(0, self, self._drain)

    def _say_taken(self) -> None:
        """The worker of a simulated run waits where this window is behind."""
        if self._taken > self._said_taken:
            self._said_taken = self._taken
            self.send(LinesTaken(self._taken))

    def _take(self, line: bytes) -> None:
        """A line that is no message comes of a worker that is broken: it ends."""
        self._taken += 1
        try:
            event = read_event(line)
        except InputError as error:
            self._stderr += f"{error}\n"
            return self._kill(self.tr("The work said what this window cannot read, and was ended by it."))
        return self._dispatch(event)

    def _show_state(self) -> None:
        line, self._state = self._state, None
        if line is not None:
            self._take(line)

    def _dispatch(self, event: Event) -> None:
        match event:
            case StateRead(state):
                self.states.emit(state)
            case Recorded(items):
                self.items.emit(items)
            case Progress(text):
                self.progress.emit(text)
            case GoesOn():
                self._is_back = True
                self.came_back.emit(event)
            case Done(number, answer):
                self._answered(number, answer)
            case Failed(number, fault):
                if (waiting := self._pending.pop(number, None)) is not None:
                    waiting[2](fault)

    def _answered(self, number: int, said: Any) -> None:
        if (waiting := self._pending.pop(number, None)) is None:
            return
        command, then, failed = waiting
        try:
            answer = read_answer(command, said)
        except InputError as error:
            failed(Fault("crash", OWN_MISTAKE, "", str(error)))
        else:
            then(answer)

    def _read_stderr(self) -> None:
        if self._process is not None:
            text = bytes(self._process.readAllStandardError().data()).decode(errors="replace")
            self._stderr = (self._stderr + text)[-STDERR_TAIL:]

    def _process_finished(self, code: int, status: QProcess.ExitStatus) -> None:
        self._read_stdout()
        self._show_state()
        while self._lines:
            self._take(self._lines.popleft())
        self._process_gone(self._ended_here or self._how_it_ended(code, status))

    def _how_it_ended(self, code: int, status: QProcess.ExitStatus) -> str:
        """Of a process that was killed Qt gives the signal's number in place of an exit code."""
        if status == QProcess.ExitStatus.NormalExit:
            return self.tr("The work ended by itself (exit {0}).").format(code)
        if sys.platform == "win32":
            return self.tr("The work crashed (code {0}).").format(code)
        return self.tr("The work was killed (signal {0}).").format(_named_signal(code))

    def _process_error(self, error: QProcess.ProcessError) -> None:
        if error == QProcess.ProcessError.FailedToStart:
            self._process_gone(self.tr("The worker process could not be started."))

    def _process_gone(self, text: str) -> None:
        self._read_stderr()
        process, self._process = self._process, None
        self._worker_before = 0
        self._heartbeat.stop()
        if process is not None:
            process.deleteLater()
        waiting, self._pending = list(self._pending.values()), {}
        for _, _, failed in waiting:
            failed(Fault("ended", text, "", self._stderr))


def _end(worker: int) -> None:
    """As QProcess ends a process of its own; the line to it is open, so it is that process still."""
    at_once = getattr(signal, "SIGKILL", signal.SIGTERM)  # Windows, which has no SIGKILL, ends it by either
    with suppress(OSError):
        os.kill(worker, at_once)


def _named_signal(number: int) -> str:
    try:
        return f"{number}, {signal.Signals(number).name}"
    except ValueError:
        return str(number)
