"""A guardian that hangs, or was stopped, and whoever stands by it too: `labcal bench off` brings the coils to zero."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from served_lab import EXAMPLE, LABCAL, LONG_S, Served, Sessions, at_zero, children_of, example, guardians, log, until

import labcal.session
from labcal.bench.guardian import hung
from labcal.bench.guardian.standbys import HOW_MANY
from labcal.bench.shutdown import coils_off
from labcal.record.stream import Event, Item
from labcal.runner.prompts import first_choice

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="needs SIGSTOP, Unix sockets and who is at their end")
HANGS = """
import os, sys, time
from labcal.bench.guardian import wire
from labcal.bench.links import ports
assert ports.hold([sys.argv[2]])
listener, card = wire.listen()
ports.announce(card | {"bench": sys.argv[1]})
print("ready", flush=True)
time.sleep(600)
"""

TWO = """
import sys, time
from pathlib import Path
sys.path.insert(0, sys.argv[3])
from test_guardian_ear import Ear
from labcal.bench.coils.at_zero import AtZero
from labcal.bench.links import ports
folder, name = Path(sys.argv[1]).parent, sys.argv[2]
assert ports.hold([f"tcp://{folder.name}-{name}:1"])
ear = Ear()
ear.coils.order_zero = lambda *_, **__: (folder / f"{name}.heard").touch()
def zero(why, **_):
    deadline = time.monotonic() + 15
    while len(list(folder.glob("*.heard"))) < 2 and time.monotonic() < deadline:
        time.sleep(0.01)
    return [AtZero(name, 0.0, len(list(folder.glob("*.heard"))) == 2, read_s=time.monotonic())]
