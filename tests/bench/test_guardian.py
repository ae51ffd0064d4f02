"""The guardian with real processes, real lines and the real clock: whatever happens, the coils are at zero.

The supplies are the emulated ones on TCP ports that take one connection each; their coils' currents are read from the
simulated lab in this process, not from what labcal says about them. What is waited for here has no deadline that a
busy machine could miss; `test_guardian_in_time.py` holds the stopwatch.
"""

from __future__ import annotations

import fcntl
import os
import re
import signal
import subprocess
import sys
import termios
import threading
import time
import tomllib
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import pytest

import labcal.bench.serve as serving
from labcal.bench.clock import RealClock
from labcal.bench.loading import Loader
from labcal.home import home

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="SIGKILL, SIGSTOP and ptys")
EXAMPLE = Path(__file__).parents[2] / "examples" / "simulated.toml"
LABCAL = [sys.executable, "-c", "from labcal.cli import main; main()"]
ZERO_A = 0.005
LONG_S = 90.0  # a busy machine gets there, a broken one does not
SESSION = """
import sys, time
from pathlib import Path
from labcal.bench import open_bench
with open_bench(Path(sys.argv[1])) as bench:
    bench.cage.set_currents([1.0, 0.6, 0.3])
    print("energised", flush=True)
    if sys.argv[2] == "hang":
        time.sleep(60)
    while True:
        bench.clock.wait_until(bench.clock.now() + 0.1)
        if sys.argv[2] == "measure":
            bench.cage.currents_A()
"""


class OneSocket(serving.TcpOutlet):
    """A supply that takes one connection, and serves no other until that one is gone."""

    def read(self) -> bytes:
        if self._host is None:
            return super().read()
        try:
            data = self._host.recv(65536)
        except BlockingIOError:
            return b""
        except OSError:
            data = b""
        if not data:
            self._host.close()
            self._host = None
        return data


class Served:
    """The example bench on real lines, served from a thread; `current` is the truth, `mute` silences a supply."""

    def __init__(self, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self.file, self._stop, self._loaders = folder / "served.toml", threading.Event(), list[Loader]()
        self.clock = RealClock()
        self.lines: list[tuple[Any, Any]] = []
        pump = serving._pump
        ready = threading.Event()

        def loader(*args: Any) -> Loader:
            self._loaders.append(Loader(*args))
            return self._loaders[0]

        def pumped(lines: list[tuple[Any, Any]], clock: Any) -> None:
            self.lines = lines
            pump(lines, clock)

        monkeypatch.setattr(serving, "_pump", pumped)
        monkeypatch.setattr(serving, "Loader", loader)
        monkeypatch.setattr(serving, "TcpOutlet", OneSocket)
        monkeypatch.setattr(self.clock, "wait_until", self._wait)
        source = folder / "bench.toml"
        text = EXAMPLE.read_text().replace("settle_s = 0.3", "settle_s = 0.0")
        source.write_text(text.replace('role = "coil-x"', 'role = "coil-x"\nsettings = { interface_lock = true }'))
        self._thread = threading.Thread(target=self._serve, args=(source, ready), daemon=True)
        self._thread.start()
        assert ready.wait(30)

    def _serve(self, source: Path, ready: threading.Event) -> None:
        with suppress(InterruptedError):
            serving.serve(source, self.file, ready.set, clock=self.clock)

    def _wait(self, t_s: float) -> None:
        if self._stop.is_set():
            raise InterruptedError
        time.sleep(max(0.0, t_s - self.clock.now()))

    @property
    def coils(self) -> dict[str, Any]:
        """The coils of the simulated lab."""
        return dict(self._loaders[0].twin.coils)

    def currents(self) -> dict[str, float]:
        """What flows now [A]."""
        return {axis: abs(float(coil.current.now(self.clock.now()))) for axis, coil in self.coils.items()}

    def emulator(self, name: str) -> Any:
        """The emulator on the line of the instrument `name`."""
        link = tomllib.loads(self.file.read_text())["instruments"][name]["link"]
        return next(emulator for outlet, emulator in self.lines if outlet.url == link)

    def close(self) -> None:
        self._stop.set()
        self._thread.join(5)


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    served = Served(tmp_path, monkeypatch)
    yield served
    served.close()


@pytest.fixture
def session(lab: Served) -> Iterator[Callable[[str], subprocess.Popen[str]]]:
    """Starts a session that energises the coils; at the end it and its guardians are gone."""
    started: list[subprocess.Popen[str]] = []

    def start(then: str, **popen: Any) -> subprocess.Popen[str]:
        for _ in range(5):  # on a busy machine it may be silent for too long, and begins again
            child = subprocess.Popen(
                [sys.executable, "-c", SESSION, str(lab.file), then],
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **popen,
            )  # fmt: skip
            started.append(child)
            assert child.stdout is not None
            said = child.stdout.readline()
            if said == "energised\n" and lab.currents()["x"] == pytest.approx(1.0, abs=0.01):
                return child
            child.kill()
            until(lambda: not guardians())
        raise AssertionError(f"{said}{child.communicate()[1]}{log()}")

    yield start
    for child in started:
        child.kill()
        child.communicate()
    until(lambda: not guardians())


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
    status = Path(f"/proc/{pid}/stat")
    try:
        return status.read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def children_of(parent: int) -> list[int]:
    listed = [path.read_text() for path in Path(f"/proc/{parent}/task").glob("*/children")]
    return [int(pid) for pid in " ".join(listed).split()]


def log() -> str:
    path = home() / "guardian.log"
    return path.read_text() if path.exists() else ""


def read_back_after(reason: str) -> bool:
    """Whether the log says why, and then that every coil was read back at zero and open."""
    _, _, after = log().partition(reason)
    return after.split("read back: ")[-1].count("zero, open") == 3


def test_a_session_that_is_killed_leaves_the_coils_at_zero(lab: Served, session: Any) -> None:
    session("idle").kill()
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("is gone"))
    until(lambda: not guardians())


