"""The guardian's process. It begins with zero and ends with zero; two others stand by, one takes over where it dies.

Each holds a pipe to it (`handover`): silence there, or its end without the word done, means that the first must be
replaced. What they need for that they have read and loaded before; who has the ports first is the next guardian.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
import traceback
from concurrent.futures import Future
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, cast

from labcal.bench.essentials import as_table
from labcal.bench.guardian import wire
from labcal.bench.guardian.briefing import BRIEFED, Briefing, briefing_of, essentials_of
from labcal.bench.guardian.controller import Guardian
from labcal.bench.guardian.handover import DONE, Handover, patience, stand_by, unknown
from labcal.bench.guardian.logbook import note, written
from labcal.bench.guardian.server import Server
from labcal.bench.guardian.spawn import STANDBY, SUCCESSOR
from labcal.bench.guardian.standbys import Standbys
from labcal.bench.guardian.supplies import supplies_of
from labcal.bench.links import ports
from labcal.bench.loading import drivers_of
from labcal.errors import InputError

if TYPE_CHECKING:
    from labcal.bench.config import BenchConfig

LOOK_S = 0.02
RETRY_S = 0.2  # after which what is not confirmed at zero is asked again
FOUND_S = 0.25  # so often it sees whether others can find it
LONELY_S, SUCCEEDED_S = 20.0, 2.0  # without a session so long after its start, it ends; after that of another
FREE_S = 2.0  # until the kernel has freed the ports of a process that died


class Watch:
    """One guardian from its first zero to its last. `succeeds`: the one before it is gone, and currents may flow.

    `bench` may have no more than the essentials; then all of `line` is read into `loading` while zero is awaited.
    """

    def __init__(
        self, path: Path, bench: Briefing, handed: Handover, loading: Future[Briefing], line: str, *, succeeds: bool
    ) -> None:
        self._path, self._bench, self._succeeds, self._loading, self._line = path, bench, succeeds, loading, line
        self._guardian = Guardian(path, bench.config, note, handed)
        self._end_requested = threading.Event()

    def live(self) -> None:
        """Begin with zero, then watch until nobody needs it any more and every coil is at zero."""
        listener, card = wire.listen()
        config, named = self._bench.config, os.path.abspath(self._bench.named)
        driven = {"supplies": supplies_of(config), ports.DRIVEN: as_table(config)}
        ports.announce(card | {"bench": str(self._path), "named": named} | driven)
        signal.signal(signal.SIGTERM, lambda *_: self._end_requested.set())
        server = Server(self._guardian, listener, card["token"], self._bench.fingerprint)
        server.start()
        if not self._loading.done():
            self._guardian.load_supplies()
            threading.Thread(target=self._load_rest, daemon=True).start()
        self._guardian.zero("the one before is gone, its successor begins" if self._succeeds else "a session begins")
        whole = self._loading.result()
        self._guardian.load(whole.config)
        server.ready.set()
        standbys = Standbys(whole, self._guardian)
        standbys.start()
        self._guardian.heartbeats.start()
        try:
            self._watch(server, card)
        finally:
            wire.unlisten(listener, card)
            standbys.dismiss()
            self._guardian.heartbeats.stop()
            self._guardian.close()

    def _load_rest(self) -> None:
        """What zero does without, by one thread: two that load one library at once may each get half of it."""
        load_into(self._loading, self._path, self._line)
        self._guardian.meet_others()

    @property
    def in_doubt(self) -> bool:
        """Whether a coil was not confirmed at zero."""
        return bool(self._guardian.unresolved)

    def _watch(self, server: Server, card: wire.Card) -> None:
        begun = retried = sought = time.monotonic()
        alone_s = SUCCEEDED_S if self._succeeds else LONELY_S
        in_doubt = self._succeeds  # whether a coil that does not answer may carry current
        while True:
            time.sleep(LOOK_S)
            in_doubt = in_doubt or self._guardian.energised
            self._look_after(server)
            self._look_at_heartbeats()
            self._guardian.look_at_duty()
            if self._guardian.unresolved and time.monotonic() - retried > RETRY_S:
                self._guardian.try_again()
                retried = time.monotonic()
            if self._guardian.broken is not None:
                raise self._guardian.broken
            if time.monotonic() - sought > FOUND_S:
                sought = time.monotonic()
                if not (ports.still_held() and wire.still_there(card)):
                    self._guardian.zero("its lock or its socket was removed: nobody could find it")
                    return
            if self._end_requested.is_set():
                self._guardian.zero("the guardian was asked to end")
                return
            lonely = server.had_session or time.monotonic() - begun > alone_s
            needless = server.dismissed.is_set() or (server.session is None and lonely)
            if needless and not (in_doubt and self._guardian.unresolved):
                return

    def _look_at_heartbeats(self) -> None:
        """Let them know that this loop lives; zero where one went wrong."""
        guardian = self._guardian
        guardian.heartbeats.see(at_rest=not guardian.energised, in_doubt=bool(guardian.unresolved))
        if (fault := guardian.heartbeats.fault) is not None and guardian.energised:
            guardian.zero(fault.what, fault=fault)

    def _look_after(self, server: Server) -> None:
        """Zero where the session is gone, or silent for longer than the ramp leaves of two seconds."""
        session = server.session
        if session is None:
            return
        silent_s = time.monotonic() - session.heard_s
        if session.gone:
            if self._guardian.energised:
                self._guardian.zero(f"the connection to {session.who} has ended")
            server.part(session)
        elif self._guardian.energised and silent_s > patience(self._guardian.way_down_s):
            self._guardian.zero(f"{session.who} has been silent for {silent_s:.2f} s")


def take_over(url: str, how: str) -> None:
    """Wait until the port of the guardian before is free; one that hangs is killed."""
    card = ports.holder(url) or {}
    if how == "silent" and "pid" in card and ports.holding(url) in (None, card["pid"]):  # what a card says is no proof
        note(f"guardian {card['pid']} was silent for too long and is killed")
        with suppress(OSError):
            os.kill(card["pid"], getattr(signal, "SIGKILL", signal.SIGTERM))
    deadline = time.monotonic() + FREE_S
    while ports.holder(url) is not None and time.monotonic() < deadline:
        time.sleep(0.005)


def briefed(path: Path, line: str) -> Briefing:
    """What whoever started this process has read of the bench; else what its file says now. Raises InputError."""
    if (found := briefing_of(line)) is not None:
        return found
    from labcal.bench.coils.cage_file import calibrated
    from labcal.bench.config import read_config

    config, fingerprint = read_config(path), wire.fingerprint(path)
    with suppress(InputError, OSError):  # without its matrix zero is brought all the same, and nothing else
        config, _ = calibrated(config, path)
    return Briefing(path, config, fingerprint)


def load_into(loading: Future[Briefing], path: Path, line: str) -> None:
    """Read all of the briefing; what fails is raised where it is asked for."""
    try:
        loading.set_result(briefed(path, line))
    except Exception as error:
        loading.set_exception(error)


def zero_first(path: Path, line: str) -> Handover | None:
    """Bring the coils down by the essentials of a briefing, before the rest of it is loaded; what was found then.

    None where another has the ports, or the briefing says too little.
    """
    if (brief := essentials_of(line)) is None:
        return None
    some = brief.config
    with suppress(InputError):
        ports.meet(some.safety.group, some.safety.runtime)
    if not ports.hold(some.guarded_links):
        return None
    guardian = Guardian(path, some, note, unknown())
    try:
        guardian.zero("the one before is gone, its successor begins")
    finally:
        guardian.close()
    return guardian.handover()


def main(path: Path, how: str, line: str) -> None:
    """Be the guardian of the bench `path`: now, or when the present one dies. `line`: its briefing."""
    for name in ("SIGHUP", "SIGINT"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_IGN)
    handed = (zero_first(path, line) if how == SUCCESSOR else None) or Handover()
    loading = Future[Briefing]()
    some = None if how else essentials_of(line)  # where a session begins, zero waits long for the supplies' answers
    if some is None:
        load_into(loading, path, line)
    bench = some or loading.result()
    config = bench.config
    with suppress(InputError):  # a session has heard it; who takes over does so without the group's folder too
        ports.meet(config.safety.group, config.safety.runtime)
    urls = config.guarded_links
    if how == STANDBY:
        with suppress(InputError):  # a third of a second that is not lost when it counts
            drivers_of(path, cast("BenchConfig", loading.result().config))
        ended, handed = stand_by(sys.stdin)
        if ended == DONE:
            return
        take_over(urls[0], ended)
    if how and not handed.coils:
        handed = unknown()
    if ports.hold(urls):
        watch = Watch(path, bench, handed, loading, line, succeeds=how != "")
        watch.live()
        ports.let_go(in_doubt=watch.in_doubt)


if __name__ == "__main__":
    try:
        options = [option for option in sys.argv[2:] if option != BRIEFED]
        main(Path(sys.argv[1]), "".join(options), sys.stdin.readline() if BRIEFED in sys.argv else "")
    except BaseException:
        try:
            traceback.print_exc()  # into guardian.log
        finally:
            os._exit(1)  # with or without memory for that; its standby takes the ports, which this process lets go of
    written(at_most_s=2.0)
    os._exit(0)  # wait for no thread that still listens to a silent instrument
