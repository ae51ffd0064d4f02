"""The guardian's process. It begins with zero and ends with zero; a second one stands by and takes over where it dies.

The two hold a pipe: silence for `HUNG_S`, or its end without the word done, means that the first must be replaced.
"""

from __future__ import annotations

import os
import queue
import signal
import subprocess
import sys
import threading
import time
from contextlib import suppress
from pathlib import Path

from labcal.bench.config import read_config
from labcal.bench.guardian import wire
from labcal.bench.guardian.keeper import Guardian
from labcal.bench.guardian.logbook import note, written
from labcal.bench.guardian.server import Server
from labcal.bench.guardian.spawn import STANDBY, spawn
from labcal.bench.links import ports

LOOK_S = 0.02
RETRY_S = 0.5
LONELY_S, SUCCEEDED_S = 20.0, 2.0  # without a session so long after its start, it ends; after that of another
TO_ZERO_S = 2.0  # from the last sign of life to zero
READ_BACK_S = 0.35  # of that, for the read-back
PULSE_S, HUNG_S = 0.2, 1.5
FREE_S = 2.0  # until the kernel has freed the ports of a process that died


class Watch:
    """One guardian from its first zero to its last. `succeeds`: the one before it died, and currents may flow."""

    def __init__(self, path: Path, *, succeeds: bool) -> None:
        self._path, self._succeeds = path, succeeds
        self._guardian = Guardian(path, read_config(path), note)
        self._told_to_end = threading.Event()
        self._standby: subprocess.Popen[bytes] | None = None
        self._one_standby = threading.Lock()

    def live(self) -> None:
        """Begin with zero, then watch until nobody needs it any more and every coil is at zero."""
        listener, card = wire.listen()
        ports.announce(card)
        signal.signal(signal.SIGTERM, lambda *_: self._told_to_end.set())
        server = Server(self._guardian, listener, card["token"], wire.fingerprint(self._path))
        server.start()
        self._guardian.zero("a guardian was killed, its successor begins" if self._succeeds else "a session begins")
        server.ready.set()
        threading.Thread(target=self._keep_standby, daemon=True).start()
        try:
            self._watch(server)
        finally:
            wire.unlisten(listener, card)
            self._dismiss_standby()
            self._guardian.close()

    def _watch(self, server: Server) -> None:
        begun = retried = time.monotonic()
        alone_s = SUCCEEDED_S if self._succeeds else LONELY_S
        in_doubt = self._succeeds  # whether a coil that does not answer may carry current
        while True:
            time.sleep(LOOK_S)
            in_doubt = in_doubt or self._guardian.energised
            self._look_after(server)
            self._guardian.look_at_duty()
            if self._guardian.unresolved and time.monotonic() - retried > RETRY_S:
                self._guardian.try_again()
                retried = time.monotonic()
            if self._told_to_end.is_set():
                self._guardian.zero("the guardian was told to end")
                return
            lonely = server.had_session or time.monotonic() - begun > alone_s
            needless = server.dismissed.is_set() or (server.session is None and lonely)
            if needless and not (in_doubt and self._guardian.unresolved):
                return

    def _look_after(self, server: Server) -> None:
        """Zero where the session is gone, or silent for longer than the ramp leaves of two seconds."""
        session = server.session
        if session is None:
            return
        silent_s = time.monotonic() - session.heard_s
        if session.gone:
            if self._guardian.energised:
                self._guardian.zero(f"{session.who} is gone")
            server.part(session)
        elif self._guardian.energised and silent_s > patience(self._guardian.way_down_s):
            self._guardian.zero(f"{session.who} has been silent for {silent_s:.2f} s")

    def _keep_standby(self) -> None:
        """Keep one beside this process and tell it that this one lives."""
        while not self._told_to_end.is_set():
            with self._one_standby:
                if self._standby is None or self._standby.poll() is not None:
                    self._standby = spawn(self._path, STANDBY, stdin=subprocess.PIPE)
                self._tell_standby(b"alive\n")
            time.sleep(PULSE_S)

    def _tell_standby(self, word: bytes) -> None:
        if self._standby is not None and self._standby.stdin is not None:
            with suppress(OSError, ValueError):
                self._standby.stdin.write(word)
                self._standby.stdin.flush()

    def _dismiss_standby(self) -> None:
        self._told_to_end.set()
        with self._one_standby:
            self._tell_standby(b"done\n")


def patience(way_down_s: float) -> float:
    """How long a session may be silent [s]: what two seconds leave after the way down and the read-back."""
    return min(0.8, max(0.3, TO_ZERO_S - READ_BACK_S - way_down_s))


def stand_by() -> str:
    """Wait beside the guardian until it is "done", has "ended" without a word, or is "silent" and must be replaced."""
    words: queue.Queue[str] = queue.Queue()

    def listen() -> None:
        for word in sys.stdin:
            words.put(word.strip())
        words.put("ended")

    threading.Thread(target=listen, daemon=True).start()
    try:
        while (word := words.get(timeout=HUNG_S)) == "alive":
            pass
    except queue.Empty:
        return "silent"
    return word


def take_over(url: str, how: str) -> None:
    """Wait until the port of the guardian before is free; one that hangs is killed."""
    card = ports.holder(url) or {}
    if how == "silent" and "pid" in card:
        note(f"guardian {card['pid']} hangs and is killed")
        with suppress(OSError):
            os.kill(card["pid"], signal.SIGKILL if sys.platform != "win32" else signal.SIGTERM)
    deadline = time.monotonic() + FREE_S
    while ports.holder(url) is not None and time.monotonic() < deadline:
        time.sleep(0.005)


def main(path: Path, how: str) -> None:
    """Be the guardian of the bench `path`: now, or when the present one dies."""
    for name in ("SIGHUP", "SIGINT"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    urls = read_config(path).guarded_links
    if how == STANDBY:
        if (ended := stand_by()) == "done":
            return
        take_over(urls[0], ended)
    if ports.hold(urls):
        Watch(path, succeeds=how != "").live()
        ports.let_go()


if __name__ == "__main__":
    main(Path(sys.argv[1]), "".join(sys.argv[2:]))
    written(at_most_s=2.0)
    os._exit(0)  # wait for no thread that still listens to a silent instrument
