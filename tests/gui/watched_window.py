"""The window as `labcal gui` starts it, without a screen; its first start begins a run, each start does one deed.

`watched_window.py BENCH FOLDER PROCEDURE KEY=VALUE;… DEED… -- WHAT-WATCH-GIVES`, with a deed of crash, off, cannot
(open), late, never or nothing.
"""

from __future__ import annotations

import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

from PySide6.QtCore import QTimer

from labcal.gui import __main__ as gui
from labcal.gui import window as window_module

bench, place, procedure, settings, *deeds = sys.argv[1 : sys.argv.index("--")]
given = sys.argv[sys.argv.index("--") + 1 :]
starts = Path(place) / "starts"
number = len(starts.read_text().splitlines()) if starts.exists() else 0
with starts.open("a") as file:
    file.write("start\n")
deed = deeds[number] if number < len(deeds) else "stay"
begun: set[str] = set()


def say(*words: object) -> None:
    print(*words, flush=True)


def first(what: str) -> bool:
    """Whether this has not been done yet."""
    new = what not in begun
    begun.add(what)
    return new


def act(window: window_module.Window) -> None:
    state, run = window.app_state, window.app_state.run
    built = all(page.ready for page in window.lazy_pages.values())  # else on a busy computer it stands still meanwhile
    if number == 0 and state.facts and built and first("start"):
        state.set_identity(operator="J. Doe", dut="EM-07")
        window.open_page("History")
        state.start(procedure, dict(one.split("=") for one in settings.split(";")))
    if number == 0 and run.state == "asking":
        run.answer(run.prompt.choices[0])
    if run.segment is not None and first("there"):
        steps, order = [name for name, _ in run.steps()], run.order
        say("there", number, window.page_shown(), state.bench_worker.pid, order.procedure, order.dut, *steps)
        do(window)
    if run.state == "ended" and first("end"):
        say("ended", run.status, run.message)
        window.leave()


def do(window: window_module.Window) -> None:
    if deed == "crash":
        QTimer.singleShot(1500, lambda: os.kill(os.getpid(), signal.SIGKILL))
    elif deed == "off":
        window.top.off.click()


if deed == "cannot":  # open a second time
    sys.exit(2)
if deed == "never":
    time.sleep(60)
    sys.exit(2)
if deed == "late":
    say("late")
    time.sleep(10)
opened = window_module.open_window


def open_and_act(*args: Any, **more: Any) -> window_module.Window:
    window = opened(*args, **more)
    timer = QTimer(window, interval=20)
    timer.timeout.connect(lambda: act(window))
    timer.start()
    return window


window_module.open_window = open_and_act
sys.argv = ["labcal gui", "--bench", bench, *given]
sys.exit(gui.main())
