"""What the operator wants, said from any thread: pause, go on, stop, abort."""

from __future__ import annotations

from collections.abc import Mapping
from queue import Empty, SimpleQueue
from threading import Event

from labcal.errors import Stopped
from labcal.record.endings import BY_ABORT, STOPPED_BY


class Aborted(Stopped):
    """The operator aborted: coils to zero first, the procedure's own way out after that."""


GONE = "whoever ran this is gone"
STOOD_STILL = "the window stood still for more than 4 seconds"


class Left(Aborted):
    """Whoever ran this is gone, or stands still: the same way out."""


LATER = "stopped by the operator, to be gone on with later"


class Later(Left):
    """Nobody is gone: the operator goes on with it later, and said so. The same way out."""


class NotKept(Aborted):
    """The record cannot be kept, for the reason `fault`: the same way out, and the run may be gone on with."""

    def __init__(self, fault: Exception) -> None:
        super().__init__(str(fault))
        self.fault = fault


def stopped_by(fault: BaseException | None) -> dict[str, str]:
    """What the last word of a record says of a run that a person ended; nothing of all others."""
    nobody = isinstance(fault, Left | NotKept) and not isinstance(fault, Later)
    person = isinstance(fault, Stopped | KeyboardInterrupt) and not nobody
    by_abort = isinstance(fault, Aborted) and not isinstance(fault, Later)
    return {STOPPED_BY: BY_ABORT if by_abort else "operator"} if person else {}


class Control:
    """Pause takes hold where the next step begins; stop and abort at the next sample. All leave the coils at zero.

    With `to_be_resumed` a run that the operator ends is `interrupted`, where its procedure can be gone on with.
    """

    def __init__(self, *, to_be_resumed: bool = False) -> None:
        self.to_be_resumed = to_be_resumed
        self._going, self._stop, self._abort, self._left = Event(), Event(), Event(), Event()
        self._why_left = GONE
        self._going.set()
        self._notes: SimpleQueue[tuple[str, Mapping[str, str]]] = SimpleQueue()

    def pause(self) -> None:
        """Wait where the next step begins, with the coils at zero, until `resume`."""
        self._going.clear()

    def resume(self) -> None:
        """Go on after a pause."""
        self._going.set()

    def stop(self) -> None:
        """End now, in order: the procedure undoes what it did. The run is `stopped`."""
        self._stop.set()

    def abort(self) -> None:
        """End now: the coils go to zero before anything else is done. The run is `failed: aborted by the operator`."""
        self._abort.set()

    def leave(self, why: str = GONE) -> None:
        """Whoever ran this is gone: as an abort, but the run is `interrupted`, and may be gone on with."""
        self._why_left = why
        self._left.set()

    def note(self, text: str, **data: str) -> None:
        """Put a remark into the record ("lift moved"), stamped when the next item is written; `data` goes with it."""
        self._notes.put((text, data))

    def notes(self) -> list[tuple[str, Mapping[str, str]]]:
        """The remarks that are not in the record yet, with their data; each is given once."""
        said = list[tuple[str, Mapping[str, str]]]()
        while True:
            try:
                said.append(self._notes.get_nowait())
            except Empty:
                return said

    def paused(self) -> bool:
        """Whether a pause is wanted."""
        return not self._going.is_set()

    def wait_for_resume(self, at_most_s: float) -> None:
        """Return when going on is wanted, or after `at_most_s` of true time."""
        self._going.wait(at_most_s)

    def stopping(self) -> bool:
        """Whether a stop was asked for."""
        return self._stop.is_set()

    def aborting(self) -> bool:
        """Whether the coils have to go to zero before anything else."""
        return self._abort.is_set() or self._left.is_set()

    def ends(self) -> bool:
        """Whether the run is to end, in whatever way."""
        return self.stopping() or self.aborting()

    def check(self) -> None:
        """Raise Aborted or Stopped where that is wanted."""
        if self._abort.is_set():
            raise Aborted("aborted by the operator")
        if self._left.is_set():
            raise (Later if self._why_left == LATER else Left)(self._why_left)
        if self._stop.is_set():
            raise Stopped("stopped by the operator")