ear.coils.zero = zero
ports.announce(ear.card | {"bench": sys.argv[1], "supplies": {name: f"supply {name}"}})
print("ready", flush=True)
time.sleep(600)
"""


def stopped_of(guardian: int) -> list[int]:
    """Stops a guardian and all that stand by it; returns those."""
    until(lambda: len(children_of(guardian)) == HOW_MANY)
    standing_by = children_of(guardian)
    for pid in (*standing_by, guardian):
        os.kill(pid, signal.SIGSTOP)
    return standing_by


@pytest.mark.parametrize("bench_text", [example()], ids=["tti"])
def test_off_takes_the_place_of_a_guardian_that_was_stopped(lab: Served, session: Sessions) -> None:
    session("idle")
    (first,) = guardians()
    standing_by = stopped_of(first)
    said = subprocess.run([*LABCAL, "bench", "off", str(lab.file)], capture_output=True, text=True, timeout=LONG_S)
    assert at_zero(lab), said
    assert (said.returncode, said.stdout.count("zero, open")) == (0, 3), said
    assert f"guardian {first} was ordered zero and hangs, or was stopped: it was killed" in log()
    for pid in standing_by:
        os.kill(pid, signal.SIGCONT)
    until(lambda: not guardians())
    assert at_zero(lab)


@pytest.mark.parametrize("bench_text", [example()], ids=["tti"])
def test_a_session_that_ends_takes_the_place_of_a_guardian_that_was_stopped(lab: Served, session: Sessions) -> None:
    # whoever started the tests may have SIGINT ignored, and children inherit that
    child = session("idle", popen=lambda: {"preexec_fn": lambda: signal.signal(signal.SIGINT, signal.SIG_DFL)})
    (first,) = guardians()
    standing_by = stopped_of(first)
    os.kill(child.pid, signal.SIGINT)
    said = f"guardian {first} was ordered zero and hangs, or was stopped: it was killed by process {child.pid}"
    until(lambda: said in log())
    until(lambda: at_zero(lab))
    child.communicate(timeout=LONG_S)
    for pid in standing_by:
        os.kill(pid, signal.SIGCONT)


@pytest.mark.parametrize("bench_text", [example()], ids=["tti"])
def test_a_session_that_holds_a_field_takes_its_place_too_and_nobody_need_stop_it(lab: Served) -> None:
    stopped, first = list[int](), list[int]()

    def stop(item: Item) -> None:
        if isinstance(item, Event) and item.kind == "set-point" and not stopped:
            first.extend(guardians())
            stopped.extend(stopped_of(*first))

    outcome = labcal.session.run("field-hold", lab.file, {"duration_s": "60"}, answer=first_choice, on_item=stop)
    assert at_zero(lab), f"{outcome}\n{log()}"
    assert "the connection to the guardian was lost" in outcome.ending
    assert f"guardian {first[0]} answers nothing and hangs, or was stopped: it was killed" in log()
    for pid in stopped:
        os.kill(pid, signal.SIGCONT)


@pytest.fixture
def hangs(tmp_path: Path) -> Iterator[Callable[[], subprocess.Popen[str]]]:
    """Begins a guardian that listens and never answers."""
    begun = list[subprocess.Popen[str]]()

    def begin() -> subprocess.Popen[str]:
        words = [sys.executable, "-c", HANGS, str(bench_of(tmp_path)), f"tcp://{tmp_path.name}:1"]
        begun.append(subprocess.Popen(words, stdout=subprocess.PIPE, text=True))
        out = begun[-1].stdout
        assert out is not None
        assert out.readline() == "ready\n"
        return begun[-1]

    yield begin
    for process in begun:
        process.kill()
        process.communicate()


def test_two_guardians_of_one_name_are_both_ordered_before_either_is_waited_for(tmp_path: Path) -> None:
    file = tmp_path.resolve() / "gone.toml"
    words = [sys.executable, "-c", TWO, str(file)]
    both = [subprocess.Popen([*words, name, str(Path(__file__).parent)], stdout=subprocess.PIPE) for name in "xy"]
    try:
        for one in both:
            assert one.stdout is not None
            assert one.stdout.readline() == b"ready\n"
        assert [(end.axis, end.opened) for end in coils_off(file)] == [("x", True), ("y", True)]
    finally:
        for one in both:
            one.kill()
            one.communicate()


def bench_of(folder: Path) -> Path:
    file = folder / "bench.toml"
    file.write_text(EXAMPLE.read_text())
    return file.resolve()


def test_one_that_never_answers_is_ended_and_the_coils_are_reached_from_here(
    hangs: Callable[[], subprocess.Popen[str]], tmp_path: Path
) -> None:
    guardian = hangs()
    assert [end.words for end in coils_off(tmp_path / "bench.toml")] == ["zero, open"] * 3
    assert guardian.wait(LONG_S) == -signal.SIGKILL


def test_one_that_was_stopped_after_it_had_heard_is_ended(tmp_path: Path) -> None:
    file = tmp_path.resolve() / "gone.toml"
    words = [sys.executable, "-c", TWO, str(file), "x", str(Path(__file__).parent)]
    with subprocess.Popen(words, stdout=subprocess.PIPE) as guardian:
        assert guardian.stdout is not None
        assert guardian.stdout.readline() == b"ready\n"
        off = subprocess.Popen([*LABCAL, "bench", "off", str(file)], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        until(lambda: (tmp_path / "x.heard").exists())
        os.kill(guardian.pid, signal.SIGSTOP)
        assert guardian.wait(10.0) == -signal.SIGKILL  # an order that was heard is waited for twice as long
        off.communicate(timeout=LONG_S)


def test_one_that_may_not_be_ended_is_named_and_nothing_is_claimed(
    hangs: Callable[[], subprocess.Popen[str]], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def not_permitted(pid: int, number: int) -> None:
        raise PermissionError(1, "Operation not permitted")

    guardian = hangs()
    with monkeypatch.context() as patch:
        patch.setattr(os, "kill", not_permitted)
        ended = coils_off(tmp_path / "bench.toml")
    left = [end for end in ended if end.fault is not None]
    assert [(end.axis[0], end.current_A, end.opened) for end in left] == [(axis, None, False) for axis in "xyz"]
    for end in left:
        assert end.words.startswith(f"guardian {guardian.pid} of user ")
        assert "How the coils are is not known" in end.words
        assert f"kill -9 {guardian.pid}" in end.words


def test_who_is_traced_for_a_moment_does_not_stand_still() -> None:
    assert not hung.stands_still(os.getpid())
    assert not hung.stands_still(None)
