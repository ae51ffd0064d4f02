"""The example's lab served on real lines from this process, and sessions on it that are processes of their own.

The supplies are the emulated ones on TCP ports that take one connection each; their coils' currents are read from the
simulated lab in this process, not from what labcal says about them.
"""

from __future__ import annotations

import os
import re
import select
import signal
import socket
import subprocess
import sys
import threading
import time
import tomllib
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

import labcal.bench.serve as serving
from labcal.bench.clock import RealClock
from labcal.bench.guardian.standbys import HOW_MANY
from labcal.bench.links import Nobody
from labcal.bench.loading import Loader
from labcal.files.home import home

EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
LABCAL = [sys.executable, "-m", "labcal"]
ZERO_A = 0.005
LONG_S = 90.0  # a busy machine gets there, a broken one does not
PATIENT_S = 15.0  # of a supply's driver: less than an order's, more than this process may be kept from answering
SESSION = """
import signal, sys, time
from pathlib import Path
from labcal.bench import open_bench
measures = [sys.argv[2] == "measure"]
signal.signal(signal.SIGUSR1, lambda *_: measures.append(True))
with open_bench(Path(sys.argv[1])) as bench:
    bench.cage.set_currents([float(part) for part in sys.argv[3].split(",")])
    print("energised", flush=True)
    if sys.argv[2] == "hang":
        time.sleep(600)
    while True:
        bench.clock.wait_until(bench.clock.now() + 0.1)
        if any(measures):
            bench.cage.currents_A()
"""


def plain() -> str:
    """The example's bench file; its coils are given seven time constants to settle, and no more."""
    return EXAMPLE.read_text(encoding="utf-8").replace("settle_s = 0.3", "settle_s = 0.15")


def example(timeout_s: float = PATIENT_S) -> str:
    """That with supplies which are waited for so long; supply_x takes the interface lock."""
    text = plain()
    for axis, locks in (("x", "true"), ("y", "false"), ("z", "false")):
        settings = f"settings = {{ interface_lock = {locks}, timeout_s = {timeout_s} }}"
        text = text.replace(f'role = "coil-{axis}"', f'role = "coil-{axis}"\n{settings}')
    return text


def three_on_one_pair() -> str:
    """Three Riden supplies on one RS-485 pair, that bear fewer than ten requests a second each."""
    text = plain()
    for number, axis in enumerate("xyz", 1):
        of_tti = f'driver = "tti-pl"\nlink = "emulated://"\nrole = "coil-{axis}"'
        assert of_tti in text
        of_riden = of_tti.replace("tti-pl", "riden-rd60xx").replace("emulated://", "emulated://pair")
        text = text.replace(of_tti, f"{of_riden}\nsettings = {{ address = {number} }}")
    return text


def three_genesys() -> str:
    """Three Genesys on one RS-485 pair, told apart by whom the line heard last."""
    text = three_on_one_pair().replace("riden-rd60xx", "genesys")
    for number in (1, 2, 3):
        text = text.replace(f"{{ address = {number} }}", f"{{ address = {number}, max_current_A = 3.0 }}")
    return text


class OneSocket(serving.TcpOutlet):
    """A supply that takes one connection, and serves no other until that one is gone."""

    def files(self) -> list[int]:
        return super().files()[-1:]  # nobody looks at the port while there is a connection

    def _welcome(self) -> None:
        if self._host is None:
            super()._welcome()


class Stop(Nobody):
    """A line of nobody's that ends the serving when it is pulled."""

    url = ""

    def __init__(self) -> None:
        self._end, self._hand = socket.socketpair()

    def files(self) -> list[int]:
        return [self._end.fileno()]

    def full(self) -> list[int]:
        return []

    def pull(self) -> None:
        self._hand.close()

    def read(self) -> bytes:
        if select.select([self._end], [], [], 0)[0]:
            self._end.close()
            raise InterruptedError
        return b""