def test_a_session_that_loses_its_terminal_leaves_the_coils_at_zero(lab: Served, session: Any) -> None:
    terminal, its_end = os.openpty()

    def on_this_terminal() -> None:
        os.setsid()
        fcntl.ioctl(its_end, termios.TIOCSCTTY, 0)

    child = session("idle", stdin=its_end, preexec_fn=on_this_terminal)
    os.close(its_end)
    os.close(terminal)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("is gone"))
    assert child.wait(LONG_S) == -signal.SIGHUP


@pytest.mark.parametrize("how", ["SIGSTOP", pytest.param("hang", marks=pytest.mark.slow)])
def test_a_session_that_stops_or_hangs_with_the_lock_held_loses_its_coils(lab: Served, session: Any, how: str) -> None:
    child = session("hang" if how == "hang" else "idle")
    if how == "SIGSTOP":
        os.kill(child.pid, signal.SIGSTOP)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("has been silent for"))
    assert child.poll() is None


def test_off_is_obeyed_while_a_session_hangs_and_no_other_session_may_begin(lab: Served, session: Any) -> None:
    child = session("measure")
    second = beginning(lab)
    assert f"session {child.pid} drives this bench" in second.stderr
    assert "energised" not in second.stdout
    os.kill(child.pid, signal.SIGSTOP)
    off = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, check=False)
    assert (off.returncode, off.stdout.count("zero, open")) == (0, 3), off.stderr
    assert at_zero(lab)
    os.kill(child.pid, signal.SIGCONT)
    _, said = child.communicate(timeout=LONG_S)
    assert "was taken to zero" in said


def test_a_killed_guardian_is_replaced_by_one_that_begins_with_zero(lab: Served, session: Any) -> None:
    child = session("measure")
    (first,) = guardians()
    os.kill(first, signal.SIGKILL)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))
    assert guardians() - {first}
    _, said = child.communicate(timeout=LONG_S)
    assert "the guardian was killed" in said


def test_a_guardian_killed_with_its_session_is_replaced_all_the_same(lab: Served, session: Any) -> None:
    child = session("idle")
    (first,) = guardians()
    until(lambda: bool(children_of(first)))
    os.kill(first, signal.SIGKILL)
    child.kill()
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))


def test_one_silent_supply_keeps_no_other_from_zero_and_the_next_start_is_refused(lab: Served, session: Any) -> None:
    child = session("idle")
    emulator = lab.emulator("supply_x")
    emulator.emit = lambda until_s: []
    child.kill()
    until(lambda: at_zero(lab, "yz"))
    until(lambda: re.search("coil x unknown, .*no reply", log()) is not None)
    assert guardians()
    refused = beginning(lab)
    assert "no reply" in refused.stderr
    assert "energised" not in refused.stdout
    del emulator.emit
    until(lambda: "at last: coil x +0.0000 A, zero, open" in log())


@pytest.mark.slow
def test_where_both_guardians_are_killed_the_session_starts_another(lab: Served, session: Any) -> None:
    session("idle")
    (first,) = guardians()
    until(lambda: bool(children_of(first)))
    for pid in (*children_of(first), first):
        os.kill(pid, signal.SIGKILL)
    until(lambda: at_zero(lab))
    until(lambda: read_back_after("its successor begins"))


def beginning(lab: Served) -> subprocess.CompletedProcess[str]:
    """Another session that would energise, to its end."""
    start = [sys.executable, "-c", SESSION, str(lab.file), "idle"]
    return subprocess.run(start, capture_output=True, text=True, check=False, timeout=LONG_S)
