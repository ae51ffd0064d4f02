"""What is done to a lab at work."""

from __future__ import annotations

import resource
import signal
import sqlite3
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

from benches import until
from technician import Technician
from trial import Trial

CALLS = {
    "write": ("write,pwrite64,writev", "EIO"),
    "fsync": ("fsync,fdatasync", "EIO"),
    "send": ("sendto,sendmsg", "ECONNRESET"),
    "recv": ("recvfrom,recvmsg", "ECONNRESET"),
}
ATTACHED_S = 15.0
FALLEN_A = 0.02


# processes


def _pids(trial: Trial, who: Sequence[str]) -> list[int]:
    every = {"session": [trial.session.pid], "guardian": [trial.guardian], "standbys": trial.standbys}
    every |= {"worker": [trial.worker], "standby": [trial.standby]}
    return [pid for name in who for pid in every[name] if pid]


def _signalled(trial: Trial, what: signal.Signals, who: Sequence[str], due: bool) -> None:
    trial.signal(what, *_pids(trial, who))
    if due:
        trial.zero_is_due()


def killed(trial: Trial, who: Sequence[str], due: bool) -> None:
    """kill -9."""
    _signalled(trial, signal.SIGKILL, who, due)


def stopped(trial: Trial, who: Sequence[str], due: bool) -> None:
    """SIGSTOP."""
    _signalled(trial, signal.SIGSTOP, who, due)


def hung_up_on(trial: Trial, who: Sequence[str], due: bool) -> None:
    """SIGHUP."""
    _signalled(trial, signal.SIGHUP, who, due)


def told_to_end(trial: Trial, who: Sequence[str], due: bool) -> None:
    """SIGTERM."""
    _signalled(trial, signal.SIGTERM, who, due)


def interrupted_twice(trial: Trial, who: Sequence[str], due: bool) -> None:
    """Ctrl-C, and again before the first is done."""
    for _ in range(2):
        _signalled(trial, signal.SIGINT, who, due)
        trial.wait(0.05, 0.4)


def terminal_closed(trial: Trial) -> None:
    """Its window is closed."""
    trial.session.close_the_terminal()
    trial.zero_is_due()


def suspended(trial: Trial) -> None:
    """All of labcal sleeps, the supplies do not; zero, or going on, is due when it wakes."""
    pids = _pids(trial, ("session", "guardian", "standbys"))
    trial.signal(signal.SIGSTOP, *pids)
    trial.wait(1.0, 8.0)
    trial.signal(signal.SIGCONT, *pids)
    trial.wait(2.0, 3.0)
    if not trial.session.ended:
        trial.session.press_ctrl_c()
    trial.zero_is_due()


def standby_wakes(trial: Trial) -> None:
    """Only the one that stands by was stopped; when it wakes, the guardian beside it is well."""
    trial.signal(signal.SIGSTOP, trial.standby)
    trial.wait(2.0, 5.0)
    trial.signal(signal.SIGCONT, trial.standby)
    trial.wait(1.0, 2.0)


def guardian_wakes(trial: Trial) -> None:
    """The guardian was stopped, and wakes while its successor works, or after."""
    trial.signal(signal.SIGSTOP, trial.guardian)
    trial.zero_is_due()
    trial.wait(1.0, 4.0)  # who is silent for less than 0.8 s is not missed, and nothing is due
    trial.signal(signal.SIGCONT, trial.guardian)
    if not trial.session.ended:
        trial.wait(1.0, 2.0)
        trial.session.press_ctrl_c()


# people


def bench_off(trial: Trial) -> None:
    """`labcal bench off` at another terminal; zero is due from Enter."""
    off = _off_begun(trial)
    until(lambda: off.ended, ATTACHED_S)


def _off_begun(trial: Trial) -> Technician:
    """With all that it has to load: a person waits for that too."""
    trial.zero_is_due()
    command = [sys.executable, "-m", "labcal", "bench", "off", str(trial.bench.file)]
    trial.others.append(Technician(command, trial.bench.env(trial.home)))
    return trial.others[-1]


def all_killed_then_off(trial: Trial) -> None:
    """Nobody is left, until somebody says off."""
    killed(trial, ("session", "guardian", "standbys"), False)
    trial.wait(0.5, 2.0)
    bench_off(trial)


def all_killed_and_off_too(trial: Trial) -> None:
    """Nobody is left; somebody says off, and that is killed while the coils come down."""
    killed(trial, ("session", "guardian", "standbys"), False)
    trial.wait(0.5, 2.0)
    before = trial.bench.ask("currents")  # a ramp that was cut by the kill has settled
    off = _off_begun(trial)
    until(lambda: _has_fallen(trial, before), ATTACHED_S)
    trial.signal(signal.SIGKILL, off.pid)


