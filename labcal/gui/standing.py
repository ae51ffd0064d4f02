"""Where the window stands, in a file for whoever watches it; and standing there again after it broke off."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from functools import partial
from pathlib import Path

from PySide6.QtCore import QCoreApplication, QObject

from labcal.gui.ipc.answers import RunLine
from labcal.gui.ipc.messages import ListRuns
from labcal.gui.ipc.wire import Fault
from labcal.gui.viewmodels.one_dut import KEPT
from labcal.gui.window import Window


class Standing(QObject):
    """Writes page, bench and run to `file`, if anybody watches it, whenever one changes: nothing that was typed."""

    def __init__(self, window: Window, file: Path | None) -> None:
        super().__init__(window)
        self._window, self._file, self._written = window, file, ""
        if file is None:
            return
        window.stack.currentChanged.connect(self.write)
        window.app_state.run.changed.connect(self.write)
        window.app_state.bench_changed.connect(self.write)
        self.write()

    def write(self) -> None:
        """Write what is new, whole or not at all; a full disk is no fault of the window's."""
        run, app_state = self._window.app_state.run, self._window.app_state
        standing = {
            "page": list(self._window.lazy_pages)[self._window.stack.currentIndex()],
            "bench": app_state.bench,
            "simulated": None if app_state.facts is None else app_state.facts.simulated,
            "run": {
                "id": run.run_id,
                "state": run.state,
                "steps": [[name, str(mark)] for name, mark in run.steps()],
                "worker": app_state.bench_worker.pid if run.alive else 0,
            },
        }
        if self._file is None or (text := json.dumps(standing)) == self._written:
            return
        self._written, part = text, self._file.with_suffix(".part")
        with suppress(OSError):
            part.write_text(text, encoding="utf-8")
            os.replace(part, self._file)


def come_back(window: Window, page: str, report: str, *, ran: bool) -> None:
    """Show the page that was open when the window before this one broke off, and say what happened.

    `ran`: a run went on then.
    """
    if page in window.lazy_pages:
        window.open_page(page)
    if kept := str(window.app_state.settings.value(KEPT, "") or ""):
        window.app_state.set_identity(dut=kept)  # not that of the bench file in its place
    words = QCoreApplication.translate(
        "Standing", "The window broke off, and was started again. What it said last is kept in {0}."
    )
    interrupted = QCoreApplication.translate(
        "Standing", "A run that went on is broken off by its own process: go on with it on Start."
    )
    went_on = QCoreApplication.translate("Standing", "The run went on meanwhile in its own process: here it is.")
    remedy = went_on if window.app_state.run.alive else interrupted if ran else ""
    window.app_state.fault.emit(Fault("crash", words.format(report), remedy))
    if remedy == interrupted:
        window.app_state.request(ListRuns(), partial(_with_its_dut, window))


def _with_its_dut(window: Window, runs: tuple[RunLine, ...]) -> None:
    """At the top the DUT of the run that is to be gone on with, not the one that the bench file names."""
    if runs and runs[0].status == "interrupted":
        window.app_state.set_identity(dut=runs[0].dut_serial)
