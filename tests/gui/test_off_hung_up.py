"""A worker's line: a window that goes does not break off the way to zero, and each run hears its own answers."""

from __future__ import annotations

import io
import os
import threading
from pathlib import Path

import pytest

from labcal import session
from labcal.bench.coils.at_zero import AtZero
from labcal.gui.ipc import channel as channels
from labcal.gui.ipc.lines import write_line
from labcal.gui.ipc.messages import Abort, Answer, ListRuns, Request, ResumeRun, RunProcedure, Stop, SwitchOff, Word
from labcal.gui.ipc.worker import serve
from labcal.record.stream import Prompt
from labcal.runner.control import Aborted, Stopped

LONG_S = 30.0


def test_a_window_that_hangs_up_does_not_end_its_worker_on_the_way_to_zero(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    ended, at_zero, before = [], [], threading.enumerate()
    reading, writing = (os.fdopen(end, mode) for end, mode in zip(os.pipe(), "rw", strict=True))

    def coming_down(_: Path) -> tuple[list[AtZero], None]:
        [listener] = (thread for thread in threading.enumerate() if thread.name == "window" and thread not in before)
        writing.close()  # now, for it may be gone at once
        listener.join(LONG_S)
        at_zero.append(not ended)
        return [], None

    monkeypatch.setattr(channels.os, "_exit", ended.append)
    monkeypatch.setattr(session, "coils_off_and_stopped", coming_down)
    writing.write(write_line(Request(1, SwitchOff(str(tmp_path / "bench.toml")))) + "\n")
    writing.flush()
    with reading:
        serve(channels.Channel(reading, io.StringIO()))
    assert at_zero == [True]


def test_a_question_that_is_open_when_its_run_ends_takes_no_answer_of_the_next_run(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As where the disk is too slow while a person is asked: the next run had its answers eaten, and waited."""
    reading, writing = (os.fdopen(end, mode) for end, mode in zip(os.pipe(), "rw", strict=True))
    channel, told = channels.Channel(reading, io.StringIO()), {}

    def ask(key: str) -> threading.Thread:
        def wait() -> None:
            try:
                told[key] = channel.answer(Prompt(0.0, key, "?"))
            except Stopped as stopped:
                told[key] = stopped

        asked, check = threading.Event(), channel.control.check
        monkeypatch.setattr(channel.control, "check", lambda: (asked.set(), check()))
        asking = threading.Thread(target=wait, daemon=True)
        asking.start()
        assert asked.wait(LONG_S)  # of this run: on a busy computer the thread may begin after the next one's beginning
        return asking

    channel.run_begins(simulated=True)
    first = ask("failed-turn")
    channel.run_ends()
    channel.run_begins(simulated=True)
    first.join(LONG_S)
    assert isinstance(told.get("failed-turn"), Stopped)
    second = ask("mounting-stands")
    monkeypatch.setattr(channels.os, "_exit", lambda code: None)
    listening = threading.Thread(target=lambda: list(channel.requests()), daemon=True)
    listening.start()
    writing.write(write_line(Answer("mounting-stands", "yes")) + "\n")
    writing.flush()
    second.join(LONG_S)
    assert told["mounting-stands"] == "yes"
    channel.run_ends()
    writing.close()
    listening.join(LONG_S)
    reading.close()


@pytest.mark.parametrize(("word", "ends"), [(Stop(), Stopped), (Abort(), Aborted)], ids=["stop", "coils off"])
@pytest.mark.parametrize("asked", [RunProcedure("preflight", "bench.toml"), ResumeRun("r1", "bench.toml", "EM-07")])
def test_what_is_said_while_a_run_is_being_started_is_said_to_it(
    asked: RunProcedure | ResumeRun, word: Word, ends: type[Stopped], monkeypatch: pytest.MonkeyPatch
) -> None:
    reading, writing = (os.fdopen(end, mode) for end, mode in zip(os.pipe(), "rw", strict=True))
    monkeypatch.setattr(channels.os, "_exit", lambda code: None)
    channel = channels.Channel(reading, io.StringIO())
    requests = channel.requests()
    writing.write("".join(f"{write_line(said)}\n" for said in (Request(1, asked), word, Request(2, ListRuns()))))
    writing.flush()
    assert [next(requests).number for _ in range(2)] == [1, 2]  # and what was said between them was heard
    channel.run_begins(simulated=True)
    with pytest.raises(Stopped) as caught:
        channel.control.check()
    assert caught.type is ends
    channel.run_ends()
    writing.close()
    list(requests)
    reading.close()
