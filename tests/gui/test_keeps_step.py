"""A simulated run keeps step with its window: it stands still while that has not taken what was said long ago."""

import io
import os
import threading
import time

import pytest

from labcal.bench.coils.state import LabState
from labcal.gui.ipc.channel import Channel
from labcal.gui.ipc.keeps_step import AHEAD_S
from labcal.gui.ipc.lines import write_line
from labcal.gui.ipc.messages import Abort, LinesTaken
from labcal.record.stream import Event

LONG_S = 5 * AHEAD_S


@pytest.fixture
def run():
    """A run that says ten times a second how the lab is, and each time something else: by what window, and how far."""
    over, before, windows = [], set(threading.enumerate()), []

    def begin(*, simulated=True):
        messages = io.StringIO()
        hears, says = os.pipe()
        ear = os.fdopen(hears)
        channel = Channel(ear, messages)
        windows.append((says, ear, channel))
        channel.run_begins(simulated)
        threading.Thread(target=lambda: list(channel.requests()), daemon=True).start()

        def go():
            while not over:
                channel.send_state(LabState(()))
                channel.send_item(Event(0.0, "note", "a row"))
                time.sleep(0.02)

        threading.Thread(target=go, daemon=True).start()
        return says, lambda: messages.getvalue().count("\n")

    yield begin
    over.append(True)
    mine = set(threading.enumerate()) - before
    for says, _, _ in windows:
        os.close(says)
    join(thread for thread in mine if thread.name == "window")
    for _, ear, channel in windows:
        channel.run_ends()
        ear.close()
    join(mine)  # whoever comes later is not to wait for them


def join(threads):
    for thread in threads:
        thread.join(20.0)
        assert not thread.is_alive(), thread


def hear(says, word):
    os.write(says, f"{write_line(word)}\n".encode())


def stands(lines):
    """How far it has come, once no line has come for long."""
    deadline = time.monotonic() + 20.0
    before, since_s = lines(), time.monotonic()
    while time.monotonic() - since_s < LONG_S:
        assert time.monotonic() < deadline, "it runs on"
        if lines() != before:
            before, since_s = lines(), time.monotonic()
        time.sleep(0.01)
    return before


def goes_on(lines, after):
    deadline = time.monotonic() + 20.0
    while lines() <= after + 4:
        assert time.monotonic() < deadline, "it stands still"
        time.sleep(0.01)


def test_it_waits_for_a_window_that_is_behind_and_goes_on_with_it(run):
    says, lines = run()
    hear(says, LinesTaken(1))
    said = stands(lines)
    hear(says, LinesTaken(said))
    goes_on(lines, said)


def test_its_way_out_waits_for_nobody(run):
    says, lines = run()
    hear(says, LinesTaken(1))
    said = stands(lines)
    hear(says, Abort())
    goes_on(lines, said)


def test_one_of_real_instruments_waits_for_no_window(run):
    says, lines = run(simulated=False)
    hear(says, LinesTaken(1))
    began = time.monotonic()
    while time.monotonic() - began < LONG_S:
        said = lines()
        goes_on(lines, said)


def test_a_window_that_never_says_what_it_takes_is_not_waited_for(run):
    _, lines = run()
    began = time.monotonic()
    while time.monotonic() - began < LONG_S:
        said = lines()
        goes_on(lines, said)
