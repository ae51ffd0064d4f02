"""One trial: a session at work on a bench, a deed at a moment that the seed says, and what came of it."""

from __future__ import annotations

import os
import random
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

import lateness
from benches import Bench, until
from judge import false_claims, first_zero, flowing, rises, zero_for_good, zero_heard
from short_preflight import SHORT
from technician import Technician, processes_of

from labcal.bench.guardian.standbys import HOW_MANY

if TYPE_CHECKING:
    from kinds import Kind

HERE = Path(__file__).parent
WINDOW = HERE / "window_at_work.py"
BEGINS_S, ENDS_S = 90.0, 30.0  # a session's start on a busy machine; its end, after zero was due, over a slow line
IN_TIME_S = 2.0
LONGER_S = 1.5  # the coils are watched so long after everything seems over
FLOWS_A = 0.05
STAMPED = re.compile(r"(\S+Z) \[(\d+)\] (.*)")


@dataclass
class Trial:
    """What a deed may use. `due_s`: when zero was due (monotonic clock), of some axes later; `excused`: cannot hear."""

    bench: Bench
    chance: random.Random
    home: Path
    session: Technician
    guardian: int
    standbys: list[int]
    axis: str  # whose supply the deed is about, where it is about one
    energised_s: float
    due_s: float | None = None
    rows: list[Any] = field(default_factory=list)  # committed just before the deed
    due_of: dict[str, float] = field(default_factory=dict)
    excused: str = ""
    others: list[Technician] = field(default_factory=list)
    helpers: list[subprocess.Popen[bytes]] = field(default_factory=list)
    undo: list[Any] = field(default_factory=list)

    @property
    def standby(self) -> int:
        """The first of those that stand by; 0 where none does."""
        return (self.standbys or [0])[0]

    @property
    def store(self) -> Path:
        """The session's store."""
        return self.home / "store.sqlite"

    @property
    def worker(self) -> int:
        """The process in which the window's run goes on; 0 at a terminal."""
        return worker_of(self.session)

    @property
    def line(self) -> str:
        """The line of the supply that the deed is about."""
        return self.bench.line_of(self.axis)

    def zero_is_due(self) -> None:
        """From now on the coils have to go to zero."""
        if self.due_s is None:
            self.due_s = time.monotonic()

    def signal(self, what: signal.Signals, *pids: int) -> None:
        """Send it to each of these, at once."""
        for pid in pids:
            with suppress(ProcessLookupError):
                os.kill(pid, what)

    def another(self, *words: str) -> Technician:
        """Somebody else's labcal on this bench, with the same user's folders."""
        self.others.append(Technician.runs(list(words), self.bench.env(self.home)))
        return self.others[-1]

    def wait(self, shortest_s: float, longest_s: float) -> None:
        """A while that the seed says."""
        time.sleep(self.chance.uniform(shortest_s, longest_s))


def worker_of(session: Technician) -> int:
    """The process of which the window has said that its run goes on there; 0 at a terminal."""
    return next((int(words) for _, words in session.said if words.isdigit()), 0)


class NotBegun(Exception):
    """The session did not energise anything: no trial."""


def try_out(kind: Kind, seed: int, bench: Bench) -> dict[str, Any]:
    """One trial; everything that is known of it afterwards."""
    chance = random.Random(f"{kind.name} {seed}")
    home = Path(tempfile.mkdtemp(prefix="home-", dir=bench.folder))
    bench.ask("well")
    bench.ask("begin")
    begun_utc = time.time() - time.monotonic()
    session = _begun(kind, chance, bench, home)
    trial = None
    try:
        trial = _at_work(kind, chance, bench, home, session)
        record = _done_and_watched(kind, seed, trial, begun_utc)
    finally:
        left = _cleared_away(bench, session, trial)
        lost = rows_lost(home / "store.sqlite", trial.rows if trial else [])
        shutil.rmtree(home, ignore_errors=True)
    return record | {"left": left, "rows_lost": lost}


def _begun(kind: Kind, chance: random.Random, bench: Bench, home: Path) -> Technician:
    """Somebody begins a run, at a terminal or in the window."""
    env = bench.env(home) | {"CAMPAIGN_CLOCK": str(home / "clock")}
    if kind.window:
        return Technician([sys.executable, str(WINDOW), str(bench.file), str(home / "window.ini")], env)
    return Technician.runs(_words(kind, chance, bench), env)


