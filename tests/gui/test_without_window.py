"""A window that somebody watches breaks off in a run: the run goes on without it, and the next window comes back."""

import io
import os
import threading
import time
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.coils.state import CoilReading, LabState
from labcal.errors import Stopped
from labcal.gui.ipc import channel as channel_module
from labcal.gui.ipc.backlog import PastMessages
from labcal.gui.ipc.bench_commands import run
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.lines import read_event, write_line
from labcal.gui.ipc.messages import (
    Answer,
    Done,
    GoesOn,
    HangUp,
    ListRuns,
    Recorded,
    Rejoin,
    Request,
    RunProcedure,
    StateRead,
)
from labcal.gui.ipc.worker import carried_out
from labcal.record.stream import Event, Prompt, Step
from labcal.system import run_door

BENCH = Path(__file__).parents[2] / "examples" / "simulated.toml"
HELD = {"duration_s": "60"}
ORDER = RunProcedure("field-hold", str(BENCH), HELD, "EM-07", "J. Doe", seed=3)
PATIENCE_S = 60.0
QUESTION = Prompt(1.0, "ready", "Hands off?", ("done", "no"), acts=True)


class Window(io.StringIO):
    """Hears the worker, and is killed when the first turn begins; `last_words` come before that."""

    def __init__(self, last_words=b""):
        super().__init__()
        hears, self._mouth = os.pipe()
        self.says, self._last_words, self.dead, self.heard = os.fdopen(hears), last_words, False, []
        self.says_line(Request(1, ListRuns()))

    def says_line(self, message):
        os.write(self._mouth, f"{write_line(message)}\n".encode())

    def write(self, line):
        if self.dead:
            raise BrokenPipeError(32, "Broken pipe")
        self.heard.append(read_event(line))
        if "segment-opened" in line:
            os.write(self._mouth, self._last_words)
            self.die()
        return len(line)

    def die(self):
        self.dead = True
        os.close(self._mouth)


@pytest.fixture
def worker(home_of_its_own):
    """A channel whose window is watched, and the number of the request that is worked on."""
    made, before = [], set(threading.enumerate())

    def begin(window, *, answers=True):
        channel = Channel(window.says, window, watched=True)
        if answers:
            channel.answer = lambda prompt: prompt.choices[0]
        made.append((channel, window))
        requests = channel.requests()
        assert next(requests).number == 1
        return channel, requests

    yield begin
    for channel, window in made:
        if not window.dead:
            window.die()
        channel.close_door()
        for thread in set(threading.enumerate()) - before:
            if thread.name == "window":
                thread.join(PATIENCE_S)
        window.says.close()


@contextmanager
def comes_back():
    """A window's line to the run of this process."""
    with run_door.knock(os.getpid()) as connection, connection.makefile("r", encoding="utf-8") as said:
        connection.settimeout(PATIENCE_S)
        yield connection, said


def ended_status():
    return [one.status for one in session.runs()]


def test_a_run_goes_on_without_its_window_and_the_next_one_hears_all_of_it(worker):
    window = Window()
    channel, _ = worker(window)
    channel.send(carried_out(channel, Request(1, ORDER)))
    assert window.dead
    assert ended_status() == ["finished"]
    with comes_back() as (connection, said):
        connection.sendall(f"{write_line(Request(7, Rejoin()))}\n".encode())
        heard = [read_event(said.readline())]
        while not isinstance(heard[-1], Done):
            heard.append(read_event(said.readline()))
        channel._on_bench = channel._hung_up = True  # else it would end this process when the line is closed
    first, *between, last = heard
    assert (first.order, first.bench.name, last.number) == (ORDER, "simulated cage", 7)
    assert last.answer["status"] == "finished"
    items = [item for event in between if isinstance(event, Recorded) for item in event.items]
    assert [one.name for one in items if isinstance(one, Step)] == ["ambient field", "open loop", "held"]
    assert any(isinstance(event, StateRead) for event in between)