def _has_fallen(trial: Trial, before: dict[str, float]) -> bool:
    """Whether the coils are on their way down: what a coil does by itself, or noise, is less."""
    now = trial.bench.ask("currents")
    return any(now[axis] < before[axis] - FALLEN_A for axis in before)


def all_stopped_then_off(trial: Trial) -> None:
    """Nobody hears anything any more; somebody says off."""
    stopped(trial, ("session", "guardian", "standbys"), False)
    trial.wait(0.5, 2.0)
    bench_off(trial)


def guardian_stopped_then_off(trial: Trial) -> None:
    """Guardian and all that stand by it stand still, the session goes on; somebody says off."""
    stopped(trial, ("guardian", "standbys"), False)
    trial.wait(0.5, 2.0)
    bench_off(trial)


def all_killed_file_lost_then_off(trial: Trial) -> None:
    """Nobody is left, and the file is not what it was; somebody says off."""
    killed(trial, ("session", "guardian", "standbys"), False)
    trial.wait(0.5, 2.0)
    text = trial.bench.file.read_bytes()
    trial.undo.append(lambda: trial.bench.file.write_bytes(text))
    if trial.chance.random() < 0.5:
        trial.bench.file.write_bytes(text[: trial.chance.randrange(len(text) // 2)])
    else:
        trial.bench.file.unlink()
    bench_off(trial)


def second_labcal(trial: Trial) -> None:
    """Somebody begins a run on the same bench."""
    trial.another("field-hold", "--bench", str(trial.bench.file))
    until(lambda: trial.others[-1].ended, 20.0)


def second_bench(trial: Trial) -> None:
    """Another bench's file names supplies on the same pair."""
    other = trial.home / "other.toml"
    named = '"name" = "simulated cage"'
    text = trial.bench.file.read_text()
    assert named in text
    other.write_text(text.replace(named, '"name" = "the other cage"'))
    trial.another("field-hold", "--bench", str(other))
    until(lambda: trial.others[-1].ended, 20.0)


# supplies


def trouble(trial: Trial, **what: Any) -> None:
    """The line of one supply is troubled in this way."""
    trial.bench.ask("trouble", name=trial.line, seed=trial.chance.randrange(1 << 30), **what)


def deaf(trial: Trial) -> None:
    """It hears nothing any more."""
    trouble(trial, lost_requests=1.0)
    trial.excused = trial.bench.axes_on_line(trial.axis)


def half_open(trial: Trial) -> None:
    """The connection that is there leads nowhere; another one would be served."""
    trial.bench.ask("half_open", name=trial.line)


def lies(trial: Trial, measures_truly: bool) -> None:
    """It says yes and does nothing."""
    trial.bench.ask("lie", axis=trial.axis, measures_truly=measures_truly)
    trial.excused = trial.axis


def trips(trial: Trial) -> None:
    """It switches its output off by itself."""
    trial.bench.ask("panel", axis=trial.axis, current_A=0.5, on=False)


def reboots(trial: Trial) -> None:
    """Its mains fail for a moment, and it comes back with what its panel holds, output on."""
    trial.bench.ask("unplug", name=trial.line)
    for axis in trial.bench.axes_on_line(trial.axis):
        trial.bench.ask("panel", axis=axis, current_A=0.0, on=False)
    trial.wait(0.3, 2.5)
    trial.bench.ask("panel", axis=trial.axis, current_A=round(trial.chance.uniform(0.2, 1.0), 3), on=True)
    trial.bench.ask("plug", name=trial.line)
    for axis in trial.bench.axes_on_line(trial.axis):
        trial.due_of[axis] = time.monotonic()


def dropped(trial: Trial) -> None:
    """Its cable is out."""
    trial.bench.ask("unplug", name=trial.line)
    trial.excused = trial.bench.axes_on_line(trial.axis)


def dropped_and_back(trial: Trial) -> None:
    """Its cable is out for a while."""
    trial.bench.ask("unplug", name=trial.line)
    trial.wait(0.3, 4.0)
    trial.bench.ask("plug", name=trial.line)
    for axis in trial.bench.axes_on_line(trial.axis):
        trial.due_of[axis] = time.monotonic()


def swapped(trial: Trial) -> None:
    """Two cables are out, and each goes into the other's supply."""
    other = trial.chance.choice([axis for axis in "xyz" if axis != trial.axis])
    names = (trial.line, trial.bench.line_of(other))
    for name in names:
        trial.bench.ask("unplug", name=name)
    trial.wait(0.3, 2.0)
    trial.bench.ask("swap", one=names[0], other=names[1])
    for axis, name in zip((trial.axis, other), names, strict=True):
        trial.bench.ask("plug", name=name)
        trial.due_of[axis] = time.monotonic()


# sensors


def out(trial: Trial, name: str) -> None:
    """Its cable is out."""
    trial.bench.ask("unplug", name=name)


def out_and_in(trial: Trial, name: str) -> None:
    """Its cable is out for a while."""
    trial.bench.ask("unplug", name=name)
    trial.wait(0.3, 3.0)
    trial.bench.ask("plug", name=name)


def frozen(trial: Trial, name: str) -> None:
    """A sensor repeats itself; what is asked does not answer."""
    if name in ("reference", "dut"):
        trial.bench.ask("freeze", role=name)
    else:
        trial.bench.ask("trouble", name=name, lost_requests=1.0)


def truck(trial: Trial) -> None:
    """A lorry stops beside the cage: the reference is at the end of its range."""
    trial.bench.ask("truck", field_nT=[0.0, 0.0, trial.chance.choice((-1, 1)) * 4e5])


# the store


def _store_files(trial: Trial) -> list[Path]:
    return [path for path in trial.home.glob("store.sqlite*") if path.is_file()]


def store_full(trial: Trial) -> None:
    """No file of the session's grows any more."""
    most = max(path.stat().st_size for path in _store_files(trial))
    _, hard = resource.prlimit(trial.session.pid, resource.RLIMIT_FSIZE)
    resource.prlimit(trial.session.pid, resource.RLIMIT_FSIZE, (most, hard))


def store_locked(trial: Trial) -> None:
    """Another program holds it."""
    held = sqlite3.connect(trial.store, isolation_level=None, check_same_thread=False, timeout=10.0)
    held.execute("BEGIN IMMEDIATE")
    trial.undo.append(held.close)


def store_read_only(trial: Trial) -> None:
    """The disk has been mounted anew to be read only."""
    _injected(trial, trial.session.pid, "pwrite64,fdatasync,fsync", "error=EROFS")


def slow_disk(trial: Trial) -> None:
    """Every flush takes seconds."""
    _injected(trial, trial.session.pid, "fdatasync,fsync", "delay_enter=3s")


def store_unlinked(trial: Trial) -> None:
    """Somebody has tidied up."""
    for path in _store_files(trial):
        path.unlink()


def page_overwritten(trial: Trial) -> None:
    """A page in the middle is another program's."""
    size = trial.store.stat().st_size
    with trial.store.open("r+b") as file:
        file.seek(4096 * max(1, size // 4096 // 2))
        file.write(trial.chance.randbytes(4096))


# the machine


def clock_set(trial: Trial, seconds: float) -> None:
    """The session's wall clock jumps."""
    (trial.home / "clock").write_text(str(seconds))


def _of(trial: Trial, whom: str) -> int:
    return trial.session.pid if whom == "session" else trial.guardian


def out_of_memory(trial: Trial, whom: str) -> None:
    """It gets no more than it has."""
    pid = _of(trial, whom)
    now = int(Path(f"/proc/{pid}/statm").read_text().split()[0]) * resource.getpagesize()
    resource.prlimit(pid, resource.RLIMIT_AS, (now, resource.prlimit(pid, resource.RLIMIT_AS)[1]))


def out_of_handles(trial: Trial, whom: str) -> None:
    """It can open nothing more."""
    pid = _of(trial, whom)
    resource.prlimit(pid, resource.RLIMIT_NOFILE, (3, resource.prlimit(pid, resource.RLIMIT_NOFILE)[1]))


def call_fails(trial: Trial, whom: str, call: str) -> None:
    """One of the next fails, once."""
    calls, error = CALLS[call]
    _injected(trial, _of(trial, whom), calls, f"error={error}:when={trial.chance.randint(1, 4)}", once=True)


def _injected(trial: Trial, pid: int, calls: str, what: str, *, once: bool = False) -> None:
    """The kernel answers so from now on."""
    command = ["strace", "-f", "-p", str(pid), "-e", f"trace={calls}", "-e", f"inject={calls}:{what}"]
    tracer = subprocess.Popen(command, stderr=subprocess.PIPE)
    trial.helpers.append(tracer)
    assert tracer.stderr is not None
    tracer.stderr.readline()  # "attached"
    threading.Thread(target=_heard_out, args=(tracer, once), daemon=True).start()


def _heard_out(tracer: subprocess.Popen[bytes], once: bool) -> None:
    """Read what the tracer says; it lets go after the first call that has failed, where it is to be one."""
    assert tracer.stderr is not None
    with suppress(ValueError, OSError):
        for line in tracer.stderr:
            if once and b"INJECTED" in line:
                tracer.terminate()