def _words(kind: Kind, chance: random.Random, bench: Bench) -> list[str]:
    """The command: a procedure that holds a field and moves it, mostly; a feedback's hold or a preflight else."""
    where = ["--bench", str(bench.file), "--operator", "J. Doe"]
    field_nT = [chance.choice((-1, 1)) * chance.uniform(15e3, 55e3) for _ in "xyz"]
    told = "field_nT=" + ",".join(f"{value:.0f}" for value in field_nT)
    pick = chance.random()
    if pick < 0.75 or not kind.any_procedure:
        return [str(HERE / "hold_and_move.py"), *where, "--set", told]
    if pick < 0.9:
        return ["field-hold", *where, "--set", told, "--set", "duration_s=600", "--set", "period_s=1"]
    return ["preflight", *where, *(word for key, value in SHORT.items() for word in ("--set", f"{key}={value}"))]


def _at_work(kind: Kind, chance: random.Random, bench: Bench, home: Path, session: Technician) -> Trial:
    """Wait until current flows, and then as long as the seed says: on the ramp, or later."""
    flows = until(lambda: session.ended or max(bench.ask("currents").values()) > FLOWS_A, BEGINS_S)
    if session.ended or not flows:
        raise NotBegun("\n".join(line for _, line in session.said[-8:]))
    energised_s = time.monotonic()
    time.sleep(chance.choice((chance.uniform(0.0, 0.4), chance.uniform(0.4, 3.5))))
    until(lambda: len(processes_of(bench.file)["standby"]) == HOW_MANY, 10.0)
    if kind.standby_ready:
        time.sleep(1.5)
    found, currents = processes_of(bench.file), bench.ask("currents")
    at_work = [axis for axis in "xyz" if currents[axis] > FLOWS_A] or ["z"]
    if session.ended:
        raise NotBegun("\n".join(line for _, line in session.said[-8:]))
    return Trial(
        bench, chance, home, session, (found["guardian"] or [0])[0], found["standby"],
        chance.choice(at_work), energised_s,
    )  # fmt: skip


def _done_and_watched(kind: Kind, seed: int, trial: Trial, begun_utc: float) -> dict[str, Any]:
    trial.rows = committed(trial.store)
    flowed, load = trial.bench.ask("currents"), os.getloadavg()[0]
    deed_s = time.monotonic()
    kind.does(trial)
    if kind.stops:
        trial.wait(0.5, 3.0)
        if not trial.session.ended:
            trial.session.press_ctrl_c()
            trial.due_s = time.monotonic() if trial.due_s is None else trial.due_s
    if trial.due_s is None:
        trial.due_s = time.monotonic()
    trial.due_s = min([trial.due_s, *_ordered(trial.home, begun_utc, deed_s)])
    _watch(kind, trial)
    truth, said = trial.bench.ask("truth"), _said(trial, begun_utc, deed_s)
    last = list(_ordered(trial.home, begun_utc, deed_s))
    return {
        "kind": kind.name, "seed": seed, "bench": trial.bench.kind, "load": round(load, 2),
        "moment_s": round(deed_s - trial.energised_s, 2),
        "axis": trial.axis, "flowed_A": {a: round(i, 3) for a, i in flowed.items()},
        "due_after_deed_s": round(trial.due_s - deed_s, 3),
        "ordered_s": round(min(last) - deed_s, 3) if last else None,
        "code": trial.session.code,
        "rows_before": len(trial.rows),
        "traceback": any("Traceback" in words for _, words in said),
        "words": [[round(t_s - deed_s, 2), words] for t_s, words in said],
    } | _judged(kind, trial, truth, said, min(last, default=None), deed_s)  # fmt: skip


def _judged(
    kind: Kind,
    trial: Trial,
    truth: dict[str, Any],
    said: list[tuple[float, str]],
    by_log_s: float | None,
    deed_s: float,
) -> dict[str, Any]:
    assert trial.due_s is not None
    zero, heard, rose = dict[str, float | None](), dict[str, float | None](), dict[str, Any]()
    for axis in "xyz":
        due_s = max(trial.due_s, trial.due_of.get(axis, 0.0))
        at = zero_for_good(truth["flow"][axis], truth["tau_s"][axis], truth["now_s"])
        got = zero_heard(truth["heard"][axis], due_s)
        ordered_s = first_zero(truth["sent"][axis], due_s) if by_log_s is None else by_log_s
        zero[axis] = None if at is None else round(max(at - due_s, 0.0), 3)
        heard[axis] = None if got is None else round(got - due_s, 3)
        rose[axis] = [[round(t_s - deed_s, 3), *levels] for t_s, *levels in rises(truth["sent"][axis], ordered_s)]
    counted = [axis for axis in "xyz" if axis not in trial.excused]
    worst = _worst(zero[axis] for axis in counted)
    late = trial.due_s + (IN_TIME_S if worst is None else worst)
    left = {axis: flowing(truth["flow"][axis], truth["tau_s"][axis], truth["now_s"]) for axis in "xyz"}
    return {
        "at_zero_s": worst, "heard_s": _worst(heard[axis] for axis in counted), "excused": trial.excused,
        "zero_of": zero, "heard_of": heard, "rose": {axis: found for axis, found in rose.items() if found},
        "false_zero": [[round(t - deed_s, 2), axis, round(i, 3), w] for t, axis, i, w in false_claims(said, truth)],
        "left_A": {axis: round(i, 3) for axis, i in left.items() if i > FLOWS_A},
        "machine_late_s": round(lateness.kept_waiting(trial.due_s, late), 3),
        "limit_s": IN_TIME_S + kind.late_s,
    }  # fmt: skip


