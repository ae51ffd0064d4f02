"""Many runs are made ready by several processes: the same is pushed, whoever of them is killed."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import in_archive, rows_of
from made_lab import stored_runs
from postgres import Server, children_of

from labcal.archive.ahead import FEW
from labcal.archive.run_to_push import of_store, of_store_into, taken
from labcal.session import archiving
from labcal.system.workers import cores

RUNS, SAMPLES, WITHIN_S = FEW + 6, 500, 60.0
AT_ONCE = pytest.mark.skipif(
    cores() < 2 or not Path("/proc/self/stat").exists(), reason="needs two cores, and processes are looked for in /proc"
)


def running(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def wait_until_gone(processes: set[int]) -> None:
    until = time.monotonic() + WITHIN_S
    while any(map(running, processes)):
        assert time.monotonic() < until
        time.sleep(0.02)


def test_by_processes_of_which_one_is_killed_and_by_none_the_same_is_pushed(
    postgres: Server, database: str, url: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    stored_runs(range(RUNS), SAMPLES)
    came, killed = list[str](), list[int]()

    def kill_once(remark: str) -> None:
        came.append(remark)
        if len(came) == 3:
            killed.extend(child.pid for child in multiprocessing.active_children()[:1] if child.pid)
            os.kill(killed[0], signal.SIGKILL)

    monkeypatch.setattr("labcal.session.pushing.worth_it", lambda number: 2)
    found = archiving.push(url, on_remark=kill_once)
    assert (found.runs, found.refused, len(killed)) == (RUNS, (), 1)
    assert came == [f"run size-{number}" for number in range(RUNS)]
    by_two = in_archive(postgres, database, tmp_path / "bundles")

    monkeypatch.setattr("labcal.session.pushing.worth_it", lambda number: 0)
    other = postgres.url(again := postgres.database())
    archiving.init_archive(other, None)
    assert archiving.push(f"{other}&bundles={tmp_path / 'again'}&site=aalto").runs == RUNS
    assert in_archive(postgres, again, tmp_path / "again") == by_two


@AT_ONCE
@pytest.mark.parametrize(
    "how", [signal.SIGKILL, pytest.param(signal.SIGINT, marks=pytest.mark.slow)], ids=["killed", "Ctrl-C"]
)
def test_a_push_that_is_cut_leaves_no_process_and_nothing_half(
    how: signal.Signals, postgres: Server, database: str, url: str, tmp_path: Path
) -> None:
    """Ctrl-C reaches all processes of the terminal, and none says anything of its own."""
    runs = RUNS if how == signal.SIGKILL else 3 * RUNS  # so many that a busy computer does not cut it after the last
    stored_runs(range(runs), 4 * SAMPLES)
    bundles = tmp_path / "bundles"
    environment = {**os.environ, "LABCAL_ARCHIVE": url}
    program = "from labcal.start import main\nif __name__ == '__main__':\n    main()\n"
    (script := tmp_path / "labcal_push.py").write_text(program)
    words = [sys.executable, str(script), "push"]
    push = subprocess.Popen(
        words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, start_new_session=True
    )
    until = time.monotonic() + WITHIN_S
    while len(list(bundles.rglob("*.zip"))) < 3:
        assert time.monotonic() < until, push.poll()
        time.sleep(0.002)
    processes = children_of(push.pid)
    assert len(processes) >= 2
    if how == signal.SIGINT:
        os.killpg(push.pid, how)
    else:
        push.kill()
    told = push.communicate(timeout=WITHIN_S)[1]
    wait_until_gone(processes)
    assert "Traceback" not in told
    assert push.returncode == (130 if how == signal.SIGINT else -9), told
    there = rows_of(postgres, database)["run"]
    assert len(there) < runs
    assert {f"{row[15]}.zip" for row in there} <= {path.name for path in bundles.rglob("*.zip")}
    assert archiving.push(url).runs == runs - len(there)
    assert len(rows_of(postgres, database)["run"]) == runs
    assert archiving.check_archive(url, None) == []


def test_what_a_process_says_of_a_run_goes_into_a_pipe_at_one_go(tmp_path: Path) -> None:
    """One that is killed inside a longer answer, at Ctrl-C, leaves half of it, and who reads it waits for ever."""
    stored_runs([0], 20_000)
    said = of_store_into(str(tmp_path), "size-0")
    assert len(pickle.dumps(said)) < 4096  # PIPE_BUF of Linux
    assert taken(*said) == of_store("size-0")
    assert not said[1].exists()
