"""One window on one home: the second says so, brings the first to the front, and ends before it talks to anybody."""

import os
import signal
import subprocess
import sys

import pytest

from labcal.gui.one_window import OneWindow, to_front

WINDOW = [sys.executable, "-P", "-m", "labcal.gui"]
SAID = "labcal gui: a window is open already (process {pid} on "


@pytest.fixture
def first():
    one = OneWindow()
    assert one.take() == ""
    yield one
    one.let_go()


def test_the_second_ends_with_a_sentence_and_has_the_first_come_to_the_front(qtbot, first):
    with qtbot.waitSignal(first.knocked, timeout=60_000):
        second = subprocess.run(WINDOW, capture_output=True, text=True, timeout=60, check=False)
    assert second.returncode == 2
    assert second.stderr.startswith(SAID.format(pid=os.getpid()))
    assert second.stderr.rstrip().endswith("comes to the front; this one is not opened.")


def test_so_says_the_command_that_people_type(first):
    said = subprocess.run(
        [sys.executable, "-m", "labcal", "gui"], capture_output=True, text=True, timeout=60, check=False
    )
    assert said.returncode == 2
    assert " ".join(said.stderr.split()).startswith(SAID.format(pid=os.getpid()))
    assert "broke off" not in said.stderr


def test_one_that_was_killed_keeps_nobody_out():
    holds = (
        "from labcal.gui.one_window import OneWindow; one = OneWindow(); print(one.take() == '', flush=True); input()"
    )
    killed = subprocess.Popen([sys.executable, "-c", holds], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert killed.stdout.readline().strip() == "True"
    another = OneWindow()
    assert another.take() != ""
    killed.send_signal(signal.SIGKILL)
    killed.wait()
    killed.stdout.close()
    killed.stdin.close()
    assert another.take() == ""
    another.let_go()


def test_it_comes_to_the_front_from_wherever_it_was(new_window):
    new_window.showMinimized()
    to_front(new_window)
    assert (new_window.isVisible(), new_window.isMinimized()) == (True, False)