def _worst(times: Any) -> float | None:
    known = list(times)
    return None if None in known else max(known, default=0.0)


def _watch(kind: Kind, trial: Trial) -> None:
    """Until all is at zero and over for a while, or long after it had to be."""
    quiet_since: float | None = None
    assert trial.due_s is not None
    begun, over_s = time.monotonic(), max([trial.due_s, *trial.due_of.values()]) + ENDS_S + 2 * kind.late_s
    while (now := time.monotonic()) < over_s:
        quiet = trial.session.ended and trial.bench.at_rest() and now > begun + 2 * kind.late_s
        if kind.never and now > begun + 4.0:
            return
        if kind.session_stopped:
            quiet = trial.bench.at_rest()
        quiet_since = (quiet_since or now) if quiet else None
        if quiet_since is not None and now - quiet_since > LONGER_S + kind.late_s:
            return
        time.sleep(0.05)


def _said(trial: Trial, begun_utc: float, since_s: float) -> list[tuple[float, str]]:
    """What session, guardian and whoever else said from `since_s` on, in order, each with its monotonic time."""
    spoken = [(t_s, f"session: {words}") for t_s, words in trial.session.words()]
    for other in trial.others:
        spoken += [(t_s, f"another: {words}") for t_s, words in other.words()]
    spoken += [(t_s, f"guardian.log: {words}") for t_s, words in log_of(trial.home, begun_utc)]
    return sorted((t_s, words) for t_s, words in spoken if t_s >= since_s)


def log_of(home: Path, begun_utc: float) -> list[tuple[float, str]]:
    """The lines of guardian.log with monotonic times; one without a stamp has that of the line before."""
    path, lines, t_s = home / "guardian.log", list[tuple[float, str]](), 0.0
    for line in path.read_text(errors="replace").splitlines() if path.exists() else ():
        words = line
        if found := STAMPED.match(line):
            t_s = datetime.fromisoformat(found[1]).timestamp() - begun_utc
            words = f"[{found[2]}] {found[3]}"
        lines.append((t_s, words))
    return lines


def _ordered(home: Path, begun_utc: float, since_s: float) -> list[float]:
    """When the guardian began to bring the coils to zero, by its own log."""
    return [t_s for t_s, words in log_of(home, begun_utc) if "] to zero:" in words and t_s > since_s]


def committed(store: Path) -> list[Any]:
    """The rows that another program sees in the store; none where it sees no store."""
    with suppress(sqlite3.Error):
        reader = sqlite3.connect(f"file:{store}?mode=ro", uri=True, timeout=5.0)
        try:
            return reader.execute("SELECT number, kind, t_s, length(content), length(samples) FROM item").fetchall()
        finally:
            reader.close()
    return []


def rows_lost(store: Path, before: list[Any]) -> int:
    """How many of the rows that were committed are not there any more, or are others."""
    after = {row[0]: row for row in committed(store)}
    return sum(after.get(row[0]) != row for row in before)


def _cleared_away(bench: Bench, session: Technician, trial: Trial | None) -> list[str]:
    """Everything well again and everybody gone; what had to be ended by force is named."""
    for undo in trial.undo if trial else ():
        with suppress(OSError):
            undo()
    for helper in trial.helpers if trial else ():
        helper.kill()
        helper.wait()
    worker = worker_of(session)
    bench.ask("well")
    for somebody in (session, *(trial.others if trial else ())):
        somebody.leave()
    if worker:
        with suppress(ProcessLookupError):
            os.kill(worker, signal.SIGKILL)
    for pid in _guardians(bench):
        with suppress(OSError):
            os.kill(pid, signal.SIGCONT)
    until(lambda: not _guardians(bench), 12.0)
    left = _guardians(bench)
    for pid in left:
        with suppress(OSError):
            os.kill(pid, signal.SIGKILL)
    until(lambda: not _guardians(bench), 10.0)
    for axis in "xyz":
        if not bench.at_rest():
            bench.ask("panel", axis=axis, current_A=0.0, on=False)
    until(bench.at_rest, 5.0)
    return [f"{len(left)} guardian processes"] if left else []


def _guardians(bench: Bench) -> list[int]:
    return [pid for pids in processes_of(bench.file).values() for pid in pids]
