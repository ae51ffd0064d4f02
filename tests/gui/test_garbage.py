"""What Qt made ends in the thread that it lives in: no other thread of the window's process collects garbage."""

from __future__ import annotations

import gc
import os
import subprocess
import sys
import threading
from collections.abc import Callable
from pathlib import Path

from labcal.system.garbage import collect_if_due


class Knot:
    """Part of a cycle, which nothing but the collector ends."""

    def __init__(self, ended: Callable[[], object]) -> None:
        self.itself, self._ended = self, ended

    def __del__(self) -> None:
        self._ended()


def _make_many(kept: list[list[object]]) -> None:
    for _ in range(200_000):
        kept.append([])


def test_another_thread_makes_objects_and_collects_nothing_and_the_one_that_asks_does() -> None:
    ended_in = list[threading.Thread]()
    Knot(lambda: ended_in.append(threading.current_thread()))
    kept = list[list[object]]()
    other = threading.Thread(target=_make_many, args=(kept,))
    other.start()
    other.join()
    assert ended_in == []
    collect_if_due()
    assert ended_in == [threading.main_thread()]


def test_below_the_thresholds_nothing_is_gone_through() -> None:
    gc.collect()
    phases = list[str]()
    gc.callbacks.append(lambda phase, _: phases.append(phase))
    try:
        collect_if_due()
    finally:
        gc.callbacks.pop()
    assert phases == []


WINDOW = """
import gc, sys, threading
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

collected_by = set()

def make_many(keep=[]):
    for _ in range(400_000):
        keep.append([])

def look():
    gc.callbacks.append(lambda phase, _: collected_by.add(threading.current_thread() is threading.main_thread()))
    other = threading.Thread(target=make_many)
    other.start()
    other.join()
    QTimer.singleShot(1500, QApplication.quit)

execute = QApplication.exec
QApplication.exec = staticmethod(lambda: (QTimer.singleShot(0, look), execute())[1])
from labcal.gui.__main__ import main
sys.argv = ["labcal gui"]
main()
print(sorted(collected_by))
"""


def test_the_window_s_own_thread_collects_and_no_other(tmp_path: Path) -> None:
    at_home = os.environ | {"LABCAL_HOME": str(tmp_path), "QT_QPA_PLATFORM": "offscreen"}
    said = subprocess.run(
        [sys.executable, "-c", WINDOW], env=at_home, capture_output=True, text=True, timeout=120, check=True
    )
    assert said.stdout.splitlines()[-1] == "[True]", said.stderr
