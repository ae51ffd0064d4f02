"""kill -9 at random moments: every committed row survives, the run shows as interrupted, and resuming completes it."""

from __future__ import annotations

import multiprocessing
import random
import sqlite3
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from short_preflight import SHORT

from labcal import session
from labcal.files.home import home
from labcal.record.stream import Item, Prompt, Step
from labcal.store import Store

BenchFile = Callable[..., Path]
# It takes a second and more to compute: longer than the moments at which it is killed.
BRIEF = SHORT | {"dwell_s": "0.5", "rate_deg_per_s": "2", "magnitudes_nT": "20000, 30000, 40000", "reverse": "yes"}
CHILDREN = multiprocessing.get_context("forkserver")
CHILDREN.set_forkserver_preload(["labcal.session", "procedures.preflight", "labcal.twin"])


def committed() -> int:
    """How many items another program sees in the store now."""
    path = home() / "store.sqlite"
    if not path.exists():
        return 0
    try:
        with sqlite3.connect(f"file:{path}?mode=ro", uri=True) as reader:
            return int(reader.execute("SELECT count(*) FROM item").fetchone()[0])
    except sqlite3.OperationalError:
        return 0


def killed_after(bench: Path, seconds: float) -> int:
    """Start a preflight, kill it so long after its first committed row; returns the rows seen just before."""
    store = home() / "store.sqlite"
    child = CHILDREN.Process(
        target=session.run, args=("preflight", bench, BRIEF), kwargs={"run_id": "R", "seed": 2, "store": store}
    )
    child.start()
    while not (seen := committed()) and child.is_alive():
        time.sleep(0.02)
    end = time.monotonic() + seconds
    while time.monotonic() < end and child.is_alive():
        seen = max(seen, committed())
        time.sleep(0.05)
    child.kill()
    child.join()
    return seen


def survive(bench: Path, seconds: float) -> str:
    """One kill and what must hold after it; returns how the run stood."""
    seen = killed_after(bench, seconds)
    assert committed() >= seen
    with sqlite3.connect(home() / "store.sqlite") as database:
        assert database.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    with Store.open() as store:
        before, status = list(store.items("R")), store.status("R")
    if status == "interrupted":
        outcome = session.resume("R", bench, seed=2)
        assert outcome.status == "finished", outcome.fault
        with Store.open() as store:
            after = list(store.items("R"))
        assert [i.t_s for i in after[: len(before)] if isinstance(i, Step)] == steps_at(before)
        goes_on_after_the_last_finished_step(before, after[len(before) :])
        assert {s.id for s in session.load_run("R").segments} >= {"z+20uT-nominal"}
    return status


def steps_at(items: list[Item]) -> list[float]:
    return [i.t_s for i in items if isinstance(i, Step)]


def goes_on_after_the_last_finished_step(before: list[Item], after: list[Item]) -> None:
    finished = [i.name for i in before if isinstance(i, Step)][:-1]
    repeated = [i.name for i in after if isinstance(i, Step)]
    assert repeated[:3] == ["zero", "axes-check", "sync-check"]
    assert not {n for n in finished if "uT" in n} & set(repeated)
    asked = {i.key for i in after if isinstance(i, Prompt)}  # mounted anew where nothing said how it stood
    assert asked & {"mounting-stands", "mount-z"} == {"mounting-stands" if "axes-check" in finished else "mount-z"}
    assert min(steps_at(after)) > max(steps_at(before), default=0.0)


@pytest.mark.parametrize("kills", [2, pytest.param(100, marks=pytest.mark.slow)])
def test_no_committed_row_is_lost_and_resuming_completes(
    bench_file: BenchFile, kills: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    moments, ended = random.Random(20261121), list[str]()
    for kill in range(kills):
        monkeypatch.setenv("LABCAL_HOME", str(tmp_path / str(kill)))
        ended.append(survive(bench_file(), moments.uniform(0.0, 0.6)))
    assert ended.count("interrupted") >= kills / 2
