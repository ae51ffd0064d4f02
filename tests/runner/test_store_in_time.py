"""The stopwatch on a store that fails, on real lines and an idle machine: at zero two seconds after it is given up."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from pathlib import Path

import pytest
from served_lab import LONG_S, Served, all_gone, at_zero, example, until

from labcal.files.home import home
from labcal.record.stream import Step
from labcal.runner.run import LATE_S
from labcal.store import Store

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(sys.platform == "win32", reason="needs ptys, which Windows lacks"),
]
IN_TIME_S = 2.0
HOLD = """
import sys
from pathlib import Path
from labcal import session
from labcal.runner import yes_to_all
ended = session.run("field-hold", Path(sys.argv[1]), {"duration_s": "60"}, answer=yes_to_all(True), run_id="R")
print(ended.status, ended.at_rest, getattr(ended.fault, "fault", ended.fault), sep="; ")
"""


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Served]:
    served = Served(tmp_path, monkeypatch, example())
    yield served
    all_gone(served.file)
    served.close()


@pytest.fixture
def other() -> Iterator[sqlite3.Connection]:
    """Another program's connection to the store, once there is one."""
    Store.open().close()
    with closing(sqlite3.connect(home() / "store.sqlite", isolation_level=None)) as connection:
        yield connection


def lock(other: sqlite3.Connection) -> Callable[[], object]:
    other.execute("BEGIN IMMEDIATE")
    return lambda: other.execute("ROLLBACK")


def unlink(other: sqlite3.Connection) -> Callable[[], object]:
    (home() / "store.sqlite").unlink()
    return lambda: None


@pytest.mark.parametrize(("deed", "fault"), [(lock, "store locked"), (unlink, "store gone")])
def test_coils_are_at_zero_two_seconds_after_the_store_is_given_up(
    lab: Served, other: sqlite3.Connection, deed: Callable[[sqlite3.Connection], Callable[[], object]], fault: str
) -> None:
    with subprocess.Popen([sys.executable, "-c", HOLD, str(lab.file)], stdout=subprocess.PIPE, text=True) as run:
        until(lambda: held() and not at_zero(lab))
        begun = time.monotonic()
        undo = deed(other)
        until(lambda: at_zero(lab))
        took_s = time.monotonic() - begun
        undo()
        said = run.communicate(timeout=LONG_S)[0]
    print(f"at zero {took_s:.2f} s after: {fault}")
    assert said == f"interrupted; coils at zero; {fault}\n"
    assert took_s < IN_TIME_S + (LATE_S if deed is lock else 0.0)
    if deed is lock:
        with Store.open() as store:
            assert store.status("R") == "interrupted"


def held() -> bool:
    with suppress(Exception), Store.open() as store:
        return any(isinstance(item, Step) and item.name == "held" for item in store.items("R"))
    return False