def test_a_window_that_hangs_up_on_purpose_ends_the_run_at_once(worker):
    channel, _ = worker(Window(f"{write_line(HangUp())}\n".encode()))
    assert run(channel, replace(ORDER, pace="20 times")).status == "interrupted"
    assert ended_status() == ["interrupted"]


def test_whoever_watched_sends_the_run_to_its_end(worker):
    window = Window()
    channel, _ = worker(window)
    sender = threading.Thread(target=send_when_dead, args=(window,))
    sender.start()
    begun = time.monotonic()
    assert run(channel, replace(ORDER, pace="20 times")).status == "interrupted"
    assert time.monotonic() - begun < channel_module.ALONE_S
    sender.join()


def send_when_dead(window):
    while not window.dead:
        time.sleep(0.01)
    run_door.send_to_its_end(os.getpid())


def test_nobody_comes_back_in_time(worker, monkeypatch):
    monkeypatch.setattr(channel_module, "ALONE_S", 0.5)
    channel, requests = worker(Window())
    assert run(channel, replace(ORDER, pace="20 times")).status == "interrupted"
    assert list(requests) == []
    assert not run_door.goes_on_at(os.getpid())


def test_who_does_not_know_the_token_is_not_let_in(home_of_its_own):
    door = run_door.Door()
    card = home_of_its_own / run_door.FOLDER / f"{os.getpid()}.json"
    assert card.stat().st_mode & 0o077 == 0 or os.name == "nt"
    right = card.read_text()
    card.write_text(right.replace('"token": "', '"token": "0'))
    wrong = run_door.knock(os.getpid())
    card.write_text(right)
    came = run_door.knock(os.getpid())
    came.sendall(b"here\n")
    window = door.wait(PATIENCE_S)
    assert window.says.readline() == "here\n"
    window.close()
    for connection in (wrong, came):
        connection.close()
    door.close()
    with pytest.raises(OSError, match=r"\d+\.json"):
        run_door.knock(os.getpid())


def lab(current_A):
    now = time.monotonic()
    return LabState(tuple(CoilReading(axis, 0.0, current_A, current_A == 0.0, True, now) for axis in "xyz"))


def keeps_telling(channel, current_A, over):
    while not over.wait(0.05):
        channel.send_state(lab(current_A))


@pytest.mark.parametrize(("current_A", "goes_on"), [(0.0, True), (1.0, False)])
def test_a_question_without_a_window_waits_only_with_the_coils_at_zero(worker, current_A, goes_on):
    window, over = Window(), threading.Event()
    channel, _ = worker(window, answers=False)
    channel.run_begins(True, GoesOn(ORDER, "now", session_bench()))
    told = threading.Thread(target=keeps_telling, args=(channel, current_A, over))
    told.start()
    window.die()
    back = threading.Thread(target=answer_later, args=(3 * channel_module.UNANSWERED_S,))
    back.start()
    try:
        if goes_on:
            assert channel.answer(QUESTION) == "done"
        else:
            with pytest.raises(Stopped):
                channel.answer(QUESTION)
    finally:
        over.set()
        told.join()
        back.join()
        run_door.send_to_its_end(os.getpid())  # else it waits for another window until ALONE_S is over


def session_bench():
    from labcal.gui.ipc.bench_commands import read_bench
    from labcal.gui.ipc.messages import ReadBench

    return read_bench(None, ReadBench(str(BENCH)))


def answer_later(seconds):
    time.sleep(seconds)
    with suppress(OSError), comes_back() as (connection, _):  # of a run that has ended nobody answers
        for message in (Request(2, Rejoin()), Answer("ready", "done")):
            connection.sendall(f"{write_line(message)}\n".encode())


def test_who_comes_back_is_not_asked_again_what_was_answered():
    past = PastMessages(GoesOn(ORDER, "now", session_bench()))
    asked_again = replace(QUESTION, t_s=3.0)
    answered = Event(2.0, "answer", "done", {"key": "ready"})
    past.keep(Recorded((Prompt(0.0, "mount-x", "Mount.", ("done",)), QUESTION, answered, asked_again)))
    _, recorded = past.events()
    assert [getattr(one, "key", one) for one in recorded.items] == ["mount-x", answered, "ready"]
