"""What each run of the store came to, in the words of the card of its end; asked for a few at a time."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from PySide6.QtCore import QObject, Signal

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.client import Client
from labcal.gui.ipc.record_messages import RunResult, TellResults
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.run_verdict import end_result, result_word

AT_ONCE = 25  # runs, of the newest: nobody else waits long for the worker


class RunResults(QObject):
    """`changed` when another few are known; `told` is kept by who lives longer, as a window in another language."""

    changed = Signal()

    def __init__(self, worker: Client, told: dict[str, RunResult] | None = None) -> None:
        super().__init__()
        self._worker = worker
        self._known: dict[str, RunResult] = {} if told is None else told
        self._asked = set[str]()  # or it cannot be told
        self.waiting: list[str] = []
        self._at_once = AT_ONCE

    def ask(self, runs: Iterable[RunLine]) -> None:
        """Ask for those that have finished and are not known."""
        idle = not self.waiting
        new = [one.run_id for one in runs if one.status == "finished" and one.run_id not in self._asked]
        new = [run_id for run_id in new if run_id not in self._known]
        self._asked |= set(new)
        self.waiting += new
        if idle:
            self._ask_some()

    def _ask_some(self) -> None:
        if some := tuple(self.waiting[: self._at_once]):
            told, not_told = partial(self._told, some), partial(self._not_told, some)
            self._worker.request(TellResults(some), told, not_told)

    def _told(self, asked: tuple[str, ...], said: tuple[RunResult, ...]) -> None:
        self._known.update({one.run_id: one for one in said})
        del self.waiting[: len(asked)]
        self.changed.emit()
        self._ask_some()

    def _not_told(self, asked: tuple[str, ...], fault: Fault) -> None:
        """A damaged record says so where it is opened; here their status stands. Of others it is told all the same."""
        del self.waiting[: len(asked)]
        if len(asked) > 1:
            self.waiting[:0] = asked  # one by one: the damaged one is not known
            self._at_once = 1
        self._ask_some()

    def word(self, one: RunLine) -> tuple[str, str]:
        """How a run came out, with its shape, and the colour of that."""
        said = self._known.get(one.run_id) if one.status == "finished" else None
        if said is None:
            return end_result(one.status, stopped=one.stopped, by_off=one.by_off)
        return result_word(said.verdict, said.left_out)
