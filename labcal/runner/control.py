"""What the operator wants, said from any thread: pause, go on, stop, abort."""

from __future__ import annotations

from threading import Event

from labcal.errors import Stopped


class Aborted(Stopped):
    """The operator aborted: coils to zero first, the procedure's own way out after that."""


class Control:
    """Pause takes hold where the next step begins; stop and abort at the next sample. All leave the coils at zero."""

    def __init__(self) -> None:
        self._pause, self._stop, self._abort = Event(), Event(), Event()

    def pause(self) -> None:
        """Wait where the next step begins, with the coils at zero, until `resume`."""
        self._pause.set()

    def resume(self) -> None:
        """Go on after a pause."""
        self._pause.clear()

    def stop(self) -> None:
        """End now, in order: the procedure undoes what it did. The run is `stopped`."""
        self._stop.set()

    def abort(self) -> None:
        """End now: the coils go to zero before anything else is done. The run is `failed: aborted by the operator`."""
        self._abort.set()

    def paused(self) -> bool:
        """Whether a pause is wanted."""
        return self._pause.is_set()

    def stopping(self) -> bool:
        """Whether a stop was asked for."""
        return self._stop.is_set()

    def check(self) -> None:
        """Raise Aborted or Stopped where that is wanted."""
        if self._abort.is_set():
            raise Aborted("aborted by the operator")
        if self._stop.is_set():
            raise Stopped("stopped by the operator")