class Served:
    """A bench on real lines, served from a thread; `currents` is the truth."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch, bench: str) -> None:
        self.file, self._stop, self._loaders = folder / "served.toml", Stop(), list[Loader]()
        self.clock = RealClock()
        self.lines: list[tuple[Any, Any]] = []
        pump = serving._pump
        ready = threading.Event()

        def loader(*args: Any) -> Loader:
            self._loaders.append(Loader(*args))
            return self._loaders[0]

        def pumped(lines: list[tuple[Any, Any]], clock: Any) -> None:
            self.lines = lines
            pump([*lines, (self._stop, self._stop)], clock)

        monkeypatch.setattr(serving, "_pump", pumped)
        monkeypatch.setattr(serving, "Loader", loader)
        monkeypatch.setattr(serving, "TcpOutlet", OneSocket)
        source = folder / "bench.toml"
        source.write_text(bench)
        self._thread = threading.Thread(target=self._serve, args=(source, ready), daemon=True)
        self._thread.start()
        assert ready.wait(LONG_S)

    def _serve(self, source: Path, ready: threading.Event) -> None:
        with suppress(InterruptedError):
            serving.serve(source, self.file, ready.set, clock=self.clock)

    @property
    def twin(self) -> Any:
        """The simulated lab."""
        return self._loaders[0].twin

    @property
    def coils(self) -> dict[str, Any]:
        """The coils of the simulated lab."""
        return dict(self.twin.coils)

    def currents(self) -> dict[str, float]:
        """What flows now [A]."""
        return {axis: abs(float(coil.current.now(self.clock.now()))) for axis, coil in self.coils.items()}

    def emulator(self, name: str) -> Any:
        """The emulator on the line of the instrument `name`."""
        link = tomllib.loads(self.file.read_text())["instruments"][name]["link"]
        return next(emulator for outlet, emulator in self.lines if outlet.url == link)

    def close(self) -> None:
        self._stop.pull()
        self._thread.join()


class Sessions:
    """Starts sessions that energise the coils of `lab`; `end` ends them, and waits until their guardians are gone."""

    def __init__(self, lab: Served) -> None:
        self._lab, self._started = lab, list[subprocess.Popen[str]]()

    def __call__(
        self, then: str, currents_A: str = "1.0,0.6,0.3", popen: Callable[[], dict[str, Any]] = dict
    ) -> subprocess.Popen[str]:
        """One that does `then`; `popen` gives each attempt what its process is started with."""
        for _ in range(5):  # on a busy machine it may be silent for too long, and begins again
            child = subprocess.Popen(
                [sys.executable, "-c", SESSION, str(self._lab.file), then, currents_A],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **popen(),
            )  # fmt: skip
            self._started.append(child)
            assert child.stdout is not None
            said, wanted = child.stdout.readline(), float(currents_A.split(",")[0])
            if said == "energised\n" and self._lab.currents()["x"] == pytest.approx(wanted, abs=0.01):
                return child
            child.kill()
            until(lambda: not guardians())
        raise AssertionError(f"{said}{child.communicate()[1]}{log()}")

    def end(self) -> None:
        for child in self._started:
            child.kill()
            child.communicate()
        all_gone(self._lab.file)


def until(true: Callable[[], bool]) -> None:
    """Wait until it is true."""
    begun = time.monotonic()
    while not true():
        assert time.monotonic() - begun < LONG_S, f"not within {LONG_S:g} s:\n{log()}"
        time.sleep(0.01)


def at_zero(lab: Served, axes: str = "xyz") -> bool:
    return all(lab.currents()[axis] < ZERO_A for axis in axes)


def guardians() -> set[int]:
    """The living processes that have written into this test's log."""
    return {pid for pid in map(int, re.findall(r"\[(\d+)\]", log())) if alive(pid)}


def alive(pid: int) -> bool:
    """Whether this is a living guardian: of a dead one there is no command line, or another program's."""
    try:
        return b"labcal.bench.guardian" in Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return False


def all_gone(bench: Path) -> None:
    """Wait until no guardian of this bench is left, nor one that stands by; the last means is to kill them.

    One whose supplies have gone would try for ever, and hold the pty that the next test is given.
    """
    try:
        until(lambda: not of_bench(bench))
    finally:
        for pid in of_bench(bench):
            os.kill(pid, signal.SIGKILL)


def end_guardians(lab: Served) -> None:
    """Where supplies stay dead their guardians would try for ever, long after the test."""
    while left := of_bench(lab.file):
        for pid in left:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(0.05)


def of_bench(bench: Path) -> list[int]:
    """The guardians of this bench file, with those that stand by."""
    found = list[int]()
    for place in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):
            words = (place / "cmdline").read_bytes().split(b"\0")
            if b"labcal.bench.guardian" in words and os.fsencode(bench.resolve()) in words:
                found.append(int(place.name))
    return found


def children_of(parent: int) -> list[int]:
    found = list[int]()
    for path in Path(f"/proc/{parent}/task").glob("*/children"):
        with suppress(OSError):  # a thread that has ended since has none
            found += map(int, path.read_text().split())
    return found


def kill_all(child: subprocess.Popen[str]) -> None:
    """End session, guardian and those that stand by, at once: nobody is left who could order zero."""
    (first,) = guardians()
    until(lambda: len(children_of(first)) == HOW_MANY)
    everybody = [*children_of(first), first, child.pid]
    for what in (signal.SIGSTOP, signal.SIGKILL):  # on a busy machine one that is left would act meanwhile
        for pid in everybody:
            os.kill(pid, what)
    child.wait()


def log() -> str:
    path = home() / "guardian.log"
    return path.read_text() if path.exists() else ""


def read_back_after(reason: str) -> bool:
    """Whether the log says why, and then that every coil was read back at zero and open."""
    _, _, after = log().partition(reason)
    return after.split("read back: ")[-1].count("zero, open") == 3


def beginning(lab: Served) -> subprocess.CompletedProcess[str]:
    """Another session that would energise, to its end."""
    start = [sys.executable, "-c", SESSION, str(lab.file), "idle", "1.0,0.6,0.3"]
    return subprocess.run(start, capture_output=True, text=True, check=False, timeout=LONG_S)


def on_a_terminal(session: Sessions, currents_A: str = "1.0,0.6,0.3") -> tuple[subprocess.Popen[str], int]:
    """A session that a person began on a terminal of its own, and the other end of that: to close it is to hang up."""
    import fcntl
    import termios

    ends = list[int]()

    def take_it() -> None:
        os.setsid()
        signal.signal(signal.SIGHUP, signal.SIG_DFL)  # whoever runs the tests may have it ignored
        fcntl.ioctl(ends[-1], termios.TIOCSCTTY, 0)

    def on_it() -> dict[str, Any]:
        ends.extend(os.openpty())  # a terminal whose first session has died serves no other
        return {"stdin": ends[-1], "preexec_fn": take_it}

    child = session("idle", currents_A, on_it)
    terminal = ends[-2]
    for end in ends:
        if end != terminal:
            os.close(end)
    return child, terminal
